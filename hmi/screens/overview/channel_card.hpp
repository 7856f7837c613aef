// One channel of the overview, written into a box of any size: the smaller it is, the fewer lines
// it has.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/machine/programs/program_text.hpp"

namespace polyturn::hmi {

// the levels 1 to 10 among a channel's keys
inline constexpr std::uint32_t kAllBlockSkips = 0x3FFu * kKeyBlockSkip1;

// the axes of a card that has room for two of their columns: the two others, in all such cards
inline constexpr int kTurnAxesHit = 1000;

// hint: of the chosen channel, where nothing else is to be said. turned: narrow cards show machine
// coordinates and following errors.
void composeCard(Writer& w, QSizeF size, const Context& context, unsigned channel,
                 ProgramText& programs, const QString& hint = {}, bool turned = false);

}  // namespace polyturn::hmi
