#include "hmi/machine/bodies/room_view.hpp"

#include <algorithm>
#include <filesystem>

namespace polyturn::hmi {
namespace {
constexpr double kPointOnly = 1e-3;  // mm: a box that is no more than the carrier's point
}

bool RoomView::follow(const Live& live) {
    if (!live.connected()) return false;
    bool fresh = false;
    if (generation_ != live.generation() || folder_ != live.machineFolder()) {
        generation_ = live.generation();
        folder_ = live.machineFolder();
        read_.reset();
        reading_.start(
            [base = folder_, config = live.config()](const std::atomic<bool>&) {
                std::vector<Diagnosis> ignored;  // said by who started the controller
                std::error_code none;
                const std::string file = base + ".toml";
                return std::make_shared<Room>(load_room(
                    !base.empty() && std::filesystem::exists(file, none) ? file : std::string(),
                    config, ignored));
            },
            0);
    }
    if (auto made = reading_.take()) {
        read_ = *made;
        fresh = true;
    }
    if (!read_) return false;
    if (!fresh && tools_ == live.toolsVersion() && table_ == live.storeVersion()) return false;
    tools_ = live.toolsVersion();
    table_ = live.storeVersion();
    if (fresh) {
        room_ = *read_;
        last_ = {};
    }
    if (!bodies_) {
        bodies_ = std::make_unique<RoomBodies>();
        shapes_ = std::make_unique<ToolShapes>();
    }
    tool_shapes_of(live.tools(), live.table(), *shapes_);
    bodies_->configure(room_, live.table(), body_facts(live.config()), *shapes_, true);
    return true;
}

RoomNow RoomView::now(const Live& live) {
    const MachineConfig& config = live.config();
    for (unsigned a = 1; a <= config.last_axis; ++a) {
        last_.axes[a - 1] = live.status().axes[a - 1].act;
        last_.held[a - 1] = live.nc(signals::an_guard(a)) != 0;
    }
    for (const unsigned channel : live.channels()) {
        RoomBodies::Turret& turret = last_.turrets[channel - 1];
        const bool managed = live.nc(signals::cn_mgzno(channel)) != 0;
        const auto station = static_cast<std::uint32_t>(std::max(
            live.nc(managed ? signals::cn_potno(channel) : signals::cn_tcode(channel)), 0));
        if (station != turret.station) turret.tip_known = false;
        turret.station = station;
        const std::int32_t stands = live.plc(signals::cp_actt(channel));
        turret.stands_at = stands > 0 ? static_cast<std::uint32_t>(stands) : std::max(station, 1u);
        turret.turns = live.plc(signals::cp_turretopen(channel)) != 0;
        const ChannelView& view = live.view(channel);
        if (!view.known ||
            std::all_of(view.picture.tool_shift.begin(), view.picture.tool_shift.end(),
                        [](double one) { return one == 0; }))
            continue;
        turret.tip_known = true;
        turret.tip = tip_of(room_, config, channel, view.picture.tool_shift);
    }
    return last_;
}

bool RoomView::carrier(unsigned channel, const RoomNow& now, RoomBodies::Vector& out) const {
    if (!bodies_) return false;
    for (std::size_t n = 0; n < bodies_->body_count; ++n) {
        const RoomBodies::Body& body = bodies_->bodies[n];
        if (body.kind != RoomBodies::Kind::Carrier || body.channel != channel || body.carriers == 0)
            continue;
        out = RoomBodies::point(body, now.axes.data());
        return true;
    }
    return false;
}

std::vector<ShownBody> RoomView::bodies(const RoomNow& now) const {
    std::vector<ShownBody> out;
    if (!bodies_) return out;
    for (std::size_t n = 0; n < bodies_->body_count; ++n) {
        const RoomBodies::Body& body = bodies_->bodies[n];
        ShownBody shown;
        shown.kind = body.kind;
        shown.number = body.number;
        shown.channel = body.channel;
        shown.barrier = body.of_channel != 0;
        shown.guarded = body.guarded && bodies_->watched;
        shown.moves = body.carriers != 0;
        shown.at = RoomBodies::point(body, now.axes.data());
        for (std::size_t i = 0; i < body.carriers; ++i) shown.held |= now.held[body.axis[i]];
        RoomBodies::Turret turret;
        if (body.channel) {
            turret = now.turrets[body.channel - 1];
            shown.tip = {shown.at.x + turret.tip.x, shown.at.z + turret.tip.z};
            shown.tipKnown = turret.tip_known;
            shown.inWork = turret.turns ? 0 : turret.station;
            shown.reach = body.reach;
            shown.axisAt = body.axis_at;
            shown.outwards = body.outwards;
            shown.alongX = body.looks_along_x;
        }
        for (std::size_t i = body.first; i < body.first + body.count; ++i) {
            RoomBodies::Box box{};
            const RoomBodies::Box& own = bodies_->boxes[i];
            if (own.x_high - own.x_low > kPointOnly &&
                RoomBodies::placed(body, own, shown.at, turret, box))
                shown.boxes.push_back(box);
        }
        out.push_back(std::move(shown));
    }
    return out;
}

}  // namespace polyturn::hmi
