// DEF, REDEF, DEFINE, PROC, EXTERN: names that a program brings with it.
#include "channels/sinumerik/variables/declarations.hpp"

#include <algorithm>

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/calls.hpp"
#include "channels/sinumerik/grammar/expression.hpp"
#include "channels/sinumerik/grammar/head.hpp"
#include "channels/sinumerik/spindles/speed_limits.hpp"
#include "channels/sinumerik/variables/changes.hpp"
#include "channels/sinumerik/variables/data_variables.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr std::size_t kLongestName = 31;
constexpr std::size_t kMostCells = 65536;
// what READ gives back (sinumerik_part3 7.16); 200 where no length is named (9.7)
constexpr double kLongestText = 255;

bool declare(Execution& x, const std::string& name, std::shared_ptr<Variable> variable,
             const char* at) {
    if (name.size() > kLongestName)
        return fail_at(x, Alarm::NameTooLong, at, name.size(), name, kLongestName);
    // Two letters or _ begin a name; one letter alone is allowed where it is no address.
    // fixed addresses without a row (sinumerik_part3 5.1)
    const bool letter = name == "N" || name == "R";
    if (letter || find_symbol(name).kind != Symbol::Kind::None || find_axis(x, name) >= 0 ||
        (name.size() > 1 && is_digit(name[1])))
        return fail_at(x, Alarm::NameReserved, at, name.size(), name);
    const std::shared_ptr<Scope> in = x.names.declares_for_channel ? x.names.of_channel : scope(x);
    if (in->names.contains(name) ||
        (!x.names.declares_for_channel && scope(x)->names.contains(name)))
        return fail_at(x, Alarm::NameTwice, at, name.size(), name);
    undo(x, [in, name] { in->names.erase(name); });
    in->names[name] = {std::move(variable), 0, true};
    return true;
}

// REDEF $SA_SPIND_MAX_VELO_LIMS PRLOC: the limit of a spindle's speed ends with the program
// (sinumerik_part1 7.3, 7.5).
bool redefine_data(Execution& x, const char* from) {
    x.line.cursor.advance(1);
    const std::string name = "$" + upper(x.line.cursor.name_ahead());
    x.line.cursor.advance(name.size() - 1);
    const params::Row* row = data_row(name);
    if (!row || !limits_spindle_speed(*row) || upper(x.line.cursor.name_ahead()) != "PRLOC")
        return fail_at(x, Alarm::NotBuilt, from, name.size(), "REDEF " + name);
    x.line.cursor.advance(5);
    undo(x, [&x, before = x.speed_limits.program_local] { x.speed_limits.program_local = before; });
    x.speed_limits.program_local.push_back(row);
    return true;
}

}  // namespace

bool parse_type(Execution& x, Type& type, std::size_t& length) {
    const char* const from = x.line.cursor.at();
    const std::string word = upper(x.line.cursor.name_ahead());
    constexpr Type kTypes[] = {Type::Bool,   Type::Char, Type::Int,  Type::Real,
                               Type::String, Type::Axis, Type::Frame};
    for (const Type t : kTypes) {
        if (word != type_name(t)) continue;
        x.line.cursor.advance(word.size());
        type = t;
        length = 200;
        if (t == Type::String && x.line.cursor.eat('[')) {
            Value value;
            if (x.line.cursor.eat(']')) return true;
            if (!expression(x, value)) return false;
            if (!value.is_number() || value.number < 1 || value.number > kLongestText)
                return fail_at(x, Alarm::ArrayIndexIllegal, from, word.size(), "STRING",
                               value.number);
            length = static_cast<std::size_t>(value.number);
            return x.line.cursor.eat(']') || syntax(x, x.line.cursor.at(), "]");
        }
        return true;
    }
    return syntax(x, from, word);
}

// DEF type name[dimensions] = value, name ...; DEF CHAN holds until the next cycle start, for all
// programs.
bool st_def(Execution& x) {
    bool has_lower = false, has_upper = false;
    double lower = 0, upper_limit = 0;
    int physical_unit = 0;
    x.names.declares_for_channel = false;
    for (;;) {
        // Variables are read and written in the order of the text, and made anew at each start: so
        // SYNR SYNW SYNRW and INIPO INIRE INICF PRLOC hold.
        static constexpr std::string_view kHold[] = {"CHAN",  "SYNR",  "SYNW",  "SYNRW",
                                                     "INIPO", "INIRE", "INICF", "PRLOC"};
        const std::string word = upper(x.line.cursor.name_ahead());
        if (word == "NCK")
            return fail_at(x, Alarm::NotBuilt, x.line.cursor.at(), word.size(), "DEF " + word);
        if (std::find(std::begin(kHold), std::end(kHold), word) == std::end(kHold)) break;
        x.names.declares_for_channel = x.names.declares_for_channel || word == "CHAN";
        x.line.cursor.advance(word.size());
    }
    Type type{};
    std::size_t length = 0;
    if (!parse_type(x, type, length)) return false;
    for (;;) {
        const std::string word = upper(x.line.cursor.name_ahead());
        if (word == "LLI" || word == "ULI") {
            x.line.cursor.advance(3);
            Value value;
            if (!expression(x, value)) return false;
            if (!value.is_number())
                return fail_at(x, Alarm::OperandTypeIllegal, x.line.cursor.at(), 1, word);
            (word == "LLI" ? has_lower : has_upper) = true;
            (word == "LLI" ? lower : upper_limit) = value.number;
        } else if (word == "PHU") {
            x.line.cursor.advance(3);
            Value value;
            if (!expression(x, value)) return false;
            if (!value.is_number())
                return fail_at(x, Alarm::OperandTypeIllegal, x.line.cursor.at(), 1, word);
            physical_unit = static_cast<int>(value.number);
        } else if (word.starts_with("APR") || word.starts_with("APW")) {
            return fail_at(x, Alarm::NotBuilt, x.line.cursor.at(), word.size(), word);
        } else {
            break;
        }
    }
    for (;;) {
        x.line.cursor.skip();
        const char* const at = x.line.cursor.at();
        const std::string name = upper(x.line.cursor.name_ahead());
        if (name.empty()) return syntax(x, at);
        x.line.cursor.advance(name.size());
        auto variable = std::make_shared<Variable>();
        variable->type = type;
        variable->text_length = length;
        variable->name = name;
        variable->has_lower = has_lower;
        variable->has_upper = has_upper;
        variable->lower = lower;
        variable->upper = upper_limit;
        variable->unit = physical_unit;
        std::size_t cells = 1;
        if (x.line.cursor.peek() == '[') {
            std::vector<Value> indices;
            if (!index_list(x, indices)) return false;
            if (indices.size() > 3)
                return fail_at(x, Alarm::ArrayIndexIllegal, at, name.size(), name,
                               static_cast<double>(indices.size()));
            for (const Value& index : indices) {
                if (!index.is_number() ||
                    !(index.number >= 1 && index.number <= static_cast<double>(kMostCells)))
                    return fail_at(x, Alarm::ArrayIndexIllegal, at, name.size(), name,
                                   index.number);
                variable->dimensions.push_back(static_cast<unsigned>(index.number));
                cells *= static_cast<std::size_t>(index.number);
                if (cells > kMostCells)
                    return fail_at(x, Alarm::ArrayIndexIllegal, at, name.size(), name,
                                   static_cast<double>(cells));
            }
        }
        Value initial;
        initial.type = type;
        if (type == Type::Frame) initial = Value::of_frame({});
        if (type == Type::Axis) initial = Value::of_axis(-1, {});
        if (has_lower) initial.number = std::max(initial.number, lower);
        variable->cells.assign(cells, initial);
        if (!declare(x, name, variable, at)) return false;
        if (x.line.cursor.at_assign()) {
            Reference reference{variable, 0, !variable->dimensions.empty()};
            const Cursor before = x.line.cursor;
            x.line.cursor.advance(1);
            const std::string word = upper(x.line.cursor.name_ahead());
            const bool list =
                word == "SET" || word == "REP" || (x.line.cursor.peek() == '(' && reference.whole);
            if (reference.whole && !list) {  // one value for all
                const char* const value_at = x.line.cursor.at();
                Value value;
                if (!expression(x, value)) return false;
                for (std::size_t i = 0; i < cells; ++i)
                    if (!assign(x, {variable, i, false}, value, value_at)) return false;
            } else {
                x.line.cursor = before;
                if (!assignment(x, reference)) return false;
            }
        }
        variable->defaults = variable->cells;
        if (x.line.cursor.at_end()) return true;
        if (!x.line.cursor.eat(','))
            return syntax(x, x.line.cursor.at(), std::string(1, x.line.cursor.peek()));
    }
}

// REDEF changes a variable's limits; what only concerns screens and protection is refused.
bool st_redef(Execution& x) {
    const char* const from = x.line.cursor.at();
    Reference reference;
    if (x.line.cursor.peek() == '$') return redefine_data(x, from);
    if (!reference_ahead(x, reference)) return false;
    if (!reference)
        return fail_at(x, Alarm::NameUnknown, from, 1, upper(x.line.cursor.name_ahead()));
    while (!x.line.cursor.at_end()) {
        const std::string word = upper(x.line.cursor.name_ahead());
        if (word != "LLI" && word != "ULI")
            return fail_at(x, Alarm::NotBuilt, x.line.cursor.at(),
                           std::max<std::size_t>(1, word.size()), "REDEF " + word);
        x.line.cursor.advance(3);
        Value value;
        const char* const at = x.line.cursor.at();
        double number = 0;
        if (!expression(x, value) || !number_of(x, value, at, number)) return false;
        Variable& variable = *reference.variable;
        undo(x, [keep = reference.variable, lower = variable.lower, upper = variable.upper,
                 has_lower = variable.has_lower, has_upper = variable.has_upper] {
            keep->lower = lower;
            keep->upper = upper;
            keep->has_lower = has_lower;
            keep->has_upper = has_upper;
        });
        (word == "LLI" ? variable.has_lower : variable.has_upper) = true;
        (word == "LLI" ? variable.lower : variable.upper) = number;
    }
    return true;
}

// DEFINE name AS text
bool st_define(Execution& x) {
    const char* const at = x.line.cursor.at();
    const std::string name = upper(x.line.cursor.name_ahead());
    if (name.empty()) return syntax(x, at);
    x.line.cursor.advance(name.size());
    if (name.size() > kLongestName)
        return fail_at(x, Alarm::NameTooLong, at, name.size(), name, kLongestName);
    if (find_symbol(name).kind != Symbol::Kind::None || find_axis(x, name) >= 0)
        return fail_at(x, Alarm::NameReserved, at, name.size(), name);
    if (x.names.macros.contains(name) || scope(x)->names.contains(name))
        return fail_at(x, Alarm::NameTwice, at, name.size(), name);
    if (upper(x.line.cursor.name_ahead()) != "AS") return syntax(x, x.line.cursor.at(), "AS");
    x.line.cursor.advance(2);
    x.line.cursor.skip();
    std::string text(x.line.cursor.at(), x.line.cursor.end());
    while (!text.empty() && is_blank(text.back())) text.pop_back();
    if (text.empty()) return syntax(x, x.line.cursor.at(), "AS");
    x.names.macros[name] = text;
    return true;
}

// The text of a line with its macros put in; a macro's own text is not looked through again, so
// that none can call itself.
void expand_macros(Execution& x) {
    std::string out;
    bool text = false;
    const bool defines = upper(x.line.text).find("DEFINE") != std::string::npos;
    if (defines) return;
    for (std::size_t i = 0; i < x.line.text.size();) {
        const char c = x.line.text[i];
        if (c == ';' && !text) {
            out.append(x.line.text, i);
            break;
        }
        if (c == '"') text = !text;
        if (text || !is_name_start(c)) {
            out += c;
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < x.line.text.size() && is_name(x.line.text[end])) ++end;
        const auto found =
            x.names.macros.find(upper(std::string_view(x.line.text).substr(i, end - i)));
        if (found == x.names.macros.end())
            out.append(x.line.text, i, end - i);
        else
            out += found->second;
        i = end;
    }
    x.line.text = std::move(out);
}

// The head of a program that is started as a main program: its parameters have their defaults.
bool st_proc(Execution& x) {
    // a second one, behind other blocks
    if (x.calls.levels.size() > 1) return syntax(x, x.line.cursor.at(), "PROC");
    x.line.cursor.at() = x.line.cursor.begin();
    bool skipped = false;
    if (!parse_head(x, skipped)) return false;
    std::vector<Argument> none;
    return read_proc(x, "PROC", none, x.calls.levels.back());
}

// EXTERN name(types): the program must exist; the types are those of its PROC line.
bool st_extern(Execution& x) {
    const char* const at = x.line.cursor.at();
    const std::string name = upper(x.line.cursor.name_ahead());
    if (name.empty()) return syntax(x, at);
    x.line.cursor.advance(name.size());
    if (x.line.cursor.eat('(') && !x.line.cursor.eat(')')) {
        for (;;) {
            if (upper(x.line.cursor.name_ahead()) == "VAR") x.line.cursor.advance(3);
            Type type{};
            std::size_t length = 0;
            if (!parse_type(x, type, length)) return false;
            if (is_name_start(x.line.cursor.peek()))
                x.line.cursor.advance(x.line.cursor.name_ahead().size());
            if (x.line.cursor.eat('['))
                while (!x.line.cursor.eat(']')) {
                    if (x.line.cursor.at_end()) return syntax(x, x.line.cursor.at(), "]");
                    x.line.cursor.advance(1);
                }
            if (x.line.cursor.eat(')')) break;
            if (!x.line.cursor.eat(',')) return syntax(x, x.line.cursor.at(), ")");
        }
    }
    if (!rest_must_be_empty(x)) return false;
    if (!x.files.find_name(name) && !x.files.find_name(name + ".SPF"))
        return fail_at(x, Alarm::SubprogramMissing, at, name.size(), name);
    return true;
}

// --- calls by other means

}  // namespace polyturn::channels::sinumerik
