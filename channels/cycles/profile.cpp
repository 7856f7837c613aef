#include "channels/cycles/profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polyturn::channels::cycles {
namespace {

constexpr double kOnContour = 1e-7;  // mm: a level on the contour
constexpr double kQuarter = std::numbers::pi / 2;

}  // namespace

double Piece::at_height(double h) const {
    double s = to.s;
    if (!arc) {
        if (to.h != from.h) s = from.s + (h - from.h) / (to.h - from.h) * (to.s - from.s);
    } else {
        const double rise = h - centre.h, square = radius * radius - rise * rise;
        s = centre.s +
            std::copysign(square > 0 ? std::sqrt(square) : 0.0, (from.s + to.s) / 2 - centre.s);
    }
    return std::clamp(s, std::fmin(from.s, to.s), std::fmax(from.s, to.s));
}

Level Profile::level(Point p) const {
    return facing_ ? Level{s_sign_ * p.x, h_sign_ * p.z} : Level{s_sign_ * p.z, h_sign_ * p.x};
}
Point Profile::point(Level l) const {
    return facing_ ? Point{h_sign_ * l.h, s_sign_ * l.s} : Point{s_sign_ * l.s, h_sign_ * l.h};
}

Profile::Profile(const Contour& contour, bool facing, double s_sign, double h_sign, Point offset)
    : facing_(facing), s_sign_(s_sign), h_sign_(h_sign) {
    first_ = level({contour.first.z + offset.z, contour.first.x + offset.x});
    for (std::size_t i = 0; i < contour.elements.size(); ++i) {
        const Element& element = contour.elements[i];
        if (element.form != Element::Form::Line) {
            add_arc(element, i, offset);
            continue;
        }
        Piece piece;
        piece.from = level({element.from.z + offset.z, element.from.x + offset.x});
        piece.to = level({element.to.z + offset.z, element.to.x + offset.x});
        piece.element = i;
        pieces_.push_back(piece);
    }
}

// An arc turns back at whole quarter turns only.
void Profile::add_arc(const Element& element, std::size_t index, Point offset) {
    const double a = element.first_angle, sweep = element.sweep;
    std::vector<double> cuts;  // angles inside the sweep
    for (int k = static_cast<int>(std::floor(std::fmin(a, a + sweep) / kQuarter));
         k * kQuarter < std::fmax(a, a + sweep) - 1e-9; ++k)
        if (k * kQuarter > std::fmin(a, a + sweep) + 1e-9) cuts.push_back(k * kQuarter);
    if (sweep < 0) std::reverse(cuts.begin(), cuts.end());
    const Point centre{element.centre.z + offset.z, element.centre.x + offset.x};
    Piece piece;
    piece.arc = true;
    piece.clockwise = element.form == Element::Form::ArcCw;
    piece.centre = level(centre);
    piece.radius = element.radius;
    piece.element = index;
    piece.from = level({element.from.z + offset.z, element.from.x + offset.x});
    for (const double angle : cuts) {
        piece.to = level({centre.z + element.radius * std::cos(angle),
                          centre.x + element.radius * std::sin(angle)});
        pieces_.push_back(piece);
        piece.from = piece.to;
    }
    piece.to = level({element.to.z + offset.z, element.to.x + offset.x});
    pieces_.push_back(piece);
}

double Profile::lowest() const {
    double h = first_.h;
    for (const Piece& piece : pieces_) h = std::fmin(h, piece.to.h);
    return h;
}

std::optional<std::size_t> Profile::runs_back(bool height, double tolerance) const {
    double highest = height ? first_.h : first_.s;
    for (const Piece& piece : pieces_) {
        const double value = height ? piece.to.h : piece.to.s;
        if (highest - value > tolerance + kOnContour) return piece.element;
        highest = std::fmax(highest, value);
    }
    return std::nullopt;
}

Opening Profile::whole() const {
    return {0, pieces_.empty() ? 0 : pieces_.size() - 1, first_.s, last().s, true, true};
}

std::vector<Opening> Profile::openings(double h, const Opening& within) const {
    std::vector<Opening> found;
    if (pieces_.empty()) return found;
    Opening now;
    // A flank piece may belong to two openings: only what lies inside [s1, s2] of this one counts.
    bool open = within.from_start && first_.h <= h + kOnContour;
    if (open) now = {0, 0, first_.s, 0, true, false};
    for (std::size_t i = within.first; i <= within.last; ++i) {
        const Piece& piece = pieces_[i];
        const bool low_before = piece.from.h <= h + kOnContour,
                   low_after = piece.to.h <= h + kOnContour;
        if (!low_before && low_after && !open) {
            now = {i, i, piece.at_height(std::fmax(h, piece.to.h)), 0, false, false};
            open = true;
        } else if (low_before && !low_after && open) {
            now.last = i;
            now.s2 = piece.at_height(std::fmax(h, piece.from.h));
            found.push_back(now);
            open = false;
        }
    }
    if (open) {
        now.last = within.last;
        now.s2 = within.to_end ? last().s : within.s2;
        now.to_end = within.to_end;
        found.push_back(now);
    }
    return found;
}

}  // namespace polyturn::channels::cycles
