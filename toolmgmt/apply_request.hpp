// What one request does to the values: checked whole, then written, with the list of what changed
// for disk and kernel.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "toolmgmt/store_values.hpp"

namespace polyturn::toolmgmt {

// Who asks: an operator's entry keeps to the limits of the tables (N1400, N1415); a program's was
// checked by its language.
enum class Origin : std::uint8_t { Operator, Program, Setup };

struct Applied {
    std::vector<Change> changes;   // values that really differ now
    std::string answer;            // of a query
    bool until_power_off = false;  // not for the disk
};

// The level of whoever asks is too low for this request (parameters by their protection, wear the
// operator's, geometry and zeros the setter's); nothing: it is not.
[[nodiscard]] std::optional<Diagnosis> level_refusal(const StoreRequest& request);

// The channel in whose table an offset lies: numbers up to N1401 (milling channels) or N1412
// (turning channels) mean one cell for all channels of the kind, that of the first of them (nct
// part 1, 15.1).
[[nodiscard]] std::int32_t offset_owner(const params::Table& table, const MachineConfig& machine,
                                        std::int64_t channel, std::int64_t number);

// Nothing is written when it is refused.
[[nodiscard]] Result<Applied> apply_request(const StoreRequest& request, Origin origin,
                                            const MachineConfig& machine, StoreValues& values);

}  // namespace polyturn::toolmgmt
