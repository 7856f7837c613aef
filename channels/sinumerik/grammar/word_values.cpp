// Index and value of one word.
#include "channels/sinumerik/grammar/word_values.hpp"

#include <cmath>

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/grammar/expression.hpp"
#include "channels/sinumerik/grammar/words.hpp"
#include "channels/sinumerik/variables/variables.hpp"
#include "channels/text/number.hpp"

namespace polyturn::channels::sinumerik {

// [axis], [2], [SPI(2)], [S2]
bool read_index(Execution& x, Word& word, const Address& address) {
    x.line.cursor.skip();
    const char* const from = x.line.cursor.at();
    std::vector<Value> indices;
    if (!index_list(x, indices)) return false;
    if (address.name == "FMA" && indices.size() == 2) {  // which input, then the axis
        if (!indices[0].is_number() || !(indices[0].number >= 2 && indices[0].number <= 7))
            return fail_at(x, Alarm::ArrayIndexIllegal, from, 1, "FMA", indices[0].number);
        indices.erase(indices.begin());
    }
    if (indices.size() != 1 || address.index == Address::Index::None)
        return fail_at(x, Alarm::ArrayIndexIllegal, from, 1, std::string(address.name));
    const Value& index = indices[0];
    if (index.type == Type::Axis) {
        if (index.place() >= kSpindleAxis) {
            word.index = index.place() - kSpindleAxis;
            word.spindle = true;
        } else {
            word.axis = index.place();
        }
        if (address.index == Address::Index::Number)
            return fail_at(x, Alarm::ArrayIndexIllegal, from, 1, std::string(address.name));
        return true;
    }
    if (!index.is_number() || address.index == Address::Index::Axis)
        return fail_at(x, Alarm::ArrayIndexIllegal, from, 1, std::string(address.name));
    if (!(index.number >= 0 && index.number <= 99))
        return fail_at(x, Alarm::ArrayIndexIllegal, from, 1, std::string(address.name),
                       index.number);
    word.index = static_cast<std::int32_t>(std::nearbyint(index.number));
    word.spindle = address.index == Address::Index::Spindle;
    return true;
}
bool read_value(Execution& x, Word& word) {
    if (!x.line.cursor.at_assign()) {  // one letter and a number
        x.line.cursor.skip();
        const char* const from = x.line.cursor.at();
        // An axis of which no value is wanted is not known here: a name without a value is a
        // mistake.
        const ScannedNumber scanned = scan_number(x.line.cursor.at(), x.line.cursor.end());
        switch (scanned.status) {
            case ScannedNumber::Status::Ok:
                break;
            case ScannedNumber::Status::SecondPoint:
                return fail_at(x, Alarm::SecondPoint, x.line.cursor.at(), 1);
            case ScannedNumber::Status::TooManyDigits:
                return fail_at(x, Alarm::DigitsTooMany, from, 1);
            case ScannedNumber::Status::Missing:
                return fail_at(x, Alarm::NumberMissing, from, 1,
                               word.address == &kAxisAddress ? axis_name(x, word.axis)
                                                             : std::string(word.address->name));
        }
        word.has_value = true;
        word.value =
            scanned.has_point ? Value::of_real(scanned.value) : Value::of_int(scanned.value);
        return true;
    }
    x.line.cursor.advance(1);
    const std::string_view name = x.line.cursor.name_ahead();
    if (!name.empty() && name.size() <= 4) {
        const std::string modifier = upper(name);
        Cursor after = x.line.cursor;
        after.advance(name.size());
        if (after.peek() == '(')
            for (const ModeName& row : kModes)
                if (row.name == modifier) {
                    x.line.cursor = after;
                    word.mode = row.mode;
                    break;
                }
    }
    word.has_value = true;
    const bool list = word.address->name == "POSP" || word.address->name == "MEASA" ||
                      word.address->name == "MEAWA";
    if (!list || word.mode != Mode::Plain || !x.line.cursor.eat('('))
        return expression(x, word.value);
    // (end, part, mode): values that belong together
    const std::string_view first = x.line.cursor.name_ahead();
    for (const ModeName& row : kModes) {
        Cursor after = x.line.cursor;
        after.advance(first.size());
        if (first.empty() || upper(first) != row.name || after.peek() != '(') continue;
        x.line.cursor = after;
        word.mode = row.mode;
        break;
    }
    if (!expression(x, word.value)) return false;
    while (x.line.cursor.eat(',')) {
        Value further;
        const char* const at = x.line.cursor.at();
        if (!expression(x, further)) return false;
        if (!further.is_number())
            return fail_at(x, Alarm::OperandTypeIllegal, at, 1, std::string(word.address->name));
        word.further.push_back(std::move(further));
    }
    return x.line.cursor.eat(')') || syntax(x, x.line.cursor.at(), ")");
}
}  // namespace polyturn::channels::sinumerik
