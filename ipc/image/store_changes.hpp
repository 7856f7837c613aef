// Change notifications of the store to the kernel: ToolAnswer::alarm of a message to the
// operator. `tool` is its number (Alarm), `text` what it names.
#pragma once
#include <cstdint>

namespace polyturn {

inline constexpr std::int32_t kStoreMessage = -3;
// Likewise, and no production from now on, because data were lost (kStoreUnfit); the store is whole
// again or what is left was confirmed (kStoreWhole). A process that attaches later is notified
// again.
inline constexpr std::int32_t kStoreUnfit = -4, kStoreWhole = -5;

}  // namespace polyturn
