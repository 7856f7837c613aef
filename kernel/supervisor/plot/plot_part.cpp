#include "kernel/supervisor/plot/plot_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>

namespace polyturn::supervisor {

namespace {

constexpr double kArcStep_rad = 4.0 * std::numbers::pi / 180.0;

// "grooving 3 mm" -> 3; 0 when the name has no width of a groove.
double groove_width(const std::string& name) {
    if (name.find("groov") == std::string::npos && name.find("Groov") == std::string::npos &&
        name.find("part") == std::string::npos)
        return 0.0;
    const auto mm = name.rfind("mm");
    if (mm == std::string::npos) return 0.0;
    std::size_t from = mm;
    while (from > 0 && (name[from - 1] == ' ' || name[from - 1] == '.' ||
                        (name[from - 1] >= '0' && name[from - 1] <= '9')))
        --from;
    const double width = std::strtod(name.c_str() + from, nullptr);
    return width > 0 && width < 50 ? width : 0.0;
}

std::string mounted_tool(const JobPlan& plan, const Activity& activity) {
    if (activity.tool.size() < 2 || activity.tool[0] != 'T' || !plan.job) return activity.tool;
    const int station = std::atoi(activity.tool.c_str() + 1);
    for (const text::JobTool& tool : plan.job->tools)
        if (tool.channel == activity.channel && tool.station == station) return tool.name;
    return activity.tool;
}

// Arc as chords, in the direction that the move has: clockwise as seen with Z to the right and X
// up.
void add_arc(std::vector<PlaneSegment>& out, PlaneSegment piece, const Activity& activity) {
    const PlanePoint centre = *activity.centre;
    const double radius = std::hypot(piece.from.x_mm - centre.x_mm, piece.from.z_mm - centre.z_mm);
    const double begin = std::atan2(piece.from.x_mm - centre.x_mm, piece.from.z_mm - centre.z_mm);
    double sweep = std::atan2(piece.to.x_mm - centre.x_mm, piece.to.z_mm - centre.z_mm) - begin;
    if (activity.clockwise && sweep >= 0) sweep -= 2 * std::numbers::pi;
    if (!activity.clockwise && sweep <= 0) sweep += 2 * std::numbers::pi;
    const int steps =
        std::clamp(static_cast<int>(std::ceil(std::abs(sweep) / kArcStep_rad)), 1, 180);
    const PlanePoint end = piece.to;
    for (int i = 1; i <= steps; ++i) {
        const double angle = begin + sweep * i / steps;
        piece.to = i == steps ? end
                              : PlanePoint{centre.x_mm + radius * std::sin(angle),
                                           centre.z_mm + radius * std::cos(angle)};
        out.push_back(piece);
        piece.from = piece.to;
    }
}

}  // namespace

std::vector<PlaneSegment> plane_segments(const RunRecord& record, const JobPlan& plan) {
    std::vector<PlaneSegment> out;
    std::map<unsigned, PlanePoint> at;
    for (std::size_t i = 0; i < record.activities.size(); ++i) {
        const Activity& activity = record.activities[i];
        if (!activity.to) continue;
        const auto before = at.find(activity.channel);
        if (before != at.end()) {
            PlaneSegment piece{activity.channel,
                               activity.doing,
                               before->second,
                               *activity.to,
                               groove_width(mounted_tool(plan, activity)),
                               i};
            if (activity.centre && activity.doing == Doing::Cut)
                add_arc(out, piece, activity);
            else
                out.push_back(piece);
        }
        at[activity.channel] = *activity.to;
    }
    return out;
}

Contour contour_after(const std::vector<PlaneSegment>& segments, const text::JobStock& stock) {
    Contour contour;
    contour.z_low_mm = stock.face - stock.length;
    const auto count =
        static_cast<std::size_t>(std::clamp(stock.length / contour.step_mm, 1.0, 100'000.0));
    contour.radius_mm.assign(count, stock.diameter / 2);
    const auto index_of = [&](double z) { return (z - contour.z_low_mm) / contour.step_mm; };
    const auto lower = [&](double z0, double z1, double x0, double x1) {
        if (z1 < z0) {
            std::swap(z0, z1);
            std::swap(x0, x1);
        }
        const auto first = static_cast<long>(std::ceil(index_of(z0) - 0.5)),
                   last = static_cast<long>(std::floor(index_of(z1) - 0.5));
        for (long i = std::max(first, 0L); i <= std::min(last, static_cast<long>(count) - 1); ++i) {
            const double z = contour.z_low_mm + (static_cast<double>(i) + 0.5) * contour.step_mm;
            const double x =
                z1 - z0 > 1e-9 ? x0 + (x1 - x0) * (z - z0) / (z1 - z0) : std::min(x0, x1);
            auto& radius = contour.radius_mm[static_cast<std::size_t>(i)];
            radius = std::max(0.0, std::min(radius, x));
        }
    };
    for (const PlaneSegment& piece : segments) {
        if (piece.doing == Doing::Rapid) continue;
        lower(piece.from.z_mm, piece.to.z_mm, piece.from.x_mm, piece.to.x_mm);
        if (piece.tool_width_mm > 0) {
            const double bottom = std::min(piece.from.x_mm, piece.to.x_mm),
                         z = std::min(piece.from.z_mm, piece.to.z_mm);
            lower(z, std::max(piece.from.z_mm, piece.to.z_mm) + piece.tool_width_mm, bottom,
                  bottom);
        }
        // A face cut to the centre takes away everything in front of it.
        const bool face = std::abs(piece.to.z_mm - piece.from.z_mm) < 1e-6 &&
                          piece.to.x_mm <= 1e-6 && piece.from.x_mm > 0;
        if (face) lower(piece.to.z_mm, stock.face + 1.0, 0.0, 0.0);
    }
    return contour;
}

}  // namespace polyturn::supervisor
