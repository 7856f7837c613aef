// The plane, G16 to G19, and the polar origin in it.
#pragma once

namespace polyturn::channels::fagor {

struct Execution;
struct GCode;

bool g_plane(Execution& x, const GCode& row);
bool g_plane_of_axes(Execution& x, const GCode&);
bool g_polar_origin(Execution& x, const GCode&);
// The places of abscissa and ordinate; false: the machine lacks one, a fault is noted.
bool plane_places(Execution& x, unsigned& p, unsigned& q);
// In the part, before mirror and scale.
void polar_origin(const Execution& x, double& p, double& q);
void set_polar_origin(Execution& x, double p, double q);
void reset_polar_origin(Execution& x);

}  // namespace polyturn::channels::fagor
