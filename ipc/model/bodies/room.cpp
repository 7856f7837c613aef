#include "ipc/model/bodies/room.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "ipc/model/files/read_file.hpp"
#include "ipc/model/files/toml_reader.hpp"

namespace polyturn {
namespace {

using text::TomlReader;

class Reader {
public:
    Reader(std::string_view filename, const MachineConfig& machine,
           std::vector<Diagnosis>& diagnoses)
        : toml_(filename, diagnoses), machine_(machine) {}

    void read(std::string_view content, Room& room) {
        const auto document = toml_.parse(content);
        if (!document) return;
        toml_.each(*document, [&](const toml::key& key, const toml::node& node) {
            if (key == "axis")
                each_named(key, node, 'A',
                           [&](const toml::key& k, unsigned n, const toml::table& t) {
                               axis(k, n, t, room);
                           });
            else if (key == "chuck")
                each_named(key, node, 'S',
                           [&](const toml::key& k, unsigned n, const toml::table& t) {
                               chuck(k, n, t, room);
                           });
            else if (key == "turret")
                each_named(key, node, 'L',
                           [&](const toml::key& k, unsigned n, const toml::table& t) {
                               turret(k, n, t, room);
                           });
            else if (key == "tailstock")
                each_named(key, node, '\0',
                           [&](const toml::key&, unsigned n, const toml::table& t) {
                               tailstock(n, t, room);
                           });
            else
                toml_.unknown(key, "axis, chuck, turret, tailstock");
        });
    }

private:
    // The tables below [axis], [chuck] ...: "A3" with its letter, or a plain number.
    template <class Take>
    void each_named(const toml::key& group, const toml::node& node, char letter, Take take) {
        const toml::table* all = toml_.table(group, node);
        if (!all) return;
        toml_.each(*all, [&](const toml::key& key, const toml::node& entry) {
            std::string_view digits = key.str();
            if (letter && (digits.empty() || digits[0] != letter))
                return wrong_name(
                    key, std::string(group.str()) + " is followed by " + letter + " and a number");
            if (letter) digits.remove_prefix(1);
            unsigned number = 0;
            for (const char c : digits) {
                if (c < '0' || c > '9' || number > 999) return wrong_name(key, "not a number");
                number = number * 10 + static_cast<unsigned>(c - '0');
            }
            if (number == 0) return wrong_name(key, "numbers begin at 1");
            if (const toml::table* table = toml_.table(key, entry)) take(key, number, *table);
        });
    }
    void wrong_name(const toml::key& key, const std::string& why) {
        toml_.fault(Alarm::RoomEntry, key.source(), std::string(key.str()) + ": " + why,
                    static_cast<std::uint32_t>(key.str().size()));
    }

    void vector(const toml::key& key, const toml::node& node, RoomVector& out) {
        const toml::table* table = toml_.table(key, node);
        if (!table) return;
        out = {};
        toml_.each(*table, [&](const toml::key& axis, const toml::node& value) {
            double* to = axis == "X"   ? &out.x
                         : axis == "Y" ? &out.y
                         : axis == "Z" ? &out.z
                                       : nullptr;
            if (!to) return toml_.unknown(axis, "X, Y, Z");
            if (const auto number = toml_.number(axis, value)) *to = *number;
        });
    }
    // True when the key was one of those that every place has.
    bool place(const toml::key& key, const toml::node& node, RoomPlace& out) {
        if (key == "origin") {
            vector(key, node, out.origin);
            return true;
        }
        if (key != "direction") return false;
        RoomVector way;
        vector(key, node, way);
        const double length = std::hypot(way.x, way.y, way.z);
        if (length > 1e-9)
            out.direction = {way.x / length, way.y / length, way.z / length};
        else
            toml_.fault(Alarm::RoomEntry, node.source(), "direction: all of X, Y, Z are 0");
        return true;
    }
    void length(const toml::key& key, const toml::node& node, double& out) {
        const auto number = toml_.number(key, node);
        if (number && *number >= 0)
            out = *number;
        else if (number)
            toml_.wrong(key, node, "a length from 0");
    }

    void carrier(const toml::node& node, unsigned& out) {
        const std::string name = node.value_or(std::string());
        unsigned number = 0;
        for (std::size_t i = 1; i < name.size() && name[i] >= '0' && name[i] <= '9'; ++i)
            number = number * 10 + static_cast<unsigned>(name[i] - '0');
        if (name.size() > 1 && name[0] == 'A' && number >= 1 && number <= kMaxAxes &&
            machine_.axis(number).exists())
            out = number;
        else
            toml_.fault(Alarm::RoomEntry, node.source(),
                        "carried_by: an axis of the machine, as \"A6\"");
    }
    // Rectangles { X = [low, high], Z = [low, high] }.
    void boxes(const toml::node& node, std::vector<RoomBox>& out) {
        const auto wrong = [&](const toml::node& at) {
            toml_.fault(Alarm::RoomEntry, at.source(),
                        "rectangles are { X = [low, high], Z = [low, high] }, low below high");
        };
        const toml::array* all = node.as_array();
        if (!all) return wrong(node);
        for (const toml::node& entry : *all) {
            const toml::table* table = entry.as_table();
            double range[2][2];
            bool good = table && table->size() == 2;
            for (int i = 0; good && i < 2; ++i) {
                const toml::array* ends = table->get_as<toml::array>(i == 0 ? "X" : "Z");
                good = ends && ends->size() == 2;
                for (std::size_t k = 0; good && k < 2; ++k) {
                    const auto value = ends->get(k)->value<double>();
                    good = value.has_value();
                    if (good) range[i][k] = *value;
                }
                good = good && range[i][0] < range[i][1];
            }
            if (good)
                out.push_back({range[0][0], range[0][1], range[1][0], range[1][1]});
            else
                wrong(entry);
        }
    }
    template <class Take>
    void stations(const toml::key& key, const toml::node& node, const Take& take) {
        const toml::table* table = toml_.table(key, node);
        if (!table) return;
        toml_.each(*table, [&](const toml::key& name, const toml::node& entry) {
            unsigned station = 0;
            for (const char c : name.str())
                station = c >= '0' && c <= '9' && station < 1000
                              ? station * 10 + static_cast<unsigned>(c - '0')
                              : 1000;
            if (station < 1 || station > 96)
                return wrong_name(name, "a station is a number from 1 to 96");
            take(station, name, entry);
        });
    }

    void axis(const toml::key& name, unsigned number, const toml::table& table, Room& room) {
        if (number > kMaxAxes || !machine_.axis(number).exists())
            return wrong_name(name, "the machine has no such axis");
        RoomPlace& out = room.axes[number];
        toml_.each(table, [&](const toml::key& key, const toml::node& node) {
            if (!place(key, node, out)) toml_.unknown(key, "origin, direction");
        });
    }
    void chuck(const toml::key& name, unsigned number, const toml::table& table, Room& room) {
        if (number > kMaxSpindles || !machine_.spindle(number).exists())
            return wrong_name(name, "the machine has no such spindle");
        RoomChuck& out = room.chucks[number];
        toml_.each(table, [&](const toml::key& key, const toml::node& node) {
            if (place(key, node, out)) return;
            if (key == "diameter")
                length(key, node, out.diameter);
            else if (key == "length")
                length(key, node, out.length);
            else if (key == "jaws")
                length(key, node, out.jaws);
            else if (key == "carried_by")
                carrier(node, out.carried_by);
            else
                toml_.unknown(key, "origin, direction, diameter, length, jaws, carried_by");
        });
    }
    void turret(const toml::key& name, unsigned number, const toml::table& table, Room& room) {
        if (number > kMaxChannels || !machine_.channel(number).exists())
            return wrong_name(name, "the machine has no such channel");
        RoomTurret& out = room.turrets[number];
        toml_.each(table, [&](const toml::key& key, const toml::node& node) {
            if (place(key, node, out)) return;
            if (key == "reach") return length(key, node, out.reach);
            if (key == "body") return boxes(node, out.body);
            if (key == "tools")
                return stations(key, node,
                                [&](unsigned station, const toml::key&, const toml::node& entry) {
                                    boxes(entry, out.tools[station]);
                                });
            if (key == "tips")
                return stations(
                    key, node, [&](unsigned station, const toml::key& at, const toml::node& entry) {
                        vector(at, entry, out.tips[station]);
                    });
            if (key != "stations")
                return toml_.unknown(key, "origin, direction, stations, reach, body, tools, tips");
            if (const auto count = toml_.whole(key, node, 1, 96))
                out.stations = static_cast<unsigned>(*count);
        });
        for (const auto& [station, tip] : out.tips)
            if (!out.tools.contains(station))
                wrong_name(name,
                           "tips: station " + std::to_string(station) + " has no shape in tools");
    }
    void tailstock(unsigned number, const toml::table& table, Room& room) {
        RoomTailstock& out = room.tailstocks[number];
        toml_.each(table, [&](const toml::key& key, const toml::node& node) {
            if (place(key, node, out)) return;
            if (key == "diameter")
                length(key, node, out.diameter);
            else if (key == "length")
                length(key, node, out.length);
            else
                toml_.unknown(key, "origin, direction, diameter, length");
        });
    }

    TomlReader toml_;
    const MachineConfig& machine_;
};

RoomVector usual_direction(PlaneRole role, bool upper) {
    switch (role) {
        case PlaneRole::BasicX:
        case PlaneRole::ParallelX:
            return {upper ? 1.0 : -1.0, 0.0, 0.0};
        case PlaneRole::BasicY:
        case PlaneRole::ParallelY:
            return {0.0, 1.0, 0.0};
        default:
            return {0.0, 0.0, 1.0};
    }
}

}  // namespace

RoomVector Room::point(const ChannelConfig& channel, const MachineConfig& machine,
                       const double* coordinates) const {
    RoomVector out;
    for (std::size_t slot = 0; slot < channel.axis_count; ++slot) {
        const auto found = axes.find(channel.axes[slot]);
        if (found == axes.end() || machine.axis(channel.axes[slot]).rotary) continue;
        const RoomPlace& at = found->second;
        out.x += at.origin.x + coordinates[slot] * at.direction.x;
        out.y += at.origin.y + coordinates[slot] * at.direction.y;
        out.z += at.origin.z + coordinates[slot] * at.direction.z;
    }
    return out;
}

Room default_room(const MachineConfig& machine) {
    Room room;
    for (const AxisConfig& axis : machine.axes)
        if (axis.exists())
            room.axes[axis.number] = {{}, usual_direction(axis.role, axis.channel % 2 == 1)};
    return room;
}

Room parse_room(std::string_view content, std::string_view filename, const MachineConfig& machine,
                std::vector<Diagnosis>& diagnoses) {
    Room room = default_room(machine);
    Reader(filename, machine, diagnoses).read(content, room);
    return room;
}

Room load_room(const std::string& path, const MachineConfig& machine,
               std::vector<Diagnosis>& diagnoses) {
    if (path.empty()) return default_room(machine);
    const Result<std::string> content = text::read_text_file(path, text::kLargestToml);
    if (content) return parse_room(*content, path, machine, diagnoses);
    diagnoses.push_back(content.diagnosis());
    return default_room(machine);
}

}  // namespace polyturn
