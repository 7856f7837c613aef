#include "channels/sinumerik/grammar/value.hpp"

#include <fmt/format.h>

namespace polyturn::channels::sinumerik {

std::string_view type_name(Type type) {
    constexpr std::string_view kNames[] = {"BOOL",   "CHAR", "INT",  "REAL",
                                           "STRING", "AXIS", "FRAME"};
    return kNames[static_cast<std::size_t>(type)];
}

bool convert(Value& value, Type to) {
    if (value.type == to) return true;
    if (value.type == Type::Axis || value.type == Type::Frame || to == Type::Axis ||
        to == Type::Frame)
        return false;
    if (value.type == Type::String) {
        if (to == Type::Bool)
            value = Value::of_bool(!value.text.empty());
        else if (value.text.size() == 1)
            value = Value::of_char(static_cast<unsigned char>(value.text[0]));
        else
            return false;
        value.type = to;
        return true;
    }
    switch (to) {
        case Type::Bool:
            value.number = value.number != 0.0 ? 1.0 : 0.0;
            break;
        case Type::Char:
            value.number = std::floor(value.number + 0.5);
            if (!(value.number >= 0 && value.number <= 255)) return false;
            break;
        case Type::Int:
            value.number = std::floor(value.number + 0.5);
            if (!(value.number >= -2147483648.0 && value.number <= 2147483647.0)) return false;
            break;
        case Type::String:
            if (value.type == Type::Char)
                value.text = value.number == 0 ? std::string()
                                               : std::string(1, static_cast<char>(value.number));
            else if (value.type == Type::Bool)
                value.text = value.number != 0 ? "1" : "0";
            else
                return false;
            break;
        default:
            break;
    }
    value.type = to;
    return true;
}

std::string to_text(const Value& value) {
    switch (value.type) {
        case Type::Bool:
            return value.number != 0 ? "TRUE" : "FALSE";
        case Type::Char:
            return std::string(1, static_cast<char>(value.number));
        case Type::Int:
            return fmt::format("{:.0f}", value.number);
        case Type::Real: {
            std::string text = fmt::format("{:.10g}", value.number);
            if (const auto e = text.find('e'); e != std::string::npos) text.replace(e, 1, "EX");
            return text == "-0" ? "0" : text;
        }
        case Type::String:
        case Type::Axis:
            return value.text;
        case Type::Frame:
            break;
    }
    return {};
}

}  // namespace polyturn::channels::sinumerik
