// libs: polyturn_channels
// Any text as a sinumerik program: it ends, fails with an alarm, or is stopped after as many blocks as a loop may take. The
// first byte says how often the reader comes back to an earlier block.
#include <cstddef>
#include <cstdint>
#include <memory>

#include "channels/check/check_port.hpp"
#include "channels/check/event_text.hpp"
#include "channels/language.hpp"

namespace {

using namespace polyturn;
using namespace polyturn::channels;

const params::Table& lathe() {
    static const auto table = [] {
        auto t = std::make_unique<params::Table>(params::defaults());
        params::put(*t, params::n0000_machine_group, 1, 1);
        for (const unsigned axis : {1u, 2u, 3u}) params::put(*t, params::n0002_axis_assign, 1, axis);
        params::put(*t, params::n0100_axis_name1, 'X', 1);
        params::put(*t, params::n0103_axis_to_plane, 1, 1);
        params::put(*t, params::n0106_axis_properties, 1, 1);
        params::put(*t, params::n0100_axis_name1, 'Z', 2);
        params::put(*t, params::n0103_axis_to_plane, 3, 2);
        params::put(*t, params::n0100_axis_name1, 'C', 3);
        params::put(*t, params::n0106_axis_properties, 2, 3);
        params::put(*t, params::n0607_spindle_config, 7, 1);
        params::put(*t, params::n0604_default_spindle, 1, 1);
        return t;
    }();
    return *table;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    MachineView view = make_machine_view(lathe(), 1);
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    ProgramFiles files;
    std::string events;
    EventSink sink({&view, &files, Dialect::Sinumerik}, events, true, '\n');
    const text::Setup setup;
    CheckPort port(setup, 1, true);
    const auto main = files.open_text(text, "fuzz");
    if (!main) return 0;
    const auto interpreter = make_sinumerik(view, sink, port, files);
    interpreter->keep_resume_states(data[0] != 0);
    interpreter->preset_tool(1, "A");
    interpreter->preset_edge(1, 1, "DP1", 500);
    interpreter->preset_edge(1, 1, "DP6", 0.8);
    (void)interpreter->start(*main).ok();
    for (int steps = 1; steps < 2000; ++steps) {
        const Step step = interpreter->step();
        if (step == Step::AtBarrier) interpreter->barrier_done();
        else if (step != Step::Continue) break;
        if (data[0] && steps % data[0] == 0 && interpreter->core().at.serial > 2) (void)interpreter->resume_at(interpreter->core().at.serial - 1);
        if (events.size() > 1u << 20) events.clear();
    }
    return 0;
}
