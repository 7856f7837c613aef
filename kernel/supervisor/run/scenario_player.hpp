// Stimuli of a scenario as commands for exact ticks: those with a time at once, those with `when`
// as soon as their event has happened. What only the supervisor can do (kill, stop a process)
// becomes an Action command, and is carried out when the kernel says that its tick has come.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/model/files/scenario.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::supervisor {

// A process and what is done to it.
struct ProcessAction {
    enum class Kind { Kill, Stop, Continue } kind = Kind::Kill;
    std::size_t slot = 0;  // kProcessKernel ...
    // Stop of the kernel: its time stops with it, so the wall's says when it goes on; 0: somebody
    // else does
    double for_s = 0.0;
};

// A command, or an action with the Action command that brings it about.
struct Planned {
    double t_s = 0.0;  // since cycle start
    Command command{};
    std::optional<ProcessAction> action;
};

class ScenarioPlayer {
public:
    ~ScenarioPlayer();
    ScenarioPlayer(ScenarioPlayer&&) noexcept;
    ScenarioPlayer& operator=(ScenarioPlayer&&) noexcept;
    // Understands all words; the diagnoses have the places in the scenario file.
    static std::optional<ScenarioPlayer> make(const text::Scenario& scenario,
                                              const MachineConfig& machine,
                                              std::vector<Diagnosis>& diagnoses);

    // Stimuli with a time, in the file's order.
    const std::vector<Planned>& timed() const;
    bool has_when() const;
    bool has_actions() const;
    // Does anything in it press cycle start? Then programmed stops are its business.
    bool presses_cycle_start() const;
    // What the event starts. Each stimulus acts once, at its first match. t_s: of the event.
    std::vector<Planned> match(std::string_view event_text, double t_s);
    bool waits_for_events() const;                       // a `when` that has not happened
    std::set<unsigned> channels_not_waited_for() const;  // CP_NOWT or ignore_waits at some time
    std::set<unsigned> channels_that_read() const;       // by select and mdi: they need a process

private:
    struct Parts;
    explicit ScenarioPlayer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

// "channel 2", "plc", "kernel": the process slot, or nothing.
std::optional<std::size_t> process_slot(std::string_view words);
std::string process_name(std::size_t slot);

}  // namespace polyturn::supervisor
