#include "hmi/machine/tools/tool_in_work.hpp"

#include <cstring>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/machine/tools/tool_words.hpp"
#include "ipc/model/machine/active_tool.hpp"

namespace polyturn::hmi {
namespace {

QString givenName(const ToolRow& tool) {
    return QString::fromUtf8(tool.name.data(),
                             static_cast<int>(::strnlen(tool.name.data(), tool.name.size())));
}

const ToolRow* toolRow(const Live& live, std::int32_t tool) {
    const auto& rows = live.tools().rows;
    return tool > 0 && static_cast<std::size_t>(tool) <= rows.size() &&
                   rows[static_cast<std::size_t>(tool) - 1].used
               ? &rows[static_cast<std::size_t>(tool) - 1]
               : nullptr;
}

}  // namespace

ToolAtWork toolAtWork(const Live& live, unsigned channel) {
    ToolAtWork out;
    const ChannelStatus& status = live.channel(channel);
    const ChannelView& view = live.view(channel);
    const BlockPicture& block = view.picture;
    if (const ToolRow* managed = toolRow(live, status.tool)) {
        out = {managed->type_number, givenName(*managed), 0, true};
    } else if (const std::int32_t station = active_tool(live.table(), live.outputs(), channel);
               station > 0) {
        const auto magazine = static_cast<std::int32_t>(
            params::get(live.table(), params::pt_turret_magazine, channel));
        const ToolPlace* place = magazine > 0 ? placeOf(live, magazine, station) : nullptr;
        const ToolRow* there = place ? toolRow(live, place->tool) : nullptr;
        out = {station, there ? givenName(*there) : QString(), 0, true};
    }
    const QString named = QString::fromUtf8(
        block.tool_name.data(),
        static_cast<int>(::strnlen(block.tool_name.data(), block.tool_name.size())));
    // a tool that is called by its name may have no number
    if (out.number <= 0 && block.tool > 0 && (out.name.isEmpty() || out.name == named))
        out = {block.tool, named, 0, out.certain};
    if (out.number == block.tool && out.name.isEmpty()) out.name = named;
    if (view.known && works(status) && out.number > 0 && block.tool > 0 && block.tool != out.number)
        out.called = block.tool;
    return out;
}

QString toolAtWorkText(const ToolAtWork& tool, bool named) {
    if (tool.number <= 0) return tool.name;
    QString out = QString("T%1").arg(tool.number);
    if (tool.called) return out + QString::fromUtf8(" \u2192 ") + QString("T%1").arg(tool.called);
    return named && !tool.name.isEmpty() ? out + "  " + tool.name : out;
}

}  // namespace polyturn::hmi
