// A machine on the bench: the kernel's cyclic part in this process, with supervisor, store, PLC and
// channels played by the test. The segments are ordinary objects here: what a test sees is what
// lies in shared memory when it is for real.
//
//   TickRig rig;                                    // two turrets: L1 with A1 X, A2 Z; L2 with A3
//                                                   X, A4 Z; S1
//   rig.push(1, rig.line(1, {10, 0}, 50));          // 10 mm in X at 50 mm/s, from where L1's last
//                                                   record ended
//   rig.start(1);
//   rig.run_until_rest();
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <vector>

#include "kernel/tick/machine.hpp"

namespace polyturn::kernel {

class TickRig {
public:
    // that every channel has from the beginning
    static constexpr std::string_view kProgram = "rig.nc";
    // every axis
    static constexpr double kVelocity = 200.0, kAcceleration = 2000.0, kJerk = 40'000.0;

    explicit TickRig(const std::function<void(params::Table&, RunOptions&)>& adjust = {},
                     const std::function<void(StoreSegment&)>& keep = {}) {
        params::set_defaults(store->parameters.draft());
        params::Table& t = store->parameters.draft();
        for (unsigned l = 1; l <= kMaxChannels; ++l)
            params::put(t, params::n0000_machine_group, 0, l);
        for (unsigned l = 1; l <= 3; ++l) {
            params::put(t, params::n0000_machine_group, 1, l);
            params::put(t, params::n0604_default_spindle, 1, l);
        }
        for (unsigned a = 1; a <= 4; ++a) {
            params::put(t, params::n0002_axis_assign, a <= 2 ? 1 : 2, a);
            params::put(t, params::n0304_rapid, kVelocity * 60, a);
            params::put(t, params::n0305_max_feed, kVelocity * 60, a);
            params::put(t, params::n0400_acceleration, kAcceleration, a);
            params::put(t, params::n0401_acc_tc, kAcceleration / kJerk, a);
            params::put(t, params::n0504_position_gain, 40, a);
            params::put(t, params::n0511_feedforward, 1, a);
            params::put(t, params::n0515_feed_forward_control, 3, a);
            params::put(t, params::n0516_inpos, 0.005, a);
        }
        for (unsigned s = 1; s <= 2; ++s) {
            params::put(t, params::n0607_spindle_config, 7, s);
            params::put(t, params::n0608_spindle_encoder_counts, 4096, s);
            params::put(t, params::n0610_spindle_n_time_constant, 0, s);
            params::put(t, params::n0634_r1_s_calibration, 4500, s);
            params::put(t, params::n0650_r1_s_max, 4000, s);
            params::put(t, params::n0666_r1_s_ramp_up, 1500, s);
            params::put(t, params::n0674_r1_s_ramp_down, 1500, s);
        }
        supervisor->options.virtual_time = 1;
        supervisor->options.ready = 1;
        if (adjust) adjust(t, supervisor->options);
        store->parameters.publish();
        if (keep) keep(*store);
        machine = std::make_unique<Machine>(*kernel, *supervisor, *store);
        EXPECT_TRUE(store->parameters.read(machine->core().table));
        machine->start();
        machine->attach_plc(*plc);
        for (unsigned l = 1; l <= 3; ++l) {
            channel.push_back(std::make_unique<ChannelSegment>());
            machine->attach_channel(l - 1, *channel.back());
            machine->channel(l - 1).select(kProgram, 0);
        }
    }

    // --- records ---
    PathRecord blank(unsigned l, RecordKind kind) {
        PathRecord r{};
        r.kind = static_cast<std::uint8_t>(kind);
        r.epoch = channel[l - 1]->epoch.load();
        r.line = ++lines_;
        r.note = ++notes_;
        r.flags = kBlockBegin | kBlockEnd;
        r.block = -1;
        return r;
    }
    // A straight move by (dx, dz) from the end of the channel's last one.
    PathRecord line(unsigned l, std::array<double, 2> by, double feed_mm_s,
                    std::uint32_t flags = 0) {
        PathRecord r = blank(l, RecordKind::Line);
        r.flags |= flags;
        r.axis_count = 2;
        for (unsigned i = 0; i < 2; ++i) {
            r.axis[i] = static_cast<std::uint8_t>((l - 1) * 2 + i);
            r.start[i] = at_[l - 1][i];
            r.end[i] = at_[l - 1][i] += by[i];
        }
        r.length = std::hypot(by[0], by[1]);
        const double most = std::max(std::fabs(by[0]), std::fabs(by[1])) / r.length;
        r.v_max = kVelocity / most;
        r.a_max = kAcceleration / most;
        r.j_max = kJerk / most;
        r.feed_mode =
            static_cast<std::uint8_t>((flags & kRapid) ? FeedMode::Rapid : FeedMode::PerMinute);
        r.feed = feed_mm_s;
        r.spindle = 1;
        return r;
    }
    // The next record of the channel begins here.
    void place(unsigned l, unsigned slot, double at) { at_[l - 1][slot] = at; }
    PathRecord wait(unsigned l, int code, std::uint32_t set, std::uint32_t flags = 0) {
        PathRecord r = blank(l, RecordKind::Wait);
        r.code = code;
        r.mask = set;
        r.flags |= flags;
        return r;
    }
    PathRecord dwell(unsigned l, double seconds) {
        PathRecord r = blank(l, RecordKind::Dwell);
        r.feed_mode = static_cast<std::uint8_t>(FeedMode::Seconds);
        r.feed = seconds;
        return r;
    }
    PathRecord aux(unsigned l, char letter, double value) {
        PathRecord r = blank(l, RecordKind::Aux);
        r.code = letter;
        r.value = value;
        return r;
    }
    PathRecord stop(unsigned l, StopReason reason) {
        PathRecord r = blank(l, RecordKind::Stop);
        r.code = static_cast<std::int32_t>(reason);
        return r;
    }
    PathRecord spindle(unsigned l, double rpm, std::uint16_t number = 1) {
        PathRecord r = blank(l, RecordKind::SpindleSpeed);
        r.spindle = number;
        r.value = rpm;
        return r;
    }
    std::uint64_t push(unsigned l, const PathRecord& record) {
        auto& ring = channel[l - 1]->path;
        const auto head = ring.head.load();
        stop_at_corner(ring, last_line_[l - 1], record);
        if (record.kind == static_cast<std::uint8_t>(RecordKind::Line)) last_line_[l - 1] = head;
        ring.slot(head) = record;
        ring.head.store(head + 1);
        return head;
    }

    // --- commands ---
    void command(CommandKind kind, unsigned l = 0, double value = 1, std::int64_t tick = 0,
                 std::uint32_t object = 0, std::uint32_t flags = 0, std::string_view text = {}) {
        auto& ring = supervisor->commands;
        const auto head = ring.head.load();
        Command& c = ring.slot(head);
        c = {};
        c.kind = static_cast<std::uint32_t>(kind);
        c.channel = l;
        c.value = value;
        c.tick = tick;
        c.seq = head + 1;
        c.object = object;
        c.flags = flags;
        copy_text(c.text, text);
        ring.head.store(head + 1);
    }
    void start(unsigned l) { command(CommandKind::CycleStart, l); }

    // --- time ---
    void tick() {
        machine->tick();
        serve();
        if (on_tick) on_tick();
    }
    // What the other processes do between two ticks.
    void serve() {
        answer_events();
        answer_plc();
        read_log();
    }
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) tick();
    }
    // Until nothing can go on; the number of ticks it took.
    int run_until_idle(int most = 200'000) {
        for (int i = 0; i < most; ++i) {
            if (machine->idle()) return i;
            tick();
        }
        ADD_FAILURE() << "not idle after " << most << " ticks";
        return most;
    }

    // --- what is seen ---
    ChannelState state(unsigned l) const { return machine->channel(l - 1).state(); }
    double position(unsigned axis) const { return machine->core().axes[axis - 1].command(); }
    double speed_of(unsigned axis) const { return machine->core().axes[axis - 1].velocity(); }
    const KernelEvent* find(KernelEventKind kind, unsigned l = 0, std::uint64_t note = 0) const {
        for (const KernelEvent& e : log)
            if (e.kind == static_cast<std::uint32_t>(kind) && (l == 0 || e.channel == l) &&
                (note == 0 || e.note == note))
                return &e;
        return nullptr;
    }
    bool alarmed(Alarm number, unsigned l = 0) const {
        for (const KernelEvent& e : log)
            if (e.code == static_cast<int>(number) && (l == 0 || e.channel == l) &&
                (e.kind == static_cast<std::uint32_t>(KernelEventKind::Alarm) ||
                 e.kind == static_cast<std::uint32_t>(KernelEventKind::Message)))
                return true;
        return false;
    }
    // Time of an event in ticks, its part of a tick included.
    double when(const KernelEvent* e) const {
        return e ? static_cast<double>(e->tick) + e->offset_s / machine->core().config.tick_s
                 : -1.0;
    }

    // Played parts a test may change.
    std::function<void(const PlcInputs&, PlcOutputs&)> plc_program = lathe;
    std::function<void()> on_tick;
    bool plc_answers = true;
    std::vector<KernelEvent> log;
    std::vector<std::vector<ChannelEvent>> heard = std::vector<std::vector<ChannelEvent>>(3);

    std::unique_ptr<SupervisorSegment> supervisor = std::make_unique<SupervisorSegment>();
    std::unique_ptr<StoreSegment> store = std::make_unique<StoreSegment>();
    std::unique_ptr<KernelSegment> kernel = std::make_unique<KernelSegment>();
    std::unique_ptr<PlcSegment> plc = std::make_unique<PlcSegment>();
    std::vector<std::unique_ptr<ChannelSegment>> channel;
    std::unique_ptr<Machine> machine;

    // Finishes every M, S and T at once; M3, M4, M5 turn spindle 1.
    static void lathe(const PlcInputs& in, PlcOutputs& out) {
        for (std::size_t a = 1; a <= 4; ++a) out.signal[signals::ap_paxena(a)] = 1;
        for (std::size_t l = 1; l <= 3; ++l) {
            const int code = in.signal[signals::cn_mcode(l)];
            if (out.signal[signals::cp_mfin(l)] != in.signal[signals::cn_mstr(l)] && code >= 3 &&
                code <= 5)
                out.signal[signals::sp_rot(1)] = code;
            out.signal[signals::cp_jogfd(l)] = 20;  // 12.6 m/min
            out.signal[signals::cp_mfin(l)] = in.signal[signals::cn_mstr(l)];
            out.signal[signals::cp_sfin(l)] = in.signal[signals::cn_sstr(l)];
            out.signal[signals::cp_tfin(l)] = in.signal[signals::cn_tstr(l)];
            out.signal[signals::cp_bfin(l)] = in.signal[signals::cn_bstr(l)];
        }
    }

private:
    // As a channel does it: no path goes round a corner at speed. Of lines; what was pushed so long
    // ago that it is driven already rests at its end.
    static void stop_at_corner(auto& ring, std::uint64_t last, const PathRecord& record) {
        if (last == ~0ull || record.kind != static_cast<std::uint8_t>(RecordKind::Line) ||
            (record.flags & kThread))
            return;
        PathRecord& before = ring.slot(last);
        const auto way = [](const PathRecord& r, std::size_t axis) {
            for (std::size_t i = 0; i < r.axis_count; ++i)
                if (r.axis[i] == axis && r.length > 0) return (r.end[i] - r.start[i]) / r.length;
            return 0.0;
        };
        for (std::size_t a = 0; a < kMaxAxes; ++a)
            if (std::fabs(way(before, a) - way(record, a)) > 1e-9) before.flags |= kExactStop;
    }
    // A channel takes its events at once; after a reset it pushes with the new epoch.
    void answer_events() {
        for (unsigned l = 0; l < 3; ++l) {
            auto& tail = channel[l]->event_tail.tail;
            const auto head = kernel->events[l].head.load();
            while (tail.load() < head) {
                const ChannelEvent& event = kernel->events[l].slot(tail.load());
                if (std::string_view(event.text.data()) != kProgram) heard[l].push_back(event);
                if (event.kind == static_cast<std::uint32_t>(ChannelEventKind::Reset)) {
                    channel[l]->epoch.store(event.epoch);
                    for (unsigned i = 0; i < 2 && l < 2; ++i) at_[l][i] = position(l * 2 + i + 1);
                }
                channel[l]->quiet.store(event.seq);
                tail.fetch_add(1);
            }
        }
    }
    void answer_plc() {
        PlcInputs in;
        if (!plc_answers || !kernel->plc_inputs.read(in) || in.cycle == plc->cycle.load()) return;
        PlcOutputs& out = plc->outputs.draft();
        out = plc->outputs.published();
        plc_program(in, out);
        out.cycle = in.cycle;
        plc->outputs.publish();
        plc->cycle.store(in.cycle);
    }
    void read_log() {
        const auto head = kernel->log.head.load();
        for (auto i = supervisor->log_tail.tail.load(); i < head; ++i)
            log.push_back(kernel->log.slot(i));
        supervisor->log_tail.tail.store(head);
    }
    std::array<std::array<double, 2>, 3> at_{};
    // index of the last one that was pushed
    std::array<std::uint64_t, 3> last_line_{~0ull, ~0ull, ~0ull};
    std::uint32_t lines_ = 0;
    std::uint64_t notes_ = 0;
};

}  // namespace polyturn::kernel
