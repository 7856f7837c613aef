// Values of the machine in the text of a statement: the machine must have come there first.
#pragma once

namespace polyturn::channels::fagor {

struct Execution;

bool mentions_live_value(const char* at, const char* end);
// The text asks where an axis really is, and it is not quiet yet: ask again.
bool axes_settle(Execution& x, const char* at, const char* end);

}  // namespace polyturn::channels::fagor
