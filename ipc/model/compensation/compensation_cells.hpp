// Single cells and grid points of a machine's compensation table (compensation_tables.hpp), as
// programs give them values (G10 L50, N10000 and on, fanuc_lathe 7) and operators. The file keeps
// its other lines and comments.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ipc/params/table.hpp"

namespace polyturn {

struct CellEntry {
    std::int64_t cell = 0;
    float value = 0;
};

// One of the three corrections of a point of a channel's grid.
struct PointEntry {
    unsigned channel = 1;
    std::int64_t point = 0;
    unsigned component = 0;  // 0 to 2: of the grid's first, second, third axis
    float value = 0;
};
// A table must have no gaps: what the tables of the parameters use and nobody has given is written
// as 0.
enum class Gaps : std::uint8_t { Left, Filled };

// "10500=0.0012"; nothing: it is no cell with a value.
std::optional<CellEntry> cell_entry(std::string_view line);
// The text of the file with these values; of two for one cell the later counts. Into an empty one
// all that the tables use is written.
std::string with_cells(std::string_view content, const params::Table& parameters,
                       std::span<const CellEntry> entries, std::span<const PointEntry> points = {},
                       Gaps gaps = Gaps::Left);

}  // namespace polyturn
