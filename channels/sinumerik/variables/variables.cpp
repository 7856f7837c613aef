// Names of variables, their elements, assignments.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

Reference Interpreter::find_variable(std::string_view name) const {
    for (auto level = levels_.rbegin(); level != levels_.rend(); ++level) {
        if (level->section) continue;  // shares the names of its program
        const auto found = level->scope->names.find(name);
        if (found != level->scope->names.end()) return found->second;
        break;
    }
    if (const auto found = channel_scope_->names.find(name); found != channel_scope_->names.end())
        return found->second;
    return {};
}

// A variable with its index at the cursor. When there is none, the cursor stays and the
// reference is null.
bool Interpreter::reference_ahead(Reference& reference) {
    reference = {};
    cursor_.skip();
    const char* const from = cursor_.at();
    const bool dollar = cursor_.peek() == '$';
    if (dollar) {
        if (upper(cursor_.next_raw(1)) != 'R' || is_name_start(cursor_.next_raw(2))) return true;
        cursor_.advance(1);
    }
    const std::string_view name = cursor_.name_ahead();
    if (name.empty()) {
        cursor_.at() = from;
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
            word.size() == 1 && name.data()[1] == '[' && name.data() + 1 < cursor_.end();
        if (digits || indexed) {
            cursor_.advance(name.size());
            if (indexed) {
                std::vector<Value> indices;
                if (!index_list(indices)) return false;
                if (indices.size() != 1 || !indices[0].is_number())
                    return fail_at(Alarm::ArrayIndexIllegal, from, 2, "R");
                if (indices[0].number < -0.5)
                    return fail_at(Alarm::ArrayIndexIllegal, from, 2, "R", indices[0].number);
                number = static_cast<std::size_t>(std::nearbyint(std::min(indices[0].number, 1e6)));
            }
            if (number >= r_->cells.size())
                return fail_at(Alarm::VariableNumberIllegal, from, name.size(),
                               "R" + std::to_string(number), static_cast<double>(number),
                               static_cast<double>(r_->cells.size() - 1));
            reference = {r_, number, false};
            return true;
        }
    }
    Reference found = find_variable(word);
    if (!found) {
        cursor_.at() = from;
        return true;
    }
    cursor_.advance(name.size());
    if (cursor_.peek() == '[' && (found.whole || found.variable->dimensions.empty())) {
        std::vector<Value> indices;
        if (!index_list(indices)) return false;
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
        if (!element_of(*found.variable, indices, from, found.element)) return false;
        found.whole = false;
    }
    reference = std::move(found);
    return true;
}

bool Interpreter::index_list(std::vector<Value>& indices) {
    if (!cursor_.eat('[')) return syntax(cursor_.at(), "[");
    for (;;) {
        Value value;
        // $P_PFRAME[X,TR]: a component of a frame by its name
        const std::string part = upper(cursor_.name_ahead());
        if (!indices.empty() &&
            (part == "TR" || part == "FI" || part == "RT" || part == "SC" || part == "MI") &&
            !find_variable(part)) {
            cursor_.advance(part.size());
            value = Value::of_text(part);
        } else if (!expression(value)) {
            return false;
        }
        indices.push_back(std::move(value));
        if (cursor_.eat(']')) return true;
        if (!cursor_.eat(',') || indices.size() == 4) return syntax(cursor_.at(), "]");
    }
}

bool Interpreter::element_of(const Variable& variable, const std::vector<Value>& indices,
                             const char* at, std::size_t& element) {
    if (indices.size() != variable.dimensions.size())
        return fail_at(Alarm::ArrayIndexMissing, at, 1, variable.name);
    element = 0;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (!indices[i].is_number()) return fail_at(Alarm::ArrayIndexIllegal, at, 1, variable.name);
        const double index = std::nearbyint(indices[i].number);
        if (!(index >= 0 && index < variable.dimensions[i]))
            return fail_at(Alarm::ArrayIndexIllegal, at, 1, variable.name, index);
        element = element * variable.dimensions[i] + static_cast<std::size_t>(index);
    }
    return true;
}

// Which character TEXT[i] names; there must be one.
bool Interpreter::character_of(const Reference& reference, const char* at, std::size_t& i) {
    const Value& index = reference.component.front();
    const std::string& text = reference.cell().text;
    if (!index.is_number() ||
        !(index.number >= 0 && std::nearbyint(index.number) < static_cast<double>(text.size())))
        return fail_at(Alarm::ArrayIndexIllegal, at, 1, reference.variable->name, index.number);
    i = static_cast<std::size_t>(std::nearbyint(index.number));
    return true;
}

std::string Interpreter::reference_name(const Reference& reference) const {
    const Variable& variable = *reference.variable;
    if (reference.variable == r_) return "R" + std::to_string(reference.element);
    if (variable.dimensions.empty()) return variable.name;
    std::string text;
    std::size_t rest = reference.element;
    for (std::size_t i = variable.dimensions.size(); i-- > 0;) {
        text = std::to_string(rest % variable.dimensions[i]) + (text.empty() ? "" : ",") + text;
        rest /= variable.dimensions[i];
    }
    return variable.name + "[" + text + "]";
}

void Interpreter::undo(std::function<void()> back) {
    if (reading_) block_undo_.push_back(back);
    if (keep_states_) undo_log_.emplace_back(serial_, std::move(back));
}

void Interpreter::store(const Reference& reference, Value value) {
    Value& cell = reference.cell();
    if (cell.number != value.number || cell.text != value.text || value.frame) core_.did();
    undo([variable = reference.variable, element = reference.element, before = cell] {
        variable->cells[element] = before;
    });
    cell = std::move(value);
    written_.push_back({reference_name(reference), cell});
}

bool Interpreter::assign(const Reference& reference, Value value, const char* at) {
    const Variable& variable = *reference.variable;
    const Type from = value.type;
    // no axis
    if (variable.type == Type::Axis && from == Type::Int && value.number == 0)
        value = Value::of_axis(-1, {});
    else if (!convert(value, variable.type))
        return fail_at(Alarm::ConversionImpossible, at, 1,
                       variable.name + ": " + std::string(type_name(from)) + ", " +
                           std::string(type_name(variable.type)));
    if (variable.type == Type::String && value.text.size() > variable.text_length)
        return fail_at(Alarm::TextTooLong, at, 1, variable.name,
                       static_cast<double>(variable.text_length));
    if ((variable.has_lower && value.number < variable.lower) ||
        (variable.has_upper && value.number > variable.upper))
        return fail_at(Alarm::ValueOutOfRange, at, 1, variable.name + " = " + to_text(value));
    store(reference, std::move(value));
    return true;
}

// Behind the name: = value; an array takes SET(a, b), (a, b), REP(a[, count]).
bool Interpreter::assignment(const Reference& reference) {
    if (!cursor_.at_assign()) return syntax(cursor_.at(), "=");
    cursor_.advance(1);
    cursor_.skip();
    const char* const at = cursor_.at();
    const std::string word = upper(cursor_.name_ahead());
    const bool list =
        reference.whole && !reference.variable->dimensions.empty() && cursor_.peek() == '(';
    if (word == "REP" || word == "SET" || list) {
        if (reference.variable->dimensions.empty() && reference.variable != r_)
            return syntax(at, word);
        if (!word.empty() && (word == "REP" || word == "SET")) cursor_.advance(3);
        if (!cursor_.eat('(')) return syntax(cursor_.at(), "(");
        std::vector<std::optional<Value>> values;
        for (;;) {
            if (cursor_.peek() == ',') {
                values.emplace_back();  // this element keeps its value
            } else {
                Value value;
                if (!expression(value)) return false;
                values.emplace_back(std::move(value));
            }
            if (cursor_.eat(')')) break;
            if (!cursor_.eat(',')) return syntax(cursor_.at(), ")");
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
            return fail_at(Alarm::ArrayIndexIllegal, at, 1, reference.variable->name,
                           static_cast<double>(first + count - 1));
        for (std::size_t i = 0; i < count; ++i) {
            const auto& value = values[word == "REP" ? 0 : i];
            if (value && !assign({reference.variable, first + i, false}, *value, at)) return false;
        }
        return true;
    }
    if (reference.whole && !reference.variable->dimensions.empty())
        return fail_at(Alarm::ArrayIndexMissing, at, 1, reference.variable->name);
    Value value;
    if (!reference.component.empty() && reference.variable->type == Type::String) {
        std::size_t i = 0;
        Value text = reference.cell();
        if (!character_of(reference, at, i) || !expression(value)) return false;
        if (!convert(value, Type::Char))
            return fail_at(Alarm::ConversionImpossible, at, 1, reference.variable->name);
        text.text[i] = static_cast<char>(value.number);
        store(reference, std::move(text));
        return true;
    }
    if (!reference.component.empty()) {
        FrameValue frame = reference.cell().frame ? *reference.cell().frame : FrameValue{};
        if (!expression(value) ||
            !change_frame_component(reference.variable->name, frame, reference.component, 0, value))
            return false;
        store(reference, Value::of_frame(frame));
        return true;
    }
    return expression(value) && assign(reference, std::move(value), at);
}

void Interpreter::report_variable(const std::string& name, const Value& value) {
    if (name.starts_with("$TC_")) tell_tool(name, value);
    if (name.starts_with("$A_OUT[")) tell_outputs();
    core_.mark_emitted();
    channels::Variable told{
        name, value.is_number() ? value.number : std::numeric_limits<double>::quiet_NaN()};
    if (value.type == Type::String || (value.type == Type::Axis && value.place() >= 0)) {
        told.is_text = true;
        told.text = value.text;
    }
    core_.sink().variable(told, core_.at);
}

// $A_OUT[1] to $A_OUT[32]: the bits of the register that macros write as #1100 and on.
void Interpreter::tell_outputs() {
    std::uint32_t bits = 0;
    for (unsigned n = 1; n <= 32; ++n)
        if (const auto written = written_system_.find("$A_OUT[" + std::to_string(n) + "]");
            written != written_system_.end() && written->second.number != 0)
            bits |= 1u << (n - 1);
    core_.signal("CN_UOUT", bits);
}

// The outputs as they are switched, whoever has written them: what was read ahead when a program
// was reset has written none.
void Interpreter::look_at_outputs() {
    const auto bits =
        static_cast<std::uint32_t>(static_cast<std::int64_t>(core_.port().interface_value(1132)));
    for (unsigned n = 1; n <= 32; ++n) {
        const std::string name = "$A_OUT[" + std::to_string(n) + "]";
        if (const bool on = bits >> (n - 1) & 1u; on || written_system_.contains(name))
            written_system_[name] = Value::of_real(on ? 1.0 : 0.0);
    }
}

bool Interpreter::preset_variable(std::string_view name, double value) {
    const std::string word = upper(name);
    if (word.size() > 1 && word[0] == 'R') {
        std::size_t number = 0;
        for (std::size_t i = 1; i < word.size(); ++i) {
            if (!is_digit(word[i])) return false;
            number = number * 10 + static_cast<std::size_t>(word[i] - '0');
            if (number >= r_->cells.size()) return false;
        }
        r_->cells[number] = Value::of_real(value);
        return true;
    }
    if (!word.empty() && word[0] == '$') {
        written_system_[word] = Value::of_real(value);
        return true;
    }
    return false;
}

// STRING variables are declared by the program itself: there is nothing that a text could be
// entered into before.
bool Interpreter::preset_text(std::string_view, std::string_view) { return false; }

bool Interpreter::preset_tool(int number, std::string_view name) {
    if (number < 1 || number > 32000) return false;
    tools_[number].name = name;
    return true;
}

// DP1 to DP35, DPNT.
bool Interpreter::preset_edge(int tool, int edge, std::string_view parameter, double value) {
    const std::string word = upper(parameter);
    if (tool < 1 || tool > 32000 || edge < 1 || !word.starts_with("DP")) return false;
    Edge& entry = tools_[tool].edges[edge];
    if (word == "DPNT") {
        entry.teeth = value;
        return true;
    }
    unsigned number = 0;
    for (const char c : word.substr(2)) {
        if (!is_digit(c) || number > 99) return false;
        number = number * 10 + static_cast<unsigned>(c - '0');
    }
    if (number < 1 || number >= kEdgeParameters) return false;
    entry.dp[number] = value;
    return true;
}

}  // namespace polyturn::channels::sinumerik
