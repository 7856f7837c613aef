// Jogs, handwheels and reference runs of an inclined slide, whose motion moves the axis at right
// angles too.
#include <algorithm>
#include <cmath>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {

// nullptr as well while either drive is exchanged: the slide then moves under another name, and by
// itself.
const InclinedSlides::Slide* Machine::slide_of(std::uint32_t a) const noexcept {
    const InclinedSlides::Slide* slide = slides_.of(core_, a);
    return slide && !couplings_.route(a) && !couplings_.route(slide->square - 1) ? slide : nullptr;
}

bool Machine::square_rests(const InclinedSlides::Slide& slide) const noexcept {
    const std::uint32_t z = slide.square - 1;
    const AxisUnit& square = core_.axes[z];
    // Wanted to its reference point, but in a later order than the slide: its turn comes when the
    // slide is there.
    const bool waits_its_turn =
        to_reference_[z] &&
        core_.config.axes[z].reference.order > core_.config.axes[slide.angular - 1].reference.order;
    return square.exists() && !square.bound() && !square.detached && !square.beside &&
           !square.moving() && !jogs_[z].active() && !homing_[z].active() &&
           (!to_reference_[z] || waits_its_turn);
}

// May it be taken along now? NOZAGC moves the slide alone.
bool Machine::square_may_come(const InclinedSlides::Slide& slide, std::uint32_t channel) noexcept {
    if (core_.signals.plc(signals::nozagc(channel))) return true;
    if (!may_be_moved(slide.square - 1, Door::Jog)) return false;
    if (square_rests(slide)) return true;
    core_.alarm(Alarm::NotReady, channel, "the axis still moves");
    return false;
}

AxisJog::Limits Machine::limits_by_hand(std::uint32_t a, double speed) const noexcept {
    const AxisConfig& config = core_.config.axes[a];
    AxisJog::Limits most{std::fmin(speed, config.rapid), config.acceleration, config.jerk};
    const InclinedSlides::Slide* slide = slide_of(a);
    // PT_SETUP_FEED holds for each drive, not at right angles
    const bool setup = config.channel && core_.signals.plc(signals::cp_setup(config.channel)) != 0;
    if (slide && setup) most.speed = std::fmin(most.speed, config.setup_feed);
    const double share = slide && slides_.takes(config.channel) ? std::fabs(slide->sine) : 0.0;
    if (share == 0.0) return most;
    const AxisConfig& square = core_.config.axes[slide->square - 1];
    if (setup) most.speed = std::fmin(most.speed, square.setup_feed / share);
    const bool slow = !core_.axes[slide->square - 1].referenced && square.reference.rapid > 0;
    most.speed =
        std::fmin(most.speed,
                  (slow ? std::fmin(square.rapid, square.reference.rapid) : square.rapid) / share);
    most.acceleration = std::fmin(most.acceleration, square.acceleration / share);
    most.jerk = std::fmin(most.jerk, square.jerk / share);
    return most;
}

double Machine::room_by_hand(std::uint32_t a, double sign) const noexcept {
    const InclinedSlides::Slide* slide = slide_of(a);
    return slide && slides_.takes(core_.config.axes[a].channel)
               ? core_.stroke.room(core_, a, sign, slide->square - 1, -slide->sine)
               : core_.stroke.room(core_, a, sign);
}

// An axis that is moved by an inclined slide cannot go on: the inclined slide stops.
void Machine::stop_carrier(std::uint32_t a) noexcept {
    const std::uint32_t l = slides_.carrier(core_, a);
    if (!l) return;
    for (std::uint32_t x = 0; x < core_.config.axis_count; ++x) {
        if (core_.config.axes[x].channel != l || !slides_.of(core_, x)) continue;
        jogs_[x].stop();
        handwheel_left_[x] = 0;
        if (homing_[x].active()) homing_[x].stop();
    }
}

void Machine::run_inclined_slides() noexcept {
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (slides_.of(core_, a))
            slides_.follow(core_, core_.config.axes[a].channel,
                           !jogs_[a].active() && !homing_[a].active());
    if (slides_.take_due()) slides_.configure(core_.table, core_.config);
}

}  // namespace polyturn::kernel
