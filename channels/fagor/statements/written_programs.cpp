#include "channels/fagor/statements/written_programs.hpp"

#include <fmt/format.h>

#include <utility>

#include "channels/engine/text_search.hpp"
#include "channels/fagor/execution.hpp"
#include "channels/fagor/statements/statement_text.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fagor {

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

Flow open_statement(Execution& x, std::string_view, const char*& at, const char* end) {
    const char* const begin = at;
    std::int64_t number = 0;
    if (const Flow flow = number_of_statement(x, at, end, 'P', number); flow != Flow::Done)
        return flow;
    char how = 0;
    std::string title;
    while (comma(at, end)) {
        if (folder(at, end)) continue;
        if (at != end && (*at == 'A' || *at == 'D') && !how)
            how = *at++;
        else if (!quoted(at, end, title))
            return flow_fault(x, Alarm::FagorStatement, at == end ? begin : at, 1, "OPEN");
    }
    WrittenProgram* written = nullptr;
    for (WrittenProgram& program : x.modal.written)
        if (program.number == number) written = &program;
    const auto stored =
        written ? std::optional<FileId>() : x.programs.files.find_number(number, ".PIT");
    if ((written || stored) && !how)
        return flow_fault(x, Alarm::FagorProgramExists, begin, 1, "P" + std::to_string(number));
    std::string text;
    if (how == 'A' && written) text = *written->text;
    if (how == 'A' && stored) {
        LineSource& source = x.programs.files.source(*stored);
        const engine::KeepPosition keep(source);
        source.seek({0, 1});
        std::string_view line;
        while (source.next(line) == LineSource::Status::Line) text.append(line) += '\n';
    }
    if (!keep_written(x)) return Flow::Fault;
    if (!written) written = &x.modal.written.emplace_back(WrittenProgram{number, {}, {}});
    if (text.empty()) text = "%" + title + ",MX,\n";
    written->title = title;
    written->text = std::make_shared<const std::string>(std::move(text));
    x.modal.writing = number;
    return Flow::Done;
}

// ISO words take the values of their parameters; in a statement only parameters behind ? do.
Flow write_statement(Execution& x, std::string_view, const char*& at, const char* end) {
    if (x.modal.writing < 0)
        return flow_fault(x, Alarm::FagorWriteClosed, at == end ? at - 1 : at, 1);
    blanks(at, end);
    const std::string_view block(at, static_cast<std::size_t>(end - at));
    // behind skip signs and a label too
    const bool statement = block.substr(0, block.find(';')).find('(') != std::string_view::npos;
    for (WrittenProgram& program : x.modal.written) {
        if (program.number != x.modal.writing) continue;
        std::string text = *program.text + with_parameters(x, block, statement) + '\n';
        program.text = std::make_shared<const std::string>(std::move(text));
    }
    at = end;
    return Flow::Done;
}

// The program that was open is complete: it goes into the machine's program memory, where there is
// one.
bool keep_written(Execution& x) {
    if (x.modal.writing < 0 || !x.programs.files.keeps() || x.ahead.reads_profile ||
        x.ahead.scans_loops)
        return true;
    for (const WrittenProgram& program : x.modal.written)
        if (program.number == x.modal.writing &&
            !x.programs.files.keep(fmt::format("{:06}.PIT", program.number), *program.text))
            return x.fail(Alarm::FileUnreadable, 0, fmt::format("{:06}.PIT", program.number));
    return true;
}

}  // namespace polyturn::channels::fagor
