// Random programs through the whole pipeline: text, language, path maker, planner, positions of the
// axes. Judged on the raw differences of those positions, as the drives get them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "channels/language.hpp"
#include "channels/process/run_port.hpp"
#include "channels/records/record_sink.hpp"
#include "ipc/model/machine/load_machine.hpp"
#include "ipc/path/path_geometry.hpp"
#include "kernel/motion/path_planner.hpp"
#include "tests/seeds.hpp"

namespace polyturn {
namespace {

constexpr double kDt = 0.001;

class Pipeline {
public:
    Pipeline()
        : view_(channels::make_machine_view(*machine_.table, 1)),
          limits_(channels::path_limits(view_.machine, view_.table(), 1)) {}

    const channels::PathLimits& limits() const { return limits_; }

    // Records that a text makes; empty: it has an alarm.
    std::vector<PathRecord> records(const std::string& text) {
        auto own = std::make_unique<ChannelSegment>();
        auto kernel = std::make_unique<KernelSegment>();
        channels::RunPort port(*kernel, 1);
        port.configure(view_.machine, nullptr);
        channels::EventInbox inbox(*kernel, 0, *own);
        channels::RingOut ring(*own, *kernel, 0, 1024, inbox);
        channels::PathMaker maker(ring, limits_);
        channels::RecordSink sink(view_, maker, ring, nullptr, nullptr, {});
        channels::ProgramFiles files;
        const auto main = files.open_text(text, "random");
        const auto language = channels::make_language("fanuc", view_, sink, port, files);
        std::vector<PathRecord> all;
        if (!main || !language->start(*main)) return all;
        std::uint64_t taken = 0;
        channels::Step step = channels::Step::Continue;
        while (step == channels::Step::Continue) {
            step = language->step();
            for (; taken < ring.pushed(); ++taken) all.push_back(own->path.slot(taken));
            kernel->path_tail[0].tail.store(taken, std::memory_order_release);
        }
        if (step == channels::Step::Failed) return {};
        maker.flush();
        for (; taken < ring.pushed(); ++taken) all.push_back(own->path.slot(taken));
        return all;
    }

private:
    LoadedMachine machine_ = load_machine_file({});
    channels::MachineView view_;
    channels::PathLimits limits_;
};

bool is_motion(const PathRecord& r) {
    return r.kind >= 1 && r.kind <= static_cast<std::uint8_t>(RecordKind::Curve);
}

struct Driven {
    bool ended = false;
    double seconds = 0, fastest = 0;  // in feed
    double v = 0, a = 0, j = 0;       // of the axes' limits
    std::uint64_t anomalies = 0;
};

// `operate` may change the input before each tick.
template <class Operate>
Driven drive(const std::vector<PathRecord>& records, const channels::PathLimits& limits,
             Operate&& operate) {
    auto planner = std::make_unique<kernel::PathPlanner>();
    planner->configure(kDt, 1024);
    planner->clear(0);
    std::array<double, kMaxSpindles> rev_s{};
    rev_s.fill(20);
    kernel::PathInput input;
    input.spindle_rev_s = rev_s.data();
    Driven driven;
    // positions now and at the three ticks before; where the path has taken each axis
    std::array<std::array<double, 4>, kMaxAxes> p{};
    std::array<double, kMaxAxes> to;
    to.fill(std::nan(""));
    const auto place = [&](const PathRecord& r, double s) {
        SlotVector at{};
        position_at(r, s, at);
        for (std::size_t i = 0; i < r.axis_count; ++i) to[r.axis[i]] = at[i];
    };
    // Every axis stands where it first moves from.
    for (const PathRecord& r : records) {
        for (std::size_t i = 0; is_motion(r) && i < r.axis_count; ++i)
            if (std::isnan(to[r.axis[i]])) to[r.axis[i]] = r.start[i];
    }
    for (std::size_t n = 0; n < kMaxAxes; ++n) p[n].fill(to[n]);
    const auto judge = [&] {
        for (std::size_t n = 0; n < kMaxAxes; ++n) {
            auto& q = p[n];
            if (std::isnan(to[n])) continue;
            std::rotate(q.rbegin(), q.rbegin() + 1, q.rend());
            q[0] = to[n];
            const channels::PathAxis& most = limits.axis[n];
            driven.v = std::max(driven.v, std::abs(q[0] - q[1]) / kDt / most.rapid);
            driven.a =
                std::max(driven.a, std::abs(q[0] - 2 * q[1] + q[2]) / (kDt * kDt) / most.accel);
            driven.j = std::max(driven.j, std::abs(q[0] - 3 * q[1] + 3 * q[2] - q[3]) /
                                              (kDt * kDt * kDt) / most.jerk);
        }
    };
    for (int tick = 1; tick < 3'000'000 && !driven.ended; ++tick) {
        while (planner->wants_record() && planner->next_record() < records.size()) {
            const PathRecord& r = records[planner->next_record()];
            kernel::PlannedRecord planned = kernel::PlannedRecord::from(r, !is_motion(r));
            if (!is_motion(r)) planned.length = 0;
            planner->append(planned);
        }
        operate(tick, input, rev_s);
        const kernel::PathStep step = planner->tick(input);
        // as the kernel does: the axes of a record that ended within the tick are at its end, also
        // those that the record behind it does not move
        for (std::uint64_t i = step.ended_from; i < step.ended_to; ++i)
            if (is_motion(records[i])) place(records[i], records[i].length);
        if (step.record < records.size() && is_motion(records[step.record]))
            place(records[step.record], step.s);
        judge();
        if (step.record < records.size() && (records[step.record].flags & kRapid) == 0)
            driven.fastest = std::max(driven.fastest, step.speed);
        if (step.stands == kernel::Stands::BeforeRecord) planner->skip(step.record + 1);
        if (step.stands == kernel::Stands::BlockEnd) planner->step_block();
        driven.ended = planner->at_rest() && planner->next_record() == records.size() &&
                       step.stands == kernel::Stands::NoRecord;
        driven.seconds = tick * kDt;
    }
    driven.anomalies = planner->anomalies();
    return driven;
}

// Lines, arcs, corners of any angle, ways of 1 um to 100 mm, feeds a minute, a revolution and with
// constant surface speed.
std::string random_program(std::uint64_t seed) {
    std::mt19937_64 random(test_seed(seed));
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<>(low, high)(random);
    };
    const auto chance = [&](double p) { return between(0, 1) < p; };
    std::string text = "G21 G98 G18\nM3 S1200\nG0 X100. Z-50.\nG1 F1000.\n";
    double x = 50, z = -50, heading = 0;  // x: radius
    const bool tiny = chance(0.3);
    char line[160];
    for (int n = 0; n < 60; ++n) {
        if (chance(0.05)) {
            std::snprintf(line, sizeof line,
                          chance(0.5)   ? "G98 G97 S1200 F%.0f\n"
                          : chance(0.5) ? "G99 G97 S1500 F%.3f\n"
                                        : "G99 G96 S150 F%.3f\n",
                          0.0);
            if (line[1] == '9' && line[2] == '8')
                std::snprintf(line, sizeof line, "G98 G97 S1200 F%.0f\n", between(100, 12'000));
            else if (chance(0.5))
                std::snprintf(line, sizeof line, "G99 G97 S1500 F%.3f\n", between(0.02, 0.8));
            else
                std::snprintf(line, sizeof line, "G99 G96 S150 F%.3f\n", between(0.02, 0.8));
            text += line;
        }
        heading += chance(0.3) ? 0 : chance(0.3) ? between(-3.14159, 3.14159) : between(-0.3, 0.3);
        const double length = std::exp(between(std::log(0.001), std::log(tiny ? 0.5 : 100)));
        const double to_x = x + length * std::sin(heading), to_z = z + length * std::cos(heading);
        if (to_x < 20 || to_x > 90 || to_z < -120 || to_z > -10) {
            heading += 2;
            continue;
        }
        if (length > 0.01 && chance(0.3)) {
            const double radius = length * between(0.6, 5);
            std::snprintf(line, sizeof line, "%s X%.4f Z%.4f R%.4f\n", chance(0.5) ? "G2" : "G3",
                          2 * to_x, to_z, radius);
        } else {
            std::snprintf(line, sizeof line, "%s X%.4f Z%.4f\n",
                          chance(0.05)   ? "G0"
                          : chance(0.05) ? "G9 G1"
                                         : "G1",
                          2 * to_x, to_z);
        }
        text += line;
        x = to_x;
        z = to_z;
    }
    return text + "M30\n";
}

TEST(TextToMotion, RandomProgramsKeepTheAxesLimits) {
    Pipeline pipeline;
    int driven_programs = 0;
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
        SCOPED_TRACE(seed);
        const std::vector<PathRecord> records = pipeline.records(random_program(seed));
        if (records.empty()) continue;  // an arc that does not fit
        ++driven_programs;
        std::mt19937_64 random(test_seed(seed));
        const Driven driven =
            drive(records, pipeline.limits(),
                  [&](int, kernel::PathInput& input, std::array<double, kMaxSpindles>& rev_s) {
                      if (seed % 2 == 0) return;
                      const auto dice = random() % 1000;
                      if (dice < 5)
                          input.feed_override = static_cast<double>(5 + random() % 196) / 100;
                      else if (dice < 8)
                          input.rapid_override = static_cast<double>(5 + random() % 96) / 100;
                      else if (dice < 11)
                          input.hold = true;
                      else if (dice < 40)
                          input.hold = false;
                      else if (dice < 43)
                          input.single_block = !input.single_block;
                      if (seed % 3 == 0)
                          rev_s.fill(20 * (1 + 0.02 * std::sin(static_cast<double>(random() % 7))));
                  });
        ASSERT_TRUE(driven.ended);
        ASSERT_EQ(driven.anomalies, 0u);
        ASSERT_LE(driven.v, 1.01);
        ASSERT_LE(driven.a, 1.01);
        ASSERT_LE(driven.j, 1.01);
    }
    EXPECT_GT(driven_programs, 90);
}

TEST(TextToMotion, AHundredThousandTenthsReachTheSpeedOfTheAxes) {
    Pipeline pipeline;
    std::string text = "G21 G98 G18\nG0 X100. Z0.\nG1 F100000.\n";
    char line[64];
    double z = 0, step = -0.1;
    for (int n = 0; n < 100'000; ++n) {  // to and fro over 200 mm
        if (n > 0 && n % 2'000 == 0) step = -step;
        z += step;
        std::snprintf(line, sizeof line, "Z%.1f\n", z);
        text += line;
    }
    const std::vector<PathRecord> records = pipeline.records(text + "M30\n");
    ASSERT_GE(records.size(), 100'000u);
    const Driven driven = drive(records, pipeline.limits(), [](int, kernel::PathInput&, auto&) {});
    ASSERT_TRUE(driven.ended);
    EXPECT_EQ(driven.anomalies, 0u);
    double feed = 0;
    for (const PathRecord& r : records) {
        if (is_motion(r) && r.axis_count == 1 && (r.flags & kRapid) == 0)
            feed = std::max(feed, pipeline.limits().axis[r.axis[0]].feed);
    }
    EXPECT_NEAR(driven.fastest, feed, 0.001 * feed);
    EXPECT_LE(driven.v, 1.01);
    EXPECT_LE(driven.a, 1.01);
    EXPECT_LE(driven.j, 1.01);
}

}  // namespace
}  // namespace polyturn
