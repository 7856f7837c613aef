#include "channels/fagor/motion/probe.hpp"

#include <cmath>
#include <string_view>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/flow/fault.hpp"
#include "channels/fagor/motion/feed.hpp"
#include "channels/fagor/motion/points.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::fagor {
namespace {

bool start_probe(Execution& x, const AxisValues& target, std::string_view input,
                 std::uint16_t code) {
    const std::uint64_t before = x.core.moves();
    const bool locked = x.core.path.override_locked;
    if (code != 52 && !x.settings.probe_override) {  // no override at all, the program's neither
        x.core.path.override_locked = true;
        x.core.path.feed_path.scale = 1.0;
    }
    const bool good = code == 52
                          ? x.core.fixed_stop(target, 0.0, x.core.path.feed_mode, false, input)
                          : x.core.skip(target, 0.0, x.core.path.feed_mode, input, code == 76);
    x.core.path.override_locked = locked;
    if (!good) return false;
    if (x.core.moves() != before) x.probe.under_way = x.run.wants_barrier = true;
    x.probe.code = code;
    return true;
}

// Where the signal came counts as the position, though braking has carried the axes on: the
// coordinates say so until something moves, and the next move begins its increments there (10.1).
void take_touched_point(Execution& x) {
    const AxisValues rests = x.core.framed(x.core.path.programmed);
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (x.core.skip_moved() >> i & 1u) x.core.path.programmed[i] = x.core.skip_point(i);
    const AxisValues met = x.core.framed(x.core.path.programmed);
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        x.probe.braked_mm[i] = rests[i] - met[i];
    x.probe.moves_at_touch = x.core.moves();
}

}  // namespace

bool g_probe(Execution& x, const GCode& row) {
    if (!x.words.has_axes())
        return x.fail(Alarm::CoordinateAxisNone, 'G', row.number == 75 ? "G75" : "G76");
    if (x.modal.comp != 40)
        return x.fail(Alarm::FagorIncompatible, 'G', row.number == 75 ? "G75 G41" : "G76 G41");
    AxisValues target;
    if (!read_point(x, target, nullptr) || !set_feed(x, target)) return false;
    x.modal.motion = 1;
    return start_probe(x, target, x.modal.probe_input == 2 ? "2" : "1", row.number);
}

// G52: towards the target until the axis meets something; G01 and G40 hold behind it.
bool g_hard_stop(Execution& x, const GCode&) {
    if (!x.words.has_axes()) return x.fail(Alarm::CoordinateAxisNone, 'G', "G52");
    if (x.modal.comp != 40) return x.fail(Alarm::FagorIncompatible, 'G', "G52 G41");
    if (x.modal.inclined) return x.fail(Alarm::FagorInclined, 'G', "G52");
    AxisValues target;
    if (!read_point(x, target, nullptr) || !set_feed(x, target)) return false;
    x.modal.motion = 1;
    // Its drives get only the torque of PT_STOP_TORQUE on the way; what is pressed is let go behind
    // it.
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (std::fabs(target[i] - x.core.path.programmed[i]) > 1e-9)
            x.core.limit_torque(
                i,
                static_cast<double>(params::get(x.core.view().table(), params::pt_stop_torque,
                                                x.core.view().axes[i].machine_axis + 1u)),
                0.0);
    return start_probe(x, target, "HARDSTOP", 52);
}

// Behind the barrier: the axes stand where the signal stopped them, and are programmed to be there.
Step finish_probe(Execution& x) {
    x.probe.under_way = false;
    x.core.begin_block();
    const AxisValues wished = x.core.path.machine;
    const AxisSet early = x.core.take_skip();
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (early >> i & 1u) x.out.ways.take_back(i, wished[i] - x.core.path.machine[i]);
    x.run.state_changed = true;
    if (x.probe.code != 52) take_touched_point(x);
    if (x.probe.code == 52) {
        for (unsigned i = 0; i < x.core.view().axis_count; ++i)
            if (x.core.skip_moved() >> i & 1u) x.core.limit_torque(i, 0.0, 0.0);
        return Step::AtBarrier;  // the command comes back to where the slides stand
    }
    if (early) return Step::Continue;
    if (x.settings.probe_error && x.modal.probe_mode == 0)
        return fault(x, {Alarm::FagorProbe, 'G', static_cast<double>(x.probe.code), 0.0, {}, {}});
    return Step::Continue;
}

}  // namespace polyturn::channels::fagor
