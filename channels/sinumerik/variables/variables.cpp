// Names of variables, their elements, assignments.
#include "channels/sinumerik/variables/variables.hpp"

#include <cmath>
#include <limits>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/frames/settable_frames.hpp"
#include "channels/sinumerik/grammar/expression.hpp"
#include "channels/sinumerik/tools/managed_tools.hpp"
#include "channels/sinumerik/variables/changes.hpp"

namespace polyturn::channels::sinumerik {
namespace {

std::string reference_name(const Execution& x, const Reference& reference) {
    const Variable& variable = *reference.variable;
    if (reference.variable == x.names.r) return "R" + std::to_string(reference.element);
    if (variable.dimensions.empty()) return variable.name;
    std::string text;
    std::size_t rest = reference.element;
    for (std::size_t i = variable.dimensions.size(); i-- > 0;) {
        text = std::to_string(rest % variable.dimensions[i]) + (text.empty() ? "" : ",") + text;
        rest /= variable.dimensions[i];
    }
    return variable.name + "[" + text + "]";
}

// $A_OUT[1] to $A_OUT[32]: the bits of the register that macros write as #1100 and on.
void tell_outputs(Execution& x) {
    std::uint32_t bits = 0;
    for (unsigned n = 1; n <= 32; ++n)
        if (const auto written = x.names.system.find("$A_OUT[" + std::to_string(n) + "]");
            written != x.names.system.end() && written->second.number != 0)
            bits |= 1u << (n - 1);
    x.core.signal("CN_UOUT", bits);
}

}  // namespace

Reference find_variable(const Execution& x, std::string_view name) {
    for (auto level = x.calls.levels.rbegin(); level != x.calls.levels.rend(); ++level) {
        if (level->section) continue;  // shares the names of its program
        const auto found = level->scope->names.find(name);
        if (found != level->scope->names.end()) return found->second;
        break;
    }
    if (const auto found = x.names.of_channel->names.find(name);
        found != x.names.of_channel->names.end())
        return found->second;
    return {};
}

// A variable with its index at the cursor. When there is none, the cursor stays and the
// reference is null.
bool reference_ahead(Execution& x, Reference& reference) {
    reference = {};
    x.line.cursor.skip();
    const char* const from = x.line.cursor.at();
    const bool dollar = x.line.cursor.peek() == '$';
    if (dollar) {
        if (upper(x.line.cursor.next_raw(1)) != 'R' || is_name_start(x.line.cursor.next_raw(2)))
            return true;
        x.line.cursor.advance(1);
    }
    const std::string_view name = x.line.cursor.name_ahead();
    if (name.empty()) {
        x.line.cursor.at() = from;
        return true;
    }
    const std::string word = upper(name);
    if (word[0] == 'R') {  // R5, R[expression]
        bool digits = word.size() > 1;
        std::size_t number = 0;
        for (std::size_t i = 1; i < word.size(); ++i) {
            digits = digits && is_digit(word[i]);
            if (digits && number < 1'000'000)
                number = number * 10 + static_cast<std::size_t>(word[i] - '0');
        }
        const bool indexed =
            word.size() == 1 && name.data()[1] == '[' && name.data() + 1 < x.line.cursor.end();
        if (digits || indexed) {
            x.line.cursor.advance(name.size());
            if (indexed) {
                std::vector<Value> indices;
                if (!index_list(x, indices)) return false;
                if (indices.size() != 1 || !indices[0].is_number())
                    return fail_at(x, Alarm::ArrayIndexIllegal, from, 2, "R");
                if (indices[0].number < -0.5)
                    return fail_at(x, Alarm::ArrayIndexIllegal, from, 2, "R", indices[0].number);
                number = static_cast<std::size_t>(std::nearbyint(std::min(indices[0].number, 1e6)));
            }
            if (number >= x.names.r->cells.size())
                return fail_at(x, Alarm::VariableNumberIllegal, from, name.size(),
                               "R" + std::to_string(number), static_cast<double>(number),
                               static_cast<double>(x.names.r->cells.size() - 1));
            reference = {x.names.r, number, false};
            return true;
        }
    }
    Reference found = find_variable(x, word);
    if (!found) {
        x.line.cursor.at() = from;
        return true;
    }
    x.line.cursor.advance(name.size());
    if (x.line.cursor.peek() == '[' && (found.whole || found.variable->dimensions.empty())) {
        std::vector<Value> indices;
        if (!index_list(x, indices)) return false;
        // TEXT[i] means a character; a frame variable's components are the geometry's.
        if (found.variable->type == Type::String &&
            indices.size() == found.variable->dimensions.size() + 1) {
            found.component.assign(indices.end() - 1, indices.end());
            indices.pop_back();
        }
        if (found.variable->type == Type::Frame &&
            indices.size() == found.variable->dimensions.size() + 2) {
            found.component.assign(indices.end() - 2, indices.end());
            indices.resize(indices.size() - 2);
        }
        if (!element_of(x, *found.variable, indices, from, found.element)) return false;
        found.whole = false;
    }
    reference = std::move(found);
    return true;
}

bool index_list(Execution& x, std::vector<Value>& indices) {
    if (!x.line.cursor.eat('[')) return syntax(x, x.line.cursor.at(), "[");
    for (;;) {
        Value value;
        // $P_PFRAME[X,TR]: a component of a frame by its name
        const std::string part = upper(x.line.cursor.name_ahead());
        if (!indices.empty() &&
            (part == "TR" || part == "FI" || part == "RT" || part == "SC" || part == "MI") &&
            !find_variable(x, part)) {
            x.line.cursor.advance(part.size());
            value = Value::of_text(part);
        } else if (!expression(x, value)) {
            return false;
        }
        indices.push_back(std::move(value));
        if (x.line.cursor.eat(']')) return true;
        if (!x.line.cursor.eat(',') || indices.size() == 4)
            return syntax(x, x.line.cursor.at(), "]");
    }
}

bool element_of(Execution& x, const Variable& variable, const std::vector<Value>& indices,
                const char* at, std::size_t& element) {
    if (indices.size() != variable.dimensions.size())
        return fail_at(x, Alarm::ArrayIndexMissing, at, 1, variable.name);
    element = 0;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (!indices[i].is_number())
            return fail_at(x, Alarm::ArrayIndexIllegal, at, 1, variable.name);
        const double index = std::nearbyint(indices[i].number);
        if (!(index >= 0 && index < variable.dimensions[i]))
            return fail_at(x, Alarm::ArrayIndexIllegal, at, 1, variable.name, index);
        element = element * variable.dimensions[i] + static_cast<std::size_t>(index);
    }
    return true;
}

// Which character TEXT[i] names; there must be one.
bool character_of(Execution& x, const Reference& reference, const char* at, std::size_t& i) {
    const Value& index = reference.component.front();
    const std::string& text = reference.cell().text;
    if (!index.is_number() ||
        !(index.number >= 0 && std::nearbyint(index.number) < static_cast<double>(text.size())))
        return fail_at(x, Alarm::ArrayIndexIllegal, at, 1, reference.variable->name, index.number);
    i = static_cast<std::size_t>(std::nearbyint(index.number));
    return true;
}

void store(Execution& x, const Reference& reference, Value value) {
    Value& cell = reference.cell();
    if (cell.number != value.number || cell.text != value.text || value.frame) x.core.did();
    undo(x, [variable = reference.variable, element = reference.element, before = cell] {
        variable->cells[element] = before;
    });
    cell = std::move(value);
    x.changes.written.push_back({reference_name(x, reference), cell});
}

bool assign(Execution& x, const Reference& reference, Value value, const char* at) {
    const Variable& variable = *reference.variable;
    const Type from = value.type;
    // no axis
    if (variable.type == Type::Axis && from == Type::Int && value.number == 0)
        value = Value::of_axis(-1, {});
    else if (!convert(value, variable.type))
        return fail_at(x, Alarm::ConversionImpossible, at, 1,
                       variable.name + ": " + std::string(type_name(from)) + ", " +
                           std::string(type_name(variable.type)));
    if (variable.type == Type::String && value.text.size() > variable.text_length)
        return fail_at(x, Alarm::TextTooLong, at, 1, variable.name,
                       static_cast<double>(variable.text_length));
    if ((variable.has_lower && value.number < variable.lower) ||
        (variable.has_upper && value.number > variable.upper))
        return fail_at(x, Alarm::ValueOutOfRange, at, 1, variable.name + " = " + to_text(value));
    store(x, reference, std::move(value));
    return true;
}

// Behind the name: = value; an array takes SET(a, b), (a, b), REP(a[, count]).
bool assignment(Execution& x, const Reference& reference) {
    if (!x.line.cursor.at_assign()) return syntax(x, x.line.cursor.at(), "=");
    x.line.cursor.advance(1);
    x.line.cursor.skip();
    const char* const at = x.line.cursor.at();
    const std::string word = upper(x.line.cursor.name_ahead());
    const bool list =
        reference.whole && !reference.variable->dimensions.empty() && x.line.cursor.peek() == '(';
    if (word == "REP" || word == "SET" || list) {
        if (reference.variable->dimensions.empty() && reference.variable != x.names.r)
            return syntax(x, at, word);
        if (!word.empty() && (word == "REP" || word == "SET")) x.line.cursor.advance(3);
        if (!x.line.cursor.eat('(')) return syntax(x, x.line.cursor.at(), "(");
        std::vector<std::optional<Value>> values;
        for (;;) {
            if (x.line.cursor.peek() == ',') {
                values.emplace_back();  // this element keeps its value
            } else {
                Value value;
                if (!expression(x, value)) return false;
                values.emplace_back(std::move(value));
            }
            if (x.line.cursor.eat(')')) break;
            if (!x.line.cursor.eat(',')) return syntax(x, x.line.cursor.at(), ")");
        }
        const std::size_t first = reference.whole ? 0 : reference.element,
                          size = reference.variable->cells.size();
        std::size_t count = values.size();
        if (word == "REP") {
            count = size - first;
            if (values.size() > 1 && values[1])
                count = static_cast<std::size_t>(std::max(0.0, std::min(values[1]->number, 1e6)));
        }
        if (first + count > size)
            return fail_at(x, Alarm::ArrayIndexIllegal, at, 1, reference.variable->name,
                           static_cast<double>(first + count - 1));
        for (std::size_t i = 0; i < count; ++i) {
            const auto& value = values[word == "REP" ? 0 : i];
            if (value && !assign(x, {reference.variable, first + i, false}, *value, at))
                return false;
        }
        return true;
    }
    if (reference.whole && !reference.variable->dimensions.empty())
        return fail_at(x, Alarm::ArrayIndexMissing, at, 1, reference.variable->name);
    Value value;
    if (!reference.component.empty() && reference.variable->type == Type::String) {
        std::size_t i = 0;
        Value text = reference.cell();
        if (!character_of(x, reference, at, i) || !expression(x, value)) return false;
        if (!convert(value, Type::Char))
            return fail_at(x, Alarm::ConversionImpossible, at, 1, reference.variable->name);
        text.text[i] = static_cast<char>(value.number);
        store(x, reference, std::move(text));
        return true;
    }
    if (!reference.component.empty()) {
        FrameValue frame = reference.cell().frame ? *reference.cell().frame : FrameValue{};
        if (!expression(x, value) || !change_frame_component(x, reference.variable->name, frame,
                                                             reference.component, 0, value))
            return false;
        store(x, reference, Value::of_frame(frame));
        return true;
    }
    return expression(x, value) && assign(x, reference, std::move(value), at);
}

void report_variable(Execution& x, const std::string& name, const Value& value) {
    if (name.starts_with("$TC_")) tell_tool(x, name, value);
    if (name.starts_with("$A_OUT[")) tell_outputs(x);
    x.core.mark_emitted();
    channels::Variable told{
        name, value.is_number() ? value.number : std::numeric_limits<double>::quiet_NaN()};
    if (value.type == Type::String || (value.type == Type::Axis && value.place() >= 0)) {
        told.is_text = true;
        told.text = value.text;
    }
    x.core.sink().variable(told, x.core.at);
}

// The outputs as they are switched, whoever has written them: what was read ahead when a program
// was reset has written none.
void look_at_outputs(Execution& x) {
    const auto bits =
        static_cast<std::uint32_t>(static_cast<std::int64_t>(x.core.port().interface_value(1132)));
    for (unsigned n = 1; n <= 32; ++n) {
        const std::string name = "$A_OUT[" + std::to_string(n) + "]";
        if (const bool on = bits >> (n - 1) & 1u; on || x.names.system.contains(name))
            x.names.system[name] = Value::of_real(on ? 1.0 : 0.0);
    }
}

}  // namespace polyturn::channels::sinumerik
