// DEF, REDEF, DEFINE, PROC, EXTERN: names that a program brings with it.
#include <algorithm>
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr std::size_t kLongestName = 31;
constexpr std::size_t kMostCells = 65536;
// what READ gives back (sinumerik_part3 7.16); 200 where no length is named (9.7)
constexpr double kLongestText = 255;

}  // namespace

bool Interpreter::parse_type(Type& type, std::size_t& length) {
    const char* const from = cursor_.at();
    const std::string word = upper(cursor_.name_ahead());
    constexpr Type kTypes[] = {Type::Bool,   Type::Char, Type::Int,  Type::Real,
                               Type::String, Type::Axis, Type::Frame};
    for (const Type t : kTypes) {
        if (word != type_name(t)) continue;
        cursor_.advance(word.size());
        type = t;
        length = 200;
        if (t == Type::String && cursor_.eat('[')) {
            Value value;
            if (cursor_.eat(']')) return true;
            if (!expression(value)) return false;
            if (!value.is_number() || value.number < 1 || value.number > kLongestText)
                return fail_at(Alarm::ArrayIndexIllegal, from, word.size(), "STRING", value.number);
            length = static_cast<std::size_t>(value.number);
            return cursor_.eat(']') || syntax(cursor_.at(), "]");
        }
        return true;
    }
    return syntax(from, word);
}

bool Interpreter::declare(const std::string& name, std::shared_ptr<Variable> variable,
                          const char* at) {
    if (name.size() > kLongestName)
        return fail_at(Alarm::NameTooLong, at, name.size(), name, kLongestName);
    // Two letters or _ begin a name; one letter alone is allowed where it is no address.
    // fixed addresses without a row (sinumerik_part3 5.1)
    const bool letter = name == "N" || name == "R";
    if (letter || find_symbol(name).kind != Symbol::Kind::None || find_axis(name) >= 0 ||
        (name.size() > 1 && is_digit(name[1])))
        return fail_at(Alarm::NameReserved, at, name.size(), name);
    const std::shared_ptr<Scope> in = of_channel_ ? channel_scope_ : scope();
    if (in->names.contains(name) || (!of_channel_ && scope()->names.contains(name)))
        return fail_at(Alarm::NameTwice, at, name.size(), name);
    undo([in, name] { in->names.erase(name); });
    in->names[name] = {std::move(variable), 0, true};
    return true;
}

// DEF type name[dimensions] = value, name ...; DEF CHAN holds until the next cycle start, for all
// programs.
bool Interpreter::st_def() {
    bool has_lower = false, has_upper = false;
    double lower = 0, upper_limit = 0;
    int physical_unit = 0;
    of_channel_ = false;
    for (;;) {
        // Variables are read and written in the order of the text, and made anew at each start: so
        // SYNR SYNW SYNRW and INIPO INIRE INICF PRLOC hold.
        static constexpr std::string_view kHold[] = {"CHAN",  "SYNR",  "SYNW",  "SYNRW",
                                                     "INIPO", "INIRE", "INICF", "PRLOC"};
        const std::string word = upper(cursor_.name_ahead());
        if (word == "NCK")
            return fail_at(Alarm::NotBuilt, cursor_.at(), word.size(), "DEF " + word);
        if (std::find(std::begin(kHold), std::end(kHold), word) == std::end(kHold)) break;
        of_channel_ = of_channel_ || word == "CHAN";
        cursor_.advance(word.size());
    }
    Type type{};
    std::size_t length = 0;
    if (!parse_type(type, length)) return false;
    for (;;) {
        const std::string word = upper(cursor_.name_ahead());
        if (word == "LLI" || word == "ULI") {
            cursor_.advance(3);
            Value value;
            if (!expression(value)) return false;
            if (!value.is_number())
                return fail_at(Alarm::OperandTypeIllegal, cursor_.at(), 1, word);
            (word == "LLI" ? has_lower : has_upper) = true;
            (word == "LLI" ? lower : upper_limit) = value.number;
        } else if (word == "PHU") {
            cursor_.advance(3);
            Value value;
            if (!expression(value)) return false;
            if (!value.is_number())
                return fail_at(Alarm::OperandTypeIllegal, cursor_.at(), 1, word);
            physical_unit = static_cast<int>(value.number);
        } else if (word.starts_with("APR") || word.starts_with("APW")) {
            return fail_at(Alarm::NotBuilt, cursor_.at(), word.size(), word);
        } else {
            break;
        }
    }
    for (;;) {
        cursor_.skip();
        const char* const at = cursor_.at();
        const std::string name = upper(cursor_.name_ahead());
        if (name.empty()) return syntax(at);
        cursor_.advance(name.size());
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
        if (cursor_.peek() == '[') {
            std::vector<Value> indices;
            if (!index_list(indices)) return false;
            if (indices.size() > 3)
                return fail_at(Alarm::ArrayIndexIllegal, at, name.size(), name,
                               static_cast<double>(indices.size()));
            for (const Value& index : indices) {
                if (!index.is_number() ||
                    !(index.number >= 1 && index.number <= static_cast<double>(kMostCells)))
                    return fail_at(Alarm::ArrayIndexIllegal, at, name.size(), name, index.number);
                variable->dimensions.push_back(static_cast<unsigned>(index.number));
                cells *= static_cast<std::size_t>(index.number);
                if (cells > kMostCells)
                    return fail_at(Alarm::ArrayIndexIllegal, at, name.size(), name,
                                   static_cast<double>(cells));
            }
        }
        Value initial;
        initial.type = type;
        if (type == Type::Frame) initial = Value::of_frame({});
        if (type == Type::Axis) initial = Value::of_axis(-1, {});
        if (has_lower) initial.number = std::max(initial.number, lower);
        variable->cells.assign(cells, initial);
        if (!declare(name, variable, at)) return false;
        if (cursor_.at_assign()) {
            Reference reference{variable, 0, !variable->dimensions.empty()};
            const Cursor before = cursor_;
            cursor_.advance(1);
            const std::string word = upper(cursor_.name_ahead());
            const bool list =
                word == "SET" || word == "REP" || (cursor_.peek() == '(' && reference.whole);
            if (reference.whole && !list) {  // one value for all
                const char* const value_at = cursor_.at();
                Value value;
                if (!expression(value)) return false;
                for (std::size_t i = 0; i < cells; ++i)
                    if (!assign({variable, i, false}, value, value_at)) return false;
            } else {
                cursor_ = before;
                if (!assignment(reference)) return false;
            }
        }
        variable->defaults = variable->cells;
        if (cursor_.at_end()) return true;
        if (!cursor_.eat(',')) return syntax(cursor_.at(), std::string(1, cursor_.peek()));
    }
}

// REDEF $SA_SPIND_MAX_VELO_LIMS PRLOC: the limit of a spindle's speed ends with the program
// (sinumerik_part1 7.3, 7.5).
bool Interpreter::redefine_data(const char* from) {
    cursor_.advance(1);
    const std::string name = "$" + upper(cursor_.name_ahead());
    cursor_.advance(name.size() - 1);
    const params::Row* row = data_row(name);
    if (!row || !limits_spindle_speed(*row) || upper(cursor_.name_ahead()) != "PRLOC")
        return fail_at(Alarm::NotBuilt, from, name.size(), "REDEF " + name);
    cursor_.advance(5);
    undo([this, before = program_local_] { program_local_ = before; });
    program_local_.push_back(row);
    return true;
}

// REDEF changes a variable's limits; what only concerns screens and protection is refused.
bool Interpreter::st_redef() {
    const char* const from = cursor_.at();
    Reference reference;
    if (cursor_.peek() == '$') return redefine_data(from);
    if (!reference_ahead(reference)) return false;
    if (!reference) return fail_at(Alarm::NameUnknown, from, 1, upper(cursor_.name_ahead()));
    while (!cursor_.at_end()) {
        const std::string word = upper(cursor_.name_ahead());
        if (word != "LLI" && word != "ULI")
            return fail_at(Alarm::NotBuilt, cursor_.at(), std::max<std::size_t>(1, word.size()),
                           "REDEF " + word);
        cursor_.advance(3);
        Value value;
        const char* const at = cursor_.at();
        double number = 0;
        if (!expression(value) || !number_of(value, at, number)) return false;
        Variable& variable = *reference.variable;
        undo([keep = reference.variable, lower = variable.lower, upper = variable.upper,
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
bool Interpreter::st_define() {
    const char* const at = cursor_.at();
    const std::string name = upper(cursor_.name_ahead());
    if (name.empty()) return syntax(at);
    cursor_.advance(name.size());
    if (name.size() > kLongestName)
        return fail_at(Alarm::NameTooLong, at, name.size(), name, kLongestName);
    if (find_symbol(name).kind != Symbol::Kind::None || find_axis(name) >= 0)
        return fail_at(Alarm::NameReserved, at, name.size(), name);
    if (macros_.contains(name) || scope()->names.contains(name))
        return fail_at(Alarm::NameTwice, at, name.size(), name);
    if (upper(cursor_.name_ahead()) != "AS") return syntax(cursor_.at(), "AS");
    cursor_.advance(2);
    cursor_.skip();
    std::string text(cursor_.at(), cursor_.end());
    while (!text.empty() && is_blank(text.back())) text.pop_back();
    if (text.empty()) return syntax(cursor_.at(), "AS");
    macros_[name] = text;
    return true;
}

// The text of a line with its macros put in; a macro's own text is not looked through again, so
// that none can call itself.
void Interpreter::expand_macros() {
    std::string out;
    bool text = false;
    const bool defines = upper(line_).find("DEFINE") != std::string::npos;
    if (defines) return;
    for (std::size_t i = 0; i < line_.size();) {
        const char c = line_[i];
        if (c == ';' && !text) {
            out.append(line_, i);
            break;
        }
        if (c == '"') text = !text;
        if (text || !is_name_start(c)) {
            out += c;
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < line_.size() && is_name(line_[end])) ++end;
        const auto found = macros_.find(upper(std::string_view(line_).substr(i, end - i)));
        if (found == macros_.end())
            out.append(line_, i, end - i);
        else
            out += found->second;
        i = end;
    }
    line_ = std::move(out);
}

// The head of a program that is started as a main program: its parameters have their defaults.
bool Interpreter::st_proc() {
    // a second one, behind other blocks
    if (levels_.size() > 1) return syntax(cursor_.at(), "PROC");
    cursor_.at() = cursor_.begin();
    bool skipped = false;
    if (!parse_head(skipped)) return false;
    std::vector<Argument> none;
    return read_proc("PROC", none, levels_.back());
}

// EXTERN name(types): the program must exist; the types are those of its PROC line.
bool Interpreter::st_extern() {
    const char* const at = cursor_.at();
    const std::string name = upper(cursor_.name_ahead());
    if (name.empty()) return syntax(at);
    cursor_.advance(name.size());
    if (cursor_.eat('(') && !cursor_.eat(')')) {
        for (;;) {
            if (upper(cursor_.name_ahead()) == "VAR") cursor_.advance(3);
            Type type{};
            std::size_t length = 0;
            if (!parse_type(type, length)) return false;
            if (is_name_start(cursor_.peek())) cursor_.advance(cursor_.name_ahead().size());
            if (cursor_.eat('['))
                while (!cursor_.eat(']')) {
                    if (cursor_.at_end()) return syntax(cursor_.at(), "]");
                    cursor_.advance(1);
                }
            if (cursor_.eat(')')) break;
            if (!cursor_.eat(',')) return syntax(cursor_.at(), ")");
        }
    }
    if (!rest_must_be_empty()) return false;
    if (!files_->find_name(name) && !files_->find_name(name + ".SPF"))
        return fail_at(Alarm::SubprogramMissing, at, name.size(), name);
    return true;
}

// --- calls by other means

// The name in a path: /_N_WKS_DIR/_N_SHAFT_WPD/PART.SPF, _N_PART_SPF
std::string Interpreter::program_of_path(std::string_view path) {
    const std::size_t slash = path.find_last_of("/\\:");
    std::string name = upper(slash == std::string_view::npos ? path : path.substr(slash + 1));
    if (name.starts_with("_N_")) name.erase(0, 3);
    if (name.ends_with("_SPF") || name.ends_with("_MPF")) name.erase(name.size() - 4);
    return name;
}

// CALL "name", CALL name BLOCK first TO last, CALL BLOCK first TO last
bool Interpreter::st_call() {
    std::string name;
    if (upper(cursor_.name_ahead()) != "BLOCK") {
        const char* const at = cursor_.at();
        Value value;
        if (!expression(value)) return false;
        if (value.type != Type::String)
            return fail_at(Alarm::OperandTypeIllegal, at, 1,
                           "CALL: " + std::string(type_name(value.type)));
        name = program_of_path(value.text);
    }
    if (upper(cursor_.name_ahead()) == "BLOCK") {
        cursor_.advance(5);
        std::string first, last;
        if (!jump_target(first)) return false;
        if (upper(cursor_.name_ahead()) != "TO") return syntax(cursor_.at(), "TO");
        cursor_.advance(2);
        if (!jump_target(last) || !rest_must_be_empty()) return false;
        if (!name.empty()) return call_section(name, first, last);
        auto begin = find_label(first, -1);
        if (!begin) begin = find_label(first, 1);
        if (!begin) return fail(Alarm::JumpTargetMissing, first);
        std::optional<TextPosition> stop;
        if (const auto* places = index_of(levels_.back().file).label(last))
            for (const TextPosition& place : *places)
                if (!stop && place.offset >= begin->offset) stop = place;
        if (!stop) return fail(Alarm::JumpTargetMissing, last);
        const TextPosition back = source_->next_position();
        std::string_view text;
        source_->seek(*stop);
        const bool read = source_->next(text) == LineSource::Status::Line;
        const std::uint64_t end = read ? source_->next_position().offset : stop->offset + 1;
        source_->seek(back);
        if (begin->offset <= here_.offset && here_.offset < end)
            return fail(Alarm::StructureNesting, "CALL BLOCK");
        return run_section(*begin, end, 1, false);
    }
    if (!rest_must_be_empty()) return false;
    return call_program(name, {}, 1, false);
}

// PCALL path/name(arguments)
bool Interpreter::st_pcall() {
    cursor_.skip();
    const char* const from = cursor_.at();
    while (cursor_.at() != cursor_.end() && *cursor_.at() != '(' && !is_blank(*cursor_.at()))
        cursor_.advance(1);
    const std::string name = program_of_path({from, static_cast<std::size_t>(cursor_.at() - from)});
    if (name.empty()) return syntax(from);
    std::vector<Argument> arguments;
    if (cursor_.peek() == '(' && !read_program_arguments(name, arguments)) return false;
    return rest_must_be_empty() && call_program(name, std::move(arguments), 1, false);
}

// EXTCALL("path"), EXTCALL "path": run from where it lies
bool Interpreter::st_extcall() {
    const char* const at = cursor_.at();
    Value value;
    if (!expression(value)) return false;
    if (value.type != Type::String)
        return fail_at(Alarm::OperandTypeIllegal, at, 1,
                       "EXTCALL: " + std::string(type_name(value.type)));
    return rest_must_be_empty() && call_program(program_of_path(value.text), {}, 1, false);
}

// MCALL name(arguments): behind each block that moves; MCALL alone ends it.
bool Interpreter::st_mcall() {
    if (cursor_.at_end()) {
        modal_.call.reset();
        return true;
    }
    const char* const at = cursor_.at();
    const std::string name = upper(cursor_.name_ahead());
    const Symbol symbol = find_symbol(name);
    if (name.empty() || symbol.kind == Symbol::Kind::Reserved)
        return fail_at(Alarm::NotBuilt, at, std::max<std::size_t>(1, name.size()), "MCALL " + name);
    cursor_.advance(name.size());
    ModalCall call{name, {}, nullptr};
    if (symbol.kind == Symbol::Kind::Command) {
        const Command& cycle = symbol.command();
        if (!cycle.name.starts_with("CYCLE8") || name == "CYCLE800")
            return fail_at(Alarm::NotBuilt, at, name.size(), "MCALL " + name);
        Call given;
        if (!read_arguments(cycle, given) || !rest_must_be_empty()) return false;
        call.arguments = std::move(given.arguments);
        call.cycle = &cycle;
        modal_.call = std::move(call);
        return true;
    }
    if (cursor_.peek() == '(' && !read_program_arguments(name, call.arguments)) return false;
    if (!rest_must_be_empty()) return false;
    if (!files_->find_name(name) && !files_->find_name(name + ".SPF"))
        return fail_at(names_cycle(name) ? Alarm::NotBuilt : Alarm::SubprogramMissing, at,
                       name.size(), names_cycle(name) ? "MCALL " + name : name);
    modal_.call = std::move(call);
    return true;
}

}  // namespace polyturn::channels::sinumerik
