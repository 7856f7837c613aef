#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "kernel/supervisor/base/options.hpp"
#include "kernel/supervisor/base/version.hpp"
#include "kernel/supervisor/press/phrases.hpp"
#include "kernel/supervisor/store/store_command_line.hpp"

namespace polyturn::supervisor {

namespace {

// In the reader's language (POLYTURN_LANG, LC_ALL ...).
std::string tell(const char* english) { return std::string(say(english)); }

constexpr const char* kExitStatus =
    "Exit status: 0 done; 1 the job ended with an alarm; 2 wrong usage or unreadable input.";

// Each occurrence takes one argument, so that programs may follow it.
CLI::Option* repeatable(CLI::App& app, const char* name, std::vector<std::string>& into,
                        const char* text) {
    return app.add_option(name, into, tell(text))->allow_extra_args(false);
}

void add_job_options(CLI::App& app, JobOptions& job) {
    app.add_option(
           "PROGRAM", job.programs,
           tell("L=FILE (channel and file), FILE (the first for channel 1, and so on), or one "
                "NAME.job.toml"))
        ->required();
    repeatable(app, "--language", job.languages,
               "[L=]NAME: fanuc, nct, fagor, sinumerik or mefi; otherwise the machine says");
    app.add_option("--machine", job.machine,
                   tell("parameter file, or folder with machine.params; default: "
                        "examples/machines/twin-turret"));
    repeatable(app, "--set", job.sets,
               "one parameter: 'NAME [SCOPE]=VALUE', such as 'N1300 L1=5'; repeatable");
    repeatable(app, "--param-file", job.param_files, "file of such lines; repeatable");
    app.add_option("--setup", job.setup,
                   tell("what an operator would have entered: positions, zeros, offsets, variables,"
                        " keys (TOML)"));
    app.add_option("--instance", job.instance, tell("name of the private controller"));
    app.add_option("--like", job.like,
                   tell("copies offsets, tools, zeros and parameters of this running controller"));
    // for the editor, whose text is not saved yet
    app.add_option("--instead", job.instead)->allow_extra_args(false)->group("");
    app.add_option("--store", job.store, tell("keeps what the programs write in this folder"));
    app.add_flag("--variables", job.variables,
                 tell("also report every variable that a program writes"));
    app.add_flag("--quiet", job.quiet, tell("only alarms, messages and the summary"));
    app.add_option("--scenario", job.scenario, tell("what happens while it runs (TOML)"));
    repeatable(
        app, "--watch", job.watch,
        "report each change of this flag or register, such as 'CN_WTNG L1' (run); repeatable");
    app.footer(tell(kExitStatus));
}

void add_run_options(CLI::App& app, JobOptions& job) {
    app.add_flag("--virtual", job.virtual_time,
                 tell("virtual time: as fast as it goes, identical every time"));
    app.add_option("--trace", job.trace_file,
                   tell("positions, speeds and states of each tick (CSV)"));
    app.add_option("--trace-every", job.trace_every, tell("a line each so many ticks"))
        ->check(CLI::Range(1u, 1'000'000u));
    repeatable(app, "--override", job.overrides, "[L=]PERCENT: feed override at the start");
    repeatable(app, "--from", job.from, "L=N120: program restart at a block; repeatable");
    app.add_option("--parts", job.parts, tell("parts to make (default 1)"))
        ->check(CLI::Range(1u, 1'000'000'000u));
    app.add_option("--plot", job.plot_file, tell("tool paths and the channels' timeline (SVG)"));
    app.add_flag("--report", job.report,
                 tell("print where the time went, for reading, after the events"));
}

std::string joined(const std::vector<std::string>& words) {
    std::string out;
    for (const auto& word : words) {
        if (!out.empty()) out += ' ';
        out += word;
    }
    return out;
}

// The words of press and set may begin with a sign ("-120"), so they are not parsed as options;
// --instance may stand among them.
void take_words(const CLI::App& app, CommandLine& line) {
    std::vector<std::string> words = app.remaining();
    for (std::size_t i = 0; i < words.size();) {
        if (words[i] == "--instance" && i + 1 < words.size()) {
            line.instance = words[i + 1];
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                        words.begin() + static_cast<std::ptrdiff_t>(i) + 2);
        } else if (words[i].rfind("--instance=", 0) == 0) {
            line.instance = words[i].substr(11);
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(i));
        } else {
            ++i;
        }
    }
    line.words = joined(words);
}

constexpr const char* kPressWords =
    "  cycle_start [L|T]   feed_hold [L|T]   reset [L|T]   emergency_stop   "
    "release_emergency_stop   machine_on\n"
    "  mode L1=auto|mdi|jog|handwheel|reference   select L1=FILE   select JOB\n"
    "  mdi L1 G0 X50. (enters a block, cycle_start L1 runs it)   mdi_clear L1   hand_key L1 T0101\n"
    "  jog A3+ 0.5s   step A3- 0.01   handwheel 1 A3 +120   reference A3|all\n"
    "  feed_override L1=50   rapid_override L1=25   spindle_override S1=80\n"
    "  single_block L1=on|T1=on   optional_stop L1=on   block_skip L1=1   dry_run L1=on   "
    "machine_lock L1=on\n"
    "  restart L1=N120 L2=N340   retrace L1=on   jog_in_hold L1   return L1   ignore_waits "
    "L2=on   stop_after_part\n"
    "  rapid_key L1=on   first_part L1=on   warm_up L1=600   program_wheel L1=on   superpose "
    "L1=on\n"
    "  answer L1 #500=12.5 key=1\n";

}  // namespace

CommandLine read_command_line(int argc, char** argv) {
    CommandLine line;
    CLI::App app{tell("Polyturn: a multi-channel lathe controller"), "polyturn"};
    app.set_help_flag("-h,--help", tell("Print this help message and exit"));
    app.set_version_flag("--version", std::string("polyturn ") + kVersion,
                         tell("Display program version information and exit"));
    for (const char* label :
         {"Usage", "OPTIONS", "Options", "Positionals", "Subcommands", "SUBCOMMAND", "REQUIRED"})
        app.get_formatter()->label(label, tell(label));
    app.footer(tell(kExitStatus));
    app.require_subcommand(1);

    CLI::App* check = app.add_subcommand(
        "check", tell("Interprets programs and matches their waits; nothing moves"));
    add_job_options(*check, line.job);
    check->add_option(
        "--most-blocks", line.job.most_blocks,
        tell("blocks after which a program counts as endless (default 10000000); 0: no limit"));
    CLI::App* run = app.add_subcommand(
        "run", tell("Runs programs on a private machine, in real or virtual time"));
    add_job_options(*run, line.job);
    add_run_options(*run, line.job);
    CLI::App* start = app.add_subcommand(
        "start", tell("The controller; it stays in the foreground, SIGTERM is a controlled stop"));
    start->add_option("MACHINE", line.start.machine,
                      tell("parameter file or folder; default: examples/machines/twin-turret"));
    start->add_option("--instance", line.start.instance, tell("its name; default polyturn"));
    start->add_option(
        "--store", line.start.store,
        tell("folder of what must survive power-off; default $XDG_STATE_HOME/polyturn/NAME"));
    start->add_flag("--no-hmi", line.start.no_hmi, tell("without screens"));
    repeatable(*start, "--set", line.start.sets, "one parameter; repeatable");
    repeatable(*start, "--param-file", line.start.param_files,
               "file of parameter lines; repeatable");

    CLI::App* press =
        app.add_subcommand("press", tell("What an operator does, on a running controller"))
            ->prefix_command();
    press->footer(tell("What can be pressed:") + "\n" + kPressWords + tell(kExitStatus));
    CLI::App* set =
        app.add_subcommand(
               "set",
               tell("Forces a PLC signal, register, input or drive fault, or sets a parameter: "
                    "'AP_SYNCR A3=1'"))
            ->prefix_command();
    CLI::App* release =
        app.add_subcommand("release", tell("Gives a forced signal back to the PLC: 'AP_SYNCR A3'"))
            ->prefix_command();
    CLI::App* dialogue =
        app.add_subcommand(
               "dialogue",
               tell("What programs ask the operator; with words: the answer, 'L1 #500=12.5 key=1'"))
            ->prefix_command();
    dialogue->add_flag("--json", line.json, tell("for programs"));
    for (CLI::App* one : {press, set, release, dialogue})
        one->add_option("--instance", line.instance, tell("the controller; default polyturn"));

    CLI::App* status = app.add_subcommand("status", tell("What runs, and what it does"));
    CLI::App* alarms =
        app.add_subcommand("alarms", tell("The alarms since the controller was started"));
    for (CLI::App* one : {status, alarms}) {
        one->add_option("--instance", line.instance,
                        tell(one == status ? "the controller; default: all that run"
                                           : "the controller; default polyturn"));
        one->add_flag("--json", line.json, tell("for programs"));
    }

    CLI::App* params = app.add_subcommand(
        "params", tell("Parameters of a running controller (--instance) or of a machine file"));
    params->require_subcommand(1);
    struct Action {
        const char *name, *text, *argument, *meaning;
        bool many, needed;
    };
    static constexpr Action kActions[] = {
        {"list", "All parameters, or those whose number or name holds a text", "TEXT",
         "part of number, name or group", true, false},
        {"get", "Everything about one parameter; its value last", "NAME", "'N1600 L1'", true, true},
        {"set", "Sets one or more; returns when they are on disk", "LINE", "'N1600 L1=2.5'", true,
         true},
        {"export", "Parameter lines that read in again to the same values", "FILE",
         "where to; default: standard output", false, false},
        {"import", "Sets all lines of a file, or none when one is wrong", "FILE", "parameter file",
         false, true},
        {"diff", "What differs between two machines or files", "FILE",
         "one file (compared with the machine) or two", true, true},
        {"check", "Is the file right, and do its values fit together?", "FILE",
         "parameter file or machine folder; default: the machine", false, false},
    };
    std::vector<CLI::App*> actions;
    for (const Action& action : kActions) {
        CLI::App* one = params->add_subcommand(action.name, tell(action.text));
        auto* argument =
            one->add_option(action.argument, line.params.arguments, tell(action.meaning));
        if (!action.many) argument->expected(0, 1);
        if (action.needed) argument->required();
        one->add_option("--instance", line.params.instance, tell("a running controller"));
        one->add_option("--machine", line.params.machine,
                        tell("parameter file or folder; default: examples/machines/twin-turret"));
        if (std::string_view(action.name) == "list") {
            one->add_flag("--unused", line.params.unused,
                          tell("only those without effect, with the reason"));
        } else if (std::string_view(action.name) == "export") {
            one->add_flag("--all", line.params.all, tell("also what has its default"));
        }
        one->footer(tell(kExitStatus));
        actions.push_back(one);
    }

    CLI::App* job =
        app.add_subcommand("job", tell("A job's zeros and offsets, on a running controller"));
    job->require_subcommand(1);
    std::vector<CLI::App*> job_actions;
    for (const auto& [name, text] :
         {std::pair{"load", "Selects the job and enters its zeros and the offsets of its setup"},
          {"diff", "What is entered otherwise than the job has it"}}) {
        CLI::App* one = job->add_subcommand(name, tell(text));
        one->add_option("JOB", line.of_job.file, tell("NAME.job.toml"))->required();
        one->add_option("--instance", line.of_job.instance,
                        tell("the controller; default polyturn"));
        one->footer(tell(
            "Exit status: 0 done, or nothing differs; 1 something differs or this machine does "
            "not have it; 2 refused."));
        job_actions.push_back(one);
    }
    add_store_verbs(app, line);
    CLI::App* clean = app.add_subcommand(
        "clean", tell("Removes what no living process holds: shared memory, sockets"));
    CLI::App* bench =
        app.add_subcommand("bench",
                           tell("Runs the benchmarks of this build and prints their figures"))
            ->prefix_command();

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const int code = app.exit(error, std::cout, std::cerr);  // 0 for help and version
        line.exit_status = code == 0 ? 0 : 2;
        return line;
    }

    if (!line.store.group.empty()) line.verb = Verb::Store;
    if (*check) line.verb = Verb::Check;
    if (*run) line.verb = Verb::Run;
    if (*start) line.verb = Verb::Start;
    if (*status) line.verb = Verb::Status;
    if (*alarms) line.verb = Verb::Alarms;
    if (*clean) line.verb = Verb::Clean;
    if (*bench) {
        line.verb = Verb::Bench;
        line.rest = bench->remaining();
    }
    for (auto [one, verb] :
         {std::pair{press, Verb::Press}, {set, Verb::Set}, {release, Verb::Release}})
        if (*one) {
            line.verb = verb;
            take_words(*one, line);
            if (line.words.empty() || line.words == "--help") {
                (line.words.empty() ? std::cerr : std::cout) << one->help();
                line.exit_status = line.words.empty() ? 2 : 0;
                line.verb = Verb::None;
            }
        }
    if (*dialogue) {
        line.verb = Verb::Dialogue;
        take_words(*dialogue, line);
    }
    if (*job) {
        line.verb = Verb::Job;
        for (CLI::App* one : job_actions)
            if (*one) line.of_job.action = one->get_name();
    }
    if (*params) {
        line.verb = Verb::Params;
        for (CLI::App* one : actions)
            if (*one) line.params.action = one->get_name();
    }
    return line;
}

}  // namespace polyturn::supervisor
