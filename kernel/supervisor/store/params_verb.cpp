#include "kernel/supervisor/store/params_verb.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "ipc/model/bodies/room.hpp"
#include "ipc/model/machine/check/config_check.hpp"
#include "ipc/model/compensation/compensation_tables.hpp"
#include "ipc/model/machine/load_machine.hpp"
#include "ipc/memory/segment.hpp"
#include "ipc/params/export.hpp"
#include "ipc/params/param_file.hpp"
#include "ipc/params/translations.hpp"
#include "ipc/model/files/read_file.hpp"
#include "ipc/model/files/replace_file.hpp"
#include "kernel/supervisor/check/job_plan.hpp"
#include "kernel/supervisor/press/phrases.hpp"
#include "kernel/supervisor/status/ask_verbs.hpp"

namespace polyturn::supervisor {

namespace {

using TablePointer = std::unique_ptr<params::Table>;

bool tell(const std::vector<Diagnosis>& diagnoses) {
    for (const Diagnosis& diagnosis : diagnoses) print_diagnosis(diagnosis, Dialect::Polyturn);
    return any_error(diagnoses);
}

// The parameters that act in a running controller.
TablePointer running_table(const std::string& instance) {
    const auto store = PeerSegment<StoreSegment>::attach(instance);
    if (!store) {
        print_diagnosis(store.diagnosis(), Dialect::Polyturn);
        return nullptr;
    }
    auto table = std::make_unique<params::Table>();
    if (!(*store)->parameters.read(*table)) return nullptr;
    return table;
}

// "…/machine" of the machine that a running controller has; empty: it has parameters only.
std::string running_base(const std::string& instance) {
    const auto supervisor = PeerSegment<SupervisorSegment>::attach(instance);
    return supervisor ? std::string((*supervisor)->options.machine_folder.data()) : std::string();
}

TablePointer table_of_file(const std::string& machine) {
    LoadedMachine loaded = load_machine_file(machine);
    if (tell(loaded.diagnoses)) return nullptr;
    return std::move(loaded.table);
}

TablePointer wanted_table(const ParamsOptions& options) {
    return options.instance.empty() ? table_of_file(options.machine)
                                    : running_table(options.instance);
}

std::string upper(std::string_view words) {
    std::string out(words);
    for (char& c : out) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return out;
}

int list(const ParamsOptions& options) {
    std::size_t shown = 0;
    std::string_view group;
    for (const params::Row& row : params::rows()) {
        const bool acts = row.acts == "yes" || row.acts.empty();
        if (options.unused && acts) continue;
        const params::RowWords words = params::words_of(row, display_language_now());
        const std::string searched =
            upper(fmt::format("{} {} {} {}", row.number, row.name, row.group, words.name));
        if (!std::all_of(options.arguments.begin(), options.arguments.end(),
                         [&](const std::string& word) {
                             return searched.find(upper(word)) != std::string::npos;
                         }))
            continue;
        if (row.group != group) {
            print(fmt::format("{}{}\n", shown ? "\n" : "", row.group));
            group = row.group;
        }
        ++shown;
        print(fmt::format("  {:<14} {:<9} {:<12} {}{}{}\n", row.number,
                          params::to_string(row.scope), row.unit, words.name,
                          words.meaning.empty() ? "" : ": ", words.meaning));
        if (!acts) print(fmt::format("  {:<14} {}: {}\n", "", say("no effect"), words.acts));
    }
    print(fmt::format(fmt::runtime(say("{}{} parameters{}\n")), shown ? "\n" : "", shown,
                      options.unused ? say(" without effect") : ""));
    return 0;
}

int get(const ParamsOptions& options) {
    const TablePointer table = wanted_table(options);
    if (!table) return 2;
    for (const std::string& name : options.arguments) {
        const auto target = params::parse_target(name);
        if (!target) return refuse(target.diagnosis());
        print(params::describe(*target->row));
        print(params::value_text(*table, *target) + "\n");
    }
    return 0;
}

// Sends lines to a running controller; returns when they are on disk.
int send_lines(const std::string& instance, const std::vector<std::string>& lines, bool import) {
    nlohmann::json request;
    request["do"] = "parameters";
    request["import"] = import;
    request["lines"] = lines;
    return ask(instance, request.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
               ? 0
               : 2;
}

int rewrite(const std::string& path, const std::string& content) {
    if (auto written = text::replace_file(path, content); !written)
        return refuse(written.diagnosis());
    return 0;
}

// The value goes to the end of the machine's file, where the last line of a name wins; its comments
// stay.
int append_lines(const std::string& machine, const std::vector<std::string>& lines) {
    LoadedMachine loaded = load_machine_file(machine);
    if (tell(loaded.diagnoses)) return 2;
    auto content = text::read_text_file(loaded.params_file);
    if (!content) return refuse(content.diagnosis());
    if (!content->empty() && content->back() != '\n') *content += '\n';
    for (const std::string& line : lines) *content += line + "\n";
    return rewrite(loaded.params_file, *content);
}

int set(const ParamsOptions& options) {
    for (const std::string& line : options.arguments)
        if (auto assignment = params::parse_assignment(line); !assignment) {
            assignment.diagnosis().place.file = "'" + line + "'";
            return refuse(assignment.diagnosis());
        }
    if (!options.instance.empty()) return send_lines(options.instance, options.arguments, false);
    if (options.machine.empty()) {
        std::fputs(say("polyturn: say --instance NAME (a running controller) or --machine FILE (a "
                       "machine's file)\n")
                       .data(),
                   stderr);
        return 2;
    }
    return append_lines(options.machine, options.arguments);
}

int export_table(const ParamsOptions& options) {
    const TablePointer table = wanted_table(options);
    if (!table) return 2;
    const std::string lines =
        params::export_lines(*table, options.all ? params::Content::All : params::Content::Changed);
    if (options.arguments.empty()) {
        print(lines);
        return 0;
    }
    return rewrite(options.arguments.front(), lines);
}

// Measured errors are imported whole: the table is checked against the machine's parameters, then
// it takes the old one's place.
int import_compensation(const ParamsOptions& options, const std::string& path,
                        const std::string& content) {
    const std::string base =
        options.instance.empty() ? std::string() : running_base(options.instance);
    if (options.instance.empty() ? options.machine.empty() : base.empty()) {
        std::fputs(say("polyturn: a compensation table is imported with --machine FILE, or with "
                       "--instance NAME into a controller that runs a machine\n")
                       .data(),
                   stderr);
        return 2;
    }
    std::vector<Diagnosis> faults;
    const CompensationTables tables = parse_compensation(content, path, faults);
    if (!options.instance.empty()) {
        const TablePointer table = running_table(options.instance);
        if (!table) return 2;
        check_compensation_tables(*table, tables, path, faults);
        if (tell(faults)) return 2;
        // By the store, which writes what programs and operators enter into the same file.
        const nlohmann::json request = {
            {"do", "store"},
            {"op",
             {{"do", "compensation.import"}, {"file", std::filesystem::absolute(path).string()}}}};
        if (!ask(options.instance,
                 request.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)))
            return 2;
        print(fmt::format(fmt::runtime(say("{}: acts as soon as the axes rest\n")),
                          base + ".compensation"));
        return 0;
    }
    LoadedMachine loaded = load_machine_file(options.machine);
    // of the one that is replaced
    std::erase_if(loaded.diagnoses,
                  [](const Diagnosis& d) { return d.alarm == Alarm::CompensationTable; });
    if (tell(loaded.diagnoses) || !loaded.table) return 2;
    check_compensation_tables(*loaded.table, tables, path, faults);
    if (tell(faults)) return 2;
    if (const int failed = rewrite(compensation_file_of(loaded.params_file), content))
        return failed;
    print(fmt::format(fmt::runtime(say("{}: acts from the next start of the machine\n")),
                      compensation_file_of(loaded.params_file)));
    return 0;
}

int import_file(const ParamsOptions& options) {
    const std::string& path = options.arguments.front();
    const auto content = text::read_text_file(path);
    if (!content) return refuse(content.diagnosis());
    if (path.ends_with(".compensation")) return import_compensation(options, path, *content);
    const params::ParsedFile parsed = params::parse_param_file(*content, path);
    if (tell(parsed.diagnoses) || !parsed.ok()) return 2;  // none of them
    std::vector<std::string> lines;
    for (const params::Assignment& assignment : parsed.assignments) {
        std::string line(text::line_of(*content, assignment.place.line));
        lines.push_back(line.substr(0, line.find_last_not_of(" \t\r") + 1));
    }
    if (!options.instance.empty()) {
        // Comments behind the value would only make the lines too long for a request.
        for (std::string& line : lines)
            if (line.find('"') == std::string::npos)
                if (const auto comment = line.find(';'); comment != std::string::npos)
                    line.resize(line.find_last_not_of(" \t", comment ? comment - 1 : 0) + 1);
        return send_lines(options.instance, lines, true);
    }
    if (options.machine.empty()) {
        std::fputs(say("polyturn: say --instance NAME (a running controller) or --machine FILE (a "
                       "machine's file)\n")
                       .data(),
                   stderr);
        return 2;
    }
    return append_lines(options.machine, lines);
}

int diff(const ParamsOptions& options) {
    if (options.arguments.size() > 2)
        return refuse({Alarm::PressArgument, {}, {}, "two files at the most are compared"});
    TablePointer before =
        options.arguments.size() == 2 ? table_of_file(options.arguments[0]) : wanted_table(options);
    TablePointer after = table_of_file(options.arguments.back());
    if (!before || !after) return 2;
    const auto differences = params::difference(*before, *after);
    for (const auto& one : differences) print(params::to_string(one) + "\n");
    if (differences.empty()) print(say("no difference\n"));
    return differences.empty() ? 0 : 1;
}

// A machine's file is checked with the files next to it: the machine model and the measured errors.
int check(const ParamsOptions& options) {
    std::vector<Diagnosis> contradictions;
    if (options.arguments.empty() && !options.instance.empty()) {
        const TablePointer table = running_table(options.instance);
        if (!table) return 2;
        contradictions = check_machine_config(*table);
        if (const std::string base = running_base(options.instance); !base.empty()) {
            const std::string file = base + ".compensation";
            check_compensation_tables(*table, load_compensation(file, contradictions), file,
                                      contradictions);
        }
    } else {
        const LoadedMachine loaded = load_machine_file(
            options.arguments.empty() ? options.machine : options.arguments.front());
        if (tell(loaded.diagnoses)) return 2;
        (void)load_room(loaded.room_file, derive_machine_config(*loaded.table), contradictions);
        const std::vector<Diagnosis> config = check_machine_config(*loaded.table);
        contradictions.insert(contradictions.end(), config.begin(), config.end());
        const std::string file = compensation_file_of(loaded.params_file);
        check_compensation_tables(*loaded.table, load_compensation(file, contradictions), file,
                                  contradictions);
    }
    if (tell(contradictions)) return 1;
    print(say("consistent\n"));
    return 0;
}

}  // namespace

// Nothing said: the controller that `press` and `set` speak to, if it runs.
static ParamsOptions with_instance(ParamsOptions options) {
    constexpr std::string_view kUsual = "polyturn";
    if (!options.instance.empty() || !options.machine.empty() || options.action == "check")
        return options;
    if (const auto supervisor = PeerSegment<SupervisorSegment>::attach(kUsual);
        supervisor && process_lives((*supervisor)->header.writer_pid))
        options.instance = kUsual;
    return options;
}

int params_verb(const ParamsOptions& asked) {
    const ParamsOptions options = with_instance(asked);
    if (options.action == "list") return list(options);
    if (options.action == "get") return get(options);
    if (options.action == "set") return set(options);
    if (options.action == "export") return export_table(options);
    if (options.action == "import") return import_file(options);
    if (options.action == "diff") return diff(options);
    return check(options);
}

}  // namespace polyturn::supervisor
