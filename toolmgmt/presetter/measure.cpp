#include "toolmgmt/presetter/measure.hpp"

#include <cmath>
#include <numbers>

#include "toolmgmt/presetter/contour.hpp"
#include "toolmgmt/presetter/nose_fit.hpp"

namespace polyturn::presetter {
namespace {

constexpr double kCoverage = 2.0;     // standard uncertainties
constexpr double kPixelFloor = 0.03;  // what threshold and optics leave, pixels
constexpr double kDegrees = 180 / std::numbers::pi;

// From the nose centre to the imaginary tip by its number, (Z, X) (fanuc_lathe 2.1).
constexpr int kTips[9][2] = {{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1},
                             {1, 0}, {0, 1}, {-1, 0}, {0, -1}};

// The axis directions in which the nose is the outermost of the tool: those between the outward
// normals of the flanks.
int tip_of(const Nose& nose) {
    int z = 0, x = 0;
    for (int k = 0; k < 4; ++k) {
        const double direction = k * std::numbers::pi / 2;
        if (std::fabs(std::remainder(direction - nose.points_to, 2 * std::numbers::pi)) >
            nose.half + 1e-3)
            continue;
        if (k % 2 == 0)
            z = k == 0 ? 1 : -1;
        else
            x = k == 1 ? 1 : -1;
    }
    for (int n = 1; n <= 8; ++n)
        if (kTips[n][0] == z && kTips[n][1] == x) return n;
    return 0;
}

}  // namespace

Result<Measured> measure(const ShadowImage& image, const Calibration& calibration) {
    if (image.width != calibration.width || image.height != calibration.height)
        return Diagnosis{Alarm::PresetterScale,
                         {},
                         {},
                         "the calibration is for pictures of " + std::to_string(calibration.width) +
                             " x " + std::to_string(calibration.height) + " pixels"};
    const Result<Contour> contour = find_contour(image);
    if (!contour) return contour.diagnosis();
    if (!contour->at_border)
        return Diagnosis{Alarm::PresetterImage,
                         {},
                         {},
                         "what it shows is held by nothing: it is dirt, or it is cut off"};
    std::vector<Point> points;
    points.reserve(contour->points.size());
    for (const Point& p : contour->points) points.push_back(calibration.to_machine(p));  // (z, x)
    const Result<Nose> fitted = fit_nose(points, calibration.mm_per_pixel);
    if (!fitted) return fitted.diagnosis();
    const Nose& nose = *fitted;
    Measured out;
    out.centre_z_mm = nose.x;
    out.centre_x_mm = nose.y;
    out.radius_mm = nose.r;
    out.tip = tip_of(nose);
    out.z_mm = nose.x + kTips[out.tip][0] * nose.r;
    out.x_mm = nose.y + kTips[out.tip][1] * nose.r;
    // Along the flanks away from the tip: a quarter turn beyond the normals.
    for (int k = 0; k < 2; ++k) {
        const double side = k == 0 ? 1 : -1;
        out.edge_deg[k] = std::remainder(nose.points_to + side * (nose.half + std::numbers::pi / 2),
                                         2 * std::numbers::pi) *
                          kDegrees;
    }
    out.included_deg = 180 - 2 * nose.half * kDegrees;
    const auto& v = nose.covariance;
    const double floor = kPixelFloor * calibration.mm_per_pixel;
    const auto error = [&](int axis, int e, double from_reference) {
        const double fit = v(axis, axis) + e * e * v(2, 2) + 2 * e * v(axis, 2);
        const double scale = calibration.scale_error * from_reference;
        return kCoverage *
               std::sqrt(std::max(fit, 0.0) + scale * scale +
                         calibration.reference_error_mm * calibration.reference_error_mm +
                         floor * floor);
    };
    out.z_error_mm = error(0, kTips[out.tip][0], out.z_mm - calibration.z_mm);
    out.x_error_mm = error(1, kTips[out.tip][1], out.x_mm - calibration.x_mm);
    out.radius_error_mm =
        kCoverage *
        std::sqrt(v(2, 2) + std::pow(calibration.scale_error * nose.r, 2) + floor * floor);
    out.angle_error_deg = kCoverage * std::sqrt(v(3, 3) + v(4, 4)) * kDegrees;
    out.blur_pixels = contour->blur;
    out.deviation_mm = nose.deviation;
    out.outliers = nose.outliers;
    return out;
}

}  // namespace polyturn::presetter
