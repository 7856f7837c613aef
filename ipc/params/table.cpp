#include "ipc/params/table.hpp"

#include <algorithm>

#include "ipc/params/registry.hpp"
#include "ipc/params/row_default.hpp"

namespace polyturn::params {

void set_default(Table& table, const Row& row) noexcept {
    const unsigned count = instances(row.scope) * row.array;
    for (unsigned i = 0; i < count; ++i) {
        if (row.type == Type::Text)
            put_text_at(table, row.first_slot + i, row.default_text);
        else
            table.numbers[row.first_slot + i] = row.default_number(i % row.array);
    }
}

void set_defaults(Table& table) noexcept {
    std::memset(&table, 0, sizeof table);
    for (const Row& row : rows()) set_default(table, row);
}

Table defaults() noexcept {
    Table table;
    set_defaults(table);
    return table;
}

void put_text_at(Table& table, std::size_t slot, std::string_view text) noexcept {
    TextCell& cell = table.texts[slot];
    const std::size_t length = std::min(text.size(), kTextCapacity);
    std::memset(cell.bytes, 0, sizeof cell.bytes);
    std::memcpy(cell.bytes, text.data(), length);
}

bool same(const Table& left, const Table& right) noexcept {
    if (left.numbers != right.numbers) return false;
    for (std::size_t slot = 0; slot < kTextSlots; ++slot)
        if (text_at(left, slot) != text_at(right, slot)) return false;
    return true;
}

}  // namespace polyturn::params
