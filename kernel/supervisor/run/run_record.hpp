// What report and plot need of a finished run: each channel's activities with their times and
// places. Filled from the events themselves, so that picture and log never disagree.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polyturn::supervisor {

enum class Doing : std::uint8_t { Cut, Thread, Rapid, Wait, Dwell, Aux };

struct PlanePoint {
    double x_mm = 0.0, z_mm = 0.0;  // workpiece system; X as a radius
};

struct Activity {
    unsigned channel = 0;
    Doing doing = Doing::Cut;
    double t_s = 0.0, end_s = 0.0;
    std::string file;
    std::uint32_t line = 0;
    std::string code;                  // Wait: M501; Aux: M8, T0303
    std::uint32_t partners = 0;        // Wait: set of channels, bit 0 is channel 1
    std::string tool;                  // of a move: "T3 finishing 35°"
    std::optional<PlanePoint> to;      // of a move that has X or Z
    std::optional<PlanePoint> centre;  // of an arc
    bool clockwise = false;
};

struct ChannelTimes {
    double cycle_s = 0, cutting_s = 0, rapid_s = 0, waiting_s = 0;
    std::uint64_t blocks = 0;
};

struct RunRecord {
    bool wanted = false;               // nothing is collected unless somebody asks for it
    std::vector<Activity> activities;  // by channel and time as they were given out
    std::map<unsigned, ChannelTimes> channels;
    double seconds = 0.0;

    // An event as it was printed; end_s below 0: it has none. `diameter`: X of the channel is
    // programmed as one.
    void add(std::string_view event_text, double t_s, double end_s, bool diameter);
};

}  // namespace polyturn::supervisor
