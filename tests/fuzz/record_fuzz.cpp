// libs: polyturn_kernel
//
// A channel's process may write anything into its segment: any bytes as a
// record, any head, any transformation. No axis leaves its limits, no memory is harmed, a tick
// stays a tick.
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "kernel/tick/machine.hpp"

namespace {
using namespace polyturn;
using namespace polyturn::kernel;

constexpr double kVelocity = 200, kAcceleration = 2000, kJerk = 40'000, kFarthest = 500;

struct Bytes {
    const std::uint8_t* at;
    const std::uint8_t* end;
    bool empty() const { return at == end; }
    std::uint8_t one() { return at == end ? 0 : *at++; }
    void take(void* to, std::size_t size) {  // zeros when they are used up
        const std::size_t n = std::min(size, static_cast<std::size_t>(end - at));
        std::memcpy(to, at, n);
        at += n;
    }
};

struct Rig {
    std::unique_ptr<SupervisorSegment> supervisor = std::make_unique<SupervisorSegment>();
    std::unique_ptr<StoreSegment> store = std::make_unique<StoreSegment>();
    std::unique_ptr<KernelSegment> image = std::make_unique<KernelSegment>();
    std::unique_ptr<ChannelSegment> channel = std::make_unique<ChannelSegment>();
    std::unique_ptr<Machine> machine;
    double at[2] = {0, 0}, p[2] = {0, 0}, v[2] = {0, 0};

    Rig() {
        params::Table& t = store->parameters.draft();
        params::set_defaults(t);
        for (unsigned l = 1; l <= kMaxChannels; ++l)
            params::put(t, params::n0000_machine_group, l == 1 ? 1 : 0, l);
        for (unsigned a = 1; a <= 2; ++a) {
            params::put(t, params::n0002_axis_assign, 1, a);
            params::put(t, params::n0304_rapid, kVelocity * 60, a);
            params::put(t, params::n0305_max_feed, kVelocity * 60, a);
            params::put(t, params::n0400_acceleration, kAcceleration, a);
            params::put(t, params::n0401_acc_tc, kAcceleration / kJerk, a);
            params::put(t, params::n1000_range_enable, 1, a);
            params::put(t, params::n1002_range1a_positive, kFarthest, a);
            params::put(t, params::n1003_range1a_negative, -kFarthest, a);
        }
        store->parameters.publish();
        supervisor->options.virtual_time = supervisor->options.ready = 1;
        machine = std::make_unique<Machine>(*image, *supervisor, *store);
        if (!store->parameters.read(machine->core().table)) std::abort();
        machine->start();
        machine->attach_channel(0, *channel);
        machine->channel(0).select("fuzz.nc", 0);
        machine->channel(0).cycle_start();
    }
    void tick() {
        machine->tick();
        supervisor->log_tail.tail.store(image->log.head.load());
        channel->event_tail.tail.store(image->events[0].head.load());
        for (unsigned a = 0; a < 2; ++a) {
            const double now = machine->core().axes[a].command(), speed = (now - p[a]) / 0.001,
                         acceleration = (speed - v[a]) / 0.001;
            if (!(std::fabs(now) <= kFarthest + 1e-6) ||
                !(std::fabs(speed) <= kVelocity * 1.02 + 0.01) ||
                !(std::fabs(acceleration) <= 10'000 * 1.02))
                std::abort();
            p[a] = now;
            v[a] = speed;
        }
    }
    PathRecord good(std::uint8_t x, std::uint8_t z) {
        PathRecord r{};
        r.kind = static_cast<std::uint8_t>(RecordKind::Line);
        r.flags = kBlockBegin | kBlockEnd;
        r.axis_count = 2;
        const double by[2] = {(x - 127.5) / 8, (z - 127.5) / 8};
        for (unsigned i = 0; i < 2; ++i) {
            r.axis[i] = static_cast<std::uint8_t>(i);
            r.start[i] = at[i];
            r.end[i] = at[i] += by[i];
        }
        r.length = std::hypot(by[0], by[1]);
        const double most = std::fmax(std::fabs(by[0]), std::fabs(by[1])) / r.length;
        r.v_max = kVelocity / most;
        r.a_max = kAcceleration / most;
        r.j_max = kJerk / most;
        r.feed_mode = static_cast<std::uint8_t>(FeedMode::PerMinute);
        r.feed = 100;
        return r;
    }
};
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto rig = std::make_unique<Rig>();
    Bytes bytes{data, data + size};
    auto& ring = rig->channel->path;
    while (!bytes.empty()) {
        const std::uint8_t what = bytes.one();
        PathRecord& slot = ring.slot(ring.head.load());
        switch (what % 8) {
            case 0:
                bytes.take(&slot, sizeof slot);
                ring.head.fetch_add(1);
                break;
            case 1: {  // good, but for a few bytes
                slot = rig->good(bytes.one(), bytes.one());
                for (unsigned n = what / 8 % 4; n > 0; --n) {
                    const unsigned place = bytes.one() | unsigned{bytes.one()} << 8;
                    reinterpret_cast<std::uint8_t*>(&slot)[place % sizeof slot] = bytes.one();
                }
                ring.head.fetch_add(1);
                break;
            }
            case 2: {  // good, but for one number
                slot = rig->good(bytes.one(), bytes.one());
                double number = 0;
                const unsigned place = bytes.one();
                bytes.take(&number, sizeof number);
                std::memcpy(reinterpret_cast<std::uint8_t*>(&slot) + 64 +
                                8 * (place % ((sizeof slot - 64) / 8)),
                            &number, sizeof number);
                ring.head.fetch_add(1);
                break;
            }
            case 3: {
                std::uint64_t head = 0;
                bytes.take(&head, 1 + what / 8 % 8);
                ring.head.store(what & 128 ? head : ring.head.load() + head);
                break;
            }
            case 4:
                bytes.take(&rig->channel->kinematics[what / 8 % kKinematics], sizeof(Kinematics));
                break;
            // one that was sent already
            case 5:
                bytes.take(&ring.slot(ring.head.load() - 1 - what / 8), sizeof(PathRecord));
                break;
            default:
                for (unsigned n = 1u << (what / 8 % 6); n > 0; --n) rig->tick();
        }
    }
    for (int n = 0; n < 200; ++n) rig->tick();
    return 0;
}
