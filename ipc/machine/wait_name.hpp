// A wait as the language of the program writes it: M501, or WAITM(3) and WAITE.
#pragma once
#include <string>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn {

inline constexpr int kWaitAtProgramEnd = 100;  // code of WAITE

inline std::string wait_name(Dialect language, int code) {
    if (language != Dialect::Sinumerik) return "M" + std::to_string(code);
    return code == kWaitAtProgramEnd ? "WAITE" : "WAITM(" + std::to_string(code) + ")";
}

}  // namespace polyturn
