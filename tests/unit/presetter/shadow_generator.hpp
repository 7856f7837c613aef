// Pictures of tools in a presetter, made without the library that measures them and without its
// formulas: a shape is asked point by point whether it covers a place, a pixel is the share of 12 x
// 12 places of it, and the blur is a plain convolution.
#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "toolmgmt/presetter/shadow_image.hpp"

namespace polyturn::test {

constexpr double kPi = 3.14159265358979323846;

struct Scene {
    int width = 800, height = 800;
    double um_per_pixel = 5.0;
    double tilt_deg = 0;                // of the camera
    double blur_px = 1.0, noise = 2.0;  // grey values
    double dark = 30, light = 220;
    std::uint32_t seed = 1;
    std::vector<std::array<double, 3>> chips;  // attached or loose: z, x, radius in mm
    std::vector<std::array<double, 3>> bites;  // broken out of the edge
};

// A place of the machine (z to the right, x up, mm; the middle of the picture is 0, 0): is it in
// the shadow?
using Shape = std::function<bool(double z, double x)>;

// A rounded wedge by its construction on paper: the corner point, two straight edges at the angles
// e1 and e2 (degrees against +Z, away from the corner), the circle of radius r laid into it; what
// lies between corner and circle is rounded away.
struct Wedge {
    double corner_z, corner_x, e1, e2, r;
    double included() const {
        double d = std::fabs(e1 - e2);
        return d > 180 ? 360 - d : d;
    }
    // Towards the middle of the wedge.
    double axis() const {
        const double a = e1 * kPi / 180, b = e2 * kPi / 180;
        return std::atan2(std::sin(a) + std::sin(b), std::cos(a) + std::cos(b));
    }
    double to_centre() const { return r / std::sin(included() * kPi / 360); }
    double centre_z() const { return corner_z + to_centre() * std::cos(axis()); }
    double centre_x() const { return corner_x + to_centre() * std::sin(axis()); }
    bool covers(double z, double x) const {
        // In the wedge: the direction from the corner lies within half the angle of the axis.
        const double dz = z - corner_z, dx = x - corner_x,
                     along = dz * std::cos(axis()) + dx * std::sin(axis()),
                     across = -dz * std::sin(axis()) + dx * std::cos(axis());
        const double half = included() * kPi / 360;
        if (along <= 0 || std::fabs(across) > along * std::tan(half)) return false;
        // In front of the points where the circle touches both edges only the circle counts.
        const double touch = r / std::tan(half) * std::cos(half);
        if (along >= touch) return true;
        const double cz = z - centre_z(), cx = x - centre_x();
        return cz * cz + cx * cx <= r * r;
    }
};

inline presetter::ShadowImage picture(const Scene& scene, const Shape& shape) {
    constexpr int kFine = 12;
    const double mm = scene.um_per_pixel / 1000, t = scene.tilt_deg * kPi / 180;
    std::vector<double> share(static_cast<std::size_t>(scene.width) *
                              static_cast<std::size_t>(scene.height));
    const auto covered = [&](double px, double py) {
        // right, up
        const double u = (px - scene.width / 2.0) * mm, w = (scene.height / 2.0 - py) * mm;
        const double z = std::cos(t) * u + std::sin(t) * w, x = -std::sin(t) * u + std::cos(t) * w;
        for (const auto& bite : scene.bites)
            if (std::hypot(z - bite[0], x - bite[1]) < bite[2]) return false;
        for (const auto& chip : scene.chips)
            if (std::hypot(z - chip[0], x - chip[1]) < chip[2]) return true;
        return shape(z, x);
    };
    for (int py = 0; py < scene.height; ++py)
        for (int px = 0; px < scene.width; ++px) {
            // Where the corners and the middle agree nothing passes through the pixel (no detail is
            // that small).
            const bool first = covered(px - 0.5, py - 0.5);
            double value = first ? 1 : 0;
            if (covered(px + 0.5, py - 0.5) != first || covered(px - 0.5, py + 0.5) != first ||
                covered(px + 0.5, py + 0.5) != first || covered(px, py) != first) {
                int count = 0;
                for (int j = 0; j < kFine; ++j)
                    for (int i = 0; i < kFine; ++i)
                        count +=
                            covered(px - 0.5 + (i + 0.5) / kFine, py - 0.5 + (j + 0.5) / kFine);
                value = count / static_cast<double>(kFine * kFine);
            }
            share[static_cast<std::size_t>(py) * static_cast<std::size_t>(scene.width) +
                  static_cast<std::size_t>(px)] = value;
        }
    // Blur: first along the rows, then along the columns.
    if (scene.blur_px > 0) {
        const int reach = static_cast<int>(std::ceil(4 * scene.blur_px));
        std::vector<double> kernel;
        double sum = 0;
        for (int k = -reach; k <= reach; ++k) {
            kernel.push_back(std::exp(-0.5 * k * k / (scene.blur_px * scene.blur_px)));
            sum += kernel.back();
        }
        for (int way = 0; way < 2; ++way) {
            std::vector<double> out(share.size());
            for (int y = 0; y < scene.height; ++y)
                for (int x = 0; x < scene.width; ++x) {
                    double value = 0;
                    for (int k = -reach; k <= reach; ++k) {
                        const int xx = std::min(std::max(x + (way == 0 ? k : 0), 0),
                                                scene.width - 1),
                                  yy = std::min(std::max(y + (way == 1 ? k : 0), 0),
                                                scene.height - 1);
                        value += kernel[static_cast<std::size_t>(k + reach)] *
                                 share[static_cast<std::size_t>(yy) *
                                           static_cast<std::size_t>(scene.width) +
                                       static_cast<std::size_t>(xx)];
                    }
                    out[static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width) +
                        static_cast<std::size_t>(x)] = value / sum;
                }
            share = std::move(out);
        }
    }
    std::mt19937 random(scene.seed);
    std::normal_distribution<double> noise(0, scene.noise);
    presetter::ShadowImage out{scene.width, scene.height, std::vector<float>(share.size())};
    for (std::size_t i = 0; i < share.size(); ++i) {
        const double grey = scene.light + share[i] * (scene.dark - scene.light) +
                            (scene.noise > 0 ? noise(random) : 0.0);
        // eight bits
        out.grey[i] = static_cast<float>(std::floor(std::min(255.0, std::max(0.0, grey)) + 0.5));
    }
    return out;
}

// A pin with a flat end that comes from above (pointing to -X) or from the right (pointing to -Z);
// its end in the middle.
inline Shape gauge_pin(double diameter, bool along_x) {
    return [=](double z, double x) {
        return along_x ? x >= 0 && std::fabs(z) <= diameter / 2
                       : z >= 0 && std::fabs(x) <= diameter / 2;
    };
}

}  // namespace polyturn::test
