#include "kernel/motion/thread_follower.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "kernel/motion/spindle_observer.hpp"
#include "tests/seeds.hpp"

namespace polyturn::kernel {
namespace {

constexpr double kDt = 0.001;

PathRecord thread_record(double length, double lead, double start_angle = 0) {
    PathRecord record{};
    record.length = length;
    record.v_max = 200;
    record.a_max = 1000;
    record.j_max = 20000;
    record.lead = lead;
    record.start_angle = start_angle;
    return record;
}

struct Driven {
    // degrees: greatest distance of the true spindle angle from where the path says it is
    double phase = 0;
    double a = 0, j = 0;  // greatest raw differences
    bool done = false;
    double end = 0;
    std::uint64_t began = 0, ended = 0;
};

// True angle as a function of time; the path is judged between two places of the thread.
Driven drive(const std::vector<PathRecord>& thread, const std::function<double(double)>& angle,
             double from, double to, const std::function<double(double)>& turns_at) {
    SpindleObserver observer;
    observer.configure(kDt, 4096, kDt);
    ThreadFollower follower;
    follower.configure(kDt);
    follower.clear(50);
    double length = 0;
    std::vector<double> begin;
    for (const PathRecord& record : thread) {
        begin.push_back(length);
        length += record.length;
        EXPECT_TRUE(follower.append(record));
    }
    Driven driven;
    double s1 = 0, s2 = 0, s3 = 0;
    for (int tick = 0; tick < 60'000; ++tick) {
        const double now = tick * kDt;
        observer.update(static_cast<std::int64_t>(std::floor(angle(now - kDt) * 4096 / 360)));
        if (tick < 1500) continue;
        const ThreadStep step = follower.tick(
            {observer.angle(kDt), observer.speed(kDt), observer.acceleration(kDt), false, 0});
        const double s = begin[step.record - 50] + step.s;
        driven.began += step.began_to - step.began_from;
        driven.ended += step.ended_to - step.ended_from;
        driven.a = std::max(driven.a, std::abs(s - 2 * s1 + s2) / (kDt * kDt));
        driven.j = std::max(driven.j, std::abs(s - 3 * s1 + 3 * s2 - s3) / (kDt * kDt * kDt));
        s3 = s2;
        s2 = s1;
        s1 = s;
        if (s > from && s < to) {
            const double off =
                std::remainder(angle(now + kDt) - thread[0].start_angle - 360 * turns_at(s), 360.0);
            driven.phase = std::max(driven.phase, std::abs(off));
        }
        if (step.phase == ThreadPhase::Done) {
            driven.done = true;
            driven.end = s;
            break;
        }
    }
    return driven;
}

TEST(ThreadFollower, CrossesAPlaneAtTheSameAngleWhateverPhaseAndSpeed) {
    std::mt19937_64 random(test_seed(11));
    for (double rpm : {300.0, 500.0, 800.0, 1000.0, 1200.0, 1500.0}) {
        SCOPED_TRACE(rpm);
        for (int i = 0; i < 170; ++i) {  // some 1000 passes
            const double begin = std::uniform_real_distribution<>(0, 360)(random);
            const Driven driven = drive(
                {thread_record(20, 2, 77)}, [&](double t) { return begin + rpm * 6 * t; }, 8, 13,
                [](double s) { return s / 2; });
            ASSERT_TRUE(driven.done);
            ASSERT_EQ(driven.end, 20);
            ASSERT_LT(driven.phase, 0.02);
            ASSERT_LT(driven.a, 1010);
            ASSERT_LT(driven.j, 20200);
        }
    }
}

TEST(ThreadFollower, KeepsThePitchWithinAMicrometreWhileTheSpindleSwings) {
    for (double rpm : {300.0, 600.0, 1000.0, 1200.0, 1500.0}) {
        SCOPED_TRACE(rpm);
        const auto angle = [&](double t) {
            return rpm * 6 * (t + 0.2 * (1 - std::cos(2 * M_PI * t)) / (2 * M_PI));
        };
        const Driven driven =
            drive({thread_record(60, 2)}, angle, 8, 50, [](double s) { return s / 2; });
        ASSERT_TRUE(driven.done);
        EXPECT_LT(driven.phase * 2000 / 360, 1.0);
        EXPECT_LT(driven.a, 1010);
        EXPECT_LT(driven.j, 20200);
    }
}

TEST(ThreadFollower, TurnsBothWays) {
    const Driven driven = drive(
        {thread_record(20, 1.5, 30)}, [](double t) { return 100 - 6000 * t; }, 8, 13,
        [](double s) { return -s / 1.5; });
    ASSERT_TRUE(driven.done);
    EXPECT_LT(driven.phase, 0.02);
}

TEST(ThreadFollower, ChainsRecordsAndClosesTheGapWhereTheLeadJumps) {
    const auto turns = [](double s) { return s < 10 ? s / 1 : 10 + (s - 10) / 2; };
    const Driven driven = drive(
        {thread_record(10, 1), thread_record(30, 2)}, [](double t) { return 6 * 900 * t; }, 20, 35,
        turns);
    ASSERT_TRUE(driven.done);
    EXPECT_EQ(driven.end, 40);
    EXPECT_EQ(driven.began, 2u);
    EXPECT_EQ(driven.ended, 2u);
    EXPECT_LT(driven.phase, 0.02);
    EXPECT_LT(driven.a, 1010);
    EXPECT_LT(driven.j, 20200);
}

TEST(ThreadFollower, FollowsALeadThatGrows) {
    PathRecord record = thread_record(60, 1);
    record.lead_change = 0.05;
    const auto turns = [](double s) { return (-1 + std::sqrt(1 + 2 * 0.05 * s)) / 0.05; };
    const Driven driven = drive(
        {record}, [](double t) { return 6 * 700 * t; }, 10, 50, turns);
    ASSERT_TRUE(driven.done);
    EXPECT_LT(driven.phase, 0.02);
}

TEST(ThreadFollower, RefusesALeadTimesSpeedAboveTheCeiling) {
    ThreadFollower follower;
    follower.configure(kDt);
    follower.clear(1);
    ASSERT_TRUE(follower.append(thread_record(20, 10)));
    for (int tick = 0; tick < 500; ++tick) {
        // 250 mm/s asked for, 200 allowed
        const ThreadStep step = follower.tick({tick * 9.0, 9000, 0, false, 0});
        ASSERT_TRUE(step.too_fast);
        ASSERT_EQ(step.s, 0);
    }
}

}  // namespace
}  // namespace polyturn::kernel
