#include "toolmgmt/presetter/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "toolmgmt/presetter/robust_line.hpp"

namespace polyturn::presetter {
namespace {

using Json = nlohmann::json;
constexpr double kParallel = 0.01, kSquare = 0.03;  // rad
constexpr double kTolerance = 1.5;                  // pixels

Diagnosis bad(std::string why) { return Diagnosis{Alarm::PresetterScale, {}, {}, std::move(why)}; }

// Angle between two lines, 0 to a quarter turn.
double between(const Line& a, const Line& b) {
    return std::asin(std::min(1.0, std::fabs(a.nx * b.ny - a.ny * b.nx)));
}

}  // namespace

Point Calibration::to_machine(const Point& pixel) const {
    const double u = (mirrored ? reference.x - pixel.x : pixel.x - reference.x) * mm_per_pixel,
                 w = (reference.y - pixel.y) * mm_per_pixel;
    const double c = std::cos(tilt_rad), s = std::sin(tilt_rad);
    return {z_mm + c * u + s * w, x_mm - s * u + c * w};
}

Result<Calibration> calibrate(const ShadowImage& image, const GaugePin& pin) {
    if (!(pin.diameter_mm > 0)) return bad("the diameter of the gauge pin is missing");
    const Result<Contour> contour = find_contour(image);
    if (!contour) return contour.diagnosis();
    std::vector<Point> left = contour->points;
    std::vector<Line> lines;
    while (lines.size() < 3) {
        auto line = robust_line(left, kTolerance);
        if (!line) break;
        std::vector<Point> rest, own;
        for (const Point& p : left)
            (std::fabs(line->distance(p)) <= 2 * kTolerance ? own : rest).push_back(p);
        line->on.resize(own.size());
        lines.push_back(std::move(*line));
        left = std::move(rest);
    }
    if (lines.size() < 3)
        return bad("the picture does not show both sides and the flat end of a pin");
    int end = -1;
    for (int k = 0; k < 3; ++k)
        if (between(lines[static_cast<std::size_t>((k + 1) % 3)],
                    lines[static_cast<std::size_t>((k + 2) % 3)]) < kParallel)
            end = k;
    if (end < 0) return bad("the sides of the pin are not parallel in the picture");
    Line face = lines[static_cast<std::size_t>(end)],
         a = lines[static_cast<std::size_t>((end + 1) % 3)],
         b = lines[static_cast<std::size_t>((end + 2) % 3)];
    if (between(face, a) < std::numbers::pi / 2 - kSquare)
        return bad("the end of the pin is not square to its sides");
    if (a.nx * b.nx + a.ny * b.ny < 0) {
        b.nx = -b.nx;
        b.ny = -b.ny;
        b.d = -b.d;
    }
    // One direction for both sides, each by the points that it has.
    const double wa = static_cast<double>(a.on.size()), wb = static_cast<double>(b.on.size());
    double nx = a.nx * wa + b.nx * wb, ny = a.ny * wa + b.ny * wb;
    const double length = std::hypot(nx, ny);
    nx /= length;
    ny /= length;
    double da = 0, db = 0, na = 0, nb = 0, spread = 0;
    for (const Point& p : contour->points) {
        if (std::fabs(a.distance(p)) <= kTolerance && std::fabs(face.distance(p)) > 12) {
            da += nx * p.x + ny * p.y;
            na += 1;
            spread += a.distance(p) * a.distance(p);
        } else if (std::fabs(b.distance(p)) <= kTolerance && std::fabs(face.distance(p)) > 12) {
            db += nx * p.x + ny * p.y;
            nb += 1;
            spread += b.distance(p) * b.distance(p);
        }
    }
    if (na < 50 || nb < 50) return bad("too little of the pin's sides is seen");
    da /= na;
    db /= nb;
    spread = std::sqrt(spread / (na + nb));
    const double pixels = std::fabs(da - db);
    if (pixels < 40)
        return bad("the pin is only " + std::to_string(static_cast<int>(pixels)) + " pixels thick");
    Calibration out;
    out.width = image.width;
    out.height = image.height;
    out.mirrored = pin.mirrored;
    out.mm_per_pixel = pin.diameter_mm / pixels;
    const double pixel_error =
        std::hypot(spread * std::sqrt(4 / std::min(na, nb)) * std::numbers::sqrt2, 0.03);
    out.scale_error = std::hypot(pixel_error / pixels, pin.error_mm / pin.diameter_mm);
    // The middle line meets the end.
    const double middle = (da + db) / 2, cross = nx * face.ny - ny * face.nx;
    out.reference = {(middle * face.ny - face.d * ny) / cross,
                     (nx * face.d - face.nx * middle) / cross};
    out.reference_error_mm = out.mm_per_pixel * std::hypot(pixel_error, 0.03);
    out.x_mm = pin.x_mm;
    out.z_mm = pin.z_mm;
    // The pin's axis is one of the machine's: the nearer one. Its direction in the picture, upwards
    // and to the right.
    // (u right, w up) of a line with the normal (nx, ny), y downwards
    double along_u = -ny, along_w = -nx;
    if (pin.mirrored) along_u = -along_u;
    // of the axis against the right
    double angle = std::atan2(along_w, along_u);
    angle = std::remainder(angle, std::numbers::pi / 2);  // against the nearest axis
    out.tilt_rad = angle;
    return out;
}

Result<Calibration> read_calibration(const std::string& path) {
    std::ifstream file(path);
    if (!file) return bad(path + " cannot be read");
    const Json json = Json::parse(file, nullptr, false);
    Calibration out;
    try {
        out.mm_per_pixel = json.at("mm_per_pixel");
        out.scale_error = json.at("scale_error");
        out.tilt_rad = json.at("tilt_rad");
        out.reference = {json.at("reference").at(0), json.at("reference").at(1)};
        out.x_mm = json.at("x_mm");
        out.z_mm = json.at("z_mm");
        out.reference_error_mm = json.at("reference_error_mm");
        out.mirrored = json.at("mirrored");
        out.width = json.at("width");
        out.height = json.at("height");
    } catch (const Json::exception&) { return bad(path + " is no calibration"); }
    if (!(out.mm_per_pixel > 0) || !std::isfinite(out.tilt_rad))
        return bad(path + " is no calibration");
    return out;
}

Result<void> write_calibration(const std::string& path, const Calibration& c) {
    const Json json = {{"mm_per_pixel", c.mm_per_pixel},
                       {"scale_error", c.scale_error},
                       {"tilt_rad", c.tilt_rad},
                       {"reference", {c.reference.x, c.reference.y}},
                       {"x_mm", c.x_mm},
                       {"z_mm", c.z_mm},
                       {"reference_error_mm", c.reference_error_mm},
                       {"mirrored", c.mirrored},
                       {"width", c.width},
                       {"height", c.height}};
    std::error_code none;  // a folder that cannot be made shows in the file
    if (const auto folder = std::filesystem::path(path).parent_path(); !folder.empty())
        std::filesystem::create_directories(folder, none);
    std::ofstream file(path);
    file << json.dump(2) << '\n';
    file.close();
    if (!file) return Diagnosis{Alarm::OutputFile, {path, 0, 0, 0}, {}, path};
    return {};
}

}  // namespace polyturn::presetter
