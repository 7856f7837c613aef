// Interrupt inputs of a channel beside those of InterruptBit, and flags that a program sets in path
// order.
#pragma once
#include <cstdint>

namespace polyturn {

// The value of an Interrupts record is the whole number whose bit n - 1 watches input n; 0: UINT or
// MINT as the mask says. Inputs 1 to 4 are the signals INT1 to INT4; with kInterruptByWires in the
// mask input n is the program's input n as well (#999 + n, $A_IN[n]): a wire of the machine or a
// bit of CP_UIN. The number of the input that came is in the event's record above bit 0.
inline constexpr unsigned kInterruptInputs = 32;
inline constexpr std::uint32_t kInterruptByWires = 1u << 3;

// In the record of an Interrupt event: the signal has come while a block runs that is driven to its
// end first; value: the first block behind it. The channel runs the macro statements of its
// interrupt program until there, answers as to a question, and is notified again of the path's
// position. What they bring about carries kAtOnce and is executed as soon as it is seen.
inline constexpr std::uint64_t kInterruptAhead = 1u << 16;
inline constexpr std::uint32_t kAtOnce = 1u << 23;  // flag of a record

// code of a Flag record: what in the channel takes its value.
inline constexpr std::int32_t kFlagTapping = 1;  // signal TAPPING
inline constexpr std::int32_t kFlagControl = 2;  // #3003, #3004: bits of ProgramControl
// G22 (1), G23 (0): stroke range 2 counts in this channel
inline constexpr std::int32_t kFlagStroke2 = 3;
inline constexpr std::int32_t kFlagOutputs = 4;      // register CN_UOUT: #1100 to #1131, bit by bit
inline constexpr std::int32_t kFlagOutputsWide = 5;  // register CN_UOUTW: #1133 as a whole number

// What a program has taken out of the operator's hands (fanuc_lathe 6.3.4; fagor_8037t part 2,
// 12.3). NoPlcStop: CP_STOP waits too. GroupEnds: blocks that single block took as one end here, so
// it stops here. Polls: it asks the machine for the same value again and again and does nothing in
// between.
enum ProgramControl : std::uint32_t {
    kControlNoSingleBlock = 1,
    kControlNoFinish = 2,
    kControlNoHold = 4,
    kControlNoPlcStop = 8,
    kControlGroupEnds = 16,
    kControlOwnSpindleOverride = 32,
    kControlPolls = 64
};

}  // namespace polyturn
