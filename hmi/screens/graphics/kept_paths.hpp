// The paths of the running part and what is left of its blank, as they are kept over a restart of
// the screens. They hold as long as the controller runs, the program is the same, and a channel is
// still in the cycle that it was in.
#pragma once
#include <QByteArray>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "hmi/screens/graphics/cutting_scene.hpp"

namespace polyturn::hmi {

struct KeptPaths {
    struct Channel {
        std::uint64_t cycles = 0;  // that it had done
        double cycle_s = 0;        // of the one that it was in
        double zeroZ = 0;          // of the workpiece in the work area, as the screen knew it
        bool zeroKnown = false;
        std::deque<TrailPoint> points;
    };
    std::uint64_t machineRun = 0;  // 0: there are none
    std::string program;
    std::map<unsigned, Channel> channels;
    std::vector<double> radii, holes;

    QByteArray written() const;
    static KeptPaths read(const QByteArray& bytes);  // of what is no such thing: none
};

}  // namespace polyturn::hmi
