// nct: the fanuc family's words of system B, set up by the N parameters (spec: nct parameters,
// parts 1 and 2).
#pragma once
#include "channels/fanuc/settings.hpp"

namespace polyturn::channels::nct {

fanuc::Settings nct_settings(const params::Table& table, unsigned channel);

}  // namespace polyturn::channels::nct
