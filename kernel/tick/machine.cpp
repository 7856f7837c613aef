#include "kernel/tick/machine.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "kernel/drives/simulated_drive.hpp"

namespace polyturn::kernel {
namespace {
// a PLC whose signals have not changed for so long counts down nothing
constexpr double kPlcQuietS = 0.2;
// ... unless an M, S or T is open: turrets and chucks take their time
constexpr double kHandshakeQuietS = 20.0;
}  // namespace

Machine::Machine(KernelSegment& image, const SupervisorSegment& supervisor,
                 const StoreSegment& store)
    : store_segment_(&store),
      core_(image, supervisor, store),
      commands_(supervisor, image),
      plc_(core_),
      trace_ring_(image.trace, supervisor.trace_tail) {
    for (unsigned i = 0; i < kMaxChannels; ++i) {
        channels_[i] = std::make_unique<ChannelRunner>(core_, i);
        runners_[i] = channels_[i].get();
    }
}

Machine::~Machine() {
    for (AxisUnit& axis : core_.axes) axis.close();
    for (SpindleUnit& spindle : core_.spindles) spindle.close();
}

void Machine::start() {
    const RunOptions& options = core_.supervisor.options;
    core_.virtual_time = options.virtual_time != 0;
    core_.spindle_couplings = &spindle_couplings_;
    core_.guard = &guard_;
    core_.couplings = &couplings_;
    read_config(core_.table, core_.config, true);
    couplings_.configure(core_.table, core_.config);
    slides_.configure(core_.table, core_.config);
    couplings_.lower_limits(core_);
    compensation_.configure(core_.table, core_.config);
    guard_.configure(core_.table, core_.config);
    core_.stroke.configure(core_.config);
    // P1: constant, written before own->publish() (the order is stronger than needed)
    core_.image.tick_ns.store(static_cast<std::uint64_t>(core_.config.tick_ns),
                              std::memory_order_release);
    for (unsigned a = 0; a < kMaxAxes; ++a) {
        if (!core_.config.axes[a].exists) continue;
        // A simulated machine is where it was left.
        const double left_at = store_segment_->totals.published().last_position[a];
        const ReferenceConfig& reference = core_.config.axes[a].reference;
        const double was_at = left_at + reference.absolute_origin();
        const double at = options.start_known[a]   ? options.start_position[a]
                          : std::isfinite(left_at) ? was_at
                                                   : 0.0;
        open_axis(a, at);
        open_direct_device(a);
        core_.axes[a].referenced = options.ready != 0 || reference.absolute;
        check_absolute(a, at);
    }
    for (unsigned s = 0; s < kMaxSpindles; ++s) open_spindle(s);
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        const double factor = options.feed_override[l];
        channels_[l]->panel().feed_override = factor > 0 ? factor : 1.0;
        if (core_.config.channels[l].exists) channels_[l]->prepare();
    }
    show_free_parameters();
    core_.totals.start(core_.table);
    // P1: the tables of this version are published
    store_version_ = store_segment_->version.load(std::memory_order_acquire);
    core_.tools.start(core_.image, *store_segment_);
    core_.stroke.update(core_);
    set_state(options.ready ? MachineState::On : MachineState::Off);
    step_ = step_now();  // a start is no change
    publish();
}

void Machine::attach_channel(unsigned index, const ChannelSegment& segment) {
    // P4: read by this thread alone (the order is stronger than needed)
    core_.channel_segment[index].store(&segment, std::memory_order_release);
    channels_[index]->attach(segment);
}

void Machine::take_tables(CompensationTables tables) {
    compensation_.take_tables(std::move(tables));
}

void Machine::attach_plc(const PlcSegment& segment) {
    // P4: read by this thread alone (the order is stronger than needed)
    core_.plc_segment.store(&segment, std::memory_order_release);
    plc_.started();
}

void Machine::set_state(MachineState state) noexcept {
    core_.state = state;
    core_.signals.set_nc(signals::n_machine_on(), state == MachineState::On);
    core_.signals.set_nc(signals::n_estop(), state == MachineState::EmergencyStop);
}

// Real time only: in virtual time only channels have successors, between two ticks
// (clock_virtual.cpp); other processes stay dead.
void Machine::take_restarted_processes() noexcept {
    // P7, here and below: a look that costs nothing, then the place is taken
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        if (core_.next_channel[l].load(std::memory_order_relaxed) == nullptr ||
            !channels_[l]->may_be_replaced())
            continue;
        // P7: taken
        if (const ChannelSegment* segment =
                core_.next_channel[l].exchange(nullptr, std::memory_order_acquire))
            attach_channel(l, *segment);
    }
    // P7: a look, then taken
    if (core_.next_plc.load(std::memory_order_relaxed) != nullptr)
        if (const PlcSegment* segment = core_.next_plc.exchange(nullptr, std::memory_order_acquire))
            attach_plc(*segment);
    // P7: a look, then taken
    if (core_.next_store.load(std::memory_order_relaxed) != nullptr)
        if (const StoreSegment* segment =
                core_.next_store.exchange(nullptr, std::memory_order_acquire)) {
            store_segment_ = segment;
            core_.store.rebind(core_.image, *segment);
            core_.tools.rebind(core_.image, *segment);
            core_.store_dead = false;
        }
    // P7: released too, for those taken before are written again
    if (core_.next_shapes.load(std::memory_order_relaxed) != nullptr)
        if (const ToolShapes* shapes =
                core_.next_shapes.exchange(nullptr, std::memory_order_acq_rel)) {
            guard_.take_tools(*shapes);
            guard_.configure(core_.table, core_.config);
        }
    // P7: a look, then taken
    if (core_.next_compensation.load(std::memory_order_relaxed) != nullptr) {
        bool rest = true;
        for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
            rest = rest && !(core_.axes[a].exists() && core_.axes[a].moving());
        if (rest) {
            // P7: used, then the place is given back
            compensation_.use_tables(*core_.next_compensation.load(std::memory_order_acquire));
            core_.next_compensation.store(nullptr, std::memory_order_release);
        }
    }
    // P3: a flag, announces nothing (the order is stronger than needed)
    if (core_.compensation_refused.exchange(false, std::memory_order_acquire))
        core_.alarm(Alarm::CompensationTable, 0,
                    "machine.compensation was not taken (params check says why)");
    // What operators change in the store (offsets, zeros) the channels take over at their next
    // barrier.
    // P1: the tables of this version are published
    const std::uint64_t version = store_segment_->version.load(std::memory_order_acquire);
    if (version != store_version_) {
        store_version_ = version;
        for (auto& channel : channels_) channel->store_changed();
    }
}

void Machine::tick() noexcept {
    if (!core_.virtual_time) take_restarted_processes();
    if (segment_drives_) segment_drives_->begin();
    take_commands();
    take_answers();
    supervise();
    core_.stroke.update(core_);
    run_channels();
    run_homing();
    run_gear_retracts();
    run_retracts();
    run_positioning();
    run_jogs();
    run_overlays();
    run_spindles();
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (const double by = core_.axes[a].take_shift(); by != 0) {
            couplings_.shifted(a, by);
            spindle_couplings_.shifted(a, by);
            slides_.shifted(a, by);
        }
    run_inclined_slides();
    core_.standing = 0;
    for (unsigned l = 0; l < kMaxChannels; ++l)
        core_.standing |= channels_[l]->stands() ? ChannelSet{1} << l : ChannelSet{0};
    couplings_.step(core_);
    for (unsigned l = 0; couplings_.changed() >> l; ++l)
        if (couplings_.changed() >> l & 1u) channels_[l]->forget_trail();
    refuse_coupling();
    if (const std::uint32_t torn = couplings_.skewed_gantry(); torn && core_.on())
        emergency_stop(Alarm::GantryError, core_.config.axes[torn - 1].channel,
                       name_of('A', torn - 1).view(), core_.axes[torn - 1].measured());
    protect();
    compensation_.step(core_);
    run_axes();
    if (segment_drives_) segment_drives_->end();
    position_signals();
    watch_step();
    core_.sensors.look(core_.axes, core_.spindles, core_.signals, core_.config.axis_count,
                       core_.tick);
    count_totals();
    watch_signals();
    trace();
    ++core_.tick;
    publish();
    for (auto& channel : channels_) channel->send_events();
    --core_.tick;
    plc_.send_inputs();
    ++core_.tick;
}

void Machine::adopt_parameters() noexcept {
    read_config(core_.table, core_.config, false);
    couplings_.configure(core_.table, core_.config);
    slides_.configure(core_.table, core_.config);
    couplings_.lower_limits(core_);
    compensation_.configure(core_.table, core_.config);
    guard_.configure(core_.table, core_.config);
    show_free_parameters();
    core_.stroke.configure(core_.config);
    core_.totals.adopt(core_.table);
    for (unsigned a = 0; a < core_.config.axis_count; ++a)
        core_.axes[a].configure(core_.config.axes[a]);
    for (unsigned s = 0; s < core_.config.spindle_count; ++s)
        core_.spindles[s].configure(core_.config.spindles[s]);
    for (auto& channel : channels_) channel->store_changed();
}

void Machine::take_answers() noexcept {
    if (core_.store.take_changes(core_.table, core_.tick, core_.virtual_time)) adopt_parameters();
    core_.tools.take_answers(core_);
    if (core_.store.value_taken())
        for (auto& channel : channels_) channel->store_changed();
    // Said once; the machine stays stopped until a reset finds the PLC answering again.
    const PlcLink::Take plc = plc_.take_outputs();
    const bool late = plc_.take_fast() == PlcLink::Take::Late || plc == PlcLink::Take::Late;
    if (late && !plc_late_) stop_all(Alarm::PlcLate);
    if (late || plc != PlcLink::Take::Nothing) plc_late_ = late;
}

void Machine::supervise() noexcept {
    watch_stop_circuit();
    watch_power();
    watch_interlocks();
    for (unsigned l = 0; l < kMaxChannels; ++l)
        if (channels_[l]->silent_too_long()) {
            channels_[l]->process_died(Alarm::ChannelSilent);
            partner_death(l);
        }
    for (unsigned l = 0; l < kMaxChannels; ++l)
        if (channels_[l]->sends_what_cannot_be()) {
            channels_[l]->turn_away();
            partner_death(l);
        }
    const std::int32_t message = core_.signals.plc(signals::plc_alarm());
    if (message != builder_message_) {
        builder_message_ = message;
        if (message) core_.alarm(Alarm::BuilderMessage, 0, {}, message);
    }
    const std::int32_t note = core_.signals.plc(signals::plc_note());
    if (note != builder_note_) {
        builder_note_ = note;
        if (note) core_.alarm(Alarm::BuilderNote, 0, {}, note);
    }
}

void Machine::run_channels() noexcept {
    judge_restarts();
    turn_handwheels();
    core_.some_slow = false;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        core_.some_slow = core_.some_slow || core_.is_slow(a);
    for (auto& channel : channels_) channel->supply();
    // Balance cut: both channels have requested it and both programs are running. The lower
    // override counts for both; what holds one holds both.
    struct Own {
        double feed, rapid;
    };
    std::array<Own, kMaxChannels> own;
    for (unsigned l = 0; l < kMaxChannels; ++l)
        own[l] = {channels_[l]->panel().feed_override, channels_[l]->panel().rapid_override};
    const auto stands = [&](unsigned l) {
        const ChannelState state = channels_[l]->state();
        return state == ChannelState::Held || state == ChannelState::ProgramStop ||
               state == ChannelState::Interrupted || core_.signals.plc(signals::cp_stop(l + 1)) ||
               core_.signals.nc(signals::cn_hold(l + 1)) ||
               core_.signals.nc(signals::cn_alarm(l + 1));
    };
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        const auto with = static_cast<unsigned>(core_.signals.nc(signals::cn_balance(l + 1)));
        if (with == 0 || with > kMaxChannels ||
            core_.signals.nc(signals::cn_balance(with)) != static_cast<std::int32_t>(l + 1) ||
            channels_[l]->idle() || channels_[with - 1]->idle())
            continue;
        const bool held = stands(l) || stands(with - 1);
        channels_[l]->panel().feed_override =
            held ? 0.0 : std::min(own[l].feed, own[with - 1].feed);
        channels_[l]->panel().rapid_override = held ? 0.0 : own[l].rapid;
    }
    for (auto& channel : channels_) channel->run();
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        channels_[l]->panel().feed_override = own[l].feed;
        channels_[l]->panel().rapid_override = own[l].rapid;
    }
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        Core::ProgramCall& call = core_.program_calls[l];
        if (std::exchange(call.selected, false))
            channels_[l]->init_program(
                {call.file.data(), ::strnlen(call.file.data(), call.file.size())});
        if (std::exchange(call.started, false)) channels_[l]->start_program();
    }
    for (unsigned l = 0; l < kMaxChannels; ++l) core_.waits.tell(l, channels_[l]->standing());
    const ChannelSet released = core_.waits.release(core_.no_wait());
    if (released) ++core_.meetings;
    for (unsigned l = 0; released >> l; ++l)
        if (released >> l & 1u)
            if (const auto permit = MotionGate::ask(core_, Door::WaitRelease, l + 1))
                channels_[l]->release_wait(*permit);
    for (auto& channel : channels_) channel->after_waits(runners_);
    for (auto& channel : channels_) channel->pass_waits(runners_);
    judge_restarts();
}

void Machine::run_axes() noexcept {
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        AxisUnit& axis = core_.axes[a];
        if (!axis.exists()) continue;
        const bool was_faulted = axis.faulted();
        axis.requests = {core_.signals.plc(signals::ap_opnr(a + 1)) != 0,
                         core_.signals.plc(signals::ap_efd(a + 1)) != 0,
                         core_.signals.plc(signals::ap_flwu(a + 1)) != 0,
                         core_.signals.plc(signals::ap_end(a + 1)) != 0, core_.torque_limit(a)};
        axis.requests.seeks_stop = core_.move_torque[a] != 0;
        if (core_.move_torque[a]) axis.stop_torque = core_.move_torque[a];
        // Until the command is back where the slide is, the drive presses no harder than the move
        // has allowed.
        if (const std::uint16_t most = axis.leaves_stop ? axis.stop_torque : core_.move_torque[a];
            most && (axis.requests.torque_limit == 0 || most < axis.requests.torque_limit))
            axis.requests.torque_limit = most;
        attach_and_detach(a);
        watch_drive_reference(a);
        guard_stroke(a);
        if (const std::uint32_t master = axis.config().servo.tandem_master;
            master >= 1 && master <= kMaxAxes && axis.config().servo.open)
            axis.forward(core_.axes[master - 1].output_speed());  // its own loop stays open (7.9)
        lubricated_[a] += std::fabs(axis.target() - axis.command());
        const bool lent = axis.config().on_spindle && !core_.shared_axes[a].has_drive;
        axis.exchange(core_.config.tick_s, core_.state != MachineState::Off && !lent);
        watch_absolute(a);
        if (axis.faulted() && !was_faulted) axis_fault(a);
        watch_fixed_stop(a);
        core_.signals.set_nc(signals::an_inpos(a + 1), axis.in_position());
        core_.signals.set_nc(signals::an_move(a + 1), axis.moving());
        core_.signals.set_nc(signals::an_ref(a + 1), axis.referenced);
        core_.signals.set_nc(signals::an_torq(a + 1), static_cast<std::int32_t>(axis.torque()));
        core_.signals.set_nc(signals::an_synca(a + 1), couplings_.synchronous_master(a) != 0);
    }
}

void Machine::axis_fault(std::size_t a) noexcept {
    const AxisUnit& axis = core_.axes[a];
    static constexpr Alarm kReasons[] = {
        Alarm::DriveFault,      Alarm::DriveFault, Alarm::FollowingError,
        Alarm::StandstillError, Alarm::ModelError, Alarm::DualDifference,
        Alarm::DriveLost,       Alarm::DriveNotOn, Alarm::CommandJump};
    emergency_stop(kReasons[static_cast<std::size_t>(axis.fault())], axis.config().channel,
                   name_of('A', a).view(), axis.fault_value());
}

void Machine::emergency_stop(Alarm reason, std::uint32_t channel, std::string_view detail,
                             double value) noexcept {
    core_.alarm(reason, channel, detail, value);
    for (auto& runner : channels_) runner->emergency();
    core_.all_stop = true;
    release_waits_ = on_waits_ = false;
    if (core_.state != MachineState::EmergencyStop) set_state(MachineState::EmergencyStop);
}

void Machine::stop_all(Alarm reason, double value) noexcept {
    core_.alarm(reason, 0, {}, value);
    core_.all_stop = true;
    for (auto& runner : channels_) runner->interrupt();
}

void Machine::left_alone() noexcept {
    if (!is_left_alone()) {
        alone_since_ = core_.tick;
        stop_all(Alarm::SupervisorSilent);
        release_waits_ = on_waits_ = false;
        switch_on_at_ = -1;
        return;
    }
    const double alone_s = static_cast<double>(core_.tick - alone_since_) * core_.config.tick_s;
    if (core_.tick > alone_since_ + 1 && (all_stands() || alone_s > kLeftAloneMostS))
        core_.end_run = true;
}

bool Machine::all_stands() noexcept {
    for (const auto& channel : channels_)
        if (!channel->rests()) return false;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (core_.axes[a].exists() && core_.axes[a].moving()) return false;
    for (std::uint32_t s = 0; s < core_.config.spindle_count; ++s)
        if (core_.spindles[s].exists() &&
            (core_.spindles[s].command() != 0.0 || !core_.spindles[s].standing()))
            return false;
    return true;
}

bool Machine::idle() noexcept {
    if (is_left_alone()) return false;
    commands_.drain(core_.tick);
    if (switch_on_at_ >= 0) return false;
    if (!commands_.empty() || core_.store.question_open()) return false;
    bool handshake = false, polls = false;  // the PLC may yet give what a program asks for
    for (auto& channel : channels_) {
        if (channel->in_handshake())
            handshake = true;
        else if (channel->can_go_on())
            return false;
        polls = polls || channel->polls();
    }
    for (std::uint32_t s = 0; s < core_.config.spindle_count; ++s)
        if (core_.spindles[s].exists() && !core_.spindles[s].settled()) return false;
    // What follows a turning spindle (a gear box that stays closed) moves for ever.
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        if (core_.axes[a].exists() &&
            ((core_.axes[a].moving() && !spindle_couplings_.follows(a)) ||
             (jogs_[a].active() && !(core_.axes[a].beside && jogs_[a].stands())) ||
             overlays_[a].jog.active() || core_.beside[a].asked || to_reference_[a] ||
             core_.home_request[a]))
            return false;
    const double quiet_s = static_cast<double>(plc_.quiet_ticks()) * core_.config.tick_s;
    return !plc_.present() ? !handshake || plc_.dead()
                           : quiet_s >= (handshake || polls ? kHandshakeQuietS : kPlcQuietS);
}

}  // namespace polyturn::kernel
