// The languages of programs by their names, as PT_LANGUAGE, jobs and --language say them.
#pragma once
#include <utility>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn {

inline constexpr std::pair<std::string_view, Dialect> kProgramLanguages[] = {
    {"fanuc", Dialect::Fanuc},
    {"nct", Dialect::Nct},
    {"fagor", Dialect::Fagor},
    {"sinumerik", Dialect::Sinumerik},
    {"mefi", Dialect::Mefi}};

// Polyturn for a name that is none.
constexpr Dialect dialect_of(std::string_view language) noexcept {
    for (const auto& [name, dialect] : kProgramLanguages)
        if (name == language) return dialect;
    return Dialect::Polyturn;
}

// The other way round; empty for Polyturn.
constexpr std::string_view language_name(Dialect dialect) noexcept {
    for (const auto& [name, one] : kProgramLanguages)
        if (one == dialect) return name;
    return {};
}

}  // namespace polyturn
