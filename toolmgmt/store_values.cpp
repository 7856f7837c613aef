#include "toolmgmt/store_values.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "ipc/model/machine/store/apply_setup.hpp"
#include "ipc/model/machine/store/tool_fields.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"
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
    if (field == OffsetField::T)
        return table == OffsetTable::Geometry || table == OffsetTable::Wear ? &cell.tip : nullptr;
    if (field == OffsetField::R)
        return table == OffsetTable::Geometry ? &cell.geometry_r
               : table == OffsetTable::Wear   ? &cell.wear_r
                                              : nullptr;
    if (field > OffsetField::T) return nullptr;
    const auto place = static_cast<std::size_t>(field);
    switch (table) {
        case OffsetTable::Geometry:
            return &cell.geometry[place];
        case OffsetTable::Wear:
            return &cell.wear[place];
        case OffsetTable::SecondGeometry:
            return &cell.second[place];
        case OffsetTable::Work:
            break;
    }
    return nullptr;
}

// Slot of a parameter's instance (from 1) and element; nothing when the registry has none.
const params::Row* parameter_row(const Key& key, std::size_t& slot) {
    const params::Row* row = params::find(key.name);
    if (!row || key.scope < 1 || static_cast<unsigned>(key.scope) > params::instances(row->scope) ||
        key.number < 0 || key.number >= row->array)
        return nullptr;
    slot = row->first_slot + static_cast<std::size_t>(key.scope - 1) * row->array +
           static_cast<std::size_t>(key.number);
    return row;
}

}  // namespace

void clear(StoreValues& values) {
    params::set_defaults(values.parameters);
    for (ChannelStore& store : values.channels) clear_channel_store(store);
    values.counters.fill(std::numeric_limits<double>::quiet_NaN());
    values.last_position.fill(std::numeric_limits<double>::quiet_NaN());
    values.tools = {};
    for (ToolRow& row : values.tools.rows) clear_tool(row);
    values.edges = {};
    values.cells.clear();
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
            return channel + " offset " + std::to_string(key.number) + " " + kTableNames[table] +
                   " " + kFieldNames[field];
        }
        case Kind::WorkZero:
            return channel + " " + work_zero_name(static_cast<std::size_t>(key.number)) +
                   " place " + std::to_string(key.field + 1);
        case Kind::Variable:
            return channel + " #" + std::to_string(500 + key.number);
        case Kind::Counter:
            return "counter " + std::to_string(key.number);
        case Kind::Position:
            return "A" + std::to_string(key.scope) + " last position";
        case Kind::Tool:
            return "tool " + std::to_string(key.number) + " " + key.name;
        case Kind::Edge:
            return "tool " + std::to_string(key.scope) + " D" + std::to_string(key.number) + " DP" +
                   std::to_string(key.field);
        case Kind::Place:
            return "magazine " + std::to_string(key.scope) + " pot " + std::to_string(key.number) +
                   " " + key.name;
        case Kind::Work:
            return channel + " " + key.name;
        case Kind::User:
            return "user " + std::to_string(key.number) + " " + key.name;
        case Kind::Dimension:
            return "dimension " + std::to_string(key.number) + " " + key.name;
        case Kind::Pallet:
            return "pallet " + std::to_string(key.number) + " " + key.name;
        case Kind::Setting:
            return key.name;
    }
    return channel;
}

double* number_at(StoreValues& values, const Key& key) {
    if (key.kind == Kind::Parameter) {
        std::size_t slot = 0;
        const params::Row* row = parameter_row(key, slot);
        return row && row->type != params::Type::Text ? &values.parameters.numbers[slot] : nullptr;
    }
    if (key.kind == Kind::Counter)
        return key.number >= 0 && key.number < kCounters
                   ? &values.counters[static_cast<std::size_t>(key.number)]
                   : nullptr;
    if (key.kind == Kind::Position)
        return key.scope >= 1 && key.scope <= static_cast<int>(kMaxAxes)
                   ? &values.last_position[static_cast<std::size_t>(key.scope - 1)]
                   : nullptr;
    if (key.kind > Kind::Position || key.scope < 1 || key.scope > static_cast<int>(kMaxChannels))
        return nullptr;
    ChannelStore& store = values.channels[static_cast<std::size_t>(key.scope - 1)];
    if (key.kind == Kind::Offset) return offset_at(store, key.number, key.field);
    if (key.kind == Kind::WorkZero) {
        const bool exists = key.number >= 0 && key.number < static_cast<int>(kWorkZeros) &&
                            key.field >= 0 && key.field < static_cast<int>(kChannelAxes);
        return exists ? &store.zeros[static_cast<std::size_t>(key.number) * kChannelAxes +
                                     static_cast<std::size_t>(key.field)]
                      : nullptr;
    }
    return key.number >= 0 && key.number < static_cast<int>(kPersistentVariables)
               ? &store.variables[static_cast<std::size_t>(key.number)]
               : nullptr;
}

namespace {

bool order(const ToolEdge& a, const ToolEdge& b) {
    return a.tool != b.tool ? a.tool < b.tool : a.number < b.number;
}

bool empty(const ToolEdge& edge) {
    return std::all_of(edge.dp.begin(), edge.dp.end(), [](double v) { return v == 0.0; });
}

bool write_tool(StoreValues& values, const Key& key, double number, const std::string& text) {
    ToolRow* row = values.tool(key.number);
    if (!row) return false;
    if (key.name == "exists") {
        if (std::isnan(number) || number == 0.0)
            clear_tool(*row);
        else
            row->used = 1;
        return true;
    }
    const auto field = find_tool_field(key.name);
    if (!field) return false;
    const ToolField& column = tool_fields()[*field];
    if (column.is_text())
        put_tool_text(*row, column, text);
    else
        put_tool_number(*row, column, number);
    return true;
}

bool write_edge(StoreValues& values, const Key& key, double number) {
    if (!values.tool(key.scope) || key.number < 1 || key.number > 12 || key.field < 0 ||
        key.field >= 36)
        return false;
    const double value = std::isnan(number) ? 0.0 : number;
    ToolEdge* edge = find_edge(values, key.scope, key.number);
    if (!edge && value == 0.0) return true;
    if (!edge) edge = make_edge(values, key.scope, key.number);
    if (!edge) return false;
    edge->dp[static_cast<std::size_t>(key.field)] = value;
    if (empty(*edge)) remove_edge(values, key.scope, key.number);
    return true;
}

bool write_work(StoreValues& values, const Key& key, double number) {
    if (key.scope < 1 || key.scope > static_cast<int>(kMaxChannels)) return false;
    const auto channel = static_cast<std::size_t>(key.scope - 1);
    const auto tool = static_cast<std::int32_t>(std::isnan(number) ? 0.0 : number);
    if (key.name == "tool")
        values.tools.in_channel[channel] = tool;
    else if (key.name == "next tool")
        values.tools.next[channel] = tool;
    else
        return false;
    return true;
}

}  // namespace

ToolEdge* find_edge(StoreValues& values, std::int32_t tool, std::int32_t number) {
    ToolEdge wanted;
    wanted.tool = tool;
    wanted.number = number;
    ToolEdge* const end = values.edges.edges.data() + values.edges.count;
    ToolEdge* const at = std::lower_bound(values.edges.edges.data(), end, wanted, order);
    return at != end && at->tool == tool && at->number == number ? at : nullptr;
}

const ToolEdge* find_edge(const StoreValues& values, std::int32_t tool, std::int32_t number) {
    return find_edge(const_cast<StoreValues&>(values), tool, number);
}

ToolEdge* make_edge(StoreValues& values, std::int32_t tool, std::int32_t number) {
    ToolEdgeTable& table = values.edges;
    if (table.count == kToolEdges) return nullptr;
    ToolEdge fresh;
    fresh.tool = tool;
    fresh.number = number;
    ToolEdge* const end = table.edges.data() + table.count;
    ToolEdge* const at = std::lower_bound(table.edges.data(), end, fresh, order);
    std::move_backward(at, end, end + 1);
    *at = fresh;
    ++table.count;
    return at;
}

void remove_edge(StoreValues& values, std::int32_t tool, std::int32_t number) {
    ToolEdge* const at = find_edge(values, tool, number);
    if (!at) return;
    ToolEdge* const end = values.edges.edges.data() + values.edges.count;
    std::move(at + 1, end, at);
    values.edges.edges[--values.edges.count] = {};
}

bool write_value(StoreValues& values, const Key& key, double number, const std::string& text,
                 bool is_text) {
    switch (key.kind) {
        case Kind::Tool:
            return write_tool(values, key, number, text);
        case Kind::Edge:
            return write_edge(values, key, number);
        case Kind::Work:
            return write_work(values, key, number);
        case Kind::Place:
        case Kind::User:
        case Kind::Dimension:
        case Kind::Pallet:
        case Kind::Setting:
            if (is_text ? text.empty() : std::isnan(number))
                values.cells.erase(key);
            else
                values.cells[key] = {number, text, is_text};
            return true;
        default:
            break;
    }
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

bool change_to(const StoreValues& values, const Key& key, double number, std::string_view text,
               bool is_text, Change& out) {
    out = {key, std::numeric_limits<double>::quiet_NaN(), number, {}, std::string(text), is_text};
    switch (key.kind) {
        case Kind::Tool: {
            const ToolRow* row = values.tool(key.number);
            if (!row) return false;
            if (key.name == "exists") {
                out.before = row->used;
                return out.before != number;
            }
            const auto field = find_tool_field(key.name);
            if (!field) return false;
            const ToolField& column = tool_fields()[*field];
            if (column.is_text()) {
                out.is_text = true;
                out.text_before = tool_text(*row, column);
            } else
                out.before = tool_number(*row, column);
            return column.is_text() ? out.text_before != text : out.before != number;
        }
        case Kind::Edge: {
            const ToolEdge* edge = find_edge(values, key.scope, key.number);
            out.before = edge && key.field >= 0 && key.field < 36
                             ? edge->dp[static_cast<std::size_t>(key.field)]
                             : 0.0;
            return out.before != number;
        }
        case Kind::Work:
            if (key.scope < 1 || key.scope > static_cast<int>(kMaxChannels)) return false;
            out.before =
                (key.name == "tool" ? values.tools.in_channel
                                    : values.tools.next)[static_cast<std::size_t>(key.scope - 1)];
            return out.before != number;
        case Kind::Place:
        case Kind::User:
        case Kind::Dimension:
        case Kind::Pallet:
        case Kind::Setting: {
            const Cell* cell = values.cell(key);
            if (cell) {
                out.before = cell->number;
                out.text_before = cell->text;
            }
            if (!cell) return is_text ? !text.empty() : !std::isnan(number);
            if (cell->is_text != is_text) return true;
            return is_text ? cell->text != text
                           : std::bit_cast<std::uint64_t>(cell->number) !=
                                 std::bit_cast<std::uint64_t>(number);
        }
        default:
            break;
    }
    const double* at = number_at(const_cast<StoreValues&>(values), key);
    if (at) {
        out.before = *at;
        return std::bit_cast<std::uint64_t>(*at) != std::bit_cast<std::uint64_t>(number);
    }
    std::size_t slot = 0;
    const params::Row* row = key.kind == Kind::Parameter ? parameter_row(key, slot) : nullptr;
    if (!row) return false;
    out.text_before = params::text_at(values.parameters, slot);
    return out.text_before != text;
}

}  // namespace polyturn::toolmgmt
