#include "channels/check/check_port.hpp"

#include <ctime>
#include <string>

namespace polyturn::channels {

bool CheckPort::block_skip(unsigned number) {
    for (const int level : own_->keys.block_skip)
        if (level == static_cast<int>(number)) return true;
    return false;
}

double CheckPort::interface_value(std::int32_t variable) { return given_variable("#" + std::to_string(variable)).value_or(0.0); }

std::optional<double> CheckPort::given_variable(std::string_view name) {
    std::optional<double> value;
    for (const text::SetupVariable& variable : own_->variables)
        if (!variable.is_text && variable.name == name) value = variable.value;   // a later line wins
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
    return {local.tm_year + 1900, local.tm_mon + 1, local.tm_mday, local.tm_hour, local.tm_min, local.tm_sec};
}

}  // namespace polyturn::channels
