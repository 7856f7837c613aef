// The head of a block: skip level, block number, labels.
#include "channels/sinumerik/grammar/head.hpp"

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/variables/variables.hpp"
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::sinumerik {

// Skip level, block number, labels.
bool parse_head(Execution& x, bool& skipped) {
    while (x.line.cursor.peek() == '/') {
        const char* const from = x.line.cursor.at();
        x.line.cursor.advance(1);
        unsigned level = 0;
        if (is_digit(x.line.cursor.next_raw())) {
            level = static_cast<unsigned>(x.line.cursor.next_raw() - '0');
            x.line.cursor.advance(1);
            if (is_digit(x.line.cursor.next_raw()))
                return fail_at(x, Alarm::SkipLevelIllegal, from, 3);
        }
        if (x.core.port().block_skip(level + 1)) skipped = true;
        // one level in a block
        if (x.line.cursor.peek() == '/')
            return fail_at(x, Alarm::SkipLevelIllegal, x.line.cursor.at(), 1);
    }
    if (skipped) return true;
    const char c = x.line.cursor.peek();
    Cursor number = x.line.cursor;
    if (c == ':' || c == 'N' || c == 'n') {
        number.advance(1);
        number.skip();
        if (is_digit(number.next_raw())) {
            double value = 0;
            while (is_digit(number.next_raw())) {
                value = value * 10 + (number.next_raw() - '0');
                number.advance(1);
            }
            if (value > 99999999)
                return fail_at(x, Alarm::DigitsTooMany, x.line.cursor.at(), 1, "N");
            if (is_name_start(number.next_raw()) || is_blank(number.next_raw()) ||
                number.at_end() || !number.at_assign()) {
                x.core.at.block = x.modal.last_number = static_cast<std::int64_t>(value);
                x.line.cursor = number;
            }
        } else if (c == ':') {
            return syntax(x, x.line.cursor.at(), ":");
        }
    }
    for (;;) {  // labels
        const std::string_view name = x.line.cursor.name_ahead();
        if (name.size() < 2) return true;
        Cursor after = x.line.cursor;
        after.advance(name.size());
        if (after.peek() != ':') return true;
        const std::string word = upper(name);
        after.eat(':');
        // GOTOF :20
        if (find_symbol(word).kind == Symbol::Kind::Statement && is_digit(after.peek()))
            return true;
        if (word != "ENDLABEL" &&
            (find_symbol(word).kind != Symbol::Kind::None || is_digit(name[1])))
            return fail_at(x, Alarm::NameReserved, x.line.cursor.at(), name.size(), word);
        // one name, one thing
        if (find_variable(x, word))
            return fail_at(x, Alarm::NameTwice, x.line.cursor.at(), name.size(), word);
        x.line.cursor = after;
    }
}
}  // namespace polyturn::channels::sinumerik
