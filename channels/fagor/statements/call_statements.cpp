#include "channels/fagor/statements/call_statements.hpp"

#include "channels/fagor/execution.hpp"
#include "channels/fagor/flow/calls.hpp"
#include "channels/fagor/flow/programs.hpp"
#include "channels/fagor/frames/plane.hpp"
#include "channels/fagor/motion/lines.hpp"
#include "channels/fagor/statements/statement_text.hpp"
#include "channels/fagor/statements/written_programs.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fagor {

Flow goto_statement(Execution& x, std::string_view, const char*& at, const char* end) {
    const char* const begin = at;
    std::int64_t label = 0;
    if (const Flow flow = number_of_statement(x, at, end, 'N', label); flow != Flow::Done)
        return flow;
    if (const Flow flow = nothing_follows(x, at, end); flow != Flow::Done) return flow;
    if (!jump_to(x, label))
        return flow_fault(x, Alarm::SequenceNumberMissing, begin, 1, std::to_string(label));
    return Flow::Done;
}

Flow rpt_statement(Execution& x, std::string_view, const char*& at, const char* end) {
    const char* const begin = at;
    std::int64_t first = 0, last = 0, program = -1;
    if (const Flow flow = number_of_statement(x, at, end, 'N', first); flow != Flow::Done)
        return flow;
    if (!comma(at, end)) return flow_fault(x, Alarm::FagorStatement, begin, 1, "RPT");
    if (const Flow flow = number_of_statement(x, at, end, 'N', last); flow != Flow::Done)
        return flow;
    if (comma(at, end)) {
        if (const Flow flow = number_of_statement(x, at, end, 'P', program); flow != Flow::Done)
            return flow;
    }
    if (const Flow flow = nothing_follows(x, at, end); flow != Flow::Done) return flow;
    FileId file = x.calls.here().file;
    if (program >= 0) {
        const auto found = find_program(x, program);
        if (!found)
            return flow_fault(x, Alarm::SubprogramMissing, begin, 1, "P" + std::to_string(program));
        file = *found;
    }
    const auto from = find_label(x, file, first), to = find_label(x, file, last);
    if (!from || !to)
        return flow_fault(x, Alarm::SequenceNumberMissing, begin, 1,
                          std::to_string(from ? last : first));
    if (from->line > to->line)
        return flow_fault(x, Alarm::FagorLabelOrder, begin, 1,
                          "N" + std::to_string(first) + " N" + std::to_string(last));
    const std::int64_t count = x.line.block.repeat < 0 ? 1 : x.line.block.repeat;
    if (count < 1) return Flow::Done;
    CallFrame frame;
    frame.kind = CallFrame::Kind::Repeat;
    frame.file = file;
    frame.begin = *from;
    frame.last_line = to->line;
    frame.runs_left = count - 1;
    frame.program = program >= 0 ? program : x.calls.here().program;
    frame.maker = x.calls.here().maker;
    x.words.repeats = -1;
    return push_frame(x, frame) ? Flow::Done : Flow::Fault;
}

// CALL (e); PCALL and MCALL with assignments of local parameters.
Flow call_statement(Execution& x, std::string_view word, const char*& at, const char* end) {
    const char* const begin = at;
    std::int64_t number = 0;
    if (const Flow flow = number_of_statement(x, at, end, 0, number); flow != Flow::Done)
        return flow;
    LocalSet arguments{};
    std::uint32_t given = 0;
    for (int count = 0; word != "CALL" && comma(at, end); ++count) {
        const char* const item = at;
        if (count == 26) return flow_fault(x, Alarm::WordsTooMany, item);
        Target to;
        if (const Flow flow = read_target(x, at, end, to); flow != Flow::Done) return flow;
        if (to.row || to.number < 0 || to.number >= static_cast<std::int64_t>(kLocals))
            return flow_fault(x, Alarm::MacroArgument, item, 1, target_name(to));
        blanks(at, end);
        if (at != end && *at == '=')
            ++at;
        else if (!to.by_letter)
            return flow_fault(x, Alarm::FagorStatement, item, 1, std::string(word));
        double value = 0.0;
        if (const Flow flow = evaluate(x, at, end, value); flow != Flow::Done) return flow;
        arguments[static_cast<std::size_t>(to.number)] = value;
        given |= 1u << to.number;
    }
    if (const Flow flow = nothing_follows(x, at, end); flow != Flow::Done) return flow;
    CallFrame frame;
    frame.given = given;
    if (word == "MCALL") {
        if (inside_modal_call(x))
            return flow_fault(x, Alarm::FagorStatement, begin, 1, "MCALL in a modal subroutine");
        x.modal.modal_call = {ModalCall::Kind::Subroutine, number, arguments, given};
        frame.modal = true;
    }
    if (call_subroutine(x, number, frame, word == "CALL" ? nullptr : &arguments)) return Flow::Done;
    return fault_stands_at(x, begin);
}

// A definition that the program comes to is passed over.
Flow skip_definition(Execution& x, std::string_view, const char*& at, const char* end) {
    std::int64_t number = 0;
    const char* const begin = at;
    if (const Flow flow = number_of_statement(x, at, end, 0, number); flow != Flow::Done)
        return flow;
    if (number > 20'000)
        return flow_fault(x, Alarm::FagorValueRange, begin, 1, "SUB", static_cast<double>(number));
    if (number >= 10'000 && !x.calls.here().maker)
        return flow_fault(x, Alarm::FagorMakerSubroutine, begin, 1, std::to_string(number));
    if (const Flow flow = nothing_follows(x, at, end); flow != Flow::Done) return flow;
    std::string_view line;
    const std::uint32_t here = x.core.at.line;
    while (x.calls.source().next(line) == LineSource::Status::Line) {
        const std::string_view statement = statement_of(line);
        if (!statement.starts_with("RET")) continue;
        x.run.jumped = true;
        return Flow::Done;
    }
    x.line.fault.line = here;
    return flow_fault(x, Alarm::ProgramNotEnded, begin, 1, "RET");
}

Flow exec_statement(Execution& x, std::string_view word, const char*& at, const char* end) {
    const char* const begin = at;
    std::int64_t number = 0;
    if (const Flow flow = number_of_statement(x, at, end, 'P', number); flow != Flow::Done)
        return flow;
    if (comma(at, end) && !folder(at, end))
        return flow_fault(x, Alarm::FagorStatement, at == end ? begin : at, 1, std::string(word));
    if (const Flow flow = nothing_follows(x, at, end); flow != Flow::Done) return flow;
    CallFrame frame;
    if (word == "MEXEC") {
        if (inside_modal_call(x))
            return flow_fault(x, Alarm::FagorExecForbidden, begin, 1, "P" + std::to_string(number));
        x.modal.modal_call = {ModalCall::Kind::Program, number, {}, 0};
        frame.modal = true;
    }
    if (call_program(x, number, frame)) return Flow::Done;
    return fault_stands_at(x, begin);
}

Flow ret_statement(Execution& x, std::string_view word, const char*& at, const char* end) {
    if (x.calls.here().kind != CallFrame::Kind::Subroutine)
        return flow_fault(x, Alarm::FagorReturn, word.data(), word.size());
    if (const Flow flow = nothing_follows(x, at, end); flow != Flow::Done) return flow;
    x.run.called = true;
    return return_from_frame(x) ? Flow::Done : Flow::Fault;
}

Flow mdoff_statement(Execution& x, std::string_view, const char*&, const char*) {
    x.modal.modal_call = {};
    return Flow::Done;
}

// Back to where the interrupt has stopped the program, axis by axis; those of the plane together
// (12.6).
Flow repos_statement(Execution& x, std::string_view, const char*& at, const char* end) {
    const char* const begin = at;
    const CallFrame* interrupt = nullptr;
    for (const CallFrame& frame : x.calls.frames())
        if (frame.interrupt) interrupt = &frame;
    if (!interrupt) return flow_fault(x, Alarm::FagorRepos, begin, 1);
    unsigned p = 0, q = 0;
    const bool plane = plane_places(x, p, q);
    AxisSet done = 0;
    for (;;) {
        blanks(at, end);
        const int place = at != end && *at >= 'A' && *at <= 'Z' ? x.places.of(*at) : -1;
        if (place < 0)
            return flow_fault(x, Alarm::FagorStatement, at == end ? begin : at, 1, "REPOS");
        ++at;
        const auto i = static_cast<unsigned>(place);
        AxisSet set = 1u << i;
        if (plane && (i == p || i == q)) set = 1u << p | 1u << q;
        if (!(done & set)) {
            AxisValues target = x.core.path.programmed;
            for (unsigned k = 0; k < x.core.view().axis_count; ++k)
                if (set >> k & 1u) target[k] = interrupt->point[k];
            if (!drive_straight(x, target, x.modal.motion == 0)) return Flow::Fault;
        }
        done |= set;
        blanks(at, end);
        if (at == end) return Flow::Done;
        if (*at != ',') return flow_fault(x, Alarm::FagorStatement, at, 1, "REPOS");
        ++at;
    }
}

}  // namespace polyturn::channels::fagor
