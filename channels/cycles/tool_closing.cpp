#include "channels/cycles/tool_closing.hpp"

#include <cmath>
#include <numbers>

#include "channels/cycles/profile.hpp"

namespace polyturn::channels::cycles {
namespace {

constexpr double kStep = 0.02;      // mm of an arc that is judged as straight
constexpr double kSame = 1e-7;

struct Chain {
    std::vector<Level> points;
    std::vector<BlockContext> at;   // of the way that ends in the point
};

// Closes what falls more steeply than `slope` (height for each mm of way), in the order of s.
bool close(Chain& chain, double slope) {
    Chain out;
    bool changed = false;
    out.points.push_back(chain.points.front());
    out.at.push_back(chain.at.front());
    for (std::size_t i = 1; i < chain.points.size(); ++i) {
        const Level from = out.points.back(), to = chain.points[i];
        const double ds = to.s - from.s, fall = from.h - to.h;
        if (fall <= kSame || (ds > kSame && fall <= slope * ds + kSame)) {
            out.points.push_back(to);
            out.at.push_back(chain.at[i]);
            continue;
        }
        // From here a line at the flank's angle until it meets the contour again, or its end.
        changed = true;
        bool met = false;
        for (std::size_t k = i; k < chain.points.size() && !met; ++k) {
            const Level a = chain.points[k - 1], b = chain.points[k];
            const auto over = [&](Level p) { return p.h - (from.h - slope * (p.s - from.s)); };   // above the line
            const double x = over(a), y = over(b);
            if (k > i && x < 0 && y >= 0) {
                const double t = x / (x - y);
                const Level meet{a.s + t * (b.s - a.s), a.h + t * (b.h - a.h)};
                out.points.push_back(meet);
                out.at.push_back(chain.at[k]);
                i = k - 1;
                met = true;
            }
        }
        if (!met) {
            const Level last = chain.points.back();
            out.points.push_back({last.s, from.h - slope * (last.s - from.s)});
            out.at.push_back(chain.at.back());
            break;
        }
    }
    chain = std::move(out);
    return changed;
}

}  // namespace

Contour closed_for(const Contour& contour, bool facing, double s_sign, double h_sign, const Flanks& flanks, bool& changed) {
    changed = false;
    const bool descents = flanks.descent_deg < 90.0, ascents = flanks.ascent_deg < 90.0;
    if (!descents && !ascents) return contour;
    const Profile profile(contour, facing, s_sign, h_sign, {});
    Chain chain;
    chain.points.push_back(profile.first());
    chain.at.push_back(contour.first_block);
    for (const Piece& piece : profile.pieces()) {
        const BlockContext& at = contour.elements[piece.element].at;
        const double way = std::fabs(piece.to.h - piece.from.h);
        const int steps = piece.arc ? 1 + static_cast<int>(way / kStep) : 1;
        for (int k = 1; k < steps; ++k) {
            const double h = piece.from.h + (piece.to.h - piece.from.h) * k / steps;
            chain.points.push_back({piece.at_height(h), h});
            chain.at.push_back(at);
        }
        chain.points.push_back(piece.to);
        chain.at.push_back(at);
    }
    const auto slope = [](double deg) { return std::tan(deg * std::numbers::pi / 180.0); };
    if (descents) changed = close(chain, slope(flanks.descent_deg));
    if (ascents) {   // the same from the other end
        Chain back;
        for (std::size_t i = chain.points.size(); i-- > 0;) {
            back.points.push_back({-chain.points[i].s, chain.points[i].h});
            back.at.push_back(chain.at[i]);
        }
        if (close(back, slope(flanks.ascent_deg))) {
            changed = true;
            chain.points.clear();
            chain.at.clear();
            for (std::size_t i = back.points.size(); i-- > 0;) {
                chain.points.push_back({-back.points[i].s, back.points[i].h});
                chain.at.push_back(back.at[i]);
            }
        }
    }
    if (!changed) return contour;
    Contour out = contour;
    out.elements.clear();
    out.first = profile.point(chain.points.front());
    for (std::size_t i = 1; i < chain.points.size(); ++i) {
        Element e;
        e.from = profile.point(chain.points[i - 1]);
        e.to = profile.point(chain.points[i]);
        e.at = chain.at[i];
        if (std::hypot(e.to.z - e.from.z, e.to.x - e.from.x) > kSame) out.elements.push_back(e);
    }
    return out;
}

}  // namespace polyturn::channels::cycles
