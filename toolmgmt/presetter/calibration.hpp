// How the camera sees the machine's X and Z: found with a gauge pin of known diameter that stands
// in the picture with a flat end, the middle of which is at a known place. X is a radius.
#pragma once

#include <string>

#include "ipc/diagnosis/diagnosis.hpp"
#include "toolmgmt/presetter/contour.hpp"

namespace polyturn::presetter {

struct Calibration {
    double mm_per_pixel = 0, scale_error = 0;  // relative standard uncertainty
    double tilt_rad = 0;                       // the camera about its axis
    Point reference;                           // pixels: the middle of the pin's end
    double x_mm = 0, z_mm = 0;                 // where that is
    double reference_error_mm = 0;             // standard uncertainty
    bool mirrored = false;                     // the right of the picture is -Z
    int width = 0, height = 0;                 // of the pictures that it is for

    // As points (z, x) in millimetres.
    Point to_machine(const Point& pixel) const;
};

struct GaugePin {
    double diameter_mm = 0, error_mm = 0.0005;  // standard uncertainty
    double x_mm = 0, z_mm = 0;                  // of the middle of its end
    bool mirrored = false;
};

Result<Calibration> calibrate(const ShadowImage& image, const GaugePin& pin);

// A small JSON file.
Result<Calibration> read_calibration(const std::string& path);
Result<void> write_calibration(const std::string& path, const Calibration& calibration);

}  // namespace polyturn::presetter
