// From a picture of a tool's shadow to what the offset table wants: X and Z of the tip, nose
// radius, tip number, edge angles; each with its uncertainty (twice the standard one: 95 %).
#pragma once

#include "ipc/diagnosis/diagnosis.hpp"
#include "toolmgmt/presetter/calibration.hpp"
#include "toolmgmt/presetter/shadow_image.hpp"

namespace polyturn::presetter {

struct Measured {
    double x_mm = 0, z_mm = 0;  // of the imaginary tip, X as a radius
    double radius_mm = 0;
    // imaginary tip number: 1 to 4 a corner, 5 to 8 the middle of the nose
    int tip = 0;
    double centre_x_mm = 0, centre_z_mm = 0;
    // the two flanks against +Z, away from the tip; -180 to 180
    double edge_deg[2] = {0, 0};
    double included_deg = 0;  // between them
    // uncertainties
    double x_error_mm = 0, z_error_mm = 0, radius_error_mm = 0, angle_error_deg = 0;
    double blur_pixels = 0, deviation_mm = 0, outliers = 0;
};

Result<Measured> measure(const ShadowImage& image, const Calibration& calibration);

}  // namespace polyturn::presetter
