// The frames around the programmable one: grinding, settable, basic.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/value.hpp"
#include "channels/state/core.hpp"
#include "channels/state/frame.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;
struct FrameValue;

Frame outer_frame(const Execution& x);
// the point in the settable system
AxisValues programmable(const Execution& x, const AxisValues& target);
void use_frame(Execution& x);
bool g_grinding(Execution& x, const GCode& code);
void choose_settable(Execution& x, int number, std::int32_t row);
bool names_settable(const Execution& x, const std::string& text, int& number);
bool add_to_settable(Execution& x, int number, const Frame& added);
bool frame_component(Execution& x, const std::string& name, const FrameValue& frame,
                     const std::vector<Value>& indices, std::size_t first, Value& value);
bool change_frame_component(Execution& x, const std::string& name, FrameValue& frame,
                            const std::vector<Value>& indices, std::size_t first,
                            const Value& value);
bool outer_frame_value(Execution& x, const std::string& name, const std::vector<Value>& indices,
                       Value& value, bool& known);
bool write_outer_frame(Execution& x, const std::string& name, const std::vector<Value>& indices,
                       const Value& value, bool& known);
void tell_written_zeros(Execution& x);

}  // namespace polyturn::channels::sinumerik
