// A channel: its parts, each with data of its own (kernel/channel/parts), and what all of its units
// say and ask. The units are functions by topic (kernel/channel/path, kernel/channel/program,
// kernel/records); the order of a tick is ChannelRunner's.
//
// Writers: a part is changed by its own functions, by the unit that bears its name, and by the two
// places where a program ends or is taken back: finish_reset() and discard_ahead().
#pragma once
#include <cstdint>
#include <string_view>

#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/kinematics/kinematics.hpp"
#include "ipc/model/languages/language_traits.hpp"
#include "kernel/by_hand/positioning_program.hpp"
#include "kernel/channel/parts/block_shown.hpp"
#include "kernel/channel/parts/channel_path.hpp"
#include "kernel/channel/parts/hand_blocks.hpp"
#include "kernel/channel/parts/interrupt_watch.hpp"
#include "kernel/channel/parts/operator_panel.hpp"
#include "kernel/channel/parts/outbox.hpp"
#include "kernel/channel/parts/path_axes.hpp"
#include "kernel/channel/parts/process_link.hpp"
#include "kernel/channel/parts/production.hpp"
#include "kernel/channel/parts/program_state.hpp"
#include "kernel/channel/parts/restart_stage.hpp"
#include "kernel/channel/parts/resume.hpp"
#include "kernel/channel/parts/retrace.hpp"
#include "kernel/channel/parts/standing_record.hpp"
#include "kernel/channel/parts/thread_executor.hpp"
#include "kernel/tick/core.hpp"

namespace polyturn::kernel {

struct Channel {
    Channel(Core& machine, unsigned from_0) : core(machine), index(from_0), number(from_0 + 1) {}

    Core& core;
    const unsigned index;        // from 0
    const std::uint32_t number;  // from 1
    ProcessLink process;
    ProgramState program;
    OperatorPanel panel;
    ChannelPath path;
    PathAxes axes;
    BlockShown shown;
    StandingRecord standing;
    ThreadExecutor thread;
    PositioningProgram positioning;
    InterruptWatch interrupts;
    Retrace retrace;
    Resume resume;
    HandBlocks hand;
    RestartStage restart;
    Production production;
    Outbox outbox;

    const PathRecord& record(std::uint64_t i) const noexcept { return path.inbox.record(i); }
    // The transformation that leads from the record's coordinates to its axes; none: they are its
    // axes.
    const Kinematics* kinematics_of(const PathRecord& r) const noexcept {
        return path.inbox.kinematics(r.transform);
    }
    bool at_rest() const noexcept {
        return path.planner->at_rest() && !thread.moving() && retrace.trail.at_rest() &&
               !axes.off_path.any();
    }
    // The language of what runs: of the selected program, where its job says one; a block by hand
    // is in that of the machine.
    Dialect speaks() const noexcept;
    const LanguageTraits& traits() const noexcept { return traits_of(speaks()); }
    double feed_factor() const noexcept;  // the effective feed override

    // The program stands, and this is why.
    void stand(ChannelState state, StopReason reason) noexcept;
    // Interrupts the program: the path brakes, and only a reset leads out. The first alarm is the
    // cause, what follows is not reported.
    void raise(Alarm alarm, std::string_view detail = {}, double value = 0) noexcept;
    void tell(ChannelEventKind kind, std::uint64_t record, double value = 0,
              std::string_view text = {}) noexcept;
    // Event of a record that has a note.
    void report(KernelEventKind kind, const PathRecord& r, double offset_s) noexcept;
};

}  // namespace polyturn::kernel
