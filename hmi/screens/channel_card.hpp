// One channel of the overview, written into a box of any size: the smaller it is, the fewer lines it has.
#pragma once
#include "hmi/app/screen.hpp"
#include "hmi/machine/program_text.hpp"

namespace polyturn::hmi {

void composeCard(Writer& w, QSizeF size, const Desk& desk, unsigned channel, ProgramText& programs);

}  // namespace polyturn::hmi
