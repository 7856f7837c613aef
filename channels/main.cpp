// polyturn-channel: one machining channel. With --check it interprets a program without a machine.
#include <CLI/CLI.hpp>

#include "channels/check/check_mode.hpp"
#include "channels/process/run_mode.hpp"
#include "ipc/memory/life_line.hpp"

int main(int argc, char** argv) {
    using namespace polyturn;
    CLI::App app{
        "Polyturn: the process of one machining channel. Started by polyturn, not by hand."};
    bool check = false;
    channels::CheckOptions options;
    std::string instance, retained;
    app.add_flag("--check", check, "interpret a program without a machine and print its events");
    app.add_option("--instance", instance, "the controller to attach to");
    app.add_option("--channel", options.channel, "number of the channel, from 1")
        ->check(CLI::Range(1u, static_cast<unsigned>(kMaxChannels)));
    app.add_option("--language", options.language, "fanuc, nct, fagor, sinumerik, mefi");
    app.add_option("--machine", options.machine.machine,
                   "a machine: parameter file, folder or name");
    app.add_option("--set", options.machine.sets, "one parameter line; repeatable")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--param-file", options.machine.param_files,
                   "a file of parameter lines; repeatable")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--setup", options.setup, "what an operator would have entered before");
    app.add_flag("--variables", options.variables,
                 "also report every variable that the program writes");
    app.add_option("--retained", retained, "folder of what must survive power-off");
    app.add_option("--shared", options.shared,
                   "file of the variables that all programs of the check share");
    app.add_option("--most-blocks", options.most_blocks,
                   "blocks after which a program counts as endless; 0: none");
    app.add_flag("--alone", options.alone, "no other channel's program takes part in the check");
    app.add_option("program", options.program, "program file");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) { return app.exit(error) == 0 ? 0 : 2; }
    if (check) {
        if (options.program.empty()) {
            std::fputs("polyturn-channel: --check needs a program\n", stderr);
            return 2;
        }
        return channels::run_check(options, stdout);
    }
    if (instance.empty()) {
        std::fputs("polyturn-channel: --instance or --check is needed; see --help\n", stderr);
        return 2;
    }
    end_with_kernel(instance);
    const auto ended = channels::run_mode(
        {instance, options.channel, options.language, options.setup, retained, options.variables});
    if (!ended) {
        std::fputs(render(ended.diagnosis(), Dialect::Polyturn, {}).c_str(), stderr);
        return 1;
    }
    return 0;
}
