// What the store tells the kernel without having been asked: ToolAnswer::alarm of a message to the operator. `tool` is its number
// (Alarm), `text` what it names.
#pragma once
#include <cstdint>

namespace polyturn {

inline constexpr std::int32_t kStoreMessage = -3;

}  // namespace polyturn
