// Names of flags and registers as people write them: "AP_SYNCR A3", "CN_WTNG L1", "CP_NOWT[2]",
// "N_SW[4]", "PLC_ALARM".
#pragma once
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::supervisor {

struct SignalName {
    const SignalRow* row = nullptr;
    std::uint32_t instance = 1;
    std::uint32_t element = 0;  // of an array, from 0
    std::uint32_t slot() const {
        return row->slot + (instance - 1 + element) * (row->kind == SignalKind::Double ? 2u : 1u);
    }
};

// Whatever its case; the scope may be left out where there is only one. A name that does not exist
// is answered with the nearest one that does.
Result<SignalName> parse_signal(std::string_view words);
std::string_view trimmed(std::string_view words);

}  // namespace polyturn::supervisor
