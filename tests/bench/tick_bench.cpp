// libs: polyturn_kernel
//
// What a tick costs (issue 2): all axes moving on segments of 0.1 mm, all
// spindles turning, trace off. The other processes are played between the ticks and not counted.
// median_us and p999_us are the figures; the issue allows
//   2 channels, 6 axes: median 3 us          16 channels, 96 axes, 32 spindles: median 60 us,
//                                            99.9th percentile 150 us
// full: the same with all that issue 3 adds, median 80 us: of each channel's six axes three drive
// on the path, the fourth is a PLC axis under way, the fifth follows the second one synchronously,
// the sixth superimposed; pitch, temperature and contour are watched or compensated on all, three
// stroke ranges each, 32 position switches, 16 guarded carriers in one room.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "ipc/model/machine/machine_config.hpp"
#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {
namespace {

// A moment of it is enough where only what acts is judged (tests/bench/run_bench.py).
std::int64_t ticks(std::int64_t whole) {
    return std::getenv("POLYTURN_BENCH_MOMENT") ? whole / 10 : whole;
}

constexpr double kVelocity = 400, kAcceleration = 3000, kJerk = 60'000;

class Load {
public:
    Load(unsigned channels, unsigned axes_each, unsigned spindles, bool full = false)
        : channels_(channels),
          axes_each_(axes_each),
          path_axes_(full ? 3 : axes_each),
          spindles_(spindles) {
        params::Table& t = store_->parameters.draft();
        params::set_defaults(t);
        for (unsigned l = 1; l <= kMaxChannels; ++l)
            params::put(t, params::n0000_machine_group, l <= channels ? 1 : 0, l);
        for (unsigned a = 1; a <= channels * axes_each; ++a) {
            params::put(t, params::n0002_axis_assign, (a - 1) / axes_each + 1, a);
            params::put(t, params::n0304_rapid, kVelocity * 60, a);
            params::put(t, params::n0400_acceleration, kAcceleration, a);
            params::put(t, params::n0401_acc_tc, kAcceleration / kJerk, a);
            params::put(t, params::n0504_position_gain, 40, a);
            params::put(t, params::n0511_feedforward, 1, a);
            params::put(t, params::n0515_feed_forward_control, 3, a);
        }
        for (unsigned s = 1; s <= spindles; ++s) {
            params::put(t, params::n0607_spindle_config, 1, s);
            params::put(t, params::n0650_r1_s_max, 4000, s);
        }
        params::put(t, params::n0005_nc_cycle_time, 1000);
        if (full) ask_for_everything(t);
        store_->parameters.publish();
        supervisor_->options.virtual_time = supervisor_->options.ready = 1;
        machine_ = std::make_unique<Machine>(*kernel_, *supervisor_, *store_);
        if (!store_->parameters.read(machine_->core().table)) std::abort();
        if (full) give_tables_and_room();
        machine_->start();
        machine_->attach_plc(*plc_);
        if (full) set_flags();
        for (unsigned l = 0; l < channels; ++l) {
            segments_.push_back(std::make_unique<ChannelSegment>());
            machine_->attach_channel(l, *segments_[l]);
            machine_->channel(l).select("bench.nc", 0);  // a start that begins nothing is refused
        }
        for (unsigned s = 1; s <= spindles; ++s) {
            machine_->core().signals.force_plc(signals::sp_rot(s), 3);
            machine_->core().spindles[s - 1].demand_speed(1000);
        }
        if (full)  // couplings change at standstill
            for (int i = 0; i < 50; ++i) {
                tick();
                serve();
            }
        for (unsigned l = 0; l < channels; ++l) send(CommandKind::CycleStart, l + 1);
        serve();
        if (!full) return;
        for (int i = 0; i < 50; ++i) {
            tick();
            serve();
        }
        move_plc_axes();
    }

    void tick() { machine_->tick(); }
    // Full rings, heard events, PLC answers.
    void serve() {
        for (unsigned l = 0; l < channels_; ++l) {
            auto& ring = segments_[l]->path;
            while (ring.head.load() - kernel_->path_tail[l].tail.load() < 2048) push(l);
            segments_[l]->event_tail.tail.store(kernel_->events[l].head.load());
            segments_[l]->quiet.store(kernel_->events[l].head.load());
        }
        PlcInputs in;
        if (kernel_->plc_inputs.read(in) && in.cycle != plc_->cycle.load()) {
            plc_->outputs.draft() = plc_->outputs.published();
            plc_->outputs.publish();
            plc_->cycle.store(in.cycle);
        }
        for (auto i = supervisor_->log_tail.tail.load(); i < kernel_->log.head.load(); ++i)
            if (const KernelEvent& e = kernel_->log.slot(i);
                e.kind == static_cast<std::uint32_t>(KernelEventKind::Alarm) && said_.size() < 5)
                said_.push_back(e);
        supervisor_->log_tail.tail.store(kernel_->log.head.load());
    }
    // Axes of paths that move just now, as a part of all of them.
    double moving() const {
        unsigned moved = 0;
        for (unsigned l = 0; l < channels_; ++l)
            for (unsigned i = 0; i < path_axes_; ++i)
                moved += std::fabs(machine_->core().axes[l * axes_each_ + i].velocity()) > 1;
        return static_cast<double>(moved) / (channels_ * path_axes_);
    }

    // Something that is claimed to be measured and does not act; empty: everything does.
    std::string idle_part() const {
        const Core& core = machine_->core();
        const auto part = [](const char* what, char letter, unsigned number) {
            return std::string(what) + " " + letter + std::to_string(number);
        };
        for (unsigned l = 0; l < channels_; ++l) {
            const unsigned a = l * axes_each_;
            if (!machine_->channel(l).path_moves()) return part("no path moves in", 'L', l + 1);
            if (path_axes_ == axes_each_) continue;
            if (!(std::fabs(core.axes[a].compensation()) > 0))
                return part("no compensation of", 'A', a + 1);
            if (!(std::fabs(core.axes[a + 3].velocity()) > 0) ||
                core.signals.nc(signals::an_paxa(a + 4)) == 0)
                return part("the PLC does not move", 'A', a + 4);
            if (core.signals.nc(signals::an_synca(a + 5)) == 0)
                return part("no master leads", 'A', a + 5);
            if (core.signals.nc(signals::an_sprpna(a + 6)) == 0)
                return part("nothing is added to", 'A', a + 6);
        }
        for (unsigned s = 0; s < spindles_; ++s)
            if (std::fabs(core.spindles[s].speed()) < 100) return part("standing:", 'S', s + 1);
        return {};
    }
    std::string alarms() const {
        std::string out;
        for (const KernelEvent& e : said_)
            out += "\n  alarm " + std::to_string(e.code) + " L" + std::to_string(e.channel) + " " +
                   e.text.data();
        return out;
    }

private:
    void ask_for_everything(params::Table& t) {
        for (unsigned a = 1; a <= channels_ * axes_each_; ++a) {
            const unsigned place = (a - 1) % axes_each_;  // in its channel
            params::put(t, params::n0103_axis_to_plane, place == 0 ? 1 : place == 1 ? 3 : 0, a);
            params::put(t, params::n2500_pitch_comp_contr, 1, a);
            params::put(t, params::n2501_primary_interval, 20, a);
            params::put(t, params::n2502_cell_no_of_mach_zero, 10000, a);
            params::put(t, params::n2503_primary_smallest_cell_no, 10000, a);
            params::put(t, params::n2504_primary_largest_cell_no, 10019, a);
            params::put(t, params::pt_temp_slope, 1e-5, a);
            params::put(t, params::pt_temp_zero, -500, a);
            params::put(t, params::n1000_range_enable, 7, a);
            params::put(t, params::n1002_range1a_positive, 2000, a);
            params::put(t, params::n1003_range1a_negative, -2000, a);
            params::put(t, params::n1004_range1b_positive, 2000, a);
            params::put(t, params::n1005_range1b_negative, -2000, a);
            params::put(t, params::n1006_range2_positive, 3100, a);  // forbidden, far away
            params::put(t, params::n1007_range2_negative, 3000, a);
            params::put(t, params::n1008_range3_positive, 3300, a);
            params::put(t, params::n1009_range3_negative, 3200, a);
            if (place == 4) params::put(t, params::n2101_synchronous_master, a - 3, a);
            if (place == 5) params::put(t, params::n2107_superimposed_master, a - 4, a);
        }
        for (unsigned l = 1; l <= channels_; ++l) {
            params::put(t, params::n2000_check_config, 15, l);
            params::put(t, params::pt_contour_tol, 1, l);
        }
        for (unsigned n = 1; n <= 32; ++n) {
            params::put(t, params::nth(params::n1101_sw1_axis_number, n), n * 3);
            params::put(t, params::nth(params::n1133_sw1_min_pos, n), -50);
            params::put(t, params::nth(params::n1165_sw1_max_pos, n), 50);
        }
    }
    void give_tables_and_room() {
        CompensationTables tables;
        tables.measured = true;
        tables.cells.assign(static_cast<std::size_t>(kLastCell - kFirstCell + 1), 0.002f);
        for (std::size_t i = 0; i < 20; ++i)
            tables.cells[i] = static_cast<float>(0.001 + 0.0005 * static_cast<double>(i % 5));
        machine_->take_tables(std::move(tables));
        Room room;
        for (unsigned a = 1; a <= channels_ * axes_each_; ++a) {
            const unsigned place = (a - 1) % axes_each_;
            const double apart = 1000.0 * ((a - 1) / axes_each_);
            room.axes[a] = {place == 0 ? RoomVector{apart, 0, 0} : RoomVector{},
                            place == 0   ? RoomVector{1, 0, 0}
                            : place == 1 ? RoomVector{0, 0, 1}
                                         : RoomVector{0, 1, 0}};
        }
        for (unsigned l = 1; l <= channels_; ++l) room.turrets[l].body = {{-100, 100, -100, 100}};
        machine_->take_room(room, derive_machine_config(machine_->core().table));
    }
    void set_flags() {
        Signals& signals = machine_->core().signals;
        for (unsigned a = 1; a <= channels_ * axes_each_; ++a) {
            const unsigned place = (a - 1) % axes_each_;
            signals.force_plc(signals::ap_temp(a), 500);
            if (place == 4) signals.force_plc(signals::ap_syncr(a), 1);
            if (place == 5) signals.force_plc(signals::ap_sprpnr(a), 1);
        }
    }
    void move_plc_axes() {  // once the programs run: a start wants all axes at rest
        Signals& signals = machine_->core().signals;
        for (unsigned a = 4; a <= channels_ * axes_each_; a += axes_each_) {
            signals.force_plc(signals::ap_paxpos(a), 1'900'000);
            signals.force_plc(signals::ap_paxfeed(a), 2000);
            signals.force_plc(signals::ap_paxr(a), 1);
        }
    }
    void push(unsigned l) {
        auto& ring = segments_[l]->path;
        const auto head = ring.head.load();
        PathRecord& r = ring.slot(head);
        r = {};
        r.kind = static_cast<std::uint8_t>(RecordKind::Line);
        const bool turns = (head + 1) % 1500 == 0;
        r.flags = kBlockBegin | kBlockEnd | (turns ? static_cast<std::uint32_t>(kExactStop) : 0u);
        r.axis_count = static_cast<std::uint8_t>(std::min<unsigned>(path_axes_, kMaxPathAxes));
        const double step = (head / 1500) % 2 ? -0.1 : 0.1;
        for (unsigned i = 0; i < r.axis_count; ++i) {
            r.axis[i] = static_cast<std::uint8_t>(l * axes_each_ + i);
            r.start[i] = at_[l];
            r.end[i] = at_[l] + step;
        }
        at_[l] += step;
        r.length = 0.1 * std::sqrt(r.axis_count);
        // A master of a superimposed axis is no faster than half of what that can do, and a channel
        // knows it.
        const double part = (path_axes_ < axes_each_ ? 2.0 : 1.0) / std::sqrt(r.axis_count);
        r.v_max = kVelocity / part;
        r.a_max = kAcceleration / part;
        r.j_max = kJerk / part;
        r.feed_mode = static_cast<std::uint8_t>(FeedMode::PerMinute);
        r.feed = 100;
        ring.head.store(head + 1);
    }
    void send(CommandKind kind, unsigned l) {
        auto& ring = supervisor_->commands;
        const auto head = ring.head.load();
        ring.slot(head) = {};
        ring.slot(head).kind = static_cast<std::uint32_t>(kind);
        ring.slot(head).channel = l;
        ring.slot(head).seq = head + 1;
        ring.head.store(head + 1);
    }
    unsigned channels_, axes_each_, path_axes_, spindles_;
    std::array<double, kMaxChannels> at_{};
    std::unique_ptr<SupervisorSegment> supervisor_ = std::make_unique<SupervisorSegment>();
    std::unique_ptr<StoreSegment> store_ = std::make_unique<StoreSegment>();
    std::unique_ptr<KernelSegment> kernel_ = std::make_unique<KernelSegment>();
    std::unique_ptr<PlcSegment> plc_ = std::make_unique<PlcSegment>();
    std::vector<std::unique_ptr<ChannelSegment>> segments_;
    std::unique_ptr<Machine> machine_;
    std::vector<KernelEvent> said_;
};

bool all_acted = true;

// Figures of something that does not act mean nothing: none are printed, and the program fails.
void void_figures(benchmark::State& state, const std::string& why) {
    all_acted = false;
    state.SkipWithError(("not everything that is to be measured acts: " + why).c_str());
}

void tick_cost(benchmark::State& state) {
    const bool full = state.range(3) != 0;
    Load load(static_cast<unsigned>(state.range(0)), static_cast<unsigned>(state.range(1)),
              static_cast<unsigned>(state.range(2)), full);
    for (int i = 0; i < 2000; ++i) {
        load.tick();
        load.serve();
    }
    if (const std::string idle = load.idle_part(); !idle.empty())
        return void_figures(state, idle + load.alarms());
    std::vector<double> us;
    double moving = 0;
    for (auto _ : state) {
        const auto began = std::chrono::steady_clock::now();
        load.tick();
        const double took =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        state.SetIterationTime(took);
        us.push_back(took * 1e6);
        moving += load.moving();
        load.serve();
    }
    // Corners are stops: an axis rests now and then, but not for long.
    const double moved = moving / static_cast<double>(us.size());
    if (const std::string idle = load.idle_part(); moved < 0.9 || !idle.empty())
        return void_figures(state, "axes moved in " + std::to_string(moved) + " of the ticks; " +
                                       idle + load.alarms());
    state.counters["moving"] = moved;
    std::sort(us.begin(), us.end());
    state.counters["median_us"] = us[us.size() / 2];
    state.counters["p999_us"] = us[us.size() * 999 / 1000];
    state.counters["worst_us"] = us.back();
}
BENCHMARK(tick_cost)
    ->Args({2, 3, 4, 0})
    ->Args({16, 6, 32, 0})
    ->Args({16, 6, 32, 1})
    ->ArgNames({"channels", "axes_each", "spindles", "full"})
    ->UseManualTime()
    ->Iterations(ticks(30'000))
    ->Unit(benchmark::kMicrosecond);

}  // namespace
bool every_part_acted() { return all_acted; }
}  // namespace polyturn::kernel

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    return polyturn::kernel::every_part_acted() ? 0 : 1;
}
