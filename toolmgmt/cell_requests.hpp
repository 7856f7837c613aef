// Cells of the machine's compensation table that a program has given a value (G10 L50, N10000 and
// on), and the file that they are kept in: the machine's own, where the kernel sees them and takes
// them while all axes rest. Only the store's thread writes it, so that what a program and what an
// operator enters (operations/compensation_operations.cpp) do not undo each other. A virtual run
// leaves it as it is.
#pragma once
#include <optional>
#include <span>
#include <string>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/compensation/compensation_cells.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::toolmgmt {

std::optional<CellEntry> cell_of(const StoreRequest& request);  // nothing: it is another request
// empty: there is none, or it is not to be written
std::string compensation_file(const RunOptions& options);
Result<std::string> read_compensation(const std::string& path);  // not there yet: empty
Result<void> keep_cells(const RunOptions& options, const params::Table& parameters,
                        std::span<const CellEntry> cells);

}  // namespace polyturn::toolmgmt
