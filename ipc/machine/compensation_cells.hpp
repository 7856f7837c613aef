// Single cells of a machine's compensation table (compensation_tables.hpp), as programs give them values: G10 L50, N10000 and on
// (fanuc_lathe 7). The file keeps its other lines and comments.
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

// "10500=0.0012"; nothing: it is no cell with a value.
std::optional<CellEntry> cell_entry(std::string_view line);
// The text of the file with these values; of two for one cell the later counts. Into an empty one all cells that the tables of
// these parameters use are written, the others as 0: a table must have no gaps.
std::string with_cells(std::string_view content, const params::Table& parameters, std::span<const CellEntry> entries);

}  // namespace polyturn
