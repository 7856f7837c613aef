#include "channels/fanuc/program/start.hpp"

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/motion/modes.hpp"
#include "channels/fanuc/program/inherited.hpp"

namespace polyturn::channels::fanuc {

// The state of cycle start: what the parameters say, else the rows marked at_reset.
void clear_modal(Execution& x) {
    x.modal.active.fill(nullptr);
    for (const GCode& row : g_codes())
        if ((row.systems & x.settings.system) && row.at_reset) x.modal.in_force(row.group) = &row;
    const auto choose = [&x](std::uint16_t tenths) {
        const GCode* row = x.vocabulary.table.find(tenths);
        // mefi knows millimetres only
        if (row) x.modal.in_force(row->group) = row;
        return row;
    };
    x.modal.motion = choose(x.settings.power_on_g1 ? 10 : 0);
    static constexpr std::uint16_t kPlanes[] = {170, 180, 190};
    choose(kPlanes[x.settings.power_on_plane]);
    x.core.path.plane = static_cast<Plane>(x.settings.power_on_plane);
    x.modal.input.inch = x.settings.power_on_inch;
    choose(units_code(x, x.modal.input.inch));
    x.modal.input.unit = x.modal.input.inch ? 25.4 : 1.0;
    x.modal.input.absolute = x.settings.system == kA || !x.settings.power_on_incremental;
    if (x.settings.system != kA) choose(x.modal.input.absolute ? 900 : 910);
    if (x.settings.power_on_length) choose(x.settings.power_on_length);
    x.core.helix_in_plane(x.settings.helix_in_plane);
    // feed per revolution waits for a spindle that the PLC may start; the kernel reports if none
    // turns
    x.core.wait_for_spindle(true);
    const bool per_revolution = x.settings.power_on_per_revolution;
    if (x.settings.system == kA)
        choose(per_revolution ? 990 : 980);
    else
        choose(per_revolution ? 950 : 940);
    x.core.path.feed_mode = per_revolution ? FeedMode::PerRevolution : FeedMode::PerMinute;
    x.core.path.feed = per_revolution ? x.settings.feed_per_revolution : x.settings.feed_per_minute;
    x.core.path.exact_stop_mode = x.core.path.override_locked = x.core.path.exact_stop_off =
        x.core.path.stroke2_off = false;
    x.modal.control.single_block_off = x.modal.control.no_finish_wait = x.calls.hidden = false;
    x.modal.control.automatic = 0;
    if (x.core.path.spindle.surface_m_min == 0)
        x.core.path.spindle.surface_m_min = x.settings.surface_speed;
    x.modal.parameter_input = false;
    x.modal.life = {};
    x.calls.modal.clear();
}

void start_program(Execution& x, FileId main) {
    x.core.begin_control();
    x.core.compensation_reset();
    x.core.fixture_off();
    x.core.compensation_options(x.settings.compensation);
    x.core.shows = {x.settings.shows_tool_vector, x.settings.shows_nose};
    clear_modal(x);
    x.calls.frames.clear();
    x.calls.loops.clear();
    while (x.macro.variables.depth() > 1) x.macro.variables.pop_locals();
    CallLevel frame;
    frame.file = main;
    x.calls.frames.push_back(std::move(frame));
    x.text.source = &x.files.source(main);
    x.text.source->seek({0, 1});
    x.text.line_left = x.modal.program.tape_begun = x.modal.program.blocks_begun = x.run.ended =
        x.text.ended_by_code = x.run.reread = x.text.points_judged = false;
    x.run.tool_serial = x.macro.written.serial = 0;
    x.run.fresh = true;  // cycle start is a barrier
    // Without a machine only the program can have closed a spindle's loop.
    x.machine.turned.fill({x.core.port().axis_command(x.core.view().axes[0].machine_axis)
                               ? SpindleLoop::Unknown
                               : SpindleLoop::Open,
                           0.0});
    x.modal.program.number = 0;
    // As they are switched: by hand in a hold, or behind a process that died, another one has
    // written them.
    x.macro.system.outputs =
        static_cast<std::uint32_t>(static_cast<std::int64_t>(x.core.port().interface_value(1132)));
    x.macro.system.outputs_wide = x.core.port().interface_value(1133);
    x.awaited.measuring = {};
    x.reading.barrier_fault.reset();
    x.machine.synchronous = 0;
    x.awaited.remote.active = x.awaited.external.active = false;
    x.awaited.remote.from.close();
    x.modal.cycles.finishing = {};
    x.modal.cycles.data = {};
    x.modal.interrupting = {};
    x.way_back.interruption = {};
    x.way_back.interrupted.reset();
    x.run.serial = 0;
    x.way_back.points.clear();
    x.macro.variables.undo().clear();
    x.run.state_changed = true;
    x.machine.polygon_on = x.machine.balance_on = false;  // a reset has ended them
    x.macro.dialogue = {};
    x.core.refresh_limits();
    if (x.settings.policy.program.starts_with_zero)
        x.core.path.zero_row = x.settings.priority_zero_row;
    x.core.load_zeros();
    if (x.settings.policy.program.recalls && !x.reading.contour) recall_kept(x);
}

}  // namespace polyturn::channels::fanuc
