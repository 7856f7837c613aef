// G12.1, G13.1, G7.1: the face as a plane, the surface of a cylinder.
#pragma once

namespace polyturn::channels::fanuc {

struct Execution;
struct GCode;

bool switches_transformation(Execution& x);
bool g_polar_plane(Execution& x, const GCode& row);
bool g_cylinder(Execution& x, const GCode& row);
bool transformation_allows(Execution& x);

}  // namespace polyturn::channels::fanuc
