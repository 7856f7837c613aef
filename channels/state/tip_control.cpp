// Rotary heads and tables (nct part 2 33): the parameters as the transformation that channel and
// kernel share.
#include "channels/state/tip_control.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "channels/state/core.hpp"
#include "ipc/kinematics/five_axis.hpp"

namespace polyturn::channels {
namespace {
namespace p = params;
constexpr double kMmPerInch = 25.4;

// N3205, N3206: 1 X, 2 Y, 3 Z; 4 in XY from X, 5 in YZ from Y, 6 in ZX from Z.
bool direction_of(std::int64_t code, double degrees, bool reversed, double* out) {
    if (code < 1 || code > 6 || (code <= 3 && degrees != 0)) return false;
    const double sense = reversed ? -1.0 : 1.0, angle = degrees * std::numbers::pi / 180.0;
    const auto first = static_cast<std::size_t>((code - 1) % 3);
    out[0] = out[1] = out[2] = 0;
    out[first] = sense * (code <= 3 ? 1.0 : std::cos(angle));
    if (code > 3) out[(first + 1) % 3] = sense * std::sin(angle);
    return true;
}
}  // namespace

bool controls_tip(Core& core) {
    return kind_of(core.path.transformation.kinematics) == KinematicsKind::FiveAxis;
}

bool control_tip(Core& core, bool head_alone) {
    Transformation wanted;
    return describe_head(core, head_alone, wanted) && core.transform(wanted);
}

bool describe_head(Core& core, bool head_alone, Transformation& wanted) {
    namespace f = five_axis;
    const MachineView& view = core.view();
    PathState& path = core.path;
    const p::Table& t = view.table();
    const unsigned l = view.channel;
    const auto refuse = [&](const std::string& what) {
        return core.fail(Alarm::FiveAxisUndefined, 'G', what);
    };
    const std::array<int, 3> geo{view.axis_by_role(PlaneRole::BasicX),
                                 view.axis_by_role(PlaneRole::BasicY),
                                 view.axis_by_role(PlaneRole::BasicZ)};
    const auto type = p::get(t, p::n3200_mechanical_type, l);
    if (type < 1 || type > 3) return refuse("N3200");
    wanted = {};
    Kinematics& k = wanted.kinematics;
    k.kind = static_cast<std::uint32_t>(KinematicsKind::FiveAxis);
    for (std::size_t r = 0; r < 3; ++r) {
        if (geo[r] < 0) return refuse(std::string(1, "XYZ"[r]));
        k.axis[r] = static_cast<std::uint8_t>(geo[r]);
    }
    const double unit = view.config().inch ? kMmPerInch : 1.0;
    if (core.vector_pending()) core.take_wanted();  // the tool's length is in the arms
    std::array<double, 3> tool{};
    for (std::size_t r = 0; r < 3; ++r) tool[r] = path.shift[k.axis[r]] + path.wanted[k.axis[r]];
    // Each rotary axis: whose it is, where it points; a missing one that has a fixed angle turns by
    // that.
    const auto rotary = [&](std::size_t role, std::int64_t number, bool fixed, double angle,
                            std::int64_t code, double tilt, bool reversed, std::size_t at,
                            const char* name) {
        k.axis[role] = kNoPlace;
        if (number == 0 && !fixed) return true;
        // an axis of the table
        if (head_alone && (type == 2 || (type == 3 && role == 4))) return true;
        if (!direction_of(code, tilt, reversed, &k.value[at])) return refuse(name);
        k.centre[role] = angle;
        if (number == 0) return true;
        for (unsigned i = 0; i < view.axis_count; ++i)
            if (view.axes[i].machine_axis + 1 == number && view.axes[i].rotary)
                k.axis[role] = static_cast<std::uint8_t>(i);
        return k.axis[role] != kNoPlace ? true : refuse(name);
    };
    const auto flag = [&](unsigned bit) { return p::bit(t, p::n3212_5d_control, l, bit); };
    if (!rotary(3, p::get(t, p::n3204_no_of_the_first_rot_ax, l), flag(0),
                p::get(t, p::n3207_angle_of_the_first_rot_ax, l),
                p::get(t, p::n3205_direction_of_the_first_rot_ax, l),
                p::get(t, p::n3206_inclination_angle_of_the_first_rot_ax, l), flag(2),
                f::kFirstDirection, "N3204 N3205"))
        return false;
    if (!rotary(4, p::get(t, p::n3208_no_of_the_second_rot_ax, l), flag(1),
                p::get(t, p::n3211_angle_of_the_second_rot_ax, l),
                p::get(t, p::n3209_direction_of_the_second_rot_ax, l),
                p::get(t, p::n3210_inclination_angle_of_the_second_rot_ax, l), flag(3),
                f::kSecondDirection, "N3208 N3209"))
        return false;
    if (!f::exists(k, f::kFirstDirection) && !f::exists(k, f::kSecondDirection))
        return refuse("N3204 N3208");
    if (k.axis[3] != kNoPlace && k.axis[3] == k.axis[4]) return refuse("N3204 N3208");
    const std::array<double, 3> table{p::get(t, p::n3213_rotary_table_pos_x, l) * unit,
                                      p::get(t, p::n3214_rotary_table_pos_y, l) * unit,
                                      p::get(t, p::n3215_rotary_table_pos_z, l) * unit};
    const std::array<double, 3> second_table{
        p::get(t, p::n3216_offset_of_2nd_rotary_table_x, l) * unit,
        p::get(t, p::n3217_offset_of_2nd_rotary_table_y, l) * unit,
        p::get(t, p::n3218_offset_of_2nd_rotary_table_z, l) * unit};
    const std::array<double, 3> pivot{
        p::get(t, p::n3219_offs_between_tool_holder_and_2nd_rot_ax_x, l) * unit,
        p::get(t, p::n3220_offs_between_tool_holder_and_2nd_rot_ax_y, l) * unit,
        p::get(t, p::n3221_offs_between_tool_holder_and_2nd_rot_ax_z, l) * unit};
    const std::array<double, 3> outer{
        p::get(t, p::n3222_offs_between_the_2nd_and_1st_rot_ax_x, l) * unit,
        p::get(t, p::n3223_offs_between_the_2nd_and_1st_rot_ax_y, l) * unit,
        p::get(t, p::n3224_offs_between_the_2nd_and_1st_rot_ax_z, l) * unit};
    k.value[f::kFirstIsHead] = type != 2;
    k.value[f::kSecondIsHead] = type == 1;
    for (std::size_t r = 0; r < 3; ++r) {
        // From the pivot to the tip: the pivot as seen from the holder, the other way round, and on
        // by the tool, whose tip lies against its offset. A point of a table in carrier coordinates
        // lies ahead of the tip by the same.
        const double arm = -pivot[r] - tool[r];
        // A head with one axis alone carries the tool itself.
        k.value[f::kFirstPoint + r] =
            type == 1   ? (f::exists(k, f::kSecondDirection) ? -outer[r] : arm - outer[r])
            : type == 3 ? arm
                        : table[r] + tool[r];
        k.value[f::kSecondPoint + r] = type == 1   ? arm
                                       : type == 3 ? table[r] + tool[r]
                                                   : table[r] + second_table[r] + tool[r];
    }
    return true;
}

}  // namespace polyturn::channels
