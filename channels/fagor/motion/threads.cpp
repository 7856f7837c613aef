#include "channels/fagor/motion/threads.hpp"

#include <cmath>
#include <utility>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/motion/lengths.hpp"
#include "channels/fagor/motion/points.hpp"
#include "channels/fagor/tools/spindle.hpp"

namespace polyturn::channels::fagor {
namespace {

// Length of the way, and its part along the axis that travels most.
void thread_travel(const Execution& x, const AxisValues& target, double& length, double& along) {
    const AxisValues from = x.core.framed(x.core.path.programmed), to = x.core.framed(target);
    double square = 0.0;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i) {
        const double way = std::fabs(to[i] - from[i]);
        square += way * way;
        along = std::fmax(along, way);
    }
    length = std::sqrt(square);
}

bool read_point_without_polar(Execution& x, AxisValues& target) {
    const Word* q = std::exchange(x.words.by_letter['Q' - 'A'], nullptr);
    const std::uint32_t letters =
        std::exchange(x.words.letters, x.words.letters & ~letter_set("QR"));
    const bool good = read_point(x, target, nullptr);
    x.words.by_letter['Q' - 'A'] = q;
    x.words.letters = letters;
    return good;
}

}  // namespace

bool g_thread(Execution& x, const GCode& row) {
    if (!x.words.has_axes())
        return x.fail(Alarm::CoordinateAxisNone, 'G', row.number == 33 ? "G33" : "G34");
    if (x.words.has('Q') && !x.settings.thread_angle) return x.fail(Alarm::FagorThreadAngle, 'Q');
    if (std::fabs(x.words.number('Q')) >= 360.0)
        return x.fail(Alarm::FagorValueRange, 'Q', "Q", x.words.number('Q'));
    AxisValues target;
    if (!read_point_without_polar(x, target)) return false;
    double lead = x.words.has('L') ? distance(x, 'L') : x.modal.lead;
    double change = row.number == 34 ? distance(x, 'K') : 0.0;
    if (lead < 0) return x.fail(Alarm::NegativeSign, 'L', "L");
    const bool joined = x.core.path.after_thread && x.modal.corner == 5;
    // only the first one has an angle (6.11)
    if (joined && x.words.has('Q')) return x.fail(Alarm::FagorThreadJoin, 'Q', "Q");
    if (joined && row.number == 33 && x.modal.lead_varies)
        return x.fail(Alarm::FagorThreadJoin, 'G', "G34 G33");
    if (row.number == 34) {
        if (joined && x.modal.lead_varies && change != 0.0)
            return x.fail(Alarm::FagorThreadJoin, 'G', "G34 G34");
        // L0 K0: on with the pitch reached
        if (joined && x.modal.lead_varies && lead == 0.0)
            lead = x.modal.end_lead;
        else if (joined && !x.modal.lead_varies && change != 0.0 &&
                 std::fabs(lead - x.modal.end_lead) > 1e-6)
            return x.fail(Alarm::FagorThreadJoin, 'L', "L");
    }
    double length = 0.0, along = 0.0;
    thread_travel(x, target, length, along);
    if (lead == 0.0) return x.fail(Alarm::LeadMissing, 'L');
    // pitch after the way s: v^2 = L^2 + 2 K s
    const double square = lead * lead + 2 * change * along;
    if (square <= 0) return x.fail(Alarm::FagorCyclePitch, 'K');
    if (!joined) x.core.path.after_thread = false;  // only G05 joins threads
    ThreadCall call;
    call.lead = lead;
    call.lead_change = change;
    call.start_angle = x.words.has('Q') ? x.words.number('Q') : 0.0;
    if (x.modal.withdraws) {  // G233: at most three axes leave the thread
        std::size_t slot = 0;
        for (unsigned i = 0; i < x.core.view().axis_count && slot < call.withdraw.size(); ++i) {
            if (x.modal.withdrawal[i] == 0.0) continue;
            call.withdraw_axis[slot] = static_cast<std::int8_t>(i);
            call.withdraw[slot++] = x.modal.withdrawal[i];
        }
    }
    follow_spindle(x, true);
    if (!x.core.thread(target, call)) return false;
    x.modal.lead = lead;
    x.modal.end_lead = std::sqrt(square);
    x.modal.lead_varies = change != 0.0;
    return true;
}

// G233: how far the axes leave a thread that is stopped.
bool g_withdrawal(Execution& x, const GCode&) {
    x.modal.withdrawal = {};
    x.modal.withdraws = false;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i) {
        if (!x.words.axis[i]) continue;
        x.modal.withdrawal[i] = x.words.axis[i]->value * x.modal.unit();  // a true distance
        x.modal.withdraws = x.modal.withdraws || x.words.axis[i]->value != 0.0;
    }
    return true;
}

}  // namespace polyturn::channels::fagor
