#include "channels/fanuc/macro/variable_writes.hpp"

#include <cmath>

#include "channels/fanuc/execution.hpp"

namespace polyturn::channels::fanuc {

// A variable is written: the channel sees it at once, the others when the record is executed.
bool write_variable(Execution& x, std::int64_t number, double value, std::string_view comment) {
    x.core.did();
    if (number == 3000) {  // an alarm of the program's own
        x.macro.message = comment;
        if (x.macro.message.empty()) x.macro.message = "alarm of the program";
        if (!is_null(value) && (value < 0 || value > 200) && x.settings.policy.macro.alarms_to_200)
            return x.core.fail(Alarm::VariableValue, 0, "#3000", value);
        return x.core.program_alarm(x.macro.message,
                                    3000 + (is_null(value) ? 0 : std::nearbyint(value)));
    }
    if (number == 3006) {  // a message, and the program stops
        x.core.mark_emitted();
        x.core.sink().message(comment, x.core.at);
        x.core.sink().stop({StopReason::M00}, x.core.at);
        x.run.wants_barrier = true;
        return true;
    }
    if (number >= x.settings.protected_first && number <= x.settings.protected_last)
        return x.core.fail(Alarm::VariableReadOnly, 0, variable_name(number));
    switch (x.macro.variables.write(number, value)) {
        case VariableStatus::Ok:
            break;
        case VariableStatus::ReadOnly:
            return x.core.fail(Alarm::VariableReadOnly, 0, variable_name(number));
        case VariableStatus::Fault:
            return false;
        default:
            return x.core.fail(Alarm::VariableUnknown, 0, variable_name(number));
    }
    char text[24] = {'#'};
    char* last = text + 1;
    std::int64_t rest = number;
    char digits[20];
    int count = 0;
    do digits[count++] = static_cast<char>('0' + rest % 10);
    while (rest /= 10);
    while (count) *last++ = digits[--count];
    Variable variable;
    variable.name = {text, static_cast<std::size_t>(last - text)};
    variable.value = value;
    if (number >= 500 && number < 1000)
        variable.persistent = static_cast<std::int32_t>(number - 500);
    // kept in the first channel's store, #100 and on behind the others
    if (number < 1000 && x.macro.variables.is_shared(number)) {
        variable.persistent =
            static_cast<std::int32_t>(number >= 500 ? number - 500 : 400 + number);
        variable.channel = 1;
    }
    x.core.mark_emitted();
    x.core.sink().variable(variable, x.core.at);
    return true;
}

bool preset_variable(Execution& x, std::string_view name, double value) {
    if (name.size() < 2 || name[0] != '#') return false;
    std::int64_t number = 0;
    for (const char c : name.substr(1)) {
        if (c < '0' || c > '9' || number > 10'000'000) return false;
        number = number * 10 + (c - '0');
    }
    if (number >= 1000) return false;
    return x.macro.variables.write(number, value) == VariableStatus::Ok;
}

}  // namespace polyturn::channels::fanuc
