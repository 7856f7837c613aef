// The `code` of a Beside record: one asynchronous move, or a step of the program that
// the axis runs by itself.
//
//   Plain      axis[0] goes to end[0]; who needs it waits with an Await record
//   Begin End  around the steps of one program; how many are begun and not ended is limited
//   Room       behind each kStepsAtOnce steps of it, and as Begin before them: the path waits until
//              the axis has room for more
//   Move       like Plain, behind the steps before it
//   MoveBy     likewise; end is a travel from the axis' position when its program began
//   Dwell      feed: seconds
//   Function   mask: letter (M, S, T), value: number; handed to the PLC at the axis (AN_PAXFSTR)
#pragma once
#include <cstdint>

namespace polyturn {

enum class PositioningStep : std::int32_t {
    Plain = 0,
    Begin,
    End,
    Move,
    Dwell,
    Function,
    Room,
    MoveBy
};

inline constexpr std::uint32_t kStepsAtOnce = 1000;

// code of a RecordBegin event: the step has been handed over and begins later, with a RecordBegin
// of its own.
inline constexpr std::int32_t kStepHandedOver = -2;

// Of AxisStatus::flags: a program moves it asynchronously, or is going to. It will be where that
// program sends it.
inline constexpr std::uint32_t kPositioningOfProgram = 1u << 7;

}  // namespace polyturn
