#include "channels/fanuc/program/reading.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "channels/fanuc/block.hpp"
#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/macro/macro.hpp"
#include "channels/fanuc/motion/measuring.hpp"
#include "channels/fanuc/program/barriers.hpp"
#include "channels/fanuc/program/faults.hpp"
#include "channels/fanuc/program/remote_data.hpp"
#include "channels/fanuc/program/resume.hpp"

namespace polyturn::channels::fanuc {
namespace {

Step end_of_text(Execution& x) {
    x.core.at.line = x.text.source->position().line;
    x.core.at.block = -1;
    x.text.line = {};
    if (x.calls.frames.size() > 1) return report_at(x, Alarm::ProgramNotEnded, 0, 0, "M99");
    if (x.modal.program.tape_begun) return report_at(x, Alarm::ProgramNotEnded, 0, 0, "%");
    x.core.begin_block();
    end_program(x, StopReason::End);
    if (x.core.reads_ahead() && !x.core.compensation_failed()) return report(x, x.core.fault());
    x.core.end_block();
    if (x.core.reads_ahead() && x.core.halted()) return Step::AtBarrier;
    return Step::Ended;
}

// The next line, unless the one in hand holds a further block. Nothing: it is there.
std::optional<Step> next_line(Execution& x) {
    if (x.text.line_left) return std::nullopt;
    switch (x.text.source->next(x.text.line)) {
        case LineSource::Status::Line:
            break;
        case LineSource::Status::End:
            return end_of_text(x);
        case LineSource::Status::TooLong:
            return report_at(x, Alarm::LineTooLong, 0, 0);
        case LineSource::Status::ReadError:
            return report_at(x, Alarm::FileUnreadable, 0, 0, "reading failed");
    }
    x.text.column = 0;
    return std::nullopt;
}

// What the events of the block say of its place.
void name_place(Execution& x) {
    const std::vector<CallLevel>& frames = x.calls.frames;
    BlockContext& at = x.core.at;
    at.file = frames.back().file;
    at.stack_depth = static_cast<std::uint8_t>(frames.size() - 1);
    at.by_code = frames.size() > 1 && std::any_of(frames.begin() + 1, frames.end(),
                                                  [](const CallLevel& f) { return f.by_code; });
    at.line = x.text.source->position().line;
    at.block = -1;
    at.statement = false;
    at.cycle = x.modal.cycles.finishing.active ? x.modal.cycles.finishing.name : std::string_view{};
}

// A %: the beginning of the tape, or its end.
Step tape_mark(Execution& x) {
    RunningProgram& program = x.modal.program;
    const auto column = static_cast<std::uint32_t>(x.scanner.stopped_at() + 1);
    if (!program.blocks_begun && !program.tape_begun && x.block.count == 0) {
        // the rest of the line is the tape's title
        program.tape_begun = x.run.state_changed = true;
        return Step::Continue;
    }
    if (x.block.count != 0) return report_at(x, Alarm::CharacterUnknown, column, 1, "%");
    program.tape_begun = false;
    if (x.settings.needs_end_code && x.calls.frames.size() == 1)
        return report_at(x, Alarm::ProgramEndMissing, column, 1);
    return end_of_text(x);
}

Step scan_fault(Execution& x) {
    if (x.reading.has_pending_fault) return report(x, x.reading.pending_fault);
    const ScanFault& fault = x.scanner.fault();
    return report_at(x, fault.alarm, fault.column, fault.length,
                     fault.letter ? std::string(1, fault.letter) : std::string{});
}

void take_block_number(Execution& x) {
    if (x.block.has('N'))
        x.core.at.block = x.modal.last.n = static_cast<std::int64_t>(x.block.value('N'));
}

Step statement_block(Execution& x) {
    if (!x.settings.policy.macro.statements)
        return report_at(x, Alarm::NotBuilt, static_cast<std::uint32_t>(x.scanner.stopped_at() + 1),
                         1, "macro statements in mefi");
    take_block_number(x);
    x.modal.program.blocks_begun = x.run.state_changed = true;
    return macro_statement(x, x.scanner.stopped_at());
}

// N and O are whole numbers, as GOTO and M98 look for them. Nothing: they are.
std::optional<Step> fault_of_numbers(Execution& x) {
    for (const char letter : {'N', 'O'}) {
        if (!x.block.has(letter)) continue;
        const Word& word = x.block.word(letter);
        if (word.from_expression)  // fanuc_lathe 6.1
            return report_at(x, Alarm::MacroFormat, word.column, word.length,
                             std::string(1, letter) + " takes no variable");
        if (word.value < 0 || word.has_point)
            return report_at(x, word.value < 0 ? Alarm::NegativeSign : Alarm::PointForbidden,
                             word.column, word.length, std::string(1, letter));
    }
    return std::nullopt;
}

// A block of words, or an empty one.
Step word_block(Execution& x) {
    if (const std::optional<Step> fault = fault_of_numbers(x)) return *fault;
    const std::size_t next_column = x.scanner.stopped_at();
    if (x.block.count == 0 && !x.block.name_length) {
        x.text.column = next_column;
        return Step::Continue;
    }
    // it waits for the path, and is read again
    if (x.reading.only_macros && (x.block.letters & ~letter_set("NO"))) {
        x.reading.only_macros = false;
        x.run.reread = true;
        x.text.line_left = false;
        return Step::AtBarrier;
    }
    take_block_number(x);
    if (x.run.keeps_states && !is_plain_move(x)) x.run.state_changed = true;
    if (x.block.has('O')) {
        if (x.modal.program.blocks_begun) {  // the next program of the text begins
            x.modal.program.tape_begun = false;
            return end_of_text(x);
        }
        x.modal.program.number = static_cast<std::int64_t>(x.block.value('O'));
    }
    x.modal.program.blocks_begun = true;
    x.text.behind = next_column;
    const Step step = nc_block(x);
    if (!x.run.jumped && !x.run.reread) x.text.column = next_column;
    return step;
}

}  // namespace

void end_program(Execution& x, StopReason reason) {
    x.core.mark_emitted();
    x.core.sink().stop({reason}, x.core.at);
    x.run.ended = true;
    x.text.ended_by_code = reason != StopReason::End;
}

Step read_block(Execution& x) {
    if (x.run.reread) {
        x.run.reread = false;
    } else {
        x.reading.inputs_fresh = false;
        x.core.at.serial = ++x.run.serial;
        if (x.run.keeps_states) note_resume_point(x);
        if (const std::optional<Step> end = next_line(x)) return *end;
    }
    x.text.line_left = false;
    x.words.culprit = {};
    x.reading.has_pending_fault = false;
    x.core.begin_block();
    x.core.rest_of_dwell = std::exchange(x.way_back.interruption.goes_on, false);
    name_place(x);
    switch (x.scanner.scan(x.text.line, x.text.column, x.block)) {
        case ScanStop::EndOfLine:
            break;
        case ScanStop::Skipped:
            x.text.line_left = x.scanner.stopped_at() < x.text.line.size();
            break;
        case ScanStop::EndOfBlock:
            x.text.line_left = true;
            break;
        case ScanStop::TapeMark:
            return tape_mark(x);
        case ScanStop::NeedsBarrier:
            read_value_barrier(x);
            return Step::AtBarrier;
        case ScanStop::Fault:
            return scan_fault(x);
        case ScanStop::Macro:
            return statement_block(x);
    }
    return word_block(x);
}

Step step(Execution& x) {
    if (x.core.reads_ahead()) {
        if (x.core.halted()) return Step::AtBarrier;
        if (!x.run.ended && !x.core.compensation_failed()) return report(x, x.core.fault());
    }
    if (x.run.ended) return Step::Ended;
    if (x.reading.barrier_fault)
        return report(x, *std::exchange(x.reading.barrier_fault, std::nullopt));
    if (x.awaited.measuring.skipping) return finish_skip(x);
    if (x.awaited.remote.active) return binary_step(x);
    if (x.awaited.external.active) return external_step(x);
    return read_block(x);
}

}  // namespace polyturn::channels::fanuc
