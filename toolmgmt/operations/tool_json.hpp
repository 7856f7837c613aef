// What several operations do with tools: show one, write its columns, let it stand somewhere.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ipc/model/machine/store/tool_fields.hpp"
#include "toolmgmt/operations/operation.hpp"

namespace polyturn::toolmgmt {

std::int64_t table_length(const StoreValues& values);                   // N2902
bool column_exists(const StoreValues& values, const ToolField& field);  // N2903 for the free ones
Json tool_json(const StoreValues& values, std::int32_t number);
// `row` of a table for the faults; 0 none. False: a fault was added. A column's value may be an
// entry: {"delta":2} is added to
// what stands there (read_entry()); `entries` then tells of each what it was and has become.
bool set_fields(Work& work, std::int32_t number, const Json& fields, int row,
                Json* entries = nullptr);
bool set_field(Work& work, std::int32_t number, const std::string& name, const std::string& text,
               int row);
bool stand_at(Work& work, std::int32_t number, std::int32_t magazine, std::int32_t pot, int row);
void remove_tool(Work& work, std::int32_t number);
// The rate of the forecast is counted from here on; the mark goes with the tool.
void mark_life(Work& work, std::int32_t tool);
void forget_life(Work& work, std::int32_t tool);

}  // namespace polyturn::toolmgmt
