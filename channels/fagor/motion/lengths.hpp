// Units, and how numbers of the program become lengths: true millimetres (X as a radius) or
// degrees.
#pragma once

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

double distance(const Execution& x, char letter);  // of a word; 0 without it
bool g_units(Execution& x, const GCode& row);
bool g_x_format(Execution& x, const GCode& row);
bool g_distance(Execution& x, const GCode& row);
// Millimetres (X as a radius) or degrees of a programmed number.
double length(const Execution& x, double programmed, int place);
// As the program would write it.
double from_length(const Execution& x, double true_mm, int place);
// Likewise of a true distance of a linear axis.
double from_length_plain(const Execution& x, double mm);
// The machine's view knows whether X is programmed as a diameter.
void show_diameter(Execution& x);

}  // namespace polyturn::channels::fagor
