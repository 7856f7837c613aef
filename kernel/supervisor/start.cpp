#include "kernel/supervisor/start.hpp"

#include <unistd.h>

#include "kernel/supervisor/job_plan.hpp"
#include "kernel/supervisor/start_session.hpp"

namespace polyturn::supervisor {

int start_controller(const StartOptions& options) {
    if (!valid_instance(options.instance)) {
        print_diagnosis(Diagnosis{Alarm::InstanceName, {}, {}, options.instance}, Dialect::Polyturn);
        return 2;
    }
    MachineSource source;
    source.machine = options.machine;
    source.param_files = options.param_files;
    source.sets = options.sets;
    LoadedMachine machine = load_machine(source);
    for (const Diagnosis& diagnosis : machine.diagnoses) print_diagnosis(diagnosis, Dialect::Polyturn);
    if (!machine.ok()) return 2;
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
    if (stuck) _exit(status);   // nobody waits for it
    return status;
}

}  // namespace polyturn::supervisor
