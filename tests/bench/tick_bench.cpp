// libs: polyturn_kernel
// What a tick costs (issue 2): all axes moving on segments of 0.1 mm, all spindles turning, trace off. The other processes
// are played between the ticks and not counted. median_us and p999_us are the figures; the issue allows
//   2 channels, 6 axes: median 3 us          16 channels, 96 axes, 32 spindles: median 60 us, 99.9th percentile 150 us
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <vector>

#include "kernel/cyclic/machine.hpp"

namespace polyturn::kernel {
namespace {

constexpr double kVelocity = 400, kAcceleration = 3000, kJerk = 60'000;

class Load {
public:
    Load(unsigned channels, unsigned axes_each, unsigned spindles) : channels_(channels), axes_each_(axes_each), spindles_(spindles) {
        params::Table& t = store_->parameters.draft();
        params::set_defaults(t);
        for (unsigned l = 1; l <= kMaxChannels; ++l) params::put(t, params::n0000_machine_group, l <= channels ? 1 : 0, l);
        for (unsigned a = 1; a <= channels * axes_each; ++a) {
            params::put(t, params::n0002_axis_assign, (a - 1) / axes_each + 1, a);
            params::put(t, params::n0304_rapid, kVelocity * 60, a);
            params::put(t, params::n0400_acceleration, kAcceleration, a);
            params::put(t, params::n0401_acc_tc, kAcceleration / kJerk, a);
            params::put(t, params::n0504_position_gain, 40, a);
            params::put(t, params::n0511_feedforward, 1, a);
            params::put(t, params::n0515_feed_forward_control, 3, a);
        }
        for (unsigned s = 1; s <= spindles; ++s) params::put(t, params::n0607_spindle_config, 1, s), params::put(t, params::n0650_r1_s_max, 4000, s);
        params::put(t, params::n0005_nc_cycle_time, 1000);
        store_->parameters.publish();
        supervisor_->options.virtual_time = supervisor_->options.ready = 1;
        machine_ = std::make_unique<Machine>(*kernel_, *supervisor_, *store_);
        if (!store_->parameters.read(machine_->core().table)) std::abort();
        machine_->start();
        machine_->attach_plc(*plc_);
        for (unsigned l = 0; l < channels; ++l) {
            segments_.push_back(std::make_unique<ChannelSegment>());
            machine_->attach_channel(l, *segments_[l]);
        }
        for (unsigned s = 1; s <= spindles; ++s) {
            machine_->core().signals.force_plc(signals::sp_rot(s), 3);
            machine_->core().spindles[s - 1].demand_speed(1000);
        }
        for (unsigned l = 0; l < channels; ++l) send(CommandKind::CycleStart, l + 1);
        serve();
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
        supervisor_->log_tail.tail.store(kernel_->log.head.load());
    }
    bool moving() const { return std::fabs(machine_->core().axes[0].velocity()) > 1; }

private:
    void push(unsigned l) {
        auto& ring = segments_[l]->path;
        const auto head = ring.head.load();
        PathRecord& r = ring.slot(head);
        r = {};
        r.kind = static_cast<std::uint8_t>(RecordKind::Line);
        const bool turns = (head + 1) % 1500 == 0;
        r.flags = kBlockBegin | kBlockEnd | (turns ? static_cast<std::uint32_t>(kExactStop) : 0u);
        r.axis_count = static_cast<std::uint8_t>(std::min<unsigned>(axes_each_, kMaxPathAxes));
        const double step = (head / 1500) % 2 ? -0.1 : 0.1;
        for (unsigned i = 0; i < r.axis_count; ++i) {
            r.axis[i] = static_cast<std::uint8_t>(l * axes_each_ + i);
            r.start[i] = at_[l];
            r.end[i] = at_[l] + step;
        }
        at_[l] += step;
        r.length = 0.1 * std::sqrt(r.axis_count);
        const double part = 1 / std::sqrt(r.axis_count);
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
    unsigned channels_, axes_each_, spindles_;
    std::array<double, kMaxChannels> at_{};
    std::unique_ptr<SupervisorSegment> supervisor_ = std::make_unique<SupervisorSegment>();
    std::unique_ptr<StoreSegment> store_ = std::make_unique<StoreSegment>();
    std::unique_ptr<KernelSegment> kernel_ = std::make_unique<KernelSegment>();
    std::unique_ptr<PlcSegment> plc_ = std::make_unique<PlcSegment>();
    std::vector<std::unique_ptr<ChannelSegment>> segments_;
    std::unique_ptr<Machine> machine_;
};

void tick_cost(benchmark::State& state) {
    Load load(static_cast<unsigned>(state.range(0)), static_cast<unsigned>(state.range(1)), static_cast<unsigned>(state.range(2)));
    for (int i = 0; i < 2000; ++i) load.tick(), load.serve();
    std::vector<double> us;
    double moving = 0;
    for (auto _ : state) {
        const auto began = std::chrono::steady_clock::now();
        load.tick();
        const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        state.SetIterationTime(took);
        us.push_back(took * 1e6);
        moving += load.moving();
        load.serve();
    }
    state.counters["moving"] = moving / static_cast<double>(us.size());
    std::sort(us.begin(), us.end());
    state.counters["median_us"] = us[us.size() / 2];
    state.counters["p999_us"] = us[us.size() * 999 / 1000];
}
BENCHMARK(tick_cost)->Args({2, 3, 4})->Args({16, 6, 32})->ArgNames({"channels", "axes_each", "spindles"})->UseManualTime()->Iterations(30'000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace polyturn::kernel

BENCHMARK_MAIN();
