// What each command does, at the start of its tick.
#include <algorithm>

#include "ipc/requests/command_levels.hpp"
#include "kernel/tick/command_check.hpp"
#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {
namespace {
std::string_view text_of(const Command& c) noexcept {
    return {c.text.data(), ::strnlen(c.text.data(), c.text.size())};
}

// Means one channel's program: without a process it would do nothing, and say nothing. Switches and
// overrides are kept without one.
constexpr bool needs_process(CommandKind kind) noexcept {
    switch (kind) {
        case CommandKind::CycleStart:
        case CommandKind::Mode:
        case CommandKind::Mdi:
        case CommandKind::MdiClear:
        case CommandKind::HandKey:
        case CommandKind::Retrace:
        case CommandKind::JogInHold:
        case CommandKind::StopAfterPart:
        case CommandKind::WarmUp:
        case CommandKind::Superpose:
        case CommandKind::DialogueValue:
        case CommandKind::DialogueKey:
            return true;
        default:
            return false;
    }
}
}  // namespace

template <class Act>
void Machine::each_channel(const Command& command, Act act) noexcept {
    for (unsigned l = 0; l < kMaxChannels; ++l)
        if (channels_[l]->attached() && (command.channel == 0 || command.channel == l + 1))
            act(*channels_[l]);
}

// A channel that is named is started, or reports why it cannot start. Of several (all, or a machine
// group) those that have something to execute start in this tick; the others are skipped without a
// message. If none can start, one channel reports what it lacks: the one that is in MDI, else the
// first.
void Machine::start_channels(const Command& command) noexcept {
    if (command.channel != 0)
        return each_channel(
            command, [&](ChannelRunner& r) { r.cycle_start((command.flags & kStartByHand) != 0); });
    bool any = false;
    ChannelRunner* lacks = nullptr;
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        ChannelRunner& runner = *channels_[l];
        if (!runner.attached() ||
            (command.object != 0 && core_.config.channels[l].group != command.object))
            continue;
        if (runner.lacks_program_or_block()) {
            if (!lacks || (runner.mode() == ChannelMode::Mdi && lacks->mode() != ChannelMode::Mdi))
                lacks = &runner;
            continue;
        }
        any = true;
        runner.cycle_start();
    }
    if (!any && lacks)
        lacks->cycle_start();  // refused, with its own words
    else if (!any)
        core_.alarm(Alarm::NotReady, 0, "no program is selected");
}

void Machine::take_commands() noexcept {
    if (is_left_alone()) return;
    commands_.drain(core_.tick);
    while (const Command* command = commands_.next_due(core_.tick)) {
        const Command due = *command;  // an action may bring further commands into the queue
        if (const char* const field = fault_of(due)) {
            ShortText text("a command of the supervisor: ");
            text << field;
            core_.alarm(Alarm::RequestBad, 0, text.view());
            continue;
        }
        // The supervisor has asked already; the kernel does not rely on it and asks again. Level 0:
        // the
        // machine's own.
        if (due.level != 0 && due.level - 1 < static_cast<std::uint32_t>(level_of(due))) {
            core_.alarm(Alarm::LevelTooLow, due.channel, level_words(due));
            continue;
        }
        core_.store.set_asker(due.level ? due.level - 1 : 0, due.user);
        run_command(due);
        core_.store.set_asker(0, 0);
        plc_.touched();  // it may have changed what the PLC will see
    }
}

void Machine::run_command(const Command& c) noexcept {
    const bool on = c.value != 0.0;
    // of a channel without a process too: its axes are moved by hand
    const auto key = [&](std::uint32_t bits) {
        for (unsigned l = 0; l < kMaxChannels; ++l)
            if (c.channel == 0 || c.channel == l + 1)
                channels_[l]->panel().pressed = on ? channels_[l]->panel().pressed | bits
                                                   : channels_[l]->panel().pressed & ~bits;
    };
    if (c.channel != 0 && needs_process(static_cast<CommandKind>(c.kind)) &&
        !channels_[c.channel - 1]->attached()) {
        core_.alarm(Alarm::NotReady, c.channel, "the channel's process is not there");
        return;
    }
    switch (static_cast<CommandKind>(c.kind)) {
        case CommandKind::CycleStart:
            judge_restarts();  // a reset of this very tick ends a restart before a start of it
            start_channels(c);
            break;
        case CommandKind::FeedHold:
            each_channel(c, [](ChannelRunner& r) { r.feed_hold(); });
            break;
        case CommandKind::Reset:
            each_channel(c, [](ChannelRunner& r) { r.reset(); });
            reset_couplings(c.channel);
            // positioning axes end with their own channel (by_hand/positioning_axis.cpp)
            for (std::uint32_t a = 0; a < kMaxAxes; ++a)
                if (!positioning_axes_[a].asked || positioning_axes_[a].channel == 0)
                    jogs_[a].stop();
            for (Overlay& overlay : overlays_) {
                overlay.left = 0;
                overlay.jog.stop();
            }
            handwheel_left_.fill(0.0);
            stop_homing();
            reset_machine();
            break;
        case CommandKind::EmergencyStop:
            emergency_stop(Alarm::EmergencyStop, 0, {}, 0);
            break;
        case CommandKind::MachineOn:
            press_machine_on();
            break;
        case CommandKind::ReleaseStop:
            release_stop();
            break;
        case CommandKind::RapidKey:
            key(kKeyRapid);
            break;
        case CommandKind::Superpose:
            each_channel(c, [&](ChannelRunner& r) { r.superpose(on); });
            break;
        case CommandKind::Scope:
            scope_.choose(core_.image, c.flags,
                          static_cast<ScopeKind>(static_cast<std::uint32_t>(c.value)), c.object);
            break;
        case CommandKind::WarmUp:
            each_channel(c, [&](ChannelRunner& r) { r.warm_up(c.value); });
            break;
        case CommandKind::Mode:
            each_channel(c, [&](ChannelRunner& r) {
                r.set_mode(static_cast<ChannelMode>(static_cast<std::uint32_t>(c.value)),
                           (c.flags & kStartByHand) != 0);
            });
            break;
        case CommandKind::Select:
            each_channel(c, [&](ChannelRunner& r) { r.select(text_of(c), c.value); });
            break;
        case CommandKind::Mdi:
            each_channel(c, [&](ChannelRunner& r) { r.enter(text_of(c)); });
            break;
        case CommandKind::MdiClear:
            each_channel(c, [](ChannelRunner& r) { r.clear_entered(); });
            break;
        case CommandKind::HandKey:
            each_channel(c, [&](ChannelRunner& r) { r.hand_key(text_of(c)); });
            break;
        case CommandKind::FeedOverride:
            each_channel(c, [&](ChannelRunner& r) {
                r.panel().feed_override = std::clamp(c.value, 0.0, 2.0);
            });
            break;
        case CommandKind::RapidOverride:
            each_channel(c, [&](ChannelRunner& r) {
                r.panel().rapid_override = std::clamp(c.value, 0.0, 1.0);
            });
            break;
        case CommandKind::SpindleOverride:
            for (std::uint32_t s = 0; s < kMaxSpindles; ++s)
                if (c.object == 0 || c.object == s + 1)
                    core_.spindles[s].override_factor = std::clamp(c.value, 0.0, 2.0);
            break;
        case CommandKind::SingleBlock:
            key(kKeySingleBlock);
            break;
        case CommandKind::OptionalStop:
            key(kKeyOptionalStop);
            break;
        case CommandKind::DryRun:
            key(kKeyDryRun);
            break;
        case CommandKind::MachineLock:
            key(kKeyMachineLock);
            break;
        case CommandKind::BlockSkip:
            key(c.flags ? kKeyBlockSkip1 << (std::min<std::uint32_t>(c.flags, 10) - 1)
                        : 0x3FFu * kKeyBlockSkip1);
            break;
        case CommandKind::IgnoreWaits:
            for (std::uint32_t l = 1; l <= kMaxChannels; ++l)
                if (c.channel == 0 || c.channel == l) {
                    if (on)
                        core_.signals.force_plc(signals::cp_nowt(l), 1);
                    else
                        core_.signals.release_plc(signals::cp_nowt(l));
                }
            break;
        case CommandKind::SetSignal:
            if (c.flags && c.object < kPlcSignals && c.channel >= 1 && c.channel <= 32) {
                const std::uint32_t bit = 1u << (c.channel - 1),
                                    now = static_cast<std::uint32_t>(core_.signals.plc(c.object));
                core_.signals.force_plc(c.object,
                                        static_cast<std::int32_t>(on ? now | bit : now & ~bit));
            } else if (c.flags && c.object < kPlcSignals)
                core_.signals.force_plc(c.object, static_cast<std::int32_t>(c.value));
            else if (!c.flags && c.object < kNcSignals)
                core_.signals.force_nc(c.object, static_cast<std::int32_t>(c.value));
            break;
        case CommandKind::ReleaseSignal:
            if (c.flags && c.object < kPlcSignals)
                core_.signals.release_plc(c.object);
            else if (!c.flags && c.object < kNcSignals)
                core_.signals.release_nc(c.object);
            break;
        case CommandKind::SetInput:
            if (c.object >= kInputs) break;
            if (c.flags)
                core_.signals.release_input(c.object);
            else
                core_.signals.set_input(c.object, on);
            break;
        case CommandKind::Sensor:
            if (c.object >= 1 && c.object <= kMaxAxes + kMaxSpindles && c.flags < kInputs)
                core_.sensors.add({c.object - 1, c.flags,
                                   c.channel == 1   ? 1
                                   : c.channel == 2 ? -1
                                                    : 0,
                                   c.value});
            break;
        case CommandKind::DriveFault:
            if (!c.flags && c.object >= 1 && c.object <= kMaxAxes)
                core_.axes[c.object - 1].simulate = static_cast<std::uint16_t>(c.value);
            if (c.flags && c.object >= 1 && c.object <= kMaxSpindles)
                core_.spindles[c.object - 1].simulate = static_cast<std::uint16_t>(c.value);
            break;
        case CommandKind::SetParameter:
            if (!core_.store.ask_parameter(text_of(c), core_.tick, core_.config.answer_ticks))
                core_.alarm(Alarm::StoreWrite, c.channel, text_of(c));
            break;
        case CommandKind::Watch:
            if (watch_count_ < watches_.size() &&
                c.object < (c.flags & kSlotOfPlc ? kPlcSignals : kNcSignals)) {
                Watch& watch = watches_[watch_count_++];
                watch = {(c.flags & kSlotOfPlc) != 0, (c.flags & kSlotOfDouble) != 0, c.object,
                         0.0};
                watch.last = watched_value(watch);
            }
            break;
        case CommandKind::Jog:
        case CommandKind::Step:
        case CommandKind::Handwheel:
            jog_command(c);
            break;
        case CommandKind::Reference:
            reference_command(c);
            break;
        case CommandKind::Restart:
            for (std::uint32_t l = 1; l <= kMaxChannels; ++l)
                if (c.channel == 0 || c.channel == l) restart_channel(c, l);
            break;
        case CommandKind::Retrace:
            each_channel(c, [&](ChannelRunner& r) { r.retrace(on); });
            break;
        case CommandKind::DialogueValue:
            each_channel(c, [&](ChannelRunner& r) { r.dialogue_value(c.value, text_of(c)); });
            break;
        case CommandKind::DialogueKey:
            each_channel(c, [&](ChannelRunner& r) { r.dialogue_key(c.value); });
            break;
        case CommandKind::FirstPart:
            key(kKeyFirstPart);
            break;
        case CommandKind::ProgramHandwheel:
            program_wheel(c.channel, on);
            break;
        case CommandKind::StoreValue:
            if (!core_.store.ask_value(static_cast<StoreRequestKind>(c.object), c.channel,
                                       static_cast<std::int32_t>(c.flags >> 16),
                                       static_cast<std::int32_t>(c.flags & 0xFFFFu), c.value,
                                       text_of(c), core_.tick, core_.config.answer_ticks))
                core_.alarm(Alarm::StoreWrite, c.channel,
                            "the store has not yet taken what was written before");
            break;
        case CommandKind::JogInHold:
            each_channel(c, [&](ChannelRunner& r) {
                if (!r.allow_jog_in_hold())
                    core_.alarm(Alarm::NotReady, c.channel,
                                "axes are moved in a hold when the path has come to rest in it");
            });
            break;
        case CommandKind::Return:
            begin_return(c.channel);
            break;
        case CommandKind::StopAfterPart:
            each_channel(c, [&](ChannelRunner& r) { r.stop_after_part(on); });
            break;
        case CommandKind::Action:
            core_.event(KernelEventKind::ActionDue, c.channel, static_cast<std::int32_t>(c.seq),
                        c.value, c.object, text_of(c));
            // What it brings about (the death of a process) belongs to this very tick.
            if (on_action) {
                on_action(on_action_context);
                commands_.drain(core_.tick);
            }
            break;
        case CommandKind::ProcessDied:
            process_died(c.object);
            break;
        case CommandKind::ProcessStopped:
            process_stopped(c.object, true);
            break;
        case CommandKind::ProcessContinued:
            process_stopped(c.object, false);
            break;
        case CommandKind::EndRun:
            for (auto& channel : channels_) channel->quit();
            core_.end_run = true;
            break;
        default:
            break;  // refused by the supervisor, which knows what is built
    }
}

// Reset clears what stopped the whole machine, but not an emergency stop, and not a PLC that is
// still dead.
void Machine::reset_machine() noexcept {
    for (SpindleUnit& spindle : core_.spindles) spindle.clear_fault();
    if (core_.state != MachineState::EmergencyStop && !plc_.dead() && !plc_late_)
        core_.all_stop = false;
}

void Machine::partner_death(unsigned index) noexcept {
    const ChannelConfig& dead = core_.config.channels[index];
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        if (core_.config.channels[l].group != dead.group) continue;
        if (dead.partner_death == PartnerDeath::Retract) retract_work(l + 1);
        if (l == index) continue;
        if (dead.partner_death == PartnerDeath::Hold) channels_[l]->safe_hold();
        if (dead.partner_death == PartnerDeath::Reset) channels_[l]->reset();
    }
}

void Machine::process_died(std::uint32_t slot) noexcept {
    if (slot >= kProcessChannel && slot < kProcesses) {
        const unsigned index = slot - static_cast<unsigned>(kProcessChannel);
        if (!channels_[index]->attached() || channels_[index]->state() == ChannelState::Dead)
            return;
        channels_[index]->process_died(Alarm::ChannelDied);
        partner_death(index);
    } else if (slot == kProcessPlc && !plc_.dead()) {
        plc_.died();
        stop_all(Alarm::PlcDied);
    } else if (slot == kProcessStore && !core_.store_dead) {
        core_.store_dead = true;
        core_.alarm(Alarm::StoreDied, 0);
    }
}

void Machine::process_stopped(std::uint32_t slot, bool stopped) noexcept {
    if (slot >= kProcessChannel && slot < kProcesses)
        channels_[slot - kProcessChannel]->process_stopped(stopped);
    else if (slot == kProcessPlc)
        plc_.stopped(stopped);
    else if (slot == kProcessStore)
        core_.store_dead = stopped;
}

}  // namespace polyturn::kernel
