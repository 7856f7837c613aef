// The keys that start, hold and reset, alike and at the same place on every screen that has them:
// F1 to F4 are the chosen channel's, F5 to F8 those of its machine group, or of all channels where
// the machine is one group.
#pragma once
#include "hmi/widgets/screen.hpp"

namespace polyturn::hmi {

inline constexpr std::size_t kStartPlace = 0, kHoldPlace = 1, kResetPlace = 2, kSinglePlace = 3,
                             kStartAllPlace = 4, kHoldAllPlace = 5, kResetAllPlace = 6;

SoftKey startKey(Context& context);  // of the chosen channel
SoftKey holdKey(Context& context);
SoftKey resetKey(Context& context);
SoftKey singleBlockKey(Context& context);

// Of a machine group; 0: of all channels.
SoftKey startGroupKey(Context& context, unsigned group);
SoftKey holdGroupKey(Context& context, unsigned group);
SoftKey resetGroupKey(Context& context, unsigned group);
SoftKey singleBlockGroupKey(Context& context, unsigned group);

}  // namespace polyturn::hmi
