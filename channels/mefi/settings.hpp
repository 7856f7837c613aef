// The language mefi (MEFI CNC8x6) as values of the address front end that fanuc and nct share
// (channels/fanuc).
#pragma once
#include "channels/fanuc/settings.hpp"

namespace polyturn::channels::mefi {

// Settings of channel `channel`: its machine's N parameters, and what makes the language (spec
// mefi_cnc8x6 3 to 6): whole units without a point, its own zero shifts, no macros.
fanuc::Settings mefi_settings(const params::Table& table, unsigned channel);

}  // namespace polyturn::channels::mefi
