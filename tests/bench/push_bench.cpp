// libs: polyturn_channel_process
//
// Program text to records in the ring (issue 2: at least 500 000 blocks/s on one core): language,
// machine state, blends, ceilings, ring. The kernel's part, taking the records, is played by moving
// the tail.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "channels/language.hpp"
#include "channels/process/run_port.hpp"
#include "channels/records/record_sink.hpp"
#include "ipc/model/machine/load_machine.hpp"

namespace polyturn::channels {
namespace {

constexpr int kBlocks = 200'000;

std::string straight_blocks() {
    std::string text = "G21 G98\n";
    char line[64];
    for (int n = 0; n < kBlocks; ++n) {
        std::snprintf(line, sizeof line, "N%d G1 X%.3f Z%.3f F500.\n", n + 1, 60.0 + (n % 7),
                      -0.001 * n);
        text += line;
    }
    return text;
}

// Short pieces along a smooth curve, as a CAM system writes them.
std::string curve_blocks() {
    std::string text = "G21 G98 F3000.\nG1";
    char line[64];
    for (int n = 0; n < kBlocks; ++n) {
        const double angle = n * 0.002;
        std::snprintf(line, sizeof line, "X%.4f Z%.4f\n", 100 + 100 * std::cos(angle),
                      50 * std::sin(angle) - 60);
        text += line;
    }
    return text;
}

void push(benchmark::State& state, const std::string& text) {
    auto own = std::make_unique<ChannelSegment>();
    auto kernel = std::make_unique<KernelSegment>();
    const LoadedMachine machine = load_machine_file({});
    MachineView view = make_machine_view(*machine.table, 1);
    RunPort port(*kernel, 1);
    port.configure(view.machine, nullptr);
    EventInbox inbox(*kernel, 0, *own);
    PathLimits limits = path_limits(view.machine, view.table(), 1);
    RingOut ring(*own, *kernel, 0, 1024, inbox);
    double blocks = 0;
    for (auto _ : state) {
        PathMaker maker(ring, limits);
        RecordSink sink(view, maker, ring, nullptr, nullptr, {});
        ProgramFiles files;
        const auto main = files.open_text(text, "bench");
        const auto language = make_language("fanuc", view, sink, port, files);
        if (!main || !language->start(*main)) {
            state.SkipWithError("the program cannot be started");
            return;
        }
        Step step = Step::Continue;
        for (int n = 0; step == Step::Continue; ++n) {
            step = language->step();
            if (n % 256 == 0)
                kernel->path_tail[0].tail.store(ring.pushed(), std::memory_order_release);
        }
        if (step == Step::Failed) {
            state.SkipWithError("the program has an alarm");
            return;
        }
        kernel->path_tail[0].tail.store(ring.pushed(), std::memory_order_release);
        blocks += kBlocks;
    }
    state.counters["blocks"] = benchmark::Counter(blocks, benchmark::Counter::kIsRate);
    state.counters["records/block"] = static_cast<double>(ring.pushed()) / blocks;
}

void BM_StraightBlocks(benchmark::State& state) { push(state, straight_blocks()); }
void BM_ShortPiecesOfACurve(benchmark::State& state) { push(state, curve_blocks()); }
BENCHMARK(BM_StraightBlocks)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ShortPiecesOfACurve)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace polyturn::channels

BENCHMARK_MAIN();
