// Cells of the machine's compensation table that a program has given a value (G10 L50, N10000 and on). They are kept in the
// machine's own file, where the kernel sees them and takes them while all axes rest. A virtual run leaves the machine as it is.
#pragma once
#include <optional>
#include <span>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/machine/compensation_cells.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::toolmgmt {

std::optional<CellEntry> cell_of(const StoreRequest& request);   // nothing: it is another request
Result<void> keep_cells(const RunOptions& options, const params::Table& parameters, std::span<const CellEntry> cells);

}  // namespace polyturn::toolmgmt
