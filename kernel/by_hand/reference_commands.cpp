// Referencing as the operator asks for it: one axis, or all in the order of PT_REF_ORDER; and what
// a drive reports by itself.
#include "kernel/drives/simulated_drive.hpp"
#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {
namespace {
std::string_view name_of(const AxisConfig& config) noexcept { return {config.name.data()}; }
}  // namespace

void Machine::reference_command(const Command& c) noexcept {
    if (MotionGate::missing(core_, Door::Reference, 0)) {
        core_.alarm(Alarm::ReferenceRefused, 0, "the machine is not on");
        return;
    }
    if (c.object > core_.config.axis_count ||
        (c.object != 0 && !core_.axes[c.object - 1].exists())) {
        core_.alarm(
            Alarm::ReferenceRefused, 0,
            "there is no drive behind this address: an axis must be exchanged onto it first");
        return;
    }
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (core_.axes[a].exists() &&
            (c.object == a + 1 || (c.object == 0 && core_.config.axes[a].reference.order != 0)))
            reference_axis(a, c.object != 0);
}

void Machine::reference_axis(std::uint32_t a, bool alone) noexcept {
    AxisUnit& axis = core_.axes[a];
    const AxisConfig& config = core_.config.axes[a];
    if (homing_[a].active()) return;
    const auto refuse = [&](std::string_view why) {
        ShortText text;
        text << name_of(config) << ": " << why;
        core_.alarm(Alarm::ReferenceRefused, config.channel, text.view());
    };
    if (MotionGate::missing(core_, Door::Reference, config.channel) & kDoorClosed)
        return refuse("the door is open: close it, or switch to setup mode");
    if (axis.detached) return alone ? refuse("it is detached") : void();
    if (axis.slave) return alone ? refuse("it follows another axis") : void();
    if (axis.owner && channels_[config.channel - 1]->program_runs())
        return refuse("a program moves it");
    if (config.reference.moves() && channels_[config.channel - 1]->program_runs())
        return refuse("a program runs in its channel");
    if (axis.moving() || jogs_[a].active() || slides_.carrier(core_, a)) return refuse("it moves");
    to_reference_[a] = true;
}

void Machine::run_homing() noexcept {
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        if (!core_.home_request[a]) continue;  // a program (record Home)
        core_.home_request[a] = false;
        const AxisUnit& axis = core_.axes[a];
        const bool may = MotionGate::ask(core_, Door::ReferenceByProgram, 0) && !axis.detached &&
                         !axis.bound() && !jogs_[a].active() && !slides_.carrier(core_, a);
        core_.home_failed[a] = !may;
        to_reference_[a] = may;
    }
    // asynchronous motion is reported in its tick, here and in run_jogs
    core_.jogging = 0;
    // Selects the axes that reference next. Axes of one order go together; the next order waits for
    // them.
    std::uint32_t turn = ~0u;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (to_reference_[a] || homing_[a].active())
            turn = std::min(turn, core_.config.axes[a].reference.order);
    core_.home_busy.fill(false);
    if (turn == ~0u) return;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        AxisUnit& axis = core_.axes[a];
        const AxisConfig& config = core_.config.axes[a];
        const bool ready = core_.signals.plc(signals::ap_rpe(a + 1)) != 0;
        if (to_reference_[a] && config.reference.order == turn) {
            to_reference_[a] = false;
            // asked again: its turn may come late
            const auto permit = MotionGate::ask(core_, Door::ReferenceByProgram, 0);
            if (!permit) {
                core_.home_failed[a] = true;
                continue;
            }
            axis.owner = 0;
            if (const InclinedSlides::Slide* slide = slide_of(a);
                slide && slide->taken_home && config.reference.moves() && square_rests(*slide))
                slides_.begin(core_, a);
            homing_[a].start(*permit, axis, ready, core_.config.tick_s,
                             limits_by_hand(a, config.rapid));
            if (axis.referenced && !homing_[a].active()) reference_gantry(a);
        }
        core_.home_busy[a] = to_reference_[a] || homing_[a].active();
        if (!homing_[a].active()) continue;
        core_.jogging |= ChannelSet{1} << (config.channel - 1);
        if (core_.state == MachineState::EmergencyStop) {
            if (!axis.brake(core_.config.tick_s)) homing_[a] = {};
            axis.watch_mark(false);
            axis.referenced = axis.referenced && !config.reference.moves();
            continue;
        }
        if (core_.all_stop) homing_[a].stop();
        const Homing::State now = homing_[a].step(
            axis, core_.signals.plc(signals::ap_decsw(a + 1)) != 0, ready, core_.config.tick_s);
        if (now == Homing::State::Done) reference_gantry(a);
        if (now == Homing::State::Failed) {
            core_.alarm(homing_[a].alarm(), config.channel, name_of(config));
            core_.home_failed[a] = true;
            for (std::uint32_t other = 0; other < core_.config.axis_count; ++other)
                core_.home_failed[other] = core_.home_failed[other] || to_reference_[other];
            to_reference_.fill(false);  // what was to follow waits for the operator
        }
    }
}

// The slaves of a gantry have come along: their reference point is their master's
// (nct_parameters_part2 22.3).
void Machine::reference_gantry(std::uint32_t master) noexcept {
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        AxisUnit& slave = core_.axes[a];
        if (couplings_.gantry_master(a) != master + 1 || !slave.exists() || slave.referenced)
            continue;
        slave.shift(couplings_.sense(a) * core_.axes[master].own() - slave.own());
        slave.referenced = true;
    }
}

void Machine::stop_homing() noexcept {
    to_reference_.fill(false);
    for (Homing& homing : homing_) homing.stop();
}

// Dual position loop (7.9): in simulation the device sits on the slide that the axis' own drive
// moves.
void Machine::open_direct_device(unsigned a) {
    const std::uint32_t number = core_.config.axes[a].servo.dual_axis;
    AxisUnit& axis = core_.axes[a];
    if (number < 1 || number > kMaxAxes || !axis.exists() || core_.config.axes[a].on_spindle)
        return;
    const bool simulated = core_.config.axes[a].servo.drive_source == DriveSource::Simulated;
    if (axis.open_direct(number, core_.config.axes[number - 1], core_.config.tick_s) && simulated)
        static_cast<SimulatedDrive*>(axis.direct_drive())
            ->measure(*static_cast<SimulatedDrive*>(axis.drive()));
}

// ABS with FLO: the drive knows its reference point, AP_RPE says so (part 1, 10.1). A level that
// was never on says nothing: a machine that starts referenced stays so.
void Machine::watch_drive_reference(std::uint32_t a) noexcept {
    const ReferenceConfig& reference = core_.config.axes[a].reference;
    const bool ready = core_.signals.plc(signals::ap_rpe(a + 1)) != 0;
    if (reference.absolute && reference.floating && ready != drive_ready_[a])
        core_.axes[a].referenced = ready;
    drive_ready_[a] = ready;
}

}  // namespace polyturn::kernel
