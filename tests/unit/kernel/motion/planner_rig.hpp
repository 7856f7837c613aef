// Drives a PathPlanner through a list of records as the cyclic thread would and judges every tick
// by raw differences of the position along the whole path: what a drive would see.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "kernel/motion/path_planner.hpp"

namespace polyturn::kernel {

struct Judged {
    std::int64_t ticks = 0;
    double worst_v = 0, worst_a = 0, worst_j = 0;  // of their limits; 1 is the limit
    std::string fault;                             // empty: none
    std::vector<double> position;                  // at each tick's end, along the whole path
    double end_s = 0;
    [[nodiscard]] bool complete() const { return fault.empty(); }
};

class PlannerRig {
public:
    double dt = 0.001;
    std::uint32_t horizon = 1024;
    std::int64_t tick_limit = 400'000;
    bool keep_positions = false;
    std::function<void(std::int64_t tick, PathInput&)> operate = [](std::int64_t, PathInput&) {};
    // How many records are in the ring at a tick.
    std::function<std::uint64_t(std::int64_t tick, std::uint64_t driven)> there =
        [](std::int64_t, std::uint64_t) { return ~0ull; };
    std::unique_ptr<PathPlanner> planner = std::make_unique<PathPlanner>();

    Judged drive(const std::vector<PlannedRecord>& records) {
        Judged judged;
        std::vector<double> begin(records.size() + 1, 0.0);
        for (std::size_t i = 0; i < records.size(); ++i)
            begin[i + 1] = begin[i] + records[i].length;
        planner->configure(dt, horizon);
        constexpr std::uint64_t kBase = 1000;
        planner->clear(kBase);
        PathInput input;
        std::array<double, 4> s{};          // positions, newest first
        std::array<std::uint64_t, 5> at{};  // records at those, newest first
        std::uint64_t began = 0, ended = 0;
        for (std::int64_t tick = 0; tick < tick_limit; ++tick) {
            operate(tick, input);
            const std::uint64_t available =
                std::min<std::uint64_t>(records.size(), there(tick, ended));
            while (planner->wants_record() && planner->next_record() - kBase < available)
                planner->append(records[planner->next_record() - kBase]);
            const PathStep step = planner->tick(input);
            if (step.began_to > step.began_from) {
                if (step.began_from - kBase != began)
                    return fail(judged, tick, "a record did not begin in turn");
                began = step.began_to - kBase;
            }
            if (step.ended_to > step.ended_from) {
                if (step.ended_from - kBase != ended)
                    return fail(judged, tick, "a record did not end in turn");
                ended = step.ended_to - kBase;
                double last = 0;
                for (auto i = step.ended_from; i < step.ended_to; ++i) {
                    if (planner->end_fraction(i) < last || planner->end_fraction(i) > 1)
                        return fail(judged, tick, "times in a tick");
                    last = planner->end_fraction(i);
                }
            }
            if (available == 0) continue;
            const std::uint64_t now =
                std::min<std::uint64_t>(step.record - kBase, records.size() - 1);
            std::rotate(s.rbegin(), s.rbegin() + 1, s.rend());
            std::rotate(at.rbegin(), at.rbegin() + 1, at.rend());
            s[0] = begin[now] + step.s;
            at[0] = now;
            if (keep_positions) judged.position.push_back(s[0]);
            judged.ticks = tick + 1;
            judged.end_s = s[0];
            // The widest of what the records that the differences span allow.
            const auto widest = [&](std::uint64_t oldest) {
                Limits most{0, 0, kNoLimit, kNoLimit, kNoLimit, kNoLimit};
                for (std::uint64_t i = oldest; i <= now; ++i) {
                    if (records[i].length > 0) most.widen(records[i].limits());
                }
                return most;
            };
            double v_most = 0;
            for (std::uint64_t i = at[1]; i <= now; ++i) {
                if (records[i].length > 0) v_most = std::max(v_most, records[i].v_max);
            }
            // Rounding of positions of some metres, after differences: not motion.
            const double noise = 4e-15 * std::max(1.0, s[0]);
            const double v = (s[0] - s[1]) / dt, v_before = std::max(0.0, (s[0] - s[2]) / (2 * dt)),
                         v_3 = std::max(0.0, (s[0] - s[3]) / (3 * dt));
            const double a = (s[0] - 2 * s[1] + s[2]) / (dt * dt),
                         a_3 = (s[0] - s[1] - s[2] + s[3]) / (2 * dt * dt);
            const double j = (s[0] - 3 * s[1] + 3 * s[2] - s[3]) / (dt * dt * dt);
            if (s[0] < s[1] - noise) return fail(judged, tick, "moved backwards");
            const auto share = [&](double value, double error, double most) {
                return most > 0 ? (std::abs(value) - error) / most : 0.0;
            };
            judged.worst_v = std::max(judged.worst_v, share(v, noise / dt, v_most));
            const Limits two = widest(at[2]), three = widest(at[3]);
            judged.worst_a = std::max(
                judged.worst_a,
                share(std::hypot(a, two.bend * v_before * v_before), 2 * noise / (dt * dt), two.a));
            const double v3 = v_3 * v_3 * v_3;
            const double whole_j =
                std::hypot(std::abs(j) + three.along * v3,
                           three.turning * v_3 * std::abs(a_3) + three.across * v3);
            judged.worst_j =
                std::max(judged.worst_j, share(whole_j, 4 * noise / (dt * dt * dt), three.j));
            if (judged.worst_v > 1.01) return fail(judged, tick, "too fast");
            if (judged.worst_a > 1.01) return fail(judged, tick, "too much acceleration");
            if (judged.worst_j > 1.01) return fail(judged, tick, "too much jerk");
            if (planner->anomalies() != 0)
                return fail(judged, tick, "no step within limits was found");
            if (step.stands == Stands::BlockEnd) planner->step_block();
            if (ended == records.size() && planner->at_rest()) {
                if (step.s != records.back().length)
                    return fail(judged, tick, "did not end at the end");
                return judged;
            }
        }
        return fail(judged, tick_limit, "never ended");
    }

private:
    static constexpr double kNoLimit = std::numeric_limits<double>::infinity();
    static Judged fail(Judged& judged, std::int64_t tick, const char* why) {
        judged.fault = std::string(why) + " at tick " + std::to_string(tick) + ", s " +
                       std::to_string(judged.end_s) + ", of limits v " +
                       std::to_string(judged.worst_v) + " a " + std::to_string(judged.worst_a) +
                       " j " + std::to_string(judged.worst_j);
        return judged;
    }
};

// A record that bends: what speed takes of its limits, and the speed limit that leaves some of
// them, as the channel makes it.
inline void bend_record(PlannedRecord& r, double curvature, double change) {
    r.bend = curvature;
    r.turning = 3 * curvature;
    r.along = curvature * curvature;
    r.across = change;
    r.v_max = std::min(r.v_max, std::sqrt(0.95 * r.a_max / curvature));
    const double x = r.along / r.j_max, y = r.across / r.j_max, square = x * x + y * y,
                 half = 0.1 * x + 0.08 * y;
    r.v_max =
        std::min(r.v_max, std::cbrt((std::sqrt(half * half + 0.97 * square) - half) / square));
}

// Random programs: what blends, arcs, rapids and tiny segments leave in the ring; with `bends` arcs
// and transitions too.
inline std::vector<PlannedRecord> random_records(std::uint64_t seed, std::size_t count,
                                                 bool bends = false) {
    std::mt19937_64 random(seed);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<>(low, high)(random);
    };
    const auto log_between = [&](double low, double high) {
        return std::exp(between(std::log(low), std::log(high)));
    };
    const auto chance = [&](double p) { return between(0, 1) < p; };
    std::vector<PlannedRecord> records;
    const double a = log_between(200, 10'000), j = log_between(5'000, 500'000),
                 v = log_between(20, 800);
    const bool tiny = chance(0.3), alike = chance(0.3);
    double feed = log_between(5, 500);
    bool rapid = false;
    double curvature = 0;  // goes on over some records, as on a spline
    for (std::size_t i = 0; i < count; ++i) {
        PlannedRecord r;
        r.length = tiny ? log_between(0.001, 0.5) : log_between(0.001, 100);
        if (chance(0.05)) feed = log_between(5, 500);
        if (chance(0.05)) rapid = !rapid;
        r.v_max = alike ? v : v * (chance(0.3) ? log_between(0.05, 1) : between(0.9, 1));
        r.a_max = alike ? a : a * (chance(0.3) ? between(0.3, 1) : 1);
        r.j_max = alike ? j : j * (chance(0.3) ? between(0.3, 1) : 1);
        r.feed = feed;
        r.feed_mode = rapid ? FeedMode::Rapid : FeedMode::PerMinute;
        r.stop_after = chance(tiny ? 0.01 : 0.1);
        r.block_end = chance(0.7);
        if (bends) {
            if (chance(0.4))
                curvature = chance(0.3) ? 0 : a / std::pow(v * log_between(0.05, 1.5), 2);
            else
                curvature *= between(0.9, 1.1);
            r.a_max = a;
            r.j_max = j;
            if (curvature > 0)
                bend_record(r, curvature,
                            chance(0.3) ? j / std::pow(v * log_between(0.05, 2), 3)
                                        : curvature * curvature * between(0, 0.5));
            r.length = std::min(r.length, 2 * r.v_max);
        }
        if (chance(0.05)) r.length = 0;
        records.push_back(r);
    }
    while (!records.empty() && records.back().length == 0) records.pop_back();
    if (!records.empty()) records.back().stop_after = true;
    return records;
}

}  // namespace polyturn::kernel
