// libs: polyturn_motion polyturn_channel_path
//
// How near the planner comes to the least possible time on tests/bench/parts (the issue allows 10 %
// above the reference), and what a tick of it costs. First a table, then Google Benchmark's.
//     motion_bench                   both
//     motion_bench --paths X.part    the path of a part as bench/reference/reference.cpp reads it
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "channels/path/path_maker.hpp"
#include "kernel/motion/path_planner.hpp"
#include "tests/places.hpp"

namespace polyturn {
namespace {

constexpr double kDt = 0.001;

struct Collected : channels::RecordOut {
    std::vector<PathRecord> records;
    PathRecord& claim() override { return records.emplace_back(); }
    void commit() override {}
};

struct Part {
    double acceleration = 0, jerk = 0, velocity = 0;
    std::vector<PathRecord> records;
};

Part load(const std::filesystem::path& file) {
    Part part;
    channels::PathLimits limits;
    Collected out;
    channels::PathMaker maker(out, limits);
    std::ifstream in(file);
    double x = 0, z = 0;
    std::int64_t block = 0;
    const auto begin = [&](RecordKind kind, double to_x, double to_z, double feed) -> PathRecord& {
        PathRecord& r = maker.next_move();
        r.kind = static_cast<std::uint8_t>(kind);
        r.feed_mode = static_cast<std::uint8_t>(FeedMode::PerMinute);
        r.feed = feed;
        r.block = ++block;
        r.axis_count = 2;
        r.axis = {0, 1};
        r.start = {x, z};
        r.end = {to_x, to_z};
        return r;
    };
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line.substr(0, line.find('#')));
        std::string word;
        if (!(words >> word)) continue;
        if (word == "limits") {
            words >> part.velocity >> part.acceleration >> part.jerk;
            for (auto& axis : limits.axis)
                axis = {part.velocity,
                        part.velocity,
                        part.acceleration,
                        part.acceleration,
                        part.jerk,
                        0,
                        0,
                        0,
                        false};
        } else if (word == "tolerance") {
            words >> limits.tolerance;
        } else if (word == "start") {
            words >> x >> z;
        } else if (word == "line") {
            double to_x = 0, to_z = 0, feed = 0;
            words >> to_x >> to_z >> feed;
            begin(RecordKind::Line, to_x, to_z, feed);
            maker.add_move();
            x = to_x;
            z = to_z;
        } else if (word == "arc") {
            double to_x = 0, to_z = 0, cx = 0, cz = 0, feed = 0;
            std::string sense;
            words >> to_x >> to_z >> cx >> cz >> sense >> feed;
            PathRecord& r = begin(RecordKind::Arc, to_x, to_z, feed);
            const double from = std::atan2(z - cz, x - cx), to = std::atan2(to_z - cz, to_x - cx);
            double sweep = std::remainder(to - from, 2 * std::numbers::pi);
            if (sense == "ccw" && sweep < 0) sweep += 2 * std::numbers::pi;
            if (sense == "cw" && sweep > 0) sweep -= 2 * std::numbers::pi;
            r.plane = {0, 1, 0, 0};
            r.shape[arc_shape::kCentreP] = cx;
            r.shape[arc_shape::kCentreQ] = cz;
            r.shape[arc_shape::kRadius] = std::hypot(x - cx, z - cz);
            r.shape[arc_shape::kRadiusEnd] = std::hypot(to_x - cx, to_z - cz);
            r.shape[arc_shape::kStartAngle] = from;
            r.shape[arc_shape::kSweep] = sweep;
            maker.add_move();
            x = to_x;
            z = to_z;
        }
    }
    maker.flush();
    part.records = std::move(out.records);
    return part;
}

// Between two stands the grid is fine at both ends, where acceleration changes on short ways, and
// at records' borders.
void print_paths(const Part& part) {
    std::printf("axes 2\nlimits %.17g %.17g %.17g %.17g\n", part.acceleration, part.jerk,
                part.acceleration, part.jerk);
    for (std::size_t first = 0; first < part.records.size();) {
        std::size_t last = first;
        double length = part.records[first].length;
        while (last + 1 < part.records.size() && (part.records[last].flags & kExactStop) == 0)
            length += part.records[++last].length;
        std::vector<std::string> rows;
        double before = 0;
        for (std::size_t i = first; i <= last; ++i) {
            const PathRecord& r = part.records[i];
            // Nodes of the cosine grid of the whole segment that lie in this record, at least six
            // intervals.
            std::vector<double> nodes{0};
            constexpr int kWhole = 160;
            for (int k = 1; k < kWhole; ++k) {
                const double s =
                    length * (1 - std::cos(std::numbers::pi * k / kWhole)) / 2 - before;
                if (s > 1e-3 * r.length && s < (1 - 1e-3) * r.length) nodes.push_back(s);
            }
            const int least = part.records.size() > 60 ? 2 : 8;
            if (static_cast<int>(nodes.size()) < least) {
                nodes = {0};
                for (int k = 1; k < least; ++k) nodes.push_back(r.length * k / least);
            }
            nodes.push_back(r.length);
            for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
                PathDerivatives b{}, e{};
                derivatives_at(r, nodes[k], b);
                derivatives_at(r, nodes[k + 1], e);
                double ceiling = r.feed;
                for (std::size_t axis = 0; axis < 2; ++axis) {
                    ceiling = std::min(ceiling,
                                       part.velocity / std::max({std::abs(b.first[axis]),
                                                                 std::abs(e.first[axis]), 1e-9}));
                }
                char text[512];
                std::snprintf(
                    text, sizeof text,
                    "%.15g %.15g  %.12g %.12g %.12g %.12g %.12g %.12g  %.12g %.12g %.12g %.12g "
                    "%.12g %.12g",
                    nodes[k + 1] - nodes[k], ceiling, b.first[0], b.second[0], b.third[0],
                    e.first[0], e.second[0], e.third[0], b.first[1], b.second[1], b.third[1],
                    e.first[1], e.second[1], e.third[1]);
                rows.emplace_back(text);
            }
            before += r.length;
        }
        std::printf("segment %zu\n", rows.size());
        for (const std::string& row : rows) std::puts(row.c_str());
        first = last + 1;
    }
    std::puts("end");
}

struct Driven {
    double seconds = 0;
    double worst_v = 0, worst_a = 0, worst_j = 0;  // of the axes' limits, raw differences
};

Driven drive(const Part& part) {
    auto planner = std::make_unique<kernel::PathPlanner>();
    planner->configure(kDt, 1024);
    planner->clear(0);
    Driven driven;
    double p[2][4];
    for (int axis = 0; axis < 2; ++axis) {
        for (double& q : p[axis]) q = part.records[0].start[static_cast<std::size_t>(axis)];
    }
    for (int tick = 1; tick < 1'000'000; ++tick) {
        while (planner->wants_record() && planner->next_record() < part.records.size()) {
            planner->append(
                kernel::PlannedRecord::from(part.records[planner->next_record()], false));
        }
        const kernel::PathStep step = planner->tick({});
        SlotVector at{};
        position_at(part.records[step.record], step.s, at);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            double(&q)[4] = p[axis];
            q[3] = q[2];
            q[2] = q[1];
            q[1] = q[0];
            q[0] = at[axis];
            driven.worst_v = std::max(driven.worst_v, std::abs(q[0] - q[1]) / kDt / part.velocity);
            driven.worst_a = std::max(
                driven.worst_a, std::abs(q[0] - 2 * q[1] + q[2]) / (kDt * kDt) / part.acceleration);
            driven.worst_j = std::max(driven.worst_j, std::abs(q[0] - 3 * q[1] + 3 * q[2] - q[3]) /
                                                          (kDt * kDt * kDt) / part.jerk);
        }
        if (step.ended_to == part.records.size()) {
            driven.seconds = tick * kDt;
            break;
        }
    }
    return driven;
}

void report() {
    std::printf("%-12s %8s %8s %10s %10s %7s   %s\n", "part", "records", "stops", "planner s",
                "least s", "ratio", "of the axes' limits: v a j");
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(kSourceFolder) / "tests/bench/parts")) {
        if (entry.path().extension() == ".part") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
        const Part part = load(file);
        const Driven driven = drive(part);
        int stops = 0;
        for (const PathRecord& r : part.records) stops += (r.flags & kExactStop) != 0 ? 1 : 0;
        double least = std::nan("");
        std::ifstream(std::filesystem::path(file).replace_extension(".reference")) >> least;
        std::printf("%-12s %8zu %8d %10.3f %10.3f %7.3f   %.3f %.3f %.3f\n", file.stem().c_str(),
                    part.records.size(), stops, driven.seconds, least, driven.seconds / least,
                    driven.worst_v, driven.worst_a, driven.worst_j);
    }
}

kernel::PlannedRecord record(double length, double v, double a, double j) {
    kernel::PlannedRecord r;
    r.length = length;
    r.v_max = v;
    r.a_max = a;
    r.j_max = j;
    r.feed = 100;
    return r;
}

// Channels that drive without end; each tick's median would need a clock around it, so the mean of
// many is shown.
void run(benchmark::State& state, const std::vector<kernel::PlannedRecord>& pattern) {
    const auto count = static_cast<std::size_t>(state.range(0));
    std::vector<std::unique_ptr<kernel::PathPlanner>> planners;
    for (std::size_t i = 0; i < count; ++i) {
        planners.push_back(std::make_unique<kernel::PathPlanner>());
        planners.back()->configure(kDt, 1024);
        planners.back()->clear(0);
    }
    const auto tick = [&] {
        for (auto& planner : planners) {
            while (planner->wants_record())
                planner->append(pattern[planner->next_record() % pattern.size()]);
            benchmark::DoNotOptimize(planner->tick({}));
        }
    };
    for (int i = 0; i < 1000; ++i) tick();
    for (auto _ : state) tick();
}
void long_lines_with_stops(benchmark::State& state) {
    auto r = record(10, 300, 2000, 50'000);
    r.stop_after = true;
    run(state, {r});
}
void blends_between_lines(benchmark::State& state) {
    run(state, {record(5, 300, 2000, 50'000), record(0.2, 40, 1000, 20'000)});
}
void tenths_of_a_millimetre(benchmark::State& state) {
    run(state, {record(0.1, 300, 2000, 50'000)});
}
void tenths_with_blends(benchmark::State& state) {
    run(state, {record(0.08, 300, 2000, 50'000), record(0.02, 270, 1000, 20'000)});
}
BENCHMARK(long_lines_with_stops)->Arg(1)->Arg(2)->Arg(16);
BENCHMARK(blends_between_lines)->Arg(1)->Arg(2)->Arg(16);
BENCHMARK(tenths_of_a_millimetre)->Arg(1)->Arg(2)->Arg(16);
BENCHMARK(tenths_with_blends)->Arg(1)->Arg(2)->Arg(16);

}  // namespace
}  // namespace polyturn

int main(int argc, char** argv) {
    if (argc == 3 && std::strcmp(argv[1], "--paths") == 0) {
        polyturn::print_paths(polyturn::load(argv[2]));
        return 0;
    }
    polyturn::report();
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
