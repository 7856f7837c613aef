// The limits of a parameter: in words, alike in diagnoses and in descriptions, and as a check.
#pragma once

#include <string>
#include <string_view>

#include "ipc/params/registry.hpp"

namespace polyturn::params {

[[nodiscard]] std::string limits_text(const Row& row);  // "0 to 255", "from 0", "one of fanuc, nct"

// Whether a printable text may be stored in a text parameter.
[[nodiscard]] bool text_allowed(const Row& row, std::string_view text) noexcept;

}  // namespace polyturn::params
