// The tool in work as the PLC reports it: the one in the turret or spindle now, whatever
// a program has read ahead.
#pragma once
#include <cstdint>

#include "ipc/image/segments.hpp"
#include "ipc/params/table.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn {

// N2901 TSP: of the channel (from 1), or of the spindle that its tools are in. 0: the PLC says
// nothing.
inline std::int32_t active_tool(const params::Table& table, const PlcOutputs& plc,
                                unsigned channel) {
    if (!params::bit(table, params::n2901_search_config, channel, 7))
        return plc.signal[PlcSignal{signals::cp_actt}(channel)];
    const auto driven = params::get(table, params::pt_driven_spindle, channel),
               own = params::get(table, params::n0604_default_spindle, channel);
    const auto spindle = static_cast<std::uint32_t>(driven > 0 ? driven : own);
    return spindle >= 1 && spindle <= kMaxSpindles
               ? plc.signal[PlcSignal{signals::sp_actt}(spindle)]
               : 0;
}

}  // namespace polyturn
