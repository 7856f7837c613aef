#include "channels/fagor/execution.hpp"

#include <utility>

#include "channels/fagor/flow/start_end.hpp"

namespace polyturn::channels::fagor {

Execution::Execution(MachineView& view, Sink& sink, Port& port, ProgramFiles& program_files)
    : out(sink),
      core(view, out.ways, port),
      settings(read_settings(view.table(), view.channel)),
      places(view),
      programs{program_files, {}, {}, {}, {}, {}, {}},
      calls(program_files),
      parsers(*this) {
    // a tool's own offset until TLFD says otherwise
    for (std::size_t n = 0; n < kTools; ++n)
        values.tool(ToolField::Offset, n) = static_cast<double>(n);
    // G95 waits for a spindle that the PLC may start; the kernel reports if none turns
    core.wait_for_spindle(true);
    modal.diameter =
        core.view().axis_by_role(PlaneRole::BasicX) >= 0 &&
        view.axes[static_cast<std::size_t>(view.axis_by_role(PlaneRole::BasicX))].diameter;
    core.await_factors();
    clear_modal(*this);
    core.path.zero_row = kZeroNone;
}

bool Execution::fail(Alarm alarm, char letter, std::string detail, double v0, double v1) {
    return core.fail(alarm, letter, std::move(detail), v0, v1);
}

bool Execution::fail_word(const Word& word, Alarm alarm, std::string detail, double v0, double v1) {
    line.fault.column = word.column;
    line.fault.length = word.length;
    return core.fail(alarm, 0, std::move(detail), v0, v1);
}

}  // namespace polyturn::channels::fagor
