#include "ipc/model/files/setup.hpp"

#include <cmath>
#include <filesystem>
#include <limits>

#include "ipc/capacities.hpp"
#include "ipc/model/files/read_file.hpp"
#include "ipc/model/files/toml_reader.hpp"

namespace polyturn::text {

namespace {

// One method for each table of the file, top down as cli.md 2 shows them.
class SetupReader {
public:
    SetupReader(std::string_view filename, std::vector<Diagnosis>& diagnoses)
        : toml_(filename, diagnoses), folder_(std::filesystem::path(filename).parent_path()) {}

    void file(const toml::table& root, Setup& out) {
        toml_.each(root, [&](const toml::key& key, const toml::node& node) {
            if (key == "clock") {
                clock(key, node, out);
            } else if (key == "channel") {
                if (const auto* channels = toml_.table(key, node))
                    toml_.each(*channels, [&](const toml::key& number, const toml::node& one) {
                        const auto index =
                            toml_.whole_key(number, 1, kMaxChannels, "a channel number");
                        const auto* content = index ? toml_.table(number, one) : nullptr;
                        if (content) channel(*content, out.channels[static_cast<unsigned>(*index)]);
                    });
            } else {
                toml_.unknown(key, "clock, channel");
            }
        });
    }

private:
    void clock(const toml::key& key, const toml::node& node, Setup& out) {
        // A text as in the manual, or TOML's own date-time without quotes.
        Clock clock;
        if (const auto* value = node.as_date_time()) {
            const auto& [date, time, offset] = value->get();
            clock = {date.year, date.month, date.day, time.hour, time.minute, time.second};
        } else {
            const auto words = toml_.text(key, node);
            if (!words) return;
            int used = 0;
            char separator = 0;
            const int found = std::sscanf(words->c_str(), "%4d-%2d-%2d%c%2d:%2d:%2d%n", &clock.year,
                                          &clock.month, &clock.day, &separator, &clock.hour,
                                          &clock.minute, &clock.second, &used);
            if (found != 7 || (separator != 'T' && separator != ' ') ||
                static_cast<std::size_t>(used) != words->size()) {
                toml_.wrong(key, node, "a date and time such as \"2026-01-31T12:34:56\"");
                return;
            }
        }
        static constexpr int kDays[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
        const bool leap = clock.year % 4 == 0 && (clock.year % 100 != 0 || clock.year % 400 == 0);
        if (clock.year < 1 || clock.month < 1 || clock.month > 12 || clock.day < 1 ||
            clock.day > kDays[clock.month - 1] + (leap && clock.month == 2 ? 1 : 0) ||
            clock.hour < 0 || clock.hour > 23 || clock.minute < 0 || clock.minute > 59 ||
            clock.second < 0 || clock.second > 59) {
            toml_.wrong(key, node, "a date and time that exists");
            return;
        }
        out.clock = clock;
    }

    void channel(const toml::table& table, ChannelSetup& out) {
        toml_.each(table, [&](const toml::key& key, const toml::node& node) {
            if (key == "machine")
                axes(key, node, out.machine);
            else if (key == "pos")
                axes(key, node, out.pos);
            else if (key == "work")
                work(key, node, out);
            else if (key == "variables")
                variables(key, node, out);
            else if (key == "keys")
                keys(key, node, out.keys);
            else if (key == "subprograms")
                subprograms(key, node, out);
            else if (key == "offset")
                offsets(key, node, out);
            else if (key == "tool")
                tools(key, node, out);
            else if (key == "sensor")
                sensors(key, node, out);
            else
                toml_.unknown(
                    key, "machine, pos, work, variables, keys, subprograms, offset, tool, sensor");
        });
    }

    void axes(const toml::key& key, const toml::node& node, AxisValues& out) {
        if (const auto* table = toml_.table(key, node))
            toml_.each(*table, [&](const toml::key& axis, const toml::node& value) {
                if (const auto number = toml_.number(axis, value))
                    out[std::string(axis.str())] = *number;
            });
    }

    void work(const toml::key& key, const toml::node& node, ChannelSetup& out) {
        if (const auto* table = toml_.table(key, node))
            toml_.each(*table, [&](const toml::key& system, const toml::node& values) {
                axes(system, values, out.work[std::string(system.str())]);
            });
    }

    void variables(const toml::key& key, const toml::node& node, ChannelSetup& out) {
        if (const auto* table = toml_.table(key, node))
            toml_.each(*table, [&](const toml::key& name, const toml::node& value) {
                SetupVariable variable;
                variable.name = std::string(name.str());
                if (const auto* words = value.as_string()) {
                    variable.text = words->get();
                    variable.is_text = true;
                } else if (const auto* truth = value.as_boolean()) {
                    variable.value = truth->get() ? 1.0 : 0.0;
                } else if (const auto* real = value.as_floating_point();
                           real && std::isnan(real->get())) {
                    variable.value = std::numeric_limits<double>::quiet_NaN();  // an empty variable
                } else if (const auto number = toml_.number(name, value)) {
                    variable.value = *number;
                } else {
                    return;
                }
                out.variables.push_back(std::move(variable));
            });
    }

    void keys(const toml::key& key, const toml::node& node, KeySetup& out) {
        const auto* table = toml_.table(key, node);
        if (!table) return;
        toml_.each(*table, [&](const toml::key& name, const toml::node& value) {
            if (name == "block_skip")
                block_skip(name, value, out);
            else if (name == "optional_stop")
                out.optional_stop = toml_.flag(name, value).value_or(false);
            else if (name == "single_block")
                out.single_block = toml_.flag(name, value).value_or(false);
            else if (name == "dry_run")
                out.dry_run = toml_.flag(name, value).value_or(false);
            else if (name == "machine_lock")
                out.machine_lock = toml_.flag(name, value).value_or(false);
            else
                toml_.unknown(name,
                              "block_skip, optional_stop, single_block, dry_run, machine_lock");
        });
    }

    void block_skip(const toml::key& key, const toml::node& node, KeySetup& out) {
        if (const auto* all = node.as_boolean()) {  // true: the plain "/" of level 1
            if (all->get()) out.block_skip.push_back(1);
            return;
        }
        if (node.is_integer()) {
            if (const auto level = toml_.whole(key, node, 1, 10))
                out.block_skip.push_back(static_cast<int>(*level));
            return;
        }
        if (const auto* levels = toml_.array(key, node))
            for (const auto& one : *levels)
                if (const auto level = toml_.whole(key, one, 0, 10))
                    out.block_skip.push_back(static_cast<int>(*level));
    }

    void subprograms(const toml::key& key, const toml::node& node, ChannelSetup& out) {
        if (const auto* files = toml_.array(key, node))
            for (const auto& one : *files)
                if (const auto file = toml_.text(key, one))
                    out.subprograms.push_back((folder_ / *file).lexically_normal().string());
    }

    void offsets(const toml::key& key, const toml::node& node, ChannelSetup& out) {
        const auto* table = toml_.table(key, node);
        if (!table) return;
        toml_.each(*table, [&](const toml::key& number, const toml::node& one) {
            const auto index =
                toml_.whole_key(number, 1, static_cast<long>(kOffsets) - 1, "an offset number");
            const auto* content = index ? toml_.table(number, one) : nullptr;
            if (!content) return;
            OffsetSetup& offset = out.offsets[static_cast<int>(*index)];
            toml_.each(*content, [&](const toml::key& part, const toml::node& values) {
                if (part == "geometry")
                    offset_values(part, values, offset.geometry);
                else if (part == "wear")
                    offset_values(part, values, offset.wear);
                else
                    toml_.unknown(part, "geometry, wear");
            });
        });
    }

    void offset_values(const toml::key& key, const toml::node& node, OffsetValues& out) {
        const auto* table = toml_.table(key, node);
        if (!table) return;
        toml_.each(*table, [&](const toml::key& name, const toml::node& value) {
            if (name == "X")
                out.x = toml_.number(name, value);
            else if (name == "Y" || name == "B")
                // the offsets of a B axis with programs of its own are in the Y column
                // (fanuc_lathe 10.4)
                out.y = toml_.number(name, value);
            else if (name == "Z")
                out.z = toml_.number(name, value);
            else if (name == "R")
                out.r = toml_.number(name, value);
            else if (name == "T") {
                if (const auto tip = toml_.whole(name, value, 0, 9))
                    out.t = static_cast<double>(*tip);
            } else
                toml_.unknown(name, "X, Y, Z, B, R (nose radius), T (tip direction)");
        });
    }

    void tools(const toml::key& key, const toml::node& node, ChannelSetup& out) {
        const auto* table = toml_.table(key, node);
        if (!table) return;
        toml_.each(*table, [&](const toml::key& number, const toml::node& one) {
            const auto index = toml_.whole_key(number, 1, 32000, "a tool number");
            const auto* content = index ? toml_.table(number, one) : nullptr;
            if (!content) return;
            ToolSetup& tool = out.tools[static_cast<int>(*index)];
            toml_.each(*content, [&](const toml::key& part, const toml::node& value) {
                if (part == "name")
                    tool.name = toml_.text(part, value).value_or("");
                else if (part == "edge")
                    edges(part, value, tool);
                else
                    toml_.unknown(part, "name, edge");
            });
        });
    }

    void edges(const toml::key& key, const toml::node& node, ToolSetup& out) {
        const auto* table = toml_.table(key, node);
        if (!table) return;
        toml_.each(*table, [&](const toml::key& number, const toml::node& one) {
            const auto index = toml_.whole_key(number, 1, 999, "an edge number");
            const auto* content = index ? toml_.table(number, one) : nullptr;
            if (!content) return;
            auto& edge = out.edges[static_cast<int>(*index)];
            toml_.each(*content, [&](const toml::key& name, const toml::node& value) {
                const std::string_view word = name.str();
                const bool numbered =
                    word.size() > 2 && word.substr(0, 2) == "DP" &&
                    word.find_first_not_of("0123456789", 2) == std::string_view::npos;
                if (!numbered)
                    toml_.unknown(name, "DP1, DP2 and so on");
                else if (const auto number_value = toml_.number(name, value))
                    edge[std::string(word)] = *number_value;
            });
        });
    }

    void sensors(const toml::key& key, const toml::node& node, ChannelSetup& out) {
        const auto* list = toml_.array(key, node);
        if (!list) return;
        for (const auto& one : *list) {
            const auto* content = toml_.table(key, one);
            if (!content) continue;
            SensorSetup sensor;
            toml_.each(*content, [&](const toml::key& name, const toml::node& value) {
                if (name == "input") {
                    if (value.is_integer())
                        sensor.input =
                            std::to_string(toml_.whole(name, value, 0, kInputs - 1).value_or(0));
                    else
                        sensor.input = toml_.text(name, value).value_or("");
                } else if (name == "axis")
                    sensor.axis = toml_.text(name, value).value_or("");
                else if (name == "at")
                    sensor.at = toml_.number(name, value).value_or(0.0);
                else if (name == "direction") {
                    const auto sign = toml_.text(name, value);
                    if (sign && *sign != "-" && *sign != "+")
                        toml_.wrong(name, value, "\"-\" or \"+\"");
                    sensor.direction = sign == "-" ? -1 : 1;
                } else
                    toml_.unknown(name, "input, axis, at, direction");
            });
            if (sensor.input.empty() || sensor.axis.empty())
                toml_.fault(Alarm::WrongType, one.source(), "a sensor needs input, axis and at");
            else
                out.sensors.push_back(std::move(sensor));
        }
    }

    TomlReader toml_;
    std::filesystem::path folder_;
};

}  // namespace

const ChannelSetup& Setup::channel(unsigned number) const {
    static const ChannelSetup kEmpty;
    const auto found = channels.find(number);
    return found == channels.end() ? kEmpty : found->second;
}

Setup parse_setup(std::string_view content, std::string_view filename,
                  std::vector<Diagnosis>& diagnoses) {
    Setup out;
    out.file = std::string(filename);
    if (const auto root = TomlReader(filename, diagnoses).parse(content))
        SetupReader(filename, diagnoses).file(*root, out);
    return out;
}

Result<Setup> load_setup(const std::string& path) {
    const auto content = read_text_file(path, kLargestToml);
    if (!content) return content.diagnosis();
    std::vector<Diagnosis> diagnoses;
    Setup setup = parse_setup(*content, path, diagnoses);
    if (!diagnoses.empty()) return diagnoses.front();
    return setup;
}

}  // namespace polyturn::text
