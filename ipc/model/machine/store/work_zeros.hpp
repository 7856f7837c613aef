// Names of zero offsets, and the row of ChannelStore::zeros that each has (see the end of
// segments.hpp).
//
//   row    0         1..6      7                11..310            311   312    313..319, 9
//   name   external  G54..G59  shift (G10 P0)   G54.1P1..G54.1P300 G53   G500   G54.2P1..G54.2P8
//
// Controls call the same tables otherwise. The n-th settable offset is one row for all of them: 1
// to 6 are G54 to G59, from 7 on the rows of G54.1; so a channel that changes its language keeps
// its zeros.
//   Fagor      G159Nn     the n-th, n = 1..20
//   Sinumerik  G505..G599 the 5th to the 99th; G500 a row of its own ($P_UIFR[0])
//   MEFI       G53        a row of its own: a system like the others, added to none of them
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "ipc/capacities.hpp"

namespace polyturn {

// "G54", "g54", "G54.1P3", "G54.1 P3", "G159N7", "G505", "shift", "external"; nothing when no row
// has that name.
[[nodiscard]] std::optional<std::size_t> work_zero_row(std::string_view name);

// The row of the n-th settable offset, n from 1; nothing beyond the last one (306).
[[nodiscard]] std::optional<std::size_t> settable_zero_row(std::size_t n);

// The row's own name as in the picture above; empty for rows that have none.
[[nodiscard]] std::string work_zero_name(std::size_t row);

}  // namespace polyturn
