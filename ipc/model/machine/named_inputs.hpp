// Inputs that languages and setups call by name, each once for every channel, behind the machine's
// own numbers: SKIP and SKIP2 to SKIP4 (G31 P2 to P4), XAE, YAE, ZAE.
#pragma once
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

#include "ipc/capacities.hpp"

namespace polyturn {

inline constexpr std::array<std::string_view, 7> kInputNames{"SKIP",  "XAE",   "YAE",  "ZAE",
                                                             "SKIP2", "SKIP3", "SKIP4"};
inline constexpr std::size_t kFirstNamedInput = kInputs - kInputNames.size() * kMaxChannels;

// The number of an input that is given by name or number; channel from 1.
inline std::optional<std::uint32_t> input_by_name(std::string_view name,
                                                  unsigned channel) noexcept {
    for (std::size_t i = 0; i < kInputNames.size(); ++i)
        if (name == kInputNames[i] && channel >= 1 && channel <= kMaxChannels)
            return static_cast<std::uint32_t>(kFirstNamedInput + i * kMaxChannels + channel - 1);
    std::uint32_t number = 0;
    const auto end = std::from_chars(name.data(), name.data() + name.size(), number);
    if (name.empty() || end.ec != std::errc() || end.ptr != name.data() + name.size() ||
        number >= kInputs)
        return std::nullopt;
    return number;
}

}  // namespace polyturn
