// The generated table behind registry.hpp; nobody else includes this.
#pragma once

#include <cstdint>
#include <span>

#include "ipc/params/registry.hpp"

namespace polyturn::params::detail {

// Spans over constant data: ready before any dynamic initialisation.
extern const std::span<const Row> kRows;
// indices of kRows, numbers ascending by byte
extern const std::span<const std::uint16_t> kByNumber;

}  // namespace polyturn::params::detail
