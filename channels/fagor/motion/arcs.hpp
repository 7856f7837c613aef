// G02 G03 G06 G08 G09.
#pragma once
#include "channels/sink.hpp"

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_arc(Execution& x, const GCode& row);

}  // namespace polyturn::channels::fagor
