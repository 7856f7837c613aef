#include "channels/cycles/profile_roughing.hpp"

#include <algorithm>
#include <cmath>

#include "channels/cycles/contour_offset.hpp"
#include "channels/cycles/cycle_moves.hpp"
#include "channels/cycles/profile.hpp"
#include "channels/cycles/stock_removal.hpp"

namespace polyturn::channels::cycles {
namespace {

constexpr double kSameLevel = 1e-7;  // mm

// One pass along a contour at a feed, from the call point and back to it.
class Along {
public:
    Along(CycleMoves& moves, double tolerance) : moves_(&moves), tolerance_(tolerance) {}

    bool elements(const Contour& contour) {
        for (const Element& e : contour.elements) {
            const bool good =
                e.form == Element::Form::Line
                    ? moves_->linear(e.to)
                    : moves_->arc(e.to, e.centre, e.form == Element::Form::ArcCw, tolerance_);
            if (!good) return false;
        }
        return true;
    }

    bool finish(const Contour& part, Point call, double feed, bool square, bool x_first) {
        Core& core = moves_->core();
        const double before = core.path.feed;
        const bool exact = core.path.exact_stop_mode, nose = core.path.tool.nose_radius != 0.0;
        core.end_cycle();
        core.path.feed = feed;
        core.path.exact_stop_mode = square;
        if (nose && !core.compensation(side_towards(part, call, x_first) > 0 ? CompSide::Left
                                                                             : CompSide::Right))
            return false;
        const Point beside = x_first ? Point{call.z, part.first.x} : Point{part.first.z, call.x};
        bool good = moves_->rapid(beside) && moves_->linear(part.first) && elements(part);
        if (good && nose) good = core.compensation_off(0.0, 0.0);
        const Point here = part.end();
        good = good && moves_->rapid(x_first ? Point{here.z, call.x} : Point{call.z, here.x}) &&
               moves_->rapid(call);
        core.path.exact_stop_mode = exact;
        core.path.feed = before;
        return good;
    }

private:
    CycleMoves* moves_;
    double tolerance_;
};

class ProfilePasses {
public:
    ProfilePasses(CycleMoves& moves, Point call, const ProfileRoughing& cycle,
                  const Profile& profile, const Profile* blank)
        : moves_(&moves),
          cycle_(&cycle),
          profile_(&profile),
          blank_(blank),
          call_(profile.level(call)),
          here_(call_) {}

    bool run() {
        double top = call_.h;
        if (blank_) {
            top = blank_->first().h;
            for (const Piece& piece : blank_->pieces())
                top = std::fmax(top, std::fmax(piece.from.h, piece.to.h));
        }
        const double lowest = profile_->lowest();
        if ((top - lowest) / cycle_->depth > kMostPasses)
            return moves_->core().fail(Alarm::CycleValueIllegal, 'C', "C", cycle_->depth);
        levels_.push_back(top);
        while (levels_.back() - cycle_->depth > lowest + kSameLevel)
            levels_.push_back(levels_.back() - cycle_->depth);
        if (levels_.back() > lowest + kSameLevel) levels_.push_back(lowest);
        const Opening whole = profile_->whole();
        std::vector<Opening> before;
        struct Root {
            Opening opening;
            std::size_t level;
        };
        std::vector<Root> hollows;
        for (std::size_t k = 1; k < levels_.size(); ++k) {
            std::vector<Opening> found = profile_->openings(levels_[k], whole);
            std::vector<Opening> apart;
            for (const Opening& opening : found) {
                if (opening.from_start) {
                    if (!main_pass(opening, k)) return false;
                    continue;
                }
                const bool inside =
                    std::any_of(before.begin(), before.end(), [&](const Opening& o) {
                        return o.s1 <= opening.s1 + kSameLevel && o.s2 >= opening.s2 - kSameLevel;
                    });
                if (!inside) hollows.push_back({opening, k});
                apart.push_back(opening);
            }
            before = std::move(apart);
        }
        for (const Root& root : hollows)
            if (!hollow(root.opening, root.level)) return false;
        return true;
    }

    bool home() {
        if (here_.h < call_.h - kSameLevel && !to({here_.s, call_.h}, true)) return false;
        return to(call_, true);
    }
    void stands_at(Level level) { here_ = level; }

private:
    bool to(Level level, bool rapid) {
        here_ = level;
        return rapid ? moves_->rapid(profile_->point(level))
                     : moves_->linear(profile_->point(level));
    }

    bool follow(const Piece& piece, Level target) {
        if (std::hypot(target.s - here_.s, target.h - here_.h) < kSameLevel) return true;
        if (!piece.arc) return to(target, false);
        here_ = target;
        return moves_->arc(profile_->point(target), profile_->point(piece.centre), piece.clockwise,
                           cycle_->arc_tolerance);
    }

    // Where there is stock at this height; nothing where the blank is lower.
    bool stock(double h, double& from, double& to) const {
        if (!blank_) return true;
        bool any = false;
        double first = 0.0, last = 0.0;
        const auto see = [&](double s) {
            first = any ? std::fmin(first, s) : s;
            last = any ? std::fmax(last, s) : s;
            any = true;
        };
        for (const Piece& piece : blank_->pieces()) {
            // its surface at most: nothing above it to cut
            if (std::fmax(piece.from.h, piece.to.h) <= h + kSameLevel) continue;
            if (piece.from.h >= h - kSameLevel) see(piece.from.s);
            if (piece.to.h >= h - kSameLevel) see(piece.to.s);
            if ((piece.from.h - h) * (piece.to.h - h) < 0) see(piece.at_height(h));
        }
        if (!any) return false;
        from = std::fmax(from, first);
        to = std::fmin(to, last);
        return from < to - kSameLevel;
    }

    bool main_pass(const Opening& opening, std::size_t k) {
        const double h = levels_[k];
        double from = call_.s, end = opening.s2;
        if (!stock(h, from, end)) return true;
        const bool reaches = end > opening.s2 - kSameLevel;
        if (!to({call_.s, h}, true)) return false;
        if (from > call_.s + kSameLevel && !to({from, h}, true)) return false;
        if (!to({end, h}, false)) return false;
        return leave(opening, k, end, reaches) && to({call_.s, here_.h}, true);
    }

    // From the end of a pass away from the contour, by the rule that D has chosen.
    bool leave(const Opening& opening, std::size_t k, double end, bool at_contour) {
        const double h = levels_[k];
        if (cycle_->retract == Retract::Oblique) {
            // the flank where it came in
            const double away =
                opening.from_start ? cycle_->safety : std::fmin(cycle_->safety, end - opening.s1);
            return away < kSameLevel || to({end - away, h + away}, true);
        }
        if (cycle_->retract == Retract::Same)
            return to({std::fmax(opening.from_start ? call_.s : opening.s1, call_.s), h}, true);
        const double above = levels_[k - 1];
        if (!at_contour || opening.to_end) return to({end, above}, true);
        return up_flank(opening, above);
    }

    bool up_flank(const Opening& opening, double above) {
        const auto& pieces = profile_->pieces();
        for (std::size_t i = opening.last;
             i < pieces.size() && pieces[i].to.h > pieces[i].from.h - kSameLevel; ++i) {
            const bool ends = pieces[i].to.h > above - kSameLevel;
            if (!follow(pieces[i], ends ? Level{pieces[i].at_height(above), above} : pieces[i].to))
                return false;
            if (ends) break;
        }
        return here_.h >= above - kSameLevel || to({here_.s, above}, true);
    }

    bool down_flank(const Opening& opening, double above, double level) {
        const auto& pieces = profile_->pieces();
        std::size_t top = opening.first;
        while (pieces[top].from.h < above - kSameLevel && top > 0 &&
               pieces[top - 1].from.h > pieces[top - 1].to.h + kSameLevel)
            --top;
        Level entry = pieces[top].from;
        if (entry.h > above) entry = {pieces[top].at_height(above), above};
        if (here_.h < call_.h - kSameLevel && !to({here_.s, call_.h}, true)) return false;
        if (!to({entry.s, call_.h}, true) || !to(entry, true)) return false;
        Core& core = moves_->core();
        const double feed = core.path.feed;
        if (cycle_->plunge_feed > 0) core.path.feed = cycle_->plunge_feed;
        bool good = true;
        for (std::size_t i = top; good && i < opening.first; ++i)
            good = follow(pieces[i], pieces[i].to);
        good = good && follow(pieces[opening.first],
                              {opening.s1, std::fmax(level, pieces[opening.first].to.h)});
        core.path.feed = feed;
        return good;
    }

    bool hollow(const Opening& opening, std::size_t k) {
        if (++passes_ > kMostPasses)
            return moves_->core().fail(Alarm::CycleValueIllegal, 'C', "C", cycle_->depth);
        const double level = levels_[k], above = levels_[k - 1];
        double from = opening.s1, end = opening.s2;
        if (stock(level, from, end)) {
            if (!down_flank(opening, above, level) || !to({opening.s2, level}, false) ||
                !leave(opening, k, opening.s2, true))
                return false;
            if (!to({here_.s, call_.h}, true)) return false;
        }
        if (k + 1 == levels_.size()) return true;
        const std::vector<Opening> below = profile_->openings(levels_[k + 1], opening);
        for (const Opening& inner : below)
            if (!hollow(inner, k + 1)) return false;
        if (!below.empty()) return true;
        // The floor lies between two levels: a last pass on it.
        double floor = level;
        for (std::size_t i = opening.first; i <= opening.last; ++i) {
            if (i > opening.first) floor = std::fmin(floor, profile_->pieces()[i].from.h);
            if (i < opening.last) floor = std::fmin(floor, profile_->pieces()[i].to.h);
        }
        if (floor > level - kSameLevel) return true;
        const std::vector<Opening> bottom = profile_->openings(floor, opening);
        for (const Opening& inner : bottom) {
            levels_.insert(levels_.begin() + static_cast<std::ptrdiff_t>(k) + 1, floor);
            const bool good = down_flank(inner, level, floor) && to({inner.s2, floor}, false) &&
                              leave(inner, k + 1, inner.s2, true) && to({here_.s, call_.h}, true);
            levels_.erase(levels_.begin() + static_cast<std::ptrdiff_t>(k) + 1);
            if (!good) return false;
        }
        return true;
    }

    CycleMoves* moves_;
    const ProfileRoughing* cycle_;
    const Profile* profile_;
    const Profile* blank_;
    Level call_, here_;
    std::vector<double> levels_;  // [0] is the top of the stock
    int passes_ = 0;
};

}  // namespace

bool rough_profile(Core& core, const Contour& part, const Contour& allowed, const Contour* blank,
                   const ProfileRoughing& cycle) {
    CycleMoves moves(core);
    if (!moves.ready()) return false;
    const Point call = moves.here();
    const auto along = [&](Point p) { return cycle.facing ? p.x : p.z; };
    const auto up = [&](Point p) { return cycle.facing ? p.z : p.x; };
    double below = 0.0, above = 0.0;
    const auto look = [&](Point p) {
        below = std::fmax(below, up(call) - up(p));
        above = std::fmax(above, up(p) - up(call));
    };
    look(allowed.first);
    for (const Element& e : allowed.elements) look(e.to);
    const double s_sign = along(part.end()) > along(call) ? 1.0 : -1.0,
                 h_sign = below >= above ? 1.0 : -1.0;
    const Profile profile(allowed, cycle.facing, s_sign, h_sign, {});
    std::optional<Profile> stock;
    if (blank) stock.emplace(*blank, cycle.facing, s_sign, h_sign, Point{});
    ProfilePasses roughing(moves, call, cycle, profile, stock ? &*stock : nullptr);
    if (!roughing.run()) return false;
    Along pass(moves, cycle.arc_tolerance);
    if (cycle.semi_feed > 0) {
        const double feed = core.path.feed;
        const Level first = profile.level(allowed.first), level = profile.level(call);
        if (!moves.rapid(
                profile.point({level.s, std::fmax(first.h, profile.level(moves.here()).h)})) ||
            !moves.rapid(profile.point({level.s, first.h})))
            return false;
        core.path.feed = cycle.semi_feed;
        if (!moves.linear(allowed.first) || !pass.elements(allowed)) return false;
        core.path.feed = feed;
        roughing.stands_at(profile.level(allowed.end()));
    }
    if (!roughing.home()) return false;
    return cycle.finishing_feed <= 0 ||
           pass.finish(part, call, cycle.finishing_feed, cycle.finishing_square, !cycle.facing);
}

bool repeat_profile(Core& core, const Contour& part, const ProfileRepeat& cycle) {
    CycleMoves moves(core);
    if (!moves.ready()) return false;
    const Point call = moves.here();
    Along pass(moves, cycle.arc_tolerance);
    for (const Contour& contour : cycle.passes) {
        if (!moves.rapid(contour.first) || !pass.elements(contour)) return false;
        const Point end = contour.end();
        // Back without crossing the part: first away from it, then to the call point.
        const Point clear = cycle.along_x ? Point{end.z, call.x} : Point{call.z, end.x};
        if (!moves.rapid(clear) || !moves.rapid(call)) return false;
    }
    return cycle.finishing_feed <= 0 ||
           pass.finish(part, call, cycle.finishing_feed, cycle.finishing_square, cycle.along_x);
}

}  // namespace polyturn::channels::cycles
