#include "channels/fanuc/program/barriers.hpp"

#include <algorithm>

#include "channels/fanuc/execution.hpp"

namespace polyturn::channels::fanuc {

// Simple synchronous control (F8311) must not begin while the slave's coordinates are shifted
// (fanuc_lathe 10.3).
void check_synchronous_axes(Execution& x) {
    const PathState& path = x.core.path;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i) {
        const unsigned axis = x.core.view().axes[i].machine_axis;
        const bool follows = x.core.port().synchronous_master(axis) != 0 &&
                             params::get(x.core.view().table(), params::f8311, axis + 1) != 0;
        const bool began = follows && !(x.machine.synchronous >> i & 1u);
        x.machine.synchronous = (x.machine.synchronous & ~(1u << i)) | (follows ? 1u << i : 0u);
        const double shifts[] = {path.shift[i], path.vector[i], path.wanted[i], path.preset[i],
                                 path.local[i]};
        if (began &&
            std::any_of(std::begin(shifts), std::end(shifts), [](double by) { return by != 0; }))
            x.reading.barrier_fault =
                Fault{Alarm::SyncShifted, 0, 0.0, 0.0, std::string(x.core.view().axes[i].name),
                      std::nullopt};
    }
}

void barrier_passed(Execution& x) {
    // compensation has read on: the program is ahead of this barrier
    if (!x.core.barrier_passed()) {
        x.reading.inputs_fresh = x.run.reread;
        return;
    }
    x.run.fresh = true;
    x.core.refresh_limits();
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (const auto now = x.core.port().axis_taken_over(x.core.view().axes[i].machine_axis))
            x.core.take_machine(i, *now);
    check_synchronous_axes(x);
}

// A statement waits for a live value. Under compensation it is evaluated as soon as it is read
// (fanuc_lathe 6.13, 3.12): inputs and clocks as they are at the end of the block before the held
// one. Where the axes are is known only when the held block has ended too.
void read_value_barrier(Execution& x) {
    x.run.reread = true;
    x.text.line_left = false;
    if (!x.core.holds_block() || x.reading.inputs_fresh || !x.settings.policy.macro.inputs_ahead)
        return live_value_barrier(x);
    x.core.at.statement = true;
    x.core.barrier_before_held();
    x.core.at.statement = false;
}

// The corner before it stays without its next block.
void live_value_barrier(Execution& x) {
    if (x.core.holds_block())
        x.core.sink().alarm({Alarm::CompCornerCut,
                             {x.files.path(x.calls.frames.back().file), x.core.at.line, 0, 0},
                             {},
                             {}},
                            x.core.at);
    x.core.at.statement = true;  // the block itself is still to come
    x.core.asks_at(x.calls.frames.back().file, x.text.source->position().offset, x.text.column);
    x.core.sink().barrier(x.core.at);
    x.core.at.statement = false;
}

}  // namespace polyturn::channels::fanuc
