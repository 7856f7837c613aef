// Expressions. Priorities, strongest first: NOT B_NOT and signs | * / DIV MOD : | + - | B_AND |
// B_XOR | B_OR | AND | XOR | OR | << |
// == <> > < >= <=   (so a comparison inside AND or OR needs brackets).
#include "channels/sinumerik/grammar/expression.hpp"

#include <charconv>
#include <cmath>
#include <cstring>

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/frames/frame_functions.hpp"
#include "channels/sinumerik/frames/settable_frames.hpp"
#include "channels/sinumerik/grammar/arguments.hpp"
#include "channels/sinumerik/variables/system_variables.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {
namespace {

enum Op : unsigned {
    kNone,
    kMul,
    kDivide,
    kDiv,
    kMod,
    kChain,
    kAdd,
    kSub,
    kBitAnd,
    kBitXor,
    kBitOr,
    kAnd,
    kXor,
    kOr,
    kJoin,
    kEq,
    kNe,
    kGt,
    kLt,
    kGe,
    kLe
};

struct OpRow {
    std::string_view text;
    Op op;
    unsigned level;  // 0 binds weakest
};
constexpr OpRow kOps[] = {
    {"==", kEq, 0},        {"<>", kNe, 0},   {"<<", kJoin, 1},    {">=", kGe, 0},
    {"<=", kLe, 0},        {">", kGt, 0},    {"<", kLt, 0},       {"OR", kOr, 2},
    {"XOR", kXor, 3},      {"AND", kAnd, 4}, {"B_OR", kBitOr, 5}, {"B_XOR", kBitXor, 6},
    {"B_AND", kBitAnd, 7}, {"+", kAdd, 8},   {"-", kSub, 8},      {"*", kMul, 9},
    {"/", kDivide, 9},     {"DIV", kDiv, 9}, {"MOD", kMod, 9},    {":", kChain, 9},
};
constexpr unsigned kUnary = 10;
// nested brackets: beyond any program, and far from the end of the stack
constexpr unsigned kDeepest = 100;

const OpRow* operator_at(Cursor& cursor) {
    cursor.skip();
    const std::string_view name = cursor.name_ahead();
    if (!name.empty()) {
        const std::string word = upper(name);
        for (const OpRow& row : kOps)
            if (row.text == word) return &row;
        return nullptr;
    }
    const std::string_view rest(cursor.at(), static_cast<std::size_t>(cursor.end() - cursor.at()));
    for (const OpRow& row : kOps)
        if (!is_name_start(row.text[0]) && rest.substr(0, row.text.size()) == row.text) return &row;
    return nullptr;
}

std::int64_t bits_of(double value) { return static_cast<std::int64_t>(std::nearbyint(value)); }
bool both(const Value& a, const Value& b, Type type) { return a.type == type && b.type == type; }

bool unary(Execution& x, Value& value);
bool apply(Execution& x, unsigned op, const char* at, Value& left, const Value& right);
bool primary(Execution& x, Value& value);
bool number_constant(Execution& x, Value& value);
bool quoted_constant(Execution& x, Value& value);
bool string_constant(Execution& x, Value& value);
bool named_value(Execution& x, Value& value);

bool binary(Execution& x, Value& value, unsigned level) {
    if (level == kUnary) return unary(x, value);
    if (!binary(x, value, level + 1)) return false;
    for (;;) {
        const char* const at = x.line.cursor.at();
        const OpRow* op = operator_at(x.line.cursor);
        if (!op || op->level != level) {
            x.line.cursor.at() = at;
            return true;
        }
        x.line.cursor.advance(op->text.size());
        Value right;
        if (!binary(x, right, level + 1) || !apply(x, op->op, at, value, right)) return false;
    }
}

bool unary(Execution& x, Value& value) {
    x.line.cursor.skip();
    const char* const at = x.line.cursor.at();
    if (x.line.cursor.peek() == '-' || x.line.cursor.peek() == '+') {
        const bool negative = *x.line.cursor.at() == '-';
        x.line.cursor.advance(1);
        double number = 0;
        if (!(++x.line.depth <= kDeepest))
            return fail_at(x, Alarm::BracketsTooDeep, at, 1, {}, kDeepest);
        const bool ok = unary(x, value);
        if (x.line.depth) --x.line.depth;
        if (!ok || !number_of(x, value, at, number)) return false;
        value = value.type == Type::Real ? Value::of_real(number) : Value::of_int(number);
        if (negative) value.number = -number;
        return true;
    }
    const std::string_view name = x.line.cursor.name_ahead();
    const std::string word = name.size() <= 5 ? upper(name) : std::string();
    if (word == "NOT" || word == "B_NOT") {
        x.line.cursor.advance(name.size());
        if (!(++x.line.depth <= kDeepest))
            return fail_at(x, Alarm::BracketsTooDeep, at, 1, {}, kDeepest);
        const bool ok = unary(x, value);
        if (x.line.depth) --x.line.depth;
        if (!ok) return false;
        if (!value.is_number())
            return fail_at(x, Alarm::OperandTypeIllegal, at, name.size(),
                           word + " " + std::string(type_name(value.type)));
        if (word == "NOT")
            value = Value::of_bool(!value.is_true());
        else
            value = Value::of_int(static_cast<double>(
                static_cast<std::int32_t>(~static_cast<std::uint32_t>(bits_of(value.number)))));
        return true;
    }
    return primary(x, value);
}

bool primary(Execution& x, Value& value) {
    const char c = x.line.cursor.peek();
    if (c == '(') {
        x.line.cursor.advance(1);
        if (!expression(x, value)) return false;
        return x.line.cursor.eat(')') || syntax(x, x.line.cursor.at(), ")");
    }
    if (is_digit(c) || c == '.') return number_constant(x, value);
    if (c == '\'') return quoted_constant(x, value);
    if (c == '"') return string_constant(x, value);
    if (c == '$') return system_value(x, value);
    if (is_name_start(c)) return named_value(x, value);
    return syntax(x, x.line.cursor.at());
}

bool number_constant(Execution& x, Value& value) {
    const char* p = x.line.cursor.at();
    const char* const from = p;
    std::string digits;
    bool real = false;
    while (p != x.line.cursor.end() && (is_digit(*p) || *p == '.')) {
        if (*p == '.') {
            if (real) return fail_at(x, Alarm::SecondPoint, p, 1);
            real = true;
        }
        digits += *p++;
    }
    // An exponent: EX and a whole number.
    if (p + 1 < x.line.cursor.end() && upper(p[0]) == 'E' && upper(p[1]) == 'X') {
        const char* q = p + 2;
        std::string exponent;
        if (q != x.line.cursor.end() && (*q == '+' || *q == '-')) {
            exponent += *q == '-' ? "-" : "";
            ++q;
        }
        const char* const first = q;
        while (q != x.line.cursor.end() && is_digit(*q)) exponent += *q++;
        if (q == first) return syntax(x, p, "EX");
        digits += "e" + exponent;
        real = true;
        p = q;
    }
    double number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(number))
        return fail_at(
            x,
            error == std::errc::result_out_of_range ? Alarm::ValueOutOfRange : Alarm::NumberMissing,
            from, static_cast<std::size_t>(p - from), digits);
    if (!real && number > 2147483647.0) real = true;  // too large for INT
    value = real ? Value::of_real(number) : Value::of_int(number);
    x.line.cursor.at() = p;
    return true;
}

// 'H7F', 'B1001'; 'a' is a character.
bool quoted_constant(Execution& x, Value& value) {
    const char* const from = x.line.cursor.at();
    const void* const found =
        std::memchr(from + 1, '\'', static_cast<std::size_t>(x.line.cursor.end() - from - 1));
    if (!found) return syntax(x, from, "'");
    const auto* const close = static_cast<const char*>(found);
    const std::string_view inside(from + 1, static_cast<std::size_t>(close - from - 1));
    const char kind = inside.empty() ? '\0' : upper(inside[0]);
    x.line.cursor.at() = close + 1;
    if (inside.size() == 1) {
        value = Value::of_char(static_cast<unsigned char>(inside[0]));
        return true;
    }
    if (kind != 'H' && kind != 'B' && kind != 'D') return syntax(x, from, std::string(inside));
    const unsigned base = kind == 'H' ? 16 : kind == 'B' ? 2 : 10;
    std::uint64_t number = 0;
    bool any = false;
    for (const char raw : inside.substr(1)) {
        if (is_blank(raw)) continue;
        const char c = upper(raw);
        const unsigned digit = is_digit(c)            ? static_cast<unsigned>(c - '0')
                               : c >= 'A' && c <= 'F' ? static_cast<unsigned>(c - 'A' + 10)
                                                      : 99;
        if (digit >= base) return syntax(x, from, std::string(inside));
        number = number * base + digit;
        any = true;
        if (number > 0xFFFFFFFFu)
            return fail_at(x, Alarm::ValueOutOfRange, from, inside.size() + 2, std::string(inside));
    }
    if (!any) return syntax(x, from, std::string(inside));
    value = Value::of_int(
        static_cast<double>(static_cast<std::int32_t>(static_cast<std::uint32_t>(number))));
    return true;
}

bool string_constant(Execution& x, Value& value) {
    const char* const from = x.line.cursor.at();
    const void* const found =
        std::memchr(from + 1, '"', static_cast<std::size_t>(x.line.cursor.end() - from - 1));
    if (!found) return syntax(x, from, "\"");
    const auto* const close = static_cast<const char*>(found);
    std::string text(from + 1, static_cast<std::size_t>(close - from - 1));
    // 'H41' inside a text is the character with that code.
    for (std::size_t at = text.find("'H"); at != std::string::npos; at = text.find("'H", at + 1)) {
        const std::size_t end = text.find('\'', at + 1);
        unsigned code = 0;
        if (end == std::string::npos || end - at < 3 || end - at > 4) continue;
        const auto [p, error] = std::from_chars(text.data() + at + 2, text.data() + end, code, 16);
        if (error == std::errc() && p == text.data() + end)
            text.replace(at, end - at + 1, 1, static_cast<char>(code));
    }
    value = Value::of_text(std::move(text));
    x.line.cursor.at() = close + 1;
    return true;
}

bool named_value(Execution& x, Value& value) {
    const char* const from = x.line.cursor.at();
    const std::string_view name = x.line.cursor.name_ahead();
    const std::string word = upper(name);
    if (word == "TRUE" || word == "FALSE") {
        x.line.cursor.advance(name.size());
        value = Value::of_bool(word == "TRUE");
        return true;
    }
    Reference reference;
    if (!reference_ahead(x, reference)) return false;
    if (reference) {
        if (reference.whole && !reference.variable->dimensions.empty())
            return fail_at(x, Alarm::ArrayIndexMissing, from, name.size(), word);
        if (!reference.component.empty() && reference.variable->type == Type::String) {
            std::size_t i = 0;
            if (!character_of(x, reference, from, i)) return false;
            value = Value::of_char(static_cast<unsigned char>(reference.cell().text[i]));
            return true;
        }
        if (!reference.component.empty()) {
            static const FrameValue kNone;
            return frame_component(x, word,
                                   reference.cell().frame ? *reference.cell().frame : kNone,
                                   reference.component, 0, value);
        }
        value = reference.cell();
        return true;
    }
    const Symbol symbol = find_symbol(word);
    if (symbol.kind == Symbol::Kind::Command) {
        const Command& command = symbol.command();
        if (!command.function) return syntax(x, from, word);
        if (!command.act) return fail_at(x, Alarm::NotBuilt, from, name.size(), word);
        x.line.cursor.advance(name.size());
        Call call;
        if (!read_arguments(x, command, call)) return false;
        x.blame.column = x.line.cursor.column(from);
        x.blame.length = name.size();
        if (!command.act(x, call)) return false;
        x.blame.column = x.blame.length = 0;
        value = std::move(call.result);
        return true;
    }
    const int axis = find_axis(x, word);
    if (axis >= 0) {
        x.line.cursor.advance(name.size());
        value = Value::of_axis(axis, word);
        return true;
    }
    if (symbol.kind == Symbol::Kind::Reserved)
        return fail_at(x, Alarm::NotBuilt, from, name.size(), word);
    // frames turn about it
    if (const auto absent = std::string_view("XYZ").find(word);
        word.size() == 1 && absent != std::string_view::npos) {
        x.line.cursor.advance(name.size());
        value = Value::of_axis(kAbsentAxis - static_cast<int>(absent), word);
        return true;
    }
    return fail_at(x, Alarm::NameUnknown, from, name.size(), word);
}

bool apply(Execution& x, unsigned op, const char* at, Value& left, const Value& right) {
    const auto wrong = [&] {
        return fail_at(
            x, Alarm::OperandTypeIllegal, at, 1,
            std::string(type_name(left.type)) + ", " + std::string(type_name(right.type)));
    };
    if (op == kJoin) {
        if (left.type == Type::Frame || right.type == Type::Frame) return wrong();
        left = Value::of_text(to_text(left) + to_text(right));
        return true;
    }
    if (op == kChain) {
        if (!both(left, right, Type::Frame)) return wrong();
        return chain_frames(x, left, right);
    }
    if (op >= kEq) {
        int order = 0;
        if (both(left, right, Type::String)) {
            order = left.text.compare(right.text);
        } else if ((left.type == Type::Char && right.type == Type::String) ||
                   (left.type == Type::String && right.type == Type::Char)) {
            // TEXT[2]=="A"
            order = to_text(left).compare(to_text(right));
        } else if (both(left, right, Type::Axis)) {
            order = left.number < right.number ? -1 : left.number > right.number;
            if (op != kEq && op != kNe) return wrong();
        } else if (left.is_number() && right.is_number()) {
            order = left.number < right.number ? -1 : left.number > right.number;
        } else {
            return wrong();
        }
        left = Value::of_bool(op == kEq   ? order == 0
                              : op == kNe ? order != 0
                              : op == kGt ? order > 0
                              : op == kLt ? order < 0
                              : op == kGe ? order >= 0
                                          : order <= 0);
        return true;
    }
    if (!left.is_number() || !right.is_number()) return wrong();
    const double a = left.number, b = right.number;
    const bool whole = left.type != Type::Real && right.type != Type::Real;
    switch (op) {
        case kMul:
            left = whole ? Value::of_int(a * b) : Value::of_real(a * b);
            break;
        case kAdd:
            left = whole ? Value::of_int(a + b) : Value::of_real(a + b);
            break;
        case kSub:
            left = whole ? Value::of_int(a - b) : Value::of_real(a - b);
            break;
        case kDivide:
        case kDiv:
        case kMod:
            if (b == 0) return fail_at(x, Alarm::DivisionByZero, at, 1);
            if (op == kDivide)
                left = Value::of_real(a / b);
            else if (op == kDiv)
                left = Value::of_int(std::trunc(a / b));
            else
                left = whole ? Value::of_int(std::fmod(a, b)) : Value::of_real(std::fmod(a, b));
            break;
        case kBitAnd:
            left = Value::of_int(
                static_cast<double>(static_cast<std::int32_t>(bits_of(a) & bits_of(b))));
            break;
        case kBitOr:
            left = Value::of_int(
                static_cast<double>(static_cast<std::int32_t>(bits_of(a) | bits_of(b))));
            break;
        case kBitXor:
            left = Value::of_int(
                static_cast<double>(static_cast<std::int32_t>(bits_of(a) ^ bits_of(b))));
            break;
        case kAnd:
            left = Value::of_bool(a != 0 && b != 0);
            break;
        case kOr:
            left = Value::of_bool(a != 0 || b != 0);
            break;
        case kXor:
            left = Value::of_bool((a != 0) != (b != 0));
            break;
        default:
            return wrong();
    }
    if (left.type == Type::Int && (left.number > 2147483647.0 || left.number < -2147483648.0))
        left.type = Type::Real;
    if (!std::isfinite(left.number)) return fail_at(x, Alarm::ValueOutOfRange, at, 1, "overflow");
    return true;
}

}  // namespace

bool expression(Execution& x, Value& value) {
    if (++x.line.depth > kDeepest) {
        x.line.depth = 0;
        return fail_at(x, Alarm::BracketsTooDeep, x.line.cursor.at(), 1, {}, kDeepest);
    }
    const bool ok = binary(x, value, 0);
    if (x.line.depth) --x.line.depth;
    return ok;
}

bool number_of(Execution& x, const Value& value, const char* at, double& number) {
    if (!value.is_number())
        return fail_at(x, Alarm::OperandTypeIllegal, at, 1, std::string(type_name(value.type)));
    number = value.number;
    return true;
}

}  // namespace polyturn::channels::sinumerik
