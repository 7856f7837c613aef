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
#include "channels/fanuc/tools/managed_tool.hpp"

#include <fmt/format.h>

#include <cmath>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"

namespace polyturn::channels::fanuc {
namespace {

std::int64_t modulus_of(unsigned digits) {
    std::int64_t value = 1;
    while (digits--) value *= 10;
    return value;
}

}  // namespace

ToolRequest tool_request(const Execution& x) {
    if (!x.settings.managed_tools) return ToolRequest::Plain;
    if (x.settings.place_code != 0)
        for (std::size_t k = 0; k < x.block.count; ++k)
            if (const Word& word = x.block.words[k];
                word.axis < 0 && word.address == 'M' &&
                word.value == static_cast<double>(x.settings.place_code))
                return ToolRequest::Place;
    if (x.settings.offsets_by_g || x.settings.tool.offset_digits == 0) return ToolRequest::Plain;
    const std::int64_t modulus = modulus_of(x.settings.tool.offset_digits);
    const auto offset = static_cast<std::int64_t>(std::nearbyint(x.block.value('T'))) % modulus;
    if (x.settings.managed_offset_code != 0 && offset == x.settings.managed_offset_code &&
        !x.settings.tool.geometry_by_tool)
        return ToolRequest::OwnOffset;
    return x.settings.group_calls && x.settings.tool.offset_digits >= 2 && offset == modulus - 1
               ? ToolRequest::Group
               : ToolRequest::Plain;
}

bool waits_for_tool(const Execution& x) {
    const ToolRequest wish = tool_request(x);
    return wish == ToolRequest::OwnOffset || wish == ToolRequest::Group;
}

bool call_managed_tool(Execution& x) {
    std::int64_t value = 0;
    if (!whole_number(x, 'T', value)) return false;
    const unsigned digits = x.settings.tool.offset_digits;
    x.core.path.tool.ref.number = value / modulus_of(digits);
    x.core.at.tool = x.core.path.tool.ref;
    x.core.aux('T', static_cast<double>(x.core.path.tool.ref.number),
               fmt::format("T{:0{}}", value, digits == 2 ? 4 : digits + 1), true, false,
               tool_request(x) == ToolRequest::Group ? ToolCallBy::Group : ToolCallBy::Type);
    return true;
}

bool names_managed_offset(const Execution& x) {
    if (x.settings.managed_offset_code == 0 || !x.settings.offsets_by_g) return false;
    const auto code = static_cast<double>(x.settings.managed_offset_code);
    return (x.block.has('H') && x.block.value('H') == code) ||
           (x.block.has('D') && x.block.value('D') == code);
}

// Not known in check mode: then no offset acts, and that is reported.
bool managed_offset(Execution& x, bool radius, std::int64_t& offset) {
    const auto tool = x.core.port().tool_at_work();
    const char letter = x.block.has('T') ? 'T' : radius ? 'D' : 'H';
    if (!tool)
        x.core.sink().alarm({Alarm::ManagedToolUnknown,
                             {x.files.path(x.calls.frames.back().file), x.core.at.line, 0, 0},
                             {},
                             fmt::format("{}{:.0f}", letter, x.block.value(letter))},
                            x.core.at);
    offset = !tool ? 0 : radius && tool->radius_offset != 0 ? tool->radius_offset : tool->offset;
    return true;
}

}  // namespace polyturn::channels::fanuc
