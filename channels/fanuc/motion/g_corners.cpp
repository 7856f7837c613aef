// Chamfer and corner R at the end of a line, and lines by their angle: ,C ,R, the lathe's I K C R,
// A.
//
//   G1 Z-20. I5.      Z, then a chamfer of 5 towards +X; the next block goes on in X
//   G1 X40. Z-20. ,R2.   any two elements
//   G1 X40. A135.     (or ,A135.) the angle from the +Z axis gives the missing coordinate
#include "channels/fanuc/motion/g_corners.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/program/faults.hpp"

namespace polyturn::channels::fanuc {
namespace {

// fanuc_lathe 3.16: not where compensation begins, ends or changes its side.
bool corner_allowed(Execution& x, char letter) {
    x.corners.letters[x.corners.count % x.corners.lines.size()] = letter;
    x.corners.lines[x.corners.count++ % x.corners.lines.size()] = x.core.at.line;
    if (!x.core.compensating()) return true;
    const bool switches = x.words.has(GGroup::Comp);
    if (switches || x.core.moves() == x.corners.comp_moves)
        return x.core.fail(Alarm::CompCornerElement, letter);
    return true;
}

// An inner chamfer or corner R must be as large as the nose is (fanuc_lathe 3.16); the next line
// says whether it is an inner one.
void note_corner(Execution& x, double size, bool rounding, char letter) {
    int p = -1, q = -1;
    x.core.plane_axes(p, q);
    const AxisValues& here = x.core.path.programmed;
    const bool counts =
        x.core.compensating() && x.core.at.comp != CompSide::Off && p >= 0 && q >= 0;
    x.corners.before = {
        counts,
        rounding,
        letter,
        size,
        counts ? std::array{here[static_cast<std::size_t>(p)], here[static_cast<std::size_t>(q)]}
               : std::array<double, 2>{},
        x.core.at};
}

// With compensation both lines at a chamfer or corner R run along an axis, to a degree (fanuc_lathe
// 3.16).
bool is_at_right_angles(Execution& x, const CornerBefore& before, const AxisValues& target) {
    if (!x.settings.policy.motion.corners_at_right_angles) return true;
    static const double kDegree = std::tan(std::numbers::pi / 180.0) + 1e-9;
    int p = -1, q = -1;
    x.core.plane_axes(p, q);
    const auto i = static_cast<std::size_t>(p), k = static_cast<std::size_t>(q);
    const AxisValues& corner = x.core.path.programmed;
    const double along = std::fabs(corner[i] - before.from[0]),
                 across = std::fabs(corner[k] - before.from[1]);
    if (std::fmin(along, across) > kDegree * std::fmax(along, across)) {
        (void)x.core.fail(Alarm::CornerTaper);
        Fault fault = x.core.fault();
        fault.block = before.at;
        fault.letter = before.letter;
        x.core.set_fault(std::move(fault));
        return false;
    }
    if (x.modal.motion->tenths > 10) return true;  // an arc: compensation sees it
    const double next_along = std::fabs(target[i] - corner[i]),
                 next_across = std::fabs(target[k] - corner[k]);
    const bool first_along = along > across;
    return (first_along ? next_along <= kDegree * next_across
                        : next_across <= kDegree * next_along) ||
           x.core.fail(Alarm::CornerNotLine, 'G');
}

bool corner_has_room(Execution& x, const AxisValues& target) {
    // ,C is read before its own line is driven
    if (x.corners.before.at.serial == x.core.at.serial) return true;
    const CornerBefore before = std::exchange(x.corners.before, {});
    const ToolState& tool = x.core.path.tool;
    if (before.pending && !is_at_right_angles(x, before, target)) return false;
    if (!before.pending || (tool.geometry == 0 && tool.wear == 0) ||
        before.size >= std::fabs(tool.nose_radius) - 1e-9)
        return true;
    // an arc follows: its end does not tell to which side it begins; compensation sees it
    if (before.rounding && x.modal.motion->tenths > 10) return true;
    int p = -1, q = -1;
    x.core.plane_axes(p, q);
    const auto i = static_cast<std::size_t>(p), k = static_cast<std::size_t>(q);
    const AxisValues& corner = x.core.path.programmed;
    const double turn = (corner[i] - before.from[0]) * (target[k] - corner[k]) -
                        (corner[k] - before.from[1]) * (target[i] - corner[i]);
    const bool right = (x.core.at.comp == CompSide::Right) == (tool.nose_radius >= 0);
    if (right ? turn >= 0 : turn <= 0) return true;  // an outer one
    (void)x.core.fail(Alarm::CompCornerElement);
    Fault fault = x.core.fault();
    fault.block = before.at;
    fault.letter = before.letter;
    x.core.set_fault(std::move(fault));
    return false;
}

}  // namespace

bool corner_word(Execution& x, const Word& word) {
    const bool chamfer = word.address == 'c';
    const bool line = x.modal.motion->tenths <= 10;
    blame(x, word);
    if (!(chamfer || word.address == 'r') || x.words.has(GGroup::OneShot) ||
        x.modal.motion->tenths == 0 || (!line && x.modal.motion->tenths > 30) || x.modal.drilling)
        return x.core.fail(Alarm::AddressIllegal, 0,
                           std::string(",") + static_cast<char>(word.address - 32));
    const double size = std::fabs(length_of(x, word, -1));
    if (!corner_allowed(x, 0)) return false;
    x.words.culprit.column = x.words.culprit.length = 0;
    if (size == 0) return true;
    if (x.corners.of_block.size > 0) {  // a line has one element at its end
        blame(x, word);
        return x.core.fail(Alarm::CornerWords, 0, std::string(text_of(x, word)));
    }
    corners::Call call;
    call.shape = chamfer ? corners::Shape::ChamferLeg : corners::Shape::Rounding;
    call.size = size;
    call.required = true;
    if (line) note_corner(x, size, !chamfer, 0);
    x.corners.of_block = call;
    return x.core.corner(call);
}

// I, K, C, R of a line along one axis of the plane.
bool lathe_corner(Execution& x, AxisSet named) {
    const bool c_free =
        x.vocabulary.absolute_axis['C' - 'A'] < 0 && x.vocabulary.incremental_axis['C' - 'A'] < 0;
    char letter = 0;
    // I and K beside G40 say how the contour would go on, or nothing (fanuc_lathe 2.7).
    const bool wish = x.words.has(GGroup::Comp) && x.words.row(GGroup::Comp)->is(Trait::CompOff);
    for (const char candidate : {'I', 'K', 'R', 'C'})
        if (x.block.has(candidate) && (candidate != 'C' || c_free) &&
            !(wish && (candidate == 'I' || candidate == 'K'))) {
            if (letter)
                return x.core.fail(Alarm::CornerWords, candidate, std::string(1, candidate));
            letter = candidate;
        }
    if (!letter) return true;
    if (!x.settings.policy.motion.lathe_corners)
        return x.core.fail(Alarm::AddressIllegal, letter, std::string(1, letter));
    const MachineView& view = x.core.view();
    const int z_place = view.axis_by_role(PlaneRole::BasicZ),
              x_place = view.axis_by_role(PlaneRole::BasicX);
    if (z_place < 0 || x_place < 0) return x.core.fail(Alarm::PlaneAxisMissing, 'G');
    const bool along_z = named >> z_place & 1u, along_x = named >> x_place & 1u;
    if (!corner_allowed(x, letter)) return false;
    if (along_z && along_x) return x.core.fail(Alarm::CornerTaper, letter);
    if (!along_z && !along_x) return x.core.fail(Alarm::CornerMoveMissing, letter);
    if ((letter == 'I' && along_x) || (letter == 'K' && along_z))
        return x.core.fail(Alarm::CornerMoveMissing, letter);
    const double size = radius_length_of(x, letter);
    if (size == 0) return true;
    x.modal.corner_then = {true, along_z, size > 0 ? 1 : -1, letter};
    corners::Call call;
    call.shape = letter == 'R' ? corners::Shape::Rounding : corners::Shape::ChamferLeg;
    call.size = std::fabs(size);
    call.letter = letter;
    call.required = true;
    note_corner(x, call.size, letter == 'R', letter);
    return x.core.corner(call);
}

// Behind I K C R the next block must be a line at right angles, towards the side that the sign
// named.
bool follows_corner(Execution& x, const AxisValues& target, bool line) {
    const CornerThen then = x.modal.corner_then;
    x.modal.corner_then = {};
    if (!corner_has_room(x, target)) return false;
    if (!then.pending) return true;
    if (!line) return x.core.fail(Alarm::CornerNotLine, 'G');
    const MachineView& view = x.core.view();
    const auto z_place = static_cast<std::size_t>(view.axis_by_role(PlaneRole::BasicZ)),
               x_place = static_cast<std::size_t>(view.axis_by_role(PlaneRole::BasicX));
    const double along = target[then.along_z ? z_place : x_place] -
                         x.core.path.programmed[then.along_z ? z_place : x_place];
    const double across = target[then.along_z ? x_place : z_place] -
                          x.core.path.programmed[then.along_z ? x_place : z_place];
    if (along == 0 && across == 0) return x.core.fail(Alarm::CornerWithoutNext, 'G');
    if (std::fabs(along) > std::fabs(across) * std::tan(std::numbers::pi / 180.0) ||
        across * then.sign < 0)
        return x.core.fail(Alarm::CornerNotLine, 'G');
    return true;
}

// A where no axis, no spindle and no function has this name, or ,A.
const Word* angle_word(const Execution& x) {
    if (x.words.comma_angle >= 0)
        return &x.block.words[static_cast<std::size_t>(x.words.comma_angle)];
    if (!x.block.has('A') || (x.vocabulary.axis_letters & letter_bit('A'))) return nullptr;
    for (const auto& [name, spindle] : x.settings.spindle_addresses)
        if (name == "A") return nullptr;  // turns the spindle there (N0817)
    for (const char letter : x.settings.aux_letters)
        if (letter == 'A') return nullptr;
    return &x.block.word('A');
}

// An angle and the opposite one are the same line (programs are written both ways): the coordinates
// say which way it is driven. A: with one coordinate the other one; alone (the next block names
// both): where that block's line crosses this one.
bool angle_line(Execution& x, AxisSet named) {
    int p = -1, q = -1;
    x.core.plane_axes(p, q);
    if (p < 0 || q < 0) return x.core.fail(Alarm::PlaneAxisMissing, 'G');
    const auto i = static_cast<std::size_t>(p), k = static_cast<std::size_t>(q);
    const Word& word = *angle_word(x);
    const double degrees = word.has_point || word.from_expression || x.settings.point_means_nothing
                               ? word.value
                               : word.value * 0.001;
    const double a = degrees * std::numbers::pi / 180.0, dp = std::cos(a), dq = std::sin(a);
    const AxisValues& from = x.core.path.programmed;
    const bool has_p = named >> i & 1u, has_q = named >> k & 1u;
    if (x.core.move_reserved() && has_p && has_q) {  // second line: through its end, in its angle
        const double denominator = x.corners.angle.dp * dq - x.corners.angle.dq * dp;
        if (std::fabs(denominator) < 1e-9) return x.core.fail(Alarm::AngleParallel, 'A');
        const double t =
            ((x.words.target[i] - from[i]) * dq - (x.words.target[k] - from[k]) * dp) / denominator;
        if (std::fabs(t) < 1e-9) return x.core.fail(Alarm::AngleParallel, 'A');
        AxisValues corner = from;
        corner[i] = from[i] + t * x.corners.angle.dp;
        corner[k] = from[k] + t * x.corners.angle.dq;
        const BlockContext here = x.core.at;
        bool good = true;
        x.core.insert_reserved([&] {  // each line with the element at its own end
            x.core.at = x.corners.angle.at;
            good = x.core.corner(x.corners.angle.corner) && x.core.linear(corner);
        });
        x.core.at = here;
        return good && (x.corners.of_block.size == 0 || x.core.corner(x.corners.of_block));
    }
    if (!has_p && !has_q) {
        if (x.core.move_reserved()) return x.core.fail(Alarm::AngleParallel, 'A');
        x.corners.angle.dp = dp;
        x.corners.angle.dq = dq;
        x.corners.angle.at = x.core.at;
        x.corners.angle.corner = x.corners.of_block;
        return x.core.reserve_move(Alarm::AngleParallel);
    }
    if (has_p && has_q) return x.core.fail(Alarm::CornerWords, 'A', "A");
    const double component = has_p ? dp : dq;
    const double way = has_p ? x.words.target[i] - from[i] : x.words.target[k] - from[k];
    if (std::fabs(component) < 1e-9) return x.core.fail(Alarm::AngleParallel, 'A');
    (has_p ? x.words.target[k] : x.words.target[i]) =
        (has_p ? from[k] + way / component * dq : from[i] + way / component * dp);
    return true;
}

}  // namespace polyturn::channels::fanuc
