// libs: polyturn_channels
// Text to elementary moves: plain G1 blocks through reader, scanner, fanuc interpreter and core into a sink that keeps
// nothing. Figure: at least 2 million blocks a second on one core.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

#include "channels/check/check_port.hpp"
#include "channels/language.hpp"

namespace {

using namespace polyturn;
using namespace polyturn::channels;

class NullSink final : public Sink {
public:
    std::uint64_t moves = 0;
    void move(const Move& m, const BlockContext&) override { moves += m.moved != 0; }
    void dwell(const Dwell&, const BlockContext&) override {}
    void aux(const Aux&, const BlockContext&) override {}
    void spindle(const Spindle&, const BlockContext&) override {}
    void wait(const Wait&, const BlockContext&) override {}
    void variable(const Variable&, const BlockContext&) override {}
    void offset(const OffsetWrite&, const BlockContext&) override {}
    void message(std::string_view, const BlockContext&) override {}
    void stop(const Stop&, const BlockContext&) override {}
    void part(double, const BlockContext&) override {}
    void alarm(const Diagnosis& d, const BlockContext&) override { std::fputs(render(d, Dialect::Fanuc, {}).c_str(), stderr); }
    void barrier(const BlockContext&) override {}
    void block_end(const BlockContext&) override {}
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
    const std::string path = (std::filesystem::temp_directory_path() / "polyturn_interpreter_bench.nc").string();
    std::ofstream out(path);
    out << "O1\nG98 G1 X50. Z0 F500\n";
    for (int k = 0; k < blocks; ++k) out << "N" << (k % 9000) * 10 + 10 << " G1 X" << 40 + (k % 1000) * 0.01 << " Z-" << (k % 777) * 0.125 + 0.5 << "\n";
    out << "M30\n";
    return path;
}

void PlainG1Blocks(benchmark::State& state) {
    constexpr int kBlocks = 200'000;
    const std::string path = write_program(kBlocks);
    const auto table = lathe();
    std::uint64_t blocks = 0;
    for (auto _ : state) {
        MachineView view = make_machine_view(*table, 1);
        NullSink sink;
        const text::Setup setup;
        CheckPort port(setup, 1, true);
        ProgramFiles files;
        auto main = files.open(path);
        auto interpreter = make_fanuc(view, sink, port, files);
        if (!main || !interpreter->start(*main)) return state.SkipWithError("cannot start");
        while (interpreter->step() == Step::Continue) {}
        blocks += sink.moves;
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(blocks));
    std::filesystem::remove(path);
}
BENCHMARK(PlainG1Blocks)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
