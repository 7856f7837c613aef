// Looks at the files of a store before SQLite does: is the main file there, is each of its pages as
// it was left, what was acknowledged?
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ipc/diagnosis/diagnosis.hpp"
#include "toolmgmt/durability/page_sums.hpp"
#include "toolmgmt/durability/witness.hpp"

namespace polyturn::toolmgmt {

struct Inspection {
    WitnessFile::State witness = WitnessFile::State::Missing;
    PageSums::State sums_state = PageSums::State::Missing;
    Witness acknowledged;             // with Good
    PageSums sums;                    // with Good
    std::uint32_t version = 0;        // of the schema, as the main file says; 0: none
    std::optional<Diagnosis> damage;  // the main file must not be worked on
};
Inspection inspect(const std::string& folder, const std::string& file);

}  // namespace polyturn::toolmgmt
