// The language sinumerik: blocks of words and high-level statements.
//
// One step() reads one block (a line):
//   skip level, block number, labels -> statement (IF, GOTOF, DEF, CALL ...), or words: every value
//   is computed, every assignment made -> check: one G command a group, every word has a reader ->
//   act, in the order of act.cpp: settings -> T D -> F -> S M3 M4 M5 -> M H -> procedures -> motion
//   -> M that end -> calls
// Nothing has happened before the check. A block that needs a live value puts its assignments back
// and is read again behind the barrier (architecture 5.5).
//
// The class goes from block to block; what the words of the language do is in free functions by
// topic, which the rows of the tables point to and which work on an Execution.
#pragma once
#include <string_view>

#include "channels/language.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/flow/carry.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/tools/managed_tools.hpp"
#include "channels/sinumerik/variables/presets.hpp"
#include "channels/state/resume_points.hpp"

namespace polyturn::channels::sinumerik {

class Interpreter final : public Language {
public:
    Interpreter(MachineView& view, Sink& sink, Port& port, ProgramFiles& files);

    Result<void> start(FileId main) override;
    Step step() override;
    void barrier_done() override;
    Core& core() override { return x_.core; }

    // from block to block back (resume.cpp, interrupts.cpp)
    void keep_resume_states(bool on) override { sinumerik::keep_resume_states(x_, on); }
    void executed(std::uint64_t serial) override;
    bool resume_at(std::uint64_t serial) override;
    bool may_resume_at(std::uint64_t serial) const override;
    bool interrupt(std::uint64_t serial, bool within, unsigned input) override;

    // what setup and operator give, what screens show
    bool preset_variable(std::string_view name, double value) override {
        return sinumerik::preset_variable(x_, name, value);
    }
    bool preset_text(std::string_view name, std::string_view value) override {
        return sinumerik::preset_text(name, value);
    }
    bool preset_tool(int number, std::string_view name) override {
        return sinumerik::preset_tool(x_, number, name);
    }
    bool preset_edge(int tool, int edge, std::string_view parameter, double value) override {
        return sinumerik::preset_edge(x_, tool, edge, parameter, value);
    }
    void preset_stored(const polyturn::ToolTable& tools, const polyturn::ToolEdgeTable& edges,
                       int unit) override {
        sinumerik::preset_stored(x_, tools, edges, unit);
    }
    void active_codes(std::string& out) const override { sinumerik::active_codes(x_, out); }
    void list_variables(const ShowVariable& show) const override {
        sinumerik::list_variables(x_, show);
    }
    bool offsets_changed() override { return sinumerik::offsets_changed(x_); }
    std::any carry() const override { return sinumerik::carry(x_); }
    void take_carry(const std::any& before, bool after_reset) override {
        sinumerik::take_carry(x_, before, after_reset);
    }

private:
    struct ResumeState {
        PathState path;
        Modal modal;
        std::vector<Level> levels;
        std::map<std::string, std::string, std::less<>> macros;
        double parts = 0;
        std::vector<SynchronizedAction> actions;
    };

    Step read_block();
    bool read_line();
    bool run_statement();
    bool does_anything() const;
    Step after_block(bool ok);
    Step end_of_text();
    Step fault(Fault fault);
    void live_value_barrier();
    void note_resume_point();

    Execution x_;
    ResumePoints<ResumeState> points_;
};

}  // namespace polyturn::channels::sinumerik
