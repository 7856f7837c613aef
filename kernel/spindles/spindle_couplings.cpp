#include "kernel/spindles/spindle_couplings.hpp"

#include <algorithm>
#include <cmath>

namespace polyturn::kernel {
namespace {
// of the follower's acceleration that the master's ramp may ask for
constexpr double kMasterShare = 0.3;
constexpr double kRampRiseS = 0.005;  // a turning spindle's ramp has no jerk limit of its own
constexpr double kPullShare = 0.02;   // of the follower's speed with which N0785 may pull
constexpr double kTurn = 360.0;

bool is_axis(std::uint32_t follower) noexcept { return follower < kMaxAxes; }
std::uint32_t spindle_of(std::uint32_t follower) noexcept {
    return follower - static_cast<std::uint32_t>(kMaxAxes);
}
}  // namespace

const char* SpindleCouplings::text(Refusal why) noexcept {
    switch (why) {
        case Refusal::NoSuch:
            return "one of the two does not exist";
        case Refusal::CannotFollow:
            return "the follower has no encoder, cannot close its loop, or its drive is lent";
        case Refusal::Ring:
            return "the master follows the same spindle";
        case Refusal::Busy:
            return "it follows another master, or a program moves it";
        case Refusal::TooFast:
            return "the master turns faster than the follower can";
        case Refusal::NotOn:
            return "the machine is not on";
        default:
            return "";
    }
}

const SpindleCouplings::Link* SpindleCouplings::find(std::uint32_t follower) const noexcept {
    for (std::size_t k = 0; k < end_; ++k)
        if (links_[k].used && links_[k].wish.follower == follower) return &links_[k];
    return nullptr;
}

bool SpindleCouplings::synchronous(std::uint32_t follower) const noexcept {
    const Link* link = find(follower);
    return link && link->was_synchronous && !link->ending;
}
std::uint32_t SpindleCouplings::master_of(std::uint32_t follower) const noexcept {
    const Link* link = find(follower);
    return link && !link->ending ? link->wish.master : 0;
}
double SpindleCouplings::deviation(std::uint32_t follower) const noexcept {
    const Link* link = find(follower);
    return link ? link->deviation * kTurn : 0.0;
}
std::uint32_t SpindleCouplings::gear_of(std::uint32_t channel) const noexcept {
    for (std::size_t k = 0; k < end_; ++k)
        if (const Link& link = links_[k];
            link.used && !link.ending && link.wish.gear && link.wish.channel == channel)
            return link.wish.follower;
    return kNobody;
}

LineFollower::Limits SpindleCouplings::limits_of(const Core& core,
                                                 std::uint32_t follower) noexcept {
    if (is_axis(follower)) {
        const AxisConfig& axis = core.config.axes[follower];
        return {axis.rapid / kTurn, axis.acceleration / kTurn, axis.jerk / kTurn};
    }
    const SpindleRange& range = core.spindles[spindle_of(follower)].range();
    // a turning spindle's, where it has one
    const double ramp = std::min(range.ramp_up, range.ramp_down) / 60.0;
    const double acceleration = std::isfinite(ramp) ? ramp : range.acceleration;
    return {range.speed_max / 60.0, acceleration, acceleration / kRampRiseS};
}

// Turns that the follower should have made, `ahead` seconds after this tick's start, but for the
// offset of its follower.
PathState SpindleCouplings::line_of(const Core& core, const Link& link,
                                    double ahead) const noexcept {
    const SpindleUnit& master = core.spindles[link.wish.master - 1];
    const SpindleObserver& seen = master.observer();
    const double v = seen.speed() / kTurn, a = seen.acceleration() / kTurn;
    PathState line{seen.angle(ahead) / kTurn - master.zero_turns(), v + a * ahead, a};
    line = {line.s * link.ratio, line.v * link.ratio, line.a * link.ratio};
    line.s += link.wish.phase + link.pull + link.own + link.wish.own_rev_s * ahead;
    line.v += link.pull_v + link.wish.own_rev_s;
    if (!is_axis(link.wish.follower))
        line.s += core.spindles[spindle_of(link.wish.follower)].zero_turns();
    if (link.wish.helix != kNoHelix) {
        const AxisUnit& axis = core.axes[link.wish.helix];
        const double at = ahead > 0 ? axis.target() : axis.command();
        const double dt = core.config.tick_s;
        line.s += link.wish.helix_deg_mm * (at - link.helix_from) / kTurn;
        line.v += link.wish.helix_deg_mm * (axis.target() - axis.command()) / dt / kTurn;
    }
    return line;
}

SpindleCouplings::Refusal SpindleCouplings::couple(Core& core, const Wish& wish) noexcept {
    if (!core.on()) return Refusal::NotOn;
    if (wish.master < 1 || wish.master > kMaxSpindles || !core.spindles[wish.master - 1].exists() ||
        wish.master_turns <= 0 || wish.turns == 0)
        return Refusal::NoSuch;
    if (!core.spindles[wish.master - 1].has_encoder()) return Refusal::CannotFollow;
    if (Link* same = find(wish.follower)) {
        if (same->ending || same->wish.channel != wish.channel) return Refusal::Busy;
        same->used = false;  // with another phase or ratio: from where it is
    }
    for (std::uint32_t m = kMaxAxes + wish.master - 1, n = 0; n < kMaxSpindles; ++n) {
        if (m == wish.follower) return Refusal::Ring;
        const std::uint32_t next = master_of(m);
        if (!next) break;
        m = kMaxAxes + next - 1;
    }
    Link fresh;
    fresh.wish = wish;
    fresh.used = true;
    fresh.ratio = wish.turns / wish.master_turns;
    PathState now;
    if (is_axis(wish.follower)) {
        const AxisUnit& axis = core.axes[wish.follower];
        if (!axis.exists() || !core.config.axes[wish.follower].rotary) return Refusal::NoSuch;
        if (axis.slave || axis.moving() || axis.detached || !axis.closed()) return Refusal::Busy;
        now = {axis.own() / kTurn, 0, 0};
    } else {
        const std::uint32_t s = spindle_of(wish.follower);
        if (s >= kMaxSpindles || !core.spindles[s].exists()) return Refusal::NoSuch;
        const SpindleUnit& spindle = core.spindles[s];
        if (!spindle.may_follow()) return Refusal::CannotFollow;
        now = spindle.turning_state();
    }
    const LineFollower::Limits limits = limits_of(core, wish.follower);
    if (wish.helix != kNoHelix) fresh.helix_from = core.axes[wish.helix].command();
    const PathState line = line_of(core, fresh, 0.0);
    if (std::fabs(line.v) > limits.speed) return Refusal::TooFast;
    // A phase holds for any turn of the follower that belongs to some turn of the master.
    const double period = 1.0 / wish.master_turns;
    fresh.follower.begin(now, line, limits,
                         wish.phased ? LineFollower::Aim::Period : LineFollower::Aim::Anywhere,
                         period, core.config.tick_s);
    for (std::size_t k = 0; k < links_.size(); ++k)
        if (!links_[k].used) {
            links_[k] = fresh;
            end_ = std::max(end_, k + 1);
            return Refusal::None;
        }
    return Refusal::Busy;
}

void SpindleCouplings::uncouple(std::uint32_t follower) noexcept {
    if (Link* link = find(follower)) link->ending = true;
}

void SpindleCouplings::reset(std::uint32_t channel) noexcept {
    for (Link& link : links_)
        if (link.used && link.wish.channel != 0 && (channel == 0 || link.wish.channel == channel) &&
            !link.wish.gear)
            link.ending = true;
}

void SpindleCouplings::shifted(std::size_t axis, double by) noexcept {
    for (Link& link : links_) {
        if (!link.used) continue;
        if (link.wish.follower == axis) link.follower.shift(by / kTurn);
        if (link.wish.helix == axis) link.helix_from += by;
    }
}

// Levels of the PLC for one spindle.
void SpindleCouplings::obey_plc(Core& core, std::uint32_t s) noexcept {
    const SpindleConfig& config = core.spindles[s].config();
    const auto follower = static_cast<std::uint32_t>(kMaxAxes) + s;
    const std::int32_t rotation = core.signals.plc(signals::sp_rot(s + 1));
    const bool by_code = (config.sync_code && rotation == config.sync_code) ||
                         (config.phase_code && rotation == config.phase_code);
    const bool wanted =
        config.sync_master && core.on() && (by_code || core.signals.plc(signals::sp_syncr(s + 1)));
    const Link* link = find(follower);
    if (!wanted) {
        told_[s] = false;
        if (link && link->wish.channel == 0) uncouple(follower);
        return;
    }
    const bool phased = (config.phase_code && rotation == config.phase_code) ||
                        core.signals.plc(signals::sp_phaser(s + 1));
    if (link && (link->ending || link->wish.channel != 0 || link->wish.phased == phased)) return;
    Wish wish;
    wish.master = config.sync_master;
    wish.follower = follower;
    wish.turns = config.sync_turns;
    wish.master_turns = config.sync_master_turns;
    wish.phased = phased;
    wish.phase = phased ? config.phase_shift : 0.0;
    const Refusal why = couple(core, wish);
    if (why == Refusal::None || told_[s]) return;
    told_[s] = true;
    ShortText detail = name_of('S', s);
    detail << ": " << text(why);
    core.alarm(Alarm::SpindleCoupleRefused, core.spindles[s].owner, detail.view());
}

void SpindleCouplings::drive(Core& core, Link& link) noexcept {
    const double dt = core.config.tick_s;
    const std::uint32_t f = link.wish.follower;
    if (is_axis(f)) {
        AxisUnit& axis = core.axes[f];
        if (!core.on() || axis.detached) {
            axis.geared = false;
            if (!axis.brake(dt)) link.used = false;
            link.ending = true;
            return;
        }
        axis.geared = true;
        if (link.ending) {
            const PathState rest = link.follower.brake(dt);
            axis.move_to(rest.s * kTurn);
            if (rest.v == 0 && rest.a == 0) axis.geared = link.used = false;
            return;
        }
    } else if (link.ending || !core.on()) {
        core.spindles[spindle_of(f)].uncouple();
        link.used = false;
        return;
    }
    SpindleUnit& master = core.spindles[link.wish.master - 1];
    const LineFollower::Limits limits = limits_of(core, f);
    const double size = std::fabs(link.ratio);
    master.ceiling_rpm =
        std::min(master.ceiling_rpm,
                 std::max(limits.speed - std::fabs(link.wish.own_rev_s), 0.0) / size * 60.0);
    master.ceiling_ramp =
        std::min(master.ceiling_ramp, kMasterShare * limits.acceleration / size * 60.0);
    // How far the measured follower is from the measured line, both of this tick's start.
    const PathState here = line_of(core, link, 0.0);
    const double measured =
        is_axis(f) ? core.axes[f].measured() / kTurn : core.spindles[spindle_of(f)].turns();
    // N0785 leads the follower's command until nothing of this is left: its own pull is no part of
    // it, or it would pull for ever.
    link.deviation = here.s - link.pull + link.follower.offset() + link.follower.gap() - measured;
    double window = 1.0 / kTurn, error = 0, gain = 0;
    if (!is_axis(f)) {
        const SpindleConfig& config = core.spindles[spindle_of(f)].config();
        window = config.sync_window;
        error = config.sync_error;
        gain = core.spindles[spindle_of(f)].range().synchr_gain;
    } else {
        window = std::max(window,
                          std::fabs(here.v) / std::max(core.config.axes[f].servo.gain, 1.0) * 1.5);
    }
    if (link.follower.on_line() && gain > 0) {
        const double most = kPullShare * limits.speed, step = 0.1 * limits.acceleration * dt;
        const double v = std::clamp(gain * link.deviation, -most, most);
        link.pull_v = std::clamp(v, link.pull_v - step, link.pull_v + step);
        link.pull += link.pull_v * dt;
    }
    const PathState next = link.follower.tick(line_of(core, link, dt), dt);
    link.own += link.wish.own_rev_s * dt;
    const bool near = link.follower.on_line() && std::fabs(link.deviation) <= window;
    if (near) link.was_synchronous = true;
    if (link.was_synchronous && error > 0 && std::fabs(link.deviation) > error) skewed_ = f;
    if (is_axis(f))
        core.axes[f].move_to(next.s * kTurn);
    else
        core.spindles[spindle_of(f)].couple(next, near);
}

void SpindleCouplings::step(Core& core) noexcept {
    skewed_ = kNobody;
    for (std::uint32_t s = 0; s < core.config.spindle_count; ++s) {
        SpindleUnit& spindle = core.spindles[s];
        spindle.ceiling_rpm = spindle.ceiling_ramp = kUnlimited;
        if (spindle.exists()) obey_plc(core, s);
    }
    for (std::size_t k = 0; k < end_; ++k)
        if (links_[k].used) drive(core, links_[k]);
    while (end_ > 0 && !links_[end_ - 1].used) --end_;
    for (std::uint32_t s = 0; s < core.config.spindle_count; ++s) {
        if (!core.spindles[s].exists()) continue;
        const auto follower = static_cast<std::uint32_t>(kMaxAxes) + s;
        core.signals.set_nc(signals::sn_synca(s + 1), core.spindles[s].follows_well());
        core.signals.set_nc(signals::sn_follow(s + 1),
                            static_cast<std::int32_t>(master_of(follower)));
    }
    for (std::uint32_t l = 1; l <= kMaxChannels; ++l)
        if (core.config.channels[l - 1].exists)
            core.signals.set_nc(signals::cn_egba(l), gear_of(l) != kNobody);
}

}  // namespace polyturn::kernel
