// Axes moved by hand: jog for a time, step a distance, turn the handwheel.
#include <cmath>

#include "kernel/cyclic/machine.hpp"

namespace polyturn::kernel {
namespace {
constexpr double kWheelClick = 0.001;  // mm or degrees
constexpr std::int64_t kByRegister = 1;

// CP_JOGFD: five steps a decade from 2 mm/min on (nct_parameters_part1 5.5); degrees are a fifth of it.
double feed_of_register(std::int32_t step) { return step <= 0 ? 0.0 : 2.0 * std::pow(10.0, (step - 1) / 5.0) / 60.0; }
}  // namespace

double Machine::jog_feed(std::uint32_t a) const noexcept {
    const AxisConfig& axis = core_.config.axes[a];
    const ChannelConfig& channel = core_.config.channels[axis.channel - 1];
    const double most = axis.jog_max_feed > 0 ? std::fmin(axis.jog_max_feed, axis.rapid) : axis.rapid;
    double feed = channel.jog_feed;
    if (channel.jog_feed_source == kByRegister) feed = feed_of_register(core_.signals.plc(signals::cp_jogfd(axis.channel))) / (axis.rotary ? 5.0 : 1.0);
    return feed > 0 ? std::fmin(feed, most) : most;  // nobody chose a feed: the fastest that is allowed by hand
}

void Machine::jog_command(const Command& c) noexcept {
    if (c.object == 0 || c.object > kMaxAxes || !core_.axes[c.object - 1].exists()) return;
    const std::uint32_t a = c.object - 1;
    AxisUnit& axis = core_.axes[a];
    const AxisConfig& config = axis.config();
    if (!core_.on() || core_.all_stop || channels_[config.channel - 1]->program_runs()) {
        core_.alarm(Alarm::NotReady, config.channel, "axes are moved by hand only while the machine is on and no program of the channel runs");
        return;
    }
    if (axis.slave) {
        core_.alarm(Alarm::SlaveCommanded, config.channel, name_of('A', a).view());
        return;
    }
    if (axis.moving() || jogs_[a].active()) return;
    const auto kind = static_cast<CommandKind>(c.kind);
    const double sign = c.value < 0 ? -1.0 : 1.0, size = std::fabs(c.value);
    const double distance = kind == CommandKind::Jog ? 0.0 : kind == CommandKind::Step ? size : size * kWheelClick;
    const double by_hand = config.manual_rapid > 0 ? std::fmin(config.manual_rapid, config.rapid) : config.rapid;
    const AxisJog::Limits limits{kind == CommandKind::Jog ? jog_feed(a) : by_hand, config.acceleration, config.jerk};
    const double room = core_.stroke.room(core_, a, sign);
    jogs_[a].start(axis.own(), sign, limits, std::llround(size / core_.config.tick_s), distance, room, core_.config.tick_s);
    if (jogs_[a].active()) axis.owner = 0;
}

void Machine::run_jogs() noexcept {
    core_.jogging = 0;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        if (!jogs_[a].active()) continue;
        core_.jogging |= ChannelSet{1} << (core_.config.axes[a].channel - 1);
        AxisUnit& axis = core_.axes[a];
        if (core_.state == MachineState::EmergencyStop) {
            if (!axis.brake(core_.config.tick_s)) jogs_[a] = {};
            continue;
        }
        if (core_.all_stop) jogs_[a].stop();
        axis.move_to(jogs_[a].step(core_.config.tick_s));
    }
}

}  // namespace polyturn::kernel
