// Everything that the store holds, in memory. What the segment shows and what the disk keeps are
// copies of this.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "ipc/capacities.hpp"
#include "ipc/requests/store_requests.hpp"
#include "ipc/params/table.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::toolmgmt {

// One value that changed, as the disk keeps it. Parameters are kept by name, because their slots
// move between versions. Tool (number: data number), Edge (scope: data number, number: D, field:
// DP), Place (scope: magazine, number: pot), Work (scope: channel) and what follows have the name
// of their column in `name`; a number NaN takes such a value away.
enum class Kind : std::uint8_t {
    Parameter = 1,
    Offset,
    WorkZero,
    Variable,
    Counter,
    Position,
    Tool,
    Edge,
    Place,
    Work,
    User,
    Dimension,
    Pallet,
    Setting
};

struct Key {
    Kind kind = Kind::Parameter;
    std::int32_t scope = 0;   // channel; parameter: instance; position: axis
    std::int32_t number = 0;  // offset, row, index, counter; parameter: element
    std::int32_t field = 0;   // offset: table * 256 + field; zero: place
    std::string name;         // parameter: its number, N1600; column of a tool and the like
    friend auto operator<=>(const Key&, const Key&) = default;
};

struct Change {
    Key key;
    double before = 0.0, after = 0.0;     // numbers; NaN: empty
    std::string text_before, text_after;  // text parameters
    bool is_text = false;
};

// What has no place in the image: users, dimensions of measured parts, pallets, states of places.
struct Cell {
    double number = 0.0;
    std::string text;
    bool is_text = false;
};

struct StoreValues {
    params::Table parameters;
    std::array<ChannelStore, kMaxChannels> channels;  // [0] is L1
    std::array<double, kCounters> counters;           // NaN: never counted, the parameter decides
    std::array<double, kMaxAxes> last_position;       // [0] is A1; NaN: not known
    // a tool's station is in its row, and nowhere else
    ToolTable tools;
    ToolEdgeTable edges;  // ordered by tool and number
    std::map<Key, Cell> cells;

    const Cell* cell(const Key& key) const {
        const auto at = cells.find(key);
        return at == cells.end() ? nullptr : &at->second;
    }
    ToolRow* tool(std::int64_t number) {
        return number >= 1 && number <= static_cast<std::int64_t>(kTools)
                   ? &tools.rows[static_cast<std::size_t>(number - 1)]
                   : nullptr;
    }
    const ToolRow* tool(std::int64_t number) const {
        return const_cast<StoreValues*>(this)->tool(number);
    }
};

// Defaults, zeros, empty variables, no tools.
void clear(StoreValues& values);

// What the history calls it: "N1600 L1", "L1 offset 3 wear X", "L2 G54 place 1", "L1 #512".
std::string describe(const Key& key);

// The number a key stands for; nullptr when it names nothing that exists (a parameter of another
// version).
double* number_at(StoreValues& values, const Key& key);
// The change that brings one value there; nothing when it is there already or the key names
// nothing.
bool change_to(const StoreValues& values, const Key& key, double number, std::string_view text,
               bool is_text, Change& out);
// The edge of a tool; nullptr when it has none. make_edge adds it where its order wants it; nullptr
// when there is no room.
ToolEdge* find_edge(StoreValues& values, std::int32_t tool, std::int32_t number);
const ToolEdge* find_edge(const StoreValues& values, std::int32_t tool, std::int32_t number);
ToolEdge* make_edge(StoreValues& values, std::int32_t tool, std::int32_t number);
void remove_edge(StoreValues& values, std::int32_t tool, std::int32_t number);
// Writes the change's new value; false when the key names nothing.
bool write_value(StoreValues& values, const Key& key, double number, const std::string& text,
                 bool is_text);

}  // namespace polyturn::toolmgmt
