// The bodies of the machine in its room (ipc/model/bodies/room_bodies.hpp: what protection
// guards), at positions of the axes that somebody names: those of now, or those of a dry run.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "hmi/machine/live/aside.hpp"
#include "hmi/machine/live/live.hpp"
#include "ipc/model/bodies/room_bodies.hpp"

namespace polyturn::hmi {

struct RoomNow {
    std::array<double, kMaxAxes> axes{};  // true machine positions, from 0
    std::array<RoomBodies::Turret, kMaxChannels> turrets{};
    std::array<bool, kMaxAxes> held{};  // by protection
};

struct ShownBody {
    RoomBodies::Kind kind{};
    // of the channel, spindle or tailstock; channel: whose tool carrier it is, 0 else
    unsigned number = 0, channel = 0;
    bool barrier = false;  // N1900 to N1914, not machine.toml
    bool guarded = false, held = false, moves = false;
    RoomBodies::Vector at{}, tip{};  // the carrier's point and the tip of its tool in work
    bool tipKnown = false;
    std::vector<RoomBodies::Box> boxes{};  // station: that in work is given by inWork
    unsigned inWork = 0;
    // a turret of which only that is known: it has no boxes
    double reach = 0, axisAt = 0, outwards = 1;
    bool alongX = true;
};

class RoomView {
public:
    // Each frame: reads machine.toml aside when it is another machine, takes parameters and tools
    // that have changed. True: the bodies are other ones.
    bool follow(const Live& live);
    bool any() const { return bodies_ != nullptr && bodies_->body_count > 0; }
    const Room* room() const { return bodies_ ? &room_ : nullptr; }
    // The present positions. The tip of a tool is what the running block says; it stays as it
    // was known while none says it.
    RoomNow now(const Live& live);
    std::vector<ShownBody> bodies(const RoomNow& now) const;
    // The point of the channel's tool carrier; false: its position is not known.
    bool carrier(unsigned channel, const RoomNow& now, RoomBodies::Vector& out) const;

private:
    Aside<std::shared_ptr<Room>> reading_;
    std::string folder_;
    std::uint64_t generation_ = ~0ull, tools_ = 0, table_ = 0;
    Room room_;
    std::shared_ptr<Room> read_;
    std::unique_ptr<RoomBodies> bodies_;
    std::unique_ptr<ToolShapes> shapes_;
    RoomNow last_;
};

}  // namespace polyturn::hmi
