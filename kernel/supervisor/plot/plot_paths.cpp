// The upper panel: Z to the right, X up; channels whose X axis comes from below are drawn below the
// centre line.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ipc/model/bodies/room.hpp"
#include "kernel/supervisor/plot/plot_panels.hpp"
#include "kernel/supervisor/plot/plot_part.hpp"

namespace polyturn::supervisor {

namespace {
constexpr double kMargin_mm = 10.0;
constexpr double kMostHeight = 620.0;
constexpr double kAxisRoom = 34.0;  // pixels below the drawing for the Z scale

// G54 of the channel in Z: where the workpiece zero lies on the machine.
double zero_z(const JobPlan& plan, unsigned channel) {
    const auto& work = plan.setup.channel(channel).work;
    const auto system = work.find("G54");
    if (system == work.end()) return 0.0;
    const auto value = system->second.find("Z");
    return value == system->second.end() ? 0.0 : value->second;
}
}  // namespace

double round_step(double range, double wanted) {
    const double raw = std::max(range, 1e-9) / wanted,
                 power = std::pow(10.0, std::floor(std::log10(raw)));
    const double head = raw / power;
    return power * (head < 1.5 ? 1.0 : head < 3.5 ? 2.0 : head < 7.5 ? 5.0 : 10.0);
}

struct PathPanel::Parts {
    const JobPlan& plan;
    std::vector<PlaneSegment> segments;
    std::map<unsigned, double> side;  // of the centre line: +1 above, -1 below
    std::optional<text::JobStock> stock;
    Contour contour;
    std::optional<RoomChuck> chuck;
    double chuck_face_mm = 0.0;  // in the workpiece system
    double z_low = 0, z_high = 0, x_low = 0, x_high = 0, scale = 1.0;

    Pixel at(const Frame& frame, double z, double x) const {
        return {frame.x + (z - z_low) * scale, frame.y + (x_high - x) * scale};
    }
    Pixel at(const Frame& frame, unsigned channel, PlanePoint p) const {
        return at(frame, p.z_mm, p.x_mm * side.at(channel));
    }

    void find_view(double width) {
        bool first = true;
        const auto include = [&](double z, double x) {
            if (first) {
                z_low = z_high = z;
                x_low = x_high = x;
                first = false;
            }
            z_low = std::min(z_low, z);
            z_high = std::max(z_high, z);
            x_low = std::min(x_low, x);
            x_high = std::max(x_high, x);
        };
        // Rapids leave the picture: the tool change positions are far away.
        for (const PlaneSegment& piece : segments)
            if (piece.doing != Doing::Rapid)
                for (const PlanePoint& p : {piece.from, piece.to})
                    include(p.z_mm, p.x_mm * side.at(piece.channel));
        if (stock) {
            include(stock->face, stock->diameter / 2);
            include(stock->face - stock->length, -stock->diameter / 2);
            if (chuck && chuck_face_mm < stock->face &&
                chuck_face_mm > stock->face - stock->length - 100) {
                include(chuck_face_mm - 10, stock->diameter / 2 + 16);
                include(chuck_face_mm - 10, -stock->diameter / 2 - 16);
            }
        }
        if (first)
            for (const PlaneSegment& piece : segments)
                include(piece.to.z_mm, piece.to.x_mm * side.at(piece.channel));
        z_low -= kMargin_mm;
        z_high += 1.6 * kMargin_mm;
        x_low -= kMargin_mm;
        x_high += kMargin_mm;
        x_low = std::min(x_low, -kMargin_mm);
        x_high = std::max(x_high, kMargin_mm);
        scale = std::min(width / (z_high - z_low), kMostHeight / (x_high - x_low));
        const double spare = width / scale - (z_high - z_low);  // centred when the height decides
        z_low -= spare / 2;
        z_high += spare / 2;
    }

    void draw_chuck(Svg& svg, const Frame& frame) const {
        if (!chuck || !stock) return;
        const double r = stock->diameter / 2, outer = chuck->diameter / 2;
        const auto box = [&](double z0, double z1, double x0, double x1, const char* look_of) {
            const Pixel a = at(frame, z0, x1), b = at(frame, z1, x0);
            svg.rect(a.x, a.y, b.x - a.x, b.y - a.y, look_of, 2.0);
        };
        box(chuck_face_mm - chuck->length, chuck_face_mm, -outer, outer, "fill=\"#8d979e\"");
        for (const double sign : {1.0, -1.0}) {
            const double low = r, high = std::min(outer * 0.85, r + 16.0);
            box(chuck_face_mm, chuck_face_mm + chuck->jaws, sign > 0 ? low : -high,
                sign > 0 ? high : -low, "fill=\"#5d676f\"");
            box(chuck_face_mm, chuck_face_mm + chuck->jaws * 0.55, sign > 0 ? high : -(high + 8),
                sign > 0 ? high + 8 : -high, "fill=\"#5d676f\"");
        }
    }

    void draw_part(Svg& svg, const Frame& frame) const {
        if (!stock || stock->diameter <= 0 || stock->length <= 0) return;
        const Pixel a = at(frame, stock->face - stock->length, stock->diameter / 2),
                    b = at(frame, stock->face, -stock->diameter / 2);
        svg.rect(
            a.x, a.y, b.x - a.x, b.y - a.y,
            "fill=\"url(#stock)\" stroke=\"#b9b09a\" stroke-width=\"0.8\" stroke-dasharray=\"5 3\"",
            1.5);
        std::vector<Pixel> above, below;
        double before = -1.0;
        for (std::size_t i = 0; i < contour.radius_mm.size(); ++i) {
            const double radius = contour.radius_mm[i];
            const bool last = i + 1 == contour.radius_mm.size();
            if (std::abs(radius - before) < 1e-6 && !last &&
                std::abs(contour.radius_mm[i + 1] - radius) < 1e-6)
                continue;
            const double z = contour.z_low_mm +
                             (static_cast<double>(i) + (last                              ? 1.0
                                                        : radius != before && before >= 0 ? 0.0
                                                                                          : 0.0)) *
                                 contour.step_mm;
            above.push_back(at(frame, z, radius));
            below.push_back(at(frame, z, -radius));
            before = radius;
        }
        std::vector<Pixel> outline = above;
        outline.insert(outline.end(), below.rbegin(), below.rend());
        svg.polyline(
            outline,
            fmt::format(
                "fill=\"url(#part)\" stroke=\"{}\" stroke-width=\"0.9\" stroke-linejoin=\"round\"",
                look::kPartEdge),
            true);
        if (stock->bore > 0) {
            const Pixel c = at(frame, stock->face - stock->length, stock->bore / 2),
                        d = at(frame, stock->face, -stock->bore / 2);
            svg.rect(c.x, c.y, d.x - c.x, d.y - c.y,
                     fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"0.7\"", look::kPaper,
                                 look::kPartEdge));
        }
    }

    // Consecutive pieces of one kind as one line.
    void draw_ways(Svg& svg, const Frame& frame, bool rapid) const {
        for (std::size_t i = 0; i < segments.size();) {
            const PlaneSegment& head = segments[i];
            std::vector<Pixel> points{at(frame, head.channel, head.from)};
            std::size_t k = i;
            // Channels alternate in the record; a path goes on where its channel's last piece
            // ended.
            for (; k < segments.size() && segments[k].channel == head.channel &&
                   segments[k].doing == head.doing;
                 ++k)
                points.push_back(at(frame, head.channel, segments[k].to));
            i = k;
            if ((head.doing == Doing::Rapid) != rapid) continue;
            const char* colour = look::channel_colour(head.channel);
            if (rapid)
                svg.polyline(points, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"0.8\" "
                                                 "stroke-opacity=\"0.5\" stroke-dasharray=\"4 3\"",
                                                 colour));
            else if (head.doing == Doing::Thread)
                svg.polyline(points,
                             fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"3.4\" "
                                         "stroke-dasharray=\"1.1 1.7\" stroke-opacity=\"0.85\"",
                                         colour));
            else
                svg.polyline(points,
                             fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" "
                                         "stroke-linejoin=\"round\" stroke-linecap=\"round\"",
                                         colour));
        }
    }

    void draw_scales(Svg& svg, const Frame& frame, double height) const {
        const double step = round_step(z_high - z_low, 12);
        for (double z = std::ceil(z_low / step) * step; z <= z_high; z += step) {
            const Pixel foot = at(frame, z, x_low);
            svg.line({foot.x, frame.y}, {foot.x, frame.y + height},
                     fmt::format("stroke=\"{}\" stroke-width=\"{}\"", look::kGrid,
                                 std::abs(z) < 1e-9 ? 1.2 : 0.7));
            svg.text(
                {foot.x, frame.y + height + 16}, fmt::format("{:g}", std::abs(z) < 1e-9 ? 0.0 : z),
                fmt::format("text-anchor=\"middle\" font-size=\"11\" fill=\"{}\"", look::kQuiet));
        }
        // Round steps of the diameter, as the operator reads it.
        const double x_step = round_step((x_high - x_low) * 2, 9) / 2;
        for (double x = std::ceil(x_low / x_step) * x_step; x <= x_high; x += x_step) {
            const Pixel foot = at(frame, z_low, x);
            svg.line({frame.x, foot.y}, {frame.x + frame.width, foot.y},
                     fmt::format("stroke=\"{}\" stroke-width=\"0.7\"", look::kGrid));
            svg.text({frame.x - 8, foot.y + 4},
                     std::abs(x) < 1e-9 ? std::string("0") : fmt::format("⌀{:g}", 2 * std::abs(x)),
                     fmt::format("text-anchor=\"end\" font-size=\"11\" fill=\"{}\"", look::kQuiet));
        }
    }
};

PathPanel::PathPanel(const RunRecord& record, const JobPlan& plan, double width)
    : parts_(new Parts{plan, plane_segments(record, plan), {}, {}, {}, {}}) {
    Parts& p = *parts_;
    std::vector<Diagnosis> ignored;  // a machine model that cannot be read was reported when the
                                     // machine was
    const Room room = load_room(plan.room_file, *plan.machine, ignored);
    for (const auto& [channel, program] : plan.programs) {
        const AxisConfig* x = find_axis(*plan.machine, channel, PlaneRole::BasicX);
        const auto place = x ? room.axes.find(x->number) : room.axes.end();
        p.side[channel] = place != room.axes.end() && place->second.direction.x < 0 ? -1.0 : 1.0;
    }
    std::erase_if(p.segments,
                  [&](const PlaneSegment& piece) { return !p.side.count(piece.channel); });
    if (plan.job && plan.job->stock) {
        p.stock = plan.job->stock;
        p.contour = contour_after(p.segments, *p.stock);
        const unsigned spindle =
            static_cast<unsigned>(std::strtoul(p.stock->spindle.c_str() + 1, nullptr, 10));
        const auto chuck = room.chucks.find(spindle);
        if (chuck != room.chucks.end() && !plan.programs.empty()) {
            const unsigned channel = plan.programs.begin()->first;
            const AxisConfig* z = find_axis(*plan.machine, channel, PlaneRole::BasicZ);
            const auto axis = z ? room.axes.find(z->number) : room.axes.end();
            if (axis != room.axes.end()) {
                p.chuck = chuck->second;
                p.chuck_face_mm = chuck->second.origin.z - axis->second.origin.z -
                                  zero_z(plan, channel) * axis->second.direction.z;
            }
        }
    }
    if (!empty()) p.find_view(width);
}

PathPanel::~PathPanel() = default;

bool PathPanel::empty() const { return parts_->segments.empty() && !parts_->stock; }

double PathPanel::height() const {
    return empty() ? 0.0 : (parts_->x_high - parts_->x_low) * parts_->scale + kAxisRoom;
}

void PathPanel::draw(Svg& svg, const Frame& frame) const {
    if (empty()) return;
    const Parts& p = *parts_;
    const double drawing = height() - kAxisRoom;
    svg.raw(
        fmt::format("<clipPath id=\"view\"><rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" "
                    "height=\"{:.2f}\"/></clipPath>\n",
                    frame.x, frame.y, frame.width, drawing));
    p.draw_scales(svg, frame, drawing);
    svg.open_group("clip-path=\"url(#view)\"");
    p.draw_chuck(svg, frame);
    p.draw_part(svg, frame);
    const Pixel left = p.at(frame, p.z_low, 0), right = p.at(frame, p.z_high, 0);
    svg.line(left, right,
             fmt::format("stroke=\"{}\" stroke-width=\"0.9\" stroke-dasharray=\"16 4 3 4\"",
                         look::kQuiet));
    p.draw_ways(svg, frame, true);
    p.draw_ways(svg, frame, false);
    svg.close_group();
    svg.rect(frame.x, frame.y, frame.width, drawing,
             "fill=\"none\" stroke=\"#d3d8da\" stroke-width=\"1\"");
    svg.text({frame.x + frame.width, frame.y + drawing + 31},
             "Z in mm from the workpiece zero; X as a diameter",
             fmt::format("text-anchor=\"end\" font-size=\"11\" fill=\"{}\"", look::kQuiet));
    for (const auto& [channel, side] : p.side) {
        const auto file = p.plan.programs.find(channel);
        const std::string name =
            fmt::format("L{}  {}", channel,
                        file == p.plan.programs.end()
                            ? std::string()
                            : std::filesystem::path(file->second.file).filename().string());
        // Channels of one side stand under each other.
        double row = 0;
        for (const auto& [other, other_side] : p.side)
            if (other < channel && other_side == side) row += 23;
        svg.rect(frame.x + 8, (side > 0 ? frame.y + 6 + row : frame.y + drawing - 25 - row),
                 16.0 + 7.4 * static_cast<double>(name.size()), 20,
                 "fill=\"#ffffff\" fill-opacity=\"0.92\"", 4.0);
        svg.text({frame.x + 16, side > 0 ? frame.y + 20 + row : frame.y + drawing - 11 - row}, name,
                 fmt::format("font-size=\"12.5\" font-weight=\"600\" fill=\"{}\"",
                             look::channel_colour(channel)));
    }
}

}  // namespace polyturn::supervisor
