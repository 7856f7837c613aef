// What the command line says, before anything is read or started (cli.md 1, 4, 7).
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace polyturn::supervisor {

// check and run
struct JobOptions {
    std::vector<std::string> programs;   // "L=FILE", "FILE" or one NAME.job.toml
    std::vector<std::string> languages;  // "NAME" or "L=NAME"
    std::string machine, setup, instance, like, store;
    std::vector<std::string> sets, param_files;
    // "FILE=COPY": of a job's program, the text that is read in its place
    std::vector<std::string> instead;
    bool variables = false, quiet = false;
    // check: a longer program counts as one without an end; 0: no limit
    std::uint64_t most_blocks = 10'000'000;
    // run only
    bool virtual_time = false, report = false;
    std::string trace_file, plot_file, scenario;
    unsigned trace_every = 1, parts = 0;
    std::vector<std::string> watch, overrides, from;
};

struct StartOptions {
    std::string machine, instance = "polyturn", store;
    std::vector<std::string> sets, param_files;
    bool no_hmi = false, virtual_time = false;
};

struct ParamsOptions {
    std::string action;  // list get set export import diff check
    std::vector<std::string> arguments;
    std::string machine, instance;
    bool unused = false, all = false;
};

// Verbs that ask the store: tools, offsets, parts, pallets, users, history, stops, login, backup,
// restore.
struct StoreOptions {
    std::string group, action;  // "tools", "load"
    std::vector<std::string> words;
    std::string instance, format = "csv", store, machine, who, since, zero, name;
    std::vector<std::string> with;
    int channel = 0, magazine = -1, type = -1, most = 50, offset = -1, frames = 0, plane = 0;
    bool incremental = false, preview = false, yes = false, with_plc = false;
};

struct JobVerbOptions {
    std::string action, file, instance;  // diff, load
};

enum class Verb {
    None,
    Job,
    Check,
    Run,
    Start,
    Press,
    Set,
    Release,
    Status,
    Alarms,
    Params,
    Clean,
    Bench,
    Store,
    Dialogue
};

struct CommandLine {
    Verb verb = Verb::None;
    // of Verb::None: help or version was printed (0), or the usage was wrong (2)
    int exit_status = 0;
    JobOptions job;
    StartOptions start;
    ParamsOptions params;
    StoreOptions store;
    JobVerbOptions of_job;
    std::string instance;           // press, set, alarms: empty means polyturn; status: all
    std::string words;              // press, set, release: the rest of the line
    std::vector<std::string> rest;  // bench
    bool json = false;
};

// Reads the arguments; prints help, version or what is wrong with them itself.
CommandLine read_command_line(int argc, char** argv);

}  // namespace polyturn::supervisor
