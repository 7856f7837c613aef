// G75, G76: moves that the probe ends; G52 likewise with a hard stop; G46: the inclined axis; G36
// to G39 at the end of a block.
#include <cmath>
#include <numbers>

#include "channels/fagor/interpreter.hpp"

namespace polyturn::channels::fagor {

bool Interpreter::g_probe(const GCode& row) {
    if (!has_axes())
        return core_.fail(Alarm::CoordinateAxisNone, 'G', row.number == 75 ? "G75" : "G76");
    if (modal_.comp != 40)
        return core_.fail(Alarm::FagorIncompatible, 'G', row.number == 75 ? "G75 G41" : "G76 G41");
    if (!read_point(target_, nullptr) || !set_feed(target_)) return false;
    modal_.motion = 1;
    return start_probe(modal_.probe_input == 2 ? "2" : "1", row.number);
}

bool Interpreter::start_probe(std::string_view input, std::uint16_t code) {
    const std::uint64_t before = core_.moves();
    const bool locked = core_.path.override_locked;
    if (code != 52 && !settings_.probe_override) {  // no override at all, the program's neither
        core_.path.override_locked = true;
        core_.path.feed_path.scale = 1.0;
    }
    const bool good = code == 52
                          ? core_.fixed_stop(target_, 0.0, core_.path.feed_mode, false, input)
                          : core_.skip(target_, 0.0, core_.path.feed_mode, input, code == 76);
    core_.path.override_locked = locked;
    if (!good) return false;
    if (core_.moves() != before) probing_ = wants_barrier_ = true;
    probe_code_ = code;
    return true;
}

// Behind the barrier: the axes stand where the signal stopped them, and are programmed to be there.
Step Interpreter::finish_probe() {
    probing_ = false;
    core_.begin_block();
    const AxisValues wished = core_.path.machine;
    const AxisSet early = core_.take_skip();
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (early >> i & 1u) ways_.take_back(i, wished[i] - core_.path.machine[i]);
    state_changed_ = true;
    if (probe_code_ != 52) touched();
    if (probe_code_ == 52) {
        for (unsigned i = 0; i < core_.view().axis_count; ++i)
            if (core_.skip_moved() >> i & 1u) core_.limit_torque(i, 0.0, 0.0);
        return Step::AtBarrier;  // the command comes back to where the slides stand
    }
    if (early) return Step::Continue;
    if (settings_.probe_error && modal_.probe_mode == 0)
        return fault({Alarm::FagorProbe, 'G', static_cast<double>(probe_code_), 0.0, {}, {}});
    return Step::Continue;
}

// Where the signal came counts as the position, though braking has carried the axes on: the
// coordinates say so until something moves, and the next move begins its increments there (10.1).
void Interpreter::touched() {
    const AxisValues rests = core_.framed(core_.path.programmed);
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (core_.skip_moved() >> i & 1u) core_.path.programmed[i] = core_.skip_point(i);
    const AxisValues met = core_.framed(core_.path.programmed);
    for (unsigned i = 0; i < core_.view().axis_count; ++i) braked_mm_[i] = rests[i] - met[i];
    moves_at_touch_ = core_.moves();
}

// --- inclined axis

bool Interpreter::g_inclined(const GCode&) {
    std::int64_t state = 0;
    if (has('S') && !whole(*word('S'), state)) return false;
    if (state > 2) return core_.fail(Alarm::FagorValueRange, 'S', "S", static_cast<double>(state));
    if (state == 0) {
        set_inclined(0);
        return true;
    }
    const auto place = [this](int number) {
        return number >= 1 && number <= 9
                   ? place_of(kAxisLetters[static_cast<std::size_t>(number - 1)])
                   : -1;
    };
    inclined_place_ = place(settings_.inclined_axis);
    orthogonal_place_ = place(settings_.orthogonal_axis);
    if (inclined_place_ < 0 || orthogonal_place_ < 0 || inclined_place_ == orthogonal_place_ ||
        settings_.inclined_deg == 0.0)
        return core_.fail(Alarm::FagorInclined, 'G', "FG.ANGAXNA, FG.ORTAXNA, FG.ANGANTR");
    if (core_.reads_ahead()) return core_.fail(Alarm::FagorIncompatible, 'G', "G41 G46");
    set_inclined(static_cast<int>(state));
    return true;
}

// The real axes stand still when the transformation changes: the cartesian point becomes another
// number.
void Interpreter::set_inclined(int state) {
    if ((state != 0) != core_.transformed()) {
        core_.transform_off();
        if (state != 0) {
            Transformation wanted;
            wanted.kinematics.kind = static_cast<std::uint32_t>(KinematicsKind::Inclined);
            wanted.kinematics.axis[0] = static_cast<std::uint8_t>(inclined_place_);
            wanted.kinematics.axis[1] = static_cast<std::uint8_t>(orthogonal_place_);
            wanted.kinematics.centre[0] = settings_.inclined_origin;
            wanted.kinematics.value[0] = settings_.inclined_deg * std::numbers::pi / 180.0;
            (void)core_.transform(wanted);  // g_inclined has seen to it that it can
        }
    }
    modal_.inclined = state;
}

// While frozen only the inclined axis moves: the point slides along it (13.2).
void Interpreter::slide(AxisValues& target, AxisSet named) const {
    if (modal_.inclined != 2 || !(named >> inclined_place_ & 1u) ||
        (named >> orthogonal_place_ & 1u))
        return;
    const auto x = static_cast<std::size_t>(inclined_place_),
               z = static_cast<std::size_t>(orthogonal_place_);
    AxisValues from = core_.framed(core_.path.programmed), to = core_.framed(target);
    to[z] = from[z] + (to[x] - from[x]) * std::tan(core_.path.transformation.kinematics.value[0]);
    target = core_.unframed(to);
}

// --- what happens at the end of the block

bool Interpreter::element_at_end(bool straight_block) {
    const GCode* row = coded_[static_cast<std::size_t>(GGroup::Element)];
    if (!row) return true;
    const std::string name = "G" + std::to_string(row->number);
    if (!element_word_ || element_word_->value <= 0)
        return core_.fail(Alarm::FagorElementRadius, 'G', name);
    if (row->number == 37 && !straight_block) return core_.fail(Alarm::FagorTangential, 'G', name);
    if (row->number == 39 && !straight_block) return core_.fail(Alarm::FagorTangential, 'G', name);
    static constexpr corners::Shape kShapes[] = {corners::Shape::Rounding, corners::Shape::Entry,
                                                 corners::Shape::Exit, corners::Shape::ChamferLeg};
    corners::Call call;
    call.shape = kShapes[row->number - 36];
    // what is only read stays as it is programmed
    call.size = element_word_->value * unit() * (reads_profile_ || scanning_ ? 1.0 : modal_.scale);
    call.required = row->number == 37 || row->number == 38;
    call.straight = row->number == 39;
    call.letter = 'R';
    call.idle_blocks = 48;
    return core_.corner(call);
}

// The direction in which the path left the last block, before mirror and scale.
bool Interpreter::end_direction(double& p, double& q) const {
    p = modal_.direction_p;
    q = modal_.direction_q;
    return p != 0.0 || q != 0.0;
}

void Interpreter::note_direction(double p, double q) {
    const double length = std::hypot(p, q);
    if (length < 1e-9) return;
    modal_.direction_p = p / length;
    modal_.direction_q = q / length;
}

}  // namespace polyturn::channels::fagor
