// What a handler says when it refuses: the alarm, and which part of the line is to blame.
#include "channels/sinumerik/faults.hpp"

#include <utility>

#include "channels/sinumerik/execution.hpp"
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::sinumerik {

bool fail_word(Execution& x, Alarm alarm, const Word& word, std::string detail, double v0,
               double v1) {
    x.blame.column = word.column;
    x.blame.length = word.length;
    return x.core.fail(alarm, 0, std::move(detail), v0, v1);
}
bool syntax(Execution& x, const char* at, std::string detail) {
    return fail_at(x, Alarm::SyntaxWrong, at, 1, std::move(detail));
}
bool fail_at(Execution& x, Alarm alarm, const char* from, std::size_t length, std::string detail,
             double v0, double v1) {
    x.blame.column = x.line.cursor.column(from);
    x.blame.length = length;
    return x.core.fail(alarm, 0, std::move(detail), v0, v1);
}
bool rest_must_be_empty(Execution& x) {
    return x.line.cursor.at_end() ||
           syntax(x, x.line.cursor.at(), std::string(1, x.line.cursor.peek()));
}
}  // namespace polyturn::channels::sinumerik
