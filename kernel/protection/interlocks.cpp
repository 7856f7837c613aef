#include "kernel/protection/interlocks.hpp"

#include <array>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {
namespace {

using Act = Interlock::Act;

bool unclamped(const Core& c, std::uint32_t s) noexcept {
    return c.signals.plc(signals::sp_unclamped(s)) != 0;
}

// Two spindles with one part between them (part transfer): the chuck of one may be open while the
// other one's holds. A follower's jaws may turn open near the part from the beginning; a master's
// may open when its follower runs in step with it.
bool held_by_partner(const Core& c, std::uint32_t s) noexcept {
    const auto master = static_cast<std::uint32_t>(c.signals.nc(signals::sn_follow(s)));
    if (master != 0 && master <= kMaxSpindles && !unclamped(c, master)) return true;
    for (std::uint32_t f = 1; f <= c.config.spindle_count; ++f)
        if (c.signals.nc(signals::sn_follow(f)) == static_cast<std::int32_t>(s) &&
            c.signals.nc(signals::sn_synca(f)) && !unclamped(c, f))
            return true;
    return false;
}

constexpr std::array<Interlock, 7> kInterlocks{{
    {"door", Act::Hold, "the door is open", "close it",
     [](const Core& c, const InterlockView& v) { return c.door_open(v.channel); }},
    {"chuck", Act::Stop, "the chuck opened or lost its pressure while its spindle turned",
     "look at chuck and workpiece",
     [](const Core& c, const InterlockView& v) {
         return v.spindle && v.spindle_turns && unclamped(c, v.spindle) &&
                !held_by_partner(c, v.spindle);
     }},
    {"tailstock", Act::Stop, "the tailstock let go while the spindle turned",
     "look at tailstock and workpiece",
     [](const Core& c, const InterlockView& v) {
         return v.spindle_turns && c.signals.plc(signals::cp_tailopen(v.channel)) != 0;
     }},
    {"tool", Act::Stop, "the turret was unlocked while the axes moved", "bring a tool into place",
     [](const Core& c, const InterlockView& v) {
         return v.path_moves && !v.turret_may_turn &&
                c.signals.plc(signals::cp_turretopen(v.channel)) != 0;
     }},
    {"lubrication", Act::EndOfPart, "the lubrication is missing; the program ends with this part",
     "fill up its oil",
     [](const Core& c, const InterlockView& v) {
         return c.signals.plc(signals::cp_nolube(v.channel)) != 0;
     }},
    {"bar", Act::EndOfPart, "the bar is used up; the program ends with this part", "load a new bar",
     [](const Core& c, const InterlockView& v) {
         return c.signals.plc(signals::cp_barend(v.channel)) != 0;
     }},
    {"store", Act::EndOfPart, "the store is dead, nothing is kept; the program ends with this part",
     "wait until it runs again", [](const Core& c, const InterlockView&) { return c.store_dead; }},
}};
static_assert(kInterlocks.size() <= kMostInterlocks);

}  // namespace

std::span<const Interlock> interlocks() noexcept { return kInterlocks; }

// A row acts when it becomes broken, or when the program begins to run (again) while it is.
void Machine::watch_interlocks() noexcept {
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        if (!core_.config.channels[l].exists) continue;
        ChannelRunner& runner = *channels_[l];
        if (!runner.program_runs()) {
            broken_[l] = 0;
            continue;
        }
        const auto selected = core_.selected_spindle(l + 1);
        InterlockView view{l + 1, selected <= kMaxSpindles ? selected : 0, false,
                           runner.path_moves(), runner.turns_in_rapid()};
        if (view.spindle)
            view.spindle_turns = core_.spindles[view.spindle - 1].exists() &&
                                 !core_.spindles[view.spindle - 1].standing();
        for (std::size_t i = 0; i < kInterlocks.size(); ++i) {
            const Interlock& row = kInterlocks[i];
            const std::uint32_t bit = 1u << i;
            if (!row.broken(core_, view)) {
                broken_[l] &= ~bit;
                continue;
            }
            if (broken_[l] & bit) continue;
            broken_[l] |= bit;
            ShortText text;
            text << row.text << " (" << row.remedy << ")";
            switch (row.act) {
                case Act::Hold:
                    runner.safe_hold();
                    core_.alarm(Alarm::InterlockHold, l + 1, text.view(), 0, runner.line());
                    break;
                case Act::Stop:
                    runner.fault(Alarm::InterlockStop, text.view(), 0);
                    break;
                case Act::EndOfPart:
                    runner.stop_after_part(true);
                    core_.alarm(Alarm::InterlockNote, l + 1, text.view(), 0, runner.line());
                    break;
            }
        }
    }
}

// No spindle starts with an open chuck, behind an open door or in a machine that is not on,
// whatever SP_ROT says; one that turns stops when its chuck opens. In a thread or a cut the axes
// come to rest first (rotation_for). What was refused is not stored.
bool Machine::spindle_may_turn(std::uint32_t s, std::int32_t wanted) noexcept {
    const std::uint32_t owner = core_.spindles[s].owner;
    const bool open = unclamped(core_, s + 1) && !held_by_partner(core_, s + 1);
    const std::uint8_t missing = core_.spindles[s].standing()
                                     ? MotionGate::missing(core_, Door::PlcSpindle, owner)
                                     : std::uint8_t{0};
    const std::uint64_t run = owner ? channels_[owner - 1]->standing().run : 0;
    TurnRefusal& refused = turn_refused_[s];
    if (refused.code != wanted ||
        (refused.run != run && owner && channels_[owner - 1]->program_runs()))
        refused = {};
    if (refused.code) return false;
    if (!open && !missing) return true;
    refused = {wanted, run};
    // it has turned, and what has stopped it was said
    if (!open && !(missing & kDoorClosed) && wanted == rotation_[s]) return false;
    ShortText text = name_of('S', s);
    if (open)
        text << " must not turn, its chuck does not hold (clamp it)";
    else if (missing & kDoorClosed)
        text << " must not turn, the door is open (close it)";
    else
        text << " must not turn, the machine is not on (switch it on)";
    // One that is interrupted already says no second cause, and this is none of its program's.
    if (owner && channels_[owner - 1]->state() != ChannelState::Interrupted)
        channels_[owner - 1]->fault(Alarm::InterlockStop, text.view(), 0);
    else
        core_.alarm(Alarm::InterlockStop, owner, text.view());
    return false;
}

}  // namespace polyturn::kernel
