// What check and run work on, read and checked: machine, programs by channel, setup, job. Whatever
// is wrong is reported before anything starts.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ipc/diagnosis/languages.hpp"
#include "ipc/model/machine/load_machine.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/model/files/builder_messages.hpp"
#include "ipc/model/files/job.hpp"
#include "ipc/model/files/setup.hpp"
#include "kernel/supervisor/base/options.hpp"

namespace polyturn::supervisor {

struct PlannedProgram {
    std::string file;      // as written: events name it so
    std::string language;  // never empty
    Dialect dialect = Dialect::Polyturn;
    bool language_chosen = false;  // by option or job, rather than by the machine
};

struct JobPlan {
    MachineSource source;
    std::unique_ptr<params::Table> table;
    std::unique_ptr<MachineConfig> machine;
    std::string room_file;
    text::BuilderMessages messages;
    std::map<unsigned, PlannedProgram> programs;  // by channel
    // by option, also of channels without a program here
    std::map<unsigned, std::string> chosen_languages;
    text::Setup setup;       // zeros of the job included
    std::string setup_path;  // for the other processes; empty: none
    std::optional<text::Job> job;
    std::vector<int> memory_files;  // of files that were put together here

    Dialect dialect(unsigned channel) const;
    // Of a program that another one begins in a channel without one: as an option says; else in the
    // language that was chosen for the one that begins it; else as the machine says.
    std::string started_language(unsigned channel, const PlannedProgram& by) const;
    // Whether the setup gives this axis of the channel as a diameter, as the display shows it
    // (cli.md 2).
    bool shows_diameter(unsigned channel, const AxisConfig& axis) const;
    JobPlan() = default;
    JobPlan(JobPlan&&) noexcept;
    JobPlan& operator=(JobPlan&&) = delete;
    ~JobPlan();
    // "--machine M --set S ... --param-file F ... --setup F", as every process of Polyturn takes
    // them.
    std::vector<std::string> machine_arguments() const;
};

// Diagnoses of plan_job: what to print and with which exit status to end.
struct PlanFailure {
    std::vector<Diagnosis> diagnoses;
    int exit_status = 2;  // 1: a contradiction in the configuration; 2: unreadable input
};

// How the programs are worked on: a check has no store, so that what it knows of tools comes by the
// setup.
enum class JobWork : unsigned char { Check, Run };
std::optional<JobPlan> plan_job(const JobOptions& options, JobWork work, PlanFailure& failure);

// Renders for people on stderr, with the line it speaks of where the file can be read, and as an
// alarm event.
void print_diagnosis(const Diagnosis& diagnosis, Dialect dialect);
// The same from an alarm event that a channel made.
void print_alarm_event(std::string_view event_text, Dialect dialect);
std::string language_of(const params::Table& table, unsigned channel);

}  // namespace polyturn::supervisor
