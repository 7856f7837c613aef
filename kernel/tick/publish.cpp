// What the machine shows at the end of a tick: status, watched signals, trace.
#include <bit>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {

// A change is put down to the M code that is being executed: in the channel of the object where
// there is one, else in whichever.
void Machine::note_coupling(CoupledSince& kept, std::uint32_t master, std::uint32_t added,
                            std::uint32_t route, std::uint32_t owner) noexcept {
    if (kept.master == master && kept.added == added && kept.route == route) return;
    kept = {master, added, route, core_.tick, -1, 0};
    const auto runs = [&](std::uint32_t channel) {
        return channel >= 1 && channels_[channel - 1]->attached() &&
               channels_[channel - 1]->in_handshake() && channels_[channel - 1]->m_code() >= 0;
    };
    std::uint32_t by = runs(owner)                    ? owner
                       : runs(core_.newest_m.channel) ? core_.newest_m.channel
                                                      : 0;
    for (std::uint32_t l = 1; !by && l <= kMaxChannels; ++l)
        if (runs(l)) by = l;
    if (by) {
        kept.code = channels_[by - 1]->m_code();
        kept.channel = by;
    }
}

void Machine::publish() noexcept {
    // The draft is two pictures old; everything that exists is written anew, the rest stays zero.
    MachineStatus& status = core_.image.status.draft();
    status.tick = core_.tick;
    status.machine_state = static_cast<std::uint32_t>(core_.state);
    status.step = static_cast<std::uint32_t>(step_);
    status.alarm_count = core_.alarm_count;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a) {
        const AxisUnit& axis = core_.axes[a];
        if (!axis.exists()) continue;
        AxisStatus& out = status.axes[a];
        out.cmd = axis.command();
        out.act = axis.measured();
        out.own = axis.own();
        out.master = couplings_.synchronous_master(a);
        out.added_master = couplings_.superimposed_master(a);
        const auto route = static_cast<std::uint32_t>(couplings_.route(a));
        note_coupling(axis_coupled_[a], out.master, out.added_master, route == a + 1 ? 0 : route,
                      core_.config.axes[a].channel);
        out.since = axis_coupled_[a].since;
        out.since_code = axis_coupled_[a].code;
        out.since_channel = axis_coupled_[a].channel;
        out.velocity = axis.velocity();
        out.error = axis.error();
        out.compensation = axis.compensation();
        out.overlay = axis.overlay();
        out.torque = axis.torque();
        out.owner = axis.owner;
        out.skip = axis.skip;
        const std::uint32_t channel = core_.config.axes[a].channel;
        const bool by_program = core_.beside[a].asked ||
                                (positioning_axes_[a].asked && positioning_axes_[a].channel) ||
                                core_.positioning_turn[a].channel != 0 ||
                                (channel >= 1 && channels_[channel - 1]->has_steps(a));
        out.flags = kExists | (by_program ? kPositioningOfProgram : 0u) |
                    (axis.referenced ? kReferenced : 0u) | (axis.in_position() ? kInPos : 0u) |
                    (axis.moving() ? kMoving : 0u) | (axis.faulted() ? kDriveFault : 0u) |
                    (axis.config().rotary ? kRotary : 0u) |
                    (axis.config().diameter ? kDiameter : 0u);
    }
    for (std::uint32_t s = 0; s < core_.config.spindle_count; ++s) {
        const SpindleUnit& spindle = core_.spindles[s];
        if (!spindle.exists()) continue;
        SpindleStatus& out = status.spindles[s];
        out.command = spindle.command();
        out.speed = spindle.shown_speed();
        out.angle = spindle.angle();
        out.override = spindle.override_factor;
        out.owner = spindle.owner;
        const auto follower = static_cast<std::uint32_t>(kMaxAxes) + s;
        out.master = spindle_couplings_.master_of(follower);
        out.deviation = spindle_couplings_.deviation(follower);
        note_coupling(spindle_coupled_[s], out.master, 0, 0, spindle.owner);
        out.since = spindle_coupled_[s].since;
        out.since_code = spindle_coupled_[s].code;
        out.since_channel = spindle_coupled_[s].channel;
        out.flags = (spindle.reached() ? 1u : 0u) | (spindle.standing() ? 2u : 0u) |
                    (spindle.mode() == SpindleUnit::Mode::SurfaceSpeed ? 4u : 0u);
    }
    for (unsigned l = 0; l < kMaxChannels; ++l)
        if (core_.config.channels[l].exists || channels_[l]->attached()) {
            channels_[l]->publish(status.channels[l]);
            status.channels[l].touched = setters_[l].touched;
            status.channels[l].touched_at = setters_[l].at;
        }
    for (std::size_t a = 0; a < kMaxAxes; ++a)
        status.route[a] = static_cast<std::uint8_t>(couplings_.route(a));
    scope_.sample(core_, status);
    core_.image.status.publish();
    // P1: the status, and log and trace of the ticks before
    core_.image.tick.store(static_cast<std::uint64_t>(core_.tick), std::memory_order_release);
}

double Machine::watched_value(const Watch& watch) const noexcept {
    const auto word = [&](std::uint32_t slot) {
        return watch.plc ? core_.signals.plc(slot) : core_.signals.nc(slot);
    };
    if (!watch.is_double) return word(watch.slot);
    const auto low = static_cast<std::uint32_t>(word(watch.slot)),
               high = static_cast<std::uint32_t>(word(watch.slot + 1));
    return std::bit_cast<double>(std::uint64_t{high} << 32 | low);
}

// The builder's free parameters (N1200 to N1272) are signals for the PLC: N_P00, N_PDW1, N_PDB1 ...
void Machine::show_free_parameters() noexcept {
    const params::Table& table = core_.table;
    for (unsigned byte = 0; byte < 8; ++byte)
        for (unsigned bit = 0; bit < 8; ++bit)
            core_.signals.set_nc(
                signals::n_p00() + byte * 8 + bit,
                params::bit(table, params::nth(params::n1200_plc_bits0, byte + 1), bit));
    for (unsigned i = 0; i < 32; ++i) {
        core_.signals.set_nc(signals::n_pdw1() + i,
                             static_cast<std::int32_t>(
                                 params::get(table, params::nth(params::n1209_plc_dword1, i + 1))));
        const auto bits = std::bit_cast<std::uint64_t>(
            params::get(table, params::nth(params::n1241_plc_double1, i + 1)));
        core_.signals.set_nc(signals::n_pdb1() + 2 * i,
                             static_cast<std::int32_t>(static_cast<std::uint32_t>(bits)));
        core_.signals.set_nc(signals::n_pdb1() + 2 * i + 1,
                             static_cast<std::int32_t>(static_cast<std::uint32_t>(bits >> 32)));
    }
}

void Machine::watch_signals() noexcept {
    for (std::size_t i = 0; i < watch_count_; ++i) {
        Watch& watch = watches_[i];
        const double now = watched_value(watch);
        if (now == watch.last) continue;
        watch.last = now;
        core_.event(KernelEventKind::Signal, 0, static_cast<std::int32_t>(watch.slot), now,
                    watch.plc ? 1u : 0u);
    }
}

// A sample shows command and measurement of the same moment. What the drives measured at the end of
// a tick is known at the end of the next one, so a sample waits for one tick.
void Machine::trace() noexcept {
    const std::uint32_t every = core_.supervisor.options.trace_every;
    if (every == 0) return;
    if (trace_pending_) {
        for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
            pending_trace_.act[a] = core_.axes[a].measured();
        if (!trace_ring_.push(pending_trace_)) ++trace_dropped_;
        trace_pending_ = false;
    }
    if ((core_.tick + 1) % every != 0) return;
    pending_trace_.tick = core_.tick + 1;
    for (std::uint32_t a = 0; a < core_.config.axis_count; ++a)
        pending_trace_.cmd[a] = core_.axes[a].command();
    for (std::uint32_t s = 0; s < core_.config.spindle_count; ++s) {
        pending_trace_.speed[s] = core_.spindles[s].true_speed();
        pending_trace_.angle[s] = core_.spindles[s].true_angle();
    }
    for (unsigned l = 0; l < kMaxChannels; ++l)
        pending_trace_.state[l] = static_cast<std::uint8_t>(channels_[l]->state());
    trace_pending_ = true;
}

}  // namespace polyturn::kernel
