// The language fagor (8037 T) as the channel sees it: ISO blocks with G codes by table, statements
// in round brackets. It owns one Execution and passes each request on to the functions of its
// topic.
//
//   grammar/    a line to words or a statement; the table of G codes
//   flow/       blocks, barriers, calls, statements, interrupts, the way back
//   variables/  what programs read and write by name
//   motion/ frames/ cycles/ tools/   what the codes and words do
//
// One step() reads one block (flow/step.cpp):
//   header -> words or statement   words: classify -> check that every word has a taker -> act, in
//                                  the order of GGroup
// A block that needs a live value stops before anything has been done: AtBarrier, then it is read
// again (architecture 5.5).
#pragma once
#include <any>
#include <cstdint>
#include <string>
#include <string_view>

#include "channels/fagor/execution.hpp"
#include "channels/language.hpp"

namespace polyturn::channels::fagor {

class Interpreter final : public Language {
public:
    Interpreter(MachineView& view, Sink& sink, Port& port, ProgramFiles& files)
        : x_(view, sink, port, files) {}

    Result<void> start(FileId main) override;
    Step step() override;
    void barrier_done() override;
    bool preset_variable(std::string_view name, double value) override;
    void preset_stored(const ToolTable& tools, const ToolEdgeTable& edges, int unit) override;
    Core& core() override { return x_.core; }
    void active_codes(std::string& out) const override;
    void list_variables(const ShowVariable& show) const override;
    void keep_resume_states(bool on) override;
    void executed(std::uint64_t serial) override;
    bool resume_at(std::uint64_t serial) override;
    bool may_resume_at(std::uint64_t serial) const override;
    bool offsets_changed() override;
    bool interrupt(std::uint64_t serial, bool within, unsigned input) override;
    std::any carry() const override;
    void take_carry(const std::any& before, bool after_reset) override;

private:
    Execution x_;
};

}  // namespace polyturn::channels::fagor
