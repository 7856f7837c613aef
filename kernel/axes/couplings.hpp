// Coupled axes: synchronous, superimposed, gantry and exchanged ones (nct_parameters_part2 22,
// architecture 5.8).
//
//   own target of each axis -->  [ superimposed:  + s * travel of the master since switch-on ]
//   (channels, jogs)             [ synchronous:   own target := s * travel of the master     ]  -->
//                                                                                       target()
//
// An axis' own command and its position are two numbers of AxisUnit: own() and command(). A
// superimposed axis adds its master's travel to its own; a synchronous one has no travel of its
// own. Masters are evaluated before their slaves, so that a chain has no lag. All positions count
// from a reference taken at standstill: nothing is summed up tick by tick, the commanded difference
// of coupled slides is constant.
//
// Limits: a master is limited by its slaves, and an axis with superimposed travel has half of its
// limits for its own; core.config.axes has the result for all users in the kernel (jogs,
// references, emergencies), the channels compute the same for themselves.
//
// Switching: PLC levels AP_SYNCR, AP_SPRPNR, AP_MIXR of the slave. It waits until slave and masters
// rest and their channels have nothing planned ahead: what was planned with other limits and
// coordinates is never driven, and the switch makes no step of the command. When that has not come
// after PT_COUPLE_TIMEOUT, or requests contradict each other (two roles for one axis, two owners of
// one drive, a ring), it is refused: an alarm names the axis, its mover stops, and the state
// stays until the request is withdrawn or the alarm's reset asks again. An exchange (composite)
// moves nothing in here: it reports to the channels which drive is behind an address (route), and
// they read it at the barrier at which the M code that switched has left them.
//
// Cost: one pass over the axes that parameters couple at all; nothing for the others.
#pragma once
#include <array>
#include <cstdint>

#include "kernel/tick/core.hpp"

namespace polyturn::kernel {

class Couplings {
public:
    // From the parameters (N2101 to N2108, N0522): at the start and when they change. Couplings
    // that act go on.
    void configure(const params::Table& table, const KernelConfig& config) noexcept;
    // The configuration was read anew: its limits are those of the axes alone.
    void lower_limits(Core& core) noexcept;
    // After channels and jogs have said where their axes go, before limits and drives.
    void step(Core& core) noexcept;

    // Referencing gave an axis (from 0) other numbers: its couplings count on from them.
    void shifted(std::size_t axis, double by) noexcept;

    // For status and channels; axis numbers from 1, 0 none.
    std::uint32_t synchronous_master(std::size_t a) const noexcept {
        return links_[a].sync.on ? links_[a].sync.master : 0;
    }
    std::uint32_t superimposed_master(std::size_t a) const noexcept {
        return links_[a].add.on ? links_[a].add.master : 0;
    }
    // axis behind the address; 0: its own
    std::uint32_t route(std::size_t a) const noexcept { return links_[a].route; }
    std::uint32_t master_of(std::size_t a) const noexcept {
        return links_[a].sync.on ? links_[a].sync.master : superimposed_master(a);
    }
    // Axis (from 1) whose gantry slave it is; 0 none. And its sense against it.
    std::uint32_t gantry_master(std::size_t a) const noexcept {
        return links_[a].gantry ? links_[a].sync.master : 0;
    }
    double sense(std::size_t a) const noexcept { return links_[a].sync.sign; }
    // Channels whose axes have other limits or coordinates since this tick: what they have driven
    // is not driven back.
    ChannelSet changed() const noexcept { return changed_; }
    // A request that this tick has refused; axis 0: none. The mover of either axis must stop.
    struct Refusal {
        std::uint32_t axis = 0, other = 0;  // from 1
        Alarm number = Alarm::CoupleTimeout;
        ShortText detail;
        double value = 0;
    };
    const Refusal& refusal() const noexcept { return refusal_; }
    // channels that have its alarm
    void refusal_shown(ChannelSet by) noexcept { links_[refusal_.axis - 1].shown_by = by; }
    // A gantry slave (from 1) that has gone too far from its master; 0 none. Asked once a tick.
    std::uint32_t skewed_gantry() const noexcept { return skewed_; }

private:
    struct Follow {
        std::uint32_t master = 0;  // from 1; 0 not configured
        double sign = 1;
        bool on = false;
        double own_ref = 0, master_ref = 0;
    };
    struct Link {
        Follow sync, add;
        bool gantry = false;
        double pull_gain = 0, gantry_limit = 0, pull_v = 0;
        // of a gantry without reference points: how far its slides were apart when the machine was
        // switched on
        bool apart_known = false;
        double apart = 0;
        std::uint32_t exchange_with = 0;  // N2104
        std::uint32_t route = 0;
        // request that waits for standstill
        std::int64_t sync_since = -1, add_since = -1, mix_since = -1;
        bool conflict_told = false;  // about a request that contradicts another
        bool refused = false;        // after PT_COUPLE_TIMEOUT
        ChannelSet shown_by = 0;     // channels with the alarm of the refusal
        bool alarmed = false;        // one of them shows it now
        bool was_closed = true;      // its position loop and its master's
        // parameters lead its masters back to it: it is not coupled
        bool ring = false;
    };
    struct Limits {
        double rapid, acceleration, jerk, estop;
    };
    bool rests(const Core& core, std::size_t a) const noexcept;
    bool stand(const Core& core, std::size_t slave, std::size_t master) noexcept;
    void share_limits(Core& core) noexcept;
    bool may_switch(Core& core, std::size_t a, std::size_t other, std::int64_t& since,
                    const char* what) noexcept;
    bool refuse(std::size_t a, std::size_t other, Alarm number, std::string_view detail,
                double value) noexcept;
    void forget_refusal(const Core& core, std::size_t a) noexcept;
    bool contradicts(const Core& core, std::size_t a, bool sync, bool add, bool mix) const noexcept;
    void place_masters_first() noexcept;
    void switch_requests(Core& core, std::size_t a) noexcept;
    void exchange(Core& core, std::size_t a) noexcept;
    void follow(Core& core, std::size_t a) noexcept;
    void watch_gantry(const Core& core, Link& link, std::size_t a) noexcept;
    double gantry_pull(Core& core, Link& link, std::size_t a) noexcept;
    void pull_after_master(Core& core, const Link& link, std::size_t a) noexcept;

    std::array<Link, kMaxAxes> links_{};
    std::array<Limits, kMaxAxes> home_{};
    std::array<std::uint8_t, kMaxAxes> order_{};  // axes with a link, masters first
    std::size_t count_ = 0;
    double timeout_s_ = 0;
    bool switched_ = false;  // in this tick
    ChannelSet changed_ = 0;
    std::uint32_t skewed_ = 0;
    Refusal refusal_;
    // tick; the loops are closed and follow-up is over some ticks later
    std::int64_t powered_since_ = 0;
};

}  // namespace polyturn::kernel
