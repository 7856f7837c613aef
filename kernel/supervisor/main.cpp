// The `polyturn` command: its functions are described in docs and in cli.md.
#include <csignal>

#include "kernel/supervisor/base/options.hpp"
#include "kernel/supervisor/check/check.hpp"
#include "kernel/supervisor/job/job_verb.hpp"
#include "kernel/supervisor/press/dialogue_verb.hpp"
#include "kernel/supervisor/run/run.hpp"
#include "kernel/supervisor/start/start.hpp"
#include "kernel/supervisor/status/ask_verbs.hpp"
#include "kernel/supervisor/status/bench.hpp"
#include "kernel/supervisor/store/params_verb.hpp"
#include "kernel/supervisor/store/store_verb.hpp"

int main(int argc, char** argv) {
    using namespace polyturn::supervisor;
    // a reader that goes away is no reason to leave a machine without its supervisor
    std::signal(SIGPIPE, SIG_IGN);
    const CommandLine line = read_command_line(argc, argv);
    switch (line.verb) {
        case Verb::Check:
            return check_programs(line.job);
        case Verb::Run:
            return run_programs(line.job);
        case Verb::Start:
            return start_controller(line.start);
        case Verb::Press:
        case Verb::Set:
        case Verb::Release:
            return press_words(line);
        case Verb::Status:
            return show_status(line);
        case Verb::Alarms:
            return show_alarms(line);
        case Verb::Job:
            return job_verb(line.of_job);
        case Verb::Dialogue:
            return dialogue_verb(line);
        case Verb::Clean:
            return clean_up();
        case Verb::Params:
            return params_verb(line.params);
        case Verb::Bench:
            return run_benchmarks(line.rest);
        case Verb::Store:
            return store_verb(line.store, line.json);
        case Verb::None:
            break;
    }
    return line.exit_status;
}
