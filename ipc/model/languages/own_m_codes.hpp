// M codes that a language acts on itself: they end, stop and call programs. All others are waits
// and the machine's. One table for the printed references (channels/*/reference.cpp) and for the
// help key of the screens.
#pragma once
#include <array>
#include <span>
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::text {

struct OwnMCode {
    std::string_view name, text;  // text: translated in channels/reference_words.txt
};

// What the interpreter of the fanuc family acts on (channels/fanuc/functions/m_codes.cpp).
inline constexpr auto kFanucMCodes = std::to_array<OwnMCode>({
    {"M0", "Programmed stop: start goes on"},
    {"M1", "Stop where optional stop is on"},
    {"M2", "End of the program"},
    {"M30", "End of the program, back to its beginning"},
    {"M96", "Interrupt program on: P is the program"},
    {"M97", "Interrupt program off; P: calls from that block, to M99"},
    {"M98", "Call of a subprogram: P number or a name in angle brackets, L times"},
    {"M99",
     "End of the subprogram, P: back to that block; in a main program from the beginning again"},
    {"M198", "Call of a subprogram from outside (PT_EXTERNAL)"},
});
inline constexpr auto kFagorMCodes = std::to_array<OwnMCode>({
    {"M0", "Programmed stop: start goes on"},
    {"M1", "Stop where optional stop is on"},
    {"M2", "End of the program"},
    {"M30", "End of the program, back to its beginning"},
});
inline constexpr auto kSinumerikMCodes = std::to_array<OwnMCode>({
    {"M0", "Programmed stop: start goes on"},
    {"M1", "Stop where optional stop is on"},
    {"M2", "End of the program, or of the subprogram"},
    {"M17", "End of the subprogram"},
    {"M30", "End of the program, or of the subprogram"},
});

constexpr std::span<const OwnMCode> own_m_codes(Dialect language) {
    if (language == Dialect::Fagor) return kFagorMCodes;
    if (language == Dialect::Sinumerik) return kSinumerikMCodes;
    return kFanucMCodes;
}

}  // namespace polyturn::text
