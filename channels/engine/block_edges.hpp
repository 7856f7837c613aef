// What every language does before it reads a block and behind it, in the same order: whether a
// block may be read now, what a barrier that has been passed makes known, how a program ends, and
// what a step comes to when its block has ended. What the block itself does is the language's.
#pragma once
#include <cstdint>
#include <optional>

#include "channels/engine/block_run.hpp"
#include "channels/language.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::engine {

// May the next block be read?
enum class Gate : std::uint8_t {
    Open,
    Barrier,  // what compensation holds back ends in a barrier that comes first
    Fault,    // compensation has refused a block that was read before: Core::fault()
    Ended,
};

inline Gate gate(Core& core, const BlockRun& run) {
    if (core.reads_ahead()) {
        if (core.halted()) return Gate::Barrier;
        if (!run.ended && !core.compensation_failed()) return Gate::Fault;
    }
    return run.ended ? Gate::Ended : Gate::Open;
}

// What the step of a block comes to when the block has ended. A barrier behind it is held back
// while compensation holds the block.
inline Step step_behind(const Core& core, const BlockRun& run) {
    if (core.reads_ahead())
        return core.halted() ? Step::AtBarrier : run.ended ? Step::Ended : Step::Continue;
    if (run.ended) return Step::Ended;
    return run.wants_barrier ? Step::AtBarrier : Step::Continue;
}

// The block has ended: what was read of the machine is not known any more if it has commanded
// anything.
inline void end_block(Core& core, BlockRun& run) {
    if (!core.emitted()) return;
    run.fresh = false;
    core.end_block();
}

// The block stops here; it is read again behind a barrier.
inline Step read_again(BlockRun& run) {
    run.reread = true;
    return Step::AtBarrier;
}

// Axes that somebody else has moved are where they are now.
inline void take_machine(Core& core) {
    for (unsigned i = 0; i < core.view().axis_count; ++i)
        if (const auto now = core.port().axis_taken_over(core.view().axes[i].machine_axis))
            core.take_machine(i, *now);
}

// Everything delivered is executed. False: compensation has read on, and the program is ahead of
// this barrier, so nothing is known yet.
inline bool pass_barrier(Core& core, BlockRun& run) {
    if (!core.barrier_passed()) return false;
    run.fresh = true;
    core.refresh_limits();
    take_machine(core);
    return true;
}

inline void finish(Core& core, BlockRun& run, StopReason reason) {
    core.mark_emitted();
    core.sink().stop({reason}, core.at);
    run.ended = true;
}

// The text of the main program has ended without a code that says so. Nothing: what compensation
// still holds cannot be driven, Core::fault().
inline std::optional<Step> end_of_program(Core& core, BlockRun& run) {
    core.begin_block();
    finish(core, run, StopReason::End);
    if (core.reads_ahead() && !core.compensation_failed()) return std::nullopt;
    core.end_block();
    return core.reads_ahead() && core.halted() ? Step::AtBarrier : Step::Ended;
}

// Nothing has been read yet; cycle start is a barrier.
inline void begin_run(BlockRun& run) {
    run.serial = run.tool_serial = 0;
    run.reread = run.wants_barrier = run.jumped = run.called = run.ended = false;
    run.fresh = run.state_changed = true;
}

// Another text goes on in front of the block that would be read next: an interrupt program.
inline void break_in(BlockRun& run) {
    run.tool_serial = 0;
    run.ended = run.reread = false;
    run.fresh = run.state_changed = true;
}

// The next block is `serial`, as if neither it nor anything behind it had been read.
inline void go_back(BlockRun& run, std::uint64_t serial) {
    begin_run(run);
    run.serial = serial - 1;
}

}  // namespace polyturn::channels::engine
