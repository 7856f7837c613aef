// One block of words: what it codes, whether every word has a taker, and the order in which it
// acts.
#include "channels/fanuc/block.hpp"

#include <optional>
#include <utility>

#include "channels/fanuc/b_axis/b_axis.hpp"
#include "channels/fanuc/cycles/g_drilling.hpp"
#include "channels/fanuc/cycles/g_repetitive.hpp"
#include "channels/fanuc/cycles/pattern_data.hpp"
#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/frames/g_transform.hpp"
#include "channels/fanuc/functions/m_codes.hpp"
#include "channels/fanuc/grammar/check_words.hpp"
#include "channels/fanuc/grammar/classify.hpp"
#include "channels/fanuc/grammar/points.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/macro/calls.hpp"
#include "channels/fanuc/motion/feed.hpp"
#include "channels/fanuc/motion/g_corners.hpp"
#include "channels/fanuc/program/barriers.hpp"
#include "channels/fanuc/program/calls.hpp"
#include "channels/fanuc/program/faults.hpp"
#include "channels/fanuc/spindles/g_couplings.hpp"
#include "channels/fanuc/spindles/speeds.hpp"
#include "channels/fanuc/tools/g_length.hpp"
#include "channels/fanuc/tools/life_groups.hpp"
#include "channels/fanuc/tools/managed_tool.hpp"
#include "channels/fanuc/tools/parameter_input.hpp"
#include "channels/fanuc/tools/tool_words.hpp"
#include "channels/mefi/shifts.hpp"

namespace polyturn::channels::fanuc {
namespace {

bool macro_call_block(Execution& x) {
    const GCode* call = nullptr;
    for (unsigned k = 0; k < x.words.g_count; ++k) {
        const GCode* row = g_row(x, k);
        if (!call && row->is(Trait::MacroCall)) {
            call = row;
            continue;
        }
        const Word& word = x.block.words[x.words.g[k]];
        blame(x, word);
        return x.core.fail(Alarm::MacroArgument, 'G', std::string(text_of(x, word)));
    }
    if (call->group == GGroup::MacroModal) x.modal.in_force(call->group) = call;
    return call->act(x, *call);
}

// Settings, in the order of GGroup.
bool settings_act(Execution& x) {
    constexpr std::uint32_t kLate = bit_of(GGroup::OneShot) | bit_of(GGroup::Motion) |
                                    bit_of(GGroup::MacroModal) | bit_of(GGroup::Surface);
    for (std::uint32_t left = x.words.groups & ~kLate; left; left &= left - 1) {
        const GCode* row = x.words.coded[static_cast<std::size_t>(__builtin_ctz(left))];
        if (!row->act) return x.core.fail(Alarm::NotBuilt, 'G', std::string(row->name));
        if (!row->act(x, *row)) return false;
        x.modal.in_force(row->group) = row;
    }
    return !length_word(x) || g_length(x, *x.modal.in_force(GGroup::Length));
}

// The motion code of the block holds from here on; what the simple cycles keep ends with them.
void motion_code_holds(Execution& x, const GCode* one_shot) {
    SimpleCycleWords& simple = x.modal.cycles.simple;
    if (one_shot && one_shot->tenths != 40) {
        simple.set = 0;
        simple.taper = 0.0;
    }
    if (!x.words.has(GGroup::Motion)) return;
    const GCode* next = x.words.row(GGroup::Motion);
    if (!next->is(Trait::SimpleCycle)) {
        simple.set = 0;
        simple.taper = 0.0;
    }
    x.modal.in_force(GGroup::Motion) = x.modal.motion = next;
    x.modal.drilling = nullptr;
}

// S, T and the M codes that begin something.
bool functions_act(Execution& x) {
    constexpr std::uint32_t kFunctions = letter_set("STMBACUVWDEH");
    if (!(x.block.letters & kFunctions & ~x.vocabulary.axis_letters) && !x.words.spindles)
        return !x.words.has(GGroup::Surface) || x.core.commit_spindle();
    if (x.block.has('S') && !spindle_word(x)) return false;
    if (x.words.spindles && !named_spindles(x)) return false;
    if (x.block.has('T') && !gear_block(x) && !tool_word(x)) return false;
    return functions_before_motion(x);
}

// The one-shot code, the drilling cycle or the motion of the block.
bool motion_acts(Execution& x, const GCode* one_shot) {
    if (one_shot) {
        if (!one_shot->act) return x.core.fail(Alarm::NotBuilt, 'G', std::string(one_shot->name));
        return one_shot->act(x, *one_shot);
    }
    if (x.modal.drilling) return !(x.words.axis_count || x.block.has('R')) || run_drilling(x);
    if (x.words.used) return true;  // G51 X Z P names a point, and nothing moves
    const bool moves =
        x.words.axis_count || x.words.has(GGroup::Motion) ||
        (angle_word(x) && x.modal.motion->tenths == 10 && x.settings.policy.motion.angle_lines) ||
        x.block.has('I') || x.block.has('J') || x.block.has('K') || x.block.has('R');
    if (!moves) return true;
    if (!x.modal.motion->act)
        return x.core.fail(Alarm::NotBuilt, 'G', std::string(x.modal.motion->name));
    // F is the speed in the plane of millimetres and degrees
    x.core.path.feed_path.degree_mm =
        x.settings.policy.motion.rotary_feed ? x.modal.input.unit : 0.0;
    return x.modal.motion->act(x, *x.modal.motion);
}

bool act_on_words(Execution& x) {
    if (x.modal.parameter_input && !x.words.has(GGroup::OneShot)) return g10_parameter_block(x);
    if (x.modal.life.mode && !x.words.has(GGroup::OneShot)) return life_group_block(x);
    x.words.used = false;
    x.corners.of_block = {};
    if (!settings_act(x)) return false;
    const GCode* one_shot = x.words.has(GGroup::OneShot) ? x.words.row(GGroup::OneShot) : nullptr;
    motion_code_holds(x, one_shot);
    if (x.block.has('F') && !set_feed(x, x.block.word('F'))) return false;
    if (!lead_in_range(x)) return false;
    for (unsigned k = 0; k < x.words.comma_count; ++k)
        if (!corner_word(x, x.block.words[x.words.commas[k]])) return false;
    // refused
    if (x.words.comma_angle >= 0 && (x.modal.motion->tenths != 10 || one_shot || x.modal.drilling))
        return corner_word(x, x.block.words[static_cast<std::size_t>(x.words.comma_angle)]);
    if (x.words.has(GGroup::Surface)) {
        const GCode* row = x.words.row(GGroup::Surface);
        if (!row->act(x, *row)) return false;
        x.modal.in_force(GGroup::Surface) = row;
    }
    if (!functions_act(x)) return false;
    if (x.words.has(GGroup::MacroModal)) {
        const GCode* row = x.words.row(GGroup::MacroModal);
        if (!row->act) return x.core.fail(Alarm::NotBuilt, 'G', std::string(row->name));
        x.modal.in_force(GGroup::MacroModal) = row;
        return row->act(x, *row);
    }
    return motion_acts(x, one_shot) && (!x.words.m_count || functions_behind_motion(x));
}

// What a block of words has come to so far.
struct Course {
    std::uint64_t ways_before = 0;
    bool calls = false;          // its words were used up by a call, or are the B axis'
    bool called_behind = false;  // by G66.1, when the block has acted
    bool single_b = false;       // G110
};

bool says_something(const Execution& x) { return (x.block.letters & ~letter_set("NO")) != 0; }

// Codes and letters that call programs, and G66.1.
bool calls_first(Execution& x, Course& course) {
    const Settings& s = x.settings;
    if (!s.g_calls.empty() || !s.m_calls.empty() || !s.letter_calls.empty() || s.t_calls)
        if (!x.modal.life.mode && !code_calls(x, course.calls)) return false;
    if (course.calls || !gives_arguments(x)) return true;
    if (const Word* const stop = stops_or_waits(x))
        return stands_alone(x, *stop) && (course.called_behind = true);
    return per_block_call(x) && (course.calls = true);
}

// G110 and the blocks from G101 to G100. `registered`: nothing of the block acts.
bool b_axis_first(Execution& x, Course& course, bool& registered) {
    x.b_axis.single_now = false;
    x.b_axis.ways = 0;
    // all words of such a block are the B axis'
    if (x.block.has('G') && !course.calls && !x.b_axis.registering &&
        x.settings.policy.program.b_axis)
        for (std::size_t k = 0; k < x.block.count; ++k)
            if (const Word& word = x.block.words[k];
                word.axis < 0 && word.address == 'G' && word.value == 110) {
                if (!classify(x) || !g_b_single(x, *x.vocabulary.table.find(1100))) return false;
                course.calls = true;
            }
    if (x.b_axis.registering && !course.calls) {
        const bool ends =
            x.block.has('G') && x.block.value('G') >= 100 && x.block.value('G') <= 103;
        if (!ends && says_something(x)) {
            registered = true;
            return classify(x) && b_record(x);
        }
    }
    course.single_b = x.b_axis.single_now;
    return true;
}

// The block is read again behind a barrier.
Step read_again(Execution& x) {
    x.run.reread = true;
    x.text.line_left = false;
    live_value_barrier(x);
    return Step::AtBarrier;
}

// What must be executed before the words of the block act: then the block is read again.
std::optional<Step> barrier_before(Execution& x) {
    if (!x.run.fresh && x.block.has('G')) {
        if (!classify(x)) return report(x, x.core.fault());
        // the axes rest first (architecture 5.8)
        if (switches_transformation(x) && !x.core.reads_ahead()) return read_again(x);
    }
    if (x.block.has('T') && !x.modal.life.mode && x.run.tool_serial != x.core.at.serial &&
        waits_for_tool(x)) {
        // what is held for its corner ends first
        if (x.core.reads_ahead() && !x.run.fresh) return read_again(x);
        if (!classify(x) || !call_managed_tool(x)) return report(x, x.core.fault());
        x.run.tool_serial = x.core.at.serial;
        x.run.reread = true;
        x.text.line_left = false;
        return Step::AtBarrier;
    }
    if (!x.run.fresh && names_managed_offset(x) && !x.core.reads_ahead()) return read_again(x);
    if (x.macro.dialogue.open && ends_program(x)) {
        bool done = false;
        if (!pattern_dialogue(x, done)) return report(x, x.core.fault());
        if (!done) return x.macro.dialogue.asked ? Step::AtBarrier : Step::Continue;
    }
    return std::nullopt;
}

bool words_act(Execution& x) {
    if (!classify(x) || !transformation_allows(x)) return false;
    if (is_macro_call(x)) return macro_call_block(x);
    if (!check_words(x)) return false;
    judge_points(x);
    return act_on_words(x);
}

// Calls by codes of the block and M97 P, which wait until the block has acted.
bool calls_behind(Execution& x) {
    PendingCall& call = x.words.call;
    const auto refused = [&] {
        x.words.culprit.column = call.column;
        x.words.culprit.length = call.length;
        return false;
    };
    if (const std::int64_t program = call.program; program >= 0) {
        call.program = -1;
        x.run.called = true;
        if (!x.run.ended && !call_program(x, program, call.repeats, nullptr, true, false, 0))
            return refused();
    }
    return call.local < 0 || call_part(x, std::exchange(call.local, -1)) || refused();
}

// The block is the last one that G70 drives.
bool ends_contour(const Execution& x) {
    const Finishing& finishing = x.modal.cycles.finishing;
    return finishing.active && !x.run.ended && !x.run.called &&
           x.calls.frames.size() == finishing.depth && x.core.at.block == finishing.last;
}

// Compensation reads on, or the block is told to the machine as ended.
bool block_ends(Execution& x, const Course& course) {
    if (x.core.reads_ahead()) {
        // calls belong to no path
        const bool counts =
            !x.run.called && (!course.calls || course.single_b) && says_something(x);
        if (!x.core.end_compensated_block(counts, x.run.wants_barrier, x.run.ended) ||
            x.core.transformation_failed())
            return false;
    }
    if (x.run.tool_serial == x.core.at.serial)
        x.core.mark_emitted();  // its T came before the barrier
    if (x.core.emitted()) {
        x.run.fresh = false;
        x.core.end_block();
    }
    return true;
}

// G66 behind a block that moves, G66.1 behind one that stops or waits.
bool modal_call_behind(Execution& x, const Course& course) {
    if (course.called_behind) {
        if (!per_block_call(x)) return false;
    } else if (!x.run.ended && !x.run.called && !x.calls.modal.empty()) {
        const ModalCall& modal = x.calls.modal.back();
        if (!modal.every_block && x.core.ways() - x.b_axis.ways != course.ways_before) {
            const LocalSet arguments = modal.arguments;
            if (!call_program(x, modal.program, modal.repeats, &arguments, false, true, 'P'))
                return false;
        }
    }
    if (!x.calls.modal.empty()) x.calls.modal.back().armed = true;
    return true;
}

}  // namespace

Step nc_block(Execution& x) {
    x.run.jumped = x.run.called = x.run.wants_barrier = false;
    x.core.did();
    Course course;
    course.ways_before = x.core.ways();
    bool registered = false;
    if (!calls_first(x, course) || !b_axis_first(x, course, registered))
        return report(x, x.core.fault());
    if (registered) return Step::Continue;
    if (!course.calls) {
        if (const std::optional<Step> step = barrier_before(x)) return *step;
        if (!words_act(x)) return report(x, x.core.fault());
    }
    x.b_axis.single_before = x.b_axis.single_now;
    if (x.core.transformation_failed()) return report(x, x.core.fault());
    if (x.way_back.interruption.running && says_something(x))
        x.way_back.interruption.shows_end = false;
    if (!calls_behind(x)) return report(x, x.core.fault());
    if (ends_contour(x) && !end_finishing(x)) return report(x, x.core.fault());
    end_one_block_shift(x);
    if (!block_ends(x, course) || !modal_call_behind(x, course)) return report(x, x.core.fault());
    // a barrier ahead may be held back
    if (x.core.reads_ahead())
        return x.core.halted() ? Step::AtBarrier : x.run.ended ? Step::Ended : Step::Continue;
    if (x.run.ended) return Step::Ended;
    return x.run.wants_barrier ? Step::AtBarrier : Step::Continue;
}

}  // namespace polyturn::channels::fanuc
