#include "ipc/model/languages/cycle_block.hpp"

#include <algorithm>
#include <cmath>

#include "ipc/model/languages/block_text.hpp"

namespace polyturn::forms {
namespace {

Notation notation_of(const Dialect& dialect) {
    return dialect.speaks == kFagor       ? Notation::Fagor
           : dialect.speaks == kSinumerik ? Notation::Sinumerik
                                          : Notation::Family;
}
bool is_family(const Dialect& dialect) { return notation_of(dialect) == Notation::Family; }

bool has_any(const BlockText& block, std::string_view letters) {
    for (const char letter : letters)
        if (block.find({&letter, 1})) return true;
    return false;
}

// The value in the field's unit.
double value_of(const TextWord& word, const Field& field, const Dialect& dialect) {
    const bool no_point = !word.has_point;
    switch (field.unit) {
        case Unit::Length:
        case Unit::Diameter:
        case Unit::Rotary:
            return no_point && dialect.point_needed ? word.number * dialect.increment : word.number;
        case Unit::Fine:
            return no_point ? word.number * dialect.increment : word.number;
        case Unit::Lead:
            return no_point && dialect.point_needed
                       ? word.number * (dialect.speaks & kSeries15 ? 0.01 : 0.0001)
                       : word.number;
        case Unit::Thousandth:
            return no_point ? word.number * 0.001 : word.number;
        default:
            return word.number;
    }
}

std::string text_of(double value, const Field& field, const Dialect& dialect) {
    switch (field.unit) {
        case Unit::Fine:
            if (is_family(dialect)) return number_text(value / dialect.increment, 0, false);
            break;
        case Unit::Thousandth:
            return number_text(value * 1000.0, 0, false);
        case Unit::Count:
        case Unit::Label:
        case Unit::Choice:
        case Unit::Milliseconds:
        case Unit::Hundredths:
        case Unit::Tenths:
            return number_text(value, 0, false);
        case Unit::Degrees:
        case Unit::Plain:
        case Unit::Speed:
            return number_text(value, 4, false);
        default:
            break;
    }
    return number_text(value, decimals_of(field, dialect), is_family(dialect));
}

std::size_t place_of(const Form& form, const Field& field) {
    return static_cast<std::size_t>(&field - form.fields.data());
}

// Fields that are parts of one word.
long power(int digits) { return digits <= 0 ? 1 : 10 * power(digits - 1); }

int total_digits(const Form& form, const Field& of) {
    int total = 0;
    for (const Field& field : form.fields)
        if (field.address == of.address && field.block == of.block) total += field.digits;
    return total;
}

Value read_field(const BlockText& block, const Form& form, const Field& field,
                 const Dialect& dialect) {
    Value value;
    const TextWord* word =
        form.is_call() ? block.argument(place_of(form, field)) : block.find(field.address);
    if (!word && !field.increment.empty() && dialect.speaks & (kFanucA | kSeries15A))
        word = block.find(field.increment);
    if (!word) return value;
    value.set = true;
    if (!form.is_call() && word->address != field.address) value.address = word->address;
    if (!word->plain) {
        value.expression = word->value;
        return value;
    }
    if (field.digits) {
        const int behind = total_digits(form, field) - field.digit - field.digits;
        value.number =
            static_cast<double>(std::lround(word->number) / power(behind) % power(field.digits));
        return value;
    }
    value.number = value_of(*word, field, dialect);
    return value;
}

// The word that the fields of an address make together; empty: none.
std::string word_text(const Form& form, const std::vector<Value>& values, std::size_t i,
                      const Dialect& dialect) {
    const Field& field = form.fields[i];
    if (!field.digits) {
        if (!values[i].set) return {};
        return values[i].expression.empty() ? text_of(values[i].number, field, dialect)
                                            : values[i].expression;
    }
    long word = 0;
    bool any = false;
    const int total = total_digits(form, field);
    for (std::size_t k = 0; k < form.fields.size(); ++k) {
        const Field& other = form.fields[k];
        if (other.address != field.address || other.block != field.block) continue;
        if (!values[k].expression.empty()) return values[k].expression;
        any = any || values[k].set;
        word += std::lround(values[k].number) * power(total - other.digit - other.digits);
    }
    if (!any) return {};
    std::string out = std::to_string(word);
    return std::string(static_cast<std::size_t>(std::max(0, total - static_cast<int>(out.size()))),
                       '0') +
           out;
}

bool is_first_part(const Form& form, std::size_t i) {
    return form.fields[i].digits == 0 || form.fields[i].digit == 0;
}

std::string address_of(const Field& field, const Value& value) {
    return value.address.empty() ? std::string(field.address) : value.address;
}

std::string fresh_block(const Form& form, const CycleBlock& cycle, int block,
                        const Dialect& dialect) {
    BlockText line(std::string(form.code) + (form.is_call() ? "()" : ""), notation_of(dialect));
    for (std::size_t i = 0; i < form.fields.size(); ++i) {
        const Field& field = form.fields[i];
        if (field.block != block || !is_first_part(form, i)) continue;
        const std::string text = word_text(form, cycle.values, i, dialect);
        if (text.empty()) continue;
        if (form.is_call())
            line.set_argument(i, text);
        else
            line.set(address_of(field, cycle.values[i]), text);
    }
    return line.line();
}

bool any_set(const Form& form, const CycleBlock& cycle, int block) {
    for (std::size_t i = 0; i < form.fields.size(); ++i)
        if (form.fields[i].block == block && cycle.values[i].set) return true;
    return false;
}

bool is_set(const CycleBlock& cycle, std::string_view address) {
    for (std::size_t i = 0; i < cycle.values.size(); ++i)
        if (cycle.form->fields[i].address == address && cycle.values[i].set) return true;
    return false;
}

std::string changed_block(const std::string& line, const CycleBlock& before, const CycleBlock& now,
                          int block, const Dialect& dialect) {
    const Form& form = *now.form;
    BlockText text(line, notation_of(dialect));
    for (std::size_t i = 0; i < form.fields.size(); ++i) {
        const Field& field = form.fields[i];
        if (field.block != block || !is_first_part(form, i)) continue;
        bool same = true;
        for (std::size_t k = 0; k < form.fields.size(); ++k)
            if (form.fields[k].address == field.address && form.fields[k].block == field.block)
                same = same && before.values[k] == now.values[k];
        if (same) continue;
        if (form.is_call()) {
            const std::string argument = word_text(form, now.values, i, dialect);
            if (argument.empty())
                text.erase_argument(i);
            else
                text.set_argument(i, argument);
            continue;
        }
        const std::string address = address_of(field, now.values[i]);
        if (const std::string was = address_of(field, before.values[i]); was != address)
            text.erase(was);
        const std::string value = word_text(form, now.values, i, dialect);
        if (value.empty())
            text.erase(address);
        else
            text.set(address, value);
    }
    return text.line();
}

}  // namespace

int decimals_of(const Field& field, const Dialect& dialect) {
    if (field.whole()) return 0;
    switch (field.unit) {
        case Unit::FeedRate:
        case Unit::Lead:
        case Unit::Degrees:
        case Unit::Plain:
        case Unit::Speed:
            return 4;
        case Unit::Thousandth:
        case Unit::Seconds:
            return 3;
        default:
            break;
    }
    return std::max(0, static_cast<int>(std::lround(-std::log10(dialect.increment))));
}

std::optional<CycleBlock> read_cycle(const std::vector<std::string>& lines, int line,
                                     const Dialect& dialect) {
    const int count = static_cast<int>(lines.size());
    if (line < 0 || line >= count || !dialect.speaks) return std::nullopt;
    const auto block_at = [&](int at) {
        return BlockText(lines[static_cast<std::size_t>(at)], notation_of(dialect));
    };
    const auto neighbour = [&](int from, int step) {  // over empty lines and comments
        for (int at = from + step; at >= 0 && at < count; at += step)
            if (!block_at(at).empty()) return at;
        return -1;
    };
    const BlockText here = block_at(line);
    if (!here.plain()) return std::nullopt;
    std::optional<CycleBlock> found;
    std::ptrdiff_t most = -1;  // words of the one found
    each_form(dialect, [&](const Form& form) {
        if (!here.has_code(form.code)) return;
        CycleBlock cycle;
        cycle.form = &form;
        if (!form.two_blocks()) {
            cycle.line[0] = line;
        } else {
            const bool second = has_any(here, form.second);
            cycle.line[second ? 1 : 0] = line;
            const int other = neighbour(line, second ? -1 : 1);
            if (other >= 0) {
                const BlockText block = block_at(other);
                if (block.has_code(form.code) && has_any(block, form.second) != second)
                    cycle.line[second ? 0 : 1] = other;
            }
        }
        for (const Field& field : form.fields)
            cycle.values.push_back(
                cycle.line[field.block] < 0
                    ? Value{}
                    : read_field(block_at(cycle.line[field.block]), form, field, dialect));
        const auto words = std::count_if(cycle.values.begin(), cycle.values.end(),
                                         [](const Value& value) { return value.set; });
        if (words > most) {
            most = words;
            found = std::move(cycle);
        }
    });
    return found;
}

namespace {
bool is_length(Unit unit) {
    return unit == Unit::Length || unit == Unit::Diameter || unit == Unit::Fine ||
           unit == Unit::Lead || unit == Unit::FeedRate;
}
}  // namespace

CycleBlock new_cycle(const Form& form, const Dialect& dialect) {
    CycleBlock cycle;
    cycle.form = &form;
    for (const Field& field : form.fields) {
        Value value;
        if (const auto number = plain_number(field.preset)) {
            value.set = true;
            value.number = *number;
        }
        // what is proposed is no measure
        if (value.set && dialect.inch && is_length(field.unit))
            value.number = std::round(value.number / 25.4 * 1000) / 1000;
        cycle.values.push_back(std::move(value));
    }
    return cycle;
}

std::vector<FieldFault> check_cycle(const CycleBlock& cycle) {
    std::vector<FieldFault> out;
    for (std::size_t i = 0; i < cycle.values.size(); ++i) {
        const Field& field = cycle.form->fields[i];
        const Value& value = cycle.values[i];
        FieldFault fault;
        if (!value.set) {
            if (field.needed && !is_set(cycle, field.unless)) fault.kind = FieldFault::Missing;
            if (field.digits)  // parts of one word stand together
                for (std::size_t k = 0; k < cycle.values.size(); ++k)
                    if (cycle.form->fields[k].digits &&
                        cycle.form->fields[k].address == field.address &&
                        cycle.form->fields[k].block == field.block && cycle.values[k].set)
                        fault.kind = FieldFault::Missing;
        } else if (value.expression.empty()) {
            if (!std::isfinite(value.number))
                fault.kind = FieldFault::NoNumber;
            else if (value.number < field.low)
                fault = {FieldFault::TooSmall, field.low};
            else if (value.number > field.high)
                fault = {FieldFault::TooLarge, field.high};
            else if (field.whole() && value.number != std::floor(value.number))
                fault.kind = FieldFault::NotWhole;
        }
        out.push_back(fault);
    }
    return out;
}

std::vector<LineChange> write_cycle(const std::vector<std::string>& lines, const CycleBlock& before,
                                    const CycleBlock& now, int cursor, const Dialect& dialect) {
    std::vector<LineChange> out;
    const Form& form = *now.form;
    const int blocks = form.two_blocks() ? 2 : 1;
    const int anchor = before.line[1] >= 0   ? before.line[1]
                       : before.line[0] >= 0 ? before.line[0] + 1
                                             : cursor;
    for (int block = 0; block < blocks; ++block) {
        const int at = before.line[block];
        if (at >= 0) {
            const std::string text =
                changed_block(lines[static_cast<std::size_t>(at)], before, now, block, dialect);
            if (text != lines[static_cast<std::size_t>(at)]) out.push_back({at, false, text});
        } else if (any_set(form, now, block) || blocks == 1) {
            out.push_back({anchor, true, fresh_block(form, now, block, dialect)});
        }
    }
    return out;
}

void apply_changes(std::vector<std::string>& lines, const std::vector<LineChange>& changes) {
    int moved = 0;
    for (const LineChange& change : changes) {
        const auto at = lines.begin() + (change.at + moved);
        if (change.inserts) {
            lines.insert(at, change.text);
            ++moved;
        } else if (change.removes) {
            lines.erase(at);
            --moved;
        } else
            *at = change.text;
    }
}

}  // namespace polyturn::forms
