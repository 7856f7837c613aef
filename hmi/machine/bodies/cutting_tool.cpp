#include "hmi/machine/bodies/cutting_tool.hpp"

#include <algorithm>

namespace polyturn::hmi {
namespace {

constexpr std::size_t kType = 1, kTip = 2, kRadius = 6;  // of ToolEdge::dp

bool isDrill(std::int32_t kind) {
    return (kind >= 200 && kind < 300) || (kind >= 560 && kind < 570);
}
// One that stands on the axis has no corner there: codes 1 to 4 (fagor: the odd ones) name a
// corner, and their radius is that of the nose.
bool corner(Dialect language, int tip) {
    return language == Dialect::Fagor ? tip % 2 == 1 && tip < 9 : tip >= 1 && tip <= 4;
}

const ToolRow* rowOf(const Live& live, const CalledTool& called) {
    const auto& rows = live.tools().rows;
    if (called.data > 0 && static_cast<std::size_t>(called.data) <= rows.size() &&
        rows[static_cast<std::size_t>(called.data) - 1].used)
        return &rows[static_cast<std::size_t>(called.data) - 1];
    const ToolRow* found = nullptr;
    for (const ToolRow& row : rows)
        if (called.number > 0 && row.used && row.type_number == called.number &&
            (!found || row.state & kToolActive))
            found = &row;
    return found;
}

}  // namespace

CutSide sideOfTip(Dialect language, int tip) {
    const bool inwards =
        language == Dialect::Fagor ? tip >= 3 && tip <= 5 : tip == 3 || tip == 4 || tip == 8;
    const bool outwards = language == Dialect::Fagor ? tip == 1 || tip == 7 || tip == 8
                                                     : tip == 1 || tip == 2 || tip == 6;
    return inwards ? CutSide::Outside : outwards ? CutSide::Inside : CutSide::Unknown;
}

CuttingTool cuttingTool(const Live& live, unsigned channel, const CalledTool& called) {
    CuttingTool out;
    out.number = called.number;
    const Dialect language = live.language(channel);
    const ToolRow* row = rowOf(live, called);
    std::int32_t kind = row ? row->kind : 0;
    int tip = 0;
    double radius = 0;
    const ToolEdge* edge = nullptr;
    const auto& edges = live.edges();
    for (std::size_t i = 0; row && i < std::min<std::size_t>(edges.count, edges.edges.size()); ++i)
        if (const ToolEdge& one = edges.edges[i];
            one.tool == static_cast<std::int32_t>(row - live.tools().rows.data()) + 1 &&
            one.number == std::max(1, called.edge))
            edge = &one;
    if (edge && edge->dp[kType] > 0) {
        kind = static_cast<std::int32_t>(edge->dp[kType]);
        radius = edge->dp[kRadius];
        if (!isDrill(kind)) tip = static_cast<int>(edge->dp[kTip]);
    } else if (called.offset > 0 &&
               static_cast<std::size_t>(called.offset) < live.store(channel).offsets.size()) {
        const OffsetCell& cell =
            live.store(channel).offsets[static_cast<std::size_t>(called.offset)];
        tip = static_cast<int>(cell.tip);
        radius = cell.geometry_r + cell.wear_r;
    }
    out.side = isDrill(kind) ? CutSide::Unknown : sideOfTip(language, tip);
    const bool onAxis = isDrill(kind) || (kind == 0 && !corner(language, tip));
    if (isDrill(kind) && row && row->diameter > 0)
        out.hole = static_cast<float>(row->diameter / 2);
    else if (onAxis && radius > 0)
        out.hole = static_cast<float>(radius);
    return out;
}

}  // namespace polyturn::hmi
