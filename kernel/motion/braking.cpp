#include "kernel/motion/braking.hpp"

#include "ipc/diagnosis/assert.hpp"

namespace polyturn::kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// All constants without a unit are ratios.

// --- What counts as nothing. Speeds of a path are 1e-3 to 1e3 mm/s, lengths up to 1e4 mm; a double
// has 16 digits, and the closed forms below lose about half of them in square roots.

// A speed above a speed limit by less than this is rounding: braking that was planned to meet the
// speed limit exactly is checked again one tick later.
constexpr double kSpeedRounding = 1e-7;
// The acceleration may exceed what a stretch allows by this much where it is entered, and a piece
// counts as braking with all there is when this little is missing: p is aimed at estimates of the
// speed at the border, which are no better.
constexpr double kEntering = 2e-3;
// mm/s and mm/s2: below both the path is at standstill.
constexpr double kAtRest = 1e-9;
// Of the speed aimed at: it has been reached.
constexpr double kAtAim = 1e-9;
// Of the time, and s: driving steadily to the aim is made longer by this, so that it ends behind
// the place and not just before it, where another such piece would be needed.
constexpr double kJustBehind = 1e-12;
// Of the largest p: it is there, another piece would be rounding.
constexpr double kSameAcceleration = 1e-12;
// mm: a profile may end behind the place it aims at by so much.
constexpr double kBehindAim = 1e-8;
// The end of a braking is set to (w, 0) exactly; before that it may be off by
//     kEndSpeed (v + kEndSpeedFloor)         mm/s, v: where the release began to be looked for
//     kEndAcceleration (most + kEndAccelerationFloor)   mm/s2, most: what was allowed there.
// A thousandth of what a tick changes of either at usual limits; the drives do not notice.
constexpr double kEndSpeed = 1e-6, kEndSpeedFloor = 1e-3;             // -, mm/s
constexpr double kEndAcceleration = 1e-5, kEndAccelerationFloor = 1;  // -, mm/s2

// --- Releasing p to 0 in two halves, p to p/2 and p/2 to 0 (limits are taken at the beginning of
// each, so the lower half may have more jerk). With a constant jerk J the speed that p costs is
// p^2 / (2 J), and p/2 costs a quarter of it; so the upper half takes three quarters.
constexpr double kUpperShare = 0.75, kLowerShare = 0.25;
// The travel of a release to standstill is J t^3/6 = v t/3, since v = J t^2/2: a third of v on
// average.
constexpr double kReleaseMeanSpeed = 3;  // v divided by this
constexpr double kSpeedAtHalf = 4;       // v divided by this is left where p/2 is left

// --- Pieces on bends, where limits depend on speed. Shorter pieces lose less (limits.hpp: each is
// checked at its beginning), and cost more. Tuned with tests/bench/motion_bench.

// Pieces of a braking on a bend that takes all of what there is, about.
constexpr double kPiecesOnBend = 12;
// Of what there is: a bend that takes less is taken in no longer pieces.
constexpr double kFaint = 0.15;
// Each time so many have been made they become twice as long: the braking takes longer than was
// estimated, and must end within kMaxPieces.
constexpr std::uint32_t kPiecesUntilLonger = 24;
// Releasing a > 0: to this part of it in each piece, ...
constexpr double kRisingKept = 0.75;
// ... to 0 at once where it is less than this part of what is allowed ...
constexpr double kRisingFaint = 0.05;
// ... and not beyond the stretch: its time at the present speed, a little longer, so that the piece
// is cut at the border and not just before it; s: but no shorter than this.
constexpr double kBeyondBorder = 1.05, kShortestRising = 1e-5;
// rising_jerk: rounds, and how much further than the jerk just seen the next guess goes down. The
// jerk falls with the speed that its own smallness leads to, so guesses from above alone would come
// nearer for ever and never be below.
constexpr int kRisingRounds = 8;
constexpr double kRisingOvershoot = 0.6;

// --- When to release.

// Of the speed left, used by the release: nearer is not looked for.
constexpr double kWorthWhile = 0.97;
constexpr int kRefinements = 3;  // pieces with which it may come nearer
// Trials of half the change of p, where all of it leaves no jerk to release it.
constexpr int kHalvings = 4;
// Newton steps for the time of the release where stretches ahead make it take more than estimated;
// it is good enough when it takes this part of v too much.
constexpr int kReleaseSteps = 3;
constexpr double kReleaseExcess = 1e-3;
// A Newton step goes back by at most this part of the time, for the estimate behind it may be poor,
constexpr double kLongestStepBack = 0.5;
// and it believes in no mean jerk below the first one divided by this.
constexpr double kLeastMeanJerk = 4;
// A release that needs more speed than this is beyond saving (of the speed there is, of v, mm/s).
// Less is not: the estimate is made from a few places, and the pieces that follow it take what is
// there.
constexpr double kReleaseMay = 1.3, kReleaseMayOfV = 5e-3, kReleaseMayBe = 1e-9;
// Pieces of a release; while the jerk that would end at (w, 0) is not allowed yet, each takes this
// part of p with the jerk there is, which grows as the speed falls.
constexpr int kReleasePieces = 24;
constexpr double kReleasePart = 0.1;
// The needed jerk may be more than is allowed by this much: as exact as what follows of estimates.
constexpr double kJerkMay = 5e-3;
// Of the p that was allowed: nothing is left to release. And of v, with p^2 in the unit of jerk
// times speed: both are over at once.
constexpr double kReleased = 1e-9;

// --- Lowering p in time for a stretch that allows less.

// Rounds in which speed and time at its beginning are estimated; and how much more acceleration a
// lower speed must bring for another round.
constexpr int kArrivalRounds = 3;
constexpr double kArrivalGain = 1.02;
// Of the time for it: the attempt that lowers p earlier takes no more than this.
constexpr double kEarlier = 0.7;

// --- Newton for the time at which a place is reached.
constexpr int kNewtonRounds = 60;          // bisection alone needs 44
constexpr double kNewtonRelative = 1e-13;  // of the longest time: near the last digits
// mm/s: keep the quotient finite where the path is nearly at standstill.
constexpr double kLeastSpeedFirst = 1e-9, kLeastSpeed = 1e-12;

// --- Has a place been passed slowly enough (arrives)?
constexpr int kArrivalBisections = 20;  // a millionth of a piece

// Speed that releasing p from v on takes, in two pieces: the lower half has more jerk.
double release_drop(double v, double p, const Limits& limits) noexcept {
    if (!(p > 0)) return 0;
    if (limits.flat()) return p * p / (2 * limits.j);
    const double upper = limits.jerk(v, p), lower = limits.jerk(v, p / 2);
    return upper > 0 ? p * p * (kUpperShare / 2 / upper + kLowerShare / 2 / lower) : kInfinity;
}

// Releasing a > 0 down to `to`: the jerk that the limits allow at the speed it leads to. 0: none.
double rising_jerk(double v, double a, double to, const Limits& limits) noexcept {
    if (limits.flat()) return limits.j;
    double jerk = limits.jerk(v, a);
    for (int i = 0; i < kRisingRounds && jerk > 0; ++i) {
        const double top = v + (a * a - to * to) / (2 * jerk), there = limits.jerk(top, a);
        if (there >= jerk) {
            const double normal = limits.bend * top * top;
            return to * to <= limits.a * limits.a - normal * normal ? jerk : 0;
        }
        // it falls with the speed that its own smallness leads to
        jerk = there - kRisingOvershoot * (jerk - there);
    }
    return 0;
}

// Time until s is reached with constant jerk, in [0, most]; it is reached by then and the speed
// stays positive. Newton, kept between two times of which one is too short and one long enough.
double time_to(const PathState& x, double jerk, double s, double most) noexcept {
    double low = 0, high = most, time = std::min(most, (s - x.s) / std::max(x.v, kLeastSpeedFirst));
    for (int i = 0; i < kNewtonRounds && high - low > kNewtonRelative * most; ++i) {
        const PathState y = advanced(x, jerk, time);
        (y.s < s ? low : high) = time;
        const double next = time + (s - y.s) / std::max(y.v, kLeastSpeed);
        if (std::abs(next - time) < kNewtonRelative * most) return std::max(next, low);
        time = next > low && next < high ? next : (low + high) / 2;
    }
    return high;
}

}  // namespace

// Releasing p: the jerk of each half and the speed that both take.
struct Braking::Release {
    double upper = 0, lower = 0;  // mm/s3; 0: none is allowed
    double drop = 0;              // mm/s
    // The one jerk that would take as much: drop = p^2 / (2 mean).
    double mean() const noexcept {
        return upper > 0 && lower > 0 ? 1 / (kUpperShare / upper + kLowerShare / lower) : 0;
    }
};

// One attempt at a braking, piece by piece from the place where it begins.
//
//     begin          which stretch is it on
//     end_rise       a > 0 is released
//     choose_aim     how slow must it become: a stand, or first the speed of the aim
//     to_stand       pieces of p until standstill. Each:
//         change         how may p change, for how long (up to what is allowed, and on with it)
//         release_time   when must its release begin, so that the speed suffices for it
//         time_to_lower  when must it be lowered, so that the stretches ahead allow it
//         release_all    at the end: p to 0 together with the speed to spare
//
// Each says false where the attempt has failed.
class Braking::Walk {
public:
    Walk(Braking& braking, Road& road, bool obey, bool gentle, double strict,
         const Aim* aim) noexcept
        : b_(braking), road_(road), obey_(obey), gentle_(gentle), strict_(strict), aim_(aim) {}

    bool begin() noexcept;
    bool end_rise() noexcept;
    bool choose_aim() noexcept;
    bool to_stand() noexcept;

private:
    // How p is to change, for how long at the most.
    struct Change {
        double time;  // s; infinity: it stays
        double to;    // mm/s2, p at its end
        double rate;  // mm/s3, p over time
        double top;   // mm/s2, the largest p on the way: more is never reached
    };

    const PathState& state() const noexcept { return b_.at_[b_.count_]; }
    const Limits& limits() const noexcept { return now_->limits; }
    bool enter() noexcept;
    bool add(double time, double jerk, bool& cut) noexcept;
    // but for rounding
    void settle(double v, double a) noexcept {
        b_.at_[b_.count_].v = v;
        b_.at_[b_.count_].a = a;
    }
    void look(double distance) noexcept;
    bool varied() const noexcept { return near_count_ > 0 || !limits().flat(); }
    double cap() noexcept;
    double time_to_lower(double rate, double top, double jerk, double time, double before,
                         const Stretch*& at, double& allowed) const noexcept;
    Release release(double s, double v, double p, double to = 0) const noexcept;
    bool change(std::uint32_t piece, double most, double rise, Change& c) noexcept;
    bool change_on_bend(std::uint32_t piece, double most, double rise, Change& c) noexcept;
    double release_time(Change& c) noexcept;
    double release_time_ahead(const Change& c, double mean, double release_at) const noexcept;
    bool release_all(double most, double rise, double v) noexcept;

    Braking& b_;
    Road& road_;
    const Stretch* now_ = nullptr;  // where the state is
    std::uint32_t stretch_ = 0;     // its number
    double border_ = 0;             // where it ends
    bool obey_, gentle_;  // speed limits count; p is lowered earlier than it seems necessary
    double strict_;       // from there on it is lowered in time, before that hoped for
    const Aim* aim_;      // null: none, or it is behind
    double least_ = 0;    // w, the speed to brake to
    // s: a piece on a bend that takes all of what there is; infinity: not chosen yet
    double step_ = kInfinity;
    std::uint32_t near_count_ = 0;
    // What is read of the road: stretches on which a release goes on are few, and a seventh
    // is seen by the next piece.
    static constexpr std::size_t kNear = 6;
    std::array<const Stretch*, kNear> near_;
    const Stretch* cap_at_ = nullptr;
    double cap_ = 0;
};

bool Braking::Walk::begin() noexcept {
    const double s = state().s;
    while ((now_ = road_.stretch(stretch_)) != nullptr && road_.end_of(stretch_) <= s) ++stretch_;
    if (now_ == nullptr) return false;
    border_ = road_.end_of(stretch_);
    if (obey_ && !(state().v <= now_->speed_limit * (1 + kSpeedRounding))) return false;
    // Already there with more: it can only be lowered. Nothing leads there.
    const PathState& first = state();
    return !(std::abs(first.a) > limits().acceleration(first.v) * (1 + kEntering) &&
             (first.a > 0 || first.s > 0));
}

bool Braking::Walk::enter() noexcept {
    now_ = road_.stretch(++stretch_);
    if (now_ == nullptr) return false;
    border_ = road_.end_of(stretch_);
    const PathState& x = state();
    if (obey_ && x.v > now_->speed_limit * (1 + kSpeedRounding)) return false;
    if (std::abs(x.a) <= now_->limits.acceleration(x.v) * (1 + kEntering)) return true;
    b_.refused_ = now_->begin;
    return false;
}

// A piece, cut where a stretch ends (then `cut`). False: it is not allowed.
bool Braking::Walk::add(double time, double jerk, bool& cut) noexcept {
    cut = false;
    if (!(time > 0)) return true;
    const PathState x = state();
    PathState end = advanced(x, jerk, time);
    if (end.s > border_) {
        if (border_ >= road_.end()) return false;  // beyond the end of the road
        time = time_to(x, jerk, border_, time);
        end = advanced(x, jerk, time);
        cut = true;
    }
    if (b_.count_ == kMaxPieces) return false;
    const std::uint32_t i = b_.count_++;
    b_.time_[i] = time;
    b_.jerk_[i] = jerk;
    b_.limits_[i] = &now_->limits;
    b_.at_[i + 1] = end;
    if (obey_ && end.v > now_->speed_limit * (1 + kSpeedRounding) && end.v > x.v) return false;
    return !cut || enter();
}

// The next stretches that begin within a distance.
void Braking::Walk::look(double distance) noexcept {
    near_count_ = 0;
    for (std::uint32_t k = stretch_;
         near_count_ < near_.size() && road_.end_of(k) < state().s + distance;) {
        const Stretch* const next = road_.stretch(++k);
        if (next == nullptr) break;
        near_[near_count_++] = next;
    }
}

// Until the end of a stretch ahead that allows less than here, p is no more than that allows.
double Braking::Walk::cap() noexcept {
    if (cap_at_ != nullptr && cap_at_->begin <= now_->begin) cap_at_ = nullptr;
    return cap_at_ != nullptr ? cap_ : kInfinity;
}

// How long may p change at a rate, up to `top`, so that it can still be lowered to what each
// stretch ahead allows where that is entered? `at`: the stretch that asks for it, `allowed`: what
// that is. Stretches before `strict_` are hoped for.
//
// With T the time until the stretch is entered, a what it allows there and J the jerk on the way:
// p rises for t and falls for the rest, p + rate t - J (T - t) <= a, so
//     t = (J T - (p - a)) / (rate + J).
// T is a lower bound: from v on, with the least p that it brakes with on the way, it is
//     root = sqrt(v^2 - 2 p way) there, after T = 2 way / (v + root).
double Braking::Walk::time_to_lower(double rate, double top, double jerk, double time,
                                    double before, const Stretch*& at,
                                    double& allowed) const noexcept {
    const PathState& x = state();
    const double p = std::max(0.0, -x.a);
    for (std::uint32_t k = 0; k < near_count_ && near_[k]->begin < before; ++k) {
        const Limits& there = near_[k]->limits;
        const double way = near_[k]->begin - x.s, before_it = jerk;
        double v = obey_ ? std::min(x.v, near_[k]->speed_limit) : x.v, a = there.acceleration(v),
               long_enough = way / x.v;
        // It brakes at least so much on the way, so it is no faster there; and the slower, the more
        // is allowed, the less it must be lowered.
        for (int round = 0; round < kArrivalRounds && a < top && !there.flat(); ++round) {
            const double steadily = std::min(p, a),
                         root = std::sqrt(std::max(0.0, x.v * x.v - 2 * steadily * way)), last = a;
            long_enough = 2 * way / (x.v + root);
            v = std::min(v, root);
            a = there.acceleration(v);
            if (a < kArrivalGain * last) break;
        }
        jerk = std::min(jerk, there.jerk(v, std::min(top, a)));
        if (a >= top || near_[k] == cap_at_ || near_[k]->begin < strict_) continue;
        const double t =
            (long_enough * (gentle_ ? kEarlier : 1) * before_it - (p - a)) / (rate + before_it);
        if (t < time) {
            time = std::max(0.0, t);
            at = near_[k];
            allowed = a;
        }
    }
    return time;
}

// Releasing p on the way to a speed: the jerk of each half, and the speed that it takes. With
// constant jerk to standstill v falls as the power 2/3 of the travel that is left and p as the
// power 1/3 (v = J t^2/2, p = J t, way = J t^3/6 before the end); where a stretch is entered its
// limits count. To a speed w > 0 the travel grows nearly as the time, and so does p.
Braking::Release Braking::Walk::release(double s, double v, double p, double to) const noexcept {
    if (!(p > 0)) return {limits().jerk(v, 0), limits().jerk(v, 0), 0};
    if (limits().flat() && near_count_ == 0)
        return {limits().j, limits().j, p * p / (2 * limits().j)};
    Release r{limits().jerk(v, p), limits().jerk(v, p / 2), 0};
    const double way =
        r.upper > 0 ? (to + std::max(0.0, v - to) / kReleaseMeanSpeed) * p / r.upper : 0;
    for (std::uint32_t k = 0; k < near_count_ && near_[k]->begin - s < way; ++k) {
        const Limits& there = near_[k]->limits;
        if (there.flat()) {
            r.upper = std::min(r.upper, there.j);
            r.lower = std::min(r.lower, there.j);
            continue;
        }
        // of the way; `root`: of p, and its square of the speed
        const double left = std::clamp(1 - (near_[k]->begin - s) / way, 0.0, 1.0),
                     root = to > 0 ? left : std::cbrt(left);
        const double speed = to + (v - to) * root * root;
        if (root > 0.5) r.upper = std::min(r.upper, there.jerk(speed, p * root));
        r.lower = std::min(r.lower, there.jerk(std::min(speed, to + (v - to) / kSpeedAtHalf),
                                               p * std::min(0.5, root)));
    }
    r.drop = r.upper > 0 && r.lower > 0
                 ? p * p * (kUpperShare / 2 / r.upper + kLowerShare / 2 / r.lower)
                 : kInfinity;
    return r;
}

// Releases a > 0. On bends in parts, and no further than the stretch: its limits are not those of
// the next.
bool Braking::Walk::end_rise() noexcept {
    bool cut = false;
    while (state().a > 0) {
        const PathState x = state();
        const Limits& here = limits();
        double to = 0;
        if (!here.flat()) {
            const double inside = (border_ - x.s) / x.v * kBeyondBorder;
            to = std::max(x.a < kRisingFaint * here.a ? 0 : kRisingKept * x.a,
                          x.a - std::max(inside, kShortestRising) * here.jerk(x.v, x.a));
        }
        const double jerk = rising_jerk(x.v, x.a, to, here);
        if (!(jerk > 0) || !add((x.a - to) / jerk, -jerk, cut)) return false;
        if (!cut) settle(state().v, to);
        b_.peak_ = state().v;
    }
    b_.falling_ = b_.count_;
    return true;
}

// The speed to brake to: that of the aim, or what releasing at once ends at.
bool Braking::Walk::choose_aim() noexcept {
    if (aim_ == nullptr) return true;
    const PathState x = state();
    if (x.s > aim_->at) return false;
    look(x.v * std::max(0.0, -x.a) / limits().j);
    least_ = std::min(aim_->speed, x.v - release(x.s, x.v, std::max(0.0, -x.a), aim_->speed).drop);
    return least_ > 0;
}

// How p may change from here: towards `most`, what is allowed, with the jerk `rise`.
bool Braking::Walk::change(std::uint32_t piece, double most, double rise, Change& c) noexcept {
    const double p = std::max(0.0, -state().a);
    c.time = kInfinity;
    c.to = most;
    if (!limits().flat()) {
        if (!change_on_bend(piece, most, rise, c)) return false;
    } else if (std::abs(p - most) > kSameAcceleration * most) {
        c.time = std::abs(most - p) / rise;
    }
    c.rate = c.time < kInfinity ? (c.to - p) / c.time : 0;
    // The p at which the speed left is just what its release needs: jerk_profile.hpp (1).
    const double v = state().v;
    c.top = std::max(p, std::min(c.to, std::sqrt(rise * (v - least_) + p * p / 2)));
    return true;
}

// The same where limits depend on speed: for a piece so short that they change little.
bool Braking::Walk::change_on_bend(std::uint32_t piece, double most, double rise,
                                   Change& c) noexcept {
    const Limits& here = limits();
    const double v = state().v, p = std::max(0.0, -state().a);
    if (!(step_ < kInfinity))
        // about how long braking to w takes, by kPiecesOnBend
        step_ = ((v - least_) / std::max(most, p) + 2 * std::sqrt((v - least_) / here.j)) /
                kPiecesOnBend;
    if (piece > 0 && piece % kPiecesUntilLonger == 0) step_ *= 2;
    const double v2 = v * v, v3 = v2 * v;
    // the largest share of acceleration or jerk that the bend takes at this speed
    const double taken =
        std::max({here.bend * v2 / here.a, here.turning * v * std::max(p, most) / here.j,
                  here.along * v3 / here.j, here.across * v3 / here.j, kFaint});
    c.time = step_ / taken;
    if (p > most) {
        c.time = std::min(c.time, (p - most) / rise);
        c.to = p - rise * c.time;
    } else if (p < most * (1 - kEntering)) {  // up to what is allowed here
        const double jerk = here.jerk(v, std::min(most, p + rise * c.time));
        if (!(jerk > 0)) return false;
        c.time = std::min(c.time, (most - p) / jerk);
        c.to = p + jerk * c.time;
    } else {  // and on with it, as it grows
        c.to = std::min(here.acceleration(std::max(0.0, v - p * c.time)), cap());
        if (c.to > p) c.to = std::max(p, std::min(c.to, p + here.jerk(v, c.to) * c.time));
    }
    return true;
}

// After what time of the change must p be released, so that there is speed left for it:
//     v(t) - w = p(t)^2 / (2 mean)                           solved for t by (1) of the header.
// Makes the change smaller where it leaves no jerk to be ended with.
double Braking::Walk::release_time(Change& c) noexcept {
    const PathState x = state();
    const double v = x.v, p = std::max(0.0, -x.a);
    double mean = release(x.s, v, c.top, least_).mean();
    for (int i = 0; i < kHalvings && !(mean > 0) && c.top > p; ++i) {
        c.time /= 2;
        c.top = p + (c.top - p) / 2;
        c.to = p + c.rate * c.time;
        mean = release(x.s, v, c.top, least_).mean();
    }
    // S and k of the header
    const double spare = mean > 0 ? v - least_ - p * p / (2 * mean) : 0,
                 factor = mean > 0 ? 1 + c.rate / mean : 0;
    if (!(spare > 0)) return 0;
    const double root = p * factor * p * factor + 2 * c.rate * factor * spare,
                 sum = root >= 0 ? p * factor + std::sqrt(root) : 0;
    const double release_at = sum > 0 ? 2 * spare / sum : kInfinity;
    return release_time_ahead(c, mean, release_at);
}

// The same, made less where stretches ahead leave less jerk than was estimated. The speed missing
// at t is  f = drop(p(t)) - (v(t) - w); with a mean jerk there,  f' = p (1 + rate/mean):  Newton.
double Braking::Walk::release_time_ahead(const Change& c, double mean,
                                         double release_at) const noexcept {
    const PathState& x = state();
    const double v = x.v, p = std::max(0.0, -x.a);
    for (int i = 0; i < kReleaseSteps && release_at > 0 && release_at <= c.time && varied(); ++i) {
        const double t = release_at, p_then = p + c.rate * t, v_then = v - t * (p + c.rate * t / 2);
        const Release there =
            release(x.s + t * (v - t * (p / 2 + c.rate * t / 6)), v_then, p_then, least_);
        // there.drop may be infinite
        const double excess = std::min(there.drop, 2 * v) - (v_then - least_);
        if (!(excess > kReleaseExcess * v)) break;
        release_at = std::max(
            0.0, t - excess / std::max(p_then * (1 + c.rate / std::max(there.mean(),
                                                                       mean / kLeastMeanJerk)),
                                       excess / (kLongestStepBack * t)));
    }
    return release_at;
}

// All of p, with the jerk that ends both p and the speed to spare at once, as far as the limits
// allow; where they do not yet, with what there is: it grows. `most`, `rise`, `v`: what was allowed
// and how fast it was where the last piece began, the measure of rounding.
bool Braking::Walk::release_all(double most, double rise, double v) noexcept {
    bool cut = false;
    if (std::max(0.0, -state().a) > 0)
        for (int pieces = 0;; ++pieces) {
            const PathState z = state();
            const double left = -z.a, speed = z.v - least_;
            if (left <= kReleased * most ||
                (left * left <= kReleased * v * rise && std::abs(speed) <= kReleased * v))
                break;
            if (pieces == kReleasePieces || !(speed > 0)) return false;
            const double needed = left * left / (2 * speed),
                         jerk = limits().jerk(std::max(0.0, z.v), left);
            if (!(jerk > 0)) return false;
            const bool enough = needed <= jerk * (1 + kJerkMay);
            if (!add(left / (enough ? needed : jerk) * (enough ? 1 : kReleasePart),
                     enough ? needed : jerk, cut))
                return false;
            if (enough && !cut) break;
        }
    const PathState& end = state();
    if (std::abs(end.v - least_) > kEndSpeed * (v + kEndSpeedFloor) ||
        std::abs(end.a) > kEndAcceleration * (most + kEndAccelerationFloor))
        return false;
    settle(least_, 0);
    return true;
}

bool Braking::Walk::to_stand() noexcept {
    bool cut = false;
    int refined = 0;
    // more rounds than pieces, for some rounds add none
    for (std::uint32_t i = 0; i < 2 * kMaxPieces; ++i) {
        const PathState x = state();
        const Limits& here = limits();
        const double v = x.v, p = std::max(0.0, -x.a);
        if (v <= kAtRest && p <= kAtRest) {
            settle(0, 0);
            return true;
        }
        // steadily to the aim, through whatever lies between, and then to standstill
        if (aim_ != nullptr && p <= kAtRest && v <= least_ * (1 + kAtAim)) {
            if (b_.arrival_ == 0) b_.arrival_ = b_.count_;
            if (x.s >= aim_->at) {
                aim_ = nullptr;
                least_ = 0;
                step_ = kInfinity;
            } else {
                const double time = (aim_->at - x.s) / v * (1 + kJustBehind) + kJustBehind;
                if (!add(time, 0, cut)) return false;
                continue;
            }
        }
        const double allowed_here = here.acceleration(v), rise = here.jerk(v, p);
        if (!(allowed_here > 0) || !(rise > 0)) return false;
        const double most = std::min(allowed_here, cap());
        Change c;
        if (!change(i, most, rise, c)) return false;
        // What is to come within the travel on which p, or what it may become here, could be
        // released.
        look(v * c.top / rise);
        const double release_at = release_time(c);
        // What there is ahead may be less than here.
        const Stretch* narrow = nullptr;
        double allowed = 0;
        const double longest = std::min(c.time, release_at);
        const double lower_at =
            time_to_lower(c.rate, c.top, std::min(rise, here.jerk(v, c.top)), longest,
                          aim_ != nullptr ? aim_->at : kInfinity, narrow, allowed);
        if (!(lower_at < kInfinity)) return false;
        if (lower_at > 0) {
            if (!add(lower_at, -c.rate, cut)) return false;
            if (cut) continue;
            if (lower_at == c.time) settle(state().v, -c.to);
        }
        if (narrow != nullptr) {
            cap_at_ = narrow;
            cap_ = allowed;
            continue;
        }
        if (lower_at < release_at) continue;
        // Now all of it must be released; unless it turns out that there is still speed to lose
        // before.
        const PathState y = state();
        const double there_is = y.v - least_;
        const Release all = release(y.s, y.v, std::max(0.0, -y.a), least_);
        if (all.drop < kWorthWhile * there_is && refined < kRefinements && lower_at > 0) {
            ++refined;
            continue;
        }
        if (all.drop > kReleaseMay * there_is + kReleaseMayOfV * y.v + kReleaseMayBe) return false;
        if (!release_all(most, rise, v)) return false;
        if (aim_ == nullptr) return true;
        if (state().s > aim_->at + kBehindAim) return false;
    }
    return false;
}

void Braking::stand() noexcept {
    count_ = falling_ = 0;
    at_[0] = {};
    peak_ = duration_ = aim_time_ = 0;
    aims_ = false;
    possible_ = true;
}

void Braking::along(Road& road, const PathState& from, bool obey) noexcept {
    find(road, from, obey, nullptr);
    aims_ = false;
}

void Braking::by_way_of(const Aim& aim, Road& road, const PathState& from) noexcept {
    find(road, from, true, &aim);
    aims_ = true;
}

// First in the hope that the speed will have fallen enough wherever a stretch allows little
// acceleration; where that fails, lowering it in time there and behind.
void Braking::find(Road& road, const PathState& from, bool obey, const Aim* aim) noexcept {
    constexpr int kAttempts = 3;  // hoping; strict from where that failed; strict and early
    double strict = kInfinity;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        refused_ = kInfinity;
        const bool gentle = attempt == kAttempts - 1;
        if (walk(road, from, obey, gentle, strict, aim) || !(refused_ < kInfinity)) break;
        strict = attempt == 0 ? refused_ : 0;
    }
    duration_ = aim_time_ = 0;
    PT_ASSERT(!possible_ || (at_[count_].v == 0 && at_[count_].a == 0), "I1 it ends at rest");
    PT_ASSERT(!possible_ || end() <= road.end(), "I2 it ends on the road");
    for (std::uint32_t i = 0; i < count_; ++i) {
        PT_ASSERT(time_[i] >= 0, "I3 no piece takes less than nothing");
        duration_ += time_[i];
        if (i + 1 == arrival_) aim_time_ = duration_;
    }
}

bool Braking::walk(Road& road, const PathState& from, bool obey, bool gentle, double strict,
                   const Aim* aim) noexcept {
    count_ = falling_ = arrival_ = 0;
    at_[0] = from;
    peak_ = from.v;
    Walk walk(*this, road, obey, gentle, strict, aim);
    return possible_ = walk.begin() && walk.end_rise() && walk.choose_aim() && walk.to_stand();
}

// c: mm/s, d: mm on the road. On the way, at x, releasing at once ends at rest(x); that falls along
// the braking. So there is one place from which the release ends at c, and it must end before d.
bool Braking::arrives(double c, double d) const noexcept {
    const double at_most = c * (1 + kSpeedRounding);
    if (peak_ <= at_most) return true;
    const auto rest = [&](const PathState& x, std::uint32_t i) {
        return x.v - release_drop(x.v, -x.a, *limits_[i]);
    };
    const PathState& first = at_[falling_];
    if (falling_ == count_) return first.v <= at_most;
    if (rest(first, falling_) <= c) {  // the release ends below it anyhow
        const double a = first.a, jerk = limits_[falling_]->jerk(first.v, -a), way = d - first.s;
        if (a >= 0 || first.v <= at_most) return first.v <= at_most || way >= 0;
        if (release_distance_to(first.v, a, std::max(c, first.v - a * a / (2 * jerk)), jerk) <= way)
            return true;
        // held so long, then released
        return 2 * jerk * c >= a * a && first.v * first.v - c * c <= -2 * a * way;
    }
    // The piece in which the place lies, and the place.
    std::uint32_t i = falling_;
    while (i + 1 < count_ && rest(at_[i + 1], i) > c) ++i;
    double low = 0, high = time_[i];
    for (int k = 0; k < kArrivalBisections; ++k) {
        const double middle = (low + high) / 2;
        (rest(advanced(at_[i], jerk_[i], middle), i) > c ? low : high) = middle;
    }
    const PathState x = advanced(at_[i], jerk_[i], high);
    const double p = -x.a;
    if (!(p > 0)) return x.s <= d;
    // Where the release in two halves ends.
    const double upper = limits_[i]->jerk(x.v, p), lower = limits_[i]->jerk(x.v, p / 2);
    return advanced(advanced(x, upper, p / 2 / upper), lower, p / 2 / lower).s <= d;
}

PathState Braking::follow(double time, double dt) const noexcept {
    const auto where = [&](double t) {
        std::uint32_t i = 0;
        while (i < count_ && t >= time_[i]) t -= time_[i++];
        return i < count_ ? advanced(at_[i], jerk_[i], t) : PathState{at_[count_].s, 0, 0};
    };
    const double from = where(time).s;
    PathState x = where(time + dt);
    return {std::max(0.0, x.s - from), std::max(0.0, x.v), x.a};  // but for rounding
}

}  // namespace polyturn::kernel
