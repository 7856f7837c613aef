#include "kernel/motion/braking.hpp"

namespace polyturn::kernel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// of a braking on a bend that takes all, about
constexpr double kSteps = 12;
// of what there is: a bend that takes less is taken in no longer pieces
constexpr double kFaint = 0.15;
// of the speed left, used by the release: nearer is not looked for
constexpr double kWorthWhile = 0.97;
// relative: rounding; what a piece may be off where limits change
constexpr double kCeiling = 1e-7, kEntering = 2e-3;

// Speed that releasing p from v on takes, in two pieces: the lower half has more jerk.
double release_drop(double v, double p, const Limits& limits) noexcept {
    if (!(p > 0)) return 0;
    if (limits.flat()) return p * p / (2 * limits.j);
    const double upper = limits.jerk(v, p), lower = limits.jerk(v, p / 2);
    return upper > 0 ? p * p * (0.375 / upper + 0.125 / lower) : kInfinity;
}

// Releasing a > 0 down to `to`: the jerk that the limits allow at the speed it leads to. 0: none.
double rising_jerk(double v, double a, double to, const Limits& limits) noexcept {
    if (limits.flat()) return limits.j;
    double jerk = limits.jerk(v, a);
    for (int i = 0; i < 8 && jerk > 0; ++i) {
        const double top = v + (a * a - to * to) / (2 * jerk), there = limits.jerk(top, a);
        if (there >= jerk) {
            const double normal = limits.bend * top * top;
            return to * to <= limits.a * limits.a - normal * normal ? jerk : 0;
        }
        // it falls with the speed that its own smallness leads to
        jerk = there - 0.6 * (jerk - there);
    }
    return 0;
}

// Time until s is reached with constant jerk, in [0, most]; it is reached by then and the speed
// stays positive.
double time_to(const PathState& x, double jerk, double s, double most) noexcept {
    double low = 0, high = most, time = std::min(most, (s - x.s) / std::max(x.v, 1e-9));
    for (int i = 0; i < 60 && high - low > 1e-13 * most; ++i) {  // Newton, kept between the two
        const PathState y = advanced(x, jerk, time);
        (y.s < s ? low : high) = time;
        const double next = time + (s - y.s) / std::max(y.v, 1e-12);
        if (std::abs(next - time) < 1e-13 * most) return std::max(next, low);
        time = next > low && next < high ? next : (low + high) / 2;
    }
    return high;
}

}  // namespace

struct Braking::Release {
    double upper = 0, lower = 0, drop = 0;
    // drop = p^2 / (2 mean)
    double mean() const noexcept {
        return upper > 0 && lower > 0 ? 1 / (0.75 / upper + 0.25 / lower) : 0;
    }
};

// Where the braking is and what holds there.
class Braking::Walk {
public:
    Walk(Braking& braking, Road& road, bool obey, bool gentle, double strict) noexcept
        : b_(braking), road_(road), obey_(obey), gentle_(gentle), strict_(strict) {}

    bool begin() noexcept {
        const double s = state().s;
        while ((now_ = road_.stretch(stretch_)) != nullptr && road_.end_of(stretch_) <= s)
            ++stretch_;
        if (now_ == nullptr) return false;
        border_ = road_.end_of(stretch_);
        return !obey_ || state().v <= now_->ceiling * (1 + kCeiling);
    }
    const PathState& state() const noexcept { return b_.at_[b_.count_]; }
    const Limits& limits() const noexcept { return now_->limits; }
    double border() const noexcept { return border_; }

    // A piece, cut where a stretch ends (then `cut`). False: it is not allowed.
    bool add(double time, double jerk, bool& cut) noexcept {
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
        if (b_.count_ == kMost) return false;
        const std::uint32_t i = b_.count_++;
        b_.time_[i] = time;
        b_.jerk_[i] = jerk;
        b_.limits_[i] = &now_->limits;
        b_.at_[i + 1] = end;
        if (obey_ && end.v > now_->ceiling * (1 + kCeiling) && end.v > x.v) return false;
        return !cut || enter();
    }
    // but for rounding
    void settle(double v, double a) noexcept {
        b_.at_[b_.count_].v = v;
        b_.at_[b_.count_].a = a;
    }

    // The next stretches that begin within a distance.
    void look(double distance) noexcept {
        near_count_ = 0;
        for (std::uint32_t k = stretch_;
             near_count_ < near_.size() && road_.end_of(k) < state().s + distance;) {
            const Stretch* const next = road_.stretch(++k);
            if (next == nullptr) break;
            near_[near_count_++] = next;
        }
    }
    bool varied() const noexcept { return near_count_ > 0 || !limits().flat(); }
    // Until the end of a stretch ahead that allows less than here, p is no more than that allows.
    double cap() noexcept {
        if (cap_at_ != nullptr && cap_at_->begin <= now_->begin) cap_at_ = nullptr;
        return cap_at_ != nullptr ? cap_ : kInfinity;
    }
    // How long may p change at a rate, up to `top`, so that it can still be lowered to what each
    // stretch ahead allows where that is entered? `at`: the stretch that asks for it, `allowed`:
    // what that is. Stretches before `strict_` are hoped for.
    double time_to_lower(double rate, double top, double jerk, double time, double before,
                         const Stretch*& at, double& allowed) const noexcept {
        const PathState& x = state();
        const double p = std::max(0.0, -x.a);
        for (std::uint32_t k = 0; k < near_count_ && near_[k]->begin < before; ++k) {
            const Limits& there = near_[k]->limits;
            const double way = near_[k]->begin - x.s, before_it = jerk;
            double v = obey_ ? std::min(x.v, near_[k]->ceiling) : x.v, a = there.acceleration(v),
                   long_enough = way / x.v;
            // it brakes at least so much on the way, so it is no faster there
            for (int n = 0; n < 3 && a < top && !there.flat(); ++n) {
                const double steadily = std::min(p, a),
                             root = std::sqrt(std::max(0.0, x.v * x.v - 2 * steadily * way)),
                             last = a;
                long_enough = 2 * way / (x.v + root);
                v = std::min(v, root);
                a = there.acceleration(v);
                if (a < 1.02 * last) break;
            }
            jerk = std::min(jerk, there.jerk(v, std::min(top, a)));
            if (a >= top || near_[k] == cap_at_ || near_[k]->begin < strict_) continue;
            const double t =
                (long_enough * (gentle_ ? 0.7 : 1) * before_it - (p - a)) / (rate + before_it);
            if (t < time) {
                time = std::max(0.0, t);
                at = near_[k];
                allowed = a;
            }
        }
        return time;
    }
    void cap_until(const Stretch* at, double most) noexcept {
        cap_at_ = at;
        cap_ = most;
    }
    // Releasing p on the way to a speed: the jerk of each half, and the speed that it takes. With
    // constant jerk to a stand v falls as the power 2/3 of the way that is left and p as the power
    // 1/3; where a stretch is entered its limits count.
    Release release(double s, double v, double p, double to = 0) const noexcept {
        if (!(p > 0)) return {limits().jerk(v, 0), limits().jerk(v, 0), 0};
        if (limits().flat() && near_count_ == 0)
            return {limits().j, limits().j, p * p / (2 * limits().j)};
        Release r{limits().jerk(v, p), limits().jerk(v, p / 2), 0};
        const double way = r.upper > 0 ? (to + std::max(0.0, v - to) / 3) * p / r.upper : 0;
        for (std::uint32_t k = 0; k < near_count_ && near_[k]->begin - s < way; ++k) {
            const Limits& there = near_[k]->limits;
            if (there.flat()) {
                r.upper = std::min(r.upper, there.j);
                r.lower = std::min(r.lower, there.j);
                continue;
            }
            const double left = std::clamp(1 - (near_[k]->begin - s) / way, 0.0, 1.0),
                         root = to > 0 ? left : std::cbrt(left);
            const double u = to + (v - to) * root * root;
            if (root > 0.5) r.upper = std::min(r.upper, there.jerk(u, p * root));
            r.lower = std::min(r.lower,
                               there.jerk(std::min(u, to + (v - to) / 4), p * std::min(0.5, root)));
        }
        r.drop =
            r.upper > 0 && r.lower > 0 ? p * p * (0.375 / r.upper + 0.125 / r.lower) : kInfinity;
        return r;
    }

private:
    bool enter() noexcept {
        now_ = road_.stretch(++stretch_);
        if (now_ == nullptr) return false;
        border_ = road_.end_of(stretch_);
        const PathState& x = state();
        if (obey_ && x.v > now_->ceiling * (1 + kCeiling)) return false;
        if (std::abs(x.a) <= now_->limits.acceleration(x.v) * (1 + kEntering)) return true;
        b_.refused_ = now_->begin;
        return false;
    }
    Braking& b_;
    Road& road_;
    const Stretch* now_ = nullptr;
    std::uint32_t stretch_ = 0;
    double border_ = 0;
    bool obey_, gentle_;
    double strict_;
    std::uint32_t near_count_ = 0;
    std::array<const Stretch*, 6> near_;
    const Stretch* cap_at_ = nullptr;
    double cap_ = 0;
};

void Braking::stand() noexcept {
    count_ = falling_ = 0;
    at_[0] = {};
    peak_ = duration_ = aim_time_ = 0;
    aims_ = false;
    possible_ = true;
}

void Braking::along(Road& road, const PathState& from, bool obey) noexcept {
    way(road, from, obey, nullptr);
    aims_ = false;
}

void Braking::by_way_of(const Aim& aim, Road& road, const PathState& from) noexcept {
    way(road, from, true, &aim);
    aims_ = true;
}

// First in the hope that the speed will have fallen enough wherever a stretch allows little
// acceleration; where that fails, lowering it in time there and behind.
void Braking::way(Road& road, const PathState& from, bool obey, const Aim* aim) noexcept {
    double strict = kInfinity;
    for (int attempt = 0; attempt < 3; ++attempt) {
        refused_ = kInfinity;
        if (walk(road, from, obey, attempt == 2, strict, aim) || !(refused_ < kInfinity)) break;
        strict = attempt == 0 ? refused_ : 0;
    }
    duration_ = aim_time_ = 0;
    for (std::uint32_t i = 0; i < count_; ++i) {
        duration_ += time_[i];
        if (i + 1 == arrival_) aim_time_ = duration_;
    }
}

bool Braking::walk(Road& road, const PathState& from, bool obey, bool gentle, double strict,
                   const Aim* aim) noexcept {
    count_ = falling_ = arrival_ = 0;
    possible_ = false;
    at_[0] = from;
    peak_ = from.v;
    Walk walk(*this, road, obey, gentle, strict);
    if (!walk.begin()) return false;
    bool cut = false;
    const PathState& first = walk.state();
    // Already there with more: it can only be lowered. Nothing leads there.
    if (std::abs(first.a) > walk.limits().acceleration(first.v) * (1 + kEntering) &&
        (first.a > 0 || first.s > 0))
        return false;
    while (walk.state().a > 0) {
        const PathState x = walk.state();
        const Limits& limits = walk.limits();
        double to = 0;
        // in parts, and no further than the stretch: its limits are not those of the next
        if (!limits.flat()) {
            const double inside = (walk.border() - x.s) / x.v * 1.05;
            to = std::max(x.a < 0.05 * limits.a ? 0 : 0.75 * x.a,
                          x.a - std::max(inside, 1e-5) * limits.jerk(x.v, x.a));
        }
        const double jerk = rising_jerk(x.v, x.a, to, limits);
        if (!(jerk > 0) || !walk.add((x.a - to) / jerk, -jerk, cut)) return false;
        if (!cut) walk.settle(walk.state().v, to);
        peak_ = walk.state().v;
    }
    falling_ = count_;
    double step = kInfinity, least = 0;  // the speed to brake to
    if (aim != nullptr) {
        const PathState x = walk.state();
        if (x.s > aim->at) return false;
        walk.look(x.v * std::max(0.0, -x.a) / walk.limits().j);
        // or what releasing at once ends at
        least = std::min(aim->speed,
                         x.v - walk.release(x.s, x.v, std::max(0.0, -x.a), aim->speed).drop);
        if (!(least > 0)) return false;
    }
    int refined = 0;
    for (std::uint32_t i = 0; i < 2 * kMost; ++i) {
        const PathState x = walk.state();
        const Limits& limits = walk.limits();
        const double v = x.v, p = std::max(0.0, -x.a);
        if (v <= 1e-9 && p <= 1e-9) {
            walk.settle(0, 0);
            return possible_ = true;
        }
        // steadily to there, through whatever lies between
        if (aim != nullptr && p <= 1e-9 && v <= least * (1 + 1e-9)) {
            if (arrival_ == 0) arrival_ = count_;
            if (x.s >= aim->at) {
                aim = nullptr;
                least = 0;
                step = kInfinity;
            } else {
                if (!walk.add((aim->at - x.s) / v * (1 + 1e-12) + 1e-12, 0, cut)) return false;
                continue;
            }
        }
        const double here = limits.acceleration(v), rise = limits.jerk(v, p);
        if (!(here > 0) || !(rise > 0)) return false;
        const double most = std::min(here, walk.cap());
        // How p is to change, for how long at the most.
        double time = kInfinity, to = most;
        if (limits.flat()) {
            if (std::abs(p - most) > 1e-12 * most) time = std::abs(most - p) / rise;
        } else {
            if (!(step < kInfinity))
                step = ((v - least) / std::max(most, p) + 2 * std::sqrt((v - least) / limits.j)) /
                       kSteps;
            if (i > 0 && i % 24 == 0) step *= 2;  // it takes longer than estimated
            const double v2 = v * v, v3 = v2 * v;
            const double taken = std::max(
                {limits.bend * v2 / limits.a, limits.turning * v * std::max(p, most) / limits.j,
                 limits.along * v3 / limits.j, limits.across * v3 / limits.j, kFaint});
            time = step / taken;
            if (p > most) {
                time = std::min(time, (p - most) / rise);
                to = p - rise * time;
            } else if (p < most * (1 - kEntering)) {  // up to what is allowed here
                const double jerk = limits.jerk(v, std::min(most, p + rise * time));
                if (!(jerk > 0)) return false;
                time = std::min(time, (most - p) / jerk);
                to = p + jerk * time;
            } else {  // and on with it, as it grows
                to = std::min(limits.acceleration(std::max(0.0, v - p * time)), walk.cap());
                if (to > p) to = std::max(p, std::min(to, p + limits.jerk(v, to) * time));
            }
        }
        const double rate = time < kInfinity ? (to - p) / time : 0;
        // more is never reached
        double top = std::max(p, std::min(to, std::sqrt(rise * (v - least) + p * p / 2)));
        // What is to come within the way on which p, or what it may become here, could be released.
        walk.look(v * top / rise);
        // Until when? There must be speed left for the release: v(t) - least = p(t)^2 / (2 mean).
        double mean = walk.release(x.s, v, top, least).mean();
        for (int k = 0; k < 4 && !(mean > 0) && top > p; ++k) {
            time /= 2;
            top = p + (top - p) / 2;
            to = p + rate * time;
            mean = walk.release(x.s, v, top, least).mean();
        }
        const double spare = mean > 0 ? v - least - p * p / (2 * mean) : 0,
                     k = mean > 0 ? 1 + rate / mean : 0;
        double release_at = 0;
        if (spare > 0) {
            const double root = p * k * p * k + 2 * rate * k * spare,
                         sum = root >= 0 ? p * k + std::sqrt(root) : 0;
            release_at = sum > 0 ? 2 * spare / sum : kInfinity;
        }
        // what is there may be less than here
        for (int n = 0; n < 3 && release_at > 0 && release_at <= time && walk.varied(); ++n) {
            const double t = release_at, q = p + rate * t, u = v - t * (p + rate * t / 2);
            const Release there =
                walk.release(x.s + t * (v - t * (p / 2 + rate * t / 6)), u, q, least);
            const double excess = std::min(there.drop, 2 * v) - (u - least);
            if (!(excess > 1e-3 * v)) break;
            release_at = std::max(
                0.0, t - excess / std::max(q * (1 + rate / std::max(there.mean(), mean / 4)),
                                           excess / (0.5 * t)));
        }
        const Stretch* narrow = nullptr;
        double allowed = 0;
        const double longest = std::min(time, release_at);
        const double lower_at =
            walk.time_to_lower(rate, top, std::min(rise, limits.jerk(v, top)), longest,
                               aim != nullptr ? aim->at : kInfinity, narrow, allowed);
        if (!(lower_at < kInfinity)) return false;
        if (lower_at > 0) {
            if (!walk.add(lower_at, -rate, cut)) return false;
            if (cut) continue;
            if (lower_at == time) walk.settle(walk.state().v, -to);
        }
        if (narrow != nullptr) {
            walk.cap_until(narrow, allowed);
            continue;
        }
        if (lower_at < release_at) continue;
        // Now all of it must be released; unless it turns out that there is still speed to lose
        // before.
        const PathState y = walk.state();
        const double q = std::max(0.0, -y.a), there_is = y.v - least;
        const Release release = walk.release(y.s, y.v, q, least);
        if (release.drop < kWorthWhile * there_is && refined < 3 && lower_at > 0) {
            ++refined;
            continue;
        }
        if (release.drop > 1.3 * there_is + 5e-3 * y.v + 1e-9) return false;
        // With the jerk that ends both at once, as far as the limits allow; where they do not yet,
        // with what there is: it grows.
        for (int pieces = 0; q > 0; ++pieces) {
            const PathState z = walk.state();
            const double left = -z.a, speed = z.v - least;
            if (left <= 1e-9 * most ||
                (left * left <= 1e-9 * v * rise && std::abs(speed) <= 1e-9 * v))
                break;
            if (pieces == 24 || !(speed > 0)) return false;
            const double needed = left * left / (2 * speed),
                         jerk = walk.limits().jerk(std::max(0.0, z.v), left);
            if (!(jerk > 0)) return false;
            const bool enough = needed <= jerk * (1 + 5e-3);
            if (!walk.add(left / (enough ? needed : jerk) * (enough ? 1 : 0.1),
                          enough ? needed : jerk, cut))
                return false;
            if (enough && !cut) break;
        }
        const PathState& end = walk.state();
        if (std::abs(end.v - least) > 1e-6 * (v + 1e-3) || std::abs(end.a) > 1e-5 * (most + 1))
            return false;
        walk.settle(least, 0);
        if (aim == nullptr) return possible_ = true;
        if (walk.state().s > aim->at + 1e-8) return false;
    }
    return false;
}

bool Braking::arrives(double c, double d) const noexcept {
    if (peak_ <= c * (1 + kCeiling)) return true;
    const auto rest = [&](const PathState& x, std::uint32_t i) {
        return x.v - release_drop(x.v, -x.a, *limits_[i]);
    };
    const PathState& first = at_[falling_];
    if (falling_ == count_) return first.v <= c * (1 + kCeiling);
    if (rest(first, falling_) <= c) {  // the release ends below it anyhow
        const double a = first.a, jerk = limits_[falling_]->jerk(first.v, -a), way = d - first.s;
        if (a >= 0 || first.v <= c * (1 + kCeiling))
            return first.v <= c * (1 + kCeiling) || way >= 0;
        if (release_distance_to(first.v, a, std::max(c, first.v - a * a / (2 * jerk)), jerk) <= way)
            return true;
        // held so long, then released
        return 2 * jerk * c >= a * a && first.v * first.v - c * c <= -2 * a * way;
    }
    std::uint32_t i = falling_;
    while (i + 1 < count_ && rest(at_[i + 1], i) > c) ++i;
    double low = 0, high = time_[i];
    for (int k = 0; k < 20; ++k) {
        const double middle = (low + high) / 2;
        (rest(advanced(at_[i], jerk_[i], middle), i) > c ? low : high) = middle;
    }
    const PathState x = advanced(at_[i], jerk_[i], high);
    const double p = -x.a;
    if (!(p > 0)) return x.s <= d;
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
