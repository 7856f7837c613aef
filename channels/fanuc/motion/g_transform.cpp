// G12.1 G13.1 (G112 G113): the face as a plane of X and C. G7.1 (G107): the surface of a cylinder.
//
// The specification names the codes, their group and N0217 only (nct part 1 4.4, 14.2); what the
// control of this family does beside that is written down in docs/design/transformations.md.
#include <cmath>

#include "channels/fanuc/interpreter.hpp"
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

}  // namespace

bool Interpreter::switches_transformation() const {
    if (coded_groups_ & (1u << static_cast<unsigned>(GGroup::Transform))) return true;
    const bool length = (coded_groups_ & (1u << static_cast<unsigned>(GGroup::Length))) != 0;
    if (length && controls_tip(const_cast<Interpreter*>(this)->core_)) return true;
    if (!(coded_groups_ & (1u << static_cast<unsigned>(GGroup::OneShot)))) return false;
    return coded_[static_cast<std::size_t>(GGroup::OneShot)]->act == &Interpreter::g_cylinder;
}

// Place of the linear or the rotary axis: by its number in the channel, else by its name.
int Interpreter::transformation_axis(std::int64_t number, bool rotary) const {
    const MachineView& view = core_.view();
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
bool Interpreter::transformation_alone(Alarm alarm) {
    std::uint32_t letters =
        block_.letters & ~((1u << ('N' - 'A')) | (1u << ('O' - 'A')) | (1u << ('G' - 'A')));
    if (alarm == Alarm::CylinderPlace) letters &= ~axis_letters_;
    if (letters || g_count_ != 1) return core_.fail(alarm, 'G', "own block");
    if (core_.reads_ahead()) return core_.fail(alarm, 'G', "G41 G42");
    if (drilling_ || core_.path.framed || polar_)
        return core_.fail(alarm, 'G', drilling_ ? "G80" : polar_ ? "G16" : "G51 G68");
    return true;
}

bool Interpreter::g_polar_plane(const GCode& row) {
    const bool on = row.tenths == 121 || row.tenths == 1120;
    const Transformation& now = core_.path.transformation;
    if (!on) {
        if (!now.active()) return true;  // off again is no mistake
        if (!transformation_alone(Alarm::TransformPlace)) return false;
        if (is_cylinder(now)) return core_.fail(Alarm::CylinderCode, 'G', std::string(row.name));
        core_.transform_off();
        core_.path.plane = plane_before_;
        return true;
    }
    if (!transformation_alone(Alarm::TransformPlace)) return false;
    if (now.active())
        return core_.fail(is_cylinder(now) ? Alarm::CylinderCode : Alarm::TransformPlace, 'G',
                          std::string(row.name));
    const params::Table& t = core_.view().table();
    const unsigned l = core_.view().channel;
    const int x = transformation_axis(params::get(t, params::f5460, l), false),
              c = transformation_axis(params::get(t, params::f5461, l), true);
    if (x < 0 || c < 0 || x == c || core_.view().axes[static_cast<std::size_t>(x)].rotary)
        return core_.fail(Alarm::TransformAxis, 'G', x < 0 ? "X" : "C");
    // the linear axis is not in it
    if (settings_.nct && core_.path.plane == Plane::YZ)
        return core_.fail(Alarm::TransformPlace, 'G', "G19");
    const MachineView& view = core_.view();
    for (const int place : {x, c})
        if (view.axes[static_cast<std::size_t>(place)].hypothetical)
            return core_.fail(Alarm::AxisHypothetical, 'G',
                              view.axes[static_cast<std::size_t>(place)].name);
    Transformation wanted;
    wanted.kinematics.kind = static_cast<std::uint32_t>(KinematicsKind::Polar);
    wanted.kinematics.axis[0] = static_cast<std::uint8_t>(x);
    wanted.kinematics.axis[1] = static_cast<std::uint8_t>(c);
    wanted.kinematics.value[0] =
        params::get(t, params::n0217_polar_intp_comp_amount,
                    view.axes[static_cast<std::size_t>(c)].machine_axis + 1u);
    wanted.kinematics.value[1] = 1.0;
    wanted.virtual_y = static_cast<std::int8_t>(c);
    wanted.counts_from_here = true;
    if (!core_.transform(wanted)) return false;
    plane_before_ = core_.path.plane;
    core_.path.plane = Plane::XY;  // of the linear axis and the one that replaces Y
    return true;
}

bool Interpreter::g_cylinder(const GCode& row) {
    const Transformation& now = core_.path.transformation;
    if (!transformation_alone(Alarm::CylinderPlace)) return false;
    if (now.active() && !is_cylinder(now))
        return core_.fail(Alarm::TransformCode, 'G', std::string(row.name));
    if (axis_word_count_ != 1) return core_.fail(Alarm::CylinderPlace, 'G', "C");
    const Word& word = block_.words[axis_words_[0]];
    const auto [place, incremental] = axis_of(word);
    const ChannelAxis& axis = core_.view().axes[static_cast<std::size_t>(place)];
    if (incremental || !(axis.rotary || axis.turns))
        return core_.fail(Alarm::TransformAxis, word.address, axis.name);
    if (axis.hypothetical) return core_.fail(Alarm::AxisHypothetical, word.address, axis.name);
    const double radius = length(word, -1);
    if (radius < 0) return core_.fail(Alarm::TransformValue, word.address, axis.name);
    if (radius == 0) {
        core_.transform_off();
        core_.path.plane_p = core_.path.plane_q = -1;
        return true;
    }
    // another radius: end it first
    if (now.active()) return core_.fail(Alarm::CylinderPlace, word.address, "G7.1 C0");
    const int z = core_.view().axis_by_role(PlaneRole::BasicZ);
    if (z < 0 || core_.path.plane == Plane::XY)
        return core_.fail(Alarm::CylinderPlace, 'G', "G18 G19");
    Transformation wanted;
    wanted.kinematics.kind = static_cast<std::uint32_t>(KinematicsKind::Cylinder);
    wanted.kinematics.axis[0] = static_cast<std::uint8_t>(place);
    wanted.kinematics.value[0] = radius;
    wanted.degrees = true;
    if (!core_.transform(wanted)) return false;
    // G18: Z and the axis in place of X; G19: the axis in place of Y, and Z.
    const bool zc = core_.path.plane == Plane::ZX;
    core_.path.plane_p = static_cast<std::int8_t>(zc ? z : place);
    core_.path.plane_q = static_cast<std::int8_t>(zc ? place : z);
    return true;
}

// What the block says while a transformation is on.
bool Interpreter::transformation_allows() {
    const Transformation& t = core_.path.transformation;
    if (!t.active() || controls_tip(core_)) return true;
    const bool cylinder = is_cylinder(t);
    const Alarm alarm = cylinder ? Alarm::CylinderCode : Alarm::TransformCode;
    for (unsigned k = 0; k < g_count_; ++k) {
        const Word& word = block_.words[g_words_[k]];
        const auto tenths = static_cast<std::uint16_t>(std::lround(word.value * 10.0));
        bool allowed = false;
        for (const std::uint16_t one : kAllowed) allowed = allowed || one == tenths;
        const GCode* row = table_.find(tenths);
        if (row && (row->group == GGroup::Distance || row->group == GGroup::FeedMode))
            allowed = true;
        if (allowed) continue;
        fault_column_ = word.column;
        fault_length_ = word.length;
        return core_.fail(alarm, 'G', row ? std::string(row->name) : std::string("G"));
    }
    if (block_.has('T') && !(axis_letters_ >> ('T' - 'A') & 1u)) return core_.fail(alarm, 'T', "T");
    const GCode* motion = coded_groups_ & (1u << static_cast<unsigned>(GGroup::Motion))
                              ? coded_[static_cast<std::size_t>(GGroup::Motion)]
                              : motion_;
    const bool one_shot =
        (coded_groups_ & ((1u << static_cast<unsigned>(GGroup::OneShot)) |
                          (1u << static_cast<unsigned>(GGroup::MacroModal)))) != 0;
    if (axis_word_count_ && !one_shot && !switches_transformation() && motion->tenths != 10 &&
        motion->tenths != 20 && motion->tenths != 30)
        return core_.fail(alarm, 'G', std::string(motion->name));
    return true;
}

}  // namespace polyturn::channels::fanuc
