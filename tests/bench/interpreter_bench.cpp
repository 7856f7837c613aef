// libs: polyturn_channels
//
// Text to elementary moves: plain G1 blocks through reader, scanner, fanuc
// interpreter and core into a sink that keeps nothing. Figures on one core: plain blocks at least 2
// million a second, others beside their functions.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <memory>

#include "channels/check/check_port.hpp"
#include "channels/language.hpp"
#include "tests/unit/channels/quiet_sink.hpp"

namespace {

using namespace polyturn;
using namespace polyturn::channels;

class NullSink final : public testing::QuietSink {
public:
    std::uint64_t moves = 0;
    void move(const Move& m, const BlockContext&) override { moves += m.moved != 0; }
    void alarm(const Diagnosis& d, const BlockContext&) override {
        std::fputs(render(d, Dialect::Fanuc, {}).c_str(), stderr);
    }
};

// A lathe channel X Z, its parameters at their defaults.
std::unique_ptr<params::Table> lathe() {
    auto table = std::make_unique<params::Table>(params::defaults());
    params::put(*table, params::n0000_machine_group, 1, 1);
    params::put(*table, params::n0002_axis_assign, 1, 1);
    params::put(*table, params::n0100_axis_name1, 'X', 1);
    params::put(*table, params::n0103_axis_to_plane, 1, 1);
    params::put(*table, params::n0106_axis_properties, 1, 1);
    params::put(*table, params::n0002_axis_assign, 1, 2);
    params::put(*table, params::n0100_axis_name1, 'Z', 2);
    params::put(*table, params::n0103_axis_to_plane, 3, 2);
    return table;
}

std::string write_program(int blocks) {
    const std::string path =
        (std::filesystem::temp_directory_path() / "polyturn_interpreter_bench.nc").string();
    std::ofstream out(path);
    out << "O1\nG98 G1 X50. Z0 F500\n";
    for (int k = 0; k < blocks; ++k)
        out << "N" << (k % 9000) * 10 + 10 << " G1 X" << 40 + (k % 1000) * 0.01 << " Z-"
            << (k % 777) * 0.125 + 0.5 << "\n";
    out << "M30\n";
    return path;
}

// One program from start to end, as often as the benchmark wants; items: what `count` makes of the
// sink.
template <class Count>
void play(benchmark::State& state, const std::string& path, Count count) {
    const auto table = lathe();
    std::uint64_t items = 0;
    for (auto _ : state) {
        MachineView view = make_machine_view(*table, 1);
        view.store->offsets[1].geometry_r = 0.4;
        NullSink sink;
        const text::Setup setup;
        CheckPort port(setup, 1, true);
        ProgramFiles files;
        auto main = files.open(path);
        auto interpreter = make_fanuc(view, sink, port, files);
        if (!main || !interpreter->start(*main)) return state.SkipWithError("cannot start");
        while (interpreter->step() == Step::Continue) {}
        items += count(sink);
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(items));
    std::filesystem::remove(path);
}

void PlainG1Blocks(benchmark::State& state) {
    play(state, write_program(200'000), [](const NullSink& sink) { return sink.moves; });
}
BENCHMARK(PlainG1Blocks)->Unit(benchmark::kMillisecond);

// A smooth profile with G42. Figure: at least 500 000 blocks a second.
void CompensatedBlocks(benchmark::State& state) {
    const std::string path =
        (std::filesystem::temp_directory_path() / "polyturn_compensated_bench.nc").string();
    std::ofstream out(path);
    // with a point, always: whole numbers count micrometres
    out << std::fixed << std::setprecision(3);
    out << "O1\nG18 G98\nT0101\n#1=0\nN1 G42 G1 X60. Z5. F500\n";
    for (int k = 1; k <= 1000; ++k)
        out << "X" << 60 + 10 * std::sin(k * 0.02) << " Z-" << k * 0.5 << "\n";
    out << "G40 X90.\nG0 Z10.\n#1=#1+1\nIF [#1 LT 100] GOTO 1\nM30\n";
    out.close();
    play(state, path, [](const NullSink& sink) { return sink.moves; });
}
BENCHMARK(CompensatedBlocks)->Unit(benchmark::kMillisecond);

// A loop of three assignments and its condition. Figure: at least 3 million statements a second.
void MacroStatements(benchmark::State& state) {
    constexpr std::uint64_t kRounds = 200'000;
    const std::string path =
        (std::filesystem::temp_directory_path() / "polyturn_macro_bench.nc").string();
    std::ofstream out(path);
    out << "O1\n#1=0\n#2=0\nWHILE [#1 LT " << kRounds
        << "] DO 1\n#2=#2+#1*2\n#3=SQRT[#1]+1\n#1=#1+1\nEND 1\nM30\n";
    out.close();
    play(state, path, [](const NullSink&) { return kRounds * 5; });
}
BENCHMARK(MacroStatements)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
