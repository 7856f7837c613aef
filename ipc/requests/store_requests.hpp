// What a StoreRequest says, for those who write one (channel, kernel, supervisor) and for the store
// that reads it.
//
//   kind         number                     field                       name            value
//   OffsetValue  offset number 1..999       table * 256 + OffsetField   -               as shown
//   WorkZero     row of ChannelStore::zeros axis index, kVolatile       or "G54 X"      as shown
//   Variable     index of the saved, or -1  -                           or "#500"       NaN: empty
//   Counter      0..99                      -                           -               value
//   LastPosition axis, from 1               -                           -               coordinate
//   Parameter    -                          kMoreFollows or 0           "N1600 L1=2.5"  -
//   Query        -                          -                           "N1600 L1"      -
//   Flush        answered when everything before it is on disk
//
// A name, where there is one, wins over the numbers. "As shown": millimetres or degrees as the
// table shows them, X as a diameter where the axis is a diameter axis. "Coordinate": of the
// machine, true mm or degrees. Indices 0..499 of the saved variables are #500..#999; those from 500
// belong to languages with other names. A variable that is not saved is no error: it is just not
// stored. Parameter lines of one import follow each other, all but the last with kMoreFollows: they
// are done together or not at all, and the machine takes them in one tick. The answer to the last
// one says which; the others are answered "more follows".
#pragma once

#include <cstring>
#include <optional>
#include <string_view>

#include "ipc/image/enums.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn {

inline constexpr std::int32_t kCounters = 100;
inline constexpr std::int32_t kMoreFollows = 1;
// holds in the running system only: the next power-on has what is on the disk
inline constexpr std::int32_t kVolatile = 256;

inline StoreRequest store_request(StoreRequestKind kind, std::uint32_t channel, std::int32_t number,
                                  std::int32_t field, double value) noexcept {
    StoreRequest request{};
    request.kind = static_cast<std::uint32_t>(kind);
    request.channel = channel;
    request.number = number;
    request.field = field;
    request.value = value;
    return request;
}

inline void put_name(StoreRequest& request, std::string_view name) noexcept {
    request.name.fill(0);
    std::memcpy(request.name.data(), name.data(),
                name.size() < request.name.size() ? name.size() : request.name.size() - 1);
}

inline StoreRequest offset_request(std::uint32_t channel, std::int32_t number, OffsetTable table,
                                   OffsetField field, double value) noexcept {
    return store_request(StoreRequestKind::OffsetValue, channel, number,
                         static_cast<std::int32_t>(table) * 256 + static_cast<std::int32_t>(field),
                         value);
}
inline StoreRequest work_zero_request(std::uint32_t channel, std::int32_t row, std::int32_t place,
                                      double value) noexcept {
    return store_request(StoreRequestKind::WorkZero, channel, row, place, value);
}
inline StoreRequest variable_request(std::uint32_t channel, std::string_view name,
                                     double value) noexcept {
    StoreRequest request = store_request(StoreRequestKind::Variable, channel, 0, 0, value);
    put_name(request, name);
    return request;
}
inline StoreRequest parameter_request(std::string_view line, bool more_follows = false) noexcept {
    StoreRequest request =
        store_request(StoreRequestKind::Parameter, 0, 0, more_follows ? kMoreFollows : 0, 0.0);
    put_name(request, line);
    return request;
}

// What a record of kind Offset or Variable asks of the store; for the kernel, which forwards it in
// path order.
inline StoreRequest request_of_record(std::uint32_t channel, const PathRecord& record) noexcept {
    if (static_cast<RecordKind>(record.kind) == RecordKind::Variable) {
        StoreRequest request = variable_request(
            record.mask ? record.mask : channel,
            std::string_view(record.text.data(), ::strnlen(record.text.data(), record.text.size())),
            record.value);
        request.number = record.code;  // -1: not kept
        return request;
    }
    const auto table = static_cast<OffsetTable>(record.code);
    const auto number = static_cast<std::int32_t>(record.mask);
    if (table == OffsetTable::Work)
        return work_zero_request(channel, number,
                                 record.plane[0] + (record.plane[1] ? kVolatile : 0), record.value);
    return offset_request(record.plane[1] ? record.plane[1] : channel, number, table,
                          static_cast<OffsetField>(record.plane[0]), record.value);
}

// Index in ChannelStore::variables of a variable by its name: #500 to #999. Others are not kept.
std::optional<std::size_t> kept_variable(std::string_view name) noexcept;

}  // namespace polyturn
