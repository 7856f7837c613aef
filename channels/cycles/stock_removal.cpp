#include "channels/cycles/stock_removal.hpp"

#include <cmath>
#include <string>

#include "channels/cycles/cycle_moves.hpp"
#include "channels/cycles/profile.hpp"

namespace polyturn::channels::cycles {
namespace {

constexpr double kSame = 1e-7;  // mm

class Roughing {
public:
    Roughing(CycleMoves& moves, const Contour& contour, const StockRemoval& cycle,
             const Profile& profile)
        : moves_(&moves),
          contour_(&contour),
          cycle_(&cycle),
          profile_(&profile),
          start_(profile.level(contour.start)),
          here_(start_) {}

    template <class Visit>
    bool each_pass(Visit&& visit) const;
    bool run();

private:
    // What a pass has left: its opening at its level; the passes below it start from there.
    struct Pass {
        Opening opening;
        int level = 0;
        bool follows_parent = false;  // nothing was driven between the pass above and this one
    };
    double height(int level) const {
        return level == 0 ? start_.h : start_.h - level * cycle_->depth;
    }
    bool to(Level level, bool rapid) {
        here_ = level;
        return rapid ? moves_->rapid(profile_->point(level))
                     : moves_->linear(profile_->point(level));
    }
    bool cut(const Pass& pass);
    bool follow(const Piece& piece, Level target);
    bool down_flank(const Pass& pass);
    bool up_flank(const Pass& pass);
    bool finish();

    CycleMoves* moves_;
    const Contour* contour_;
    const StockRemoval* cycle_;
    const Profile* profile_;
    Level start_, here_;
    // down to where the stock above the contour's first point is cut
    double open_height_ = start_.h;
};

// Along a piece up to a point on it.
bool Roughing::follow(const Piece& piece, Level target) {
    if (std::hypot(target.s - here_.s, target.h - here_.h) < kSame) return true;
    if (!piece.arc) return to(target, false);
    here_ = target;
    return moves_->arc(profile_->point(target), profile_->point(piece.centre), piece.clockwise,
                       cycle_->arc_tolerance);
}

// From the level above down along the contour to the beginning of the opening.
bool Roughing::down_flank(const Pass& pass) {
    const auto& pieces = profile_->pieces();
    const double above = height(pass.level - 1), level = height(pass.level);
    std::size_t top = pass.opening.first;  // back to the level above, or to the top of the flank
    while (pieces[top].from.h < above - kSame && top > 0 &&
           pieces[top - 1].from.h > pieces[top - 1].to.h + kSame)
        --top;
    Level entry = pieces[top].from;
    if (entry.h > above) entry = {pieces[top].at_height(above), above};
    if (!to({entry.s, here_.h}, true) || !to({entry.s, above}, true) || !to(entry, false))
        return false;
    for (std::size_t i = top; i < pass.opening.first; ++i)
        if (!follow(pieces[i], pieces[i].to)) return false;
    return follow(pieces[pass.opening.first],
                  {pass.opening.s1, std::fmax(level, pieces[pass.opening.first].to.h)});
}

// From the end of the opening up along the contour to the level above, or to the top of the flank.
bool Roughing::up_flank(const Pass& pass) {
    const auto& pieces = profile_->pieces();
    const double above = height(pass.level - 1);
    for (std::size_t i = pass.opening.last; i < pieces.size() && pieces[i].to.h > pieces[i].from.h;
         ++i) {
        const bool ends = pieces[i].to.h > above - kSame;
        if (!follow(pieces[i], ends ? Level{pieces[i].at_height(above), above} : pieces[i].to))
            return false;
        if (ends) break;
    }
    return true;
}

bool Roughing::cut(const Pass& pass) {
    const double level = height(pass.level);
    if (pass.opening.from_start) {
        if (!to({pass.opening.s1, here_.h}, true) ||
            !to({pass.opening.s1, level}, contour_->approach_rapid))
            return false;
        open_height_ = level;
    } else if (!down_flank(pass)) {
        return false;
    }
    if (!to({pass.opening.s2, level}, false)) return false;
    if (cycle_->pockets && !pass.opening.to_end && !up_flank(pass)) return false;
    const double back = std::fmin(cycle_->escape, std::fabs(pass.opening.s2 - pass.opening.s1));
    return to({here_.s - back, here_.h + cycle_->escape}, true);
}

// Once along the shifted contour, then back to the start without crossing the work.
bool Roughing::finish() {
    const Level first = profile_->first();
    if (cycle_->pockets && here_.h < start_.h && !to({here_.s, start_.h}, true)) return false;
    if (!to({first.s, here_.h}, true)) return false;
    // Stock may still be left above the first point of a contour with pockets: the last part is
    // cut.
    if (cycle_->pockets && contour_->approach_rapid &&
        !to({first.s, std::fmax(first.h, open_height_)}, true))
        return false;
    if (!to(first, contour_->approach_rapid && !cycle_->pockets)) return false;
    for (const Piece& piece : profile_->pieces())
        if (!follow(piece, piece.to)) return false;
    const double clear = std::fmax(start_.h, here_.h);
    return to({here_.s, clear}, true) && to({start_.s, clear}, true) && to(start_, true);
}

// Each pass in the order in which it is cut: a pocket to its floor before the next. The visitor's
// false ends it.
template <class Visit>
bool Roughing::each_pass(Visit&& visit) const {
    const double lowest = profile_->lowest();
    const double total = start_.h - lowest;
    const int levels =
        total > kSame ? static_cast<int>(std::ceil((total - kSame) / cycle_->depth)) - 1 : 0;
    std::vector<Pass> open;  // depth first
    const auto push = [&](int level, const Opening& within) {
        if (level > levels) return;
        std::vector<Opening> found = profile_->openings(height(level), within);
        if (!cycle_->pockets && found.size() > 1) found.resize(1);
        // The one to be cut first goes on top.
        for (std::size_t k = 0; k < found.size(); ++k) {
            const std::size_t i = cycle_->first_pocket_first ? found.size() - 1 - k : k;
            open.push_back({found[i], level, k + 1 == found.size()});
        }
    };
    push(1, profile_->whole());
    while (!open.empty()) {
        const Pass pass = open.back();
        open.pop_back();
        if (!visit(pass)) return false;
        push(pass.level + 1, pass.opening);
    }
    return true;
}

bool Roughing::run() {
    int passes = 0;  // with pockets they are counted before the first move
    if (cycle_->pockets && !each_pass([&](const Pass&) { return ++passes <= kMostPasses; }))
        return moves_->core().fail(Alarm::CycleValueIllegal, cycle_->depth_letter,
                                   std::string(1, cycle_->depth_letter), cycle_->depth);
    return each_pass([this](const Pass& pass) {
               return (pass.follows_parent || here_.h >= start_.h ||
                       to({here_.s, start_.h}, true)) &&
                      cut(pass);
           }) &&
           finish();
}

bool fail_at(Core& core, Alarm alarm, const BlockContext& at, std::string detail) {
    core.fail(alarm, 0, std::move(detail));
    Fault fault = core.fault();
    fault.block = at;
    core.set_fault(std::move(fault));
    return false;
}

}  // namespace

bool remove_stock(Core& core, const Contour& contour, const StockRemoval& cycle) {
    CycleMoves moves(core);
    if (!moves.ready()) return false;
    const std::string roughing = cycle.facing ? "X" : "Z", cutting = cycle.facing ? "Z" : "X";
    if (!(cycle.depth > 0))
        return core.fail(Alarm::CycleValueIllegal, cycle.depth_letter,
                         std::string(1, cycle.depth_letter), cycle.depth);
    const auto along = [&](Point p) { return cycle.facing ? p.x : p.z; };
    const auto up = [&](Point p) { return cycle.facing ? p.z : p.x; };
    const double s_way = along(contour.end()) - along(contour.first);
    if (contour.elements.empty() || std::fabs(s_way) < kSame)
        return fail_at(core, Alarm::ContourEmpty, contour.first_block, roughing);
    // The work lies where the contour leaves the start point.
    double below = 0.0, above = 0.0;
    const auto look = [&](Point p) {
        below = std::fmax(below, up(contour.start) - up(p));
        above = std::fmax(above, up(p) - up(contour.start));
    };
    look(contour.first);
    for (const Element& element : contour.elements) look(element.to);
    const Profile profile(contour, cycle.facing, s_way > 0 ? 1.0 : -1.0,
                          below >= above ? 1.0 : -1.0, cycle.allowance);
    if (const auto at = profile.runs_back(false, cycle.roughing_tolerance))
        return fail_at(core, Alarm::ContourNotMonotone, contour.elements[*at].at, roughing);
    if (!cycle.pockets)
        if (const auto at =
                profile.runs_back(true, std::fmin(cycle.cutting_tolerance, cycle.depth)))
            return fail_at(core, Alarm::ContourNotMonotone, contour.elements[*at].at, cutting);
    if (std::fmax(below, above) / cycle.depth > kMostPasses)
        return core.fail(Alarm::CycleValueIllegal, cycle.depth_letter,
                         std::string(1, cycle.depth_letter), cycle.depth);
    return Roughing(moves, contour, cycle, profile).run();
}

bool repeat_pattern(Core& core, const Contour& contour, const Pattern& cycle) {
    CycleMoves moves(core);
    if (!moves.ready()) return false;
    if (cycle.passes < 1 || cycle.passes > kMostPasses)
        return core.fail(Alarm::CycleValueIllegal, 'R', "R", cycle.passes);
    if (contour.elements.empty())
        return fail_at(core, Alarm::ContourEmpty, contour.first_block, "");
    const auto shifted = [](Point p, Point by) { return Point{p.z + by.z, p.x + by.x}; };
    Point highest = contour.start;  // rapid goes back beyond the contour, on the side of the start
    const double side = contour.start.x >= contour.first.x ? 1.0 : -1.0;
    for (const Element& element : contour.elements)
        if (side * element.to.x > side * highest.x) highest.x = element.to.x;
    for (int pass = 1; pass <= cycle.passes; ++pass) {
        const double share = static_cast<double>(cycle.passes - pass) / cycle.divisor;
        const Point offset{cycle.relief.z * share + cycle.allowance.z,
                           cycle.relief.x * share + cycle.allowance.x};
        if (!moves.rapid(shifted(contour.start, offset))) return false;
        const Point first = shifted(contour.first, offset);
        if (!(contour.approach_rapid ? moves.rapid(first) : moves.linear(first))) return false;
        Point here = first;
        for (const Element& element : contour.elements) {
            here = shifted(element.to, offset);
            const bool good =
                element.form == Element::Form::Line
                    ? moves.linear(here)
                    : moves.arc(here, shifted(element.centre, offset),
                                element.form == Element::Form::ArcCw, cycle.arc_tolerance);
            if (!good) return false;
        }
        const double clear = side * std::fmax(side * here.x, side * (highest.x + offset.x));
        if (!moves.rapid({here.z, clear}) || !moves.rapid({contour.start.z + offset.z, clear}))
            return false;
    }
    return moves.rapid(contour.start);
}

}  // namespace polyturn::channels::cycles
