// Arithmetic and text functions (sinumerik_part3 9.6, 9.7), axes and other small questions (9.4,
// 9.9).
#include "channels/sinumerik/variables/functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "channels/angles.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// Right at whole quarter turns, where the sine of a rounded angle is not.
double sine_deg(double degrees) {
    const double turn = std::fmod(degrees, 360.0);
    if (std::fmod(turn, 180.0) == 0.0) return 0.0;
    if (turn == 90.0 || turn == -270.0) return 1.0;
    if (turn == 270.0 || turn == -90.0) return -1.0;
    return std::sin(turn * kDegree);
}
double cosine_deg(double degrees) { return sine_deg(std::fmod(degrees, 360.0) + 90.0); }

bool read_number(const std::string& text, double& number) {
    std::size_t i = 0;
    const auto blanks = [&] {
        while (i < text.size() && is_blank(text[i])) ++i;
    };
    blanks();
    std::string digits;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) {
        if (text[i] == '-') digits += '-';
        ++i;
    }
    bool any = false, point = false;
    for (; i < text.size() && (is_digit(text[i]) || text[i] == '.'); ++i) {
        if (text[i] == '.' && std::exchange(point, true)) return false;
        any = any || is_digit(text[i]);
        digits += text[i];
    }
    if (!any) return false;
    if (i + 1 < text.size() && upper(text[i]) == 'E') {
        i += upper(text[i + 1]) == 'X' ? 2 : 1;
        std::string exponent;
        if (i < text.size() && (text[i] == '+' || text[i] == '-')) exponent += text[i++];
        bool digit = false;
        for (; i < text.size() && is_digit(text[i]); ++i) {
            exponent += text[i];
            digit = true;
        }
        if (!digit || exponent.size() > 4) return false;
        digits += "e" + exponent;
    }
    blanks();
    if (i != text.size()) return false;
    number = std::strtod(digits.c_str(), nullptr);
    return std::isfinite(number);
}

Value same_type(const Value& like, double number) {
    return like.type == Type::Real ? Value::of_real(number) : Value::of_int(number);
}

}  // namespace

bool f_abs(Execution&, Call& c) {
    c.result = same_type(c.value(0), std::fabs(c.number(0)));
    return true;
}
bool f_sin(Execution&, Call& c) {
    c.result = Value::of_real(sine_deg(c.number(0)));
    return true;
}
bool f_cos(Execution&, Call& c) {
    c.result = Value::of_real(cosine_deg(c.number(0)));
    return true;
}

bool f_tan(Execution& x, Call& c) {
    const double cosine = cosine_deg(c.number(0));
    if (cosine == 0.0) return fail(x, Alarm::FunctionArgument, "TAN", c.number(0));
    c.result = Value::of_real(sine_deg(c.number(0)) / cosine);
    return true;
}

bool f_asin(Execution& x, Call& c) {
    if (std::fabs(c.number(0)) > 1) return fail(x, Alarm::FunctionArgument, "ASIN", c.number(0));
    c.result = Value::of_real(std::asin(c.number(0)) / kDegree);
    return true;
}

bool f_acos(Execution& x, Call& c) {
    if (std::fabs(c.number(0)) > 1) return fail(x, Alarm::FunctionArgument, "ACOS", c.number(0));
    c.result = Value::of_real(std::acos(c.number(0)) / kDegree);
    return true;
}

bool f_atan2(Execution&, Call& c) {
    c.result = Value::of_real(std::atan2(c.number(0), c.number(1)) / kDegree);
    return true;
}

bool f_sqrt(Execution& x, Call& c) {
    if (c.number(0) < 0) return fail(x, Alarm::FunctionArgument, "SQRT", c.number(0));
    c.result = Value::of_real(std::sqrt(c.number(0)));
    return true;
}

bool f_pot(Execution&, Call& c) {
    c.result = Value::of_real(c.number(0) * c.number(0));
    return true;
}
bool f_trunc(Execution&, Call& c) {
    c.result = Value::of_real(std::trunc(c.number(0)));
    return true;
}
bool f_round(Execution&, Call& c) {
    c.result = Value::of_real(std::round(c.number(0)));
    return true;
}
bool f_roundup(Execution&, Call& c) {
    c.result = Value::of_real(c.number(0) < 0 ? std::floor(c.number(0)) : std::ceil(c.number(0)));
    return true;
}

bool f_ln(Execution& x, Call& c) {
    if (c.number(0) <= 0) return fail(x, Alarm::FunctionArgument, "LN", c.number(0));
    c.result = Value::of_real(std::log(c.number(0)));
    return true;
}

bool f_exp(Execution& x, Call& c) {
    if (c.number(0) > 700) return fail(x, Alarm::FunctionArgument, "EXP", c.number(0));
    c.result = Value::of_real(std::exp(c.number(0)));
    return true;
}

bool f_minval(Execution&, Call& c) {
    c.result = c.number(1) < c.number(0) ? c.value(1) : c.value(0);
    return true;
}
bool f_maxval(Execution&, Call& c) {
    c.result = c.number(1) > c.number(0) ? c.value(1) : c.value(0);
    return true;
}

bool f_bound(Execution& x, Call& c) {
    if (c.number(0) > c.number(1)) return fail(x, Alarm::FunctionArgument, "BOUND", c.number(0));
    c.result = c.number(2) < c.number(0)   ? c.value(0)
               : c.number(2) > c.number(1) ? c.value(1)
                                           : c.value(2);
    return true;
}

bool f_isnumber(Execution&, Call& c) {
    double number = 0;
    c.result = Value::of_bool(read_number(c.value(0).text, number));
    return true;
}

bool f_number(Execution& x, Call& c) {
    double number = 0;
    if (!read_number(c.value(0).text, number))
        return fail(x, Alarm::ConversionImpossible, "NUMBER(\"" + c.value(0).text + "\")");
    c.result = Value::of_real(number);
    return true;
}

bool f_toupper(Execution&, Call& c) {
    c.result = Value::of_text(upper(c.value(0).text));
    return true;
}

bool f_tolower(Execution&, Call& c) {
    std::string text = c.value(0).text;
    for (char& letter : text)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    c.result = Value::of_text(std::move(text));
    return true;
}

bool f_strlen(Execution&, Call& c) {
    c.result = Value::of_int(static_cast<double>(c.value(0).text.size()));
    return true;
}

namespace {
Value position(std::size_t at) {
    return Value::of_int(at == std::string::npos ? -1.0 : static_cast<double>(at));
}
char character(const Value& value) {
    return value.type == Type::String ? value.text[0] : static_cast<char>(value.number);
}
}  // namespace

bool f_index(Execution&, Call& c) {
    c.result = position(c.value(0).text.find(character(c.value(1))));
    return true;
}
bool f_rindex(Execution&, Call& c) {
    c.result = position(c.value(0).text.rfind(character(c.value(1))));
    return true;
}
bool f_mindex(Execution&, Call& c) {
    c.result = position(c.value(0).text.find_first_of(c.value(1).text));
    return true;
}
bool f_match(Execution&, Call& c) {
    c.result = position(c.value(0).text.find(c.value(1).text));
    return true;
}

bool f_substr(Execution& x, Call& c) {
    const std::string& text = c.value(0).text;
    const double start = c.number(1), length = c.number(2, 1e6);
    if (start < 0 || length < 0)
        return fail(x, Alarm::FunctionArgument, "SUBSTR", start < 0 ? start : length);
    c.result = Value::of_text(start >= static_cast<double>(text.size())
                                  ? std::string()
                                  : text.substr(static_cast<std::size_t>(start),
                                                static_cast<std::size_t>(std::min(length, 1e6))));
    return true;
}

// Formats as of C: %B %C %D %F %E %G %S %X %U %nD %n.mF; %<text>: what is no format stays.
bool f_sprint(Execution& x, Call& c) {
    const std::string& format = c.value(0).text;
    std::string out;
    std::size_t next = 1;
    for (std::size_t i = 0; i < format.size(); ++i) {
        if (format[i] != '%') {
            out += format[i];
            continue;
        }
        if (i + 1 < format.size() && format[i + 1] == '%') {
            out += '%';
            ++i;
            continue;
        }
        std::size_t j = i + 1;
        int width = 0, places = -1;
        bool left = false, zeros = false;
        for (; j < format.size() && (format[j] == '-' || format[j] == '0' || format[j] == '+');
             ++j) {
            left = left || format[j] == '-';
            zeros = zeros || format[j] == '0';
        }
        for (; j < format.size() && is_digit(format[j]) && width < 200; ++j)
            width = width * 10 + (format[j] - '0');
        if (j < format.size() && format[j] == '.')
            for (places = 0, ++j; j < format.size() && is_digit(format[j]) && places < 100; ++j)
                places = places * 10 + (format[j] - '0');
        if (j == format.size())
            return fail(x, Alarm::FunctionArgument, "SPRINT", static_cast<double>(i));
        if (!c.has(next))
            return fail(x, Alarm::ArgumentCountIllegal, "SPRINT", static_cast<double>(next));
        const Value& value = c.value(next++);
        std::string piece;
        const int digits = places < 0 ? 6 : std::min(places, 15);
        switch (upper(format[j])) {
            case 'D':
                piece = fmt::format("{:.0f}", std::round(value.number));
                break;
            case 'U':
                piece = fmt::format("{:.0f}", std::fabs(std::round(value.number)));
                break;
            case 'F':
                piece = fmt::format("{:.{}f}", value.number, digits);
                break;
            case 'E':
                piece = fmt::format("{:.{}e}", value.number, digits);
                break;
            case 'G':
                piece = fmt::format("{:.{}g}", value.number, std::max(digits, 1));
                break;
            case 'X':
                piece = fmt::format(
                    "{:X}", static_cast<std::uint32_t>(static_cast<std::int64_t>(value.number)));
                break;
            case 'B':
                piece = value.is_true() ? "TRUE" : "FALSE";
                break;
            case 'C':
                piece = to_text(value);
                break;
            case 'S':
                piece = places >= 0 ? to_text(value).substr(0, static_cast<std::size_t>(places))
                                    : to_text(value);
                break;
            default:
                return fail(x, Alarm::FunctionArgument, "SPRINT", static_cast<double>(i));
        }
        const auto room = static_cast<std::size_t>(std::min(width, 200));
        if (piece.size() < room)
            piece.insert(left ? piece.size() : 0, room - piece.size(), zeros && !left ? '0' : ' ');
        out += piece;
        i = j;
    }
    c.result = Value::of_text(std::move(out));
    return true;
}

// The circle through three points, or the best one through four (least squares would be another
// thing: the fourth must lie on it).
bool f_calcdat(Execution& x, Call& c) {
    Variable& points = *c.arguments[0].reference.variable;
    Variable& result = *c.arguments[2].reference.variable;
    const auto count = static_cast<std::size_t>(c.number(1));
    if ((count != 3 && count != 4) || points.cells.size() < 2 * count ||
        points.dimensions.size() != 2 || points.dimensions[1] < 2 || result.cells.size() < 3)
        return fail(x, Alarm::FunctionArgument, "CALCDAT", static_cast<double>(count));
    const std::size_t width = points.dimensions[1];
    const auto at = [&](std::size_t i, std::size_t k) {
        return points.cells[i * width + k].number;
    };
    const double ax = at(0, 0), ay = at(0, 1), bx = at(1, 0) - ax, by = at(1, 1) - ay,
                 cx = at(2, 0) - ax, cy = at(2, 1) - ay;
    const double d = 2 * (bx * cy - by * cx);
    bool found = std::fabs(d) > 1e-12;
    if (found) {
        const double ux = (cy * (bx * bx + by * by) - by * (cx * cx + cy * cy)) / d,
                     uy = (bx * (cx * cx + cy * cy) - cx * (bx * bx + by * by)) / d;
        const double radius = std::hypot(ux, uy);
        if (count == 4)
            found = std::fabs(std::hypot(at(3, 0) - ax - ux, at(3, 1) - ay - uy) - radius) < 1e-3;
        const double values[] = {ax + ux, ay + uy, radius};
        for (std::size_t i = 0; i < 3 && found; ++i)
            store(x, {c.arguments[2].reference.variable, i, false}, Value::of_real(values[i]));
    }
    c.result = Value::of_bool(found);
    return true;
}

}  // namespace polyturn::channels::sinumerik
