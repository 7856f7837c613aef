// The values of all parameters of one machine: plain bytes that lie in a shared segment
// (architecture 4).
//
//   numbers  | row 0: instance 1, 2, ... | row 1: instance 1 [element 0, 1, ...], instance 2 ... |
//   ...
//   texts    | cells of 64 bytes, the same way
//
// Invariants
//   I1  Plain bytes: no pointer, no virtual. A table means the same wherever it is mapped, and
//   memcpy copies it. I2  Every number is finite and within its row's limits, every text ends with
//   a zero byte: set_defaults() begins so,
//       and only apply() (param_file.hpp), which checks, and a writer that checked itself change
//       it.
//   I3  Who writes is not settled here: the table is filled privately and published whole, or
//   written by its one owner.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "ipc/params/handle.hpp"
#include "polyturn/parameter_handles.hpp"  // generated: handles and slot counts

namespace polyturn::params {

inline constexpr std::size_t kTextCapacity = 63;

struct TextCell {
    char bytes[kTextCapacity + 1];  // ended by a zero byte
};

struct Table {
    std::array<double, kNumberSlots> numbers;
    std::array<TextCell, kTextSlots> texts;
};
static_assert(std::is_trivially_copyable_v<Table> && std::is_standard_layout_v<Table>, "I1");

void set_defaults(Table& table) noexcept;
[[nodiscard]] Table defaults() noexcept;  // large (kNumberSlots doubles): not for small stacks

// What a handle reads: bits and whole numbers as integers, the rest as it is.
template <Type kType>
using ValueOf = std::conditional_t<kType == Type::Real, double,
                                   std::conditional_t<kType == Type::Int, std::int64_t, unsigned>>;

namespace detail {
// An index outside the capacity is our mistake, never the operator's: the wrong axis' value could
// move a machine, so stop.
template <Scope kScope, Type kType>
constexpr std::size_t slot_of(Handle<kScope, kType> handle, unsigned instance,
                              unsigned element) noexcept {
    if (instance < 1 || instance > instances(kScope) || element >= handle.array) [[unlikely]]
        __builtin_trap();
    return handle.first_slot + static_cast<std::size_t>(instance - 1) * handle.array + element;
}
}  // namespace detail

// get(table, n0304_rapid, 3): rapid traverse of axis A3. Indices count from 1 as the operator's do,
// elements from 0.
template <Scope kScope, Type kType>
requires(kScope != Scope::Global && kType != Type::Text)
    [[nodiscard]] ValueOf<kType> get(const Table& table, Handle<kScope, kType> handle,
                                     unsigned instance, unsigned element = 0) noexcept {
    return static_cast<ValueOf<kType>>(table.numbers[detail::slot_of(handle, instance, element)]);
}
template <Type kType>
requires(kType != Type::Text)
    [[nodiscard]] ValueOf<kType> get(const Table& table,
                                     Handle<Scope::Global, kType> handle) noexcept {
    return static_cast<ValueOf<kType>>(table.numbers[detail::slot_of(handle, 1, 0)]);
}

// bit(table, n0106_axis_properties, 3, 0): bit #0 of axis A3.
template <Scope kScope>
requires(kScope != Scope::Global)
    [[nodiscard]] bool bit(const Table& table, Handle<kScope, Type::Bits> handle, unsigned instance,
                           unsigned number) noexcept {
    return (get(table, handle, instance) >> number & 1U) != 0;
}
[[nodiscard]] inline bool bit(const Table& table, Handle<Scope::Global, Type::Bits> handle,
                              unsigned number) noexcept {
    return (get(table, handle) >> number & 1U) != 0;
}

[[nodiscard]] inline std::string_view text_at(const Table& table, std::size_t slot) noexcept {
    const char* bytes = table.texts[slot].bytes;
    return {bytes, ::strnlen(bytes, kTextCapacity)};
}
// get_text(table, n0003_channel_name, 1). The view lives as long as the table.
template <Scope kScope>
requires(kScope != Scope::Global) [[nodiscard]] std::string_view
    get_text(const Table& table, Handle<kScope, Type::Text> handle, unsigned instance) noexcept {
    return text_at(table, detail::slot_of(handle, instance, 0));
}
[[nodiscard]] inline std::string_view get_text(const Table& table,
                                               Handle<Scope::Global, Type::Text> handle) noexcept {
    return text_at(table, detail::slot_of(handle, 1, 0));
}

// Writing without a check, for tests and for values that the machine itself counts (timers, part
// counters).
template <Scope kScope, Type kType>
requires(kType != Type::Text) void put(Table& table, Handle<kScope, kType> handle, double value,
                                       unsigned instance = 1, unsigned element = 0) noexcept {
    table.numbers[detail::slot_of(handle, instance, element)] = value;
}
// cut to kTextCapacity
void put_text_at(Table& table, std::size_t slot, std::string_view text) noexcept;
template <Scope kScope>
void put_text(Table& table, Handle<kScope, Type::Text> handle, std::string_view text,
              unsigned instance = 1) noexcept {
    put_text_at(table, detail::slot_of(handle, instance, 0), text);
}

// True when every value is the same; a byte comparison would stumble over what lies behind the end
// of a text.
[[nodiscard]] bool same(const Table& left, const Table& right) noexcept;

}  // namespace polyturn::params
