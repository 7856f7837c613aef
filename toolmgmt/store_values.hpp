// Everything that the store holds, in memory. What the segment shows and what the disk keeps are copies of this.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "ipc/capacities.hpp"
#include "ipc/machine/store_requests.hpp"
#include "ipc/params/table.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::toolmgmt {

struct StoreValues {
    params::Table parameters;
    std::array<ChannelStore, kMaxChannels> channels;    // [0] is L1
    std::array<double, kCounters> counters;             // NaN: never counted, the parameter tells
    std::array<double, kMaxAxes> last_position;         // [0] is A1; NaN: not known
};

// Defaults, zeros, empty variables.
void clear(StoreValues& values);

// One value that changed, as the disk keeps it. Parameters are kept by name, because their slots move between versions.
enum class Kind : std::uint8_t { Parameter = 1, Offset, WorkZero, Variable, Counter, Position };

struct Key {
    Kind kind = Kind::Parameter;
    std::int32_t scope = 0;      // channel; parameter: instance; position: axis
    std::int32_t number = 0;     // offset, row, index, counter; parameter: element
    std::int32_t field = 0;      // offset: table * 256 + field; zero: place
    std::string name;            // parameter: its number, N1600
    friend auto operator<=>(const Key&, const Key&) = default;
};

struct Change {
    Key key;
    double before = 0.0, after = 0.0;            // numbers; NaN: empty
    std::string text_before, text_after;         // text parameters
    bool is_text = false;
};

// What the history calls it: "N1600 L1", "L1 offset 3 wear X", "L2 G54 place 1", "L1 #512".
std::string describe(const Key& key);

// The number a key stands for; nullptr when it names nothing that exists (a parameter of another version).
double* number_at(StoreValues& values, const Key& key);
// Writes the change's new value; false when the key names nothing.
bool write_value(StoreValues& values, const Key& key, double number, const std::string& text, bool is_text);

}  // namespace polyturn::toolmgmt
