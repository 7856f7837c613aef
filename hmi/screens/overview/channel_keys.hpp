// The channels of the machine as keys at the right end of a screen's title, the chosen one marked;
// a touch gives its number.
#pragma once
#include "hmi/widgets/screen.hpp"

namespace polyturn::hmi {

// Where the keys begin: what else stands in the title ends left of that.
double composeChannelKeys(Writer& w, const Context& context, const QSizeF& title);

}  // namespace polyturn::hmi
