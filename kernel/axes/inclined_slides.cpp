#include "kernel/axes/inclined_slides.hpp"

#include <cmath>

#include "ipc/model/machine/angular_axes.hpp"

namespace polyturn::kernel {
namespace p = params;

void InclinedSlides::configure(const p::Table& table, const KernelConfig& config) noexcept {
    for (std::uint32_t l = 1; l <= kMaxChannels; ++l) {
        if (taken_[l - 1].on) {
            waits_ = true;
            continue;
        }
        slides_[l - 1] = {};
        // as programs count them: indices of named axes in ascending order
        std::array<std::uint32_t, kChannelAxes> axes{};
        unsigned count = 0;
        int x = -1, z = -1;
        for (std::uint32_t a = 1; a <= kMaxAxes && count < kChannelAxes; ++a) {
            const AxisConfig& axis = config.axes[a - 1];
            if (axis.channel != l || !axis.named) continue;
            const auto role = static_cast<PlaneRole>(p::get(table, p::n0103_axis_to_plane, a));
            if (role == PlaneRole::BasicX && x < 0) x = static_cast<int>(count);
            if (role == PlaneRole::BasicZ && z < 0) z = static_cast<int>(count);
            axes[count++] = a;
        }
        bool usable = true;
        const AngularAxes found = angular_axes(table, l, count, x, z, usable);
        if (!found.on || found.angular >= count || found.square >= count) continue;
        if (!config.axes[axes[found.angular] - 1].exists ||
            !config.axes[axes[found.square] - 1].exists)
            continue;
        slides_[l - 1] = {axes[found.angular], axes[found.square], found.cosine,
                          std::sin(found.radians), !p::bit(table, p::f8200, l, 2)};
    }
}

const InclinedSlides::Slide* InclinedSlides::of(const Core& core,
                                                std::uint32_t axis) const noexcept {
    const std::uint32_t l = core.config.axes[axis].channel;
    return l && slides_[l - 1].angular == axis + 1 ? &slides_[l - 1] : nullptr;
}

void InclinedSlides::begin(Core& core, std::uint32_t axis, bool always) noexcept {
    const std::uint32_t l = core.config.axes[axis].channel;
    const Slide& slide = slides_[l - 1];
    if (taken_[l - 1].on || (!always && core.signals.plc(signals::nozagc(l)))) return;
    taken_[l - 1] = {true, core.axes[axis].own(), core.axes[slide.square - 1].own()};
    core.axes[slide.square - 1].owner = 0;
}

std::uint32_t InclinedSlides::carrier(const Core& core, std::uint32_t axis) const noexcept {
    const std::uint32_t l = core.config.axes[axis].channel;
    return l && taken_[l - 1].on && slides_[l - 1].square == axis + 1 ? l : 0;
}

void InclinedSlides::follow(Core& core, std::uint32_t channel, bool over) noexcept {
    Taken& taken = taken_[channel - 1];
    if (!taken.on) return;
    const Slide& slide = slides_[channel - 1];
    AxisUnit& square = core.axes[slide.square - 1];
    if (core.state == MachineState::EmergencyStop) {  // each brakes as hard as it can
        taken.on = square.brake(core.config.tick_s);
        if (!taken.on && std::exchange(waits_, false)) due_ = true;
        return;
    }
    square.move_to(taken.square_from -
                   (core.axes[slide.angular - 1].own_target() - taken.slide_from) * slide.sine);
    taken.on = !over;
    if (over && std::exchange(waits_, false)) due_ = true;
}

void InclinedSlides::shifted(std::uint32_t axis, double by) noexcept {
    for (unsigned l = 0; l < kMaxChannels; ++l) {
        if (slides_[l].angular == axis + 1) taken_[l].slide_from += by;
        if (slides_[l].square == axis + 1) taken_[l].square_from += by;
    }
}

}  // namespace polyturn::kernel
