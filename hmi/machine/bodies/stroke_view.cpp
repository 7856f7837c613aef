#include "hmi/machine/bodies/stroke_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "ipc/path/stroke_flags.hpp"

namespace polyturn::hmi {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// cosine: an axis that goes along X or Z of the work area; a slanted one has no box there
constexpr double kAlong = 0.99;

double rounded(double value) {
    return std::isfinite(value) ? std::round(value * 100) / 100 + 0.0 : value;
}

// The active codes of a block, as the picture has them, contain this one.
bool codeActive(const ChannelView& view, std::string_view code) {
    if (!view.known) return false;
    const std::string_view codes(view.picture.codes.data(),
                                 ::strnlen(view.picture.codes.data(), view.picture.codes.size()));
    for (std::size_t at = codes.find(code); at != std::string_view::npos;
         at = codes.find(code, at + 1)) {
        const std::size_t end = at + code.size();
        if ((at == 0 || codes[at - 1] == ' ') && (end == codes.size() || codes[end] == ' '))
            return true;
    }
    return false;
}

}  // namespace

std::vector<ShownStroke> shownStrokes(const Live& live, const RoomView& view, const RoomNow& now) {
    std::vector<ShownStroke> out;
    const Room* room = view.room();
    if (!room) return out;
    const MachineConfig& machine = live.config();
    for (const unsigned channel : live.channels()) {
        RoomBodies::Vector at;
        if (!view.carrier(channel, now, at)) continue;
        const RoomBodies::Turret& turret = now.turrets[channel - 1];
        if (turret.tip_known) {
            at.x += turret.tip.x;
            at.z += turret.tip.z;
        }
        const ChannelStroke how = read_channel_stroke(live.table(), channel);
        ShownStroke shown;
        shown.channel = channel;
        shown.allowed = {-kInfinity, kInfinity, -kInfinity, kInfinity};
        bool limited = false, boxed[2] = {false, false}, open[2] = {false, false};
        ShownStroke::Area box[2] = {shown.allowed, shown.allowed};
        for (const std::uint16_t number : machine.channel(channel).axis_numbers()) {
            const AxisStroke stroke = read_axis_stroke(live.table(), number);
            if (!stroke.any()) continue;
            StrokeFlags flags = stroke_flags(
                [&](std::uint32_t slot) { return live.plc(slot) != 0; }, channel, number);
            flags.second_off = flags.second_off || codeActive(live.view(channel), "G23");
            const AxisZone zone = zone_of(stroke, how, flags);
            const bool judged = (live.status().axes[number - 1u].flags & kReferenced) &&
                                live.nc(signals::an_detcha(number)) == 0;
            const double stands = now.axes[number - 1u];
            const auto place = room->axes.find(number);
            const RoomVector way =
                place == room->axes.end() ? RoomVector{} : place->second.direction;
            const bool alongX = std::abs(way.x) > kAlong, alongZ = std::abs(way.z) > kAlong;
            // An interval of the axis, from where the point is now.
            const auto limit = [&](const StrokeInterval& of, ShownStroke::Area& area) {
                const double sense = alongX ? way.x : way.z, base = alongX ? at.x : at.z;
                const double a = base + (of.low - stands) * sense,
                             b = base + (of.high - stands) * sense;
                double &low = alongX ? area.xLow : area.zLow,
                       &high = alongX ? area.xHigh : area.zHigh;
                low = std::max(low, rounded(std::min(a, b)));
                high = std::min(high, rounded(std::max(a, b)));
            };
            if (judged && (alongX || alongZ) &&
                (std::isfinite(zone.allowed.low) || std::isfinite(zone.allowed.high))) {
                limit(zone.allowed, shown.allowed);
                limited = true;
            }
            for (unsigned i = 0; i < 2; ++i) {
                if (!zone.in_box[i]) continue;
                boxed[i] = true;
                // one that does not know where it is leaves the box open
                if (!judged)
                    open[i] = true;
                else if (alongX || alongZ)
                    limit(zone.box[i], box[i]);
                else
                    // beside the plane: the box counts while it is within
                    open[i] = open[i] || stands <= zone.box[i].low + kOnLimit ||
                              stands >= zone.box[i].high - kOnLimit;
            }
        }
        for (unsigned i = 0; i < 2; ++i)
            if (boxed[i] && !open[i] && box[i].xLow < box[i].xHigh && box[i].zLow < box[i].zHigh)
                shown.forbidden.emplace_back(i + 2, box[i]);
        if (limited || !shown.forbidden.empty()) out.push_back(std::move(shown));
    }
    return out;
}

}  // namespace polyturn::hmi
