// M96, M97: a signal interrupts the program (fanuc_lathe 6.14, nct part 2 18.7).
//
//   N10 ----+- - - -> N20        type I: N10 breaks off. The rest of it is lost if the interrupt program has NC statements,
//           |          ^         and driven after M99 if it has only macro statements.
//           '-> O8300 -'         type II: at the end of N10.
//
// The kernel stops the path, drops what was pushed and reports the first block that is not
// executed. Interpretation goes back there, and the interrupt program is called as if it were
// before that block. While it runs no signal counts; M99 switches the watch on again, in path
// order. Compensation rests meanwhile; behind M99 the path goes straight to the next vector.
#include "channels/fanuc/program/interrupts.hpp"

#include <algorithm>
#include <utility>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/macro/modal_values.hpp"
#include "channels/fanuc/program/reading.hpp"
#include "channels/fanuc/program/resume.hpp"
#include "channels/fanuc/program/search.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fanuc {
namespace {

void arm_interrupts(Execution& x, bool on) {
    x.core.mark_emitted();
    x.core.sink().interrupts({on, x.settings.interrupt.at_block_end, x.settings.interrupt.by_level,
                              x.settings.policy.program.interrupted_by_mint},
                             x.core.at);
}

// Are there blocks of words in it? Calls count: what they do cannot be seen from here.
bool interrupt_program_has_statements(Execution& x, std::int64_t program) {
    const auto file = x.files.find_number(program);
    const FileId id = file ? *file : x.calls.frames.front().file;
    const auto begin = find_program_in(x, id, program);
    LineSource& source = x.files.source(id);
    const TextPosition back = source.next_position();
    source.seek(begin.value_or(TextPosition{}));
    std::string_view line;
    bool found = false;
    for (int lines = 0; !found && lines < 10'000 && source.next(line) == LineSource::Status::Line;
         ++lines) {
        std::size_t i = 0;
        const auto blanks = [&] {
            while (i < line.size() && (line[i] == ' ' || line[i] == '\t')) ++i;
        };
        for (blanks(); i < line.size() &&
                       (line[i] == 'N' || line[i] == 'O' || line[i] == 'n' || line[i] == 'o');
             blanks()) {
            ++i;
            blanks();
            while (i < line.size() && line[i] >= '0' && line[i] <= '9') ++i;
        }
        if (i >= line.size() || line[i] == '(' || line[i] == ';' || line[i] == '%' ||
            line[i] == '#' || line[i] == '[')
            continue;
        const std::string_view rest = line.substr(i);
        if (rest.starts_with("M99") || rest.starts_with("m99")) break;
        static constexpr std::string_view kMacro[] = {"IF",    "WHILE", "GOTO",  "DO",    "END",
                                                      "POPEN", "PCLOS", "DPRNT", "BPRNT", "SETVN"};
        found = std::none_of(std::begin(kMacro), std::end(kMacro),
                             [&](std::string_view word) { return rest.starts_with(word); });
    }
    source.seek(back);
    return found;
}

void restore_interrupted_position(Execution& x) {
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (const auto now = x.core.port().axis_taken_over(x.core.view().axes[i].machine_axis))
            x.core.take_machine(i, *now);
}

}  // namespace

bool interrupt_code(Execution& x, const Word& word) {
    const bool on = word.value == x.settings.interrupt.on;
    if (on) {
        if (!x.block.has('P')) return x.core.fail(Alarm::SubprogramWordMissing, 'M');
        std::int64_t program = 0;
        if (!whole_number(x, 'P', program)) return false;
        if (!x.files.find_number(program) &&
            !find_program_in(x, x.calls.frames.back().file, program))
            return x.core.fail(Alarm::SubprogramMissing, 'P', "O" + std::to_string(program));
        x.modal.interrupting = {true, program};
        if (!x.run.keeps_states) keep_resume_states(x, true);
    } else {
        x.modal.interrupting.on = false;
        if (x.block.has('P')) {
            if (!whole_number(x, 'P', x.words.call.local)) return false;
            x.words.call.column = x.block.word('P').column;
            x.words.call.length = x.block.word('P').length;
        }
    }
    if (!x.way_back.interruption.running) arm_interrupts(x, on);
    return true;
}

bool interrupt_program(Execution& x, std::uint64_t serial, bool within) {
    // What held in that block, and not what was read since then.
    Interrupting watch = x.modal.interrupting;
    if (const auto* point = x.way_back.points.find(serial))
        watch = point->state->modal.interrupting;
    if (!watch.on) return false;
    x.way_back.interruption = {};
    const bool goes_on_behind = within && interrupt_program_has_statements(x, watch.program);
    x.way_back.interruption.again = within && !goes_on_behind;
    const auto* point = x.way_back.points.find(serial + 1);
    const bool read_on = within && point;
    if (read_on)
        x.way_back.interruption.end = point->programmed;
    else
        x.way_back.interruption.end = x.core.path.programmed;
    const std::uint64_t target = goes_on_behind ? (read_on ? serial + 1 : 0) : serial;
    const bool compensating = x.core.compensating();
    if (target && !go_back_to(x, target, true)) return false;
    // nothing that was held back is driven
    if (compensating || x.core.reads_ahead()) x.core.compensation_reset();
    GCode const*& comp = x.modal.in_force(GGroup::Comp);
    if (comp && comp->is(Trait::CompOn))
        x.way_back.interruption.side = comp->tenths == 410 ? CompSide::Left : CompSide::Right;
    x.run.ended = false;
    x.modal.interrupting = watch;
    // of a tap that is broken off nothing else would end it
    if (within && x.modal.drilling) x.core.taps(false);
    if (!within) x.way_back.interruption.end = x.core.path.programmed;
    x.way_back.interruption.begin = x.core.path.programmed;
    if (!x.reading.only_macros) restore_interrupted_position(x);
    for (std::size_t k = 0; k < x.way_back.interruption.modal_variables.size(); ++k) {
        double value = 0.0;
        x.way_back.interruption.modal_variables[k] =
            modal_variable(x, 4001 + static_cast<std::int64_t>(k), value) ? value : kNull;
    }
    x.way_back.interrupted = std::make_shared<ResumeState>();
    x.way_back.interrupted->path = x.core.path;  // its feed, plane and zero hold again behind it
    x.way_back.interrupted->modal = x.modal;
    x.way_back.interrupted->modal_calls = x.calls.modal;
    x.way_back.interruption.running = x.way_back.interruption.shows_end = true;
    comp = x.vocabulary.table.find(400);  // the interrupt program drives what it says
    x.calls.modal.clear();

    CallLevel frame;
    frame.interrupt = true;
    if (const auto file = x.files.find_number(x.modal.interrupting.program))
        frame.file = *file;
    else
        frame.file = x.calls.frames.front().file;
    if (const auto begin = find_program_in(x, frame.file, x.modal.interrupting.program))
        frame.begin = *begin;
    frame.resume = place_behind(x, x.text.column);
    frame.macro = x.settings.interrupt.own_locals;
    frame.loops = x.calls.loops.size();
    frame.outer_program = x.modal.program.number;
    frame.program = x.modal.interrupting.program;
    if (frame.macro) x.macro.variables.push_locals(empty_locals());
    x.text.source = &x.files.source(frame.file);
    x.text.source->seek(frame.begin);
    x.calls.frames.push_back(std::move(frame));
    x.modal.program.blocks_begun = x.text.line_left = x.run.reread = false;
    x.run.tool_serial = x.macro.written.serial = 0;
    x.run.fresh = x.run.state_changed = true;
    x.awaited.measuring = {};
    return true;
}

// Type II: the macro statements at the beginning of the interrupt program act while the block is
// still driven, what follows the first other one behind it. What they read is of the tick at which
// the signal was seen.
bool interrupt_ahead(Execution& x, std::uint64_t serial) {
    // a loop that waits for something waits at the end of the block
    constexpr int kMostStatements = 10'000;
    if (!x.settings.policy.program.interrupts_ahead || x.core.reads_ahead() ||
        !x.way_back.points.may_go_back(x.core, serial))
        return false;
    x.reading.only_macros = true;
    if (!interrupt_program(x, serial, false)) return x.reading.only_macros = false;
    for (int n = 0; n < kMostStatements && x.reading.only_macros; ++n) {
        x.run.fresh = true;
        if (read_block(x) == Step::Failed) x.reading.only_macros = false;
    }
    x.reading.only_macros = false;
    return true;
}

void interrupt_arrived(Execution& x) {
    restore_interrupted_position(x);
    x.core.refresh_limits();
    x.run.fresh = true;
}

// M99 restores what held before; M99 P leaves what the interrupt program has set.
bool return_from_interrupt(Execution& x, bool has_target, std::int64_t target) {
    const CallLevel done = std::move(x.calls.frames.back());
    x.calls.frames.pop_back();
    x.calls.loops.resize(done.loops);
    if (done.macro) x.macro.variables.pop_locals();
    x.modal.program.number = done.outer_program;
    x.text.source = &x.files.source(x.calls.frames.back().file);
    go_on_at(x, done.resume);
    x.modal.program.blocks_begun = x.run.state_changed = true;
    x.way_back.interruption.running = false;
    if (!has_target) {
        const ResumeState& before = *x.way_back.interrupted;
        const double parts = x.modal.parts;
        const Interrupting watch = x.modal.interrupting;
        const std::uint32_t control = control_bits(x);
        x.modal = before.modal;
        // the machine has what the interrupt program has put off
        if (control_bits(x) != control) tell_control(x);
        x.modal.parts = parts;
        x.modal.interrupting = watch;
        x.calls.modal = before.modal_calls;
        PathState& path = x.core.path;
        path.feed_mode = before.path.feed_mode;
        path.feed = before.path.feed;
        path.plane = before.path.plane;
        path.exact_stop_mode = before.path.exact_stop_mode;
        path.override_locked = before.path.override_locked;
        path.exact_stop_off = before.path.exact_stop_off;
        if (path.zero_row != before.path.zero_row) x.core.select_zero(before.path.zero_row);
        x.way_back.interruption.goes_on = x.way_back.interruption.again;
        // the block is read again: increments count from its start
        if (x.way_back.interruption.again) path.programmed = x.way_back.interruption.begin;
        // From where the tool is now straight to the vector at the end of the next block.
        if (x.way_back.interruption.side != CompSide::Off &&
            x.core.compensation(x.way_back.interruption.side))
            x.core.compensation_resumes();
    }
    if (x.modal.interrupting.on) arm_interrupts(x, true);
    return has_target ? jump_to_block(x, target) : true;
}

}  // namespace polyturn::channels::fanuc
