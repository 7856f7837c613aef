// Elements that follow a master spindle: a synchronous spindle, a polygon cutter, the workpiece
// axis of the electronic gear box (nct_parameters_part1 8.9, part2 19, fanuc_lathe 10.1,
// architecture 5.8). One mechanism for all of them:
//
//   follower's turns = ratio * master's turns + phase + helix * axis travel + own turns
//
// master: as its encoder says, estimated
//
// The follower reaches that line from any state (kernel/motion/line_follower.hpp), within
// its own limits and while the master goes on turning; while it follows, the master is neither
// faster nor steeper than the follower can be. Phase: zero pulse against zero pulse plus N0685
// counts of the follower; without one, as it comes.
//
// Who asks: the PLC by level (SP_SYNCR, SP_PHASER, or SP_ROT with PT_SYNC_CODE, PT_PHASE_CODE), a
// program by a record (Couple, Uncouple). A follower obeys nobody else. Being a master costs
// nothing but the limits; chains are allowed, rings refused. N0785 pulls the measured follower onto
// the measured line (1/s); PT_SYNC_ERROR guards what is left.
#pragma once
#include <array>
#include <cstdint>

#include "kernel/motion/line_follower.hpp"
#include "kernel/tick/core.hpp"

namespace polyturn::kernel {

class SpindleCouplings {
public:
    enum class Refusal : std::uint8_t { None, NoSuch, CannotFollow, Ring, Busy, TooFast, NotOn };
    struct Wish {
        std::uint32_t master = 0;    // spindle from 1
        std::uint32_t follower = 0;  // axis from 0, or kMaxAxes + spindle from 0
        double turns = 1, master_turns = 1;
        bool phased = false;
        double phase = 0;                // turns
        std::uint32_t helix = kNoHelix;  // axis from 0
        double helix_deg_mm = 0;
        double own_rev_s = 0;       // of the follower, over its line
        std::uint32_t channel = 0;  // that asked (from 1); 0: the PLC
        bool gear = false;          // G81.8: reset leaves it, N1800 says how it ends
    };
    Refusal couple(Core& core, const Wish& wish) noexcept;
    // it brakes, or turns as commanded, by itself
    void uncouple(std::uint32_t follower) noexcept;
    // ends what this channel's program has coupled, but gears
    void reset(std::uint32_t channel) noexcept;
    void step(Core& core) noexcept;  // once a tick, before the spindles

    bool follows(std::uint32_t follower) const noexcept { return find(follower) != nullptr; }
    bool synchronous(std::uint32_t follower) const noexcept;
    std::uint32_t master_of(std::uint32_t follower) const noexcept;
    double deviation(std::uint32_t follower) const noexcept;  // degrees
    // follower of its gear box; kNobody none
    std::uint32_t gear_of(std::uint32_t channel) const noexcept;
    // follower that has left its master; kNobody none
    std::uint32_t torn() const noexcept { return skewed_; }
    void shifted(std::size_t axis, double by) noexcept;
    static ShortText name_of_follower(std::uint32_t follower) noexcept {
        return follower < kMaxAxes ? name_of('A', follower) : name_of('S', follower - kMaxAxes);
    }
    static const char* text(Refusal why) noexcept;
    static constexpr std::uint32_t kNobody = ~0u;

private:
    struct Link {
        Wish wish;
        bool used = false, ending = false, was_synchronous = false;
        double ratio = 1;
        double helix_from = 0;
        double pull = 0, pull_v = 0;  // turns, turns a second
        double own = 0;               // turns that own_rev_s has made
        double deviation = 0;         // turns
        LineFollower follower;
    };
    const Link* find(std::uint32_t follower) const noexcept;
    Link* find(std::uint32_t follower) noexcept {
        return const_cast<Link*>(static_cast<const SpindleCouplings*>(this)->find(follower));
    }
    void obey_plc(Core& core, std::uint32_t spindle) noexcept;
    PathState line_of(const Core& core, const Link& link, double ahead) const noexcept;
    void drive(Core& core, Link& link) noexcept;
    static LineFollower::Limits limits_of(const Core& core, std::uint32_t follower) noexcept;

    std::array<Link, kMaxSpindles> links_{};
    std::size_t end_ = 0;  // none is used from here on: a tick without couplings looks at none
    std::array<bool, kMaxSpindles> told_{};  // of a refusal; until the request goes
    std::uint32_t skewed_ = kNobody;
};

}  // namespace polyturn::kernel
