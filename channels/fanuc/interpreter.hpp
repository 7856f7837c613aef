// The fanuc family: address words, G codes by table, custom macro B. Used for fanuc (systems A, B,
// C), nct and mefi.
//
// One step() reads one block (program/reading.cpp):
//   scan -> words   classify -> G rows, M codes   check -> every word is taken by somebody   act, in the order of GGroup
//   settings -> F -> S -> T -> M that begin -> one-shot or motion -> M that end -> calls
// A block that needs a live value stops before anything has been done: AtBarrier, then it is read
// again (architecture 5.5).
//
// This class is the language to the rest of the channel. The state of the run is Execution, and what
// blocks do are free functions over it.
#pragma once
#include <string>

#include "channels/fanuc/execution.hpp"
#include "channels/language.hpp"

namespace polyturn::channels::fanuc {

class Interpreter : public Language {
public:
    Interpreter(MachineView& view, Sink& sink, Port& port, ProgramFiles& files,
                MakeSettings make_settings)
        : x_(view, sink, port, files, make_settings) {}

    Result<void> start(FileId main) override;
    Step step() override;
    void barrier_done() override;
    Core& core() override { return x_.core; }

    bool preset_variable(std::string_view name, double value) override;
    void active_codes(std::string& out) const override;
    void list_variables(const ShowVariable& show) const override;

    void keep_resume_states(bool on) override;
    void executed(std::uint64_t serial) override;
    bool resume_at(std::uint64_t serial) override;
    bool may_resume_at(std::uint64_t serial) const override;
    bool offsets_changed() override;
    bool starts_away() const override;
    void start_away(const AxisValues& by) override;

    bool interrupt(std::uint64_t serial, bool within, unsigned input) override;
    bool interrupt_ahead(std::uint64_t serial) override;
    void interrupt_arrived() override;

    std::any carry() const override;
    void take_carry(const std::any& before, bool after_reset) override;
    bool loses_offset(bool by_reset) const override;

private:
    Execution x_;
};

}  // namespace polyturn::channels::fanuc
