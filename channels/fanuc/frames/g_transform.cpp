// G12.1 G13.1 (G112 G113): the face as a plane of X and C. G7.1 (G107): the surface of a cylinder.
//
// The specification names the codes, their group and N0217 only (nct part 1 4.4, 14.2); what the
// control of this family does beside that is written down in docs/design/transformations.md.
#include "channels/fanuc/frames/g_transform.hpp"

#include <cmath>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/program/faults.hpp"
#include "channels/state/tip_control.hpp"

namespace polyturn::channels::fanuc {
namespace {

bool is_cylinder(const Transformation& t) {
    return kind_of(t.kinematics) == KinematicsKind::Cylinder;
}

// Codes that may stand while the plane or the cylinder is on: lines, arcs, compensation, macros,
// modes of words and feed. Everything else means coordinates or axes that do not exist now.
constexpr std::uint16_t kAllowed[] = {10,  20,  30,  40,  71,  90,  121, 131,  400,  410, 420,
                                      610, 640, 650, 660, 661, 670, 970, 1070, 1120, 1130};

// Place of the linear or the rotary axis: by its number in the channel, else by its name.
int transformation_axis(const Execution& x, std::int64_t number, bool rotary) {
    const MachineView& view = x.core.view();
    const auto is_rotary = [&](unsigned i) { return view.axes[i].rotary || view.axes[i].turns; };
    if (number > 0) {
        if (number > static_cast<std::int64_t>(view.axis_count)) return -1;
        return is_rotary(static_cast<unsigned>(number - 1)) == rotary ? static_cast<int>(number - 1)
                                                                      : -1;
    }
    if (!rotary) return view.axis_by_role(PlaneRole::BasicX);
    const int c = view.axis_by_name("C");
    if (c >= 0 && is_rotary(static_cast<unsigned>(c))) return c;
    for (unsigned i = 0; i < view.axis_count; ++i)
        if (is_rotary(i)) return static_cast<int>(i);
    return -1;
}

// The codes stand alone in their block, outside of compensation, cycles and programmed frames.
bool transformation_alone(Execution& x, Alarm alarm) {
    std::uint32_t letters =
        x.block.letters & ~((1u << ('N' - 'A')) | (1u << ('O' - 'A')) | (1u << ('G' - 'A')));
    if (alarm == Alarm::CylinderPlace) letters &= ~x.vocabulary.axis_letters;
    if (letters || x.words.g_count != 1) return x.core.fail(alarm, 'G', "own block");
    if (x.core.reads_ahead()) return x.core.fail(alarm, 'G', "G41 G42");
    if (x.modal.drilling || x.core.path.framed || x.modal.polar.on)
        return x.core.fail(alarm, 'G',
                           x.modal.drilling   ? "G80"
                           : x.modal.polar.on ? "G16"
                                              : "G51 G68");
    return true;
}

}  // namespace

bool switches_transformation(Execution& x) {
    if (x.words.has(GGroup::Transform)) return true;
    const bool length = x.words.has(GGroup::Length);
    if (length && controls_tip(x.core)) return true;
    if (!x.words.has(GGroup::OneShot)) return false;
    return x.words.row(GGroup::OneShot)->is(Trait::Cylinder);
}

bool g_polar_plane(Execution& x, const GCode& row) {
    const bool on = row.tenths == 121 || row.tenths == 1120;
    const Transformation& now = x.core.path.transformation;
    if (!on) {
        if (!now.active()) return true;  // off again is no mistake
        if (!transformation_alone(x, Alarm::TransformPlace)) return false;
        if (is_cylinder(now)) return x.core.fail(Alarm::CylinderCode, 'G', std::string(row.name));
        x.core.transform_off();
        x.core.path.plane = x.modal.plane_before;
        return true;
    }
    if (!transformation_alone(x, Alarm::TransformPlace)) return false;
    if (now.active())
        return x.core.fail(is_cylinder(now) ? Alarm::CylinderCode : Alarm::TransformPlace, 'G',
                           std::string(row.name));
    const params::Table& t = x.core.view().table();
    const unsigned l = x.core.view().channel;
    const int x_place = transformation_axis(x, params::get(t, params::f5460, l), false),
              c = transformation_axis(x, params::get(t, params::f5461, l), true);
    if (x_place < 0 || c < 0 || x_place == c ||
        x.core.view().axes[static_cast<std::size_t>(x_place)].rotary)
        return x.core.fail(Alarm::TransformAxis, 'G', x_place < 0 ? "X" : "C");
    // the linear axis is not in it
    if (x.settings.policy.motion.polar_not_in_yz && x.core.path.plane == Plane::YZ)
        return x.core.fail(Alarm::TransformPlace, 'G', "G19");
    const MachineView& view = x.core.view();
    for (const int place : {x_place, c})
        if (view.axes[static_cast<std::size_t>(place)].hypothetical)
            return x.core.fail(Alarm::AxisHypothetical, 'G',
                               view.axes[static_cast<std::size_t>(place)].name);
    Transformation wanted;
    wanted.kinematics.kind = static_cast<std::uint32_t>(KinematicsKind::Polar);
    wanted.kinematics.axis[0] = static_cast<std::uint8_t>(x_place);
    wanted.kinematics.axis[1] = static_cast<std::uint8_t>(c);
    wanted.kinematics.value[0] =
        params::get(t, params::n0217_polar_intp_comp_amount,
                    view.axes[static_cast<std::size_t>(c)].machine_axis + 1u);
    wanted.kinematics.value[1] = 1.0;
    wanted.virtual_y = static_cast<std::int8_t>(c);
    wanted.counts_from_here = true;
    if (!x.core.transform(wanted)) return false;
    x.modal.plane_before = x.core.path.plane;
    x.core.path.plane = Plane::XY;  // of the linear axis and the one that replaces Y
    return true;
}

bool g_cylinder(Execution& x, const GCode& row) {
    const Transformation& now = x.core.path.transformation;
    if (!transformation_alone(x, Alarm::CylinderPlace)) return false;
    if (now.active() && !is_cylinder(now))
        return x.core.fail(Alarm::TransformCode, 'G', std::string(row.name));
    if (x.words.axis_count != 1) return x.core.fail(Alarm::CylinderPlace, 'G', "C");
    const Word& word = x.block.words[x.words.axes[0]];
    const auto [place, incremental] = axis_of(x, word);
    const ChannelAxis& axis = x.core.view().axes[static_cast<std::size_t>(place)];
    if (incremental || !(axis.rotary || axis.turns))
        return x.core.fail(Alarm::TransformAxis, word.address, axis.name);
    if (axis.hypothetical) return x.core.fail(Alarm::AxisHypothetical, word.address, axis.name);
    const double radius = length_of(x, word, -1);
    if (radius < 0) return x.core.fail(Alarm::TransformValue, word.address, axis.name);
    if (radius == 0) {
        x.core.transform_off();
        x.core.path.plane_p = x.core.path.plane_q = -1;
        return true;
    }
    // another radius: end it first
    if (now.active()) return x.core.fail(Alarm::CylinderPlace, word.address, "G7.1 C0");
    const int z = x.core.view().axis_by_role(PlaneRole::BasicZ);
    if (z < 0 || x.core.path.plane == Plane::XY)
        return x.core.fail(Alarm::CylinderPlace, 'G', "G18 G19");
    Transformation wanted;
    wanted.kinematics.kind = static_cast<std::uint32_t>(KinematicsKind::Cylinder);
    wanted.kinematics.axis[0] = static_cast<std::uint8_t>(place);
    wanted.kinematics.value[0] = radius;
    wanted.degrees = true;
    if (!x.core.transform(wanted)) return false;
    // G18: Z and the axis in place of X; G19: the axis in place of Y, and Z.
    const bool zc = x.core.path.plane == Plane::ZX;
    x.core.path.plane_p = static_cast<std::int8_t>(zc ? z : place);
    x.core.path.plane_q = static_cast<std::int8_t>(zc ? place : z);
    return true;
}

// What the block says while a transformation is on.
bool transformation_allows(Execution& x) {
    const Transformation& t = x.core.path.transformation;
    if (!t.active() || controls_tip(x.core)) return true;
    const bool cylinder = is_cylinder(t);
    const Alarm alarm = cylinder ? Alarm::CylinderCode : Alarm::TransformCode;
    for (unsigned k = 0; k < x.words.g_count; ++k) {
        const Word& word = x.block.words[x.words.g[k]];
        const auto tenths = static_cast<std::uint16_t>(std::lround(word.value * 10.0));
        bool allowed = false;
        for (const std::uint16_t one : kAllowed) allowed = allowed || one == tenths;
        const GCode* row = x.vocabulary.table.find(tenths);
        if (row && (row->group == GGroup::Distance || row->group == GGroup::FeedMode))
            allowed = true;
        if (allowed) continue;
        blame(x, word);
        return x.core.fail(alarm, 'G', row ? std::string(row->name) : std::string("G"));
    }
    if (x.block.has('T') && !(x.vocabulary.axis_letters >> ('T' - 'A') & 1u))
        return x.core.fail(alarm, 'T', "T");
    const GCode* motion =
        x.words.has(GGroup::Motion) ? x.words.row(GGroup::Motion) : x.modal.motion;
    const bool one_shot = x.words.has(GGroup::OneShot) || x.words.has(GGroup::MacroModal);
    if (x.words.axis_count && !one_shot && !switches_transformation(x) && motion->tenths != 10 &&
        motion->tenths != 20 && motion->tenths != 30)
        return x.core.fail(alarm, 'G', std::string(motion->name));
    return true;
}

}  // namespace polyturn::channels::fanuc
