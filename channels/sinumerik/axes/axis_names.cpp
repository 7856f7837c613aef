// Axes and spindles by their names: in words, in arguments, in functions.
#include "channels/sinumerik/axes/axis_names.hpp"

#include <cmath>

#include "channels/angles.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"

namespace polyturn::channels::sinumerik {

int find_axis(const Execution& x, std::string_view name) {
    const MachineView& view = x.core.view();
    const Transformation& transformation = x.core.path.transformation;
    // Y is the transformation's; its rotary axis has no name of its own meanwhile
    if (transformation.named_y) {
        if (name == "Y") return transformation.virtual_y;
        if (view.axis_by_name(name) == transformation.rotary_place()) return -1;
    }
    if (const int place = view.axis_by_name(name); place >= 0) return place;
    const auto number_behind = [&](std::size_t from) -> int {
        int number = 0;
        if (from >= name.size() || name.size() - from > 2) return -1;
        for (std::size_t i = from; i < name.size(); ++i) {
            if (!is_digit(name[i])) return -1;
            number = number * 10 + (name[i] - '0');
        }
        return number;
    };
    if (name.size() > 1 && name[0] == 'S')
        if (const int n = number_behind(1); n > 0) return kSpindleAxis + n;
    // Machine axes: AX3 by number, X1 by the letter (MD10000: X1 Y1 Z1 A1 B1 C1 U1 V1).
    if (name.size() > 2 && name.substr(0, 2) == "AX")
        if (const int n = number_behind(2); n > 0)
            for (unsigned i = 0; i < view.axis_count; ++i)
                if (view.axes[i].machine_axis + 1 == n) return static_cast<int>(i);
    if (name.size() == 2 && name[1] == '1' &&
        std::string_view("XYZABCUV").find(name[0]) != std::string_view::npos)
        return view.axis_by_name(name.substr(0, 1));
    return -1;
}
std::string axis_name(const Execution& x, int place) {
    const MachineView& view = x.core.view();
    if (place >= kSpindleAxis) return "S" + std::to_string(place - kSpindleAxis);
    return place >= 0 && static_cast<unsigned>(place) < view.axis_count
               ? view.axes[static_cast<std::size_t>(place)].name
               : std::string();
}
bool f_axname(Execution& x, Call& c) {
    const std::string name = upper(c.value(0).text);
    const int axis = find_axis(x, name);
    if (axis < 0) return fail(x, Alarm::AxisUnknown, name);
    c.result = Value::of_axis(axis, name);
    return true;
}
bool f_axstring(Execution& x, Call& c) {
    c.result = Value::of_text(c.value(0).type == Type::Axis ? axis_name(x, c.value(0).place())
                                                            : std::string());
    return true;
}
bool f_isaxis(Execution& x, Call& c) {
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    const double n = c.number(0);
    if (n < 1 || n > 3) return fail(x, Alarm::FunctionArgument, "ISAXIS", n);
    c.result =
        Value::of_bool(x.core.view().axis_by_role(kRoles[static_cast<std::size_t>(n) - 1]) >= 0);
    return true;
}
bool f_spi(Execution& x, Call& c) {
    const double n = c.number(0);
    if (!(n >= 1 && n <= kMaxSpindles) ||
        !x.core.view().machine.spindle(static_cast<std::size_t>(n)).exists())
        return fail(x, Alarm::SpindleNumberIllegal, {}, n);
    c.result = Value::of_axis(kSpindleAxis + static_cast<int>(n),
                              "S" + std::to_string(static_cast<int>(n)));
    return true;
}
bool f_axtospi(Execution& x, Call& c) {
    if (c.value(0).type != Type::Axis || c.value(0).place() < kSpindleAxis)
        return fail(x, Alarm::AxisKindWrong, c.value(0).text);
    c.result = Value::of_int(c.value(0).place() - kSpindleAxis);
    return true;
}
bool f_modaxval(Execution& x, Call& c) {
    const int place = c.value(0).type == Type::Axis ? c.value(0).place() : -1;
    double value = c.number(1);
    if (place < 0) return fail(x, Alarm::AxisKindWrong, c.value(0).text);
    if (place < kSpindleAxis) {
        const ChannelAxis& axis = x.core.view().axes[static_cast<std::size_t>(place)];
        if (axis.rollover) value -= std::floor(value / axis.rollover_deg) * axis.rollover_deg;
    } else {
        value -= std::floor(value / 360.0) * 360.0;
    }
    c.result = Value::of_real(value);
    return true;
}
// An axis of the channel as argument `k`; false: none.
bool axis_argument(Execution& x, Call& c, std::size_t k, std::string_view name,
                   std::size_t& place) {
    const int at = c.has(k) && c.value(k).type == Type::Axis ? c.value(k).place() : -1;
    if (at < 0) return fail(x, Alarm::AxisArgumentMissing, std::string(name));
    if (at >= kSpindleAxis) return fail(x, Alarm::AxisKindWrong, c.value(k).text);
    place = static_cast<std::size_t>(at);
    return true;
}
bool axes_only(Execution& x, const Call& c) {
    for (std::size_t k = 0; k < c.arguments.size(); ++k)
        if (!c.has(k) || c.value(k).type != Type::Axis)
            return fail(x, Alarm::AxisArgumentMissing,
                        std::string(x.block.procedures.back().first->name));
    return true;
}
}  // namespace polyturn::channels::sinumerik
