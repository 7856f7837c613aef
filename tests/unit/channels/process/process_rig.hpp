// Supervisor, store and kernel played by the test in one thread with the real channel process:
// events in, records out.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <functional>
#include <thread>
#include <vector>

#include "channels/process/channel_process.hpp"

namespace polyturn::channels::rig {

// A program made of calls. Each step is one function; what it returns is the step's result.
class ScriptedRun : public ProgramRun {
public:
    using Line = std::function<Step(Sink&, const MachineView&, Port&)>;
    ScriptedRun(const MachineView& view, Sink& sink, Port& port, const std::vector<Line>& lines)
        : view_(view), sink_(sink), port_(port), lines_(lines) {}
    Result<void> start() override { return {}; }
    Step step() override {
        return next_ < lines_.size() ? lines_[next_++](sink_, view_, port_) : Step::Ended;
    }
    void barrier_done() override { ++barriers; }
    std::size_t file_count() const override { return 1; }
    std::string file_name(std::size_t) const override { return "O0001.nc"; }
    int barriers = 0;

private:
    const MachineView& view_;
    Sink& sink_;
    Port& port_;
    const std::vector<Line>& lines_;
    std::size_t next_ = 0;
};

class ProcessRig {
public:
    std::vector<ScriptedRun::Line> program;
    std::string instance = "test-process-" + std::to_string(::getpid());
    OwnSegment<SupervisorSegment> supervisor;
    OwnSegment<StoreSegment> store;
    OwnSegment<KernelSegment> kernel;
    std::unique_ptr<ChannelProcess> process;
    PeerSegment<ChannelSegment> channel;
    std::vector<PathRecord> taken;
    std::uint64_t event = 0;

    ProcessRig() {
        supervisor = std::move(*OwnSegment<SupervisorSegment>::create(instance, 1));
        store = std::move(*OwnSegment<StoreSegment>::create(instance, 1));
        kernel = std::move(*OwnSegment<KernelSegment>::create(instance, 1));
        auto table = std::make_unique<params::Table>();
        params::set_defaults(*table);
        params::put(*table, params::n0000_machine_group, 1, 1);
        params::put(*table, params::n0002_axis_assign, 1, 1);
        params::put(*table, params::n0100_axis_name1, 'X', 1);
        params::put(*table, params::n0103_axis_to_plane, 1, 1);
        params::put(*table, params::n0002_axis_assign, 1, 2);
        params::put(*table, params::n0100_axis_name1, 'Z', 2);
        params::put(*table, params::n0103_axis_to_plane, 3, 2);
        store->parameters.write(*table);
        supervisor.publish();
        store.publish();
        kernel.publish();
        start_process();
    }
    ~ProcessRig() { remove_instance(instance); }

    // Again: the process has died, a successor starts; what the kernel does when it attaches to it.
    void start_process() {
        process.reset();
        kernel->path_tail[0].tail.store(0);
        ProcessServices services;
        services.make_run = [this](MachineView& view, Sink& sink, Port& port,
                                   const ProgramChoice&) {
            return std::make_unique<ScriptedRun>(view, sink, port, program);
        };
        process = std::move(*ChannelProcess::create(instance, 1, std::move(services)));
        channel = std::move(*PeerSegment<ChannelSegment>::attach(instance, 1));
    }

    void tell(ChannelEventKind kind, std::uint64_t record = 0, double value = 0,
              std::uint32_t epoch = 1) {
        ChannelEvent e;
        e.seq = ++event;
        e.kind = static_cast<std::uint32_t>(kind);
        e.record = record;
        e.value = value;
        e.epoch = epoch;
        RingProducer<RingHead<ChannelEvent, 64>> ring(kernel->events[0], channel->event_tail);
        ASSERT_TRUE(ring.push(e));
    }
    bool quiet() const { return channel->quiet.load() == event; }
    // As the clock does in virtual time: until the channel has nothing more to say.
    void run_until_quiet() {
        for (int n = 0; n < 100'000 && !quiet(); ++n) process->turn(false);
        ASSERT_TRUE(quiet());
    }
    // Takes everything out of the ring; answers records that drain.
    std::size_t take_all() {
        RingConsumer<RingHead<PathRecord, kPathRing>> ring(channel->path, kernel->path_tail[0]);
        std::size_t drains = 0;
        while (const PathRecord* r = ring.front()) {
            taken.push_back(*r);
            if (r->flags & kDrains) {
                tell(ChannelEventKind::BarrierReached, ring.tail());
                ++drains;
            }
            ring.pop();
        }
        return drains;
    }
};

inline Move line_to(const MachineView& view, AxisValues& at, double x, double z) {
    Move move;
    move.kind = MoveKind::Linear;
    move.feed_mode = FeedMode::PerMinute;
    move.feed = 600;
    move.machine_start = at;
    move.machine = at;
    move.machine[0] = x;
    move.machine[1] = z;
    move.moved = 3;
    at = move.machine;
    (void)view;
    return move;
}

}  // namespace polyturn::channels::rig
