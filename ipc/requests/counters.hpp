// What the machine counts over its life: which number of StoreRequest Counter stands for which
// parameter.
//
// Timers and part counters are parameters (N2300 to N2307) that the kernel writes, so they go their
// own way: as a counter request through the kernel's ring into the store, which shows them as
// parameter values and keeps them on disk.
#pragma once
#include <cstdint>

#include "ipc/requests/store_requests.hpp"
#include "ipc/params/table.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn {

enum class Counter : std::uint8_t {
    TotalParts = 0,
    MachinedParts,
    OperationTime,
    CuttingTime,
    IntervalTime,
    PartTime
};
inline constexpr int kCountersOfChannel = 6;
inline constexpr std::int32_t kPowerOnTime = kCountersOfChannel * static_cast<int>(kMaxChannels);
static_assert(kPowerOnTime < kCounters);

// channel from 1
constexpr std::int32_t counter_number(Counter counter, unsigned channel) noexcept {
    return static_cast<std::int32_t>(channel - 1) * kCountersOfChannel +
           static_cast<std::int32_t>(counter);
}

// Place in params::Table::numbers of the parameter that shows it; -1: none.
inline std::int64_t counter_slot(std::int32_t number) noexcept {
    if (number == kPowerOnTime) return params::n2300_power_on_time.first_slot;
    if (number < 0 || number > kPowerOnTime) return -1;
    const auto channel = static_cast<std::int64_t>(number / kCountersOfChannel);
    switch (static_cast<Counter>(number % kCountersOfChannel)) {
        case Counter::TotalParts:
            return params::n2306_no_of_total_parts.first_slot + channel;
        case Counter::MachinedParts:
            return params::n2307_no_of_machined_parts.first_slot + channel;
        case Counter::OperationTime:
            return params::n2301_operation_time.first_slot + channel;
        case Counter::CuttingTime:
            return params::n2302_cutting_time.first_slot + channel;
        case Counter::IntervalTime:
            return params::n2303_interval_meter.first_slot + channel;
        case Counter::PartTime:
            return params::n2304_part_time.first_slot + channel;
    }
    return -1;
}

}  // namespace polyturn
