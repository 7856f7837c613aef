#include "channels/path/path_maker.hpp"

#include <algorithm>
#include <limits>

#include "channels/path/quintic.hpp"
#include "ipc/diagnosis/assert.hpp"

namespace polyturn::channels {
namespace {

constexpr double kNothing = 1e-9;  // mm: a move or a rest of one that is shorter does not exist

bool has(const PathRecord& r, std::uint32_t flag) { return (r.flags & flag) != 0; }

// A spiral's fraction of the sweep over s, so that |dp/ds| = 1 although its radius changes (see
// path_geometry.hpp).
void fit_spiral(PathRecord& r) {
    const double radius = r.shape[arc_shape::kRadius], last = r.shape[arc_shape::kRadiusEnd];
    if (!(last > 0) || last == radius) return;
    const double sweep = r.shape[arc_shape::kSweep], widening = last - radius;
    const double turn = sweep * 0.5 * (radius + last);
    const double others = std::max(0.0, r.length * r.length - turn * turn - widening * widening);
    const auto speed = [&](double f) {
        const double around = (radius + widening * f) * sweep;
        return std::sqrt(around * around + widening * widening + others);
    };
    const auto growth = [&](double f) {
        return (radius + widening * f) * widening * sweep * sweep / speed(f);
    };
    double length = 0;  // Simpson over 16 strips
    constexpr int kStrips = 16;
    for (int n = 0; n <= kStrips; ++n)
        length += (n == 0 || n == kStrips ? 1
                   : n % 2                ? 4
                                          : 2) *
                  speed(static_cast<double>(n) / kStrips);
    length /= 3 * kStrips;
    const double v0 = speed(0), v1 = speed(1);
    const Quintic unit = hermite({0, length / v0, -length * length * growth(0) / (v0 * v0 * v0)},
                                 {1, length / v1, -length * length * growth(1) / (v1 * v1 * v1)});
    double power = 1;
    for (std::size_t k = 0; k < 6; ++k) {
        r.shape[curve_shape::kParameter + k] = unit[k] * power;
        power /= length;
    }
    r.length = length;
}

// The geometry of one piece into a record that has everything else.
void fill_piece(const Blend& blend, const BlendPiece& piece, PathRecord& r) {
    r.kind = static_cast<std::uint8_t>(RecordKind::Curve);
    r.axis_count = blend.axis_count;
    r.length = piece.length;
    r.shape = {};
    for (std::size_t k = 0; k < blend.axis_count; ++k) {
        r.axis[k] = blend.axis[k];
        for (std::size_t c = 0; c < 6; ++c) r.shape[6 * k + c] = piece.position[k][c];
        r.start[k] = piece.position[k][0];
        r.end[k] = at(piece.position[k], 1);
    }
    for (std::size_t c = 0; c < 6; ++c) r.shape[curve_shape::kParameter + c] = piece.parameter[c];
}

// No faster than feed override (200 %) can ask for: a blend for more would gain nothing.
double useful_speed(const PathRecord& r, double v_max) {
    constexpr double kMostOverride = 2;
    const bool per_minute =
        static_cast<FeedMode>(r.feed_mode) == FeedMode::PerMinute && !has(r, kRapid) && r.feed > 0;
    return per_minute && static_cast<RecordKind>(r.kind) != RecordKind::Line
               ? std::min(v_max, kMostOverride * r.feed)
               : v_max;
}

// rad: below this turn a blend is always worth it.
constexpr double kStopMayBeFaster = 0.2;

}  // namespace

PathRecord& PathMaker::next_move() {
    coming_.move = {};
    return coming_.move;
}

double PathMaker::length_of_next() {
    const double length = path_length(coming_.move, *limits_);
    return length > kNothing ? length : 0;  // such a move vanishes
}

void PathMaker::add_move() {
    Kept& next = coming_;
    next.move.length = path_length(next.move, *limits_);
    if (!(next.move.length > kNothing)) return;
    if (static_cast<RecordKind>(next.move.kind) == RecordKind::Arc) fit_spiral(next.move);
    next.from = 0;
    next.begun = false;
    next.number = ++number_;
    if (has(next.move, kRapid) && limits_->rapid_in_position && !limits_->rapid_overlaps)
        next.move.flags |= kExactStop | kInPosition;
    if (chain_.empty()) {
        next.move.flags &= ~std::uint32_t{kThreadChained};  // nothing to go on from
        next.record_limits = record_limits_of(next.move, *limits_);
        chain_.push_back(next);
    } else {
        const bool runs = may_run(chain_.back().move, next.move);
        next.record_limits = record_limits_of(next.move, *limits_);
        if (runs) {
            chain_.push_back(next);
            run_on();
        } else {
            close_chain();
            join(chain_.back(), next);
            chain_.back() = next;
        }
    }
    for (std::size_t k = 0; k < next.move.axis_count; ++k)
        if (next.move.axis[k] < kMaxAxes) nose_[next.move.axis[k]] = next.move.nose[k];
}

// An axis that the move does not have is where the one before has left it.
double PathMaker::nose_of(const PathRecord& move, std::uint8_t axis) const {
    for (std::size_t k = 0; k < move.axis_count; ++k)
        if (move.axis[k] == axis) return move.nose[k];
    return axis < kMaxAxes ? nose_[axis] : 0.0;
}

void PathMaker::add_event(const PathRecord& record, bool stops) {
    if (stops) flush();
    if (!chain_.empty()) {
        between_.push_back({number_, record});
        return;
    }
    out_->claim() = record;
    out_->commit();
}

void PathMaker::flush() {
    if (!chain_.empty()) {
        close_chain();
        Kept& last = chain_.back();
        if (has(last.move, kThread)) last.move.flags |= kThreadEnd;
        put_part(last, last.move.length, true, true);
        chain_.clear();
    }
    put_between(number_);
    PT_ASSERT(chain_.empty() && between_.empty(), "I3 all go out before flush() returns");
}

void PathMaker::discard() {
    chain_.clear();
    between_.clear();
    running_ = false;
    nose_.fill(0);
}

// Whatever else is kept goes out, so that one move remains.
void PathMaker::close_chain() {
    if (running_) end_run();
    if (chain_.size() < 2) return;
    join(chain_[0], chain_[1]);  // a single short corner: a blend like any other
    chain_.pop_front();
}

bool PathMaker::must_stop(const PathRecord& a, const PathRecord& b) const {
    if (has(a, kExactStop) || has(b, kTapping)) return true;
    if ((has(a, kRapid) || has(b, kRapid)) && !limits_->rapid_overlaps) return true;
    if (has(a, kThread) != has(b, kThread)) return true;
    if (has(b, kThread) && !has(b, kThreadChained)) return true;
    return has(a, kSkipMove) || has(b, kSkipMove);
}

// What the program wants; how fast its spindle turns is not known here but for threads, so a usual
// speed is taken.
double PathMaker::wanted_speed(const PathRecord& r) const {
    constexpr double kUsualRevS = 1000.0 / 60;  // 1000 rpm
    constexpr double kNoFeed = 1.0;             // mm/s, where none is programmed
    switch (static_cast<FeedMode>(r.feed_mode)) {
        case FeedMode::PerMinute:
            return r.feed > 0 ? r.feed : kNoFeed;
        case FeedMode::PerRevolution:
            return r.feed > 0 ? r.feed * kUsualRevS : kNoFeed;
        case FeedMode::Thread: {
            const double lead = std::max(
                r.lead, std::sqrt(std::max(0.0, r.lead * r.lead + 2 * r.lead_change * r.length)));
            return lead > 0 ? lead * (thread_rev_s_ > 0 ? thread_rev_s_ : kUsualRevS) : kNoFeed;
        }
        default:
            return std::numeric_limits<double>::infinity();
    }
}

// N0422: how far from its end a rapid move is when, braking, all its axes have come below their
// share of rapid traverse.
double PathMaker::overlap_way(const Kept& of) const {
    constexpr double kStill = 1e-9;  // of the path: an axis that does less does not move
    double speed = of.record_limits.v;
    for (std::size_t k = 0; k < of.move.axis_count; ++k) {
        const double t = std::abs(of.move.end[k] - of.move.start[k]) / of.move.length;
        const PathAxis& axis = limits_->axis[of.move.axis[k]];
        if (t > kStill) speed = std::min(speed, axis.overlap * axis.rapid / t);
    }
    const double a = of.record_limits.a, j = of.record_limits.j;
    const double time = speed < a * a / j ? 2 * std::sqrt(speed / j) : speed / a + a / j;
    return 0.5 * speed * time;
}

void PathMaker::join(Kept& a, Kept& b) {
    constexpr double kNoRule = std::numeric_limits<double>::infinity();
    RecordLimits rules{kNoRule, kNoRule, kNoRule};
    Junction junction = Junction::Stop;
    const bool overlap = has(a.move, kRapid) && has(b.move, kRapid);
    const bool threads =
        has(a.move, kThread) && has(b.move, kThread) && has(b.move, kThreadChained);
    if (!must_stop(a.move, b.move)) {
        double before = 0.5 * a.move.length, after = 0.5 * b.move.length;
        const double speed = std::min(useful_speed(a.move, a.record_limits.v),
                                      useful_speed(b.move, b.record_limits.v));
        if (threads) {
            junction = blend_threads(a, b, speed, rules.v);
        } else if (overlap) {  // they overlap: rounded as far as their braking lets them
            PathLimits wide = *limits_;
            wide.tolerance = 2.0 * (a.move.length + b.move.length);
            before = std::min(before, overlap_way(a));
            after = std::min(after, overlap_way(b));
            junction = make_blend(a.move, before, b.move, after, speed, wide, blend_);
        } else {
            junction = make_blend(a.move, before, b.move, after, speed, *limits_, blend_);
        }
    }
    if (junction == Junction::Blended && !threads) {
        // N0306 to N0309 speak of feeds
        if (!overlap) apply_junction_rules(blend_.sides, blend_.angle, *limits_, rules);
        if (!overlap && blend_.angle > limits_->square_turn)
            junction = Junction::Stop;
        else if (blend_.angle > kStopMayBeFaster && stop_is_faster(a, b, rules))
            junction = Junction::Stop;
    }
    // it begins anew behind the stop
    if (threads && junction == Junction::Stop) b.move.flags &= ~std::uint32_t{kThreadChained};
    if (has(a.move, kThread) && !has(b.move, kThreadChained)) a.move.flags |= kThreadEnd;
    if (junction != Junction::Blended) {
        put_part(a, a.move.length, true, junction == Junction::Stop);
        put_between(a.number);
        return;
    }
    put_part(a, a.move.length - blend_.trim, false, false);
    put_pieces(a, blend_, 0, blend_.first_half, rules, true);
    put_between(a.number);
    put_pieces(b, blend_, blend_.first_half, blend_.count, rules, false);
    b.from = blend_.trim;
}

// The record of `of` from what is out up to `to`. Nothing is left when both halves of a short move
// are blends.
void PathMaker::put_part(Kept& of, double to, bool last, bool stop) {
    if (to - of.from <= kNothing && !last) return;
    PathRecord& r = out_->claim();
    if (of.from == 0 && to == of.move.length)
        r = of.move;
    else
        cut(of.move, of.from, to, r);
    store(of.record_limits, r);
    if (!of.begun) r.flags |= begin_flag(r);
    of.begun = true;
    if (last) r.flags |= end_flag(r);
    if (stop)
        r.flags |= kExactStop;
    else
        r.flags &= ~std::uint32_t{kExactStop | kInPosition};
    if (!last) r.flags &= ~std::uint32_t{kThreadEnd};
    out_->commit();
}

// How fast blend_ between the two can be driven, and how long it is.
double PathMaker::through_blend(const Kept& a, const Kept& b, double& length) {
    double through = std::numeric_limits<double>::infinity();
    length = 0;
    PathRecord& r = scratch_;
    for (std::size_t n = 0; n < blend_.count; ++n) {
        r.flags = (n < blend_.first_half ? a : b).move.flags;
        fill_piece(blend_, blend_.piece[n], r);
        through = std::min(through, record_limits_of(r, *limits_).v);
        length += r.length;
    }
    return through;
}

// A thread stops nowhere, so between two that are joined there is a blend at any tolerance, also 0.
// Where the tolerance leaves the corner too slow for the spindle, the blend becomes as long as its
// speed needs: with a margin, for what the bend takes of the axes there is missing where the
// thread begins and ends (record_limits.hpp). `most`: how fast it is driven at most.
Junction PathMaker::blend_threads(const Kept& a, const Kept& b, double speed, double& most) {
    constexpr double kSpare = 1.6, kOvershoot = 1.2;  // a spindle swings about its speed
    const double turning = std::max(wanted_speed(a.move), wanted_speed(b.move));
    const double before = 0.5 * a.move.length, after = 0.5 * b.move.length;
    if (thread_rev_s_ > 0) most = kOvershoot * turning;
    const Junction narrow = make_blend(a.move, before, b.move, after, speed, *limits_, blend_);
    double length = 0;
    if (narrow == Junction::Smooth ||
        (narrow == Junction::Blended && through_blend(a, b, length) >= kSpare * turning))
        return narrow;
    const Blend within = blend_;
    PathLimits wide = *limits_;
    wide.tolerance = 2.0 * (a.move.length + b.move.length);
    if (make_blend(a.move, before, b.move, after, kSpare * turning, wide, blend_) ==
        Junction::Blended)
        return Junction::Blended;
    blend_ = within;
    return narrow;
}

// Time lost at the junction against driving through at full speed, by a blend or by a stop. Braking
// from V to w in time T takes (V + w)/2 T of the path, so each side loses T (V - w) / (2 V); a
// blend also its own length at its own speed.
bool PathMaker::stop_is_faster(const Kept& a, const Kept& b, const RecordLimits& rules) {
    // The speed to be reached is found by steps of a fifth, near enough to compare two times; 60 of
    // them are six decades.
    constexpr double kDown = 0.8;
    constexpr int kDowns = 60;
    double length = 0;
    const double through = std::min(rules.v, through_blend(a, b, length));
    double by_stop = 0, by_blend = 0;
    for (const Kept* side : {&a, &b}) {
        const RecordLimits& c = side->record_limits;
        const auto time = [&](double step) {
            return step < c.a * c.a / c.j ? 2 * std::sqrt(step / c.j) : step / c.a + c.a / c.j;
        };
        // What this move can reach from standstill in half its length: 0 to V takes V/2 time(V).
        double top = std::min(c.v, wanted_speed(side->move));
        for (int n = 0; n < kDowns && 0.5 * top * time(top) > 0.5 * side->move.length; ++n)
            top *= kDown;
        const double step = std::max(0.0, top - through);
        by_stop += 0.5 * time(top);
        by_blend +=
            0.5 * time(step) * step / top + 0.5 * length * (1 / std::min(through, top) - 1 / top);
    }
    return by_stop < by_blend;
}

void PathMaker::put_pieces(Kept& of, const Blend& blend, std::size_t first, std::size_t end,
                           const RecordLimits& rules, bool last) {
    for (std::size_t n = first; n < end; ++n) {
        PathRecord& r = out_->claim();
        r = of.move;
        r.flags &= ~std::uint32_t{kExactStop | kInPosition | kThreadEnd};
        if (!of.begun) r.flags |= begin_flag(r);
        of.begun = true;
        if (last && n + 1 == end) r.flags |= end_flag(r);
        fill_piece(blend, blend.piece[n], r);
        for (std::size_t k = 0; k < r.axis_count; ++k) r.nose[k] = nose_of(of.move, r.axis[k]);
        if (has(r, kThread) && std::isfinite(rules.v)) r.feed = rules.v;
        RecordLimits own = record_limits_of(r, *limits_);
        r.feed = of.move.feed;
        own.v = std::min(own.v, rules.v);
        own.soften(rules.a);
        store(own, r);
        out_->commit();
    }
}

void PathMaker::put_between(std::uint64_t up_to) {
    while (!between_.empty() && between_.front().number <= up_to) {
        out_->claim() = between_.front().record;
        out_->commit();
        between_.pop_front();
    }
}

}  // namespace polyturn::channels
