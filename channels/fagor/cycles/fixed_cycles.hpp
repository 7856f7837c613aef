// G81 to G89: the words of a cycle become a section, a hole, a thread or a groove (fagor_8037t part
// 2, 9.4 to 9.12).
#pragma once

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_section(Execution& x, const GCode& row);
bool g_drilling(Execution& x, const GCode&);
bool g_threading(Execution& x, const GCode& row);
bool g_grooving(Execution& x, const GCode& row);

}  // namespace polyturn::channels::fagor
