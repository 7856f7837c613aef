// Threads: a move whose feed is the spindle's turn; the retract from it in a hold, and the groove
// of a part that is clamped again.
#include <algorithm>
#include <cmath>

#include "channels/state/core.hpp"

namespace polyturn::channels {
namespace {
constexpr double kNoThreadWay = 1e-9;  // mm: no movement
}  // namespace

// Retract from a held thread: as the program says, or PT_THREAD_RETRACT across it, against the last
// movement of that axis, which was the infeed. An axis that has not moved yet gives no direction:
// then a hold acts behind the thread.
void Core::choose_withdrawal(const ThreadCall& call, unsigned along) {
    move_.withdraw_axis = call.withdraw_axis;
    move_.withdraw = call.withdraw;
    if (call.withdraw_axis[0] >= 0 || call.own_withdrawal) return;
    const double distance = params::get(view_->table(), params::pt_thread_retract, view_->channel);
    if (distance <= 0.0) return;
    int p = -1, q = -1;
    plane_axes(p, q);
    const int across = static_cast<int>(along) == p ? q : p;
    if (across < 0 || path.last_travel[static_cast<std::size_t>(across)] == 0) return;
    move_.withdraw_axis = {static_cast<std::int8_t>(across), -1, -1};
    move_.withdraw[0] = -distance * path.last_travel[static_cast<std::size_t>(across)];
}

// A part that was clamped again: the tool's position in its groove, and the spindle's angle there,
// give the angle at which the record begins on that groove. Turns between: s = u (lead + change u /
// 2).
double Core::picked_up(const ThreadCall& call, unsigned along) const {
    const params::Table& t = view_->table();
    const unsigned l = view_->channel;
    if (params::get(t, params::pt_thread_pickup, l) == 0 || move_.thread_chained)
        return call.start_angle;
    const double unit = params::bit(t, params::n0104_unit_of_measure, l, 0) ? 25.4 : 1.0;
    const double from = move_.machine_start[along];
    const double way =
        (view_->axes[along].from_drive(params::get(t, params::pt_thread_at, l) * unit) - from) *
        (move_.machine[along] < from ? -1.0 : 1.0);
    double turns = way / call.lead;
    if (call.lead_change != 0) {
        const double square = call.lead * call.lead + 2 * call.lead_change * way;
        if (square <= 0) return call.start_angle;  // this thread never comes there
        turns = (std::sqrt(square) - call.lead) / call.lead_change;
    }
    const double sense = path.spindle.turn == SpindleTurn::Ccw ? -1.0 : 1.0;
    const double angle =
        params::get(t, params::pt_thread_angle, l) - sense * 360.0 * turns + call.start_angle;
    return angle - std::floor(angle / 360.0) * 360.0;
}

bool Core::thread(const AxisValues& target, const ThreadCall& call) {
    if (call.lead <= 0.0) return fail(Alarm::LeadMissing, 'F');
    if (!begin_move(target, MoveKind::Thread)) return false;
    take_factors_off();
    move_.sweep = 0.0;
    if (call.arc) {
        int pi = -1, qi = -1;
        plane_axes(pi, qi);
        if (pi < 0 || qi < 0) return fail(Alarm::PlaneAxisMissing);
        auto p = static_cast<unsigned>(pi), q = static_cast<unsigned>(qi);
        ArcCall arc = *call.arc;
        bool moves = false;
        if (path.framed && !frame_arc(arc, target, p, q)) return false;
        if (!shape_arc(arc, p, q, moves)) return false;
    }
    if (!move_.moved) {
        accept(target);
        return true;
    }
    if (!spindle_ready(Alarm::ThreadSpindleStopped)) return false;
    // The lead counts along the linear axis that travels most, Z where two are equal.
    double length2 = 0.0, longest = 0.0;
    unsigned along = 0;
    bool any = false;
    double nearest_x = 0.0;
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        const ChannelAxis& axis = view_->axes[i];
        if (axis.rotary) continue;
        const double distance = std::fabs(move_.machine[i] - move_.machine_start[i]);
        length2 += distance * distance;
        const bool better = distance > longest + kNoThreadWay ||
                            (distance > longest - kNoThreadWay && axis.role == PlaneRole::BasicZ);
        if (distance > kNoThreadWay && (!any || better)) {
            along = i;
            longest = distance;
            any = true;
        }
        if (axis.role == PlaneRole::BasicX)
            nearest_x = std::fmin(std::fabs(framed_now()[i]), std::fabs(move_.pos[i]));
    }
    if (!any) return fail(Alarm::LeadIllegal, 'F', {}, call.lead);
    if (call.by_axis) {
        along = call.axis;
        longest = std::fabs(move_.machine[along] - move_.machine_start[along]);
    }
    if (longest <= kNoThreadWay) return fail(Alarm::LeadIllegal, 'F', {}, call.lead);
    const double length = call.arc ? std::fabs(move_.sweep) * move_.radius : std::sqrt(length2),
                 lead_path = call.lead * length / longest;
    // Where the lead changes from turn to turn it is sqrt(lead^2 + 2 change s) behind the distance
    // s.
    const double end_square = call.lead * call.lead + 2.0 * call.lead_change * longest;
    if (call.lead_change != 0 && end_square <= 0) return fail(Alarm::LeadRunsOut, 'K');
    const double steepest = call.lead_change > 0 ? std::sqrt(end_square) / call.lead : 1.0;
    const double rpm = spindle_rpm_at(nearest_x);
    if (rpm > 0) {
        double most = rpm;
        int slow = -1;
        for (unsigned i = 0; i < view_->axis_count; ++i) {
            const double share = std::fabs(move_.machine[i] - move_.machine_start[i]) / length *
                                 lead_path * steepest;
            const double can = view_->axes[i].max_feed_mm_min;
            if (share > kNoThreadWay && can > 0 && share * most > can * (1 + 1e-9)) {
                most = can / share;
                slow = static_cast<int>(i);
            }
        }
        if (slow >= 0)
            return fail(Alarm::ThreadTooFast, 'F',
                        std::string(view_->axes[static_cast<unsigned>(slow)].name),
                        std::floor(most));
    }
    move_.thread_chained = path.after_thread;
    move_.tap_rpm = rpm;  // corners between joined threads are rounded for this speed
    move_.feed_mode = FeedMode::Thread;
    move_.feed = 0.0;
    move_.spindle = path.spindle.spindle;
    move_.lead = call.lead;
    move_.lead_path = lead_path;
    move_.lead_change = call.lead_change;
    move_.start_angle = picked_up(call, along);
    move_.starts = call.starts;
    choose_withdrawal(call, along);
    deliver();
    path.after_thread = !move_.exact_stop;  // G9, G61: the next one begins anew from rest
    accept(target);
    return true;
}

}  // namespace polyturn::channels
