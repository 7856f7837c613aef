// Statements that run and write other texts: RPT, CALL, PCALL, MCALL, SUB, EXEC, MEXEC, OPEN,
// WRITE, REPOS (fagor_8037t part 2, 12.4 to 12.7).
#include <fmt/format.h>

#include <cmath>

#include "channels/fagor/interpreter.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fagor {
namespace {

bool comma(const char*& at, const char* end) {
    blanks(at, end);
    if (at == end || *at != ',') return false;
    ++at;
    blanks(at, end);
    return true;
}

// HD, DNC2, DNCE: where the program lies; all of them are one place here.
bool folder(const char*& at, const char* end) {
    for (const std::string_view name : {"DNC2", "DNCE", "HD"}) {
        if (static_cast<std::size_t>(end - at) < name.size() ||
            std::string_view(at, name.size()) != name)
            continue;
        at += name.size();
        return true;
    }
    return false;
}

}  // namespace

Interpreter::Flow Interpreter::repeat(const char*& at, const char* end) {
    const char* const begin = at;
    std::int64_t first = 0, last = 0, program = -1;
    if (const Flow flow = number_of_statement(at, end, 'N', first); flow != Flow::Done) return flow;
    if (!comma(at, end)) return flow_fault(Alarm::FagorStatement, begin, 1, "RPT");
    if (const Flow flow = number_of_statement(at, end, 'N', last); flow != Flow::Done) return flow;
    if (comma(at, end)) {
        if (const Flow flow = number_of_statement(at, end, 'P', program); flow != Flow::Done)
            return flow;
    }
    if (const Flow flow = nothing_follows(at, end); flow != Flow::Done) return flow;
    FileId file = frames_.back().file;
    if (program >= 0) {
        const auto found = find_program(program);
        if (!found)
            return flow_fault(Alarm::SubprogramMissing, begin, 1, "P" + std::to_string(program));
        file = *found;
    }
    const auto from = find_label(file, first), to = find_label(file, last);
    if (!from || !to)
        return flow_fault(Alarm::SequenceNumberMissing, begin, 1,
                          std::to_string(from ? last : first));
    if (from->line > to->line)
        return flow_fault(Alarm::FagorLabelOrder, begin, 1,
                          "N" + std::to_string(first) + " N" + std::to_string(last));
    const std::int64_t count = block_.repeat < 0 ? 1 : block_.repeat;
    if (count < 1) return Flow::Done;
    CallFrame frame;
    frame.kind = CallFrame::Kind::Repeat;
    frame.file = file;
    frame.begin = *from;
    frame.last_line = to->line;
    frame.runs_left = count - 1;
    frame.program = program >= 0 ? program : frames_.back().program;
    frame.maker = frames_.back().maker;
    repeats_ = -1;
    return push_frame(frame) ? Flow::Done : Flow::Fault;
}

// CALL (e); PCALL and MCALL with assignments of local parameters.
Interpreter::Flow Interpreter::call(const char*& at, const char* end, std::string_view how) {
    const char* const begin = at;
    std::int64_t number = 0;
    if (const Flow flow = number_of_statement(at, end, 0, number); flow != Flow::Done) return flow;
    LocalSet arguments{};
    std::uint32_t given = 0;
    for (int count = 0; how != "CALL" && comma(at, end); ++count) {
        const char* const item = at;
        if (count == 26) return flow_fault(Alarm::WordsTooMany, item);
        Target to;
        if (const Flow flow = target(at, end, to); flow != Flow::Done) return flow;
        if (to.row || to.number < 0 || to.number >= static_cast<std::int64_t>(kLocals))
            return flow_fault(Alarm::MacroArgument, item, 1, target_name(to));
        blanks(at, end);
        if (at != end && *at == '=')
            ++at;
        else if (!to.by_letter)
            return flow_fault(Alarm::FagorStatement, item, 1, std::string(how));
        double value = 0.0;
        if (const Flow flow = evaluate(at, end, value); flow != Flow::Done) return flow;
        arguments[static_cast<std::size_t>(to.number)] = value;
        given |= 1u << to.number;
    }
    if (const Flow flow = nothing_follows(at, end); flow != Flow::Done) return flow;
    CallFrame frame;
    frame.given = given;
    if (how == "MCALL") {
        if (inside_modal_call())
            return flow_fault(Alarm::FagorStatement, begin, 1, "MCALL in a modal subroutine");
        modal_.modal_call = {ModalCall::Kind::Subroutine, number, arguments, given};
        frame.modal = true;
    }
    if (call_subroutine(number, frame, how == "CALL" ? nullptr : &arguments)) return Flow::Done;
    fault_column_ = static_cast<std::uint32_t>(begin - line_.data()) + 1;
    fault_length_ = 1;
    return Flow::Fault;
}

// A definition that the program comes to is passed over.
Interpreter::Flow Interpreter::skip_definition(const char*& at, const char* end) {
    std::int64_t number = 0;
    const char* const begin = at;
    if (const Flow flow = number_of_statement(at, end, 0, number); flow != Flow::Done) return flow;
    if (number > 20'000)
        return flow_fault(Alarm::FagorValueRange, begin, 1, "SUB", static_cast<double>(number));
    if (number >= 10'000 && !frames_.back().maker)
        return flow_fault(Alarm::FagorMakerSubroutine, begin, 1, std::to_string(number));
    if (const Flow flow = nothing_follows(at, end); flow != Flow::Done) return flow;
    std::string_view line;
    const std::uint32_t here = core_.at.line;
    while (source_->next(line) == LineSource::Status::Line) {
        const std::string_view statement = statement_of(line);
        if (!statement.starts_with("RET")) continue;
        jumped_ = true;
        return Flow::Done;
    }
    fault_line_ = here;
    return flow_fault(Alarm::ProgramNotEnded, begin, 1, "RET");
}

Interpreter::Flow Interpreter::execute(const char*& at, const char* end, bool modal) {
    const char* const begin = at;
    std::int64_t number = 0;
    if (const Flow flow = number_of_statement(at, end, 'P', number); flow != Flow::Done)
        return flow;
    if (comma(at, end) && !folder(at, end))
        return flow_fault(Alarm::FagorStatement, at == end ? begin : at, 1,
                          modal ? "MEXEC" : "EXEC");
    if (const Flow flow = nothing_follows(at, end); flow != Flow::Done) return flow;
    CallFrame frame;
    if (modal) {
        if (inside_modal_call())
            return flow_fault(Alarm::FagorExecForbidden, begin, 1, "P" + std::to_string(number));
        modal_.modal_call = {ModalCall::Kind::Program, number, {}, 0};
        frame.modal = true;
    }
    if (call_program(number, frame)) return Flow::Done;
    fault_column_ = static_cast<std::uint32_t>(begin - line_.data()) + 1;
    fault_length_ = 1;
    return Flow::Fault;
}

Interpreter::Flow Interpreter::open(const char*& at, const char* end) {
    const char* const begin = at;
    std::int64_t number = 0;
    if (const Flow flow = number_of_statement(at, end, 'P', number); flow != Flow::Done)
        return flow;
    char how = 0;
    std::string title;
    while (comma(at, end)) {
        if (folder(at, end)) continue;
        if (at != end && (*at == 'A' || *at == 'D') && !how)
            how = *at++;
        else if (!quoted(at, end, title))
            return flow_fault(Alarm::FagorStatement, at == end ? begin : at, 1, "OPEN");
    }
    WrittenProgram* written = nullptr;
    for (WrittenProgram& program : modal_.written)
        if (program.number == number) written = &program;
    const auto stored = written ? std::optional<FileId>() : files_->find_number(number, ".PIT");
    if ((written || stored) && !how)
        return flow_fault(Alarm::FagorProgramExists, begin, 1, "P" + std::to_string(number));
    std::string text;
    if (how == 'A' && written) text = *written->text;
    if (how == 'A' && stored) {
        LineSource& source = files_->source(*stored);
        const TextPosition back = source.next_position();
        source.seek({0, 1});
        std::string_view line;
        while (source.next(line) == LineSource::Status::Line) text.append(line) += '\n';
        source.seek(back);
    }
    if (!keep_written()) return Flow::Fault;
    if (!written) written = &modal_.written.emplace_back(WrittenProgram{number, {}, {}});
    if (text.empty()) text = "%" + title + ",MX,\n";
    written->title = title;
    written->text = std::make_shared<const std::string>(std::move(text));
    modal_.writing = number;
    return Flow::Done;
}

// The program that was open is complete: it goes into the machine's program memory, where there is
// one.
bool Interpreter::keep_written() {
    if (modal_.writing < 0 || !files_->keeps() || reads_profile_ || scanning_) return true;
    for (const WrittenProgram& program : modal_.written)
        if (program.number == modal_.writing &&
            !files_->keep(fmt::format("{:06}.PIT", program.number), *program.text))
            return core_.fail(Alarm::FileUnreadable, 0, fmt::format("{:06}.PIT", program.number));
    return true;
}

// ISO words take the values of their parameters; in a statement only parameters behind ? do.
Interpreter::Flow Interpreter::write(const char*& at, const char* end) {
    if (modal_.writing < 0) return flow_fault(Alarm::FagorWriteClosed, at == end ? at - 1 : at, 1);
    blanks(at, end);
    const std::string_view block(at, static_cast<std::size_t>(end - at));
    // behind skip signs and a label too
    const bool statement = block.substr(0, block.find(';')).find('(') != std::string_view::npos;
    for (WrittenProgram& program : modal_.written) {
        if (program.number != modal_.writing) continue;
        std::string text = *program.text + with_parameters(block, statement) + '\n';
        program.text = std::make_shared<const std::string>(std::move(text));
    }
    at = end;
    return Flow::Done;
}

// Back to where the interrupt has stopped the program, axis by axis; those of the plane together
// (12.6).
Interpreter::Flow Interpreter::reposition(const char*& at, const char* end) {
    const char* const begin = at;
    const CallFrame* interrupt = nullptr;
    for (const CallFrame& frame : frames_)
        if (frame.interrupt) interrupt = &frame;
    if (!interrupt) return flow_fault(Alarm::FagorRepos, begin, 1);
    unsigned p = 0, q = 0;
    const bool plane = plane_places(p, q);
    AxisSet done = 0;
    for (;;) {
        blanks(at, end);
        const int place = at != end && *at >= 'A' && *at <= 'Z'
                              ? place_[static_cast<std::size_t>(*at - 'A')]
                              : -1;
        if (place < 0) return flow_fault(Alarm::FagorStatement, at == end ? begin : at, 1, "REPOS");
        ++at;
        const auto i = static_cast<unsigned>(place);
        AxisSet set = 1u << i;
        if (plane && (i == p || i == q)) set = 1u << p | 1u << q;
        if (!(done & set)) {
            AxisValues target = core_.path.programmed;
            for (unsigned k = 0; k < core_.view().axis_count; ++k)
                if (set >> k & 1u) target[k] = interrupt->point[k];
            if (!straight(target, modal_.motion == 0)) return Flow::Fault;
        }
        done |= set;
        blanks(at, end);
        if (at == end) return Flow::Done;
        if (*at != ',') return flow_fault(Alarm::FagorStatement, at, 1, "REPOS");
        ++at;
    }
}

}  // namespace polyturn::channels::fagor
