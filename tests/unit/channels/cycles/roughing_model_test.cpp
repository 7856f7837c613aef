// G71, G72 and G73 against an area model: random contours of lines and arcs, type I and II,
// allowances along both axes.
//
//   s  in roughing direction from the contour's first point     G71: Z = -s, X radius = h
//   h  height towards the start point                           G72: X radius = 30 - s, Z = h - 20
//
// After roughing exactly the contour shifted by the allowance is left, within a micrometre, nothing
// was cut below it, no rapid went through stock, and the tool stands where it began. Depths and
// heights share a raster: levels lie on corners.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "../compensation/lathe_program.hpp"
#include "tests/property.hpp"

namespace polyturn::channels {
namespace {

using testing::Nose;
using testing::NoseRun;
using testing::run_lathe;
using testing::value_after;

struct At {
    double s, h;
};
// radius 0: a line
struct Part {
    At to;
    double radius = 0;
    bool left = false;
    std::vector<At> way;
};
constexpr double kTop = 20.0, kMicron = 0.001, kRelief = 3.0;
constexpr int kChords = 2'000, kCells = 300;

double distance(At a, At b) { return std::hypot(a.s - b.s, a.h - b.h); }

std::vector<At> arc_way(At from, At to, double radius, bool left) {
    const double chord = distance(from, to),
                 rise = std::sqrt(std::max(0.0, radius * radius - chord * chord / 4)),
                 turn = left ? 1 : -1;
    const At centre{(from.s + to.s) / 2 - turn * rise * (to.h - from.h) / chord,
                    (from.h + to.h) / 2 + turn * rise * (to.s - from.s) / chord};
    const double first = std::atan2(from.h - centre.h, from.s - centre.s);
    double sweep = std::atan2(to.h - centre.h, to.s - centre.s) - first;
    if (left && sweep < 0) sweep += 2 * std::numbers::pi;
    if (!left && sweep > 0) sweep -= 2 * std::numbers::pi;
    std::vector<At> way;
    for (int i = 1; i < kChords; ++i)
        way.push_back({centre.s + radius * std::cos(first + sweep * i / kChords),
                       centre.h + radius * std::sin(first + sweep * i / kChords)});
    way.push_back(to);
    return way;
}

struct Job {
    bool facing = false, pockets = false;
    int pattern = 0;                                        // divisions of G73; 0: G71 or G72
    double depth = 1, escape = 0.5, along = 0, across = 0;  // allowance against s, towards h
    At first{0, 5};
    std::vector<Part> parts;

    double z(At p) const { return facing ? p.h - 20 : -p.s; }
    double x(At p) const { return facing ? 60 - 2 * p.s : 2 * p.h; }  // diameter
    At back(double dia, double z_mm) const {
        return facing ? At{30 - dia / 2, z_mm + 20} : At{-z_mm, dia / 2};
    }
    bool left_there(bool left) const { return facing ? left : !left; }
    std::string program() const {
        char text[160];
        const double u = facing ? 2 * along : 2 * across, w = facing ? across : along;
        if (pattern)
            std::snprintf(text, sizeof text,
                          "G98\nG73 U%.1f W0 R%d\nG73 P10 Q99 U%.3f W%.3f F200\n", kRelief, pattern,
                          u, w);
        else
            std::snprintf(text, sizeof text,
                          "G98\nG7%d %c%.3f R%.3f\nG7%d P10 Q99 U%.3f W%.3f F200\n", facing ? 2 : 1,
                          facing ? 'W' : 'U', depth, escape, facing ? 2 : 1, u, w);
        std::string out = text;
        if (pockets || pattern)
            std::snprintf(text, sizeof text, "N10 G0 X%.4f Z%.4f\n", x(first), z(first));
        else if (facing)
            std::snprintf(text, sizeof text, "N10 G0 Z%.4f\n", z(first));
        else
            std::snprintf(text, sizeof text, "N10 G0 X%.4f\n", x(first));
        out += text;
        for (const Part& part : parts) {
            const char* block = &part == &parts.back() ? "N99 " : "";
            if (part.radius > 0)
                std::snprintf(text, sizeof text, "%sG%d X%.4f Z%.4f R%.4f\n", block,
                              left_there(part.left) ? 3 : 2, x(part.to), z(part.to), part.radius);
            else
                std::snprintf(text, sizeof text, "%sG1 X%.4f Z%.4f\n", block, x(part.to),
                              z(part.to));
            out += text;
        }
        return out;
    }
};

void judge(const Job& job) {
    const At start{0, kTop};
    const NoseRun run = run_lathe(job.program(), Nose{0.0, 0}, job.x(start), job.z(start));
    ASSERT_EQ(run.played.errors, 0u) << job.program() << run.played.events;
    std::vector<At> shape{{job.first.s - job.along, job.first.h + job.across}};
    for (const Part& part : job.parts)
        for (const At& p : part.way) shape.push_back({p.s - job.along, p.h + job.across});
    const double low = shape.front().s + 1e-3, high = shape.back().s - 1e-3;
    const auto at_cell = [&](int i) { return low + (high - low) * i / kCells; };
    struct Range {
        double lowest = 1e9, highest = -1e9;
    };
    const auto contour_at = [&](double s) {  // at a wall: from its foot to its head
        Range range;
        for (std::size_t k = 0; k + 1 < shape.size(); ++k) {
            const At &a = shape[k], &b = shape[k + 1];
            if (s < a.s - 1e-7 || s > b.s + 1e-7) continue;
            const double h = b.s - a.s < 1e-9 ? a.h : a.h + (b.h - a.h) * (s - a.s) / (b.s - a.s);
            range.lowest = std::min({range.lowest, h, b.s - a.s < 1e-9 ? b.h : h});
            range.highest = std::max({range.highest, h, b.s - a.s < 1e-9 ? b.h : h});
        }
        return range;
    };
    // G71, G72: a bar. G73: a casting that has the shape of the part and the relief on it.
    std::vector<double> stock(kCells + 1, kTop - 0.5);
    for (int i = 0; job.pattern && i <= kCells; ++i)
        stock[static_cast<std::size_t>(i)] =
            std::min(kTop - 0.5, contour_at(at_cell(i)).lowest + kRelief);
    At here = start;
    const auto pass = [&](At to, bool rapid, const std::string& line) {
        const double a = std::min(here.s, to.s) - 1e-7, b = std::max(here.s, to.s) + 1e-7;
        for (int i = 0; i <= kCells; ++i) {
            const double s = at_cell(i);
            if (s < a || s > b) continue;
            const double tip = b - a < 1e-6
                                   ? std::min(here.h, to.h)
                                   : here.h + (to.h - here.h) * (s - here.s) / (to.s - here.s);
            double& left = stock[static_cast<std::size_t>(i)];
            if (!rapid) left = std::min(left, tip);
            if (rapid) {
                ASSERT_LE(left - tip, kMicron) << "rapid through stock: " << line << job.program();
            }
        }
        here = to;
    };
    for (const testing::Point& point : run.points) {
        const At to = job.back(point.x, point.z);
        const bool cw = point.line.find("\"kind\":\"cw\"") != std::string::npos,
                   ccw = point.line.find("\"kind\":\"ccw\"") != std::string::npos;
        if (cw || ccw) {
            const bool left = job.facing ? ccw : cw;
            for (const At& p : arc_way(here, to, value_after(point.line, "\"radius\":"), left))
                pass(p, false, point.line);
        } else {
            pass(to, point.line.find("\"kind\":\"rapid\"") != std::string::npos, point.line);
        }
        if (::testing::Test::HasFatalFailure()) return;
    }
    for (int i = 0; i <= kCells; ++i) {
        const double s = at_cell(i);
        const auto [lowest, highest] = contour_at(s);
        const double left = stock[static_cast<std::size_t>(i)], top = kTop - 0.5;
        ASSERT_LE(left, std::min(highest, top) + kMicron) << "stock left at s " << s << "\n"
                                                          << job.program();
        ASSERT_GE(left, std::min(lowest, top) - kMicron) << "cut too deep at s " << s << "\n"
                                                         << job.program();
    }
    EXPECT_LT(distance(here, start), 1e-6);
}

PROPERTY(RoughingModel, LeavesTheAllowanceOnLinesAndArcs, ()) {
    Job job;
    job.pattern = *rc::gen::element(0, 0, 0, 1, 3);
    job.facing = !job.pattern && *rc::gen::arbitrary<bool>();
    job.pockets = !job.pattern && *rc::gen::arbitrary<bool>();
    job.depth = *rc::gen::element(0.5, 1.0, 1.3, 2.0, 3.5);
    job.escape = *rc::gen::element(0.3, 0.5, 1.0);
    job.across = *rc::gen::element(0.0, 0.2, 0.5);
    job.along = *rc::gen::element(0.0, 0.1, 0.3);
    job.first = {0, *rc::gen::inRange(10, 100) * 0.1};
    At at = job.first;
    const int count = *rc::gen::inRange(1, 8);
    for (int k = 0; k < count; ++k) {
        const double step = k + 1 == count ? *rc::gen::element(0.5, 1.0, 3.0)
                                           : *rc::gen::element(0.0, 0.5, 1.0, 2.5, 4.0);
        Part part;
        part.to = {at.s + step,
                   job.pockets ? *rc::gen::inRange(10, 186) * 0.1
                               : std::min(18.5, at.h + *rc::gen::element(0.0, 0.5, 1.0, 2.0, 3.5))};
        if (distance(part.to, at) == 0) part.to.s += 0.5;
        part.way = {part.to};
        // an arc where it keeps the direction that the cycle needs
        if (part.to.s > at.s && *rc::gen::arbitrary<bool>()) {
            Part arc = part;
            arc.radius = std::round(distance(part.to, at) *
                                    *rc::gen::element(0.51, 0.6, 0.8, 1.0, 1.6) * 1e4) /
                         1e4;
            arc.left = *rc::gen::arbitrary<bool>();
            arc.way = arc_way(at, part.to, arc.radius, arc.left);
            bool good = true;
            At before = at;
            for (const At& p : arc.way) {
                good = good && p.s >= before.s - 1e-9 && (job.pockets || p.h >= before.h - 1e-9) &&
                       p.h > 0 && p.h < 19;
                before = p;
            }
            if (good) part = arc;
        }
        at = part.to;
        job.parts.push_back(part);
    }
    judge(job);
    RC_ASSERT(!::testing::Test::HasFatalFailure());
}

}  // namespace
}  // namespace polyturn::channels
