// Runs a fanuc program with a given nose and gives the end points of its moves (X as a diameter)
// with their blocks.
#pragma once
#include <cstdlib>
#include <string>
#include <vector>

#include "../play.hpp"

namespace polyturn::channels::testing {

struct Point {
    double x, z;
    long n = -1;
    std::string line = {};  // the whole event
};

struct NoseRun {
    std::vector<Point> points;
    Played played;
    bool alarm(int number) const {
        return played.has({"\"alarm\"", "\"number\":" + std::to_string(number)}) ||
               played.has({"\"alarm\"", "\"number\":\"" + (number < 100 ? std::string("0") : "") +
                                            std::to_string(number) + "\""});
    }
};

inline double value_after(const std::string& text, const std::string& key, std::size_t from = 0) {
    const std::size_t at = text.find(key, from);
    return at == std::string::npos ? -1e9 : std::strtod(text.c_str() + at + key.size(), nullptr);
}

struct Nose {
    double radius = 1.0;
    int tip = 0;
    double other_radius = 0.5;  // of offset 2
};

// The tool stands at diameter start_x and start_z of a workpiece system without offsets.
inline NoseRun run_lathe(const std::string& blocks, const Nose& nose, double start_x,
                         double start_z, std::vector<std::string> sets = {}) {
    Play how;
    how.sets = std::move(sets);
    how.sets.push_back("F3401#0=1");  // numbers without a point are millimetres
    NoseRun run;
    run.played = play(
        "G18 G40 G97 G99 S800 M3 F0.2\nT0101\n" + blocks + "\nM30\n", how, [&](MachineView& view) {
            view.store->offsets[1].geometry_r = nose.radius;
            view.store->offsets[1].tip = nose.tip;
            view.store->offsets[2].geometry_r = nose.other_radius;
            view.store->offsets[2].tip = nose.tip;
            view.start[static_cast<std::size_t>(view.axis_by_name("X"))] = start_x / 2;
            view.start[static_cast<std::size_t>(view.axis_by_name("Z"))] = start_z;
        });
    for (const std::string& line : run.played.lines()) {
        if (line.find("\"ev\":\"move\"") == std::string::npos) continue;
        const std::size_t pos = line.find("\"pos\":");
        const double n = value_after(line, "\"n\":");
        run.points.push_back({value_after(line, "\"X\":", pos), value_after(line, "\"Z\":", pos),
                              n < -1e8 ? -1 : static_cast<long>(n), line});
    }
    return run;
}

}  // namespace polyturn::channels::testing
