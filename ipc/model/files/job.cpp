#include "ipc/model/files/job.hpp"

#include <filesystem>

#include "ipc/capacities.hpp"
#include "ipc/model/files/read_file.hpp"
#include "ipc/model/files/toml_reader.hpp"

namespace polyturn::text {

namespace {

class JobReader {
public:
    JobReader(std::string_view filename, std::vector<Diagnosis>& diagnoses)
        : toml_(filename, diagnoses), folder_(std::filesystem::path(filename).parent_path()) {}

    void file(const toml::table& root, Job& out) {
        toml_.each(root, [&](const toml::key& key, const toml::node& node) {
            if (key == "name")
                out.name = toml_.text(key, node).value_or("");
            else if (key == "machine")
                out.machine = path(key, node);
            else if (key == "setup")
                out.setup = path(key, node);
            else if (key == "programs")
                programs(key, node, out);
            else if (key == "stock")
                stock(key, node, out);
            else if (key == "zeros")
                zeros(key, node, out);
            else if (key == "tools")
                tools(key, node, out);
            else if (key == "parts")
                parts(key, node, out);
            else
                toml_.unknown(key, "name, machine, setup, programs, stock, zeros, tools, parts");
        });
        if (out.programs.empty())
            toml_.fault(Alarm::TextSyntax, root.source(),
                        "a job needs [programs]: which program runs in which channel");
    }

private:
    std::string path(const toml::key& key, const toml::node& node) {
        const auto file = toml_.text(key, node);
        return file && !file->empty() ? (folder_ / *file).lexically_normal().string()
                                      : std::string();
    }

    std::optional<unsigned> channel_key(const toml::key& key) {
        const auto number = toml_.whole_key(key, 1, kMaxChannels, "a channel number");
        return number ? std::optional<unsigned>(static_cast<unsigned>(*number)) : std::nullopt;
    }

    void programs(const toml::key& key, const toml::node& node, Job& out) {
        const auto* table = toml_.table(key, node);
        if (!table) return;
        toml_.each(*table, [&](const toml::key& number, const toml::node& one) {
            const auto channel = channel_key(number);
            if (!channel) return;
            JobProgram program;
            if (one.is_string()) {  // short for { file = ... }
                program.file = path(number, one);
            } else if (const auto* content = toml_.table(number, one)) {
                toml_.each(*content, [&](const toml::key& name, const toml::node& value) {
                    if (name == "file")
                        program.file = path(name, value);
                    else if (name == "language")
                        program.language = toml_.text(name, value).value_or("");
                    else
                        toml_.unknown(name, "file, language");
                });
                if (program.file.empty())
                    toml_.fault(Alarm::TextSyntax, one.source(), "the program's file is missing");
            }
            out.programs[*channel] = std::move(program);
        });
    }

    void stock(const toml::key& key, const toml::node& node, Job& out) {
        const auto* table = toml_.table(key, node);
        if (!table) return;
        JobStock stock;
        toml_.each(*table, [&](const toml::key& name, const toml::node& value) {
            if (name == "spindle") {
                stock.spindle = toml_.text(name, value).value_or("");
                if (stock.spindle.size() < 2 || stock.spindle[0] != 'S')
                    toml_.wrong(name, value, "a spindle such as \"S1\"");
            } else if (name == "diameter")
                stock.diameter = length(name, value);
            else if (name == "bore")
                stock.bore = length(name, value);
            else if (name == "length")
                stock.length = length(name, value);
            else if (name == "face")
                stock.face = toml_.number(name, value).value_or(0.0);
            else
                toml_.unknown(name, "spindle, diameter, bore, length, face");
        });
        out.stock = stock;
    }

    double length(const toml::key& key, const toml::node& node) {
        const auto value = toml_.number(key, node);
        if (value && *value < 0) toml_.wrong(key, node, "a length from 0 on");
        return value && *value >= 0 ? *value : 0.0;
    }

    void zeros(const toml::key& key, const toml::node& node, Job& out) {
        const auto* table = toml_.table(key, node);
        if (!table) return;
        toml_.each(*table, [&](const toml::key& number, const toml::node& systems) {
            const auto channel = channel_key(number);
            const auto* content = channel ? toml_.table(number, systems) : nullptr;
            if (!content) return;
            toml_.each(*content, [&](const toml::key& system, const toml::node& values) {
                const auto* axes = toml_.table(system, values);
                if (!axes) return;
                auto& zero = out.zeros[*channel][std::string(system.str())];
                toml_.each(*axes, [&](const toml::key& axis, const toml::node& value) {
                    if (const auto number_value = toml_.number(axis, value))
                        zero[std::string(axis.str())] = *number_value;
                });
            });
        });
    }

    void tools(const toml::key& key, const toml::node& node, Job& out) {
        const auto* list = toml_.array(key, node);
        if (!list) return;
        for (const auto& one : *list) {
            const auto* content = toml_.table(key, one);
            if (!content) continue;
            JobTool tool;
            toml_.each(*content, [&](const toml::key& name, const toml::node& value) {
                if (name == "channel")
                    tool.channel = static_cast<unsigned>(
                        toml_.whole(name, value, 1, kMaxChannels).value_or(0));
                else if (name == "station")
                    tool.station = static_cast<int>(toml_.whole(name, value, 0, 9999).value_or(0));
                else if (name == "name")
                    tool.name = toml_.text(name, value).value_or("");
                else
                    toml_.unknown(name, "channel, station, name");
            });
            out.tools.push_back(std::move(tool));
        }
    }

    void parts(const toml::key& key, const toml::node& node, Job& out) {
        const auto* table = toml_.table(key, node);
        if (!table) return;
        toml_.each(*table, [&](const toml::key& name, const toml::node& value) {
            if (name == "wanted")
                out.parts_wanted =
                    static_cast<unsigned>(toml_.whole(name, value, 0, 100'000'000).value_or(0));
            else
                toml_.unknown(name, "wanted");
        });
    }

    TomlReader toml_;
    std::filesystem::path folder_;
};

}  // namespace

Job parse_job(std::string_view content, std::string_view filename,
              std::vector<Diagnosis>& diagnoses) {
    Job out;
    out.file = std::string(filename);
    if (const auto root = TomlReader(filename, diagnoses).parse(content))
        JobReader(filename, diagnoses).file(*root, out);
    return out;
}

Result<Job> load_job(const std::string& path) {
    const auto content = read_text_file(path, kLargestToml);
    if (!content) return content.diagnosis();
    std::vector<Diagnosis> diagnoses;
    Job job = parse_job(*content, path, diagnoses);
    if (!diagnoses.empty()) return diagnoses.front();
    return job;
}

bool is_job_file(std::string_view path) {
    constexpr std::string_view kEnd = ".job.toml";
    return path.size() > kEnd.size() && path.substr(path.size() - kEnd.size()) == kEnd;
}

}  // namespace polyturn::text
