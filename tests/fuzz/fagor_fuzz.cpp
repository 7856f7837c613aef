// libs: polyturn_channels
// Any text as a fagor program: it ends, fails with an alarm, or is stopped after as many blocks as a loop may take; every
// event it causes can be written, and every block can be gone back to.
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
        params::put(*t, params::n0107_rollover_control, 3, 3);
        params::put(*t, params::n0108_rollamount, 360, 3);
        params::put(*t, params::n0607_spindle_config, 7, 1);
        params::put(*t, params::n0604_default_spindle, 1, 1);
        params::put(*t, params::fg_m19type, 1, 1);
        params::put(*t, params::fg_angaxna, 1, 1);
        params::put(*t, params::fg_ortaxna, 3, 1);
        params::put(*t, params::fg_angantr, 30, 1);
        return t;
    }();
    return *table;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    MachineView view = make_machine_view(lathe(), 1);
    view.store->offsets[1].geometry_r = 0.8;
    view.store->offsets[1].tip = 3;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    ProgramFiles files;
    std::string events;
    EventSink sink({&view, &files, Dialect::Fagor}, events, true, '\n');
    const text::Setup setup;
    CheckPort port(setup, 1, data[0] & 2);
    const auto main = files.open_text(text, "fuzz");
    if (!main) return 0;
    const auto interpreter = make_fagor(view, sink, port, files);
    interpreter->keep_resume_states(data[0] & 1);
    (void)interpreter->start(*main).ok();
    for (int steps = 0; steps < 1000; ++steps) {
        const Step step = interpreter->step();
        if (step == Step::AtBarrier) interpreter->barrier_done();
        else if (step != Step::Continue) break;
        if (data[0] & 1 && steps == 200) (void)interpreter->resume_at(data[0] >> 2);
        if (events.size() > 1u << 20) events.clear();
    }
    return 0;
}
