// The machine model: where the parts of a machine are in one work area: axes, chucks, tailstocks
// and turrets, so that channels can be drawn and guarded together. From machine.toml beside
// machine.params; a machine without it gets a model in which each channel's X and Z point the usual
// way.
//
// The work area: Z along the main spindle, away from its chuck; X up. All in true millimetres, X as
// a radius.
//
//   [axis.A3]                          a point at machine coordinate p of the axis lies at origin +
//                                      p * direction
//   origin = { X = 0.0, Z = 0.0 }
//   direction = { X = -1.0, Z = 0.0 }
//   [chuck.S1]                         diameter, length (from its face backwards), jaws (from its
//                                      face forwards); carried_by = "A6": it travels with that axis
//   [turret.L1]                        stations, reach (from its axis to the seats)
//   body = [{ X = [0.0, 200.0], Z = [-80.0, 80.0] }]     what protection guards: rectangles about
//                                                        the tool carrier's point
//   tools = { 3 = [{ X = [-60.0, 0.0], Z = [-20.0, 5.0] }] }   and those of a station while it is
//                                                              in work
//   tips = { 3 = { X = -60.0, Z = -20.0 } }                    where that shape's tip is: an offset
//                                                              that puts the tip elsewhere takes
//                                                              the shape along
//   [tailstock.1]                      diameter, length
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/machine/machine_config.hpp"

namespace polyturn {

struct RoomVector {
    double x = 0.0, y = 0.0, z = 0.0;
};

// The position of a part and the direction it faces, or its positive travel goes (a unit vector).
struct RoomPlace {
    RoomVector origin, direction;
};

struct RoomBox {
    double x_low = 0.0, x_high = 0.0, z_low = 0.0, z_high = 0.0;
};

struct RoomChuck : RoomPlace {
    double diameter = 0.0, length = 0.0, jaws = 0.0;
    unsigned carried_by = 0;  // axis; 0: it is fixed
};
struct RoomTurret : RoomPlace {
    unsigned stations = 12;
    double reach = 0.0;
    std::vector<RoomBox> body;
    std::map<unsigned, std::vector<RoomBox>> tools;  // by station
    // likewise: drawn with this tip, from the carrier's point
    std::map<unsigned, RoomVector> tips;
};
struct RoomTailstock : RoomPlace {
    double diameter = 0.0, length = 0.0;
};

struct Room {
    // by axis number; every linear axis of the machine has one
    std::map<unsigned, RoomPlace> axes;
    std::map<unsigned, RoomChuck> chucks;          // by spindle number
    std::map<unsigned, RoomTurret> turrets;        // by channel number
    std::map<unsigned, RoomTailstock> tailstocks;  // by number

    // The position of a channel's tool carrier when its axes have these machine
    // coordinates: the sum over its linear axes, in the order of ChannelConfig::axes.
    RoomVector point(const ChannelConfig& channel, const MachineConfig& machine,
                     const double* coordinates) const;
};

// The model of a machine that has no machine.toml: X and Z axes point along the model's, the X of
// every second channel down.
Room default_room(const MachineConfig& machine);
// default_room() with what the text says on top; everything wrong with it goes to `diagnoses`.
Room parse_room(std::string_view content, std::string_view filename, const MachineConfig& machine,
                std::vector<Diagnosis>& diagnoses);
// An empty path: default_room().
Room load_room(const std::string& path, const MachineConfig& machine,
               std::vector<Diagnosis>& diagnoses);

}  // namespace polyturn
