// Motion asynchronous to the path of a program: positioning axes with their own feed, waiting for
// them and for positioned spindles, torque limits of drives, reference points that a program finds.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "channels/state/core.hpp"

namespace polyturn::channels {

bool Core::beside(unsigned place, const AxisValues& target, double feed, bool per_turn,
                  std::uint16_t spindle) {
    const ChannelAxis& axis = view_->axes[place];
    const auto refuse = [&](std::string_view why) {
        return fail(Alarm::PositioningRefused, axis.name[0], axis.name + ": " + std::string(why));
    };
    int p = -1, q = -1;
    const AxisSet plane = plane_axes(p, q);
    if (transformed() && path.transformation.uses(place))
        return refuse("the transformation moves it");
    if (compensating_ && (plane >> place & 1u)) return refuse("nose-radius compensation moves it");
    if (!begin_move(target, feed > 0 ? MoveKind::Linear : MoveKind::Rapid)) return false;
    if (move_.moved & ~(AxisSet{1} << place))
        return refuse("the frame turns it: other axes would have to move too");
    if (!move_.moved) {
        ++ways_;
        return true;
    }
    move_.feed_mode = feed <= 0  ? FeedMode::Rapid
                      : per_turn ? FeedMode::PerRevolution
                                 : FeedMode::PerMinute;
    move_.feed = feed;
    move_.feed_scale = 1.0;
    move_.speed_limit = 0.0;
    move_.spindle = spindle;
    move_.beside = true;
    deliver();
    move_.beside = false;
    accept(target);
    return true;
}

void Core::arrive(AxisSet axes, std::uint32_t spindles) {
    Wait told;
    told.act = Wait::Act::Arrive;
    told.axes = axes;
    told.spindles = spindles;
    emitted_ = true;
    sink_->wait(told, at);
}

void Core::limit_torque(unsigned place, double thousandths, double window_mm) {
    signal(fmt::format("WINDOW{}", place), window_mm);
    signal(fmt::format("TORQUE{}", place), thousandths);
    if (thousandths == 0) {
        resync_ |= 1u << place;
        stops_met_ &= ~(1u << place);
    }
}

void Core::find_reference(AxisSet which, const AxisValues& then) {
    signal("HOME", static_cast<double>(which));
    home_due_ |= which;
    for (unsigned i = 0; i < view_->axis_count; ++i)
        if (which >> i & 1u) home_then_[i] = then[i];
}

// Behind a barrier: axes are where a stop, a release or their reference point has left them.
void Core::take_due() {
    if (std::exchange(measure_due_, false)) measured_ = take_skip();
    if (std::exchange(skip_due_, false)) stops_met_ |= take_skip();
    for (AxisSet left = resync_ | home_due_; left; left &= left - 1) {
        const auto i = static_cast<unsigned>(__builtin_ctz(left));
        if (const auto there = port_->axis_command(view_->axes[i].machine_axis))
            take_machine(i, *there);
    }
    resync_ = 0;
    if (const AxisSet homed = std::exchange(home_due_, 0)) {
        AxisValues machine = path.machine;
        for (unsigned i = 0; i < view_->axis_count; ++i)
            if (homed >> i & 1u) machine[i] = home_then_[i];
        (void)reference(machine, homed, MoveKind::Reference);
    }
}

}  // namespace polyturn::channels
