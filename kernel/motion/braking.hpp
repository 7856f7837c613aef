// Braking to standstill from a state on a road, as hard as the limits allow at each point and each
// speed on it.
//
//   p |        .--.  .----.         p = -a, over time. p rises with the jerk there is until it is
//     |     .-'    ''      '.       all that is allowed, which grows as the speed falls; it is
//     |   .'                 '.     lowered in time where the next stretch allows less; it is
//     +--+---------+----+------+--> t  released when just enough speed is left for it. If a > 0,
//        | stretch | ...            that is released first.
//
// Limits that depend on speed (bends) are taken piece by piece at the beginning of each, where
// speed is highest, and at its greater p; limits.hpp says why that is safe. Where they do not
// (lines), pieces end only where something changes, so on a single stretch the result is the
// time-optimal profile of jerk_profile.hpp.
//
// Given      v - w of speed left above the aim w, p now, p rising at `rate`, and jerk J for its
//            release. When must it begin?
// Formula    v(t) - w = p(t)^2 / (2 J):  with k = 1 + rate/J and S = v - w - p^2/(2 J), the speed
//            to spare,
//                t = 2 S / (p k + sqrt(p^2 k^2 + 2 rate k S))                                  (1)
//            J is estimated from what the stretches on the way of the release allow; where that was
//            too much, t is made less.
// Attempts   First in the hope that the speed will have fallen enough wherever a stretch allows
//            little acceleration. If one refuses, p is lowered in time there and behind: it takes
//            the way no less time than at the present speed. Then everywhere, and earlier.
//
// Invariants of a braking that is possible()
//   I1  It ends at rest, v = 0 and a = 0.
//   I2  It ends no farther than the road does.
//   I3  Its pieces follow each other in time: none takes less than nothing.
//
// Right     Every piece is within the limits of its stretch, and every stretch is entered below its
//           speed limit, or possible() is false. So a braking that was possible once can be
//           followed to its end whatever else comes into view.
// Cost      a line: some 6 pieces; a bend: 6 to 20, each a handful of square roots, 20 to 50 ns.
// Weakness  not quite the hardest braking on bends (a percent or two of the travel), and sometimes
//           none is found where there is one; both cost time only, for the profile committed before
//           still holds.
#pragma once
#include "kernel/motion/jerk_profile.hpp"
#include "kernel/motion/road.hpp"

namespace polyturn::kernel {

class Braking {
public:
    // From `from` (s on the road) to standstill. `obey`: speed limits count.
    void along(Road& road, const PathState& from, bool obey = true) noexcept;
    // First only to a speed, without acceleration from the point `at` on where a stretch begins;
    // from there to standstill.
    struct Aim {
        double at, speed;
    };
    void by_way_of(const Aim& aim, Road& road, const PathState& from) noexcept;
    // At standstill.
    void stand() noexcept;

    [[nodiscard]] bool possible() const noexcept { return possible_; }
    // what it cost, about
    [[nodiscard]] std::uint32_t pieces() const noexcept { return count_ + 4; }
    [[nodiscard]] double distance() const noexcept { return at_[count_].s - at_[0].s; }
    [[nodiscard]] double end() const noexcept { return at_[count_].s; }  // on the road
    // on the road: no faster behind it
    [[nodiscard]] double falls_from() const noexcept { return at_[falling_].s; }
    [[nodiscard]] double duration() const noexcept { return duration_; }
    // by way of a slower stretch
    [[nodiscard]] bool aims() const noexcept { return aims_; }
    // when it has the speed of that
    [[nodiscard]] double aim_time() const noexcept { return aim_time_; }
    [[nodiscard]] double peak() const noexcept { return peak_; }  // highest speed
    // Leaving it underway, can the speed be c, without falling below it, from the point d of the
    // road on?
    [[nodiscard]] bool arrives(double c, double d) const noexcept;
    // Where it is `dt` after `time`; s is what is moved in between. At standstill at its end.
    [[nodiscard]] PathState follow(double time, double dt) const noexcept;

private:
    // a bend needs some 20; more: a piece ends wherever a stretch does
    static constexpr std::uint32_t kMaxPieces = 160;
    void find(Road& road, const PathState& from, bool obey, const Aim* aim) noexcept;
    bool walk(Road& road, const PathState& from, bool obey, bool gentle, double strict,
              const Aim* aim) noexcept;
    class Walk;
    struct Release;
    std::uint32_t count_ = 0, falling_ = 0;  // pieces; the first of them without a > 0
    std::uint32_t arrival_ = 0;              // pieces up to where it has the speed that is aimed at
    bool possible_ = false;
    bool aims_ = false;
    double refused_ = 0;  // where a stretch begins that allowed less acceleration
    double peak_ = 0, duration_ = 0, aim_time_ = 0;
    // at the beginning of each piece and at the end; s on the road
    std::array<PathState, kMaxPieces + 1> at_;
    std::array<double, kMaxPieces> time_, jerk_;
    std::array<const Limits*, kMaxPieces> limits_;  // good as long as the road is
};

}  // namespace polyturn::kernel
