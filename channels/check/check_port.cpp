#include "channels/check/check_port.hpp"

#include <cmath>
#include <ctime>
#include <string>

namespace polyturn::channels {
namespace {
constexpr double kNothingThere = 999'999.0;  // PT_DRIVE_STOP, PT_DRIVE_HELD
}  // namespace

bool CheckPort::block_skip(unsigned number) {
    for (const int level : own_->keys.block_skip)
        if (level == static_cast<int>(number)) return true;
    return false;
}

void CheckPort::skip_move(const Move& move, const MachineView& view) {
    double share = 2.0;  // of the travel at which the first signal comes
    for (const text::SensorSetup& sensor : own_->sensors) {
        const int place = view.axis_by_name(sensor.axis);
        if (sensor.input != move.skip_name || place < 0) continue;
        const auto i = static_cast<unsigned>(place);
        const double from = move.machine_start[i], way = move.machine[i] - from,
                     at = view.from_shown(i, sensor.at);
        if (way == 0.0) continue;
        // on beyond `at` in its direction: it goes when the axis comes back past it
        if (move.skip_release) {
            const double side = sensor.direction < 0 ? -1.0 : 1.0;
            if ((from - at) * side < 0)
                share = 0.0;
            else if (way * side < 0)
                share = std::fmin(share, (at - from) / way);
            continue;
        }
        if (sensor.direction != 0 && (way > 0) != (sensor.direction > 0)) continue;
        const double here = (at - from) / way;
        // passed already: the signal is there at once
        share = std::fmin(share, here < 0 ? 0.0 : here);
    }
    // what the simulated drives would meet
    for (unsigned i = 0; i < view.axis_count && (move.skip_torque != 0 || move.fixed_stop); ++i) {
        const unsigned axis = view.axes[i].machine_axis + 1u;
        const double from = move.machine_start[i], way = move.machine[i] - from;
        const double stop = params::get(view.table(), params::pt_drive_stop, axis),
                     held = params::get(view.table(), params::pt_drive_held, axis);
        if (way > 0 && stop < kNothingThere)
            share = std::fmin(share, std::fmax((stop - from) / way, 0.0));
        if (way < 0 && held > -kNothingThere && from >= held)
            share = std::fmin(share, (held - from) / way);
    }
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const double end =
            share <= 1.0 ? move.machine_start[i] + share * (move.machine[i] - move.machine_start[i])
                         : move.machine[i];
        skipped_[view.axes[i].machine_axis] = end;
    }
}

bool CheckPort::measuring_input(std::string_view name, const MachineView& view,
                                const std::array<double, kChannelAxes>& machine) {
    for (const text::SensorSetup& sensor : own_->sensors) {
        const int place = view.axis_by_name(sensor.axis);
        if (sensor.input != name || place < 0) continue;
        const auto i = static_cast<unsigned>(place);
        const double beyond = machine[i] - view.from_shown(i, sensor.at);
        if (beyond * (sensor.direction < 0 ? -1.0 : 1.0) >= -1e-9) return true;
    }
    return false;
}

double CheckPort::interface_value(std::int32_t variable) {
    return given_variable("#" + std::to_string(variable)).value_or(0.0);
}

std::optional<double> CheckPort::given_variable(std::string_view name) {
    std::optional<double> value;
    for (const text::SetupVariable& variable : own_->variables)
        // a later line wins
        if (!variable.is_text && variable.name == name) value = variable.value;
    return value;
}

CalendarTime CheckPort::clock() {
    if (setup_->clock) {
        const text::Clock& c = *setup_->clock;
        return {c.year, c.month, c.day, c.hour, c.minute, c.second};
    }
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    return {local.tm_year + 1900, local.tm_mon + 1, local.tm_mday,
            local.tm_hour,        local.tm_min,     local.tm_sec};
}

}  // namespace polyturn::channels
