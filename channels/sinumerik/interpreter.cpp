// From block to block. What a block does is in act.cpp and behind the handlers.
#include "channels/sinumerik/interpreter.hpp"

#include <algorithm>
#include <utility>

#include "channels/sinumerik/act.hpp"
#include "channels/sinumerik/actions/synchronized.hpp"
#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/coordination/procedures.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/calls.hpp"
#include "channels/sinumerik/flow/program_begin.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/frames/settable_frames.hpp"
#include "channels/sinumerik/geometry/g_settings.hpp"
#include "channels/sinumerik/grammar/head.hpp"
#include "channels/sinumerik/grammar/words.hpp"
#include "channels/sinumerik/spindles/spindle_commands.hpp"
#include "channels/sinumerik/tools/drilling_cycles.hpp"
#include "channels/sinumerik/tools/managed_tools.hpp"
#include "channels/sinumerik/variables/declarations.hpp"
#include "channels/sinumerik/variables/variables.hpp"
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr std::size_t kLongestBlock = 512;  // with comment and line feed (sinumerik_part1 3.2)
constexpr unsigned kDeepestText = 16;       // EXECSTRING within EXECSTRING

}  // namespace

Interpreter::Interpreter(MachineView& view, Sink& sink, Port& port, ProgramFiles& files)
    : x_(view, sink, port, files) {
    x_.settings = read_settings(view.table(), view);
    x_.names.r = std::make_shared<Variable>();
    x_.names.r->name = "R";
    x_.names.r->dimensions = {static_cast<unsigned>(x_.settings.r_parameters)};
    x_.names.r->cells.assign(static_cast<std::size_t>(x_.settings.r_parameters),
                             Value::of_real(0.0));
    x_.core.wait_for_spindle(true);
    x_.core.lie_in_frame(false, true);
    reset_modal(x_);
}

Result<void> Interpreter::start(FileId main) {
    x_.core.begin_control();
    x_.core.compensation_reset();
    x_.settings = read_settings(x_.core.view().table(), x_.core.view());
    if (auto wrong = reset_value_fault(x_)) return std::move(*wrong);
    x_.core.path.spindle = {};
    x_.stops.on = x_.stops.wanted = 0;
    reset_modal(x_);
    x_.calls.levels.clear();
    Level level;
    level.file = main;
    level.scope = std::make_shared<Scope>();
    x_.calls.levels.push_back(std::move(level));
    x_.calls.source = &x_.files.source(main);
    x_.calls.source->seek({0, 1});
    x_.calls.indices.clear();
    x_.names.macros.clear();
    x_.names.of_channel->names.clear();
    x_.interrupts.routines.clear();
    x_.actions.polynomials.clear();
    std::erase_if(x_.actions.all, [](const SynchronizedAction& one) { return !one.is_static; });
    x_.names.declares_for_channel = false;
    x_.run.ended = x_.run.reread = x_.run.jumped = x_.pass.needs_barrier = x_.run.wants_barrier =
        x_.run.called = false;
    x_.run.tool_serial = 0;
    look_at_outputs(x_);
    x_.run.fresh = true;  // cycle start is a barrier
    x_.run.serial = 0;
    points_.clear();
    x_.changes.of_run.clear();
    x_.run.state_changed = true;
    x_.core.refresh_limits();
    x_.core.load_zeros();
    const GCode* zero = find_g(8, x_.modal.active[8]);
    g_zero(x_, *zero);
    use_frame(x_);  // none of the program before
    x_.modal.pending_zero = {};
    return {};
}

void Interpreter::barrier_done() {
    // compensation has read on: the program is ahead of this barrier
    if (!x_.core.barrier_passed()) return;
    x_.run.fresh = true;
    x_.core.refresh_limits();
    for (unsigned i = 0; i < x_.core.view().axis_count; ++i)
        if (const auto now = x_.core.port().axis_taken_over(x_.core.view().axes[i].machine_axis))
            x_.core.take_machine(i, *now);
}

Step Interpreter::fault(Fault fault) {
    Diagnosis diagnosis;
    diagnosis.alarm = fault.alarm;
    if (fault.block) {  // an earlier block of the program
        diagnosis.place = {x_.files.path(fault.block->file), fault.block->line, fault.column,
                           fault.length};
    } else {
        std::size_t column = x_.blame.column, length = x_.blame.length;
        if (!column && fault.letter)
            for (const Word& word : x_.block.words)
                if (word.address->name == std::string_view(&fault.letter, 1) ||
                    (word.axis >= 0 && axis_name(x_, word.axis)[0] == fault.letter)) {
                    column = word.column;
                    length = word.length;
                }
        diagnosis.place = {
            x_.files.path(x_.calls.levels.back().file),
            x_.blame.line ? x_.blame.line : x_.core.at.line,
            column ? character_column(x_.line.text, static_cast<std::uint32_t>(column)) : 0,
            static_cast<std::uint32_t>(length)};
    }
    diagnosis.values = {fault.value0, fault.value1};
    diagnosis.detail = std::move(fault.detail);
    x_.core.sink().alarm(diagnosis, fault.block ? *fault.block : x_.core.at);
    x_.run.ended = true;
    return Step::Failed;
}

Step Interpreter::step() {
    if (x_.core.reads_ahead()) {
        if (x_.core.halted()) return Step::AtBarrier;
        if (!x_.run.ended && !x_.core.compensation_failed()) return fault(x_.core.fault());
    }
    if (x_.run.ended) return Step::Ended;
    return read_block();
}

// The corner before it stays without its next block.
void Interpreter::live_value_barrier() {
    if (x_.core.holds_block())
        x_.core.sink().alarm({Alarm::CompCornerCut,
                              {x_.files.path(x_.calls.levels.back().file), x_.core.at.line, 0, 0},
                              {},
                              {}},
                             x_.core.at);
    x_.core.asks_at(x_.calls.levels.back().file, x_.line.here.offset);
    x_.core.sink().barrier(x_.core.at);
}

Step Interpreter::end_of_text() {
    x_.line.text.clear();
    x_.core.at.line = x_.calls.source->position().line;
    x_.core.at.block = -1;
    x_.core.begin_block();
    if (x_.calls.levels.size() > 1) {  // a subprogram may end without M17
        if (!return_from_level(x_)) return fault(x_.core.fault());
        return Step::Continue;
    }
    finish(x_, StopReason::End);
    if (x_.core.reads_ahead() && !x_.core.compensation_failed()) return fault(x_.core.fault());
    x_.core.end_block();
    if (x_.core.reads_ahead() && x_.core.halted()) return Step::AtBarrier;
    return Step::Ended;
}

Step Interpreter::read_block() {
    if (!x_.run.reread) {
        // The end of a repeated section.
        while (x_.calls.levels.back().section &&
               x_.calls.source->next_position().offset >= x_.calls.levels.back().end) {
            Level& section = x_.calls.levels.back();
            x_.run.state_changed = true;
            if (section.repeats > 0) {
                --section.repeats;
                x_.run.fresh = false;
                x_.calls.source->seek(section.begin);
            } else {
                x_.calls.source->seek(section.resume);
                x_.calls.levels.pop_back();
            }
        }
        x_.core.at.serial = ++x_.run.serial;
        if (x_.run.keeps_states) note_resume_point();
        x_.pass.at_hole = std::exchange(x_.modal.holes, nullptr);
        std::string_view line;
        switch (x_.calls.source->next(line)) {
            case LineSource::Status::Line:
                break;
            case LineSource::Status::End:
                return end_of_text();
            case LineSource::Status::TooLong:
                x_.blame.line = x_.calls.source->position().line;
                fail(x_, Alarm::LineTooLong);
                return fault(x_.core.fault());
            case LineSource::Status::ReadError:
                fail(x_, Alarm::FileUnreadable, "reading failed");
                return fault(x_.core.fault());
        }
        x_.line.text = line;
        x_.line.here = x_.calls.source->position();
        if (!x_.names.macros.empty()) expand_macros(x_);
    }
    x_.run.reread = x_.pass.needs_barrier = x_.run.wants_barrier = x_.run.jumped = x_.run.called =
        false;
    x_.blame.column = x_.blame.length = 0;
    x_.blame.line = 0;
    x_.line.depth = 0;
    x_.core.begin_block();
    BlockContext& at = x_.core.at;
    at.file = x_.calls.levels.back().file;
    unsigned depth = 0;
    for (const Level& level : x_.calls.levels) depth += !level.section;
    at.stack_depth = static_cast<std::uint8_t>(depth - 1);
    at.line = x_.line.here.line;
    at.block = -1;
    at.cycle = {};
    x_.pass.ways_before = x_.core.ways();
    x_.block.clear();
    x_.changes.of_block.clear();
    x_.changes.written.clear();
    x_.frames.written.clear();
    x_.actions.overlays.clear();
    x_.line.statement = nullptr;
    x_.line.execute.clear();
    x_.names.declares_for_channel = false;
    x_.line.cursor = Cursor(x_.line.text);
    if (x_.line.text.size() + 1 > kLongestBlock) {
        fail(x_, Alarm::LineTooLong);
        return fault(x_.core.fault());
    }
    if (x_.line.cursor.at_end()) return Step::Continue;
    // the head of a file from an archive; the next one begins another program
    if (x_.line.cursor.peek() == '%') {
        if (x_.line.here.offset == 0) return Step::Continue;
        return end_of_text();
    }
    bool skipped = false;
    if (!parse_head(x_, skipped)) return after_block(false);
    if (skipped || x_.line.cursor.at_end()) {
        if (x_.core.reads_ahead() && !skipped &&
            !x_.core.end_compensated_block(false, false, false))
            return fault(x_.core.fault());
        return Step::Continue;
    }
    x_.run.state_changed = true;
    x_.pass.reads = true;
    bool ok = read_line();
    // EXECSTRING: its text in the place of the line
    for (unsigned nested = 0; ok && !x_.line.execute.empty() && !x_.pass.needs_barrier; ++nested) {
        if (nested == kDeepestText) {
            ok = fail(x_, Alarm::CallTooDeep, "EXECSTRING", kDeepestText);
            break;
        }
        x_.line.text = std::move(x_.line.execute);
        x_.line.execute.clear();
        x_.block.clear();
        x_.line.statement = nullptr;
        x_.line.cursor = Cursor(x_.line.text);
        x_.pass.reads = true;
        if (x_.line.cursor.at_end()) break;
        ok = parse_head(x_, skipped) && (skipped || x_.line.cursor.at_end() || read_line());
    }
    x_.pass.reads = false;
    return after_block(ok);
}

// A statement, or words and what follows them.
bool Interpreter::read_line() {
    bool ok = true;
    const std::string_view first = x_.line.cursor.name_ahead();
    const Symbol symbol = first.size() > 1 ? find_symbol(upper(first)) : Symbol{};
    if (symbol.kind == Symbol::Kind::Statement) {
        x_.line.statement = &symbol.statement();
        x_.line.cursor.advance(first.size());
        x_.line.statement_at = x_.line.cursor.column(x_.line.cursor.at());
        x_.pass.reads = !x_.line.statement->act ? true : x_.pass.reads;
        ok = x_.line.statement->act
                 ? run_statement()
                 : fail_at(x_, Alarm::NotBuilt, x_.line.cursor.at() - first.size(), first.size(),
                           std::string(x_.line.statement->name));
    } else {
        ok = parse_words(x_) && check_block(x_) && spindles_to_axes(x_) &&
             take_back_released_axes(x_) && managed_tool(x_) && synchronized_actions(x_);
        x_.pass.reads = false;
        if (ok) x_.changes.of_block.clear();
        ok = ok && act(x_);
        if (ok && x_.line.statement) {  // a jump or call behind the words
            x_.line.cursor.at() =
                x_.line.cursor.begin() + x_.line.statement_at - 1 + x_.line.statement->name.size();
            ok = x_.line.statement->act
                     ? run_statement()
                     : fail_at(
                           x_, Alarm::NotBuilt, x_.line.cursor.begin() + x_.line.statement_at - 1,
                           x_.line.statement->name.size(), std::string(x_.line.statement->name));
        }
        if (ok && x_.block.program.wanted && !x_.run.ended) {
            std::int64_t repeats = 1;
            if (const Word* p = word(x_, "P")) repeats = static_cast<std::int64_t>(p->number());
            ok = call_program(x_, x_.block.program.name, std::move(x_.block.program.arguments),
                              repeats, false);
        }
    }
    return ok;
}

// The statement itself; what it assigned is reported when it has succeeded.
bool Interpreter::run_statement() {
    const bool ok = x_.line.statement->act(x_);
    if (!ok) return false;
    for (const Written& one : x_.changes.written) report_variable(x_, one.name, one.value);
    x_.changes.written.clear();
    return true;
}

// STOPRE and MSG leave a loop that waits for the machine where it was (Core::asks_at).
bool Interpreter::does_anything() const {
    const auto acts = [](const auto& one) {
        return one.first->act != p_stopre && one.first->act != p_msg;
    };
    return !x_.block.words.empty() || !x_.block.codes.empty() ||
           std::ranges::any_of(x_.block.procedures, acts);
}

Step Interpreter::after_block(bool ok) {
    x_.pass.reads = false;
    if (!ok) {
        if (!x_.pass.needs_barrier) return fault(x_.core.fault());
        for (auto undo = x_.changes.of_block.rbegin(); undo != x_.changes.of_block.rend(); ++undo)
            (*undo)();
        x_.changes.of_block.clear();
        x_.changes.written.clear();
        x_.stops.wanted = 0;
        x_.run.reread = true;
        live_value_barrier();
        return Step::AtBarrier;
    }
    x_.changes.of_block.clear();
    if (does_anything()) x_.core.did();
    if (x_.core.transformation_failed()) return fault(x_.core.fault());
    if (x_.core.reads_ahead()) {
        const bool counts = !x_.run.called && !(x_.block.words.empty() && x_.block.codes.empty());
        if (!x_.core.end_compensated_block(counts, x_.run.wants_barrier, x_.run.ended)) {
            Fault why = x_.core.fault();
            // 11.4.1
            if (why.alarm == Alarm::CompIdleBlocks && why.block &&
                why.block->serial == x_.modal.geo.approach_serial)
                why.alarm = Alarm::ApproachNoEnd;
            return fault(why);
        }
        if (x_.core.transformation_failed()) return fault(x_.core.fault());
    }
    if (!x_.run.ended && !x_.run.called && x_.modal.call && x_.modal.call->cycle &&
        x_.core.ways() != x_.pass.ways_before && !modal_cycle(x_))
        return fault(x_.core.fault());
    if (x_.run.tool_serial == x_.core.at.serial)
        x_.core.mark_emitted();  // its T came before the barrier
    if (x_.core.emitted()) {
        x_.run.fresh = false;
        x_.core.end_block();
    }
    // nothing that it calls calls it
    const bool calls = x_.modal.call && !x_.modal.call->cycle &&
                       std::ranges::none_of(x_.calls.levels, &Level::modal_call);
    if (!x_.run.ended && !x_.run.called && calls &&
        (x_.core.ways() != x_.pass.ways_before || x_.pass.at_hole)) {
        const ModalCall call = *x_.modal.call;
        if (!call_program(x_, call.name, call.arguments, 1, true)) return fault(x_.core.fault());
        if (x_.pass.at_hole &&
            x_.pass.at_hole->more()) {  // behind it the block of the pattern comes again
            x_.calls.levels.back().resume = x_.line.here;
            x_.calls.levels.back().holes = x_.pass.at_hole;
        }
    }
    if (x_.core.reads_ahead())
        return x_.core.halted() ? Step::AtBarrier : x_.run.ended ? Step::Ended : Step::Continue;
    if (x_.run.ended) return Step::Ended;
    return x_.run.wants_barrier ? Step::AtBarrier : Step::Continue;
}

}  // namespace polyturn::channels::sinumerik
