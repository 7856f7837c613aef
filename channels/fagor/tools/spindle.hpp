// S, G96 G97, gears, and the override of the program.
#pragma once

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_spindle_mode(Execution& x, const GCode& row);
// S: a speed, a cutting speed with G96, an angle with M19.
bool spindle_word(Execution& x);
// Constant surface speed keeps to G92 S and to the gear. `said`: by G92 S itself.
bool limit_surface_speed(Execution& x, bool said = false);
// A thread or a tap turns at 100 %, whatever PRGSSO says.
void follow_spindle(Execution& x, bool thread);

}  // namespace polyturn::channels::fagor
