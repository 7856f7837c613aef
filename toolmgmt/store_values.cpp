#include "toolmgmt/store_values.hpp"

#include <limits>

#include "ipc/machine/apply_setup.hpp"
#include "ipc/machine/work_zeros.hpp"
#include "ipc/params/export.hpp"
#include "ipc/params/registry.hpp"

namespace polyturn::toolmgmt {
namespace {

constexpr const char* kTableNames[] = {"geometry", "wear", "second geometry"};
constexpr const char* kFieldNames[] = {"X", "Y", "Z", "R", "T"};

double* offset_at(ChannelStore& store, std::int32_t number, std::int32_t code) {
    if (number < 1 || static_cast<std::size_t>(number) >= kOffsets || code < 0) return nullptr;
    OffsetCell& cell = store.offsets[static_cast<std::size_t>(number)];
    const auto table = static_cast<OffsetTable>(code / 256);
    const auto field = static_cast<OffsetField>(code % 256);
    if (field == OffsetField::T) return table == OffsetTable::Geometry || table == OffsetTable::Wear ? &cell.tip : nullptr;
    if (field == OffsetField::R) return table == OffsetTable::Geometry ? &cell.geometry_r : table == OffsetTable::Wear ? &cell.wear_r : nullptr;
    if (field > OffsetField::T) return nullptr;
    const auto place = static_cast<std::size_t>(field);
    switch (table) {
        case OffsetTable::Geometry: return &cell.geometry[place];
        case OffsetTable::Wear: return &cell.wear[place];
        case OffsetTable::SecondGeometry: return &cell.second[place];
        case OffsetTable::Work: break;
    }
    return nullptr;
}

// Slot of a parameter's instance (from 1) and element; nothing when the registry has none.
const params::Row* parameter_row(const Key& key, std::size_t& slot) {
    const params::Row* row = params::find(key.name);
    if (!row || key.scope < 1 || static_cast<unsigned>(key.scope) > params::instances(row->scope) || key.number < 0 || key.number >= row->array) return nullptr;
    slot = row->first_slot + static_cast<std::size_t>(key.scope - 1) * row->array + static_cast<std::size_t>(key.number);
    return row;
}

}  // namespace

void clear(StoreValues& values) {
    params::set_defaults(values.parameters);
    for (ChannelStore& store : values.channels) clear_channel_store(store);
    values.counters.fill(std::numeric_limits<double>::quiet_NaN());
    values.last_position.fill(std::numeric_limits<double>::quiet_NaN());
}

std::string describe(const Key& key) {
    const std::string channel = "L" + std::to_string(key.scope);
    switch (key.kind) {
        case Kind::Parameter: {
            params::Target target;
            target.row = params::find(key.name);
            if (!target.row) return key.name;
            target.instance = static_cast<unsigned>(key.scope);
            if (target.row->array > 1) target.element = key.number;
            return params::target_text(target);
        }
        case Kind::Offset: {
            const int table = key.field / 256, field = key.field % 256;
            if (table < 0 || table > 2 || field > 4) break;
            return channel + " offset " + std::to_string(key.number) + " " + kTableNames[table] + " " + kFieldNames[field];
        }
        case Kind::WorkZero: return channel + " " + work_zero_name(static_cast<std::size_t>(key.number)) + " place " + std::to_string(key.field + 1);
        case Kind::Variable: return channel + " #" + std::to_string(500 + key.number);
        case Kind::Counter: return "counter " + std::to_string(key.number);
        case Kind::Position: return "A" + std::to_string(key.scope) + " last position";
    }
    return channel;
}

double* number_at(StoreValues& values, const Key& key) {
    if (key.kind == Kind::Parameter) {
        std::size_t slot = 0;
        const params::Row* row = parameter_row(key, slot);
        return row && row->type != params::Type::Text ? &values.parameters.numbers[slot] : nullptr;
    }
    if (key.kind == Kind::Counter) return key.number >= 0 && key.number < kCounters ? &values.counters[static_cast<std::size_t>(key.number)] : nullptr;
    if (key.kind == Kind::Position) return key.scope >= 1 && key.scope <= static_cast<int>(kMaxAxes) ? &values.last_position[static_cast<std::size_t>(key.scope - 1)] : nullptr;
    if (key.scope < 1 || key.scope > static_cast<int>(kMaxChannels)) return nullptr;
    ChannelStore& store = values.channels[static_cast<std::size_t>(key.scope - 1)];
    if (key.kind == Kind::Offset) return offset_at(store, key.number, key.field);
    if (key.kind == Kind::WorkZero) {
        const bool exists = key.number >= 0 && key.number < static_cast<int>(kWorkZeros) && key.field >= 0 && key.field < static_cast<int>(kChannelAxes);
        return exists ? &store.zeros[static_cast<std::size_t>(key.number) * kChannelAxes + static_cast<std::size_t>(key.field)] : nullptr;
    }
    return key.number >= 0 && key.number < static_cast<int>(kPersistentVariables) ? &store.variables[static_cast<std::size_t>(key.number)] : nullptr;
}

bool write_value(StoreValues& values, const Key& key, double number, const std::string& text, bool is_text) {
    if (!is_text) {
        double* at = number_at(values, key);
        if (at) *at = number;
        return at != nullptr;
    }
    std::size_t slot = 0;
    const params::Row* row = key.kind == Kind::Parameter ? parameter_row(key, slot) : nullptr;
    if (!row || row->type != params::Type::Text) return false;
    params::put_text_at(values.parameters, slot, text);
    return true;
}

}  // namespace polyturn::toolmgmt
