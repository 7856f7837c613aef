#include "channels/fagor/flow/step.hpp"

#include <optional>
#include <utility>

#include "channels/engine/block_edges.hpp"
#include "channels/engine/block_loop.hpp"
#include "channels/engine/fault_place.hpp"
#include "channels/engine/text_search.hpp"
#include "channels/fagor/execution.hpp"
#include "channels/fagor/flow/block_order.hpp"
#include "channels/fagor/flow/calls.hpp"
#include "channels/fagor/flow/fault.hpp"
#include "channels/fagor/flow/interrupts.hpp"
#include "channels/fagor/flow/resume.hpp"
#include "channels/fagor/grammar/words.hpp"
#include "channels/fagor/motion/dwell.hpp"
#include "channels/fagor/motion/loop_scan.hpp"
#include "channels/fagor/motion/probe.hpp"
#include "channels/fagor/statements/statements.hpp"
#include "channels/fagor/tools/managed_tools.hpp"

namespace polyturn::channels::fagor {
namespace {

Step iso_block(Execution& x) {
    x.run.jumped = x.run.called = x.run.wants_barrier = false;
    const std::uint64_t ways_before = x.core.ways();
    if (!classify(x)) return fault(x, x.core.fault());
    if (std::exchange(x.interrupt.fill, false)) stay_where_left(x);
    const GCode* one_shot = x.words.code(GGroup::OneShot);
    // the axes rest first (architecture 5.8)
    if (one_shot && one_shot->number == 46 && !x.run.fresh && !x.core.reads_ahead()) {
        x.core.sink().barrier(x.core.at);
        return engine::read_again(x.run);
    }
    // what is held for its corner ends first
    if (x.words.has('T') && x.core.reads_ahead() && !x.run.fresh &&
        x.run.tool_serial != x.core.at.serial && !x.ahead.scans_loops && managed(x)) {
        live_value_barrier(x);
        return engine::read_again(x.run);
    }
    if (asks_for_tool(x)) return engine::read_again(x.run);
    // G04 alone leaves a loop that asks the machine where it was
    if (!(one_shot && one_shot->number == 4 && ends_reading(x))) x.core.did();
    if (!(check_words(x) && act_in_order(x))) return fault(x, x.core.fault());
    if (x.run.tool_serial == x.core.at.serial)
        x.core.mark_emitted();  // its T came before the barrier
    if (x.core.transformation_failed()) return fault(x, x.core.fault());
    if (!x.run.called) x.modal.m_done = -1;
    if (x.loops.due || (x.loops.scanned_to && x.run.serial >= x.loops.scanned_to)) {
        x.loops.due = false;
        if (!scan_loops(x)) return fault(x, x.core.fault());
    }
    return end_block(x, x.line.block.count != 0, ways_before);
}

Step end_of_text(Execution& x) {
    CallFrame& frame = x.calls.here();
    if (frame.kind == CallFrame::Kind::Subroutine)
        return fault_at(x, Alarm::ProgramNotEnded, 0, 0, "RET");
    if (frame.kind != CallFrame::Kind::Main) {
        x.core.begin_block();
        return return_from_frame(x) ? Step::Continue : fault(x, x.core.fault());
    }
    x.core.at.block = -1;
    x.line.text = {};
    const auto step = engine::end_of_program(x.core, x.run);
    return step ? *step : fault(x, x.core.fault());
}

// Blank lines may only stand behind the last block (fagor_8037t part 1, 2).
Step blank_line(Execution& x) {
    const engine::KeepPosition keep(x.calls.source());
    std::string_view line;
    bool last = true;
    while (last && x.calls.source().next(line) == LineSource::Status::Line)
        last = line.find_first_not_of(" \t") == std::string_view::npos;
    return last ? Step::Continue : fault_at(x, Alarm::FagorBlockEmpty, 0, 0);
}

// Words or a statement, or neither.
Step read_block(Execution& x) {
    x.line.fault = {};
    x.words.by_letter.fill(nullptr);
    x.core.begin_block();
    BlockContext& at = x.core.at;
    at.file = x.calls.here().file;
    at.stack_depth = static_cast<std::uint8_t>(x.calls.depth() - 1);
    at.block = -1;
    at.cycle = {};
    const BlockKind kind = x.parsers.reader.read(x.line.text, x.line.block);
    if (x.line.block.label >= 0) at.block = x.modal.last_label = x.line.block.label;
    switch (kind) {
        case BlockKind::Blank:
            return blank_line(x);
        case BlockKind::Comment:
        case BlockKind::Skipped:
            return Step::Continue;
        case BlockKind::Title:
            if (x.line.is_first) return Step::Continue;
            return fault_at(x, Alarm::CharacterUnknown, 1, 1, "%");
        case BlockKind::NeedsBarrier:
        case BlockKind::Fault: {
            const ReaderFault& wrong = x.parsers.reader.fault();
            return fault_at(x, wrong.alarm, wrong.column, wrong.length, wrong.detail);
        }
        case BlockKind::Iso:
            if (x.run.keeps_states && !is_plain_move(x)) x.run.state_changed = true;
            return iso_block(x);
        case BlockKind::Statement:
            break;
    }
    x.run.state_changed = true;
    return statement_block(x);
}

// The stations of a step (engine/block_loop.hpp).
struct Stations {
    using Execution = fagor::Execution;

    static std::optional<Step> goes_on(Execution& x) {
        return x.probe.under_way ? std::optional(finish_probe(x)) : std::nullopt;
    }
    // A definition that is wrong is reported before anything moves; a repeated part ends behind its
    // last line.
    static std::optional<Step> before_line(Execution& x) {
        if (x.programs.definition_fault) {
            x.core.at.line = x.programs.definition_fault->place.line;
            return engine::report(x.core, x.run, *x.programs.definition_fault, x.core.at);
        }
        const CallFrame& frame = x.calls.here();
        if (frame.kind != CallFrame::Kind::Repeat ||
            x.calls.source().next_position().line <= frame.last_line)
            return std::nullopt;
        x.core.begin_block();
        return return_from_frame(x) ? Step::Continue : fault(x, x.core.fault());
    }
    static void note_block(Execution& x) {
        if (x.run.keeps_states)
            note_resume_point(x);
        else
            x.values.begin_block(x.run.serial);
    }
    static std::optional<Step> next_line(Execution& x) {
        std::string_view line;
        switch (x.calls.source().next(line)) {
            case LineSource::Status::Line:
                break;
            case LineSource::Status::End:
                return end_of_text(x);
            case LineSource::Status::TooLong:
                return fault_at(x, Alarm::LineTooLong, 0, 0);
            case LineSource::Status::ReadError:
                return fault_at(x, Alarm::FileUnreadable, 0, 0, "reading failed");
        }
        x.line.take(line);
        x.line.at = x.calls.source().position();
        x.line.is_first = x.line.at.line == 1;
        x.core.at.line = x.line.at.line;
        return std::nullopt;
    }
    static Step block(Execution& x) { return read_block(x); }
    static Step fault(Execution& x, const Fault& why) { return fagor::fault(x, why); }
};

}  // namespace

Step step(Execution& x) { return engine::step<Stations>(x); }

void live_value_barrier(Execution& x) { x.core.sink().barrier(x.core.at); }

// Behind words and statements: compensation goes on, and the modal subroutine runs where the block
// has moved.
Step end_block(Execution& x, bool counts, std::uint64_t ways_before) {
    if (x.core.reads_ahead() &&
        !x.core.end_compensated_block(counts && !x.run.called, x.run.wants_barrier, x.run.ended))
        return fault(x, x.core.fault());
    engine::end_block(x.core, x.run);
    if (!x.run.ended && x.core.ways() != ways_before &&
        x.modal.modal_call.kind != ModalCall::Kind::None && !inside_modal_call(x)) {
        if (!run_modal_call(x, x.words.repeats < 0 ? 1 : x.words.repeats))
            return fault(x, x.core.fault());
    }
    return engine::step_behind(x.core, x.run);
}

}  // namespace polyturn::channels::fagor
