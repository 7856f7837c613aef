// Machine and setting data by their names.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "channels/sinumerik/grammar/tables.hpp"
#include "channels/sinumerik/grammar/value.hpp"
#include "ipc/params/registry.hpp"

namespace polyturn::channels::sinumerik {

struct Execution;

struct DataCell {
    const params::Row* row = nullptr;  // nullptr: no machine or setting data
    std::size_t slot = 0;
};

// of a machine or setting datum; nullptr none
const params::Row* data_row(const std::string& name);
bool is_data_name(std::string_view name);
bool configuration_value(Execution& x, const std::string& name, const std::vector<Value>& indices,
                         const char* from, std::size_t length, Value& value, bool& known);
bool data_cell(Execution& x, const std::string& name, const std::vector<Value>& indices,
               const char* from, std::size_t length, DataCell& cell);
bool write_data(Execution& x, const DataCell& cell, const std::string& name, double value,
                const char* from, std::size_t length);

}  // namespace polyturn::channels::sinumerik
