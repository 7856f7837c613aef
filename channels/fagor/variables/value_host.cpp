#include "channels/fagor/variables/value_host.hpp"

#include "channels/fagor/execution.hpp"
#include "channels/fagor/variables/named.hpp"

namespace polyturn::channels::fagor {

bool ValueHost::block_skip(unsigned number) { return x_.core.port().block_skip(number); }

std::optional<Alarm> ValueHost::parameter_value(std::int64_t number, double& value) {
    if (!Values::exists(number)) return Alarm::VariableUnknown;
    if (Values::of_maker(number) && !x_.calls.here().maker) return Alarm::FagorMakerParameter;
    value = x_.values.parameter(number);
    return std::nullopt;
}

Access ValueHost::read(const Target& target, double& value) {
    if (target.row) return read_named(x_, target, value);
    if (!Values::exists(target.number)) return Access::Unknown;
    if (Values::of_maker(target.number) && !x_.calls.here().maker)
        return variable_fault(x_, Alarm::FagorMakerParameter, target_name(target));
    value = x_.values.parameter(target.number);
    return Access::Ok;
}

}  // namespace polyturn::channels::fagor
