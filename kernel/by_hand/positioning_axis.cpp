// Asynchronous axes (architecture 5.7): PLC axes (AP_PAXR) and positioning axes of a program
// (record Beside). Each has its own feed, and several move at once; events report when one begins
// and when it is at rest. Also the contour monitoring.
//
//   AP_PAXR     ____/-----------\____     rising: to AP_PAXPOS with AP_PAXFEED; falling: it brakes
//   AN_PAXA     _____/-----\__________     while it moves
//
// An axis may also run a program of its own, step by step (positioning_program.hpp); AN_PAXA stays
// until that is over. The PLC must allow it (AP_PAXENA), and may end it without ending anything
// else (AP_PAXRST; fanuc_lathe 10.4.6).
//
// A positioning axis of a program obeys its channel: it stops in a hold and at override 0, goes on
// with the program, and ends where it is with a reset or an alarm. Machine lock lets it be where it
// is to be without moving.
#include <cmath>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {
namespace {
// an axis that its path has just left may take so long to stop
constexpr double kComesToRestS = 1.0;
constexpr double kPositioningStandstillRevS = 1e-3;

// A feed per revolution of a stopped spindle would wait for ever. As on the path, the PLC may
// still be writing SP_ROT: some of its cycles of grace.
bool needs_spindle_standstill(const Core& core, Core::PositioningRequest& wish,
                              bool holds) noexcept {
    const bool known = wish.spindle >= 1 && wish.spindle <= kMaxSpindles;
    const bool turns =
        known && (core.spindles[wish.spindle - 1].command() != 0.0 ||
                  std::fabs(core.spindle_rev_s[wish.spindle - 1]) >= kPositioningStandstillRevS);
    if (!wish.per_turn || turns || holds) wish.since = core.tick;
    return core.tick - wish.since > 3 * core.config.plc_cycle_ticks;
}
}  // namespace

bool Machine::start_positioning_axis(std::uint32_t a,
                                     const Core::PositioningRequest& wish) noexcept {
    AxisUnit& axis = core_.axes[a];
    const AxisConfig& config = core_.config.axes[a];
    const auto permit =
        MotionGate::ask(core_, wish.channel ? Door::Positioning : Door::PlcAxis, config.channel);
    const bool may = axis.exists() && permit && axis.referenced && !axis.bound() &&
                     !axis.detached && !axis.moving() && !jogs_[a].active() &&
                     !slides_.carrier(core_, a) && !homing_[a].active() && !to_reference_[a] &&
                     axis.closed() && !(config.on_spindle && !core_.shared_axes[a].has_drive);
    if (!may) {
        axis.beside = false;
        if (wish.channel)
            channels_[wish.channel - 1]->fault(Alarm::PositioningRefused, name_of('A', a).view(),
                                               0);
        else
            core_.alarm(Alarm::PositioningRefused, config.channel, name_of('A', a).view());
        return false;
    }
    positioning_axes_[a] = wish;
    positioning_axes_[a].asked = true;
    const double way = wish.target - axis.own();
    const std::uint32_t l = wish.channel ? wish.channel : config.channel;
    core_.event(KernelEventKind::PositioningBegin, l, static_cast<std::int32_t>(a + 1), wish.target,
                wish.line);
    axis.beside = true;
    if (wish.channel && (channels_[wish.channel - 1]->panel().keys & kKeyMachineLock)) return true;
    if (way == 0) return true;
    start_jog(*permit, a, way > 0 ? 1.0 : -1.0, config.rapid, std::fabs(way), 0.0, true);
    jogs_[a].limit_speed(positioning_speed(a));
    if (wish.channel && jogs_[a].active()) axis.owner = wish.channel;
    if (wish.channel && std::fabs(way) > core_.stroke.room(core_, a, way))
        channels_[wish.channel - 1]->fault(
            Alarm::StrokeLimit, name_of('A', a).view(),
            axis.own() + std::copysign(core_.stroke.room(core_, a, way), way));
    return true;
}

// As fast as it may be in this tick: feed, override and hold of the channel whose program it is.
double Machine::positioning_speed(std::uint32_t a) const noexcept {
    const Core::PositioningRequest& wish = positioning_axes_[a];
    const AxisConfig& config = core_.config.axes[a];
    double v = config.rapid;
    if (wish.per_turn)
        v = wish.speed * (wish.spindle >= 1 && wish.spindle <= kMaxSpindles
                              ? std::fabs(core_.spindle_rev_s[wish.spindle - 1])
                              : 0.0);
    else if (wish.speed > 0)
        v = wish.speed;
    if (wish.channel) {
        const ChannelRunner& runner = *channels_[wish.channel - 1];
        if (runner.holds_positioning()) return 0.0;
        v *= runner.handwheel_share();
        v *= wish.speed > 0 ? runner.feed_factor() : runner.panel().rapid_override;
    }
    if (core_.signals.plc(signals::cp_setup(config.channel))) v = std::fmin(v, config.setup_feed);
    if (!core_.axes[a].referenced && config.reference.rapid > 0)
        v = std::fmin(v, config.reference.rapid);
    return std::fmin(v, config.rapid);
}

// It rests: says so. True when it did.
bool Machine::end_positioning(std::uint32_t a) noexcept {
    AxisUnit& axis = core_.axes[a];
    if (jogs_[a].active() || axis.moving()) return false;
    const Core::PositioningRequest& wish = positioning_axes_[a];
    const std::uint32_t l = wish.channel ? wish.channel : core_.config.axes[a].channel;
    axis.beside = false;
    core_.event(KernelEventKind::PositioningEnd, l, static_cast<std::int32_t>(a + 1), axis.own(),
                wish.line);
    if (wish.note)
        if (KernelEvent* event = core_.log.claim(KernelEventKind::RecordEnd, l, core_.tick, 0)) {
            event->note = wish.note;
            event->line = wish.line;
            event->code = static_cast<std::int32_t>(RecordKind::PositioningAxis);
            core_.log.put();
        }
    positioning_axes_[a] = {};
    return true;
}

void Machine::run_positioning() noexcept {
    for (auto& runner : channels_) runner->queue_up();
    for (auto& runner : channels_) runner->run_steps();
    for (Core::PositioningTurn& turn : core_.positioning_turn)
        turn.first = Core::PositioningTurn::kNobody;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        AxisUnit& axis = core_.axes[a];
        if (!axis.exists()) continue;
        const bool asked = core_.signals.plc(signals::ap_paxr(a + 1)) != 0;
        if (positioning_axes_[a].asked) {
            const std::uint32_t l = positioning_axes_[a].channel;
            const bool ended =
                positioning_axes_[a].own && core_.signals.plc(signals::ap_paxrst(a + 1)) != 0;
            const bool over = l ? !channels_[l - 1]->program_runs() ||
                                      channels_[l - 1]->breaks_off_positioning() || ended
                                : !asked;
            if (!over && l && jogs_[a].active() &&
                needs_spindle_standstill(core_, positioning_axes_[a],
                                         channels_[l - 1]->holds_positioning()))
                channels_[l - 1]->fault(
                    Alarm::SpindleStands,
                    name_of('S',
                            positioning_axes_[a].spindle ? positioning_axes_[a].spindle - 1u : 0u)
                        .view(),
                    0);
            if (over)
                jogs_[a].stop();
            else if (jogs_[a].active())
                jogs_[a].limit_speed(positioning_speed(a));
            end_positioning(a);
        }
        Core::PositioningRequest& wish = core_.beside[a];
        if (wish.asked && !positioning_axes_[a].asked) {
            const bool waits =
                axis.moving() &&
                static_cast<double>(core_.tick - wish.since) * core_.config.tick_s < kComesToRestS;
            if (!channels_[wish.channel - 1]->program_runs() ||
                (wish.own && core_.signals.plc(signals::ap_paxrst(a + 1)))) {
                axis.beside = false;
                wish = {};
            } else if (!waits) {
                const Core::PositioningRequest now = wish;
                wish = {};
                start_positioning_axis(a, now);
            }
        } else if (asked && !pax_request_[a] && !wish.asked) {
            const double unit = core_.config.axes[a].inch ? 25.4 : 1.0;
            const double place = core_.signals.plc(signals::ap_paxpos(a + 1)) / 1000.0 * unit;
            Core::PositioningRequest plc;
            plc.target = core_.signals.plc(signals::ap_paxinc(a + 1)) ? axis.own() + place : place;
            plc.speed = core_.signals.plc(signals::ap_paxfeed(a + 1)) * unit / 60.0;
            start_positioning_axis(a, plc);
        }
        pax_request_[a] = asked;
        const bool own = core_.config.axes[a].channel >= 1 &&
                         channels_[core_.config.axes[a].channel - 1]->runs_positioning(a);
        core_.signals.set_nc(signals::an_paxa(a + 1),
                             axis.beside || own || core_.positioning_turn[a].channel != 0);
    }
    watch_contours();
}

// Distance of the measured axes from the commanded path: the part of the following errors that is
// not along it.
void Machine::watch_contours() noexcept {
    for (std::uint32_t l = 1; l <= kMaxChannels; ++l) {
        const double tolerance = core_.config.channels[l - 1].contour_tolerance;
        if (tolerance <= 0 || !channels_[l - 1]->cuts()) continue;
        double speed2 = 0, along = 0, error2 = 0;
        for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
            const AxisUnit& axis = core_.axes[a];
            if (!axis.exists() || axis.owner != l || axis.beside ||
                axis.requests.torque_limit != 0 || core_.config.axes[a].rotary)
                continue;
            speed2 += axis.velocity() * axis.velocity();
            along += axis.velocity() * axis.error();
            error2 += axis.error() * axis.error();
        }
        if (speed2 == 0) continue;
        const double beside = std::sqrt(std::fmax(0.0, error2 - along * along / speed2));
        if (beside <= tolerance) continue;
        ShortText name;
        name << "L" << l;
        channels_[l - 1]->fault(Alarm::ContourDeviates, name.view(), beside);
    }
}

}  // namespace polyturn::kernel
