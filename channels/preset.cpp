#include "channels/preset.hpp"

namespace polyturn::channels {

void preset(Language& language, const text::ChannelSetup& setup) {
    for (const auto& [number, tool] : setup.tools) {
        language.preset_tool(number, tool.name);
        for (const auto& [edge, values] : tool.edges)
            for (const auto& [name, value] : values)
                language.preset_edge(number, edge, name, value);
    }
    for (const text::SetupVariable& variable : setup.variables) {
        if (variable.is_text)
            language.preset_text(variable.name, variable.text);
        else
            language.preset_variable(variable.name, variable.value);
    }
}

}  // namespace polyturn::channels
