// G commands that set modes of the geometry: plane, diameters, exact stop, settable zero.
#pragma once
namespace polyturn::channels::sinumerik {

struct Call;
struct Execution;
struct GCode;
struct Word;

bool g_units(Execution&, const GCode&);
bool g_distance(Execution&, const GCode&);
bool g_diameter(Execution&, const GCode&);
bool g_plane(Execution& x, const GCode& code);
bool g_exact_stop(Execution& x, const GCode& code);
bool g_exact_once(Execution& x, const GCode&);
bool g_zero(Execution& x, const GCode& code);
bool a_axis_diameter(Execution& x, const Word& word);
bool p_diamchan(Execution& x, Call&);

}  // namespace polyturn::channels::sinumerik
