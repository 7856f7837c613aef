// libs: polyturn_kernel
//
// What protection costs a tick (issue 4): eight turrets that stand around one
// part, twelve stations each with three boxes of its tool, two chucks and a tailstock. All turrets
// move, neighbours pass each other nearer than their braking ways, so that their boxes have to be
// looked at one by one. median_us and p999_us are the figures; the issue allows 20 us.
//   apart=0: as above        apart=1: each turret a metre from the next one, as on most machines
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

#include "ipc/model/machine/machine_config.hpp"
#include "kernel/protection/guard.hpp"
#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {
namespace {

// A moment of it is enough where only what acts is judged (tests/bench/run_bench.py).
std::int64_t ticks(std::int64_t whole) {
    return std::getenv("POLYTURN_BENCH_MOMENT") ? whole / 10 : whole;
}

constexpr unsigned kTurrets = 8, kStations = 12;
// mm: carriers of 120 x 120 mm on a ring of this radius pass each other by some millimetres
constexpr double kRing = 210;

class Lathe {
public:
    explicit Lathe(bool apart) {
        params::Table& t = store_->parameters.draft();
        params::set_defaults(t);
        for (unsigned l = 1; l <= kMaxChannels; ++l)
            params::put(t, params::n0000_machine_group, l <= kTurrets ? 1 : 0, l);
        for (unsigned a = 1; a <= 2 * kTurrets; ++a) {
            params::put(t, params::n0002_axis_assign, (a - 1) / 2 + 1, a);
            params::put(t, params::n0103_axis_to_plane, a % 2 ? 1 : 3, a);
            params::put(t, params::n0304_rapid, 24000, a);
            params::put(t, params::n0400_acceleration, 3000, a);
            params::put(t, params::n0401_acc_tc, 0.05, a);
        }
        for (unsigned l = 1; l <= kTurrets; ++l) params::put(t, params::n2000_check_config, 15, l);
        store_->parameters.publish();
        supervisor_->options.virtual_time = supervisor_->options.ready = 1;
        machine_ = std::make_unique<Machine>(*kernel_, *supervisor_, *store_);
        if (!store_->parameters.read(machine_->core().table)) std::abort();
        machine_->start();
        guard_.take_room(room(apart), derive_machine_config(machine_->core().table));
        guard_.configure(machine_->core().table, machine_->core().config);
        for (unsigned l = 1; l <= kTurrets; ++l)
            machine_->core().signals.set_nc(signals::cn_tcode(l), static_cast<std::int32_t>(l));
    }
    // Every carrier goes round a small circle; the axes' commands are told directly, no channel is
    // needed for it.
    void move() {
        Core& core = machine_->core();
        phase_ += 0.02;
        for (unsigned l = 0; l < kTurrets; ++l) {
            core.axes[2 * l].move_to(8 * std::cos(phase_ + l));
            core.axes[2 * l + 1].move_to(8 * std::sin(phase_ + l));
        }
    }
    Guard::Finding check() { return guard_.step(machine_->core()); }
    void end_of_tick() {
        for (unsigned a = 0; a < 2 * kTurrets; ++a) machine_->core().axes[a].exchange(0.001, true);
    }

private:
    static Room room(bool apart) {
        Room room;
        for (unsigned l = 1; l <= kTurrets; ++l) {
            const double turn = 2 * 3.14159265358979 * (l - 1) / kTurrets;
            const RoomVector at =
                apart ? RoomVector{1000.0 * l, 0, 0}
                      : RoomVector{kRing * std::cos(turn), 0, kRing * std::sin(turn)};
            room.axes[2 * l - 1] = {at, {1, 0, 0}};
            room.axes[2 * l] = {{}, {0, 0, 1}};
            RoomTurret& turret = room.turrets[l];
            turret.body = {{-40, 40, -40, 40}, {-30, 30, -60, 60}};
            // the tools of all stations count
            turret.stations = kStations;
            turret.reach = 100;
            turret.direction = {-1, 0, 0};
            for (unsigned s = 1; s <= kStations; ++s)
                turret.tools[s] = {{-60, -40, -10, 10}, {-55, -40, -25, 5}, {40, 60, -10, 10}};
        }
        room.chucks[1] = {{{0, 0, -700}, {0, 0, 1}}, 250, 200, 60, 0};
        room.chucks[2] = {{{0, 0, 700}, {0, 0, -1}}, 250, 200, 60, 0};
        room.tailstocks[1] = {{{-900, 0, 0}, {0, 0, 1}}, 80, 300};
        return room;
    }
    std::unique_ptr<SupervisorSegment> supervisor_ = std::make_unique<SupervisorSegment>();
    std::unique_ptr<StoreSegment> store_ = std::make_unique<StoreSegment>();
    std::unique_ptr<KernelSegment> kernel_ = std::make_unique<KernelSegment>();
    std::unique_ptr<Machine> machine_;
    Guard guard_;
    double phase_ = 0;
};

void guard_cost(benchmark::State& state) {
    auto lathe = std::make_unique<Lathe>(state.range(0) != 0);
    std::vector<double> us;
    double found = 0;
    for (auto _ : state) {
        lathe->move();
        const auto began = std::chrono::steady_clock::now();
        const Guard::Finding finding = lathe->check();
        const double took =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        state.SetIterationTime(took);
        us.push_back(took * 1e6);
        if (finding.first != Guard::kNone) found += 1;
        lathe->end_of_tick();
    }
    std::sort(us.begin(), us.end());
    state.counters["stops"] = found / static_cast<double>(us.size());
    state.counters["median_us"] = us[us.size() / 2];
    state.counters["p999_us"] = us[us.size() * 999 / 1000];
}
BENCHMARK(guard_cost)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("apart")
    ->UseManualTime()
    ->Iterations(ticks(20'000))
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace polyturn::kernel

BENCHMARK_MAIN();
