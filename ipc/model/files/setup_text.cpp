#include "ipc/model/files/setup_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iterator>

namespace polyturn::text {

namespace {

std::string in_quotes(std::string_view words) {
    std::string out = "\"";
    for (const char c : words) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20)
            out += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
        else
            out += c;
    }
    return out + '"';
}

std::string number(double value) {
    return std::isnan(value) ? std::string("nan") : fmt::format("{}", value);
}

std::string axes(const AxisValues& values) {
    std::string out = "{ ";
    for (const auto& [name, value] : values)
        out += (out.size() > 2 ? ", " : "") + in_quotes(name) + " = " + number(value);
    return out + " }";
}

std::string offset(const OffsetValues& values) {
    std::string out = "{ ";
    const auto add = [&](const char* name, const std::optional<double>& value) {
        if (value) out += (out.size() > 2 ? ", " : "") + std::string(name) + " = " + number(*value);
    };
    add("X", values.x);
    add("Y", values.y);
    add("Z", values.z);
    add("R", values.r);
    add("T", values.t);
    return out + " }";
}

void channel_text(std::string& out, unsigned index, const ChannelSetup& channel) {
    const std::string head = fmt::format("channel.{}", index);
    out += "[" + head + "]\n";
    if (!channel.machine.empty()) out += "machine = " + axes(channel.machine) + "\n";
    if (!channel.pos.empty()) out += "pos = " + axes(channel.pos) + "\n";
    const KeySetup& keys = channel.keys;
    out += "keys = { block_skip = [";
    for (std::size_t i = 0; i < keys.block_skip.size(); ++i)
        out += fmt::format("{}{}", i ? ", " : "", keys.block_skip[i]);
    out += fmt::format(
        "], optional_stop = {}, single_block = {}, dry_run = {}, machine_lock = {} }}\n",
        keys.optional_stop, keys.single_block, keys.dry_run, keys.machine_lock);
    out += "subprograms = [";
    for (std::size_t i = 0; i < channel.subprograms.size(); ++i)
        out += (i ? ", " : "") +
               in_quotes(
                   std::filesystem::absolute(channel.subprograms[i]).lexically_normal().string());
    out += "]\n";
    if (!channel.work.empty()) {
        out += "[" + head + ".work]\n";
        for (const auto& [system, values] : channel.work)
            out += in_quotes(system) + " = " + axes(values) + "\n";
    }
    if (!channel.variables.empty()) {
        out += "[" + head + ".variables]\n";
        for (const auto& variable : channel.variables)
            out += in_quotes(variable.name) + " = " +
                   (variable.is_text ? in_quotes(variable.text) : number(variable.value)) + "\n";
    }
    for (const auto& [index_of, values] : channel.offsets)
        out += fmt::format("[{}.offset.{}]\ngeometry = {}\nwear = {}\n", head, index_of,
                           offset(values.geometry), offset(values.wear));
    for (const auto& [index_of, tool] : channel.tools) {
        out += fmt::format("[{}.tool.{}]\nname = {}\n", head, index_of, in_quotes(tool.name));
        for (const auto& [edge, values] : tool.edges) {
            out += fmt::format("[{}.tool.{}.edge.{}]\n", head, index_of, edge);
            for (const auto& [name, value] : values) out += name + " = " + number(value) + "\n";
        }
    }
    for (const auto& sensor : channel.sensors)
        out += fmt::format(
            "[[{}.sensor]]\ninput = {}\naxis = {}\nat = {}\n{}", head, in_quotes(sensor.input),
            in_quotes(sensor.axis), number(sensor.at),
            sensor.direction ? fmt::format("direction = \"{}\"\n", sensor.direction < 0 ? '-' : '+')
                             : std::string());
}

}  // namespace

std::string setup_text(const Setup& setup) {
    std::string out;
    if (setup.clock)
        out += fmt::format("clock = \"{:04}-{:02}-{:02}T{:02}:{:02}:{:02}\"\n", setup.clock->year,
                           setup.clock->month, setup.clock->day, setup.clock->hour,
                           setup.clock->minute, setup.clock->second);
    for (const auto& [index, channel] : setup.channels) channel_text(out, index, channel);
    return out;
}

}  // namespace polyturn::text
