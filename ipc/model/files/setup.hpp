// What an operator would have entered before a run (cli.md 2): start positions, zeros, variables,
// keys, offsets, tools, sensors. Read alike by command line, channel and store; who needs what:
//   polyturn            machine, pos, keys, sensors
//   polyturn-toolmgmt   offsets, work, variables, tools
//   polyturn-channel    clock, variables, subprograms, keys, tools
// Values are as the file has them: X as the axis displays it (a diameter on a diameter axis),
// lengths mm, angles degrees.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::text {

// Axis name ("X", "C", "X2") and its value.
using AxisValues = std::map<std::string, double>;

struct SetupVariable {
    std::string name;    // "#100", "R1", "P5", "#1000", as written
    double value = 0.0;  // NaN: empty
    std::string text;    // of a string variable
    bool is_text = false;
};

// A value that the file does not name is absent and keeps what the store has (zero in a private
// instance).
struct OffsetValues {
    std::optional<double> x, y, z, r, t;  // mm; t: tip direction 0..9
};
struct OffsetSetup {
    OffsetValues geometry, wear;
};

struct ToolSetup {
    std::string name;
    std::map<int, std::map<std::string, double>> edges;  // edge number -> DP1, DP2 ...
};

struct SensorSetup {
    std::string input;  // name or number of the input
    // name of the axis in its channel; S1 ..: a switch that the spindle passes at the angle `at`
    std::string axis;
    double at = 0.0;    // machine position as displayed, from which the input is on ...
    int direction = 0;  // ... in this direction of travel: -1, +1; 0 in both
};

struct KeySetup {
    std::vector<int> block_skip;  // levels that are on; level 1 is the plain "/"
    bool optional_stop = false, single_block = false, dry_run = false, machine_lock = false;
};

struct ChannelSetup {
    AxisValues machine, pos;
    std::map<std::string, AxisValues> work;  // "G54", "G54.1P3", "shift", "G505" -> axis values
    std::vector<SetupVariable> variables;    // in the file's order
    KeySetup keys;
    // paths, already resolved against the setup file's folder
    std::vector<std::string> subprograms;
    std::map<int, OffsetSetup> offsets;
    std::map<int, ToolSetup> tools;
    std::vector<SensorSetup> sensors;
};

struct Clock {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0;
};

struct Setup {
    std::string file;                           // where it was read from
    std::optional<Clock> clock;                 // absent: the computer's
    std::map<unsigned, ChannelSetup> channels;  // by channel number, from 1

    // The channel's setup, an empty one when the file does not speak of it.
    const ChannelSetup& channel(unsigned number) const;
};

// Everything wrong with the text goes to `diagnoses`; what is right is returned all the same.
// `filename` is named in diagnoses and resolves `subprograms`.
Setup parse_setup(std::string_view content, std::string_view filename,
                  std::vector<Diagnosis>& diagnoses);

// The file, or the first diagnosis.
Result<Setup> load_setup(const std::string& path);

}  // namespace polyturn::text
