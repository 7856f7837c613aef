// The spindles' part of a tick: commands of the PLC and the channels, status reports, and faults.
#include <algorithm>
#include <cmath>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {
namespace {
// closer than that the C axis is where its program believes it
constexpr double kDisplacedDeg = 1e-3;
}  // namespace

// The operator's override of this spindle: none in a tapping cycle, and none while the program sets
// its own (fagor part 2, 11.2.10: program before panel); where the language has a range for
// the switch, from MINSOVR to MAXSOVR (fagor part 1, 5.3).
double Machine::operator_share(const SpindleUnit& spindle) const noexcept {
    if (spindle.owner == 0) return spindle.override_factor;
    if (channels_[spindle.owner - 1]->own_spindle_override()) return 1.0;
    if (!channels_[spindle.owner - 1]->traits().override_ranges) return spindle.override_factor;
    const SpindleConfig& config = spindle.config();
    return std::min(std::max(spindle.override_factor, config.override_min), config.override_max);
}

void Machine::open_spindle(unsigned index) {
    const SpindleConfig& config = core_.config.spindles[index];
    if (!config.exists || core_.spindles[index].exists()) return;  // or opened with its C axis
    const PolyturnDriveApi& api = drive_api(config.drive_source, 'S', index);
    void* drive = SpindleUnit::open_drive(index + 1, config, core_.config.tick_s, api);
    core_.spindles[index].open(config, core_.config.tick_s, api, drive,
                               config.drive_source == DriveSource::Simulated
                                   ? static_cast<SimulatedDrive*>(drive)
                                   : nullptr);
}

// A machine without one of its drives must not move: it keeps a fault, and the alarm says which is
// missing.
const PolyturnDriveApi& Machine::drive_api(DriveSource source, char letter,
                                           std::size_t index) noexcept {
    if (source == DriveSource::Simulated) return simulated_drive_api();
    if (source == DriveSource::Library && drive_library_) return *drive_library_;
    if (source == DriveSource::Process && segment_drives_)
        return letter == 'A' ? segment_drives_->axis_api() : segment_drives_->spindle_api();
    core_.alarm(Alarm::DriveMissing, 0, name_of(letter, index).view());
    return missing_drive_api();
}

// A C axis and its spindle get one drive between them.
void Machine::open_axis(unsigned index, double at) {
    const AxisConfig& config = core_.config.axes[index];
    const DriveSource source = config.servo.drive_source;
    if (!config.on_spindle) {
        core_.axes[index].open(index + 1, config, core_.config.tick_s, at,
                               drive_api(source, 'A', index));
        return;
    }
    const unsigned s = config.on_spindle - 1;
    const SpindleConfig& spindle = core_.config.spindles[s];
    PolyturnDriveSetup setup{};
    setup.version = POLYTURN_DRIVE_VERSION;
    setup.number = s + 1;
    setup.tick_s = core_.config.tick_s;
    setup.start_position = std::llround(at * 1e6);
    setup.frequency_hz = config.servo.drive_hz;
    setup.damping = config.servo.drive_damping;
    shared_drives_[s] =
        std::make_unique<SharedDrive>(drive_api(source, 'S', s), setup, spindle.drive_counts);
    shared_drives_[s]->hand_to_axis();
    core_.axes[index].open(index + 1, config, core_.config.tick_s, at, SharedDrive::axis_side());
    core_.spindles[s].open(
        spindle, core_.config.tick_s, SharedDrive::spindle_side(), shared_drives_[s].get(),
        source == DriveSource::Simulated ? static_cast<SimulatedDrive*>(shared_drives_[s]->real())
                                         : nullptr);
    shared_drives_[s]->give_to(SharedDrive::User::Axis);
    core_.shared_axes[index].has_drive = true;
}

// The user of a shared drive in this tick; it changes hands only at standstill.
void Machine::share_drives() noexcept {
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        const std::uint32_t s = core_.config.axes[a].on_spindle;
        if (!s || !core_.axes[a].exists()) continue;
        Core::SharedAxis& shared = core_.shared_axes[a];
        AxisUnit& axis = core_.axes[a];
        const SpindleUnit& spindle = core_.spindles[s - 1];
        const bool for_axis = core_.drive_is_for_axis(a);
        if (for_axis && !shared.has_drive && spindle.may_lend_drive()) {
            shared.has_drive = true;
            shared.displaced = std::fabs(axis.measured() - shared.left_at) > kDisplacedDeg;
        } else if (!for_axis && shared.has_drive && !axis.moving()) {
            shared.has_drive = false;
            if (!shared.displaced) shared.left_at = axis.command();
        }
        shared_drives_[s - 1]->give_to(shared.has_drive ? SharedDrive::User::Axis
                                                        : SharedDrive::User::Spindle);
        core_.signals.set_nc(signals::sn_axis(s), shared.has_drive);
    }
}

// The PLC gives a channel another spindle; the channel itself hears of it at its barrier.
void Machine::choose_spindles() noexcept {
    for (std::uint32_t l = 1; l <= kMaxChannels; ++l) {
        const std::int32_t chosen = core_.signals.plc(signals::cp_ssel(l));
        if (chosen == chosen_spindle_[l - 1]) continue;
        chosen_spindle_[l - 1] = chosen;
        core_.signals.set_nc(
            signals::cn_ssel(l),
            chosen > 0 ? chosen
                       : static_cast<std::int32_t>(core_.config.channels[l - 1].default_spindle));
    }
}

// A spindle is switched off only with the axes at rest: channels that cut with it are stopped
// first, and until they rest it goes on turning. Not when everything stops: then the axes follow
// the spindle down.
std::int32_t Machine::rotation_for(std::uint32_t s) noexcept {
    std::int32_t wanted = core_.signals.plc(signals::sp_rot(s + 1));
    if (wanted == 3 || wanted == 4)
        wanted = spindle_may_turn(s, wanted) ? wanted : 5;
    else
        turn_refused_[s] = {};
    const bool turned = rotation_[s] == 3 || rotation_[s] == 4;
    bool needed = false;
    // its chuck has opened: the axes first
    if (turn_refused_[s].code && turned && core_.on() && !core_.all_stop)
        for (auto& channel : channels_)
            needed = needed ||
                     (channel->path_moves() && core_.selected_spindle(channel->number()) == s + 1);
    if (turned && wanted != rotation_[s] && core_.on() && !core_.all_stop)
        for (auto& channel : channels_) {
            if (!channel->cuts_with(s + 1)) continue;
            channel->fault(Alarm::SpindleStands, name_of('S', s).view(), 0);
            needed = true;
        }
    if (!needed) rotation_[s] = wanted;
    return rotation_[s];
}

// Sinumerik: no change of speed during rapid moves; the one right in front of a cut has its speed
// already (sinumerik_part1 7.3).
double Machine::surface_position(SpindleUnit& spindle) const noexcept {
    const std::uint32_t axis = spindle.surface_axis();
    double& position = spindle.surface_position;
    const std::uint32_t owner =
        spindle.mode() == SpindleUnit::Mode::SurfaceSpeed ? spindle.locked_by : 0;
    const bool holds =
        owner != 0 && !spindle.demanded_anew() && channels_[owner - 1]->holds_surface_speed();
    if (!holds)
        position = core_.axes[axis].target();
    else if (const auto next = channels_[owner - 1]->cut_begins_at(axis))
        position = *next;
    return position;
}

void Machine::run_spindles() noexcept {
    choose_spindles();
    share_drives();
    spindle_couplings_.step(core_);
    if (const std::uint32_t torn = spindle_couplings_.torn();
        torn != SpindleCouplings::kNobody && core_.on())
        emergency_stop(Alarm::SpindleSlipped, core_.spindles[torn - kMaxAxes].owner,
                       SpindleCouplings::name_of_follower(torn).view(),
                       spindle_couplings_.deviation(torn));
    SpindleInput in;
    in.tick_s = core_.config.tick_s;
    in.powered = core_.on();
    in.stop = core_.all_stop;
    for (std::uint32_t s = 0; s < core_.config.spindle_count; ++s) {
        SpindleUnit& spindle = core_.spindles[s];
        if (!spindle.exists()) continue;
        const auto plc = [&](PlcSignal signal) { return core_.signals.plc(signal(s + 1)); };
        const auto tell = [&](NcSignal signal, std::int32_t value) {
            core_.signals.set_nc(signal(s + 1), value);
        };
        const bool detached = plc(signals::sp_sdetchr) != 0 &&
                              spindle.loop() == SpindleUnit::Loop::Turning && spindle.standing();
        in.rotation = rotation_for(s);
        in.range = static_cast<std::uint32_t>(plc(signals::sp_range));
        in.creep = plc(signals::sp_par) != 0;
        in.close_loop = plc(signals::sp_oreq) != 0;
        in.orient_switch = plc(signals::sp_osw) != 0;
        in.unwatched = plc(signals::sp_send) != 0;
        in.torque_limit = static_cast<std::uint16_t>(
            plc(signals::sp_torq) <= 0 || plc(signals::sp_torq) > 1000 ? 1000
                                                                       : plc(signals::sp_torq));
        in.muted = plc(signals::sp_sdetchr) != 0 ||
                   (shared_drives_[s] && shared_drives_[s]->user() == SharedDrive::User::Axis);
        in.override_factor = spindle.override_locked && !spindle.config().override_in_thread
                                 ? 1.0
                                 : operator_share(spindle);
        in.most_rpm = spindle.owner && core_.signals.plc(signals::cp_setup(spindle.owner))
                          ? spindle.config().setup_rpm
                          : kUnlimited;
        in.axis_position = surface_position(spindle);
        const bool fluctuated = spindle.fluctuates(), could_orient = !spindle.cannot_orient();
        const SpindleUnit::Fault fault = spindle.fault();
        spindle.step(in);
        // What is left in the filter of a measurement behind a stop turns nothing: a path fed by it
        // would creep for ever.
        core_.spindle_rev_s[s] =
            spindle.command() == 0.0 && spindle.standing() ? 0.0 : spindle.speed() / 60.0;
        tell(signals::sn_ns, spindle.reached());
        tell(signals::sn_n0, spindle.has_encoder() && spindle.standing());
        tell(signals::sn_flu, spindle.fluctuates());
        tell(signals::sn_inpos, spindle.in_position());
        tell(signals::sn_sindp, spindle.at_index());
        tell(signals::sn_sdetcha, detached);
        tell(signals::sn_range, static_cast<std::int32_t>(spindle.range_number()));
        if (spindle.fluctuates() && !fluctuated)
            core_.alarm(Alarm::SpindleFluctuates, spindle.owner, name_of('S', s).view(),
                        spindle.speed());
        if (spindle.cannot_orient() && could_orient)
            core_.alarm(Alarm::SpindleCannotClose, spindle.owner, name_of('S', s).view());
        if (spindle.fault() != fault && spindle.fault() != SpindleUnit::Fault::None)
            spindle_fault(s);
    }
}

// A spindle that does not follow its loop, or whose drive has failed, stops the machine; one that
// does not come into position only stops the program that waits for it.
void Machine::spindle_fault(std::uint32_t s) noexcept {
    const SpindleUnit& spindle = core_.spindles[s];
    const ShortText name = name_of('S', s);
    const double degrees = spindle.error() * 360.0;
    switch (spindle.fault()) {
        case SpindleUnit::Fault::Lost:
            return emergency_stop(Alarm::DriveLost, spindle.owner, name.view(), spindle.lost());
        case SpindleUnit::Fault::NotOn:
            return emergency_stop(Alarm::DriveNotOn, spindle.owner, name.view(),
                                  spindle.status_word());
        case SpindleUnit::Fault::Drive:
            return emergency_stop(Alarm::DriveFault, spindle.owner, name.view(), 0);
        case SpindleUnit::Fault::Standstill:
            return emergency_stop(Alarm::StandstillError, spindle.owner, name.view(), degrees);
        case SpindleUnit::Fault::Moving:
        case SpindleUnit::Fault::Absolute:
            return emergency_stop(Alarm::FollowingError, spindle.owner, name.view(), degrees);
        case SpindleUnit::Fault::NotOriented:
        case SpindleUnit::Fault::NotInPosition: {
            const Alarm reason = spindle.fault() == SpindleUnit::Fault::NotOriented
                                     ? Alarm::SpindleNotOriented
                                     : Alarm::SpindleNotInPosition;
            if (spindle.owner)
                channels_[spindle.owner - 1]->fault(reason, name.view(), degrees);
            else
                core_.alarm(reason, 0, name.view(), degrees);
            return;
        }
        default:
            return;
    }
}

}  // namespace polyturn::kernel
