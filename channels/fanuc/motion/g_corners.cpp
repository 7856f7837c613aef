// Chamfer and corner R at the end of a line, and lines by their angle: ,C ,R, the lathe's I K C R,
// A.
//
//   G1 Z-20. I5.      Z, then a chamfer of 5 towards +X; the next block goes on in X
//   G1 X40. Z-20. ,R2.   any two elements
//   G1 X40. A135.     (or ,A135.) the angle from the +Z axis gives the missing coordinate
#include <cmath>
#include <numbers>
#include <utility>

#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {

// fanuc_lathe 3.16: not where compensation begins, ends or changes its side.
bool Interpreter::corner_allowed(char letter) {
    corner_letters_[corner_count_ % corner_lines_.size()] = letter;
    corner_lines_[corner_count_++ % corner_lines_.size()] = core_.at.line;
    if (!core_.compensating()) return true;
    const bool switches = (coded_groups_ >> static_cast<unsigned>(GGroup::Comp)) & 1u;
    if (switches || core_.moves() == comp_moves_)
        return core_.fail(Alarm::CompCornerElement, letter);
    return true;
}

bool Interpreter::corner_word(const Word& word) {
    const bool chamfer = word.address == 'c';
    const bool line = motion_->tenths <= 10;
    fault_column_ = word.column;
    fault_length_ = word.length;
    if (!(chamfer || word.address == 'r') ||
        (coded_groups_ >> static_cast<unsigned>(GGroup::OneShot) & 1u) || motion_->tenths == 0 ||
        (!line && motion_->tenths > 30) || drilling_)
        return core_.fail(Alarm::AddressIllegal, 0,
                          std::string(",") + static_cast<char>(word.address - 32));
    const double size = std::fabs(length(word, -1));
    if (!corner_allowed(0)) return false;
    fault_column_ = fault_length_ = 0;
    if (size == 0) return true;
    if (block_corner_.size > 0) {  // a line has one element at its end
        fault_column_ = word.column;
        fault_length_ = word.length;
        return core_.fail(Alarm::CornerWords, 0, std::string(text_of(word)));
    }
    corners::Call call;
    call.shape = chamfer ? corners::Shape::ChamferLeg : corners::Shape::Rounding;
    call.size = size;
    call.required = true;
    if (line) note_corner(size, !chamfer, 0);
    block_corner_ = call;
    return core_.corner(call);
}

// An inner chamfer or corner R must be as large as the nose is (fanuc_lathe 3.16); the next line
// says whether it is an inner one.
void Interpreter::note_corner(double size, bool rounding, char letter) {
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    const AxisValues& here = core_.path.programmed;
    const bool counts = core_.compensating() && core_.at.comp != CompSide::Off && p >= 0 && q >= 0;
    corner_before_ = {
        counts,
        rounding,
        letter,
        size,
        counts ? std::array{here[static_cast<std::size_t>(p)], here[static_cast<std::size_t>(q)]}
               : std::array<double, 2>{},
        core_.at};
}

// With compensation both lines at a chamfer or corner R run along an axis, to a degree (fanuc_lathe
// 3.16).
bool Interpreter::is_at_right_angles(const CornerBefore& before, const AxisValues& target) {
    if (settings_.nct || settings_.mefi) return true;
    static const double kDegree = std::tan(std::numbers::pi / 180.0) + 1e-9;
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    const auto i = static_cast<std::size_t>(p), k = static_cast<std::size_t>(q);
    const AxisValues& corner = core_.path.programmed;
    const double along = std::fabs(corner[i] - before.from[0]),
                 across = std::fabs(corner[k] - before.from[1]);
    if (std::fmin(along, across) > kDegree * std::fmax(along, across)) {
        (void)core_.fail(Alarm::CornerTaper);
        Fault fault = core_.fault();
        fault.block = before.at;
        fault.letter = before.letter;
        core_.set_fault(std::move(fault));
        return false;
    }
    if (motion_->tenths > 10) return true;  // an arc: compensation sees it
    const double next_along = std::fabs(target[i] - corner[i]),
                 next_across = std::fabs(target[k] - corner[k]);
    const bool first_along = along > across;
    return (first_along ? next_along <= kDegree * next_across
                        : next_across <= kDegree * next_along) ||
           core_.fail(Alarm::CornerNotLine, 'G');
}

bool Interpreter::corner_has_room(const AxisValues& target) {
    // ,C is read before its own line is driven
    if (corner_before_.at.serial == core_.at.serial) return true;
    const CornerBefore before = std::exchange(corner_before_, {});
    const ToolState& tool = core_.path.tool;
    if (before.pending && !is_at_right_angles(before, target)) return false;
    if (!before.pending || (tool.geometry == 0 && tool.wear == 0) ||
        before.size >= std::fabs(tool.nose_radius) - 1e-9)
        return true;
    // an arc follows: its end does not tell to which side it begins; compensation sees it
    if (before.rounding && motion_->tenths > 10) return true;
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    const auto i = static_cast<std::size_t>(p), k = static_cast<std::size_t>(q);
    const AxisValues& corner = core_.path.programmed;
    const double turn = (corner[i] - before.from[0]) * (target[k] - corner[k]) -
                        (corner[k] - before.from[1]) * (target[i] - corner[i]);
    const bool right = (core_.at.comp == CompSide::Right) == (tool.nose_radius >= 0);
    if (right ? turn >= 0 : turn <= 0) return true;  // an outer one
    (void)core_.fail(Alarm::CompCornerElement);
    Fault fault = core_.fault();
    fault.block = before.at;
    fault.letter = before.letter;
    core_.set_fault(std::move(fault));
    return false;
}

// I, K, C, R of a line along one axis of the plane.
bool Interpreter::lathe_corner(AxisSet named) {
    const bool c_free = absolute_axis_['C' - 'A'] < 0 && incremental_axis_['C' - 'A'] < 0;
    char letter = 0;
    // I and K beside G40 say how the contour would go on, or nothing (fanuc_lathe 2.7).
    const bool wish =
        (coded_groups_ >> static_cast<unsigned>(GGroup::Comp) & 1u) &&
        coded_[static_cast<std::size_t>(GGroup::Comp)]->act == &Interpreter::g_comp_off;
    for (const char candidate : {'I', 'K', 'R', 'C'})
        if (block_.has(candidate) && (candidate != 'C' || c_free) &&
            !(wish && (candidate == 'I' || candidate == 'K'))) {
            if (letter) return core_.fail(Alarm::CornerWords, candidate, std::string(1, candidate));
            letter = candidate;
        }
    if (!letter) return true;
    if (settings_.nct || settings_.mefi)
        return core_.fail(Alarm::AddressIllegal, letter, std::string(1, letter));
    const MachineView& view = core_.view();
    const int z = view.axis_by_role(PlaneRole::BasicZ), x = view.axis_by_role(PlaneRole::BasicX);
    if (z < 0 || x < 0) return core_.fail(Alarm::PlaneAxisMissing, 'G');
    const bool along_z = named >> z & 1u, along_x = named >> x & 1u;
    if (!corner_allowed(letter)) return false;
    if (along_z && along_x) return core_.fail(Alarm::CornerTaper, letter);
    if (!along_z && !along_x) return core_.fail(Alarm::CornerMoveMissing, letter);
    if ((letter == 'I' && along_x) || (letter == 'K' && along_z))
        return core_.fail(Alarm::CornerMoveMissing, letter);
    const double size = radius_length(letter);
    if (size == 0) return true;
    corner_then_ = {true, along_z, size > 0 ? 1 : -1, letter};
    corners::Call call;
    call.shape = letter == 'R' ? corners::Shape::Rounding : corners::Shape::ChamferLeg;
    call.size = std::fabs(size);
    call.letter = letter;
    call.required = true;
    note_corner(call.size, letter == 'R', letter);
    return core_.corner(call);
}

// Behind I K C R the next block must be a line at right angles, towards the side that the sign
// named.
bool Interpreter::follows_corner(const AxisValues& target, bool line) {
    const CornerThen then = corner_then_;
    corner_then_ = {};
    if (!corner_has_room(target)) return false;
    if (!then.pending) return true;
    if (!line) return core_.fail(Alarm::CornerNotLine, 'G');
    const MachineView& view = core_.view();
    const auto z = static_cast<std::size_t>(view.axis_by_role(PlaneRole::BasicZ)),
               x = static_cast<std::size_t>(view.axis_by_role(PlaneRole::BasicX));
    const double along = target[then.along_z ? z : x] - core_.path.programmed[then.along_z ? z : x];
    const double across =
        target[then.along_z ? x : z] - core_.path.programmed[then.along_z ? x : z];
    if (along == 0 && across == 0) return core_.fail(Alarm::CornerWithoutNext, 'G');
    if (std::fabs(along) > std::fabs(across) * std::tan(std::numbers::pi / 180.0) ||
        across * then.sign < 0)
        return core_.fail(Alarm::CornerNotLine, 'G');
    return true;
}

// A where no axis, no spindle and no function has this name, or ,A.
const Word* Interpreter::angle_word() const {
    if (comma_angle_ >= 0) return &block_.words[static_cast<std::size_t>(comma_angle_)];
    if (!block_.has('A') || (axis_letters_ & letter_bit('A'))) return nullptr;
    for (const auto& [name, spindle] : settings_.spindle_addresses)
        if (name == "A") return nullptr;  // turns the spindle there (N0817)
    for (const char letter : settings_.aux_letters)
        if (letter == 'A') return nullptr;
    return &block_.word('A');
}

// An angle and the opposite one are the same line (programs are written both ways): the coordinates
// say which way it is driven. A: with one coordinate the other one; alone (the next block names
// both): where that block's line crosses this one.
bool Interpreter::angle_line(AxisSet named) {
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    if (p < 0 || q < 0) return core_.fail(Alarm::PlaneAxisMissing, 'G');
    const auto i = static_cast<std::size_t>(p), k = static_cast<std::size_t>(q);
    const Word& word = *angle_word();
    const double degrees = word.has_point || word.from_expression || settings_.point_means_nothing
                               ? word.value
                               : word.value * 0.001;
    const double a = degrees * std::numbers::pi / 180.0, dp = std::cos(a), dq = std::sin(a);
    const AxisValues& from = core_.path.programmed;
    const bool has_p = named >> i & 1u, has_q = named >> k & 1u;
    if (core_.move_reserved() && has_p && has_q) {  // second line: through its end, in its angle
        const double denominator = angle_dp_ * dq - angle_dq_ * dp;
        if (std::fabs(denominator) < 1e-9) return core_.fail(Alarm::AngleParallel, 'A');
        const double t = ((target_[i] - from[i]) * dq - (target_[k] - from[k]) * dp) / denominator;
        if (std::fabs(t) < 1e-9) return core_.fail(Alarm::AngleParallel, 'A');
        AxisValues corner = from;
        corner[i] = from[i] + t * angle_dp_;
        corner[k] = from[k] + t * angle_dq_;
        const BlockContext here = core_.at;
        bool good = true;
        core_.insert_reserved([&] {  // each line with the element at its own end
            core_.at = angle_at_;
            good = core_.corner(angle_corner_) && core_.linear(corner);
        });
        core_.at = here;
        return good && (block_corner_.size == 0 || core_.corner(block_corner_));
    }
    if (!has_p && !has_q) {
        if (core_.move_reserved()) return core_.fail(Alarm::AngleParallel, 'A');
        angle_dp_ = dp;
        angle_dq_ = dq;
        angle_at_ = core_.at;
        angle_corner_ = block_corner_;
        return core_.reserve_move(Alarm::AngleParallel);
    }
    if (has_p && has_q) return core_.fail(Alarm::CornerWords, 'A', "A");
    const double component = has_p ? dp : dq;
    const double way = has_p ? target_[i] - from[i] : target_[k] - from[k];
    if (std::fabs(component) < 1e-9) return core_.fail(Alarm::AngleParallel, 'A');
    (has_p ? target_[k] : target_[i]) =
        (has_p ? from[k] + way / component * dq : from[i] + way / component * dp);
    return true;
}

}  // namespace polyturn::channels::fanuc
