// The words of a block: addresses with their values, G commands, procedures, assignments, program
// calls. Everything is computed here, in the order of the text; nothing acts yet.
#include <algorithm>
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"
#include "channels/text/number.hpp"

namespace polyturn::channels::sinumerik {
namespace {

const Address kAxisAddress{"axis", Address::Index::Number, Address::Use::Block, nullptr};

struct ModeName {
    std::string_view name;
    Mode mode;
};
constexpr ModeName kModes[] = {{"AC", Mode::AC},     {"IC", Mode::IC},   {"DC", Mode::DC},
                               {"ACP", Mode::ACP},   {"ACN", Mode::ACN}, {"CAC", Mode::CAC},
                               {"CIC", Mode::CIC},   {"CDC", Mode::CDC}, {"CACP", Mode::CACP},
                               {"CACN", Mode::CACN}, {"DAC", Mode::DAC}, {"DIC", Mode::DIC},
                               {"RAC", Mode::RAC},   {"RIC", Mode::RIC}, {"QU", Mode::QU},
                               {"PM", Mode::PM},     {"PR", Mode::PR},   {"GP", Mode::GP}};

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

}  // namespace

// A cycle of the control by its name, of which the tables have no row (CYCLE93, POCKET1, HOLES5):
// it is not a name that the program has forgotten to declare. A program of that name that the shop
// has loaded is called all the same.
bool Interpreter::names_cycle(std::string_view upper_name) {
    for (const std::string_view kind : {"CYCLE", "POCKET", "SLOT", "HOLES", "LONGHOLE"})
        if (upper_name.starts_with(kind))
            return std::ranges::all_of(upper_name.substr(kind.size()),
                                       [](char c) { return is_digit(c); });
    return false;
}

bool Interpreter::parse_words() {
    while (!cursor_.at_end()) {
        if (block_.words.size() >= 64 || block_.codes.size() >= 32)
            return fail_at(Alarm::WordsTooMany, cursor_.at(), 1);
        if (!parse_word()) return false;
    }
    return true;
}

bool Interpreter::parse_word() {
    const char* const begin = cursor_.at();
    const char c = *begin;
    if (c == '$') {
        Reference reference;
        if (!reference_ahead(reference)) return false;
        block_.assigns = true;
        return reference ? assignment(reference) : parse_system_assignment();
    }
    if (c == '"') return syntax(begin);
    if (!is_name_start(c)) return syntax(begin, std::string(1, c));
    const std::string_view name = cursor_.name_ahead();
    const std::string word = upper(name);

    // R5 =, R[..] =, a declared variable
    Reference reference;
    if (!reference_ahead(reference)) return false;
    if (reference) {
        const bool letter_value = name.size() == 1 && reference.variable != r_;
        if (cursor_.at_assign() || reference.variable == r_ || !letter_value) {
            block_.assigns = true;
            return assignment(reference);
        }
        cursor_.at() = begin;
    }
    const bool one_letter = name.size() == 1 || is_digit(name[1]);
    if (one_letter && is_letter(c)) return parse_letter_word(begin);
    Symbol symbol = find_symbol(word);
    if (symbol.kind == Symbol::Kind::None) {  // MD10652 MD10654 MD10656
        static constexpr std::string_view kNames[] = {"ANG", "RND", "CHR"};
        for (std::size_t k = 0; k < 3; ++k)
            if (word == settings_.corner_names[k]) symbol = find_symbol(kNames[k]);
    }
    // the angles of two lines, each in its block (10.9.1)
    if (word == "ANG1" || word == "ANG2") symbol = find_symbol("ANG");
    if (symbol.kind != Symbol::Kind::None) return parse_named_word(begin, word, symbol);
    // An axis of several letters, perhaps with a numeric extension.
    if (const int axis = find_axis(word); axis >= 0 && axis < kSpindleAxis) {
        cursor_.advance(name.size());
        Word value;
        value.address = &kAxisAddress;
        value.axis = axis;
        return read_value(value) && add_word(std::move(value), begin);
    }
    // FZ0.03: the only one that may go without its = (sinumerik_part1 8.12)
    if (word.size() > 2 && word.starts_with("FZ") && is_digit(word[2])) {
        cursor_.advance(2);
        Word value;
        value.address = &find_symbol("FZ").address();
        return read_value(value) && add_word(std::move(value), begin);
    }
    // A program by its name.
    if (block_.program.wanted) return syntax(begin, word);
    cursor_.advance(name.size());
    if (cursor_.at_assign()) return fail_at(Alarm::NameUnknown, begin, name.size(), word);
    block_.program.wanted = true;
    block_.program.name = word;
    program_column_ = cursor_.column(begin);
    if (!files_->find_name(word) && !files_->find_name(word + ".SPF") &&
        !files_->find_name(word + ".MPF"))
        return fail_at(names_cycle(word) ? Alarm::NotBuilt : Alarm::NameUnknown, begin, name.size(),
                       word);
    if (cursor_.peek() == '(') return read_program_arguments(word, block_.program.arguments);
    return true;
}

// A letter and what belongs to it: X10, X=.., X1=.., S2=.., M[n]=.., G54, N is behind us.
bool Interpreter::parse_letter_word(const char* begin) {
    const char letter = upper(*begin);
    std::size_t digits = 0;
    while (is_digit(cursor_.next_raw(1 + digits))) ++digits;
    Cursor after = cursor_;
    after.advance(1 + digits);
    const bool extended = digits > 0 && after.at_assign();
    if (letter == 'G' && !extended) {
        cursor_.advance(1);
        const GCode* code = nullptr;
        if (cursor_.next_raw() == '[') {  // G[group] = number
            std::vector<Value> indices;
            Value number;
            if (!index_list(indices)) return false;
            if (!cursor_.at_assign()) return syntax(cursor_.at(), "=");
            cursor_.advance(1);
            if (!expression(number)) return false;
            if (indices.size() == 1 && indices[0].is_number() && number.is_number() &&
                indices[0].number > 0 && number.number > 0)
                code = find_g(static_cast<unsigned>(std::min(indices[0].number, 99.0)),
                              static_cast<unsigned>(std::min(number.number, 999.0)));
            if (!code)
                return fail_at(Alarm::GCodeUnknown, begin,
                               static_cast<std::size_t>(cursor_.at() - begin), "G");
            return add_g(code, begin);
        }
        double number = 0;
        if (cursor_.at_assign()) {
            cursor_.advance(1);
            Value value;
            if (!expression(value) || !number_of(value, begin, number)) return false;
        } else {
            cursor_.skip();
            const ScannedNumber scanned = scan_number(cursor_.at(), cursor_.end());
            if (scanned.status != ScannedNumber::Status::Ok)
                return fail_at(Alarm::NumberMissing, begin, 1, "G");
            number = scanned.value;
        }
        if (number >= 0 && number < 1000 && number == std::floor(number))
            if (const Symbol symbol = find_symbol("G" + std::to_string(static_cast<int>(number)));
                symbol.kind == Symbol::Kind::G)
                code = &symbol.g();
        if (!code)
            return fail_at(Alarm::GCodeUnknown, begin,
                           static_cast<std::size_t>(cursor_.at() - begin),
                           std::string(begin, cursor_.at()));
        return add_g(code, begin);
    }
    Word word;
    const std::string name(1, letter);
    if (extended) {
        const std::string full = upper({begin, 1 + digits});
        if (const int axis = find_axis(full); axis >= 0 && axis < kSpindleAxis) {
            word.axis = axis;
            word.address = &kAxisAddress;
            cursor_.advance(1 + digits);
            return read_value(word) && add_word(std::move(word), begin);
        }
        if (const Symbol symbol = find_symbol(full);
            symbol.kind == Symbol::Kind::Address || symbol.kind == Symbol::Kind::Reserved)
            return parse_named_word(begin, full, symbol);  // I1, A3
    }
    const int axis = find_axis(name);
    const Symbol symbol = find_symbol(name);
    if (axis >= 0 && axis < kSpindleAxis) {
        word.axis = axis;
        word.address = &kAxisAddress;
        cursor_.advance(1);
        if (extended)
            return fail_at(Alarm::AxisUnknown, begin, 1 + digits, upper({begin, 1 + digits}));
        return read_value(word) && add_word(std::move(word), begin);
    }
    // ROT Y of a lathe without that axis turns its plane, as RPL does
    if (letter == 'Y' && !extended && turns_about_y()) {
        word.address = &find_symbol("RPL").address();
        cursor_.advance(1);
        return read_value(word) && add_word(std::move(word), begin);
    }
    if (symbol.kind != Symbol::Kind::Address) return fail_at(Alarm::AddressIllegal, begin, 1, name);
    word.address = &symbol.address();
    cursor_.advance(1);
    // the zeros of a subprogram number count: L0123 is another program than L123
    if (letter == 'L') {
        const char* const first = cursor_.at();
        while (is_digit(cursor_.next_raw())) cursor_.advance(1);
        if (first == cursor_.at()) return fail_at(Alarm::NumberMissing, begin, 1, "L");
        if (block_.program.wanted) return syntax(begin, "L");
        block_.program.wanted = true;
        block_.program.name = "L" + std::string(first, cursor_.at());
        program_column_ = cursor_.column(begin);
        return cursor_.peek() != '(' ||
               read_program_arguments(block_.program.name, block_.program.arguments);
    }
    if (extended) {
        if (word.address->index == Address::Index::None)
            return fail_at(Alarm::AddressIllegal, begin, 1 + digits, upper({begin, 1 + digits}));
        double number = 0;
        for (std::size_t i = 0; i < digits; ++i) number = number * 10 + (begin[1 + i] - '0');
        if (number > 99) return fail_at(Alarm::ArrayIndexIllegal, begin, 1 + digits, name, number);
        word.index = static_cast<std::int32_t>(number);
        word.spindle = word.address->index == Address::Index::Spindle;
        cursor_.advance(digits);
    } else if (cursor_.next_raw() == '[' || cursor_.peek() == '[') {
        if (!read_index(word, *word.address)) return false;
    }
    return read_value(word) && add_word(std::move(word), begin);
}

bool Interpreter::parse_named_word(const char* begin, std::string_view name, const Symbol& symbol) {
    switch (symbol.kind) {
        case Symbol::Kind::G:
            cursor_.advance(name.size());
            return add_g(&symbol.g(), begin);
        case Symbol::Kind::Address: {
            Word word;
            word.address = &symbol.address();
            if (word.address->use == Address::Use::Refused)
                return fail_at(Alarm::NotBuilt, begin, name.size(), std::string(name));
            cursor_.advance(name.size());
            if (cursor_.peek() == '[' && !read_index(word, *word.address)) return false;
            if (word.address->index == Address::Index::Axis && word.axis < 0)
                return fail_at(Alarm::AxisArgumentMissing, begin, name.size(), std::string(name));
            if (name == "AX") word.address = &kAxisAddress;
            if (name == "IP" && !to_interpolation_parameter(word))
                return fail_at(Alarm::AxisKindWrong, begin, name.size(), axis_name(word.axis));
            if (word.address->valueless) return add_word(std::move(word), begin);
            // Behind several letters a value needs its = (sinumerik_part1 3.2.3): RND 2 is no
            // rounding.
            if (!cursor_.at_assign() && !cursor_.at_end() && !is_name_start(cursor_.peek()))
                return syntax(cursor_.at(), std::string(name) + " =");
            return read_value(word) && add_word(std::move(word), begin);
        }
        case Symbol::Kind::Command: {
            const Command& command = symbol.command();
            if (!command.act)
                return fail_at(Alarm::NotBuilt, begin, name.size(), std::string(name));
            // A value must go somewhere; these the manual lists as functions and as procedures
            // (sinumerik_part3 14).
            if (command.function && name != "DELDL" && name != "SETDNO" && name != "GETTENV")
                return syntax(begin, std::string(name));
            cursor_.advance(name.size());
            Call call;
            call.column =
                static_cast<std::uint16_t>(std::min<std::size_t>(cursor_.column(begin), 65535));
            if (!read_arguments(command, call)) return false;
            block_.procedures.emplace_back(&command, std::move(call));
            return true;
        }
        case Symbol::Kind::Statement:
            // A jump or call may stand behind other words of its block.
            statement_ = &symbol.statement();
            statement_at_ = cursor_.column(begin);
            cursor_.at() = cursor_.end();
            return true;
        default:
            return fail_at(Alarm::NotBuilt, begin, name.size(), std::string(name));
    }
}

// IP[axis]: I, J or K by a variable, those of the geometry axes 1 to 3.
bool Interpreter::to_interpolation_parameter(Word& word) const {
    static constexpr std::string_view kNames[] = {"I", "J", "K"};
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    const MachineView& view = core_.view();
    for (std::size_t k = 0; k < 3; ++k) {
        if (word.axis < 0 || view.axes[static_cast<std::size_t>(word.axis)].role != kRoles[k])
            continue;
        word.address = &find_symbol(kNames[k]).address();
        word.axis = -1;
        return true;
    }
    return false;
}

bool Interpreter::turns_about_y() const {
    const GCode* frame = block_.coded[3];
    return frame && (frame->name == "ROT" || frame->name == "AROT") &&
           core_.path.plane == Plane::ZX;
}

bool Interpreter::add_g(const GCode* code, const char* begin) {
    const auto length = static_cast<std::size_t>(cursor_.at() - begin);
    if (const GCode* other = block_.coded[code->group]) {
        return fail_at(Alarm::SameGroupTwice, begin, length,
                       std::string(other->name) + " and " + std::string(code->name), code->group);
    }
    if (!code->act) return fail_at(Alarm::NotBuilt, begin, length, std::string(code->name));
    block_.coded[code->group] = code;
    block_.codes.push_back(code);
    block_.code_columns.push_back(
        static_cast<std::uint16_t>(std::min<std::size_t>(cursor_.column(begin), 65535)));
    return true;
}

// [axis], [2], [SPI(2)], [S2]
bool Interpreter::read_index(Word& word, const Address& address) {
    cursor_.skip();
    const char* const from = cursor_.at();
    std::vector<Value> indices;
    if (!index_list(indices)) return false;
    if (address.name == "FMA" && indices.size() == 2) {  // which input, then the axis
        if (!indices[0].is_number() || !(indices[0].number >= 2 && indices[0].number <= 7))
            return fail_at(Alarm::ArrayIndexIllegal, from, 1, "FMA", indices[0].number);
        indices.erase(indices.begin());
    }
    if (indices.size() != 1 || address.index == Address::Index::None)
        return fail_at(Alarm::ArrayIndexIllegal, from, 1, std::string(address.name));
    const Value& index = indices[0];
    if (index.type == Type::Axis) {
        if (index.place() >= kSpindleAxis) {
            word.index = index.place() - kSpindleAxis;
            word.spindle = true;
        } else {
            word.axis = index.place();
        }
        if (address.index == Address::Index::Number)
            return fail_at(Alarm::ArrayIndexIllegal, from, 1, std::string(address.name));
        return true;
    }
    if (!index.is_number() || address.index == Address::Index::Axis)
        return fail_at(Alarm::ArrayIndexIllegal, from, 1, std::string(address.name));
    if (!(index.number >= 0 && index.number <= 99))
        return fail_at(Alarm::ArrayIndexIllegal, from, 1, std::string(address.name), index.number);
    word.index = static_cast<std::int32_t>(std::nearbyint(index.number));
    word.spindle = address.index == Address::Index::Spindle;
    return true;
}

bool Interpreter::read_value(Word& word) {
    if (!cursor_.at_assign()) {  // one letter and a number
        cursor_.skip();
        const char* const from = cursor_.at();
        // An axis of which no value is wanted is not known here: a name without a value is a
        // mistake.
        const ScannedNumber scanned = scan_number(cursor_.at(), cursor_.end());
        switch (scanned.status) {
            case ScannedNumber::Status::Ok:
                break;
            case ScannedNumber::Status::SecondPoint:
                return fail_at(Alarm::SecondPoint, cursor_.at(), 1);
            case ScannedNumber::Status::TooManyDigits:
                return fail_at(Alarm::DigitsTooMany, from, 1);
            case ScannedNumber::Status::Missing:
                return fail_at(Alarm::NumberMissing, from, 1,
                               word.address == &kAxisAddress ? axis_name(word.axis)
                                                             : std::string(word.address->name));
        }
        word.has_value = true;
        word.value =
            scanned.has_point ? Value::of_real(scanned.value) : Value::of_int(scanned.value);
        return true;
    }
    cursor_.advance(1);
    const std::string_view name = cursor_.name_ahead();
    if (!name.empty() && name.size() <= 4) {
        const std::string modifier = upper(name);
        Cursor after = cursor_;
        after.advance(name.size());
        if (after.peek() == '(')
            for (const ModeName& row : kModes)
                if (row.name == modifier) {
                    cursor_ = after;
                    word.mode = row.mode;
                    break;
                }
    }
    word.has_value = true;
    const bool list = word.address->name == "POSP" || word.address->name == "MEASA" ||
                      word.address->name == "MEAWA";
    if (!list || word.mode != Mode::Plain || !cursor_.eat('(')) return expression(word.value);
    // (end, part, mode): values that belong together
    const std::string_view first = cursor_.name_ahead();
    for (const ModeName& row : kModes) {
        Cursor after = cursor_;
        after.advance(first.size());
        if (first.empty() || upper(first) != row.name || after.peek() != '(') continue;
        cursor_ = after;
        word.mode = row.mode;
        break;
    }
    if (!expression(word.value)) return false;
    while (cursor_.eat(',')) {
        Value further;
        const char* const at = cursor_.at();
        if (!expression(further)) return false;
        if (!further.is_number())
            return fail_at(Alarm::OperandTypeIllegal, at, 1, std::string(word.address->name));
        word.further.push_back(std::move(further));
    }
    return cursor_.eat(')') || syntax(cursor_.at(), ")");
}

bool Interpreter::add_word(Word word, const char* begin) {
    word.column = static_cast<std::uint16_t>(std::min<std::size_t>(cursor_.column(begin), 65535));
    word.length = static_cast<std::uint16_t>(
        std::min<std::size_t>(static_cast<std::size_t>(cursor_.at() - begin), 65535));
    const Address& address = *word.address;
    const bool axis_word = word.address == &kAxisAddress;
    if (!takes_mode(address.name, word.mode)) {
        std::string said = axis_word ? axis_name(word.axis) : std::string(address.name);
        for (const ModeName& row : kModes)
            if (row.mode == word.mode) said += "=" + std::string(row.name);
        return fail_at(Alarm::SyntaxWrong, begin, word.length, std::move(said));
    }
    const bool text_allowed = address.name == "T";
    if (word.mode != Mode::Plain && word.value.type == Type::String && !text_allowed)
        return fail_at(Alarm::OperandTypeIllegal, begin, word.length, std::string(address.name));
    if (!word.value.is_number() && !(text_allowed && word.value.type == Type::String))
        return fail_at(Alarm::OperandTypeIllegal, begin, word.length,
                       (axis_word ? axis_name(word.axis) : std::string(address.name)) + ": " +
                           std::string(type_name(word.value.type)));
    if (!address.is_signed && word.value.number < 0)
        return fail_at(Alarm::NegativeSign, begin, word.length, std::string(address.name));
    for (const Word& other : block_.words) {
        if (other.address != word.address) continue;
        const bool same =
            axis_word ? other.axis == word.axis
                      : !address.repeats || (address.index != Address::Index::None &&
                                             address.name != "M" && address.name != "H" &&
                                             other.axis == word.axis && other.index == word.index);
        if (same)
            return fail_at(Alarm::AddressTwice, begin, word.length,
                           axis_word ? axis_name(word.axis) : std::string(address.name));
    }
    block_.words.push_back(std::move(word));
    return true;
}

const Word* Interpreter::word(std::string_view name) const {
    const Word* found = nullptr;
    for (const Word& word : block_.words)
        if (word.address->name == name) found = &word;
    return found;
}

bool Interpreter::names_moved_axis(const Word& word) {
    return word.axis >= 0 && word.axis < kSpindleAxis &&
           (word.address->name == "axis" || word.address->name.starts_with("POS"));
}

AxisSet Interpreter::axis_words() const {
    AxisSet set = 0;
    for (const Word& word : block_.words)
        if (word.address == &kAxisAddress) set |= 1u << word.axis;
    return set;
}

}  // namespace polyturn::channels::sinumerik
