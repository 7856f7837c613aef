// Axes moved by hand: jog for a time, step a distance, turn a handwheel; in a hold, with a return
// path that is stored.
#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {
namespace {
constexpr double kMmPerInch = 25.4;
// without a pulse for so long: a panel reports some times a second how far a handwheel was turned
constexpr double kWheelStandsS = 0.1;
constexpr std::int64_t kByRegister = 1, kByParameter = 2;  // N0316; 3: the feed of the program

// CP_JOGFD (nct_parameters_part1 5.5): five steps a decade, rounded as the table has them; beyond
// it the rule goes on.
constexpr double kFeedMm[] = {0,  2,  3.2, 5,   7.9, 12.6, 20,  32,
                              50, 79, 126, 200, 320, 500,  790, 1260};
constexpr double kFeedInch[] = {0, 0.08, 0.12, 0.2, 0.3, 0.5, 0.8, 1.2, 2, 3, 5, 8, 12, 20, 30, 50};

double feed_of_register(std::int32_t step, bool inch, bool rotary) {
    if (step <= 0) return 0.0;
    const bool listed = step < 16;
    const double mm_min = listed ? kFeedMm[step] : 2.0 * std::pow(10.0, (step - 1) / 5.0);
    if (rotary) return mm_min / 5.0 / 60.0;
    if (inch) return (listed ? kFeedInch[step] * kMmPerInch : mm_min) / 60.0;
    return mm_min / 60.0;
}
}  // namespace

double Machine::jog_feed(std::uint32_t a) const noexcept {
    const AxisConfig& axis = core_.config.axes[a];
    const ChannelConfig& channel = core_.config.channels[axis.channel - 1];
    // N0319, whatever key is held: a setter bears no rapid
    const bool measures = core_.signals.plc(signals::cp_tmeas(axis.channel)) != 0;
    if ((channels_[axis.channel - 1]->panel().keys & kKeyRapid) && !measures)
        return by_hand(a);  // N0314
    double most = axis.jog_max_feed > 0 ? std::fmin(axis.jog_max_feed, axis.rapid) : axis.rapid;
    if (core_.signals.plc(signals::cp_setup(axis.channel))) most = std::fmin(most, axis.setup_feed);
    if (measures) return std::fmin(channel.measure_feed, most);
    const std::uint32_t s = channel.default_spindle;
    const double rev_s = s ? std::fabs(core_.spindle_rev_s[s - 1]) : 0.0;
    if (channel.jog_feed_source == kByRegister) {
        const double feed = feed_of_register(core_.signals.plc(signals::cp_jogfd(axis.channel)),
                                             channel.inch, axis.rotary);
        return std::fmin(feed, most);  // step 0: no motion, as the table has it
    }
    // By N0317 and N0318, or the feed that holds from power-on; per revolution the spindle must
    // turn.
    const bool own = channel.jog_feed_source == kByParameter;
    const double feed = channel.per_revolution
                            ? (own ? channel.jog_feed_rev : channel.default_feed_rev) * rev_s
                        : own ? channel.jog_feed
                              : channel.default_feed;
    return std::fmin(feed, most);
}

// Steps and handwheel: N0314.
double Machine::by_hand(std::uint32_t a) const noexcept {
    const AxisConfig& config = core_.config.axes[a];
    const double most =
        config.manual_rapid > 0 ? std::fmin(config.manual_rapid, config.rapid) : config.rapid;
    return config.channel && core_.signals.plc(signals::cp_setup(config.channel))
               ? std::fmin(most, config.setup_feed)
               : most;
}

std::uint32_t Machine::behind_address(std::uint32_t a) const noexcept {
    return couplings_.route(a) ? couplings_.route(a) - 1u : a;
}
double Machine::address_sign(std::uint32_t a) const noexcept {
    return couplings_.route(a) && core_.config.axes[a].counts_other_way ? -1.0 : 1.0;
}

// `address`: as the operator names it; its channel asks. The axis is the one whose drive it has.
bool Machine::may_be_moved(std::uint32_t address, Door door) noexcept {
    const std::uint32_t a = behind_address(address), l = core_.config.axes[address].channel;
    const AxisUnit& axis = core_.axes[a];
    const auto refuse = [&](std::string_view why) {
        core_.alarm(Alarm::NotReady, l, why);
        return false;
    };
    const std::uint8_t missing = MotionGate::missing(core_, door, l);
    if (missing & (kMachineOn | kNoStop))
        return refuse("axes are moved by hand only while the machine is on");
    if (l == 0) return refuse("the axis belongs to no channel");
    if (!axis.exists())
        return refuse(
            "there is no drive behind this address: an axis must be exchanged onto it first");
    if (missing & kDoorClosed) return refuse("the door is open: close it, or switch to setup mode");
    if (channels_[l - 1]->program_runs() && !channels_[l - 1]->jogs_in_hold())
        return refuse(
            "axes are moved by hand only while no program of the channel runs, or in a hold "
            "after jog_in_hold");
    if (const std::uint32_t owner = core_.config.axes[a].channel;
        owner != l && axis.owner == owner && channels_[owner - 1]->program_runs())
        return refuse("a program of another channel moves the axis");
    if (axis.beside) return refuse("the axis is moved beside the path");
    if (axis.bound()) {
        core_.alarm(Alarm::SlaveCommanded, l, name_of('A', a).view());
        return false;
    }
    if (axis.detached) {
        core_.alarm(Alarm::AxisDetached, l, name_of('A', a).view());
        return false;
    }
    if (axis.config().on_spindle && !core_.shared_axes[a].has_drive)
        return refuse("the drive is the spindle's at present: stop the spindle");
    if (homing_[a].active() || to_reference_[a]) return refuse("the axis is being referenced");
    if (return_path_[l - 1].going) return refuse("the axes are on their way back");
    if (channels_[l - 1]->jogs_in_hold() && return_path_[l - 1].count == ReturnPath::kMost)
        return refuse("the way back has become too long; press return");
    return true;
}

void Machine::start_jog(Permit, std::uint32_t a, double sign, double speed, double distance,
                        double seconds, bool by_key) noexcept {
    AxisUnit& axis = core_.axes[a];
    const AxisConfig& config = core_.config.axes[a];
    // Before it is referenced, no axis is faster than N0302 (5).
    if (!axis.referenced && config.reference.rapid > 0)
        speed = std::fmin(speed, config.reference.rapid);
    const double from = axis.own();
    jogs_[a].start(from, sign, limits_by_hand(a, speed),
                   std::llround(seconds / core_.config.tick_s), distance, room_by_hand(a, sign),
                   core_.config.tick_s, by_key);
    jog_address_[a] = 0;
    handwheel_turned_[a] = 0;
    if (jogs_[a].active()) axis.owner = 0;
}

// One detent: an increment of the channel (N0105) as often as the PLC's switch says.
double Machine::handwheel_increment(std::uint32_t address) const noexcept {
    const AxisConfig& axis = core_.config.axes[address];
    const ChannelConfig& channel = core_.config.channels[axis.channel - 1];
    const double digits = static_cast<double>(channel.increments) + (axis.inch ? 2.0 : 1.0);
    const double times = std::max(1, core_.signals.plc(signals::cp_hwmul(axis.channel)));
    return times * std::pow(10.0, -digits) * (axis.inch ? kMmPerInch : 1.0);
}

void Machine::jog_command(const Command& c) noexcept {
    if (static_cast<CommandKind>(c.kind) == CommandKind::Handwheel && c.object == 0)
        return turn_program(c.channel, c.value);
    if (core_.config.axes[c.object - 1].channel == 0) {
        if (c.value != 0) core_.alarm(Alarm::NotReady, 0, "the axis belongs to no channel");
        return;
    }
    const std::uint32_t address = c.object - 1, a = behind_address(address);
    AxisUnit& axis = core_.axes[a];
    const AxisConfig& config = core_.config.axes[address];
    const std::uint32_t l = config.channel;
    const auto kind = static_cast<CommandKind>(c.kind);
    double size = std::fabs(c.value), sign = (c.value < 0 ? -1.0 : 1.0) * address_sign(address);
    if (kind == CommandKind::Jog && size == 0.0) return jogs_[a].stop();  // the key is let go
    // In reference mode the jog key of an axis references it (10.4).
    if (kind == CommandKind::Jog && channels_[l - 1]->mode() == ChannelMode::Reference) {
        Command reference = c;
        reference.object = a + 1;
        return reference_command(reference);
    }
    const std::uint32_t wheel = std::clamp<std::uint32_t>(c.flags, 1, 4) - 1;
    const bool by_handwheel = kind == CommandKind::Handwheel;
    const bool stops_with_wheel = by_handwheel && (config.handle >> (4 + wheel) & 1u);
    if (by_handwheel && (config.handle >> wheel & 1u)) sign = -sign;
    if (by_handwheel && channels_[l - 1]->superposes() && channels_[l - 1]->program_runs() &&
        !channels_[l - 1]->jogs_in_hold())
        return superpose(a, sign * size * handwheel_increment(address));
    const Door door = by_handwheel                ? Door::Handwheel
                      : kind == CommandKind::Step ? Door::Step
                                                  : Door::Jog;
    if (!may_be_moved(address, door)) return;
    const auto permit = MotionGate::ask(core_, door, l);
    if (!permit) return;
    if (touches_setter(l, a, sign)) {
        const bool again =
            static_cast<double>(core_.tick - setters_[l - 1].told) * core_.config.tick_s < 1.0;
        setters_[l - 1].told = core_.tick;
        if (!again) core_.alarm(Alarm::NotReady, l, "the tool touches the setter: move it away");
        return;
    }
    const InclinedSlides::Slide* slide = slide_of(a);
    // what the operator asks for is X at right angles
    const double longer = slide ? 1.0 / slide->cosine : 1.0;
    if (axis.moving() || jogs_[a].active() || slides_.carrier(core_, a)) {
        // A panel repeats that its key is held, so that an axis stops when the panel dies.
        const bool held = kind == CommandKind::Jog && jogs_[a].active() && jogs_[a].sign() == sign;
        if (held) jogs_[a].keep(std::llround(size / core_.config.tick_s), sign);
        // Pulses that come while it moves: collected, or with the handwheel's N2400 HnM (part 2,
        // 25) no more than a sign that it is still turned.
        if (stops_with_wheel)
            turn_on(a, sign, size * handwheel_increment(address) * longer);
        else if (by_handwheel)
            handwheel_left_[a] += sign * size * handwheel_increment(address) * longer;
        else if (!held)
            core_.alarm(Alarm::NotReady, l, "the axis still moves");
        return;
    }
    if (slide && !square_may_come(*slide, l)) return;
    if (channels_[l - 1]->jogs_in_hold()) {
        ReturnPath& way = return_path_[l - 1];
        // What comes along goes back with it; if that is switched off meanwhile, it goes by itself.
        if (slide && way.count + 1 < ReturnPath::kMost)
            way.add(slide->square - 1, core_.axes[slide->square - 1].own());
        way.add(a, axis.own(), slide && core_.signals.plc(signals::nozagc(l)));
    }
    if (slide) slides_.begin(core_, a);
    if (kind == CommandKind::Jog) {
        start_jog(*permit, a, sign, jog_feed(address) * longer, 0.0, size, true);
        jog_address_[a] = address + 1;
        if (!jogs_[a].active() && room_by_hand(a, sign) <= 0)
            core_.alarm(Alarm::NotReady, l,
                        "the axis is at the end of its stroke; the other direction is free");
    } else {
        start_jog(*permit, a, sign, by_hand(address) * longer,
                  (kind == CommandKind::Step ? size : size * handwheel_increment(address)) * longer,
                  0.0);
        if (stops_with_wheel) handwheel_turned_[a] = core_.tick + 1;
    }
}

// The handwheel that moves the axis, and with which it stops, has been turned further; turned back,
// it no longer counts as turned in that direction.
void Machine::turn_on(std::uint32_t a, double sign, double way) noexcept {
    if (handwheel_turned_[a] == 0) return;  // something else moves the axis
    if (sign != jogs_[a].sign()) {
        jogs_[a].stop();
        return;
    }
    jogs_[a].keep_distance(way, sign);
    handwheel_turned_[a] = core_.tick + 1;
}

// A key that is a start. What is refused is not stored: nothing moves when the machine is switched
// on again.
void Machine::begin_return(std::uint32_t channel) noexcept {
    if (channel == 0 || channel > kMaxChannels) return;
    ChannelRunner& runner = *channels_[channel - 1];
    const auto refuse = [&](std::string_view why) { core_.alarm(Alarm::NotReady, channel, why); };
    const std::uint8_t missing = MotionGate::missing(core_, Door::Return, channel);
    if (!runner.jogs_in_hold() || !runner.program_runs())
        return refuse("no axes were moved away from a program that is held");
    if (missing & (kMachineOn | kNoStop))
        return refuse("axes go back only while the machine is on");
    if (missing & kDoorClosed) return refuse("the door is open: close it, or switch to setup mode");
    return_path_[channel - 1].going = true;
}

// Moves of the operator in the hold are taken back on the same path, the last move first.
void Machine::go_back() noexcept {
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        ReturnPath& way = return_path_[l];
        if (!channels_[l]->jogs_in_hold()) {
            way.count = 0;
            way.going = false;
            continue;
        }
        if (!way.going || (core_.jogging >> l & 1u)) continue;
        const auto permit = MotionGate::ask(core_, Door::Return, l + 1);
        if (!permit || !channels_[l]->program_runs()) {  // the operator asks again
            way.going = false;
            continue;
        }
        if (way.count == 0) {
            way.going = false;
            channels_[l]->on_path_again();
            continue;
        }
        // A move counts when the axis is there: something may have stopped it on the way (the reset
        // of another channel).
        constexpr double kThere = 1e-6;  // mm, degrees
        const std::uint32_t a = way.axis[way.count - 1];
        const double left = way.from[way.count - 1] - core_.axes[a].own();
        if (std::fabs(left) <= kThere) {
            --way.count;
            continue;
        }
        if (slide_of(a) && !way.alone[way.count - 1]) slides_.begin(core_, a, true);  // as it came
        start_jog(*permit, a, left > 0 ? 1.0 : -1.0, by_hand(a), std::fabs(left), 0.0);
    }
}

void Machine::run_jogs() noexcept {
    look_at_setters();
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        AxisUnit& axis = core_.axes[a];
        if (!axis.exists()) continue;
        if (const double owed = axis.take_return_path(); owed != 0)
            // follow-up (7.4)
            if (const auto permit = MotionGate::ask(core_, Door::FollowUp, 0))
                start_jog(*permit, a, owed > 0 ? 1.0 : -1.0, by_hand(a), std::fabs(owed), 0.0);
        const InclinedSlides::Slide* slide = slide_of(a);
        // Pulses that cannot be driven now are not stored: the axis must not move later, when the
        // handwheel is not turned.
        if (!core_.on() || core_.all_stop || slides_.carrier(core_, a) ||
            (slide && !core_.signals.plc(signals::nozagc(core_.config.axes[a].channel)) &&
             !jogs_[a].active() && !square_rests(*slide)))
            handwheel_left_[a] = 0;
        if (!jogs_[a].active() && handwheel_left_[a] != 0) {
            const double left = std::exchange(handwheel_left_[a], 0.0);
            const auto permit =
                MotionGate::ask(core_, Door::Handwheel, core_.config.axes[a].channel);
            if (!permit) continue;
            if (slide) slides_.begin(core_, a);
            start_jog(*permit, a, left > 0 ? 1.0 : -1.0, by_hand(a), std::fabs(left), 0.0);
        }
        if (!jogs_[a].active()) continue;
        const std::uint32_t address = jog_address_[a];  // a key: the feed as it is now
        if (address) {
            const AxisConfig& own = core_.config.axes[a];
            const double most =
                axis.referenced || own.reference.rapid <= 0 ? own.rapid : own.reference.rapid;
            jogs_[a].limit_speed(
                limits_by_hand(
                    a, std::fmin(jog_feed(address - 1) / (slide ? slide->cosine : 1.0), most))
                    .speed);
        }
        // A positioning axis belongs to its program, not to the operator's hand.
        if (!positioning_axes_[a].asked || positioning_axes_[a].channel == 0)
            core_.jogging |= ChannelSet{1}
                             << (core_.config.axes[address ? address - 1 : a].channel - 1);
        if (core_.state == MachineState::EmergencyStop) {
            if (!axis.brake(core_.config.tick_s)) jogs_[a] = {};
            handwheel_left_[a] = 0;
            continue;
        }
        const bool at_standstill =
            handwheel_turned_[a] != 0 &&
            static_cast<double>(core_.tick + 1 - handwheel_turned_[a]) * core_.config.tick_s >
                kWheelStandsS;
        if (core_.all_stop || at_standstill) jogs_[a].stop();
        axis.move_to(jogs_[a].step(core_.config.tick_s));
        if (address && !jogs_[a].active()) {
            jog_address_[a] = 0;
            if (!jogs_[a].ran())
                core_.alarm(Alarm::JogNoFeed, core_.config.axes[address - 1].channel,
                            name_of('A', address - 1).view());
        }
    }
    go_back();
}

// A handwheel is the time of the programs of a machine group: they go as far as it is turned,
// forwards or back.
void Machine::program_wheel(std::uint32_t channel, bool on) noexcept {
    for (std::uint32_t l = 1; l <= kMaxChannels; ++l)
        if (core_.config.channels[l - 1].exists && (channel == 0 || channel == l)) {
            const std::uint32_t group = core_.config.channels[l - 1].group;
            program_handwheel_[group] = on;
            program_time_[group] = 0;
        }
}

void Machine::turn_program(std::uint32_t channel, double clicks) noexcept {
    if (channel == 0 || channel > kMaxChannels) return;
    const ChannelConfig& config = core_.config.channels[channel - 1];
    if (!program_handwheel_[config.group]) {
        core_.alarm(Alarm::NotReady, channel,
                    "the handwheel drives a program only after program_wheel");
        return;
    }
    const auto permit = MotionGate::ask(core_, Door::ProgramHandwheel, channel);
    if (!permit) {
        core_.alarm(Alarm::NotReady, channel,
                    "the handwheel drives a program only while the machine is on");
        return;
    }
    give_time(*permit, config.group, clicks * config.handwheel_time_s);
}

void Machine::give_time(Permit, std::uint32_t group, double seconds) noexcept {
    program_time_[group] += seconds;
}

void Machine::turn_handwheels() noexcept {
    constexpr double kFollowS = 0.2;  // the lag is made up within about this time
    constexpr double kNothingS = 1e-3;
    for (std::uint32_t group = 1; group < program_handwheel_.size(); ++group) {
        if (!program_handwheel_[group] && !program_handwheel_shown_[group]) continue;
        program_handwheel_shown_[group] = program_handwheel_[group];
        double& owed = program_time_[group];
        // one that cannot go further back stops the others too
        for (std::uint32_t l = 0; l < kMaxChannels; ++l)
            if (core_.config.channels[l].exists && core_.config.channels[l].group == group &&
                channels_[l]->handwheel_blocked() && owed < 0)
                owed = 0;
        const double rate =
            std::fabs(owed) < kNothingS ? 0.0 : std::clamp(owed / kFollowS, -1.0, 1.0);
        owed = rate == 0.0 ? 0.0 : owed - rate * core_.config.tick_s;
        for (std::uint32_t l = 0; l < kMaxChannels; ++l)
            if (core_.config.channels[l].exists && core_.config.channels[l].group == group)
                channels_[l]->set_handwheel(program_handwheel_[group], rate);
    }
}

}  // namespace polyturn::kernel
