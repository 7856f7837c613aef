// Tools of tool management: which tool a T means is the store's to answer, and only then its offset
// is known.
//
//   T nn <code>             the last digits are N2923 (nct part 2 30.6): nn is the type number, the
//                           offset that of the tool that works
//   T gg 99                 (fanuc) gg is a tool life group; T gg 88 cancels the offset
//   H <code>  D <code>      likewise for the tool in the spindle
//   M<N2924> T mmmmpppp     the tool of this place; no search, no offset
//
// The first two are executed before the rest of their block is read: the block is read again behind
// them.
#include <fmt/format.h>

#include <cmath>

#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {
namespace {
std::int64_t modulus_of(unsigned digits) {
    std::int64_t value = 1;
    while (digits--) value *= 10;
    return value;
}
}  // namespace

Interpreter::ToolRequest Interpreter::tool_request() const {
    if (!settings_.managed_tools) return ToolRequest::Plain;
    if (settings_.place_code != 0)
        for (std::size_t k = 0; k < block_.count; ++k)
            if (const Word& word = block_.words[k];
                word.axis < 0 && word.address == 'M' &&
                word.value == static_cast<double>(settings_.place_code))
                return ToolRequest::Place;
    if (settings_.offsets_by_g || settings_.tool.offset_digits == 0) return ToolRequest::Plain;
    const std::int64_t modulus = modulus_of(settings_.tool.offset_digits);
    const auto offset = static_cast<std::int64_t>(std::nearbyint(block_.value('T'))) % modulus;
    if (settings_.managed_offset_code != 0 && offset == settings_.managed_offset_code &&
        !settings_.tool.geometry_by_tool)
        return ToolRequest::OwnOffset;
    return settings_.group_calls && settings_.tool.offset_digits >= 2 && offset == modulus - 1
               ? ToolRequest::Group
               : ToolRequest::Plain;
}

bool Interpreter::waits_for_tool() const {
    const ToolRequest wish = tool_request();
    return wish == ToolRequest::OwnOffset || wish == ToolRequest::Group;
}

bool Interpreter::call_managed_tool() {
    std::int64_t value = 0;
    if (!whole('T', value)) return false;
    const unsigned digits = settings_.tool.offset_digits;
    core_.path.tool.ref.number = value / modulus_of(digits);
    core_.at.tool = core_.path.tool.ref;
    core_.aux('T', static_cast<double>(core_.path.tool.ref.number),
              fmt::format("T{:0{}}", value, digits == 2 ? 4 : digits + 1), true, false,
              tool_request() == ToolRequest::Group ? ToolCallBy::Group : ToolCallBy::Type);
    return true;
}

bool Interpreter::names_managed_offset() const {
    if (settings_.managed_offset_code == 0 || !settings_.offsets_by_g) return false;
    const auto code = static_cast<double>(settings_.managed_offset_code);
    return (block_.has('H') && block_.value('H') == code) ||
           (block_.has('D') && block_.value('D') == code);
}

// Not known in check mode: then no offset acts, and that is reported.
bool Interpreter::managed_offset(bool radius, std::int64_t& offset) {
    const auto tool = core_.port().tool_at_work();
    const char letter = block_.has('T') ? 'T' : radius ? 'D' : 'H';
    if (!tool)
        core_.sink().alarm({Alarm::ManagedToolUnknown,
                            {files_->path(frames_.back().file), core_.at.line, 0, 0},
                            {},
                            fmt::format("{}{:.0f}", letter, block_.value(letter))},
                           core_.at);
    offset = !tool ? 0 : radius && tool->radius_offset != 0 ? tool->radius_offset : tool->offset;
    return true;
}

}  // namespace polyturn::channels::fanuc
