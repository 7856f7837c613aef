#include "kernel/motion/path_planner.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "planner_rig.hpp"
#include "tests/seeds.hpp"

namespace polyturn::kernel {
namespace {

TEST(PathPlanner, KeepsLimitsOnRandomRecords) {
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
        SCOPED_TRACE(seed);
        PlannerRig rig;
        const Judged judged = rig.drive(random_records(test_seed(seed), 60));
        ASSERT_EQ(judged.fault, "");
    }
}

TEST(PathPlanner, KeepsLimitsWhenOverridesHoldsAndSingleBlockComeAtAnyTick) {
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
        SCOPED_TRACE(seed);
        PlannerRig rig;
        std::mt19937_64 random(test_seed(seed * 77));
        rig.operate = [&](std::int64_t, PathInput& input) {
            const auto dice = random() % 1000;
            if (dice < 5)
                input.feed_override = static_cast<double>(random() % 201) / 100;
            else if (dice < 8)
                input.rapid_override = static_cast<double>(random() % 101) / 100;
            else if (dice < 11)
                input.hold = true;
            else if (dice < 40)
                input.hold = false;
            else if (dice < 43)
                input.single_block = !input.single_block;
            if (dice < 30) input.feed_override = std::max(input.feed_override, 0.05);
            if (dice < 30) input.rapid_override = std::max(input.rapid_override, 0.05);
        };
        const Judged judged = rig.drive(random_records(test_seed(seed), 40));
        ASSERT_EQ(judged.fault, "");
    }
}

TEST(PathPlanner, KeepsOnBendsWhatTheSpeedLeaves) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        SCOPED_TRACE(seed);
        PlannerRig rig;
        std::mt19937_64 random(test_seed(seed * 77));
        if (seed % 2 == 0) {
            rig.operate = [&](std::int64_t, PathInput& input) {
                const auto dice = random() % 1000;
                if (dice < 5)
                    input.feed_override = static_cast<double>(5 + random() % 196) / 100;
                else if (dice < 11)
                    input.hold = true;
                else if (dice < 40)
                    input.hold = false;
            };
        }
        const Judged judged = rig.drive(random_records(test_seed(seed), 40, true));
        ASSERT_EQ(judged.fault, "");
    }
}

PlannedRecord record(double length, double feed = 1e6) {
    PlannedRecord r;
    r.length = length;
    r.v_max = 300;
    r.a_max = 2000;
    r.j_max = 50'000;
    r.feed = feed;
    return r;
}

// Time-optimal rest to rest, jerk-limited.
double shortest_time(double length, double v, double a, double j) {
    const auto ramp = [&](double u) {
        return u <= a * a / j ? 2 * std::sqrt(u / j) : u / a + a / j;
    };
    if (ramp(v) * v <= length) return 2 * ramp(v) + (length - ramp(v) * v) / v;
    double low = 0, high = v;
    for (int i = 0; i < 200; ++i) {
        const double middle = (low + high) / 2;
        (ramp(middle) * middle <= length ? low : high) = middle;
    }
    return 2 * ramp(low);
}

TEST(PathPlanner, DrivesALineInTheTimeOfTheClosedForm) {
    for (double length : {0.001, 0.01, 0.1, 1.0, 5.0, 20.0, 100.0, 500.0}) {
        SCOPED_TRACE(length);
        PlannerRig rig;
        PlannedRecord r = record(length);
        r.stop_after = true;
        const Judged judged = rig.drive({r});
        ASSERT_EQ(judged.fault, "");
        const double best = shortest_time(length, 300, 2000, 50'000) / rig.dt;
        EXPECT_GE(static_cast<double>(judged.ticks), best);
        EXPECT_LE(static_cast<double>(judged.ticks), 1.01 * best + 3);
    }
}

TEST(PathPlanner, DrivesAHundredThousandTinySegmentsAsOneLine) {
    std::vector<PlannedRecord> records(100'000, record(0.1));
    records.back().stop_after = true;
    PlannerRig rig;
    const Judged judged = rig.drive(records);
    ASSERT_EQ(judged.fault, "");
    EXPECT_LE(static_cast<double>(judged.ticks),
              1.002 * shortest_time(10'000, 300, 2000, 50'000) / rig.dt);
}

TEST(PathPlanner, CarriesAccelerationOverBlendsOfLowerLimits) {
    std::vector<PlannedRecord> records;
    for (int i = 0; i < 4000; ++i) {
        records.push_back(record(0.08));
        records.push_back(record(0.02));
        records.back().v_max = 270;
        records.back().a_max = 1000;
        records.back().j_max = 20'000;
    }
    records.back().stop_after = true;
    PlannerRig rig;
    rig.horizon = 4000;
    const Judged judged = rig.drive(records);
    ASSERT_EQ(judged.fault, "");
    EXPECT_LE(static_cast<double>(judged.ticks),
              1.01 * shortest_time(400, 270, 1000, 20'000) / rig.dt);
}

TEST(PathPlanner, ArrivesAtASlowCornerWithoutFallingBelowIt) {
    std::vector<PlannedRecord> records{record(20), record(0.5), record(20)};
    records[1].v_max = 20;
    records[1].a_max = 1000;
    records[1].j_max = 20'000;
    records[2].stop_after = true;
    PlannerRig rig;
    rig.keep_positions = true;
    const Judged judged = rig.drive(records);
    ASSERT_EQ(judged.fault, "");
    for (std::size_t i = 1; i < judged.position.size(); ++i) {
        if (judged.position[i - 1] < 19.9 || judged.position[i] > 20.5) continue;
        EXPECT_GT((judged.position[i] - judged.position[i - 1]) / rig.dt, 19.5);
    }
}

TEST(PathPlanner, DoesTheSameWhetherTheRingIsFullOrJustFullEnough) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        const auto records = random_records(test_seed(seed), 300);
        PlannerRig full, late;
        full.horizon = late.horizon = 64;
        full.keep_positions = late.keep_positions = true;
        std::uint64_t driven = 0;
        late.there = [&](std::int64_t, std::uint64_t ended) { return driven = ended + 64; };
        const Judged a = full.drive(records), b = late.drive(records);
        ASSERT_EQ(a.fault, "");
        ASSERT_EQ(b.fault, "");
        ASSERT_EQ(a.position, b.position);
    }
}

TEST(PathPlanner, StandsWithinLimitsWhenTheRingRunsEmpty) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937_64 random(test_seed(seed));
        PlannerRig rig;
        std::uint64_t there = 1;
        rig.there = [&](std::int64_t, std::uint64_t) {
            return there += random() % 40 == 0 ? random() % 4 : 0;
        };
        const Judged judged = rig.drive(random_records(test_seed(seed), 60));
        ASSERT_EQ(judged.fault, "");
    }
}

TEST(PathPlanner, HoldStopsWithinTheBrakingDistanceAndResumes) {
    std::mt19937_64 random(test_seed(5));
    for (int i = 0; i < 200; ++i) {
        PathPlanner planner;
        planner.configure(0.001, 1024);
        planner.clear(0);
        PlannedRecord r = record(300);
        r.stop_after = true;
        planner.append(r);
        PathInput input;
        PathStep step;
        const int hold_at = static_cast<int>(random() % 900) + 2;
        for (int tick = 0; tick < hold_at; ++tick) step = planner.tick(input);
        const double limit =
            step.s + stopping_distance(step.speed, step.acceleration, 2000, 0.995 * 50'000);
        input.hold = true;
        for (int tick = 0; tick < 2000 && step.stands == Stands::Moving; ++tick)
            step = planner.tick(input);
        ASSERT_EQ(step.stands, Stands::Held);
        ASSERT_LE(step.s, limit + 1e-6);
        const double stood = step.s;
        ASSERT_EQ(planner.tick(input).s, stood);
        input.hold = false;
        for (int tick = 0; tick < 5000 && step.s < 300; ++tick) step = planner.tick(input);
        ASSERT_EQ(step.s, 300);
        ASSERT_EQ(planner.anomalies(), 0u);
    }
}

TEST(PathPlanner, FollowsFeedPerRevolutionAndOverride) {
    PathPlanner planner;
    planner.configure(0.001, 1024);
    planner.clear(0);
    PlannedRecord r = record(1000, 0.2);
    r.feed_mode = FeedMode::PerRevolution;
    r.spindle = 2;
    planner.append(r);
    double rev_s[kMaxSpindles] = {};
    PathInput input;
    input.spindle_rev_s = rev_s;
    EXPECT_EQ(planner.tick(input).stands, Stands::NoFeed);
    rev_s[1] = -20;
    PathStep step;
    for (int tick = 0; tick < 500; ++tick) step = planner.tick(input);
    EXPECT_NEAR(step.speed, 4, 1e-9);
    input.feed_override = 1.5;
    for (int tick = 0; tick < 500; ++tick) step = planner.tick(input);
    EXPECT_NEAR(step.speed, 6, 1e-9);
    input.feed_override = 0;
    for (int tick = 0; tick < 500; ++tick) step = planner.tick(input);
    EXPECT_EQ(step.speed, 0);
    EXPECT_EQ(step.stands, Stands::NoFeed);
}

TEST(PathPlanner, StandsBeforeARecordOfTheKernelAndGoesOnAfterIt) {
    PathPlanner planner;
    planner.configure(0.001, 1024);
    planner.clear(7);
    planner.append(record(5));
    PlannedRecord aux;
    aux.stop_before = true;
    planner.append(aux);
    PlannedRecord last = record(5);
    last.stop_after = true;
    planner.append(last);
    PathStep step;
    for (int tick = 0; tick < 1000 && step.stands != Stands::BeforeRecord; ++tick)
        step = planner.tick({});
    EXPECT_EQ(step.record, 8u);
    EXPECT_EQ(step.s, 0);
    planner.skip(9);
    for (int tick = 0; tick < 1000 && !(step.record == 9 && step.s == 5); ++tick)
        step = planner.tick({});
    EXPECT_EQ(step.ended_from, 9u);
    EXPECT_EQ(step.ended_to, 10u);
    EXPECT_EQ(planner.tick({}).stands, Stands::NoRecord);
}

TEST(PathPlanner, DoesNotBrakeForAWaitWhosePartnersAreThere) {
    for (const bool early : {true, false}) {
        PathPlanner planner;
        planner.configure(0.001, 1024);
        planner.clear(0);
        planner.append(record(50, 100));
        PlannedRecord wait;
        wait.stop_before = true;
        planner.append(wait);
        planner.append(record(50, 100));
        double slowest = 1e9;
        for (int tick = 0; tick < 900; ++tick) {
            if (early && tick == 300) planner.let_pass(1);
            const PathStep step = planner.tick({});
            if (tick > 200) slowest = std::min(slowest, step.speed);
        }
        EXPECT_EQ(slowest > 99, early);
    }
}

TEST(PathPlanner, EmergencyBrakesAtOnce) {
    PathPlanner planner;
    planner.configure(0.001, 1024);
    planner.clear(0);
    planner.append(record(500));
    PathStep step;
    for (int tick = 0; tick < 600; ++tick) step = planner.tick({});
    const double v = step.speed, s = step.s;
    PathInput input;
    input.emergency_dec = 10'000;
    for (int tick = 0; tick < 200; ++tick) step = planner.tick(input);
    EXPECT_EQ(step.speed, 0);
    EXPECT_NEAR(step.s - s, v * v / 20'000, 1e-6);
}

TEST(PathPlanner, WorksWithoutAJerkLimit) {
    PlannedRecord r = record(100);
    r.j_max = std::numeric_limits<double>::infinity();
    r.stop_after = true;
    PlannerRig rig;
    const Judged judged = rig.drive({r, r, r});
    ASSERT_EQ(judged.fault, "");
    EXPECT_LE(static_cast<double>(judged.ticks), 3 * (100.0 / 300 + 300.0 / 2000) * 1000 + 10);
}

}  // namespace
}  // namespace polyturn::kernel
