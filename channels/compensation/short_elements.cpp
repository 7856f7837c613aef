// Elements that are shorter than the nose needs in an inner corner are left out: the nose's paths
// before and behind them meet (sinumerik_part2 11.4.2, 11.5).
//
//            n |             p  before_.back(): where it ends is not known yet
//              | . . .       s  block_: from the corner p/s to the corner s/n it would be driven
//        s ____|  .             backwards
//         |     .            n  the block that has come
//       p |   .
//
// So p ends where its equidistant meets that of n, or the arc round the corner s/n; s is not
// driven. Where p would be driven backwards then, it is left out in its turn.
//
// Calls behind an element that is left out are made at that point. The retract, and
// mirrored the approach, meet an element before the last one as ShortLast says.
#include <algorithm>

#include "channels/angles.hpp"
#include "channels/compensation/compensator.hpp"
#include "channels/compensation/interference.hpp"

namespace polyturn::channels::compensation {
namespace {

// times the nose's radius: longer ones do not wait for the block behind them. In a corner of 53
// degrees the nose takes two radii of an element at each end, in a sharper one more.
constexpr double kShort = 4.0;
constexpr std::size_t kDeepest = 16;  // so many wait at the most; memory of a block each

// The point of `on` that the nose passes first (last) of those where it meets `other`, within its
// normals or beyond them.
std::optional<Vec> meets_on(const Element& on, const Element& other, bool within_other, bool last) {
    const Crossings points = crossings(on, other);
    std::optional<Vec> found;
    for (int i = 0; i < points.count; ++i) {
        const Vec p = points.at[i];
        if (!on_nose_path(on, p) || (within_other && !on_nose_path(other, p))) continue;
        if (!found || (way_to(on, p) > way_to(on, *found)) == last) found = p;
    }
    return found;
}

// The circle of the nose's centre about a programmed point.
Element circle_about(Vec centre, double radius) {
    const Vec at = centre + Vec{radius, 0};
    Element e = arc(at, at, centre, kTurn);
    e.nose = 0;
    return e;
}

Element bare_line(Vec from, Vec to) {
    Element e = line(from, to);
    e.nose = 0;
    return e;
}

// Where the nose begins the k-th of the elements that wait, or with k == all.size() the one behind
// them, seen from its programmed start; `first`: where it begins the first of them.
template <class Waiting>
Vec begun(const std::vector<Waiting>& all, std::size_t k, Vec first, const Element& newest) {
    if (k == 0) return first;
    const Waiting& one = all[k - 1];
    return one.held.element.end + one.end.at[one.end.count - 1] -
           (k < all.size() ? all[k].held.element : newest).start;
}

// Where the nose may begin an element that follows one which ends at `point`: on its path, or
// beyond its end where it is short itself.
bool reached(const Element& next, Vec point, bool beyond) {
    return on_nose_path(next, point) || (beyond && !next.arc && way_to(next, point) > 0);
}

}  // namespace

// Everything that waits is driven as it looks now.
bool Compensator::release_before() {
    if (before_.empty()) return true;
    const Held newest = block_;
    HeldCalls later;
    later.append(trailing_);
    std::vector<Before> all;
    all.swap(before_);
    for (Before& one : all) {
        block_ = one.held;
        held_ = true;
        trailing_.append(one.trailing);
        if (!finish(one.end)) return false;
        follow(one.gap);
    }
    block_ = newest;
    held_ = true;
    trailing_.append(later);
    return true;
}

// What has been left out lies between the end of the last block and the next one: vectors are seen
// from the programmed point.
void Compensator::follow(Vec gap) {
    displacement_ = displacement_ - gap;
    for (unsigned i = 0; i < start_.count; ++i) start_.at[i] = start_.at[i] - gap;
}

bool Compensator::may_be_short(const Element& next) const {
    return !next.arc && length(next.end - next.start) < kShort * next.nose;
}

// Begun at an inner corner, `next` may be too short: the block behind it decides where the held
// element ends.
bool Compensator::waits(const Element& next, const CornerResult& corner) const {
    if (!options_.looks_back || corner.vectors.count != 1 || !may_be_short(next) ||
        before_.size() >= kDeepest)
        return false;
    if (block_.role == Role::Begin)
        return options_.short_last != ShortLast::None && options_.entry < Entry::Smooth;
    if (block_.role != Role::Contour || block_.element.side != next.side) return false;
    return classify(block_.element, next) == Turn::Inner;
}

// The held element is not driven: the one before it is held again, with its calls.
void Compensator::drop_held() {
    Before& one = before_.back();
    const Vec back = one.held.element.end - block_.element.end;
    // they are shifted from the other end later
    trailing_.change_moves([&](Move& m) { shift(m, back); });
    one.trailing.append(trailing_);
    block_ = one.held;
    trailing_.append(one.trailing);
    before_.pop_back();
}

// The approach ends on the first element that meets what lengthens the first of the contour.
bool Compensator::begin_beyond_short(const Element& next, CornerResult& corner, Vec& gap) {
    const Element in = before_.front().held.element;
    const Element s = first_               ? *first_
                      : before_.size() > 1 ? before_[1].held.element
                                           : block_.element;
    std::optional<Vec> point;
    const Vec square = s.start + s.nose * s.normal_at_start();
    if (options_.short_last == ShortLast::Circle)
        point = meets_on(next, circle_about(s.start, s.nose), false, true);
    else if (options_.short_last == ShortLast::Line)
        point = meets_on(next, s, false, true);
    else if (length(square - in.start) > 0)
        point = meets_on(next, bare_line(in.start, square), true, true);
    if (!point && !may_be_short(next)) return fail(Alarm::CompNoOffsetMeeting, false, block_.at);
    while (!before_.empty()) drop_held();
    if (!point) {  // the approach waits for an element farther on
        first_ = s;
        before_.push_back({block_, Vectors::one({}), {}, {}, 0});
        before_.back().trailing.append(trailing_);
        return true;
    }
    first_.reset();
    corner.vectors = Vectors::one(*point - block_.element.end);
    gap = next.start - block_.element.end;
    return true;
}

// Held elements that cannot be driven forwards between their neighbours are left
// out: the nearest element before them whose path meets the one behind them ends there.
bool Compensator::leave_out_short(const Element& next, CornerResult& corner, Vec& gap,
                                  unsigned& left_out) {
    if (first_) return begin_beyond_short(next, corner, gap);
    if (!interferes(block_.element,
                    begun(before_, before_.size(), start_.at[start_.count - 1], block_.element),
                    corner.vectors.at[0]))
        return true;
    const bool round = corner.vectors.count > 1 && corner.vectors.by_arc[1];
    if (!round && corner.vectors.count != 1) return true;
    const Vec about = block_.element.end, from = corner.vectors.at[0],
              to = round ? corner.vectors.at[1] : Vec{};
    unsigned count = 0;
    for (std::size_t k = before_.size(); k-- > 0;) {
        const Before& one = before_[k];
        const Element& p = one.held.element;
        if (one.held.role == Role::Begin) return begin_beyond_short(next, corner, gap);
        count += one.left_out + 1;
        if (count > options_.leaves_out) return true;  // treated as any other element
        std::optional<Vec> point;
        if (round) {
            Element way =
                arc(about + from, about + to, about, std::atan2(cross(from, to), dot(from, to)));
            way.nose = 0;
            point = meets_on(p, way, true, false);
        } else if (point = meets_on(p, next, false, false);
                   point && !reached(next, *point, may_be_short(next))) {
            point.reset();
        }
        if (!point || interferes(p, begun(before_, k, start_.at[start_.count - 1], block_.element),
                                 *point - p.end))
            continue;
        while (before_.size() > k) drop_held();
        left_out = count;
        corner.vectors = Vectors::one(*point - block_.element.end);
        gap = next.start - block_.element.end;
        if (round) corner.vectors.add(gap + to, true);
        return true;
    }
    return true;
}

// The last element is too short: an element before it ends where it meets the retract, the circle
// about the last programmed point or the last one's lengthened equidistant, and from there it goes
// straight out.
bool Compensator::leave_short_last(const Move& m, bool& left) {
    left = false;
    if (first_) return fail(Alarm::CompNoOffsetMeeting, false, block_.at);
    const Element s = block_.element;
    const Vec square = s.nose * s.normal_at_end();
    if (!interferes(s, begun(before_, before_.size(), start_.at[start_.count - 1], block_.element),
                    square))
        return true;
    const Vec out{m.machine[p_], m.machine[q_]};
    const bool circle = options_.short_last == ShortLast::Circle,
               travel_out = options_.short_last == ShortLast::TravelOut;
    if (travel_out && length(out - s.end - square) == 0)
        return fail(Alarm::CompNoOffsetMeeting, false, block_.at);
    const Element to = circle       ? circle_about(s.end, s.nose)
                       : travel_out ? bare_line(s.end + square, to_nose(line(s.start, out)).end)
                                    : s;
    std::optional<Vec> point;
    std::size_t on = before_.size();
    for (std::size_t k = before_.size(); k-- > 0;) {
        const Element& p = before_[k].held.element;
        if (before_[k].held.role != Role::Contour) break;
        const auto meets = meets_on(p, to, travel_out, false);
        if (!meets || interferes(p, begun(before_, k, start_.at[start_.count - 1], block_.element),
                                 *meets - p.end))
            continue;
        point = meets;
        on = k;
        if (!options_.farthest_meeting) break;
    }
    if (!point) return fail(Alarm::CompNoOffsetMeeting, false, block_.at);
    while (before_.size() > on) drop_held();
    const Vec end = block_.element.end;
    if (!finish(Vectors::one(*point - end))) return false;
    follow(s.end - end);
    left = true;
    return true;
}

}  // namespace polyturn::channels::compensation
