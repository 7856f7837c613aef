// Handlers of moves: G0 to G3, threads, G53, reference.
#include "channels/fanuc/motion/g_motion.hpp"

#include <cmath>
#include <limits>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/motion/g_corners.hpp"
#include "channels/fanuc/motion/targets.hpp"

namespace polyturn::channels::fanuc {

bool g_rapid(Execution& x, const GCode&) {
    if (!x.words.axis_count) return true;
    return read_axis_words(x, x.words.target) && follows_corner(x, x.words.target, false) &&
           x.core.rapid(x.words.target);
}

bool g_linear(Execution& x, const GCode&) {
    const bool angle = angle_word(x) != nullptr;
    if (angle && !x.settings.policy.motion.angle_lines)
        return x.core.fail(Alarm::AddressIllegal, 'A', "A");
    if (!x.words.axis_count && !angle) {
        // I and K beside G40 only say how the contour would go on (fanuc_lathe 2.7).
        const bool leaves =
            x.words.has(GGroup::Comp) && x.words.row(GGroup::Comp)->is(Trait::CompOff);
        for (const char letter : {'I', 'K', 'R'})
            if (x.block.has(letter) && !(leaves && letter != 'R'))
                return x.core.fail(Alarm::CornerMoveMissing, letter);
        return true;
    }
    AxisSet named = 0;
    if (!read_axis_words(x, x.words.target, &named)) return false;
    if (angle && !angle_line(x, named)) return false;
    if (x.core.move_reserved() && angle && !named) {  // its end comes with the next block
        // they stand at right angles to a line along an axis; here ,C and ,R can
        for (const char letter : {'I', 'K', 'R', 'C'})
            if (x.block.has(letter) &&
                !(letter == 'C' && (x.vocabulary.axis_letters & letter_bit('C'))))
                return x.core.fail(Alarm::CornerTaper, letter);
        return true;
    }
    if (x.core.move_reserved()) return x.core.fail(Alarm::AngleParallel, 'G');
    return follows_corner(x, x.words.target, true) && lathe_corner(x, named) &&
           x.core.linear(x.words.target);
}

bool g_arc(Execution& x, const GCode& row) {
    ArcCall call;
    call.clockwise = row.tenths == 20;
    bool goes = false;
    return arc_words(x, call, goes) && (!goes || x.core.arc(x.words.target, call));
}

// Target and centre or radius of an arc; goes: the block names any of them.
bool arc_words(Execution& x, ArcCall& call, bool& goes) {
    const bool centre_words = x.block.has('I') || x.block.has('J') || x.block.has('K');
    goes = x.words.axis_count || centre_words;
    if (!goes) return x.block.has('R') ? x.core.fail(Alarm::ArcWithoutRadius) : true;
    AxisSet named = 0;
    if (!read_axis_words(x, x.words.target, &named) || !follows_corner(x, x.words.target, false))
        return false;
    int p = -1, q = -1;
    x.core.plane_axes(p, q);
    if (p < 0 || q < 0) return x.core.fail(Alarm::PlaneAxisMissing, 'G');
    call.tolerance = x.settings.arc_tolerance;
    if (x.block.has('R')) {
        call.has_radius = true;
        call.radius = radius_length_of(x, 'R');
        return call.radius <= 0 && !x.settings.policy.motion.arc_radius_of_any_sign
                   ? x.core.fail(Alarm::ArcRadiusIllegal, 'R')
                   : true;
    }
    if (!centre_words) return x.core.fail(Alarm::ArcWithoutRadius, 'G');
    // An end beside the arc is no alarm under compensation: the circle about the same centre
    // through it counts there (fanuc_lathe 3.8). A contour of a cycle has no compensation yet.
    const bool compensated = x.core.compensating() && x.core.at.comp != CompSide::Off &&
                             !x.core.path.tool.nose_off && !x.reading.contour;
    if (compensated && x.settings.policy.motion.loose_arcs)
        call.tolerance = std::numeric_limits<double>::infinity();
    // by plane: first, second axis
    static constexpr char kCentre[3][2] = {{'I', 'J'}, {'K', 'I'}, {'J', 'K'}};
    static constexpr char kForeign[3] = {'K', 'J', 'I'};
    const auto plane = static_cast<std::size_t>(x.core.path.plane);
    if (x.block.has(kForeign[plane]))
        return x.core.fail(Alarm::PlaneAxisIllegal, kForeign[plane],
                           std::string(1, kForeign[plane]));
    const auto pi = static_cast<std::size_t>(p), qi = static_cast<std::size_t>(q);
    call.centre_p = radius_length_of(x, kCentre[plane][0]) +
                    (x.settings.centre_absolute ? 0.0 : x.core.path.programmed[pi]);
    call.centre_q = radius_length_of(x, kCentre[plane][1]) +
                    (x.settings.centre_absolute ? 0.0 : x.core.path.programmed[qi]);
    return true;
}

bool g_machine(Execution& x, const GCode&) {
    AxisValues machine = x.core.path.machine;
    AxisSet which = 0;
    for (unsigned k = 0; k < x.words.axis_count; ++k) {
        const Word& word = x.block.words[x.words.axes[k]];
        int place = word.axis >= 0
                        ? word.axis
                        : x.vocabulary.absolute_axis[static_cast<std::size_t>(word.address - 'A')];
        if (place < 0 || !x.modal.input.absolute)
            continue;  // an incremental word is ignored with G53
        const auto i = static_cast<std::size_t>(place);
        machine[i] = length_of(x, word, place) * (x.core.view().axes[i].diameter ? 0.5 : 1.0);
        which |= 1u << i;
    }
    return which ? x.core.machine_rapid(machine, which) : true;
}

// G28, G30, G30.1 (to F1244): rapid to the point of the block, then to the reference position.
bool g_reference(Execution& x, const GCode& row) {
    if (!x.words.axis_count)
        return x.core.fail(Alarm::ReferenceAxisMissing, 'G', std::string(row.name));
    AxisSet named = 0;
    if (!read_axis_words(x, x.words.target, &named)) return false;
    std::size_t position = 0;
    if (row.tenths == 300) {
        std::int64_t p = x.settings.policy.motion.g30_counts_further ? 1 : 2;
        if (x.block.has('P') && !whole_number(x, 'P', p)) return false;
        // Fanuc counts the second to fourth reference position, nct the three further ones.
        const std::int64_t index = x.settings.policy.motion.g30_counts_further ? p : p - 1;
        if (index < 1 || index > 3)
            return x.core.fail(Alarm::OffsetValueIllegal, 'P', {}, static_cast<double>(p));
        position = static_cast<std::size_t>(index);
    }
    if (!x.core.rapid(x.words.target)) return false;
    AxisValues machine = x.core.path.machine;
    const bool floating = row.tenths == 301;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i) {
        const ChannelAxis& axis = x.core.view().axes[i];
        if (named >> i & 1u)
            machine[i] =
                floating ? params::get(x.core.view().table(), params::f1244, axis.machine_axis + 1u)
                         : axis.reference_mm[position];
    }
    if (!x.core.reference(machine, named, MoveKind::Reference)) return false;
    // an axis finds its reference point
    x.run.wants_barrier = x.run.wants_barrier || x.core.due_at_barrier();
    return true;
}

bool g_reference_check(Execution& x, const GCode& row) {
    if (!x.words.axis_count)
        return x.core.fail(Alarm::ReferenceAxisMissing, 'G', std::string(row.name));
    AxisSet named = 0;
    if (!read_axis_words(x, x.words.target, &named) || !x.core.rapid(x.words.target)) return false;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if ((named >> i & 1u) &&
            std::fabs(x.core.path.machine[i] - x.core.view().axes[i].reference_mm[0]) > 1e-6)
            return x.core.fail(Alarm::ReferenceNotReached, x.core.view().axes[i].name[0],
                               std::string(x.core.view().axes[i].name));
    return true;
}

}  // namespace polyturn::channels::fanuc
