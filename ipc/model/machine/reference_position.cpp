#include "ipc/model/machine/reference_position.hpp"

#include "ipc/capacities.hpp"

namespace polyturn {
namespace {
constexpr unsigned kMefiAxes = 6;  // mefi_cnc8x6.md 1

bool in_inches(const params::Table& table, unsigned axis) noexcept {
    const auto channel = params::get(table, params::n0002_axis_assign, axis);
    return channel >= 1 && channel <= static_cast<std::int64_t>(kMaxChannels) &&
           params::bit(table, params::n0104_unit_of_measure, static_cast<unsigned>(channel), 0);
}

}  // namespace

double reference_position(const params::Table& table, unsigned axis) noexcept {
    using namespace params;
    const bool inch = !bit(table, n0106_axis_properties, axis, 1) && in_inches(table, axis);
    const double own = get(table, n0200_reference_position1, axis) +
                       get(table, fg_refvalue, axis) / (inch ? 25.4 : 1.0);
    const auto channel = get(table, n0002_axis_assign, axis);
    if (channel < 1 || channel > static_cast<std::int64_t>(kMaxChannels) ||
        get(table, n0100_axis_name1, axis) == 0)
        return own;
    unsigned place = 1;
    for (unsigned other = 1; other < axis; ++other)
        place += get(table, n0002_axis_assign, other) == channel &&
                 get(table, n0100_axis_name1, other) != 0;
    if (place > kMefiAxes) return own;
    const double xr = get(table, nth(mefi_80, place), static_cast<unsigned>(channel));
    return xr != 0 ? xr : own;
}

}  // namespace polyturn
