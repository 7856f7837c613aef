#include "kernel/supervisor/start/start.hpp"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "ipc/model/machine/drive_sources.hpp"
#include "ipc/params/param_file.hpp"
#include "ipc/model/files/machine_path.hpp"
#include "kernel/supervisor/check/job_plan.hpp"
#include "kernel/supervisor/press/phrases.hpp"
#include "kernel/supervisor/start/start_session.hpp"

namespace polyturn::supervisor {
namespace fs = std::filesystem;
namespace {

// A machine that is named, or not even that, is one that comes with Polyturn, an example: a
// controller that is started with it gets a copy of its own next to its store, so that what is
// measured there is written there, not into the installed examples. A copy that is there already
// stays as it is. Whoever gives a path means the files of that path.
Result<std::string> own_machine(const StartOptions& options) {
    std::error_code wrong;
    if (options.machine.find('/') != std::string::npos || fs::exists(options.machine, wrong))
        return options.machine;
    const auto path = text::resolve_machine(options.machine);
    if (!path) return options.machine;  // reported where it is loaded
    const fs::path shipped = path->folder;
    const std::string store =
        options.store.empty() ? default_store(options.instance) : options.store;
    const fs::path own = fs::path(store) / "machines" / shipped.filename();
    if (fs::exists(own / "machine.params", wrong)) return own.string();
    // Whole or not at all, whatever ends this process: the copy gets its name when it is complete.
    const fs::path fresh = own.string() + ".new";
    fs::remove_all(fresh, wrong);
    fs::create_directories(own.parent_path(), wrong);
    if (!wrong) fs::copy(shipped, fresh, fs::copy_options::recursive, wrong);
    if (!wrong) fs::rename(fresh, own, wrong);
    if (wrong)
        return Diagnosis{Alarm::OutputFile, {}, {}, own.string() + " (" + wrong.message() + ")"};
    return own.string();
}

bool only_simulated(const params::Table& table) {
    const DriveSources drives = wanted_drives(table);
    return !drives.library && !drives.process;
}

// Where no drive is real, a tick that comes late on a computer that has other work hurts nobody: it
// is counted, and only a second of them in a row stops the machine. A limit that the machine or the
// command line gives holds.
void keep_braking_profile(StartOptions& options, params::Table& table) {
    const auto row = std::make_unique<params::Table>(params::defaults());
    if (params::get(table, params::pt_late_max) != params::get(*row, params::pt_late_max)) return;
    const std::string line = "PT_LATE_MAX=1000";  // ticks in a row
    const auto assignment = params::parse_assignment(line);
    if (!assignment || !params::apply(table, {&*assignment, 1})) return;
    options.sets.push_back(line);
    std::fputs(std::string(say("polyturn: all drives are simulated: a late tick stops nothing "
                               "(PT_LATE_MAX=1000).\n"))
                   .c_str(),
               stderr);
}

}  // namespace

int start_controller(const StartOptions& asked) {
    if (!valid_instance(asked.instance)) {
        print_diagnosis(Diagnosis{Alarm::InstanceName, {}, {}, asked.instance}, Dialect::Polyturn);
        return 2;
    }
    StartOptions options = asked;
    if (auto own = own_machine(asked)) {
        options.machine = std::move(*own);
    } else {
        print_diagnosis(own.diagnosis(), Dialect::Polyturn);
        return 2;
    }
    MachineSource source;
    source.machine = options.machine;
    source.param_files = options.param_files;
    source.sets = options.sets;
    LoadedMachine machine = load_machine(source);
    for (const Diagnosis& diagnosis : machine.diagnoses)
        print_diagnosis(diagnosis, Dialect::Polyturn);
    if (!machine.ok()) return 2;
    if (only_simulated(*machine.table)) keep_braking_profile(options, *machine.table);
    catch_signals();
    auto server = RequestServer::open(options.instance);
    if (!server) {
        print_diagnosis(server.diagnosis(), Dialect::Polyturn);
        return 2;
    }
    int status = 0;
    bool stuck = false;
    {
        StartSession session(options, std::move(machine), std::move(*server));
        status = session.run();
        stuck = session.stuck();
    }
    if (stuck) _exit(status);  // it is not waited for
    return status;
}

}  // namespace polyturn::supervisor
