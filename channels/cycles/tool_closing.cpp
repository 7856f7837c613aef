#include "channels/cycles/tool_closing.hpp"

#include <cmath>
#include <numbers>

#include "channels/cycles/profile.hpp"

namespace polyturn::channels::cycles {
namespace {

constexpr double kStep = 0.02;  // mm of an arc that is taken for straight
constexpr double kSameTool = 1e-7;

constexpr std::size_t kNoArc = ~std::size_t{0};

struct Way {
    BlockContext at;
    std::size_t arc = kNoArc;  // element of the contour, where the way is a chord of it
};

// An arc is checked by its chords; where nothing closes it, it stays the arc that it was.
struct Chain {
    std::vector<Level> points;
    std::vector<Way> ways;  // that end in the points

    void add(Level point, const Way& way) {
        points.push_back(point);
        ways.push_back(way);
    }
    // The same from the other end.
    Chain reversed() const {
        Chain back;
        for (std::size_t i = points.size(); i-- > 0;)
            back.add({-points[i].s, points[i].h}, i + 1 < ways.size() ? ways[i + 1] : ways[i]);
        return back;
    }
};

// Closes what falls more steeply than `slope` (height for each mm of travel), in the order of s.
bool close(Chain& chain, double slope) {
    Chain out;
    bool changed = false;
    out.add(chain.points.front(), chain.ways.front());
    for (std::size_t i = 1; i < chain.points.size(); ++i) {
        const Level from = out.points.back(), to = chain.points[i];
        const double ds = to.s - from.s, fall = from.h - to.h;
        if (fall <= kSameTool || (ds > kSameTool && fall <= slope * ds + kSameTool)) {
            out.add(to, chain.ways[i]);
            continue;
        }
        // From here a line at the flank's angle until it meets the contour again, or its end.
        changed = true;
        bool met = false;
        for (std::size_t k = i; k < chain.points.size() && !met; ++k) {
            const Level a = chain.points[k - 1], b = chain.points[k];
            // above the line
            const auto over = [&](Level p) { return p.h - (from.h - slope * (p.s - from.s)); };
            const double x = over(a), y = over(b);
            if (k > i && x < 0 && y >= 0) {
                const double t = x / (x - y);
                const Level meet{a.s + t * (b.s - a.s), a.h + t * (b.h - a.h)};
                out.add(meet, {chain.ways[k].at});
                i = k - 1;
                met = true;
            }
        }
        if (!met) {
            const Level last = chain.points.back();
            out.add({last.s, from.h - slope * (last.s - from.s)}, {chain.ways.back().at});
            break;
        }
    }
    chain = std::move(out);
    return changed;
}

}  // namespace

Contour closed_for(const Contour& contour, bool facing, double s_sign, double h_sign,
                   const Flanks& flanks, bool& changed) {
    changed = false;
    const bool descents = flanks.descent_deg < 90.0, ascents = flanks.ascent_deg < 90.0;
    if (!descents && !ascents) return contour;
    const Profile profile(contour, facing, s_sign, h_sign, {});
    Chain chain;
    chain.add(profile.first(), {contour.first_block});
    for (const Piece& piece : profile.pieces()) {
        const Way way{contour.elements[piece.element].at, piece.arc ? piece.element : kNoArc};
        const double rise = std::fabs(piece.to.h - piece.from.h);
        const int steps = piece.arc ? 1 + static_cast<int>(rise / kStep) : 1;
        for (int k = 1; k < steps; ++k) {
            const double h = piece.from.h + (piece.to.h - piece.from.h) * k / steps;
            chain.add({piece.at_height(h), h}, way);
        }
        chain.add(piece.to, way);
    }
    const auto slope = [](double deg) { return std::tan(deg * std::numbers::pi / 180.0); };
    if (descents) changed = close(chain, slope(flanks.descent_deg));
    if (ascents) {
        Chain back = chain.reversed();
        if (close(back, slope(flanks.ascent_deg))) {
            changed = true;
            chain = back.reversed();
        }
    }
    if (!changed) return contour;
    Contour out = contour;
    out.elements.clear();
    out.first = profile.point(chain.points.front());
    for (std::size_t i = 1; i < chain.points.size(); ++i) {
        const Way& way = chain.ways[i];
        Element e;
        if (way.arc != kNoArc) e = contour.elements[way.arc];
        e.from = profile.point(chain.points[i - 1]);
        while (way.arc != kNoArc && i + 1 < chain.points.size() && chain.ways[i + 1].arc == way.arc)
            ++i;
        e.to = profile.point(chain.points[i]);
        e.at = way.at;
        if (std::hypot(e.to.z - e.from.z, e.to.x - e.from.x) <= kSameTool) continue;
        if (way.arc != kNoArc) {
            e.first_angle = std::atan2(e.from.x - e.centre.x, e.from.z - e.centre.z);
            e.sweep =
                std::remainder(std::atan2(e.to.x - e.centre.x, e.to.z - e.centre.z) - e.first_angle,
                               2 * std::numbers::pi);
            if (e.form == Element::Form::ArcCcw && e.sweep < 0) e.sweep += 2 * std::numbers::pi;
            if (e.form == Element::Form::ArcCw && e.sweep > 0) e.sweep -= 2 * std::numbers::pi;
        }
        out.elements.push_back(e);
    }
    return out;
}

}  // namespace polyturn::channels::cycles
