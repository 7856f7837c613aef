// The generated table behind registry.hpp; nobody else includes this.
#pragma once

#include <cstdint>
#include <span>

#include "ipc/params/registry.hpp"

namespace polyturn::params::detail {

// Spans over constant data: ready before any dynamic initialisation.
extern const std::span<const Row> kRows;
extern const std::span<const std::uint16_t> kByNumber;  // indices of kRows, numbers ascending by byte

}  // namespace polyturn::params::detail
