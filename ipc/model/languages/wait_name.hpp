// Codes of waits between channels, and how the language of the program writes them: M501, or
// WAITM(3) and WAITE. M codes (N2201 to N2202) and markers (0 to 99) are their own numbers; what is
// neither has a number beyond those that a wait M code can have in practice.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/image/balance.hpp"
#include "ipc/model/languages/language_traits.hpp"

namespace polyturn {

inline constexpr std::int32_t kWaitAtProgramEnd = 1'000'000'100;  // code of WAITE

inline constexpr std::string_view kWaitAtProgramEndWord = "WAITE";

inline std::string wait_name(const LanguageTraits& language, std::int32_t code) {
    if (code == kWaitAtProgramEnd) return std::string(kWaitAtProgramEndWord);
    return std::string(language.wait_prefix) + std::to_string(code) +
           std::string(language.wait_suffix);
}
inline std::string wait_name(Dialect language, std::int32_t code) {
    return wait_name(traits_of(language), code);
}

// The code of a wait that events name by its word: WAITE, and G68 and G69 of balance cutting.
inline std::optional<std::int32_t> wait_code_of(std::string_view word) {
    if (word == kWaitAtProgramEndWord) return kWaitAtProgramEnd;
    if (word == "G68") return kBalanceMeeting;
    if (word == "G69") return kBalanceEnd;
    return std::nullopt;
}

}  // namespace polyturn
