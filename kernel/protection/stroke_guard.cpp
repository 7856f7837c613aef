#include "kernel/protection/stroke_guard.hpp"

#include <algorithm>
#include <limits>

#include "ipc/kinematics/kinematics.hpp"
#include "ipc/path/stroke_flags.hpp"
#include "kernel/tick/core.hpp"

namespace polyturn::kernel {
namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFar = 1e6;      // mm: longer than any axis
constexpr unsigned kPieces = 48;  // of an arc or a curve near a limit
constexpr int kBisections = 40;
}  // namespace

void StrokeGuard::configure(const KernelConfig& config) noexcept {
    place_.fill(-1);
    for (Channel& channel : channels_) {
        channel.zones.count = 0;
        ++channel.version;
    }
    for (std::uint32_t a = 0; a < config.axis_count; ++a) {
        const AxisConfig& axis = config.axes[a];
        if (!axis.exists || axis.channel == 0) continue;
        Channel& channel = channels_[axis.channel - 1];
        if (channel.zones.count == kChannelAxes) continue;
        place_[a] = static_cast<std::int16_t>(channel.zones.count);
        channel.axis[channel.zones.count] = a;
        channel.zones.axes[channel.zones.count++] = {};
    }
}

void StrokeGuard::update(const Core& core) noexcept {
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        Channel& channel = channels_[l];
        bool limited = false, changed = false;
        for (unsigned i = 0; i < channel.zones.count; ++i) {
            const std::uint32_t a = channel.axis[i];
            const AxisUnit& axis = core.axes[a];
            const AxisStroke& stroke = core.config.axes[a].stroke;
            if (const std::uint32_t now = axis.referenced ? channel.referenced | 1u << i
                                                          : channel.referenced & ~(1u << i);
                now != channel.referenced) {
                channel.referenced = now;
                changed = true;
            }
            AxisZone zone;
            if (stroke.any() && axis.referenced && !axis.detached) {
                const auto on = [&](std::uint32_t slot) { return core.signals.plc(slot) != 0; };
                StrokeFlags flags = stroke_flags(on, l + 1, a + 1);
                flags.second_off = flags.second_off || (core.stroke2_off >> l & 1u);
                zone = zone_of(stroke, core.config.channels[l].stroke, flags);
                limited = true;
            }
            // A box is closed by all its axes; one that does not know where it is leaves it open.
            const ChannelStroke& how = core.config.channels[l].stroke;
            const bool boxed[2] = {stroke.range2 && how.second_watched && !how.second_outside,
                                   stroke.range3};
            for (unsigned box = 0; box < 2; ++box)
                if (boxed[box] && !axis.referenced) {
                    zone.in_box[box] = true;
                    zone.box[box] = {0, 0};
                }
            if (!(zone == channel.zones.axes[i])) {
                channel.zones.axes[i] = zone;
                changed = true;
            }
            const bool grows = axis.added() != channel.added[i],
                       grew = (channel.growing >> i & 1u) != 0;
            channel.added[i] = axis.added();
            channel.growing = grows ? channel.growing | 1u << i : channel.growing & ~(1u << i);
            changed = changed || (grew && !grows && stroke.any());
        }
        channel.limited = limited;
        if (changed) ++channel.version;
    }
}

void StrokeGuard::places_now(const Core& core, unsigned l, Places& places) const noexcept {
    const Channel& channel = channels_[l];
    for (unsigned i = 0; i < channel.zones.count; ++i)
        places[i] = core.axes[channel.axis[i]].target();
}

double StrokeGuard::exit_of(unsigned l, const PathRecord& r, const Kinematics* kinematics,
                            Places& places, StrokeFault& fault) const noexcept {
    const Channel& channel = channels_[l];
    Places from = places;
    std::array<int, kMaxPathAxes> slot{};
    SlotVector begin{}, end{};
    (void)drives_at(r, kinematics, 0, begin);
    (void)drives_at(r, kinematics, r.length, end);
    for (unsigned k = 0; k < r.axis_count; ++k) {
        const std::uint32_t a = r.axis[k];
        const bool own = a < kMaxAxes && place_[a] >= 0 &&
                         channel.axis[static_cast<unsigned>(place_[a])] == a &&
                         static_cast<unsigned>(place_[a]) < channel.zones.count;
        slot[k] =
            own && !(channel.growing >> static_cast<unsigned>(place_[a]) & 1u) ? place_[a] : -1;
        if (slot[k] < 0) continue;
        const auto place = static_cast<unsigned>(slot[k]);
        from[place] = begin[k] + channel.added[place];
        places[place] = end[k] + channel.added[place];
    }
    if (!channel.limited) return kInfinity;
    if (static_cast<RecordKind>(r.kind) == RecordKind::Line && r.transform == 0) {
        const double part = free_part(channel.zones, from.data(), places.data(), fault);
        return part < 1.0 ? part * r.length : kInfinity;
    }
    const auto at = [&](double s, Places& out) {
        SlotVector position;
        (void)drives_at(r, kinematics, s, position);
        out = from;
        for (unsigned k = 0; k < r.axis_count; ++k)
            if (slot[k] >= 0)
                out[static_cast<unsigned>(slot[k])] =
                    position[k] + channel.added[static_cast<unsigned>(slot[k])];
    };
    Places before = from, now;
    double s_before = 0;
    for (unsigned n = 1; n <= kPieces; ++n) {
        const double s = r.length * n / kPieces;
        at(s, now);
        // A chord leaves out what bulges by less than the piece's sagitta; its end is checked
        // exactly by bisection.
        if (free_part(channel.zones, before.data(), now.data(), fault) < 1.0) {
            double low = s_before, high = s;
            for (int i = 0; i < kBisections; ++i) {
                const double middle = (low + high) / 2;
                Places probe;
                at(middle, probe);
                (free_part(channel.zones, before.data(), probe.data(), fault) < 1.0 ? high : low) =
                    middle;
            }
            at(high, now);
            (void)free_part(channel.zones, before.data(), now.data(), fault);
            return low;
        }
        before = now;
        s_before = s;
    }
    return kInfinity;
}

double StrokeGuard::room(const Core& core, std::uint32_t a, double sign, std::uint32_t other,
                         double share) const noexcept {
    if (place_[a] < 0) return kInfinity;
    const unsigned l = core.config.axes[a].channel - 1;
    const Channel& channel = channels_[l];
    Places from, to;
    places_now(core, l, from);
    to = from;
    to[static_cast<unsigned>(place_[a])] += sign * kFar;
    if (other < kMaxAxes && place_[other] >= 0)
        to[static_cast<unsigned>(place_[other])] += sign * share * kFar;
    StrokeFault fault;
    const double part = free_part(channel.zones, from.data(), to.data(), fault);
    if (part >= 1.0) return kInfinity;
    if (part > 0.0 && fault.axis != static_cast<unsigned>(place_[a])) return part * kFar;
    // Computed from the limit itself, so that it ends there to the last digit.
    return part <= 0.0
               ? 0.0
               : std::max(0.0, sign * (fault.limit - from[static_cast<unsigned>(place_[a])]));
}

std::uint32_t StrokeGuard::closed_sides(const Core& core, std::uint32_t a) const noexcept {
    if (place_[a] < 0) return 0;
    const unsigned l = core.config.axes[a].channel - 1;
    Places places;
    places_now(core, l, places);
    return polyturn::closed_sides(channels_[l].zones, places.data(),
                                  static_cast<unsigned>(place_[a]));
}

const AxisZone* StrokeGuard::zone(const Core& core, std::uint32_t a) const noexcept {
    return place_[a] < 0 ? nullptr
                         : &channels_[core.config.axes[a].channel - 1]
                                .zones.axes[static_cast<unsigned>(place_[a])];
}

}  // namespace polyturn::kernel
