#include "channels/fagor/grammar/expression.hpp"

#include <cmath>
#include <numbers>

#include "channels/angles.hpp"
#include "channels/text/chars.hpp"
#include "channels/text/number.hpp"

namespace polyturn::channels::fagor {
namespace {

// 32 bits, as the operators see a number; the sign of a negative one is its highest bit.
std::uint32_t bits_of(double value) {
    const double whole = std::fmod(std::trunc(value), 4294967296.0);
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(whole));
}

double exact(double value) { return std::fabs(value) < 1e-15 ? 0.0 : value; }  // SIN 180 is 0

// Hexadecimal digits that read like the decimal digits of the number, and back.
double to_bcd(double value) {
    auto number = static_cast<std::uint64_t>(std::trunc(value));
    std::uint64_t out = 0;
    for (unsigned shift = 0; number && shift < 32; shift += 4, number /= 10)
        out |= (number % 10) << shift;
    return static_cast<double>(out);
}

double from_bcd(double value) {
    std::uint32_t bits = bits_of(value);
    double out = 0.0, weight = 1.0;
    for (; bits; bits >>= 4, weight *= 10) {
        if ((bits & 15u) > 9) return value;  // no BCD: the value itself
        out += weight * (bits & 15u);
    }
    return out;
}

constexpr std::string_view kFunctions[] = {"SIN",   "COS", "TAN", "ASIN", "ACOS",
                                           "ATAN",  "ARG", "ABS", "LOG",  "SQRT",
                                           "ROUND", "FIX", "FUP", "BCD",  "BIN"};

bool is_function(std::string_view name) {
    for (const std::string_view known : kFunctions)
        if (known == name) return true;
    return false;
}

}  // namespace

bool Expression::fail(Alarm alarm, const char* at, std::string detail, std::size_t length) {
    if (!needs_barrier_) fault_ = {alarm, at, length, std::move(detail)};
    return false;
}

Expression::Status Expression::finish(bool good, const char*& at) {
    if (good) {
        at = p_;
        return Status::Ok;
    }
    return needs_barrier_ ? Status::NeedsBarrier : Status::Fault;
}

Expression::Status Expression::evaluate(const char*& at, const char* end, double& value) {
    p_ = at;
    end_ = end;
    depth_ = 0;
    needs_barrier_ = false;
    Value v;
    bool good = either(v);
    if (good && !(std::fabs(v.number) < 1e15))
        good = fail(Alarm::ResultOutOfRange, at, std::string(at, p_));
    value = v.number;
    return finish(good, at);
}

Expression::Status Expression::target(const char*& at, const char* end, Target& target) {
    p_ = at;
    end_ = end;
    depth_ = 0;
    needs_barrier_ = false;
    return finish(read_target(target), at);
}

// An operator word: letters that begin with it are it, for a name cannot follow a value.
bool Expression::take_word(std::string_view word) {
    blanks();
    if (static_cast<std::size_t>(end_ - p_) < word.size() ||
        std::string_view(p_, word.size()) != word)
        return false;
    p_ += word.size();
    return true;
}

bool Expression::either(Value& v) {
    if (!both(v)) return false;
    while (take_word("OR")) {
        Value w;
        if (!both(w)) return false;
        if (v.condition && w.condition)
            v.number = v.number != 0 || w.number != 0;
        else
            v = {static_cast<double>(bits_of(v.number) | bits_of(w.number)), false};
    }
    return true;
}

bool Expression::both(Value& v) {
    if (!relation(v)) return false;
    for (;;) {
        const bool exclusive = take_word("XOR");
        if (!exclusive && !take_word("AND")) return true;
        Value w;
        if (!relation(w)) return false;
        if (v.condition && w.condition)
            v.number =
                exclusive ? (v.number != 0) != (w.number != 0) : v.number != 0 && w.number != 0;
        else
            v = {static_cast<double>(exclusive ? bits_of(v.number) ^ bits_of(w.number)
                                               : bits_of(v.number) & bits_of(w.number)),
                 false};
    }
}

bool Expression::relation(Value& v) {
    if (!sum(v)) return false;
    static constexpr std::string_view kWords[] = {"EQ", "NE", "GT", "GE", "LT", "LE"};
    for (;;) {
        int which = -1;
        for (int i = 0; i < 6 && which < 0; ++i)
            if (take_word(kWords[i])) which = i;
        if (which < 0) return true;
        Value w;
        if (!sum(w)) return false;
        const double a = v.number, b = w.number;
        const bool same =
            std::fabs(a - b) <= 1e-9 * std::fmax(1.0, std::fmax(std::fabs(a), std::fabs(b)));
        const bool result[] = {same,          !same,          a > b && !same,
                               a > b || same, a < b && !same, a < b || same};
        v = {result[which] ? 1.0 : 0.0, true};
    }
}

bool Expression::sum(Value& v) {
    if (!product(v)) return false;
    for (;;) {
        blanks();
        if (p_ == end_ || (*p_ != '+' && *p_ != '-')) return true;
        const char sign = *p_++;
        Value w;
        if (!product(w)) return false;
        v = {sign == '+' ? v.number + w.number : v.number - w.number, false};
    }
}

bool Expression::product(Value& v) {
    if (!power(v)) return false;
    for (;;) {
        blanks();
        if (p_ == end_ || (*p_ != '*' && *p_ != '/')) return true;
        const char* const sign = p_++;
        Value w;
        if (!power(w)) return false;
        if (*sign == '/' && w.number == 0) return fail(Alarm::DivisionByZero, sign);
        v = {*sign == '*' ? v.number * w.number : v.number / w.number, false};
    }
}

bool Expression::power(Value& v) {
    if (!unary(v)) return false;
    for (;;) {
        blanks();
        const char* const sign = p_;
        const bool remainder = take_word("MOD");
        if (!remainder && !take_word("EXP")) return true;
        Value w;
        if (!unary(w)) return false;
        if (remainder && w.number == 0) return fail(Alarm::DivisionByZero, sign, {}, 3);
        const double result =
            remainder ? std::fmod(v.number, w.number) : std::pow(v.number, w.number);
        if (!std::isfinite(result)) return fail(Alarm::ResultOutOfRange, sign, "EXP", 3);
        v = {result, false};
    }
}

bool Expression::unary(Value& v) {
    blanks();
    if (p_ == end_) return fail(Alarm::VariableIllegal, p_, "a value is missing");
    if (*p_ == '-' || *p_ == '+') {
        const bool negative = *p_++ == '-';
        if (++depth_ > kDepth) return fail(Alarm::BracketsTooDeep, p_);
        if (!unary(v)) return false;
        --depth_;
        v = {negative ? -v.number : v.number, false};
        return true;
    }
    if (static_cast<std::size_t>(end_ - p_) > 3 && std::string_view(p_, 3) == "NOT") {
        p_ += 3;
        if (++depth_ > kDepth) return fail(Alarm::BracketsTooDeep, p_);
        if (!unary(v)) return false;
        --depth_;
        if (v.condition)
            v.number = v.number == 0 ? 1.0 : 0.0;
        else
            v.number = static_cast<double>(~bits_of(v.number));
        return true;
    }
    return primary(v);
}

bool Expression::bracket(Value& v) {
    const char* const open = p_++;
    if (++depth_ > kDepth) return fail(Alarm::BracketsTooDeep, open);
    if (!either(v)) return false;
    blanks();
    if (p_ == end_ || *p_ != ')') return fail(Alarm::FagorBracket, open);
    ++p_;
    --depth_;
    return true;
}

bool Expression::primary(Value& v) {
    const char* const begin = p_;
    if (*p_ == '(') return bracket(v);
    if (*p_ == '$') {
        std::uint64_t number = 0;
        unsigned digits = 0;
        for (++p_; p_ != end_; ++p_, ++digits) {
            const char c = *p_;
            const int digit = is_digit(c) ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
            if (digit < 0) break;
            number = number << 4 | static_cast<unsigned>(digit);
            if (digits == 8) return fail(Alarm::DigitsTooMany, begin, std::string(begin, p_ + 1));
        }
        if (digits == 0) return fail(Alarm::NumberMissing, begin, "$");
        v = {static_cast<double>(number), false};
        return true;
    }
    if (is_digit(*p_) || *p_ == '.') {
        const ScannedNumber number = scan_number(p_, end_);
        if (number.status != ScannedNumber::Status::Ok)
            return fail(number.status == ScannedNumber::Status::SecondPoint ? Alarm::SecondPoint
                                                                            : Alarm::DigitsTooMany,
                        begin, std::string(begin, p_));
        if (std::fabs(number.value) >= 1e6)
            return fail(Alarm::DigitsTooMany, begin, std::string(begin, p_),
                        static_cast<std::size_t>(p_ - begin));
        v = {number.value, false};
        return true;
    }
    if (!is_capital(*p_)) return fail(Alarm::VariableIllegal, begin, std::string(1, *begin));
    const char* q = p_;
    while (q != end_ && is_capital(*q)) ++q;
    const std::string_view name(p_, static_cast<std::size_t>(q - p_));
    char axis = 0;
    if (name == "PI") {
        p_ = q;
        v = {std::numbers::pi, false};
        return true;
    }
    if (is_function(name)) {
        p_ = q;
        return function(name, v);
    }
    // SINP5: the function ends where its name does
    if (name.size() > 1 && !find_variable(name, axis)) {
        for (std::size_t length = name.size() - 1; length >= 3; --length) {
            if (!is_function(name.substr(0, length))) continue;
            p_ += length;
            return function(name.substr(0, length), v);
        }
    }
    Target target;
    if (!read_target(target)) return false;
    double value = 0.0;
    switch (host_->read(target, value)) {
        case Access::Ok:
            v = {value, false};
            return true;
        case Access::NeedsBarrier:
            needs_barrier_ = true;
            return false;
        case Access::Fault:
            if (!fault_.at) fault_.at = begin;
            return false;
        default:
            return fail(Alarm::VariableUnknown, begin, target_name(target),
                        static_cast<std::size_t>(p_ - begin));
    }
}

// In brackets, or a number without them.
bool Expression::argument(double& value) {
    blanks();
    Value v;
    if (p_ == end_) return fail(Alarm::VariableIllegal, p_, "a value is missing");
    const char first = *p_;  // without brackets a constant only (11.5)
    const bool constant =
        (first >= '0' && first <= '9') || first == '.' || first == '$' || first == '-' ||
        first == '+' || std::string_view(p_, static_cast<std::size_t>(end_ - p_)).starts_with("PI");
    if (first != '(' && !constant) return fail(Alarm::FagorBracket, p_);
    if (first == '(' ? !bracket(v) : !unary(v)) return false;
    value = v.number;
    return true;
}

bool Expression::function(std::string_view name, Value& v) {
    const char* const begin = p_ - name.size();
    if (name == "ARG") {
        blanks();
        if (p_ == end_ || *p_ != '(') return fail(Alarm::FagorBracket, begin);
        ++p_;
        Value x, y;
        if (!either(x)) return false;
        blanks();
        if (p_ == end_ || *p_ != ',') return fail(Alarm::VariableIllegal, p_, "ARG(x,y)");
        ++p_;
        if (!either(y)) return false;
        blanks();
        if (p_ == end_ || *p_ != ')') return fail(Alarm::FagorBracket, begin);
        ++p_;
        double angle = std::atan2(y.number, x.number) / kDegree;
        if (angle < 0) angle += 360.0;
        v = {angle, false};
        return true;
    }
    double a = 0.0, result = 0.0;
    if (!argument(a)) return false;
    if (name == "SIN")
        result = exact(std::sin(a * kDegree));
    else if (name == "COS")
        result = exact(std::cos(a * kDegree));
    else if (name == "TAN") {
        if (std::fabs(std::cos(a * kDegree)) < 1e-12)
            return fail(Alarm::ResultOutOfRange, begin, "TAN", 3);
        result = exact(std::tan(a * kDegree));
    } else if (name == "ASIN" || name == "ACOS") {
        if (std::fabs(a) > 1) return fail(Alarm::ResultOutOfRange, begin, std::string(name), 4);
        result = (name == "ASIN" ? std::asin(a) : std::acos(a)) / kDegree;
    } else if (name == "ATAN")
        result = std::atan(a) / kDegree;
    else if (name == "ABS")
        result = std::fabs(a);
    else if (name == "LOG") {
        if (a <= 0) return fail(Alarm::ResultOutOfRange, begin, "LOG", 3);
        result = std::log10(a);
    } else if (name == "SQRT") {
        if (a < 0) return fail(Alarm::ResultOutOfRange, begin, "SQRT", 4);
        result = std::sqrt(a);
    } else if (name == "ROUND")
        result = std::round(a);
    else if (name == "FIX")
        result = std::trunc(a);
    else if (name == "FUP")
        result = a == std::trunc(a) ? a : std::trunc(a) + 1.0;
    else if (name == "BCD") {
        if (a < 0 || a > 99'999'999) return fail(Alarm::ResultOutOfRange, begin, "BCD", 3);
        result = to_bcd(a);
    } else
        result = from_bcd(a);
    v = {result, false};
    return true;
}

// A whole number, or an expression in brackets.
bool Expression::index(double& value) {
    blanks();
    const char* const begin = p_;
    if (p_ != end_ && *p_ == '(') {
        Value v;
        if (!bracket(v)) return false;
        value = std::trunc(v.number);
        return true;
    }
    if (p_ == end_ || !is_digit(*p_)) {
        // One parameter may stand without brackets.
        if (p_ == end_ || *p_ != 'P')
            return fail(Alarm::VariableIllegal, begin, "the number is missing");
        Value v;
        if (!primary(v)) return false;
        value = std::trunc(v.number);
        return true;
    }
    return whole(value);
}

bool Expression::whole(double& value) {
    value = 0.0;
    unsigned digits = 0;
    for (; p_ != end_ && is_digit(*p_); ++p_, ++digits) {
        if (digits == 9) return fail(Alarm::DigitsTooMany, p_);
        value = value * 10 + (*p_ - '0');
    }
    return true;
}

bool Expression::read_target(Target& target) {
    blanks();
    const char* const begin = p_;
    if (p_ == end_ || !is_capital(*p_))
        return fail(Alarm::VariableIllegal, p_,
                    p_ == end_ ? "a name is missing" : std::string(1, *p_));
    const char* q = p_;
    while (q != end_ && is_capital(*q)) ++q;
    const std::string_view name(p_, static_cast<std::size_t>(q - p_));
    if (*p_ == 'P' && (q - p_ == 1)) {
        const char* r = q;
        while (r != end_ && (*r == ' ' || *r == '\t')) ++r;
        if (r != end_ && (is_digit(*r) || *r == '(')) {
            double number = 0.0;
            p_ = r;
            if (!index(number)) return false;
            target.number = static_cast<std::int64_t>(number);
            return true;
        }
    }
    target.row = find_variable(name, target.axis);
    if (!target.row) {
        // One letter is a local parameter; so is the first letter where an operator follows without
        // a blank.
        p_ = begin + 1;
        target.number = *begin - 'A';
        target.by_letter = true;
        if (name.size() == 1) return true;
        for (const std::string_view word :
             {"EQ", "NE", "GT", "GE", "LT", "LE", "AND", "OR", "XOR", "MOD", "EXP"})
            if (name.substr(1).starts_with(word)) return true;
        p_ = begin;
        return fail(Alarm::VariableUnknown, begin, std::string(name), name.size());
    }
    p_ = q;
    switch (target.row->shape) {
        case Shape::Plain:
        case Shape::Axis:
            return true;
        case Shape::Index:
        case Shape::AxisIndex:
            target.has_index = true;
            return index(target.index);
        case Shape::AxisOrIndex: {
            const char* r = p_;
            while (r != end_ && (*r == ' ' || *r == '\t')) ++r;
            if (r == end_ || !(is_digit(*r) || *r == '(')) return true;
            target.has_index = true;
            return index(target.index);
        }
        case Shape::BlockOfProgram:
            target.has_index = true;
            blanks();
            if (p_ == end_ || *p_ != 'N') return fail(Alarm::VariableIllegal, p_, "N");
            ++p_;
            if (!index(target.index)) return false;
            blanks();
            if (p_ == end_ || *p_ != 'P') return fail(Alarm::VariableIllegal, p_, "P");
            ++p_;
            return index(target.second);
    }
    return true;
}

std::string target_name(const Target& target) {
    if (!target.row) return "P" + std::to_string(target.number);
    std::string name(target.row->name);
    if (target.axis) name += target.axis;
    if (target.has_index) name += std::to_string(static_cast<std::int64_t>(target.index));
    return name;
}

}  // namespace polyturn::channels::fagor
