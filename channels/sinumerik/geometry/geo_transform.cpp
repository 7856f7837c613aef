// TRANSMIT, TRACYL, TRAANG, TRAFOOF (sinumerik_part3 7.7, part 1 2.4, part 2 16.2): the geometry
// axes of the program, which the machine has no axes for, and the machine axes that make them.
// Behind frames, compensation and tool length.
#include "channels/sinumerik/geometry/geo_transform.hpp"

#include <numbers>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/state/tip_control.hpp"

namespace polyturn::channels::sinumerik {
namespace {

enum Kind : std::int64_t { kTransmit = 256, kTracyl = 512, kTraang = 1024 };
constexpr unsigned kSets = 4;

auto axes_of_set(unsigned n) {
    switch (n) {
        case 1:
            return params::md24110;
        case 2:
            return params::md24210;
        case 3:
            return params::md24310;
        default:
            return params::md24410;
    }
}

// The data set of that kind: the one that is named, else the first. `axes`: places; of X, C, Z
// where the data name none.
bool transformation_data(Execution& x, std::int64_t kind, const Call& c, std::size_t number_at,
                         std::array<int, 3>& axes) {
    const MachineView& view = x.core.view();
    const params::Table& t = view.table();
    const std::int64_t kinds[kSets] = {params::get(t, params::md24100, view.channel),
                                       params::get(t, params::md24200, view.channel),
                                       params::get(t, params::md24300, view.channel),
                                       params::get(t, params::md24400, view.channel)};
    const std::string name = kind == kTransmit ? "TRANSMIT" : kind == kTracyl ? "TRACYL" : "TRAANG";
    unsigned set = 0;
    if (c.has(number_at)) {  // it counts the sets of its kind
        const double wanted = c.number(number_at);
        double seen = 0;
        for (unsigned n = 1; n <= kSets && !set; ++n)
            if (kinds[n - 1] == kind && ++seen == wanted) set = n;
        if (!set) return fail(x, Alarm::TransformNone, name + " " + to_text(Value::of_int(wanted)));
    }
    for (unsigned n = 1; n <= kSets && !set; ++n)
        if (kinds[n - 1] == kind) set = n;
    // of a cylinder, only the one without groove side offset is there (512, not 513 and 514)
    if (!set) {
        for (unsigned n = 1; n <= kSets; ++n)
            if (kind == kTracyl && (kinds[n - 1] == 513 || kinds[n - 1] == 514))
                return fail(x, Alarm::NotBuilt,
                            "TRACYL " + to_text(Value::of_int(static_cast<double>(kinds[n - 1]))));
        return fail(x, Alarm::TransformNone, name);
    }
    const auto place = [&](unsigned k, int otherwise) {
        const auto number = params::get(t, axes_of_set(set), view.channel, k);
        return number > 0 ? (number <= static_cast<std::int64_t>(view.axis_count)
                                 ? static_cast<int>(number - 1)
                                 : -1)
                          : otherwise;
    };
    const bool inclined = kind == kTraang;
    const int z = view.axis_by_role(PlaneRole::BasicZ);
    axes = {place(0, view.axis_by_role(PlaneRole::BasicX)),
            place(1, inclined ? z : view.axis_by_name("C")), inclined ? z : place(2, z)};
    static constexpr const char* kNames[] = {"X", "C", "Z"};
    for (std::size_t k = 0; k < (inclined ? 2u : 3u); ++k) {
        if (kind == kTransmit && k == 2) continue;
        const int i = axes[k];
        const bool turns = i >= 0 && (view.axes[static_cast<std::size_t>(i)].rotary ||
                                      view.axes[static_cast<std::size_t>(i)].turns);
        if (i < 0 || turns != (!inclined && k == 1))
            return fail(x, Alarm::TransformAxis,
                        i < 0 ? kNames[k] : view.axes[static_cast<std::size_t>(i)].name);
    }
    return true;
}

bool switch_transformation(Execution& x, const Transformation& wanted) {
    if (x.core.reads_ahead()) return fail(x, Alarm::TransformPlace, "G41, G42");
    if (!need_fresh(x)) return false;  // the axes rest first
    x.run.state_changed = true;
    x.core.transform_off();
    if (!wanted.active()) return true;
    return x.core.transform(wanted);
}

}  // namespace

bool p_transmit(Execution& x, Call& c) {
    std::array<int, 3> axes{};
    if (!transformation_data(x, kTransmit, c, 0, axes)) return false;
    const MachineView& view = x.core.view();
    const params::Table& t = view.table();
    Transformation wanted;
    wanted.kinematics.kind = static_cast<std::uint32_t>(KinematicsKind::Polar);
    wanted.kinematics.axis[0] = static_cast<std::uint8_t>(axes[0]);
    wanted.kinematics.axis[1] = static_cast<std::uint8_t>(axes[1]);
    wanted.kinematics.centre[1] = params::get(t, params::md24900, view.channel);
    wanted.kinematics.value[0] =
        params::get(t, params::n0217_polar_intp_comp_amount,
                    view.axes[static_cast<std::size_t>(axes[1])].machine_axis + 1u);
    wanted.kinematics.value[1] = params::get(t, params::md24910, view.channel) ? 1.0 : -1.0;
    wanted.side = static_cast<PoleSide>(params::get(t, params::md24911, view.channel));
    wanted.virtual_y = static_cast<std::int8_t>(axes[1]);
    wanted.named_y = wanted.about_machine_zero = true;
    return switch_transformation(x, wanted);
}

bool p_tracyl(Execution& x, Call& c) {
    std::array<int, 3> axes{};
    if (!c.has(0) || !(c.number(0) > 0)) return fail(x, Alarm::TransformValue, "TRACYL");
    if (!transformation_data(x, kTracyl, c, 1, axes)) return false;
    const MachineView& view = x.core.view();
    const params::Table& t = view.table();
    Transformation wanted;
    wanted.kinematics.kind = static_cast<std::uint32_t>(KinematicsKind::Cylinder);
    wanted.kinematics.axis[0] = static_cast<std::uint8_t>(axes[1]);
    wanted.kinematics.centre[0] = params::get(t, params::md24800, view.channel);
    wanted.kinematics.value[0] =
        (params::get(t, params::md24810, view.channel) ? 0.5 : -0.5) * c.number(0) * unit(x);
    wanted.virtual_y = static_cast<std::int8_t>(axes[1]);
    wanted.named_y = true;
    return switch_transformation(x, wanted);
}

bool p_traang(Execution& x, Call& c) {
    std::array<int, 3> axes{};
    if (!transformation_data(x, kTraang, c, 1, axes)) return false;
    const MachineView& view = x.core.view();
    if (c.has(0)) x.modal.inclined_deg = c.number(0);
    const double degrees =
        x.modal.inclined_deg.value_or(params::get(view.table(), params::md24700, view.channel));
    if (!(std::fabs(degrees) > 0 && std::fabs(degrees) <= 89))
        return fail(x, Alarm::TransformValue, "TRAANG");
    Transformation wanted;
    wanted.kinematics.kind = static_cast<std::uint32_t>(KinematicsKind::Inclined);
    wanted.kinematics.axis[0] = static_cast<std::uint8_t>(axes[0]);
    wanted.kinematics.axis[1] = static_cast<std::uint8_t>(axes[1]);
    wanted.kinematics.value[0] = degrees * std::numbers::pi / 180.0;
    return switch_transformation(x, wanted);
}

// TRAORI: the tip goes where the program says while head and table turn. What they are like is told
// once, for all languages, by N3200 to N3224. Directions of the tool (A3=, ORI codes) are not known
// to it: the rotary axes are programmed by their angles.
bool p_trafoof(Execution& x, Call& c) {
    if (x.block.procedures.front().first->name == "TRAORI") {
        if (c.has(0) && c.number(0) != 1)
            return fail(x, Alarm::TransformNone, "TRAORI " + to_text(Value::of_int(c.number(0))));
        if (c.has(1)) return fail(x, Alarm::TransformValue, "TRAORI");
        if (params::get(x.core.view().table(), params::n3200_mechanical_type,
                        x.core.view().channel) == 0)
            return fail(x, Alarm::TransformNone, "TRAORI");
        if (x.core.reads_ahead()) return fail(x, Alarm::TransformPlace, "G41, G42");
        if (!need_fresh(x)) return false;
        x.run.state_changed = true;
        x.core.transform_off();
        return control_tip(x.core);
    }
    if (!x.core.transformed()) return true;
    return switch_transformation(x, {});
}

}  // namespace polyturn::channels::sinumerik
