// Any text as a program of a language, on a small lathe with X, Z and C: it ends, fails with an
// alarm, or is stopped after as many blocks as a loop may take; every event it causes can be
// written, and earlier blocks can be gone back to.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "channels/check/check_port.hpp"
#include "channels/check/event_text.hpp"
#include "channels/language.hpp"

namespace polyturn::channels::fuzz {

// `more` sets what only this language reads.
template <class More>
std::unique_ptr<params::Table> lathe(More more) {
    auto table = std::make_unique<params::Table>(params::defaults());
    params::Table& t = *table;
    params::put(t, params::n0000_machine_group, 1, 1);
    for (const unsigned axis : {1u, 2u, 3u}) params::put(t, params::n0002_axis_assign, 1, axis);
    params::put(t, params::n0100_axis_name1, 'X', 1);
    params::put(t, params::n0103_axis_to_plane, 1, 1);
    params::put(t, params::n0106_axis_properties, 1, 1);
    params::put(t, params::n0100_axis_name1, 'Z', 2);
    params::put(t, params::n0103_axis_to_plane, 3, 2);
    params::put(t, params::n0100_axis_name1, 'C', 3);
    params::put(t, params::n0106_axis_properties, 2, 3);
    params::put(t, params::n0107_rollover_control, 3, 3);
    params::put(t, params::n0108_rollamount, 360, 3);
    params::put(t, params::n0607_spindle_config, 7, 1);
    params::put(t, params::n0604_default_spindle, 1, 1);
    more(t);
    return table;
}

struct How {
    Dialect dialect;
    bool live_values;     // answers of the port that only a machine could give
    unsigned back_every;  // after so many steps back by one block; 0: never
};

// make(view, sink, port, files) yields the interpreter; prepare(interpreter) enters what an
// operator would have.
template <class Make, class Prepare>
void play(std::string_view text, const params::Table& table, const How& how, Make make,
          Prepare prepare) {
    MachineView view = make_machine_view(table, 1);
    view.store->offsets[1].geometry_r = 0.8;
    view.store->offsets[1].tip = 3;
    ProgramFiles files;
    std::string events;
    EventSink sink({&view, &files, how.dialect}, events, true, '\n');
    const text::Setup setup;
    CheckPort port(setup, 1, how.live_values);
    const auto main = files.open_text(text, "fuzz");
    if (!main) return;
    const auto interpreter = make(view, sink, port, files);
    interpreter->keep_resume_states(how.back_every != 0);
    prepare(*interpreter);
    (void)interpreter->start(*main).ok();
    for (unsigned steps = 1; steps < 2000; ++steps) {
        const Step step = interpreter->step();
        if (step == Step::AtBarrier)
            interpreter->barrier_done();
        else if (step != Step::Continue)
            break;
        if (how.back_every && steps % how.back_every == 0 && interpreter->core().at.serial > 2)
            (void)interpreter->resume_at(interpreter->core().at.serial - 1);
        if (events.size() > 1u << 20) events.clear();
    }
}

inline std::string_view behind_first(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data) + 1, size - 1};
}

}  // namespace polyturn::channels::fuzz
