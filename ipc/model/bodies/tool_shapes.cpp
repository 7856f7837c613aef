#include "ipc/model/bodies/tool_shapes.hpp"

#include <algorithm>
#include <memory>

#include "polyturn/parameter_handles.hpp"

namespace polyturn {

void tool_shapes_of(const ToolTable& tools, const params::Table& table, ToolShapes& out) {
    out.count = out.left_out = 0;
    for (unsigned l = 1; l <= kMaxChannels; ++l) {
        const auto magazine =
            static_cast<std::int32_t>(params::get(table, params::pt_turret_magazine, l));
        if (magazine == 0) continue;
        for (const ToolRow& row : tools.rows) {
            if (!row.used || row.magazine != magazine || row.pot < 1) continue;
            for (std::size_t b = 0; b < std::min<std::size_t>(row.boxes, 3); ++b) {
                if (out.count == out.shapes.size()) {
                    ++out.left_out;
                    continue;
                }
                const double* e = &row.outline[b * 4];
                out.shapes[out.count++] = {
                    l, static_cast<std::uint32_t>(row.pot), e[0], e[1], e[2], e[3]};
            }
        }
    }
}

bool read_tool_shapes(const StoreSegment& store, ToolShapes& out) {
    out.count = out.left_out = 0;
    const auto tools = std::make_unique<ToolTable>();
    const auto table = std::make_unique<params::Table>();
    if (!store.tools.read(*tools) || !store.parameters.read(*table)) return false;
    tool_shapes_of(*tools, *table, out);
    return true;
}

}  // namespace polyturn
