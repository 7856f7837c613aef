// Interprets a text as check mode does and gives its events back, line by line.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "channels/check/check_port.hpp"
#include "channels/check/event_text.hpp"
#include "channels/language.hpp"
#include "channels/preset.hpp"
#include "ipc/params/param_file.hpp"

namespace polyturn::channels::testing {

struct Play {
    // parameter lines on top of a lathe channel X Z C with spindle S1
    std::vector<std::string> sets;
    std::string language = "fanuc";
    text::ChannelSetup setup;
    bool alone = true;
    bool variables = true;
};

struct Played {
    std::string events;  // JSON lines
    unsigned errors = 0;
    std::vector<std::string> lines() const {
        std::vector<std::string> out;
        for (std::size_t from = 0; from < events.size();) {
            const std::size_t end = events.find('\n', from);
            out.push_back(events.substr(from, end - from));
            from = end + 1;
        }
        return out;
    }
    // The first line that holds all of `parts`; empty when there is none.
    std::string find(const std::vector<std::string>& parts) const {
        for (const std::string& line : lines()) {
            bool all = true;
            for (const std::string& part : parts) all = all && line.find(part) != std::string::npos;
            if (all) return line;
        }
        return {};
    }
    bool has(const std::vector<std::string>& parts) const { return !find(parts).empty(); }
};

inline std::unique_ptr<params::Table> lathe(const std::vector<std::string>& more) {
    static const char* const kMachine[] = {
        "N0000 L1=1",  "N0000 L2=1",  "N0604 L1=1",  "N0604 L2=1", "N0607 S1=7",    "N1300 L1=2",
        "N1301 L1=65", "N0002 A1=1",  "N0100 A1=88", "N0103 A1=1", "N0106 A1=1",    "N0305 A1=8000",
        "N0002 A2=1",  "N0100 A2=90", "N0103 A2=3",  "N0106 A2=0", "N0305 A2=8000", "N0002 A5=1",
        "N0100 A5=67", "N0103 A5=0",  "N0106 A5=2",  "N0002 A3=2", "N0100 A3=88",   "N0103 A3=1",
        "N0106 A3=1",  "N0002 A4=2",  "N0100 A4=90", "N0103 A4=3", "N0687 L1=1",    "N1400 L1=32",
        "N2201=500",   "N2202=599"};
    auto table = std::make_unique<params::Table>(params::defaults());
    const auto put = [&](const std::string& line) {
        auto parsed = params::parse_assignment(line);
        if (!parsed) throw std::runtime_error(line + ": " + parsed.diagnosis().text());
        if (auto done = params::apply(*table, std::span(&*parsed, 1)); !done)
            throw std::runtime_error(done.diagnosis().text());
    };
    for (const char* line : kMachine) put(line);
    for (const std::string& line : more) put(line);
    return table;
}

// Until it ends or stands in an alarm; nobody has to be waited for at a barrier.
inline void run_to_end(Language& language) {
    for (int steps = 0; steps < 100'000; ++steps) {
        const Step step = language.step();
        if (step == Step::AtBarrier)
            language.barrier_done();
        else if (step != Step::Continue)
            return;
    }
}

// `prepare` may enter offsets and zeros into the store and see the start point.
template <class Prepare>
Played play(std::string_view program, const Play& how, Prepare&& prepare) {
    const auto table = lathe(how.sets);
    MachineView view = make_machine_view(*table, 1);
    prepare(view);
    text::Setup setup;
    setup.channels[1] = how.setup;
    ProgramFiles files;
    for (const std::string& path : how.setup.subprograms) files.add_library(path);
    Played played;
    const Dialect dialect = dialect_of(how.language);
    EventSink sink({&view, &files, dialect}, played.events, how.variables, '\n');
    CheckPort port(setup, 1, how.alone);
    const auto main = files.open_text(program, "test.nc");
    if (!main) {
        append_event(played.events, {&view, nullptr, dialect}, main.diagnosis(), BlockContext{});
        played.events += '\n';
        played.errors = 1;
        return played;
    }
    const auto interpreter = make_language(how.language, view, sink, port, files);
    (void)interpreter->start(*main).ok();
    interpreter->core().start_at_machine(view.start);
    preset(*interpreter, how.setup);
    run_to_end(*interpreter);
    played.errors = sink.errors();
    return played;
}

inline Played play(std::string_view program, const Play& how = {}) {
    return play(program, how, [](MachineView&) {});
}

}  // namespace polyturn::channels::testing
