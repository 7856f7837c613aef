// What the kernel must know of the language of a program, as traits: the kernel asks for them and
// never for a language. One row a language; the limits beside them are parameters.
#pragma once
#include <array>
#include <cstddef>
#include <string_view>

#include "ipc/diagnosis/languages.hpp"

namespace polyturn {

struct LanguageTraits {
    // The panel's feed switch ends at FG.MAXFOVR (at most 120 %), that of a spindle runs from
    // FG.MINSOVR to FG.MAXSOVR (fagor part 1, 5.2, 5.3).
    bool override_ranges = false;
    // G92 S limits what the keys make of a speed too (fagor part 1, 4.4.1)
    bool speed_limit_caps_override = false;
    // Constant surface speed rests in rapid moves: the spindle keeps its speed (sinumerik part 1,
    // G96).
    bool rapid_holds_surface_speed = false;
    // how a wait is written: prefix, code, suffix
    std::string_view wait_prefix = "M", wait_suffix = {};
};

// By Dialect; row 0 is that of texts without a language.
inline constexpr std::array<LanguageTraits, std::size(kProgramLanguages) + 1> kLanguageTraits = [] {
    std::array<LanguageTraits, std::size(kProgramLanguages) + 1> rows{};
    auto& fagor = rows[static_cast<std::size_t>(Dialect::Fagor)];
    fagor.override_ranges = fagor.speed_limit_caps_override = true;
    auto& sinumerik = rows[static_cast<std::size_t>(Dialect::Sinumerik)];
    sinumerik.rapid_holds_surface_speed = true;
    sinumerik.wait_prefix = "WAITM(";
    sinumerik.wait_suffix = ")";
    return rows;
}();

constexpr const LanguageTraits& traits_of(Dialect language) noexcept {
    const auto row = static_cast<std::size_t>(language);
    return kLanguageTraits[row < kLanguageTraits.size() ? row : 0];
}

}  // namespace polyturn
