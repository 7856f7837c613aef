#include "ipc/model/machine/load_machine.hpp"

#include <algorithm>

#include "ipc/model/bodies/room.hpp"
#include "ipc/model/machine/check/config_check.hpp"
#include "ipc/model/compensation/compensation_tables.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/params/param_file.hpp"
#include "ipc/model/files/machine_path.hpp"
#include "ipc/model/files/read_file.hpp"

namespace polyturn {
namespace {

void append(std::vector<Diagnosis>& to, std::vector<Diagnosis> from) {
    std::move(from.begin(), from.end(), std::back_inserter(to));
}

void apply_file(const std::string& path, params::Table& table, std::vector<Diagnosis>& diagnoses) {
    const Result<std::string> content = text::read_text_file(path);
    if (!content) {
        diagnoses.push_back(content.diagnosis());
        return;
    }
    params::ParsedFile parsed = params::parse_param_file(*content, path);
    if (const Result<void> done = params::apply(table, parsed.assignments); !done)
        diagnoses.push_back(done.diagnosis());
    append(diagnoses, std::move(parsed.diagnoses));
}

}  // namespace

bool any_error(const std::vector<Diagnosis>& diagnoses) {
    return std::any_of(diagnoses.begin(), diagnoses.end(),
                       [](const Diagnosis& d) { return d.severity() == Severity::Error; });
}

bool LoadedMachine::ok() const { return !any_error(diagnoses); }

LoadedMachine load_machine_file(const std::string& machine) {
    LoadedMachine loaded;
    loaded.table = std::make_unique<params::Table>();
    params::set_defaults(*loaded.table);
    const Result<text::MachinePath> path = text::resolve_machine(machine);
    if (!path) {
        loaded.diagnoses.push_back(path.diagnosis());
        return loaded;
    }
    loaded.params_file = path->params;
    loaded.room_file = path->room;
    apply_file(path->params, *loaded.table, loaded.diagnoses);
    return loaded;
}

void apply_overrides(const MachineSource& source, params::Table& table,
                     std::vector<Diagnosis>& diagnoses) {
    for (const std::string& file : source.param_files) apply_file(file, table, diagnoses);
    for (const std::string& line : source.sets) {
        const Result<params::Assignment> assignment = params::parse_assignment(line);
        Result<void> done = assignment ? params::apply(table, {&*assignment, 1})
                                       : Result<void>(assignment.diagnosis());
        if (done) continue;
        if (done.diagnosis().place.file.empty()) done.diagnosis().place.file = "--set";
        diagnoses.push_back(done.diagnosis());
    }
}

LoadedMachine load_machine(const MachineSource& source) {
    LoadedMachine loaded = load_machine_file(source.machine);
    // Bodies that cannot be are refused here, for the kernel would guard against others than the
    // machine has. They are checked by the machine's own file: an axis that one run takes away
    // leaves its place in the work area empty.
    if (loaded.ok())
        (void)load_room(loaded.room_file, derive_machine_config(*loaded.table), loaded.diagnoses);
    apply_overrides(source, *loaded.table, loaded.diagnoses);
    if (loaded.ok()) append(loaded.diagnoses, check_machine_config(*loaded.table));
    if (loaded.ok()) {
        const std::string file = compensation_file_of(loaded.params_file);
        check_compensation_tables(*loaded.table, load_compensation(file, loaded.diagnoses), file,
                                  loaded.diagnoses);
    }
    return loaded;
}

}  // namespace polyturn
