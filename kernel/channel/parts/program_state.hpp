// In which state a channel's program is, and for which reasons its path brakes.
//
//             start (permit)          M30, M02, the last part
//   Absent -> Reset ---------------> Running ---------------> Ended -- (a start: as from Reset)
//   attach      ^                      |  ^ '--arrives--> Waiting --release--> Running
//               |                      |  '---- start (permit) ---- Held, ProgramStop(reason)
//               |                      '--hold, stop record, single block, group end--^
//               '---- reset, path at rest ---- any state with a program, Interrupted(Alarm)
//   Dead: at once when its process dies, from any state; a successor attaches in Reset.
//
// Several reasons to brake may be set at once. When the path rests, settle_program() takes
// them in this order: Reset, an interrupt program, the question of a hold, death, Alarm, Hold,
// single block and GroupEnd.
//
// Invariants
//   S1  State and stop reason are written by enter() and nowhere else.
//   S2  An alarm ends with a reset, or with a successor of its process.
#pragma once
#include <cstdint>

#include "polyturn/image_structs.hpp"

namespace polyturn::kernel {

// Why the path comes to rest. GroupEnd: kControlNoSingleBlock has ended in single block.
enum class Brake : std::uint8_t {
    Hold = 1u << 0,
    Reset = 1u << 1,
    Alarm = 1u << 2,
    Emergency = 1u << 3,  // as hard as its axes can
    GroupEnd = 1u << 4,
};

class BrakeReasons {
public:
    constexpr bool has(Brake why) const noexcept { return (set_ & bit(why)) != 0; }
    template <class... Why>
    constexpr bool any_of(Why... why) const noexcept {
        return (set_ & (bit(why) | ...)) != 0;
    }
    template <class... Why>
    constexpr void add(Why... why) noexcept {
        set_ |= (bit(why) | ...);
    }
    template <class... Why>
    constexpr void remove(Why... why) noexcept {
        set_ &= ~(bit(why) | ...);
    }

private:
    static constexpr std::uint32_t bit(Brake why) noexcept {
        return static_cast<std::uint32_t>(why);
    }
    std::uint32_t set_ = 0;
};

class ProgramState {
public:
    ChannelMode mode = ChannelMode::Auto;
    BrakeReasons brakes;
    bool hold_put_off = false;  // pressed while the program suppresses it (kControlNoHold)
    bool alarm = false;         // the first one is the cause
    std::uint32_t control = 0;  // ProgramControl: what the program puts off
    std::uint64_t run = 0;      // grows with each start and each reset
    std::int32_t reset_count = 0;
    // its process died while a program ran: that has not come to its end, whatever a successor is
    bool cut_off = false;

    ChannelState state() const noexcept { return state_; }
    StopReason reason() const noexcept { return reason_; }
    // With the reason as it was.
    void enter(ChannelState state) noexcept { state_ = state; }
    void enter(ChannelState state, StopReason reason) noexcept {
        state_ = state;
        reason_ = reason;
    }
    void no_reason() noexcept { reason_ = StopReason::None; }

    void brake_for(Brake why) noexcept { brakes.add(why); }
    void release(Brake why) noexcept { brakes.remove(why); }
    bool holds() const noexcept { return brakes.has(Brake::Hold); }
    bool resets() const noexcept { return brakes.has(Brake::Reset); }
    bool interrupted() const noexcept { return brakes.has(Brake::Alarm); }
    bool emergency() const noexcept { return brakes.has(Brake::Emergency); }
    bool group_ends() const noexcept { return brakes.has(Brake::GroupEnd); }
    bool take_group_end() noexcept {
        const bool ended = group_ends();
        brakes.remove(Brake::GroupEnd);
        return ended;
    }

    bool is(ChannelState state) const noexcept { return state_ == state; }
    bool stopped_by(StopReason reason) const noexcept {
        return state_ == ChannelState::ProgramStop && reason_ == reason;
    }
    // It executes its program, or waits within it.
    bool drives() const noexcept {
        return state_ == ChannelState::Running || state_ == ChannelState::Waiting;
    }
    bool operates() const noexcept { return mode == ChannelMode::Auto && drives(); }
    // A program of it runs, or stands within.
    bool runs() const noexcept {
        return drives() || state_ == ChannelState::Held || state_ == ChannelState::ProgramStop;
    }
    bool idle() const noexcept {  // no program of it runs
        return state_ == ChannelState::Reset || state_ == ChannelState::Ended ||
               state_ == ChannelState::Dead || state_ == ChannelState::Absent;
    }
    // A start begins a program.
    bool begins() const noexcept {
        return state_ == ChannelState::Reset || state_ == ChannelState::Ended;
    }
    // fanuc_lathe 6.3.3: the lamp is out from feed hold and in a single block stop, and lit while
    // tools and pallets are changed.
    bool start_lamp() const noexcept { return drives() && !holds(); }

private:
    ChannelState state_ = ChannelState::Absent;
    StopReason reason_ = StopReason::None;
};

}  // namespace polyturn::kernel
