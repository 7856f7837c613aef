#include "channels/fanuc/macro/expression.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "channels/text/chars.hpp"
#include "channels/text/number.hpp"

namespace polyturn::channels::fanuc {
namespace {

double zero_if_null(double value) { return is_null(value) ? 0.0 : value; }

// A name written out or by its first two letters.
bool names(std::string_view word, std::string_view name) {
    if (word.size() != name.size() && word.size() != 2) return false;
    for (std::size_t i = 0; i < word.size(); ++i)
        if (capital(word[i]) != name[i]) return false;
    return true;
}

double to_radians(double degrees) { return degrees * std::numbers::pi / 180.0; }
double to_degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

// Exact at the quarter turns, where programs compare with 0 and 1.
double sine(double degrees) {
    const double turn = std::fmod(degrees, 360.0);
    if (turn == 0.0 || std::fabs(turn) == 180.0) return 0.0;
    if (turn == 90.0 || turn == -270.0) return 1.0;
    if (turn == 270.0 || turn == -90.0) return -1.0;
    return std::sin(to_radians(turn));
}
double cosine(double degrees) { return sine(degrees + 90.0); }

std::uint64_t bcd_to_binary(std::uint64_t value, bool& good) {
    std::uint64_t result = 0, weight = 1;
    for (; value; value >>= 4, weight *= 10) {
        if ((value & 15) > 9) good = false;
        result += (value & 15) * weight;
    }
    return result;
}
std::uint64_t binary_to_bcd(std::uint64_t value) {
    std::uint64_t result = 0;
    for (unsigned shift = 0; value && shift < 64; value /= 10, shift += 4)
        result |= (value % 10) << shift;
    return result;
}

// At most eight digits (leading zeros do not count), 0 or 0.0000001 to 99999999.
bool is_short(const char* from, const char* to, double value) {
    unsigned digits = 0;
    for (; from != to; ++from)
        if (*from >= '0' && *from <= '9' && (digits || *from != '0')) ++digits;
    return digits <= 8 &&
           (value == 0 || (std::fabs(value) >= 0.9999999e-7 && std::fabs(value) <= 99999999.0));
}

}  // namespace

std::string variable_name(std::int64_t number) { return "#" + std::to_string(number); }

bool Expression::fail(Alarm alarm, std::string detail, double value) {
    fault_ = {alarm, p_, std::move(detail), value};
    return false;
}

bool Expression::in_range(double value) {
    // fanuc_lathe 6.1; nothing of NaN holds
    if (value == 0 || (std::fabs(value) >= 1e-29 && std::fabs(value) <= 1e47)) return true;
    return fail(Alarm::ResultOutOfRange, "the value is not 0 nor between 1E-29 and 1E47");
}

std::string_view Expression::word() {
    const char* q = p_;
    while (q != end_ && is_letter(*q)) ++q;
    return {p_, static_cast<std::size_t>(q - p_)};
}

void Expression::comments() {
    comments_ = p_;
    skip_comments(p_, end_);
    behind_comments_ = p_;
}

Expression::Status Expression::finish(bool ok, const char*& at) {
    at = ok && p_ == behind_comments_ ? comments_ : p_;
    return ok ? Status::Ok : needs_barrier_ ? Status::NeedsBarrier : Status::Fault;
}

Expression::Status Expression::evaluate(const char*& at, const char* end, double& value) {
    read_from(at, end);
    return finish(comparison(value), at);
}

Expression::Status Expression::operand(const char*& at, const char* end, double& value) {
    read_from(at, end);
    blanks();
    return finish(p_ != end_ && *p_ == '[' ? bracket(value) : variable(value), at);
}

Expression::Status Expression::variable_number(const char*& at, const char* end,
                                               std::int64_t& number) {
    read_from(at, end);
    return finish(at_name() ? named(number) : number_of_variable(number), at);
}

bool Expression::comparison(double& value) {
    if (!sum(value)) return false;
    for (;;) {
        blanks();
        const std::string_view name = word();
        if (name.size() != 2) return true;
        const char a = capital(name[0]), b = capital(name[1]);
        const bool known = (a == 'E' && b == 'Q') || (a == 'N' && b == 'E') ||
                           ((a == 'G' || a == 'L') && (b == 'T' || b == 'E'));
        if (!known) return true;
        p_ += 2;
        double right = 0.0;
        if (!sum(right)) return false;
        bool holds = false;
        if (a == 'E' || a == 'N') {
            const bool same = is_null(value) || is_null(right) ? is_null(value) && is_null(right)
                                                               : value == right;
            holds = a == 'E' ? same : !same;
        } else {
            const double l = zero_if_null(value), r = zero_if_null(right);
            holds = a == 'G' ? (b == 'T' ? l > r : l >= r) : (b == 'T' ? l < r : l <= r);
        }
        value = holds ? 1.0 : 0.0;
    }
}

bool Expression::sum(double& value) {
    if (!product(value)) return false;
    for (;;) {
        blanks();
        if (p_ == end_) return true;
        double right = 0.0;
        const std::string_view name = word();
        if (*p_ == '+' || *p_ == '-') {
            const bool plus = *p_++ == '+';
            if (!product(right)) return false;
            value = zero_if_null(value) + (plus ? zero_if_null(right) : -zero_if_null(right));
            if (!in_range(value)) return false;
        } else if (name.size() >= 2 && (names(name, "OR") || names(name, "XOR"))) {
            const bool exclusive = capital(name[0]) == 'X';
            p_ += name.size();
            if (!product(right)) return false;
            const auto l = static_cast<std::int64_t>(std::llround(zero_if_null(value))),
                       r = static_cast<std::int64_t>(std::llround(zero_if_null(right)));
            value = static_cast<double>(exclusive ? l ^ r : l | r);
        } else {
            return true;
        }
    }
}

bool Expression::product(double& value) {
    if (!factor(value)) return false;
    for (;;) {
        blanks();
        if (p_ == end_) return true;
        double right = 0.0;
        const std::string_view name = word();
        if (*p_ == '*' || *p_ == '/') {
            const bool times = *p_++ == '*';
            if (!factor(right)) return false;
            if (!times && zero_if_null(right) == 0.0) return fail(Alarm::DivisionByZero);
            value = times ? zero_if_null(value) * zero_if_null(right) : zero_if_null(value) / right;
            if (!in_range(value)) return false;
        } else if (name.size() >= 2 && (names(name, "AND") || names(name, "MOD"))) {
            const bool both = capital(name[0]) == 'A';
            p_ += name.size();
            if (!factor(right)) return false;
            if (both) {
                value = static_cast<double>(
                    static_cast<std::int64_t>(std::llround(zero_if_null(value))) &
                    static_cast<std::int64_t>(std::llround(zero_if_null(right))));
            } else {
                if (zero_if_null(right) == 0.0) return fail(Alarm::DivisionByZero);
                value = std::fmod(zero_if_null(value), right);
            }
        } else {
            return true;
        }
    }
}

bool Expression::factor(double& value) {
    blanks();
    if (p_ == end_) return fail(Alarm::VariableIllegal, "it ends too early");
    if (*p_ == '-' || *p_ == '+') {
        const bool minus = *p_++ == '-';
        if (++depth_ > 64) return fail(Alarm::BracketsTooDeep, {}, kDepth);  // a row of signs
        if (!factor(value)) return false;
        --depth_;
        if (minus) value = -zero_if_null(value);
        return true;
    }
    if (*p_ == '#') return variable(value);
    if (*p_ == '[') return bracket(value);
    if (is_letter(*p_)) return function(value);
    const char* const begin = p_;
    const ScannedNumber number = scan_number(p_, end_);
    switch (number.status) {
        case ScannedNumber::Status::Ok:
            value = number.value;
            if (short_constants_ && !is_short(begin, p_, value)) {
                p_ = begin;
                return fail(Alarm::DigitsTooMany, "the number");
            }
            return true;
        case ScannedNumber::Status::Missing:
            p_ = begin;
            return fail(Alarm::VariableIllegal, "a value is missing");
        case ScannedNumber::Status::SecondPoint:
            return fail(Alarm::SecondPoint);
        case ScannedNumber::Status::TooManyDigits:
            break;
    }
    p_ = begin;
    return fail(Alarm::DigitsTooMany, "the number");
}

bool Expression::bracket(double& value) {
    blanks();
    if (p_ == end_ || *p_ != '[') return fail(Alarm::BracketMissing);
    if (at_name()) {
        const char* const begin = p_;
        std::int64_t number = 0;
        return named(number) && read(number, begin, value);
    }
    if (++depth_ > kDepth) return fail(Alarm::BracketsTooDeep, {}, kDepth);
    ++p_;
    if (!comparison(value)) return false;
    blanks();
    if (p_ == end_ || *p_ != ']') return fail(Alarm::BracketMissing);
    ++p_;
    --depth_;
    return true;
}

bool Expression::number_of_variable(std::int64_t& number) {
    if (p_ == end_ || *p_ != '#') return fail(Alarm::VariableIllegal, "# is missing");
    const char* const begin = p_;
    ++p_;
    blanks();
    double value = 0.0;
    // nct part 2 38
    static constexpr std::pair<std::string_view, double> kNamed[] = {{"_ABSOT[", 100100},
                                                                     {"_ABSKP[", 100150}};
    const std::string_view rest(p_, static_cast<std::size_t>(end_ - p_));
    const auto* const named =
        std::find_if(std::begin(kNamed), std::end(kNamed),
                     [&](const auto& one) { return rest.starts_with(one.first); });
    if (named != std::end(kNamed)) {
        p_ += named->first.size() - 1;
        if (!bracket(value)) return false;
        value = zero_if_null(value);
        if (value < 1 || value > 50) {
            p_ = begin;
            return fail(Alarm::VariableUnknown, "#" + std::string(named->first) +
                                                    std::to_string(std::llround(value)) + "]");
        }
        value += named->second;
    } else if (p_ != end_ && *p_ == '[') {
        if (!bracket(value)) return false;
    } else if (p_ != end_ && *p_ == '#') {
        if (++depth_ > kDepth) return fail(Alarm::BracketsTooDeep, {}, kDepth);
        if (!variable(value)) return false;
        --depth_;
    } else {
        const ScannedNumber scanned = scan_number(p_, end_);
        if (scanned.status != ScannedNumber::Status::Ok) {
            p_ = begin;
            return fail(Alarm::VariableIllegal, "the number of the variable is missing");
        }
        value = scanned.value;
    }
    value = zero_if_null(value);
    if (value < 0 || value > 1e7) {
        p_ = begin;
        return fail(Alarm::VariableUnknown, "#" + std::to_string(std::llround(value)));
    }
    number = std::llround(value);
    return true;
}

bool Expression::at_name() const {
    const char* p = p_;
    const auto skip = [&] {
        while (p != end_ && *p == ' ') ++p;
    };
    if (!names_ || p == end_ || *p++ != '[') return false;
    skip();
    if (p == end_ || *p++ != '#') return false;
    skip();
    return p != end_ && VariableNames::begins(*p);
}

bool Expression::named(std::int64_t& number) {
    while (!VariableNames::begins(*p_)) ++p_;
    const char* const begin = p_;
    while (p_ != end_ && VariableNames::goes_on(*p_)) ++p_;
    const std::string_view name(begin, static_cast<std::size_t>(p_ - begin));
    blanks();
    if (p_ == end_ || *p_ != ']') return fail(Alarm::BracketMissing);
    ++p_;
    if (const auto found = names_->find(name)) {
        number = *found;
        return true;
    }
    p_ = begin;
    return fail(Alarm::VariableUnknown, "#" + std::string(name));
}

bool Expression::variable(double& value) {
    const char* const begin = p_;
    std::int64_t number = 0;
    return number_of_variable(number) && read(number, begin, value);
}

bool Expression::read(std::int64_t number, const char* begin, double& value) {
    switch (variables_->read(number, value)) {
        case VariableStatus::Ok:
            return true;
        case VariableStatus::NeedsBarrier:
            needs_barrier_ = true;
            return false;
        default:
            break;
    }
    p_ = begin;
    return fail(Alarm::VariableUnknown, variable_name(number));
}

bool Expression::function(double& value) {
    const char* const begin = p_;
    const std::string_view name = word();
    enum Function {
        Sin,
        Cos,
        Tan,
        Asin,
        Acos,
        Atan,
        Sqrt,
        Abs,
        Ln,
        Exp,
        Round,
        Fix,
        Fup,
        Bin,
        Bcd,
        Count
    };
    static constexpr std::string_view kNames[] = {"SIN",   "COS",  "TAN", "ASIN", "ACOS",
                                                  "ATAN",  "SQRT", "ABS", "LN",   "EXP",
                                                  "ROUND", "FIX",  "FUP", "BIN",  "BCD"};
    int which = 0;
    while (which < Count && !names(name, kNames[which])) ++which;
    if (which == Count) return fail(Alarm::WordUnknown, std::string(name));
    p_ += name.size();
    double x = 0.0;
    if (!bracket(x)) return false;
    x = zero_if_null(x);
    const auto out_of_range = [&] {
        p_ = begin;
        return fail(Alarm::ResultOutOfRange, std::string(kNames[which]));
    };
    switch (which) {
        case Sin:
            value = sine(x);
            break;
        case Cos:
            value = cosine(x);
            break;
        case Tan: {
            const double c = cosine(x);
            if (c == 0.0) {
                p_ = begin;
                return fail(Alarm::DivisionByZero);
            }
            value = sine(x) / c;
            break;
        }
        case Asin:
            if (std::fabs(x) > 1) return out_of_range();
            value = to_degrees(std::asin(x));
            if (angle_positive_ && value < 0) value += 360.0;
            break;
        case Acos:
            if (std::fabs(x) > 1) return out_of_range();
            value = to_degrees(std::acos(x));
            break;
        case Atan: {
            blanks();
            double divisor = 1.0;
            if (p_ != end_ && *p_ == '/') {
                ++p_;
                if (!bracket(divisor)) return false;
                divisor = zero_if_null(divisor);
            }
            value = to_degrees(std::atan2(x, divisor));
            if (angle_positive_ && value < 0) value += 360.0;
            break;
        }
        case Sqrt:
            if (x < 0) return out_of_range();
            value = std::sqrt(x);
            break;
        case Abs:
            value = std::fabs(x);
            break;
        case Ln:
            if (x <= 0) return out_of_range();
            value = std::log(x);
            break;
        case Exp:
            value = std::exp(x);
            if (value > 3.65e47 || value < 1e-29) return out_of_range();
            break;
        case Round:
            value = whole_steps(x, round_step_) * round_step_;
            break;
        case Fix:
            value = std::trunc(x);
            break;
        case Fup:
            value = x < 0 ? std::floor(x) : std::ceil(x);
            break;
        case Bin: {
            bool good = x >= 0;
            value = good ? static_cast<double>(
                               bcd_to_binary(static_cast<std::uint64_t>(std::llround(x)), good))
                         : 0.0;
            if (!good) return out_of_range();
            break;
        }
        case Bcd:
            if (x < 0 || x > 99999999) return out_of_range();
            value = static_cast<double>(binary_to_bcd(static_cast<std::uint64_t>(std::llround(x))));
            break;
        default:
            break;
    }
    return true;
}

}  // namespace polyturn::channels::fanuc
