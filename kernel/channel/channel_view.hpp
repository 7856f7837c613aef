// What the rest of the kernel may ask about a channel. Nothing here changes it.
#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

#include "kernel/channel/channel.hpp"
#include "kernel/gate/start_conditions.hpp"
#include "kernel/waits/restart_fate.hpp"

namespace polyturn::kernel {

class ChannelView {
public:
    ChannelView(Core& core, unsigned index) : c_(core, index) {}

    std::uint32_t number() const noexcept { return c_.number; }
    // Switches and keys, as they are set and as they act.
    const OperatorPanel& panel() const noexcept { return c_.panel; }

    // --- its process
    bool attached() const noexcept { return c_.process.attached(); }
    bool listens() const noexcept { return c_.process.listens(); }
    // Its process is gone and its axes rest.
    bool may_be_replaced() const noexcept {
        return !attached() || (c_.process.dead() && c_.at_rest());
    }
    bool silent_too_long() const noexcept;
    // It is believed no more.
    bool sends_what_cannot_be() const noexcept {
        return attached() && !c_.process.dead() && c_.path.inbox.refusal().field;
    }
    void wake() const noexcept { c_.core.image.channel_bell[c_.index].ring(); }

    // --- its program
    ChannelState state() const noexcept { return c_.program.state(); }
    StopReason stop_reason() const noexcept { return c_.program.reason(); }
    ChannelMode mode() const noexcept { return c_.program.mode; }
    bool idle() const noexcept { return c_.program.idle(); }
    bool program_runs() const noexcept { return c_.program.runs(); }
    bool operates() const noexcept { return c_.program.operates(); }
    bool resets() const noexcept { return c_.program.resets(); }
    bool jogs_in_hold() const noexcept { return c_.resume.aside; }
    // what runs, or is held, is no program
    bool by_hand() const noexcept { return c_.hand.run(); }
    StartView start_view() const noexcept;  // what the start conditions must know of it
    // A start would begin something, and nothing is selected or entered: of several that start
    // together it is passed over.
    bool lacks_program_or_block() const noexcept;
    // Of a member of a restart group (restart_groups.hpp): what has become of it.
    RestartFate restart_fate() const noexcept;
    // State that the wait board needs (waits.hpp): this channel's half of a rendezvous counts while
    // its program runs.
    WaitBoard::Standing standing() const noexcept;
    Dialect speaks() const noexcept { return c_.speaks(); }
    const LanguageTraits& traits() const noexcept { return c_.traits(); }
    double feed_factor() const noexcept { return c_.feed_factor(); }
    // The program has set the spindle override: the operator's rests (fagor PRGSSO).
    bool own_spindle_override() const noexcept {
        return c_.program.control & kControlOwnSpindleOverride;
    }
    std::uint32_t line() const noexcept { return c_.shown.line; }
    // block of the record that began last
    std::uint64_t serial() const noexcept { return c_.shown.serial; }

    // --- its path
    bool rests() const noexcept { return !c_.path.planner || c_.at_rest(); }
    bool path_moves() const noexcept { return c_.path.moving; }
    double path_speed() const noexcept {
        return c_.path.moving ? c_.path.step.speed : 0.0;
    }  // mm/s
    bool cuts() const noexcept { return operates() && c_.path.moving && !c_.path.rapid; }
    // Its axes move by the revolutions of this spindle (from 1).
    bool cuts_with(std::uint32_t spindle) const noexcept;
    // Rapid moves, and what follows them, keep the speed of constant surface speed as it is; one
    // under way gives it the speed of the cut that follows directly, which begins with this axis
    // there.
    bool holds_surface_speed() const noexcept;
    std::optional<double> cut_begins_at(std::uint32_t axis) const noexcept;
    // The turret turns meanwhile because this channel has commanded it before the end of its rapid
    // move.
    bool turns_in_rapid() const noexcept {
        return c_.path.rapid && c_.standing.handshake.early != kNoRecord;
    }
    // Nothing is planned ahead: it is idle, or its program waits for the answer to what is being
    // executed. What changes routes, limits or coordinates then is read by the program before it
    // goes on.
    bool stands() const noexcept;
    bool in_handshake() const noexcept { return c_.standing.phase == RecordPhase::Handshake; }
    // fanuc_lathe 6.3.4: nothing of the block is in progress but the code that the PLC has; not
    // where the program does not wait for its end.
    bool distribution_ended() const noexcept {
        return in_handshake() && !c_.standing.handshake.unfinished && c_.at_rest();
    }
    // given to the PLC last; -1 none
    std::int32_t m_code() const noexcept { return c_.standing.handshake.m_code; }

    // --- positioning axes, handwheels
    bool holds_positioning() const noexcept;
    // it moves asynchronously to the path, or its own program is not over
    bool runs_positioning(std::uint32_t axis) const noexcept;
    bool has_steps(std::uint32_t axis) const noexcept { return c_.positioning.moves(axis); }
    bool breaks_off_positioning() const noexcept;
    double handwheel_share() const noexcept { return c_.retrace.wheel.share(); }
    // it cannot go further back
    bool handwheel_blocked() const noexcept { return c_.retrace.wheel.blocked; }
    bool superposes() const noexcept { return c_.panel.superposes(); }
    // the path that is driven was planned with the handwheel superposed
    bool leaves_room() const noexcept;

    // --- for the clock
    bool can_go_on() const noexcept;  // something of it moves, counts down or waits for an answer
    // The program only asks for a value of the machine, and asks again.
    bool polls() const noexcept;

protected:
    Channel c_;
};

}  // namespace polyturn::kernel
