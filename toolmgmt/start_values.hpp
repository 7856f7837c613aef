// What the store shows at its start: the machine's file, on it what the store kept, on it
// --param-file and --set of this run, and what --setup enters. The lines of --set hold for this run
// only; the setup counts as entered by an operator and is kept where there is a store.
#pragma once

#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "toolmgmt/database.hpp"
#include "toolmgmt/options.hpp"
#include "toolmgmt/store_values.hpp"

namespace polyturn::toolmgmt {

// What is wrong with machine or setup goes to `diagnoses`, contradictions included; the result
// reports whether the disk could be read and written. disk: nullptr keeps nothing.
Result<void> load_start_values(const Options& options, Database* disk, StoreValues& values,
                               std::vector<Diagnosis>& diagnoses);

}  // namespace polyturn::toolmgmt
