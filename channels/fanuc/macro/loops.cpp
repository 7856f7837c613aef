#include "channels/fanuc/macro/loops.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/macro/flow.hpp"
#include "channels/fanuc/macro/statement_words.hpp"
#include "channels/fanuc/program/search.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fanuc {

Flow loop_number(Execution& x, const char*& at, const char* end, std::uint8_t& number) {
    gap(at, end);
    const char* const begin = at;
    double value = 0.0;
    if (const Flow flow = evaluate_expression(x, at, end, value); flow != Flow::Done) return flow;
    if (value != 1 && value != 2 && value != 3) return flow_fault(x, Alarm::DoNumberIllegal, begin);
    number = static_cast<std::uint8_t>(value);
    return Flow::Done;
}

// The number of a loop that a block begins or ends, behind block number and skip signs: 0 neither.
// `ends`: it is an END.
std::uint8_t loop_word(std::string_view line, bool& ends) {
    const char* at = line.data();
    const char* const end = at + line.size();
    gap(at, end);
    while (at != end && *at == '/') {
        ++at;
        while (at != end && ((*at >= '0' && *at <= '9') || *at == ' ')) ++at;
    }
    if (at != end && capital(*at) == 'N') {
        ++at;
        while (at != end && (*at == ' ' || (*at >= '0' && *at <= '9'))) ++at;
    }
    ends = take(at, end, "END");
    if (!ends) {
        if (take(at, end, "WHILE")) {
            int depth = 0;
            for (gap(at, end); at != end; ++at) {
                if (*at == '(') at = std::find(at, end, ')');
                if (at == end) break;
                if (*at == '[') ++depth;
                if (*at == ']' && --depth == 0) break;
            }
            if (at != end) ++at;
        }
        if (!take(at, end, "DO")) return 0;
    }
    gap(at, end);
    return at != end && *at >= '1' && *at <= '3' ? static_cast<std::uint8_t>(*at - '0') : 0;
}

// Each DO from here on has its END, and they do not cross (fanuc_lathe 6.8). Looked at once for
// each place.
bool loops_nest(Execution& x, std::uint8_t number, std::size_t from) {
    const auto place =
        std::pair(x.calls.frames.back().file, x.text.source->position().offset + from);
    if (std::find(x.calls.checked_loops.begin(), x.calls.checked_loops.end(), place) !=
        x.calls.checked_loops.end())
        return true;
    const TextPosition here = x.text.source->position();
    const auto column = static_cast<std::uint32_t>(from) + 1;
    std::array<std::uint8_t, 3> open{number};
    std::size_t depth = 1;
    bool crossed = false;
    x.text.kept_line = x.text.line;  // reading on moves the window
    std::string_view line = x.text.kept_line;
    std::uint32_t last_line = here.line;
    for (std::size_t next = next_block(line, from); depth && !crossed;
         next = next_block(line, next)) {
        if (next == std::string_view::npos) {
            if (x.text.source->next(line) != LineSource::Status::Line) break;
            last_line = x.text.source->position().line;
            next = 0;
        }
        bool ends = false;
        const std::uint8_t word = loop_word(line.substr(next), ends);
        if (!word) continue;
        if (ends)
            crossed = open[--depth] != word;
        else if (crossed =
                     depth == open.size() ||
                     std::find(open.begin(), open.begin() + static_cast<std::ptrdiff_t>(depth),
                               word) != open.begin() + static_cast<std::ptrdiff_t>(depth);
                 !crossed)
            open[depth++] = word;
    }
    x.text.source->seek(here);
    if (x.text.source->next(x.text.line) != LineSource::Status::Line) x.text.line = {};
    if (!crossed && !depth) {
        if (x.calls.checked_loops.size() < 256) x.calls.checked_loops.push_back(place);
        return true;
    }
    x.words.culprit.line = crossed ? last_line : here.line;
    x.words.culprit.column = crossed ? 1 : column;
    x.words.culprit.length = 2;
    return x.core.fail(Alarm::DoEndMismatch);
}

// Goes on behind END number.
Flow skip_loop(Execution& x, std::uint8_t number, const char* from) {
    const TextPlace back = place_behind(x, x.text.behind);
    const std::size_t column = static_cast<std::size_t>(from - x.text.line.data());
    const std::uint32_t at_line = x.text.source->position().line;
    const JumpMemory::Place place{x.calls.frames.back().file, back.byte(), 0,
                                  -static_cast<std::int64_t>(number)};
    if (const TextPlace* known = x.calls.jumps.find(place)) {
        go_to(x, *known);
        return Flow::Done;
    }
    x.text.kept_line = x.text.line;  // searching moves the window
    std::string_view line = x.text.kept_line;
    for (std::size_t next = x.text.line_left ? x.text.behind : std::string_view::npos;;) {
        if (next == std::string_view::npos) {
            if (x.text.source->next(line) != LineSource::Status::Line) break;
            next = 0;
        }
        bool ends = false;
        const std::uint8_t word = loop_word(line.substr(next), ends);
        next = next_block(line, next);
        if (word != number || !ends) continue;  // N120 END1, /END1 too
        const TextPlace found = next == std::string_view::npos
                                    ? TextPlace(x.text.source->next_position())
                                    : TextPlace(x.text.source->position(), next);
        x.calls.jumps.remember(place, found);
        go_on_at(x, found);
        return Flow::Done;
    }
    x.text.source->seek(back);
    x.words.culprit.column = static_cast<std::uint32_t>(column) + 1;
    x.words.culprit.length = 5;
    x.words.culprit.line = at_line;
    x.text.line = x.text.kept_line;
    x.core.fail(Alarm::DoEndMismatch);
    return Flow::Fault;
}

}  // namespace polyturn::channels::fanuc
