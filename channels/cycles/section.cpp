#include "channels/cycles/section.hpp"

#include <algorithm>
#include <cmath>

#include "channels/cycles/cycle_moves.hpp"
#include "channels/cycles/stock_removal.hpp"

namespace polyturn::channels::cycles {
namespace {

constexpr double kSameSection = 1e-9;  // mm

// Coordinates of the cycle: s along the passes, h in the direction of the infeed, as the axes have
// them.
struct Frame2 {
    bool facing;
    double s(Point p) const { return facing ? p.x : p.z; }
    double h(Point p) const { return facing ? p.z : p.x; }
    Point point(double along, double height) const {
        return facing ? Point{height, along} : Point{along, height};
    }
};

class Cutting {
public:
    Cutting(CycleMoves& moves, const Section& section, Point call)
        : moves_(&moves), section_(&section), frame_{section.facing}, call_(call) {
        sx_ = call.x >= section.start.x ? 1.0 : -1.0;
        sz_ = call.z >= section.start.z ? 1.0 : -1.0;
        shift_ = {sz_ * std::fabs(section.allowance.z), sx_ * std::fabs(section.allowance.x)};
        start_ = shifted(section.start, shift_);
        end_ = shifted(section.end, shift_);
        centre_ = shifted(section.centre, shift_);
        const double cross =
            (section.start.z - section.centre.z) * (section.end.x - section.centre.x) -
            (section.start.x - section.centre.x) * (section.end.z - section.centre.z);
        clockwise_ = cross < 0;
    }

    bool run() {
        const Section& c = *section_;
        const double up = c.facing ? sz_ : sx_;
        const double top = up * frame_.h(call_), total = top - up * frame_.h(start_);
        const int passes =
            total > kSameSection ? static_cast<int>(std::ceil(total / c.most - 1e-9)) : 0;
        if (passes > kMostPasses)
            return moves_->core().fail(Alarm::CycleValueIllegal, 'C', "C", c.most);
        const double step = passes ? total / passes : 0.0, back = frame_.s(call_);
        double above = top;
        for (int k = 1; k <= passes; ++k) {
            const double level = k == passes ? top - total : top - k * step;
            const double h = up * level, s = meet(h);
            if (!rapid(back, h) || !linear(s, h)) return false;
            if (c.retract == Retract::Oblique) {
                const double away = frame_.s(Point{sz_, sx_}) * c.safety;
                if (!rapid(s + away, h + up * c.safety)) return false;
                if (!rapid(back, h + up * c.safety)) return false;
            } else if (c.retract == Retract::Same) {
                if (!rapid(back, h)) return false;
            } else {
                const double to = up * std::fmin(above, up * frame_.h(end_));
                if (up * to > level + kSameSection && !follow(to)) return false;
                if (up * to < above - kSameSection && !rapid(frame_.s(moves_->here()), up * above))
                    return false;
                if (!rapid(back, up * above)) return false;
            }
            above = level;
        }
        Core& core = moves_->core();
        const double feed = core.path.feed;
        if (c.roughing_feed > 0 && !pass_along(start_, end_, centre_, c.roughing_feed))
            return false;
        if (c.finishing_feed > 0 && !pass_along(c.start, c.end, c.centre, c.finishing_feed))
            return false;
        core.path.feed = feed;
        return home();
    }

private:
    static Point shifted(Point p, Point by) { return {p.z + by.z, p.x + by.x}; }
    bool rapid(double s, double h) { return moves_->rapid(frame_.point(s, h)); }
    bool linear(double s, double h) { return moves_->linear(frame_.point(s, h)); }

    // Where the pass at height h ends: on the section with its allowance, beyond its end at the
    // level of the end.
    double meet(double h) const {
        const double h0 = frame_.h(start_), h1 = frame_.h(end_);
        const double lo = std::fmin(h0, h1), hi = std::fmax(h0, h1);
        if (std::fabs(h1 - h0) < kSameSection || (h - h1) * (h1 - h0) >= 0) return frame_.s(end_);
        if ((h - h0) * (h0 - h1) >= 0) return frame_.s(start_);
        if (!section_->arc)
            return frame_.s(start_) + (h - h0) / (h1 - h0) * (frame_.s(end_) - frame_.s(start_));
        const double radius = std::hypot(start_.z - centre_.z, start_.x - centre_.x);
        const double rise = std::clamp(h, lo, hi) - frame_.h(centre_),
                     square = radius * radius - rise * rise;
        const double root = square > 0 ? std::sqrt(square) : 0.0, c = frame_.s(centre_);
        // Of the two points of the circle the one on the arc that is used: between its ends, seen
        // from the centre.
        const double middle = (frame_.s(start_) + frame_.s(end_)) / 2;
        return std::fabs(c + root - middle) < std::fabs(c - root - middle) ? c + root : c - root;
    }

    bool follow(double h) {
        const double s = meet(h);
        if (!section_->arc) return linear(s, h);
        return moves_->arc(frame_.point(s, h), centre_, clockwise_, section_->arc_tolerance);
    }

    bool pass_along(Point from, Point to, Point centre, double feed) {
        const double clear = frame_.s(call_);
        if (!moves_->rapid(frame_.point(clear, frame_.h(moves_->here()))) ||
            !moves_->rapid(frame_.point(clear, frame_.h(from))))
            return false;
        // Compensation that was programmed before the cycle acts on these passes.
        Core& core = moves_->core();
        core.end_cycle();
        core.path.feed = feed;
        if (!moves_->linear(from)) return false;
        if (!(section_->arc ? moves_->arc(to, centre, clockwise_, section_->arc_tolerance)
                            : moves_->linear(to)))
            return false;
        const bool good = rapid(frame_.s(to), frame_.h(call_)) && moves_->rapid(call_);
        core.begin_cycle(Core::CycleMoves::Shifted);
        return good;
    }

    bool home() {
        if (std::fabs(frame_.s(moves_->here()) - frame_.s(call_)) > kSameSection &&
            !rapid(frame_.s(call_), frame_.h(moves_->here())))
            return false;
        return moves_->rapid(call_);
    }

    CycleMoves* moves_;
    const Section* section_;
    Frame2 frame_;
    Point call_, shift_, start_, end_, centre_;
    double sx_ = 1.0, sz_ = 1.0;
    bool clockwise_ = false;
};

}  // namespace

bool cut_section(Core& core, const Section& section) {
    CycleMoves moves(core);
    if (!moves.ready()) return false;
    if (!(section.most > 0)) return core.fail(Alarm::CycleValueIllegal, 'C', "C", section.most);
    return Cutting(moves, section, moves.here()).run();
}

}  // namespace polyturn::channels::cycles
