#include "channels/fagor/motion/lines.hpp"

#include "channels/fagor/execution.hpp"
#include "channels/fagor/frames/inclined.hpp"
#include "channels/fagor/frames/zeros.hpp"
#include "channels/fagor/motion/corners.hpp"
#include "channels/fagor/motion/feed.hpp"
#include "channels/fagor/motion/loop_scan.hpp"
#include "channels/fagor/motion/points.hpp"
#include "channels/fagor/tools/spindle.hpp"

namespace polyturn::channels::fagor {

bool g_linear(Execution& x, const GCode& row) {
    AxisValues target;
    AxisSet named = 0;
    follow_spindle(x, false);
    if (!read_point(x, target, &named)) return false;
    if (x.words.in_machine) x.core.suspend_for(named);
    slide_along_inclined(x, target, named);
    return drive_line(x, target, row.number == 0);
}

bool drive_line(Execution& x, const AxisValues& programmed, bool rapid) {
    const AxisValues from = x.core.path.programmed;
    AxisValues target = programmed;
    if (!x.loops.plans.empty() && leave_out(x, target)) {
        if (!drive_left_out(x, target, rapid)) return false;
    } else {
        if ((!ends_sharp(x) && !element_at_end(x, true)) || !drive_straight(x, target, rapid))
            return false;
        // the way may have ended elsewhere
        if (!x.loops.plans.empty()) x.core.path.programmed = programmed;
    }
    int p = -1, q = -1;
    x.core.plane_axes(p, q);
    if (p >= 0 && q >= 0)
        note_direction(x,
                       programmed[static_cast<std::size_t>(p)] - from[static_cast<std::size_t>(p)],
                       programmed[static_cast<std::size_t>(q)] - from[static_cast<std::size_t>(q)]);
    return true;
}

bool drive_straight(Execution& x, const AxisValues& target, bool rapid) {
    if (rapid || only_positions(x, target)) return x.core.rapid(target);
    return set_feed(x, target) && x.core.linear(target);
}

// G53: the block's coordinates are the machine's; compensation and the tool's lengths rest for it.
bool begin_machine_block(Execution& x) {
    if (!x.words.has_axes()) {
        if (x.words.letters & ~letter_set("FSTDM")) return true;
        x.core.clear_preset();
        for (unsigned i = 0; i < x.core.view().axis_count; ++i) x.core.local_zero(i, 0.0);
        x.core.select_zero(kZeroNone);
        x.modal.zero = x.modal.zero_added = 0;
        refresh_zero(x);
        return true;
    }
    if (x.modal.motion > 3) return x.fail(Alarm::FagorIncompatible, 'G', "G53 and a thread");
    x.words.in_machine = true;
    return true;
}

}  // namespace polyturn::channels::fagor
