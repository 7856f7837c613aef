// Polygon turning and the electronic gear box.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

// The block codes G81.8, whose T is a number of teeth.
bool gear_block(const Execution& x);

bool turns_polygon(const Execution& x, unsigned place);
bool polygon_alone(Execution& x);
bool g_polygon(Execution& x, const GCode&);
bool g_polygon_off(Execution& x, const GCode&);
bool g_gear(Execution& x, const GCode&);
bool g_gear_off(Execution& x, const GCode&);

}  // namespace polyturn::channels::fanuc
