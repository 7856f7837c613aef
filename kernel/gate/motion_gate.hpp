// Motion needs a permit: every cause for which an axis can begin to move, and the conditions that
// must hold before.
//
// One row per entry, the same as in docs/design/motion-starts.md (a test compares and executes
// them). Grounds are the conditions that entries share; a condition of one entry only (a state, a
// mode, an axis that is free) is checked by its own function.
//
// Invariants
//   G1  Jogs, reference runs and superposed handwheels begin with a Permit, programs and blocks by
//       hand with a StartPermit; only ask() makes them, and a Permit is no StartPermit.
//   G2  A permit is used where it was given: it is no member of anything and outlives no tick.
//   G3  What was refused is not stored: nothing moves when the ground comes back. Doors that wait
//       for something (a return, an order of reference points, pulses of a handwheel) ask again
//       when their turn comes, and forget the request when it is refused.
//   G4  Entering a block, selecting, changing the mode, attaching, an imported parameter make no
//       permit.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::kernel {

struct Core;
struct StartView;

enum class Door : std::uint8_t {
    Start,
    GoOn,
    EnteredLine,
    LineInHold,
    HandKey,
    DialogueKey,
    ProgramStart,
    Restart,
    Retrace,
    ProgramHandwheel,
    WaitRelease,
    Jog,
    Step,
    Handwheel,
    Superpose,
    Return,
    Reference,
    ReferenceKey,
    ReferenceByProgram,
    PlcAxis,
    Positioning,
    FollowUp,
    StopRelease,
    GearRetract,
    WorkRetract,
    PlcSpindle,
};

enum Ground : std::uint8_t {
    kMachineOn = 1u << 0,   // drives on, no emergency stop
    kNoStop = 1u << 1,      // nothing stops the whole machine (PLC late, power failure, a dead
                            // process)
    kDoorClosed = 1u << 2,  // or setup mode
    kStartRows = 1u << 3,   // all rows of start_conditions.cpp, which contain the three above
};

struct MotionStart {
    Door door;
    std::string_view name;      // of the row in the document
    std::string_view asked_by;  // key, word of `press`, signal or record
    std::string_view begins;    // function that sets the first axis moving
    std::uint8_t grounds;
    std::optional<Alarm> refusal;  // none: nobody asked for it; nothing is reported or stored
};

inline constexpr std::uint8_t kSafe = kMachineOn | kNoStop | kDoorClosed,
                              kDriven = kMachineOn | kNoStop;
inline constexpr auto kMotionStarts = std::to_array<MotionStart>({
    {Door::Start, "start", "cycle_start in reset or at the end, automatic", "begin_program",
     kStartRows, Alarm::NotReady},
    {Door::GoOn, "start in a hold or at a stop", "cycle_start held, at M0 M1, in single block",
     "ChannelRunner::cycle_start", kStartRows, Alarm::NotReady},
    {Door::EnteredLine, "entered block", "cycle_start in MDI", "begin_line", kStartRows,
     Alarm::NotReady},
    {Door::LineInHold, "entered block in a hold", "cycle_start held, a block waits",
     "enter_by_hand", kStartRows, Alarm::NotReady},
    {Door::HandKey, "key that is a start", "hand_key: tool, part transfer step, spindle, menu",
     "ChannelRunner::hand_key", kStartRows, Alarm::NotReady},
    {Door::DialogueKey, "key of a dialogue", "answer key=N", "ChannelRunner::dialogue_key",
     kStartRows, Alarm::NotReady},
    {Door::ProgramStart, "START of a program", "record ProgramCall of a running program",
     "ChannelRunner::start_program", kStartRows, Alarm::NotReady},
    {Door::Restart, "restart at a block", "restart, then cycle_start", "ChannelRunner::restart",
     kStartRows, Alarm::NotReady},
    {Door::Retrace, "path backwards", "retrace on, then cycle_start", "start_retrace", kStartRows,
     Alarm::NotReady},
    {Door::ProgramHandwheel, "handwheel as the time", "program_wheel on, then handwheel L",
     "drive_path", kDriven, Alarm::NotReady},
    {Door::WaitRelease, "wait that opens", "the partner's arrival, ignore_waits",
     "ChannelRunner::release_wait", 0, Alarm::WaitPartnerAbsent},
    {Door::Jog, "jog key", "jog, while it is held", "Machine::start_jog", kSafe, Alarm::NotReady},
    {Door::Step, "step key", "step", "Machine::start_jog", kSafe, Alarm::NotReady},
    {Door::Handwheel, "handwheel", "handwheel A", "Machine::start_jog", kSafe, Alarm::NotReady},
    {Door::Superpose, "superposed handwheel", "superpose on, then handwheel A",
     "Machine::run_overlays", kSafe, Alarm::NotReady},
    {Door::Return, "return", "return", "Machine::go_back", kSafe, Alarm::NotReady},
    {Door::Reference, "reference", "reference", "Homing::start", kSafe, Alarm::ReferenceRefused},
    {Door::ReferenceKey, "jog key in reference mode", "jog in mode reference", "Homing::start",
     kSafe, Alarm::ReferenceRefused},
    {Door::ReferenceByProgram, "reference of a program", "record Home of a running program",
     "Homing::start", kDriven, std::nullopt},
    {Door::PlcAxis, "PLC axis", "AP_PAXR", "Machine::start_positioning_axis", kDriven,
     Alarm::PositioningRefused},
    {Door::Positioning, "positioning axis", "record PositioningAxis of a running program",
     "Machine::start_positioning_axis", kDriven, Alarm::PositioningRefused},
    {Door::FollowUp, "end of following up", "the loop closes with AP_FLWU or N0514 #5",
     "Machine::start_jog", kDriven, std::nullopt},
    {Door::StopRelease, "release of a fixed stop", "the torque limit goes", "Machine::start_jog",
     kDriven, std::nullopt},
    {Door::GearRetract, "retract of the gear box", "CP_EGBRRQ, a reset with N1800 RCE",
     "Machine::run_gear_retracts", kDriven, std::nullopt},
    {Door::WorkRetract, "retract from the work", "PLC_POWER, death of a partner",
     "Machine::run_retracts", kDriven, std::nullopt},
    {Door::PlcSpindle, "spindle", "SP_ROT, S and M of a program", "Machine::spindle_may_turn",
     kSafe, Alarm::InterlockStop},
});
constexpr const MotionStart& row_of(Door door) noexcept {
    return kMotionStarts[static_cast<std::size_t>(door)];
}
constexpr bool in_order() noexcept {
    for (std::size_t i = 0; i < kMotionStarts.size(); ++i)
        if (static_cast<std::size_t>(kMotionStarts[i].door) != i) return false;
    return kMotionStarts.size() == static_cast<std::size_t>(Door::PlcSpindle) + 1;
}
static_assert(in_order(), "each door has its row");

// Who has none cannot begin. It cannot be made, only be given. Start: of a door with kStartRows.
template <bool Start>
class PermitOf {
    friend class MotionGate;
    explicit constexpr PermitOf(Door door) noexcept : door_(door) {}
    Door door_;

public:
    Door door() const noexcept { return door_; }
};
using Permit = PermitOf<false>;
using StartPermit = PermitOf<true>;

class MotionGate {
public:
    // What is missing of the grounds of a door: 0 nothing. `channel` from 1: whose door counts; 0
    // nobody's. Of a start kStartRows always: its rows are not known by a channel's number alone.
    [[nodiscard]] static std::uint8_t missing(const Core& core, Door door,
                                              std::uint32_t channel) noexcept;
    [[nodiscard]] static std::optional<Permit> ask(const Core& core, Door door,
                                                   std::uint32_t channel) noexcept;
    // A start: all rows of start_conditions.cpp. Any other door stays shut.
    [[nodiscard]] static std::optional<StartPermit> ask(const Core& core, Door door,
                                                        const StartView& view) noexcept;
};

}  // namespace polyturn::kernel
