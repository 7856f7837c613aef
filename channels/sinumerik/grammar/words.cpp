// The words of a block: addresses with their values, G commands, procedures, assignments, program
// calls. Everything is computed here, in the order of the text; nothing acts yet.
#include "channels/sinumerik/grammar/words.hpp"

#include <algorithm>
#include <cmath>

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/grammar/arguments.hpp"
#include "channels/sinumerik/grammar/expression.hpp"
#include "channels/sinumerik/grammar/word_values.hpp"
#include "channels/sinumerik/variables/system_variables.hpp"
#include "channels/sinumerik/variables/variables.hpp"
#include "channels/text/number.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// Which modifiers an address takes (sinumerik_part3 5.2, 5.3); one that is not named takes none.
constexpr std::uint32_t bit(Mode mode) { return 1u << static_cast<unsigned>(mode); }
constexpr std::uint32_t kRelative = bit(Mode::AC) | bit(Mode::IC);
constexpr std::uint32_t kTurning = kRelative | bit(Mode::DC) | bit(Mode::ACP) | bit(Mode::ACN);
constexpr std::uint32_t kDiameters =
    bit(Mode::DAC) | bit(Mode::DIC) | bit(Mode::RAC) | bit(Mode::RIC);
constexpr std::uint32_t kCoded =
    bit(Mode::CAC) | bit(Mode::CIC) | bit(Mode::CDC) | bit(Mode::CACP) | bit(Mode::CACN);
struct ModesOf {
    std::string_view name;
    std::uint32_t modes;
};
constexpr ModesOf kModesOf[] = {
    {"axis", kTurning | kDiameters | kCoded | bit(Mode::GP)},
    {"POS", kTurning | kDiameters | kCoded},
    {"POSA", kTurning | kDiameters | kCoded},
    {"POSP", kTurning | kDiameters},
    {"AP", kRelative},
    {"RP", kRelative},
    {"I1", kRelative},
    {"J1", kRelative},
    {"K1", kRelative},
    {"I", kRelative | kDiameters},
    {"J", kRelative | kDiameters},
    {"K", kRelative | kDiameters},
    {"SPOS", kTurning},
    {"SPOSA", kTurning},
    {"POLF", kRelative | kDiameters},
    {"DISCL", bit(Mode::AC)},
    {"DISRP", bit(Mode::AC)},
    {"FAD", bit(Mode::PM) | bit(Mode::PR)},
    {"F", bit(Mode::QU)},
    {"S", bit(Mode::QU)},
    {"T", bit(Mode::QU)},
    {"D", bit(Mode::QU)},
    {"M", bit(Mode::QU)},
    {"H", bit(Mode::QU)},
    {"FA", bit(Mode::QU)},
};

bool takes_mode(std::string_view address, Mode mode) {
    if (mode == Mode::Plain) return true;
    for (const ModesOf& row : kModesOf)
        if (row.name == address) return (row.modes & bit(mode)) != 0;
    return false;
}

bool parse_letter_word(Execution& x, const char* begin);
bool parse_named_word(Execution& x, const char* begin, std::string_view name, const Symbol& symbol);
bool add_word(Execution& x, Word word, const char* begin);
bool turns_about_y(const Execution& x);
bool add_g(Execution& x, const GCode* code, const char* begin);
bool to_interpolation_parameter(const Execution& x, Word& word);

bool parse_word(Execution& x) {
    const char* const begin = x.line.cursor.at();
    const char c = *begin;
    if (c == '$') {
        Reference reference;
        if (!reference_ahead(x, reference)) return false;
        x.block.assigns = true;
        return reference ? assignment(x, reference) : parse_system_assignment(x);
    }
    if (c == '"') return syntax(x, begin);
    if (!is_name_start(c)) return syntax(x, begin, std::string(1, c));
    const std::string_view name = x.line.cursor.name_ahead();
    const std::string word = upper(name);

    // R5 =, R[..] =, a declared variable
    Reference reference;
    if (!reference_ahead(x, reference)) return false;
    if (reference) {
        const bool letter_value = name.size() == 1 && reference.variable != x.names.r;
        if (x.line.cursor.at_assign() || reference.variable == x.names.r || !letter_value) {
            x.block.assigns = true;
            return assignment(x, reference);
        }
        x.line.cursor.at() = begin;
    }
    const bool one_letter = name.size() == 1 || is_digit(name[1]);
    if (one_letter && is_letter(c)) return parse_letter_word(x, begin);
    Symbol symbol = find_symbol(word);
    if (symbol.kind == Symbol::Kind::None) {  // MD10652 MD10654 MD10656
        static constexpr std::string_view kNames[] = {"ANG", "RND", "CHR"};
        for (std::size_t k = 0; k < 3; ++k)
            if (word == x.settings.corner_names[k]) symbol = find_symbol(kNames[k]);
    }
    // the angles of two lines, each in its block (10.9.1)
    if (word == "ANG1" || word == "ANG2") symbol = find_symbol("ANG");
    if (symbol.kind != Symbol::Kind::None) return parse_named_word(x, begin, word, symbol);
    // An axis of several letters, perhaps with a numeric extension.
    if (const int axis = find_axis(x, word); axis >= 0 && axis < kSpindleAxis) {
        x.line.cursor.advance(name.size());
        Word value;
        value.address = &kAxisAddress;
        value.axis = axis;
        return read_value(x, value) && add_word(x, std::move(value), begin);
    }
    // FZ0.03: the only one that may go without its = (sinumerik_part1 8.12)
    if (word.size() > 2 && word.starts_with("FZ") && is_digit(word[2])) {
        x.line.cursor.advance(2);
        Word value;
        value.address = &find_symbol("FZ").address();
        return read_value(x, value) && add_word(x, std::move(value), begin);
    }
    // A program by its name.
    if (x.block.program.wanted) return syntax(x, begin, word);
    x.line.cursor.advance(name.size());
    if (x.line.cursor.at_assign()) return fail_at(x, Alarm::NameUnknown, begin, name.size(), word);
    x.block.program.wanted = true;
    x.block.program.name = word;
    x.line.program_column = x.line.cursor.column(begin);
    if (!x.files.find_name(word) && !x.files.find_name(word + ".SPF") &&
        !x.files.find_name(word + ".MPF"))
        return fail_at(x, names_cycle(word) ? Alarm::NotBuilt : Alarm::NameUnknown, begin,
                       name.size(), word);
    if (x.line.cursor.peek() == '(')
        return read_program_arguments(x, word, x.block.program.arguments);
    return true;
}

// A letter and what belongs to it: X10, X=.., X1=.., S2=.., M[n]=.., G54, N is behind us.
bool parse_letter_word(Execution& x, const char* begin) {
    const char letter = upper(*begin);
    std::size_t digits = 0;
    while (is_digit(x.line.cursor.next_raw(1 + digits))) ++digits;
    Cursor after = x.line.cursor;
    after.advance(1 + digits);
    const bool extended = digits > 0 && after.at_assign();
    if (letter == 'G' && !extended) {
        x.line.cursor.advance(1);
        const GCode* code = nullptr;
        if (x.line.cursor.next_raw() == '[') {  // G[group] = number
            std::vector<Value> indices;
            Value number;
            if (!index_list(x, indices)) return false;
            if (!x.line.cursor.at_assign()) return syntax(x, x.line.cursor.at(), "=");
            x.line.cursor.advance(1);
            if (!expression(x, number)) return false;
            if (indices.size() == 1 && indices[0].is_number() && number.is_number() &&
                indices[0].number > 0 && number.number > 0)
                code = find_g(static_cast<unsigned>(std::min(indices[0].number, 99.0)),
                              static_cast<unsigned>(std::min(number.number, 999.0)));
            if (!code)
                return fail_at(x, Alarm::GCodeUnknown, begin,
                               static_cast<std::size_t>(x.line.cursor.at() - begin), "G");
            return add_g(x, code, begin);
        }
        double number = 0;
        if (x.line.cursor.at_assign()) {
            x.line.cursor.advance(1);
            Value value;
            if (!expression(x, value) || !number_of(x, value, begin, number)) return false;
        } else {
            x.line.cursor.skip();
            const ScannedNumber scanned = scan_number(x.line.cursor.at(), x.line.cursor.end());
            if (scanned.status != ScannedNumber::Status::Ok)
                return fail_at(x, Alarm::NumberMissing, begin, 1, "G");
            number = scanned.value;
        }
        if (number >= 0 && number < 1000 && number == std::floor(number))
            if (const Symbol symbol = find_symbol("G" + std::to_string(static_cast<int>(number)));
                symbol.kind == Symbol::Kind::G)
                code = &symbol.g();
        if (!code)
            return fail_at(x, Alarm::GCodeUnknown, begin,
                           static_cast<std::size_t>(x.line.cursor.at() - begin),
                           std::string(begin, x.line.cursor.at()));
        return add_g(x, code, begin);
    }
    Word word;
    const std::string name(1, letter);
    if (extended) {
        const std::string full = upper({begin, 1 + digits});
        if (const int axis = find_axis(x, full); axis >= 0 && axis < kSpindleAxis) {
            word.axis = axis;
            word.address = &kAxisAddress;
            x.line.cursor.advance(1 + digits);
            return read_value(x, word) && add_word(x, std::move(word), begin);
        }
        if (const Symbol symbol = find_symbol(full);
            symbol.kind == Symbol::Kind::Address || symbol.kind == Symbol::Kind::Reserved)
            return parse_named_word(x, begin, full, symbol);  // I1, A3
    }
    const int axis = find_axis(x, name);
    const Symbol symbol = find_symbol(name);
    if (axis >= 0 && axis < kSpindleAxis) {
        word.axis = axis;
        word.address = &kAxisAddress;
        x.line.cursor.advance(1);
        if (extended)
            return fail_at(x, Alarm::AxisUnknown, begin, 1 + digits, upper({begin, 1 + digits}));
        return read_value(x, word) && add_word(x, std::move(word), begin);
    }
    // ROT Y of a lathe without that axis turns its plane, as RPL does
    if (letter == 'Y' && !extended && turns_about_y(x)) {
        word.address = &find_symbol("RPL").address();
        x.line.cursor.advance(1);
        return read_value(x, word) && add_word(x, std::move(word), begin);
    }
    if (symbol.kind != Symbol::Kind::Address)
        return fail_at(x, Alarm::AddressIllegal, begin, 1, name);
    word.address = &symbol.address();
    x.line.cursor.advance(1);
    // the zeros of a subprogram number count: L0123 is another program than L123
    if (letter == 'L') {
        const char* const first = x.line.cursor.at();
        while (is_digit(x.line.cursor.next_raw())) x.line.cursor.advance(1);
        if (first == x.line.cursor.at()) return fail_at(x, Alarm::NumberMissing, begin, 1, "L");
        if (x.block.program.wanted) return syntax(x, begin, "L");
        x.block.program.wanted = true;
        x.block.program.name = "L" + std::string(first, x.line.cursor.at());
        x.line.program_column = x.line.cursor.column(begin);
        return x.line.cursor.peek() != '(' ||
               read_program_arguments(x, x.block.program.name, x.block.program.arguments);
    }
    if (extended) {
        if (word.address->index == Address::Index::None)
            return fail_at(x, Alarm::AddressIllegal, begin, 1 + digits, upper({begin, 1 + digits}));
        double number = 0;
        for (std::size_t i = 0; i < digits; ++i) number = number * 10 + (begin[1 + i] - '0');
        if (number > 99)
            return fail_at(x, Alarm::ArrayIndexIllegal, begin, 1 + digits, name, number);
        word.index = static_cast<std::int32_t>(number);
        word.spindle = word.address->index == Address::Index::Spindle;
        x.line.cursor.advance(digits);
    } else if (x.line.cursor.next_raw() == '[' || x.line.cursor.peek() == '[') {
        if (!read_index(x, word, *word.address)) return false;
    }
    return read_value(x, word) && add_word(x, std::move(word), begin);
}

bool parse_named_word(Execution& x, const char* begin, std::string_view name,
                      const Symbol& symbol) {
    switch (symbol.kind) {
        case Symbol::Kind::G:
            x.line.cursor.advance(name.size());
            return add_g(x, &symbol.g(), begin);
        case Symbol::Kind::Address: {
            Word word;
            word.address = &symbol.address();
            if (word.address->use == Address::Use::Refused)
                return fail_at(x, Alarm::NotBuilt, begin, name.size(), std::string(name));
            x.line.cursor.advance(name.size());
            if (x.line.cursor.peek() == '[' && !read_index(x, word, *word.address)) return false;
            if (word.address->index == Address::Index::Axis && word.axis < 0)
                return fail_at(x, Alarm::AxisArgumentMissing, begin, name.size(),
                               std::string(name));
            if (name == "AX") word.address = &kAxisAddress;
            if (name == "IP" && !to_interpolation_parameter(x, word))
                return fail_at(x, Alarm::AxisKindWrong, begin, name.size(),
                               axis_name(x, word.axis));
            if (word.address->valueless) return add_word(x, std::move(word), begin);
            // Behind several letters a value needs its = (sinumerik_part1 3.2.3): RND 2 is no
            // rounding.
            if (!x.line.cursor.at_assign() && !x.line.cursor.at_end() &&
                !is_name_start(x.line.cursor.peek()))
                return syntax(x, x.line.cursor.at(), std::string(name) + " =");
            return read_value(x, word) && add_word(x, std::move(word), begin);
        }
        case Symbol::Kind::Command: {
            const Command& command = symbol.command();
            if (!command.act)
                return fail_at(x, Alarm::NotBuilt, begin, name.size(), std::string(name));
            // A value must go somewhere; these the manual lists as functions and as procedures
            // (sinumerik_part3 14).
            if (command.function && name != "DELDL" && name != "SETDNO" && name != "GETTENV")
                return syntax(x, begin, std::string(name));
            x.line.cursor.advance(name.size());
            Call call;
            call.column = static_cast<std::uint16_t>(
                std::min<std::size_t>(x.line.cursor.column(begin), 65535));
            if (!read_arguments(x, command, call)) return false;
            x.block.procedures.emplace_back(&command, std::move(call));
            return true;
        }
        case Symbol::Kind::Statement:
            // A jump or call may stand behind other words of its block.
            x.line.statement = &symbol.statement();
            x.line.statement_at = x.line.cursor.column(begin);
            x.line.cursor.at() = x.line.cursor.end();
            return true;
        default:
            return fail_at(x, Alarm::NotBuilt, begin, name.size(), std::string(name));
    }
}

// IP[axis]: I, J or K by a variable, those of the geometry axes 1 to 3.
bool to_interpolation_parameter(const Execution& x, Word& word) {
    static constexpr std::string_view kNames[] = {"I", "J", "K"};
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    const MachineView& view = x.core.view();
    for (std::size_t k = 0; k < 3; ++k) {
        if (word.axis < 0 || view.axes[static_cast<std::size_t>(word.axis)].role != kRoles[k])
            continue;
        word.address = &find_symbol(kNames[k]).address();
        word.axis = -1;
        return true;
    }
    return false;
}

bool turns_about_y(const Execution& x) {
    const GCode* frame = x.block.coded[3];
    return frame && (frame->name == "ROT" || frame->name == "AROT") &&
           x.core.path.plane == Plane::ZX;
}

bool add_g(Execution& x, const GCode* code, const char* begin) {
    const auto length = static_cast<std::size_t>(x.line.cursor.at() - begin);
    if (const GCode* other = x.block.coded[code->group]) {
        return fail_at(x, Alarm::SameGroupTwice, begin, length,
                       std::string(other->name) + " and " + std::string(code->name), code->group);
    }
    if (!code->act) return fail_at(x, Alarm::NotBuilt, begin, length, std::string(code->name));
    x.block.coded[code->group] = code;
    x.block.codes.push_back(code);
    x.block.code_columns.push_back(
        static_cast<std::uint16_t>(std::min<std::size_t>(x.line.cursor.column(begin), 65535)));
    return true;
}

bool add_word(Execution& x, Word word, const char* begin) {
    word.column =
        static_cast<std::uint16_t>(std::min<std::size_t>(x.line.cursor.column(begin), 65535));
    word.length = static_cast<std::uint16_t>(
        std::min<std::size_t>(static_cast<std::size_t>(x.line.cursor.at() - begin), 65535));
    const Address& address = *word.address;
    const bool axis_word = word.address == &kAxisAddress;
    if (!takes_mode(address.name, word.mode)) {
        std::string said = axis_word ? axis_name(x, word.axis) : std::string(address.name);
        for (const ModeName& row : kModes)
            if (row.mode == word.mode) said += "=" + std::string(row.name);
        return fail_at(x, Alarm::SyntaxWrong, begin, word.length, std::move(said));
    }
    const bool text_allowed = address.name == "T";
    if (word.mode != Mode::Plain && word.value.type == Type::String && !text_allowed)
        return fail_at(x, Alarm::OperandTypeIllegal, begin, word.length, std::string(address.name));
    if (!word.value.is_number() && !(text_allowed && word.value.type == Type::String))
        return fail_at(x, Alarm::OperandTypeIllegal, begin, word.length,
                       (axis_word ? axis_name(x, word.axis) : std::string(address.name)) + ": " +
                           std::string(type_name(word.value.type)));
    if (!address.is_signed && word.value.number < 0)
        return fail_at(x, Alarm::NegativeSign, begin, word.length, std::string(address.name));
    for (const Word& other : x.block.words) {
        if (other.address != word.address) continue;
        const bool same =
            axis_word ? other.axis == word.axis
                      : !address.repeats || (address.index != Address::Index::None &&
                                             address.name != "M" && address.name != "H" &&
                                             other.axis == word.axis && other.index == word.index);
        if (same)
            return fail_at(x, Alarm::AddressTwice, begin, word.length,
                           axis_word ? axis_name(x, word.axis) : std::string(address.name));
    }
    x.block.words.push_back(std::move(word));
    return true;
}

}  // namespace

// A cycle of the control by its name, of which the tables have no row (CYCLE93, POCKET1, HOLES5):
// it is not a name that the program has forgotten to declare. A program of that name that the shop
// has loaded is called all the same.
bool names_cycle(std::string_view upper_name) {
    for (const std::string_view kind : {"CYCLE", "POCKET", "SLOT", "HOLES", "LONGHOLE"})
        if (upper_name.starts_with(kind))
            return std::ranges::all_of(upper_name.substr(kind.size()),
                                       [](char c) { return is_digit(c); });
    return false;
}

bool parse_words(Execution& x) {
    while (!x.line.cursor.at_end()) {
        if (x.block.words.size() >= 64 || x.block.codes.size() >= 32)
            return fail_at(x, Alarm::WordsTooMany, x.line.cursor.at(), 1);
        if (!parse_word(x)) return false;
    }
    return true;
}

const Word* word(const Execution& x, std::string_view name) {
    const Word* found = nullptr;
    for (const Word& word : x.block.words)
        if (word.address->name == name) found = &word;
    return found;
}

}  // namespace polyturn::channels::sinumerik
