#include "ipc/model/machine/angular_axes.hpp"

#include <cmath>
#include <numbers>

#include "ipc/params/registry.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn {

AngularAxes angular_axes(const params::Table& table, unsigned channel, unsigned axis_count, int x,
                         int z, bool& usable) {
    AngularAxes axes;
    usable = true;
    if (!params::bit(table, params::f8200, channel, 0)) return axes;
    const double degrees = static_cast<double>(params::get(table, params::f8210, channel));
    const auto named = [&](std::int64_t number, int otherwise) {
        return number >= 1 && number <= static_cast<std::int64_t>(axis_count)
                   ? static_cast<int>(number - 1)
                   : otherwise;
    };
    x = named(params::get(table, params::f8211, channel), x);
    z = named(params::get(table, params::f8212, channel), z);
    const double away = std::fabs(std::remainder(degrees, 90.0));
    usable = x >= 0 && z >= 0 && x != z && away > 1e-9 && std::fabs(degrees) < 90.0;
    if (!usable) return axes;
    axes.on = true;
    axes.angular = static_cast<unsigned>(x);
    axes.square = static_cast<unsigned>(z);
    axes.radians = degrees * std::numbers::pi / 180.0;
    axes.cosine = std::cos(axes.radians);
    axes.tangent = std::tan(axes.radians);
    return axes;
}

}  // namespace polyturn
