// A value of the language: what an expression yields and a variable holds.
#pragma once
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

#include "channels/sinumerik/frames/frame_value.hpp"

namespace polyturn::channels::sinumerik {

enum class Type : std::uint8_t { Bool, Char, Int, Real, String, Axis, Frame };

// An AXIS value counts the axes of the channel by their places; behind them stand its spindles.
inline constexpr int kSpindleAxis = 1000;  // spindle n is kSpindleAxis + n
// X, Y or Z of a channel that has no such axis: kAbsentAxis - 0, 1, 2. Frames turn about it,
// nothing else takes it.
inline constexpr int kAbsentAxis = -2;

struct Value {
    Type type = Type::Int;
    double number = 0.0;                      // Bool 0 or 1, Char its code, Axis its place
    std::string text;                         // String; Axis: the name as written
    std::shared_ptr<const FrameValue> frame;  // Frame

    static Value of_bool(bool value) { return {Type::Bool, value ? 1.0 : 0.0, {}, {}}; }
    static Value of_int(double value) { return {Type::Int, value, {}, {}}; }
    static Value of_real(double value) { return {Type::Real, value, {}, {}}; }
    static Value of_char(unsigned char value) {
        return {Type::Char, static_cast<double>(value), {}, {}};
    }
    static Value of_text(std::string value) { return {Type::String, 0.0, std::move(value), {}}; }
    static Value of_axis(int place, std::string name) {
        return {Type::Axis, static_cast<double>(place), std::move(name), {}};
    }
    static Value of_frame(FrameValue value) {
        return {Type::Frame, 0.0, {}, std::make_shared<const FrameValue>(std::move(value))};
    }

    bool is_number() const { return type <= Type::Real; }
    bool is_true() const { return type == Type::String ? !text.empty() : number != 0.0; }
    int place() const { return static_cast<int>(number); }
};

std::string_view type_name(Type type);
// What assigning to a variable or passing to a parameter of type `to` makes of it: numbers convert
// among each other (a fraction is rounded), a text of one character is a CHAR, AXIS and FRAME only
// fit themselves. False: they do not.
bool convert(Value& value, Type to);
// As << writes it: 10, 2.5, TRUE.
std::string to_text(const Value& value);

}  // namespace polyturn::channels::sinumerik
