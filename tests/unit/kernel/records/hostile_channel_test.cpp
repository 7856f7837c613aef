// The kernel believes no channel: whatever a process writes into its segment, no axis leaves its
// limits, no memory is harmed, the channel is out of work by name and the others keep on.
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "ipc/kinematics/kinematics.hpp"
#include "tests/seeds.hpp"
#include "tests/unit/kernel/rig.hpp"

namespace polyturn::kernel {
namespace {

constexpr double kLow = -500, kHigh = 500, kEstop = 10'000;

void stroke(params::Table& t, RunOptions&) {
    for (unsigned a = 1; a <= 4; ++a) {
        params::put(t, params::n1000_range_enable, 1, a);
        params::put(t, params::n1002_range1a_positive, kHigh, a);
        params::put(t, params::n1003_range1a_negative, kLow, a);
    }
}

// Position, velocity and acceleration of every axis, tick by tick, from raw differences of its
// command.
class Limits {
public:
    explicit Limits(TickRig& rig) : rig_(&rig) {
        for (unsigned a = 0; a < 4; ++a) axes_[a].p = rig.position(a + 1);
    }
    void look() {
        const double dt = rig_->machine->core().config.tick_s;
        for (unsigned a = 0; a < 4; ++a) {
            Axis& axis = axes_[a];
            const double p = rig_->position(a + 1), v = (p - axis.p) / dt,
                         acceleration = (v - axis.v) / dt;
            if (!(p >= kLow - 1e-6 && p <= kHigh + 1e-6)) fail(a, "position", p);
            if (!(std::fabs(v) <= TickRig::kVelocity * 1.02 + 0.01)) fail(a, "velocity", v);
            if (!(std::fabs(acceleration) <= kEstop * 1.02)) fail(a, "acceleration", acceleration);
            axis = {p, v};
        }
    }
    int faults() const { return faults_; }

private:
    void fail(unsigned a, const char* what, double value) {
        if (++faults_ <= 5)
            ADD_FAILURE() << "A" << a + 1 << ": " << what << " " << value << " at tick "
                          << rig_->machine->core().tick;
    }
    struct Axis {
        double p = 0, v = 0;
    };
    TickRig* rig_;
    std::array<Axis, 4> axes_{};
    int faults_ = 0;
};

// Detail of the alarm that put a channel out of work; empty: none did.
std::string turned_away(const TickRig& rig, unsigned l) {
    for (const KernelEvent& e : rig.log)
        if (e.code == static_cast<int>(Alarm::ChannelHostile) && e.channel == l &&
            e.kind == static_cast<std::uint32_t>(KernelEventKind::Alarm))
            return e.text.data();
    return {};
}

PathRecord arc(TickRig& rig) {  // a quarter of a turn in X Z, from where the last one ended
    PathRecord r = rig.line(1, {10, -10}, 20);
    r.kind = static_cast<std::uint8_t>(RecordKind::Arc);
    r.plane = {0, 1};
    r.shape[arc_shape::kCentreP] = r.start[0];
    r.shape[arc_shape::kCentreQ] = r.start[1] - 10;
    r.shape[arc_shape::kRadius] = 10;
    r.shape[arc_shape::kStartAngle] = M_PI / 2;
    r.shape[arc_shape::kSweep] = -M_PI / 2;
    r.length = 10 * M_PI / 2;
    r.v_max = 20;
    r.a_max = 500;
    r.j_max = 5000;
    return r;
}

struct Lie {
    const char* field;  // that the alarm names
    void (*tell)(PathRecord&);
    bool of_arc = false;
};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                 kInf = std::numeric_limits<double>::infinity();
constexpr Lie kLies[] = {
    {"kind", [](PathRecord& r) { r.kind = 0; }},
    {"kind", [](PathRecord& r) { r.kind = 200; }},
    {"axis_count", [](PathRecord& r) { r.axis_count = 9; }},
    {"axis_count", [](PathRecord& r) { r.axis_count = 255; }},
    {"axis", [](PathRecord& r) { r.axis[1] = 95; }},         // not there
    {"axis", [](PathRecord& r) { r.axis[1] = 200; }},        // none at all
    {"axis", [](PathRecord& r) { r.axis[1] = 2; }},          // of the other channel
    {"axis", [](PathRecord& r) { r.axis[1] = r.axis[0]; }},  // twice
    {"spindle", [](PathRecord& r) { r.spindle = 33; }},
    {"feed_mode", [](PathRecord& r) { r.feed_mode = 7; }},
    // not where the one before it ended
    {"start", [](PathRecord& r) { r.start[0] += 0.01; }},
    {"start", [](PathRecord& r) { r.start[0] = kNan; }},
    {"end", [](PathRecord& r) { r.end[1] = kInf; }},
    {"length", [](PathRecord& r) { r.length = kNan; }},
    {"length", [](PathRecord& r) { r.length = 0; }},  // a jump
    {"length", [](PathRecord& r) { r.length = -1; }},
    {"feed", [](PathRecord& r) { r.feed = kNan; }},
    {"v_max", [](PathRecord& r) { r.v_max = kNan; }},
    {"a_max", [](PathRecord& r) { r.a_max = -1; }},
    {"j_max", [](PathRecord& r) { r.j_max = 0; }},
    {"bend", [](PathRecord& r) { r.bend_across = kNan; }},
    {"transform", [](PathRecord& r) { r.transform = 17; }},
    {"transform", [](PathRecord& r) { r.transform = 3; }},  // nothing stands there
    {"side", [](PathRecord& r) { r.side = 9; }},
    {"text", [](PathRecord& r) { r.text.fill('x'); }},
    {"plane", [](PathRecord& r) { r.plane[0] = 2; }, true},
    {"plane", [](PathRecord& r) { r.plane[1] = 200; }, true},
    {"plane", [](PathRecord& r) { r.plane[1] = r.plane[0]; }, true},
    {"shape", [](PathRecord& r) { r.shape[arc_shape::kRadius] = kNan; }, true},
    // its circle does not lead through its points
    {"end", [](PathRecord& r) { r.shape[arc_shape::kRadius] = 11; }, true},
    {"end", [](PathRecord& r) { r.shape[arc_shape::kSweep] = -1; }, true},
};

TEST(HostileChannel, IsTurnedAwayByTheNameOfTheFieldAndThePathRestsOnWhatWasJudged) {
    for (const Lie& lie : kLies) {
        SCOPED_TRACE(std::string(lie.field) + " #" + std::to_string(&lie - kLies));
        TickRig rig(stroke);
        Limits limits(rig);
        rig.on_tick = [&] { limits.look(); };
        rig.push(1, rig.line(1, {30, 0}, 50));
        PathRecord bad = lie.of_arc ? arc(rig) : rig.line(1, {0, 30}, 50);
        bad.line = 4711;
        lie.tell(bad);
        rig.push(1, bad);
        rig.push(2, rig.line(2, {50, -20}, 60));
        rig.push(2, rig.stop(2, StopReason::M30));
        rig.start(1);
        rig.start(2);
        rig.run_until_idle();
        const std::string why = turned_away(rig, 1);
        EXPECT_NE(why.find(lie.field), std::string::npos) << why;
        EXPECT_NE(why.find("L1"), std::string::npos) << why;
        EXPECT_NE(why.find("4711"), std::string::npos) << why;
        EXPECT_EQ(rig.state(1), ChannelState::Dead);
        EXPECT_LE(rig.position(1), 30.0 + 1e-9);
        EXPECT_NEAR(rig.position(2), 0.0, 1e-9);
        EXPECT_EQ(rig.state(2), ChannelState::Ended);
        EXPECT_NEAR(rig.position(3), 50, 1e-9);
    }
}

TEST(HostileChannel, CannotChangeARecordAfterItWasJudged) {
    TickRig rig(stroke);
    Limits limits(rig);
    const auto at = rig.push(1, rig.line(1, {30, 0}, 50));
    rig.push(1, rig.stop(1, StopReason::M30));
    rig.start(1);
    rig.on_tick = [&] { limits.look(); };
    rig.run(20);
    rig.on_tick = [&] {
        limits.look();
        PathRecord& r = rig.channel[0]->path.slot(at);
        r.end[0] = 480;
        r.axis_count = 250;
        r.length = kNan;
        r.transform = 1;
    };
    rig.run_until_idle();
    EXPECT_EQ(turned_away(rig, 1), "");
    EXPECT_NEAR(rig.position(1), 30, 1e-9);
    EXPECT_EQ(rig.state(1), ChannelState::Ended);
}

TEST(HostileChannel, CannotKeepTheKernelBusyWithAHeadThatIsFarAhead) {
    for (const std::uint64_t head :
         {std::uint64_t{5000}, std::uint64_t{1} << 40, ~std::uint64_t{0}, std::uint64_t{0}}) {
        SCOPED_TRACE(head);
        TickRig rig(stroke);
        rig.push(1, rig.line(1, {30, 0}, 50));
        rig.push(1, rig.line(1, {30, 0}, 50));
        rig.push(2, rig.line(2, {50, 0}, 60));
        rig.push(2, rig.stop(2, StopReason::M30));
        rig.start(1);
        rig.start(2);
        rig.run(100);
        rig.channel[0]->path.head.store(head);
        rig.run_until_idle();
        EXPECT_NE(turned_away(rig, 1).find("head"), std::string::npos);
        EXPECT_EQ(rig.state(1), ChannelState::Dead);
        EXPECT_EQ(rig.state(2), ChannelState::Ended);
    }
}

TEST(HostileChannel, SkipsOnlySoManyOldRecordsInATick) {
    TickRig rig(stroke);
    PathRecord old = rig.line(1, {1, 0}, 50);
    old.epoch = 77;
    for (int i = 0; i < 4000; ++i) rig.push(1, old);
    rig.machine->tick();
    EXPECT_LE(rig.kernel->path_tail[0].tail.load(), 512u);
    rig.run(10);
    EXPECT_EQ(rig.kernel->path_tail[0].tail.load(), 4000u);
}

TEST(HostileChannel, LeadsNoAxisBeyondItsLimitsWhateverARecordSaysOfSpeed) {
    for (const double too_much : {1.2, 3.0, 1e3, 1e9}) {
        SCOPED_TRACE(too_much);
        TickRig rig(stroke);
        Limits limits(rig);
        rig.on_tick = [&] { limits.look(); };
        PathRecord r = rig.line(1, {400, 100}, 1e6);
        r.v_max *= too_much;
        r.a_max *= too_much;
        r.j_max = kInf;
        rig.push(1, r);
        rig.push(2, rig.line(2, {50, 0}, 60));
        rig.push(2, rig.stop(2, StopReason::M30));
        rig.start(1);
        rig.start(2);
        rig.run_until_idle();
        EXPECT_EQ(limits.faults(), 0);
        EXPECT_NE(turned_away(rig, 1).find("command A1"), std::string::npos) << turned_away(rig, 1);
        EXPECT_EQ(rig.state(1), ChannelState::Dead);
        EXPECT_EQ(rig.state(2), ChannelState::Ended);
        EXPECT_EQ(rig.machine->core().state, MachineState::On);  // nobody else stops
    }
}

// One process after the other, each hostile in its own way, while channel 2 works on.
class Siege {
public:
    explicit Siege(std::uint64_t seed) : draw_(seed), rig_(stroke), limits_(rig_) {
        rig_.plc_program = TickRig::lathe;
        rig_.on_tick = [this] {
            limits_.look();
            keep_busy();
        };
    }
    void run(std::int64_t ticks) {
        const std::int64_t until = rig_.machine->core().tick + ticks;
        rig_.start(2);
        while (rig_.machine->core().tick < until && limits_.faults() == 0 &&
               !::testing::Test::HasFailure()) {
            besiege();
            ++rounds_;
        }
    }
    int rounds_ = 0, turned_away_ = 0;
    double way_of_other_ = 0;

private:
    std::uint64_t below(std::uint64_t n) { return draw_() % n; }
    void bytes(void* to, std::size_t size) {
        auto* out = static_cast<unsigned char*>(to);
        for (std::size_t i = 0; i < size; ++i) out[i] = static_cast<unsigned char>(draw_());
    }
    // Channel 2 cuts to and fro, and its ring never runs dry.
    void keep_busy() {
        const auto& ring = rig_.channel[1]->path;
        while (ring.head.load() - rig_.kernel->path_tail[1].tail.load() < 8) {
            rig_.push(2,
                      rig_.line(2, {forth_ ? 20.0 : -20.0, forth_ ? -5.0 : 5.0}, 80, kExactStop));
            forth_ = !forth_;
        }
        way_of_other_ += std::fabs(rig_.speed_of(3)) * rig_.machine->core().config.tick_s;
        if (rig_.log.size() > 4096) rig_.log.clear();
        for (auto& heard : rig_.heard) heard.clear();
    }
    void successor() {
        auto fresh = std::make_unique<ChannelSegment>();
        fresh->event_tail.tail.store(rig_.kernel->events[0].head.load());
        rig_.machine->attach_channel(0, *fresh);
        old_ = std::move(rig_.channel[0]);
        rig_.channel[0] = std::move(fresh);
        rig_.machine->channel(0).select(TickRig::kProgram, 0);
        rig_.place(1, 0, rig_.position(1));
        rig_.place(1, 1, rig_.position(2));
    }
    PathRecord good() {
        const double x = rig_.position(1) > 0 ? -1 : 1, z = rig_.position(2) > 0 ? -1 : 1;
        return rig_.line(
            1, {x * static_cast<double>(1 + below(60)), z * static_cast<double>(1 + below(60))},
            20 + static_cast<double>(below(180)), kExactStop);
    }
    // One record that was good.
    void corrupt(PathRecord& r) {
        auto* raw = reinterpret_cast<unsigned char*>(&r);
        switch (below(6)) {
            case 0:
                raw[below(sizeof r)] ^= static_cast<unsigned char>(1u << below(8));
                break;
            case 1:
                raw[below(64)] = static_cast<unsigned char>(draw_());
                break;
            case 2:
                r.v_max *= 1e3;
                r.a_max *= 1e3;
                r.j_max *= 1e6;
                break;
            case 3:
                r.kind = static_cast<std::uint8_t>(below(30));
                bytes(&r.shape, sizeof r.shape);
                break;
            case 4: {
                const double wild[] = {kNan, kInf, -kInf, 1e300, -1e300, 1e9, -1e-300, 0};
                std::memcpy(raw + 64 + 8 * below((sizeof r - 64) / 8), &wild[below(8)], 8);
                break;
            }
            default:
                bytes(raw + 16, sizeof r - 16);
        }
    }
    void besiege() {
        successor();
        ChannelSegment& own = *rig_.channel[0];
        for (int i = 0; i < 3; ++i) rig_.push(1, good());
        rig_.start(1);
        rig_.run(static_cast<int>(below(400)));
        const auto how = below(5);
        for (int n = 0; n < 60 && rig_.state(1) != ChannelState::Dead; ++n) {
            PathRecord r = good();
            switch (how) {
                case 0:
                    corrupt(r);
                    rig_.push(1, r);
                    break;
                case 1:
                    rig_.push(1, r);
                    bytes(&own.path.slot(below(4096)), sizeof(PathRecord));
                    bytes(&own.kinematics, sizeof own.kinematics);
                    break;
                case 2:
                    own.path.head.store(n < 20 ? own.path.head.load() + below(200) : draw_());
                    break;
                case 3:
                    bytes(&own.path.slots, sizeof(PathRecord) * 64);
                    own.path.head.fetch_add(below(4));
                    own.answered.store(draw_());
                    own.quiet.store(draw_());
                    own.answer.store(static_cast<std::uint32_t>(draw_()));
                    own.heartbeat.store(draw_());
                    own.epoch.store(static_cast<std::uint32_t>(draw_()));
                    own.starts_away.store(static_cast<std::uint32_t>(draw_()));
                    break;
                default:
                    r.kind = static_cast<std::uint8_t>(below(4) + 1);
                    r.transform = static_cast<std::uint16_t>(below(3));
                    bytes(&own.programs, sizeof own.programs);
                    corrupt(r);
                    rig_.push(1, r);
            }
            rig_.run(static_cast<int>(below(30)));
        }
        const bool dead = rig_.state(1) == ChannelState::Dead;
        turned_away_ += dead;
        // the supervisor's way
        if (!dead)
            rig_.command(CommandKind::ProcessDied, 0, 0, 0,
                         static_cast<std::uint32_t>(kProcessChannel));
        for (int n = 0; n < 2000 && !rig_.machine->channel(0).may_be_replaced(); ++n) rig_.run(1);
        EXPECT_TRUE(rig_.machine->channel(0).may_be_replaced());
        EXPECT_EQ(rig_.state(2), ChannelState::Running);
        EXPECT_EQ(rig_.machine->core().state, MachineState::On);
    }

    std::mt19937_64 draw_;
    TickRig rig_;
    Limits limits_;
    std::unique_ptr<ChannelSegment> old_;
    bool forth_ = true;
};

// HOSTILE_TICKS=3600000: an hour of the machine.
TEST(HostileChannel, WritesRandomBytesAndTheOthersKeepOn) {
    const char* const wanted = std::getenv("HOSTILE_TICKS");
    const char* const seed = std::getenv("HOSTILE_SEED");
    Siege siege(seed ? std::strtoull(seed, nullptr, 10) : test_seed(23));
    const std::int64_t ticks = wanted ? std::strtoll(wanted, nullptr, 10) : 200'000;
    siege.run(ticks);
    // the others were not caught in the time they had
    EXPECT_GE(siege.turned_away_ * 3, siege.rounds_);
    // mm: it has worked all the time
    EXPECT_GT(siege.way_of_other_, 0.02 * static_cast<double>(ticks));
    std::printf("%d processes, %d of them turned away\n", siege.rounds_, siege.turned_away_);
}

}  // namespace
}  // namespace polyturn::kernel
