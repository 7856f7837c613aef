#include "kernel/axes/couplings.hpp"

#include <algorithm>
#include <cmath>

#include "ipc/diagnosis/assert.hpp"

namespace polyturn::kernel {
namespace p = params;
namespace {
// after the loops are closed: commands are taken from the drives
constexpr std::int64_t kFollowUpTicks = 3;
// a large difference after power-on is driven out slowly
constexpr double kGantryPullOfRapid = 0.1;
// F8311: the master counts within its channel (fanuc_lathe 10.3). 0: none.
std::uint32_t axis_of_channel(const KernelConfig& config, std::uint32_t channel,
                              std::int64_t place) noexcept {
    for (std::uint32_t a = 0; a < config.axis_count && place > 0; ++a)
        if (config.axes[a].exists && config.axes[a].channel == channel && --place == 0)
            return a + 1;
    return 0;
}

}  // namespace

void Couplings::configure(const p::Table& t, const KernelConfig& config) noexcept {
    timeout_s_ = static_cast<double>(p::get(t, p::pt_couple_timeout));
    const auto axis = [&](std::int64_t n) -> std::uint32_t {
        return n >= 1 && n <= static_cast<std::int64_t>(kMaxAxes) &&
                       config.axes[static_cast<std::size_t>(n) - 1].exists
                   ? static_cast<std::uint32_t>(n)
                   : 0u;
    };
    for (unsigned n = 1; n <= kMaxAxes; ++n) {
        Link& link = links_[n - 1];
        const bool exists = config.axes[n - 1].exists;
        if (!link.sync.on) {
            link.sync.master = exists ? axis(p::get(t, p::n2101_synchronous_master, n)) : 0;
            if (exists && link.sync.master == 0)
                link.sync.master =
                    axis_of_channel(config, config.axes[n - 1].channel, p::get(t, p::f8311, n));
        }
        if (!link.add.on)
            link.add.master = exists ? axis(p::get(t, p::n2107_superimposed_master, n)) : 0;
        link.sync.sign = p::bit(t, p::n2102_synchron_config, n, 0) ? -1.0 : 1.0;
        link.add.sign = p::bit(t, p::n2108_superimposed_config, n, 0) ? -1.0 : 1.0;
        link.gantry = link.sync.master && p::bit(t, p::n2102_synchron_config, n, 4);
        link.pull_gain = std::fmax(0.0, p::get(t, p::n0522_synchr_k, n));
        link.gantry_limit = p::get(t, p::n2103_synchron_error, n);
        if (!link.route) {  // one of the two may be hypothetical: no drive, but an address
            const auto other = p::get(t, p::n2104_composit_axis, n);
            link.exchange_with = other >= 1 && other <= static_cast<std::int64_t>(kMaxAxes)
                                     ? static_cast<std::uint32_t>(other)
                                     : 0u;
        }
    }
    place_masters_first();
}

// Masters before their slaves. A ring of parameters (the configuration check refuses it at a start;
// later it can come value by value) loses the masters that do not act yet: what acts was no ring
// when it was switched on, so what is left is none.
void Couplings::place_masters_first() noexcept {
    std::array<bool, kMaxAxes> placed{};
    count_ = 0;
    for (Link& link : links_) link.ring = false;
    for (bool progress = true; progress;) {
        progress = false;
        for (std::size_t a = 0; a < kMaxAxes; ++a) {
            const Link& link = links_[a];
            if (placed[a] ||
                (!link.sync.master && !link.add.master && !link.exchange_with && !link.ring))
                continue;
            const auto waits_for = [&](std::uint32_t m) {
                return m && !placed[m - 1] &&
                       (links_[m - 1].sync.master || links_[m - 1].add.master);
            };
            if (waits_for(link.sync.master) || waits_for(link.add.master)) continue;
            order_[count_++] = static_cast<std::uint8_t>(a);
            placed[a] = progress = true;
        }
        for (std::size_t a = 0; a < kMaxAxes && !progress; ++a) {
            Link& link = links_[a];
            if (placed[a]) continue;
            for (Follow* follow : {&link.sync, &link.add})
                if (follow->master && !follow->on) {
                    follow->master = 0;
                    link.ring = progress = true;
                }
        }
    }
    PT_ASSERT(std::ranges::none_of(links_,
                                   [&](const Link& link) {
                                       return (link.sync.master || link.add.master) &&
                                              !placed[static_cast<std::size_t>(&link - &links_[0])];
                                   }),
              "masters before their slaves: all that follow are placed");
}

bool Couplings::rests(const Core& core, std::size_t a) const noexcept {
    const AxisUnit& axis = core.axes[a];
    return !axis.moving() && axis.own_target() == axis.own() && axis.target() == axis.command();
}

// The masters of the master rest, too, and the channels of all of them have nothing planned. Then
// these are changed().
bool Couplings::stand(const Core& core, std::size_t slave, std::size_t master) noexcept {
    ChannelSet touched = 0;
    const auto touch = [&](std::size_t a) {
        for (const std::uint32_t l : {core.config.axes[a].channel, core.axes[a].owner})
            if (l) touched |= ChannelSet{1} << (l - 1);
    };
    touch(slave);
    for (std::size_t a = master, n = 0; n < kMaxAxes; ++n) {
        if (!rests(core, a)) return false;
        touch(a);
        const std::uint32_t next = links_[a].gantry ? 0 : master_of(a);
        if (!next) break;
        a = next - 1;
    }
    if (touched & ~core.standing) return false;
    changed_ |= touched;
    return true;
}

// Limits of the configuration, kept apart from what couplings leave of them.
void Couplings::lower_limits(Core& core) noexcept {
    for (std::size_t a = 0; a < kMaxAxes; ++a) {
        const AxisConfig& axis = core.config.axes[a];
        home_[a] = {axis.rapid, axis.acceleration, axis.jerk, axis.estop_deceleration};
    }
    share_limits(core);
}

// What may reach each drive in all, slaves before their masters: a synchronous slave gets what its
// master does, a superimposed one half of it besides its own half.
void Couplings::share_limits(Core& core) noexcept {
    std::array<Limits, kMaxAxes> all = home_;
    const auto lower = [](Limits& master, const Limits& slave, double share) {
        master = {std::fmin(master.rapid, slave.rapid * share),
                  std::fmin(master.acceleration, slave.acceleration * share),
                  std::fmin(master.jerk, slave.jerk * share),
                  std::fmin(master.estop, slave.estop * share)};
    };
    for (std::size_t i = count_; i-- > 0;) {
        const std::size_t a = order_[i];
        if (links_[a].sync.on) lower(all[links_[a].sync.master - 1], all[a], 1);
        if (links_[a].add.on) lower(all[links_[a].add.master - 1], all[a], 0.5);
    }
    for (std::size_t a = 0; a < kMaxAxes; ++a) {
        AxisConfig& axis = core.config.axes[a];
        const double share = links_[a].add.on ? 0.5 : 1.0;
        const Limits own{all[a].rapid * share, all[a].acceleration * share, all[a].jerk * share,
                         all[a].estop * share};
        if (axis.rapid == own.rapid && axis.acceleration == own.acceleration &&
            axis.jerk == own.jerk && axis.estop_deceleration == own.estop)
            continue;
        axis.rapid = own.rapid;
        axis.acceleration = own.acceleration;
        axis.jerk = own.jerk;
        axis.estop_deceleration = own.estop;
        core.axes[a].configure(axis);
    }
}

// One a tick: what comes in the same tick is refused in the next one.
bool Couplings::refuse(std::size_t a, std::size_t other, Alarm number, std::string_view detail,
                       double value) noexcept {
    if (refusal_.axis) return false;
    refusal_.axis = static_cast<std::uint32_t>(a) + 1;
    refusal_.other = static_cast<std::uint32_t>(other) + 1;
    refusal_.number = number;
    refusal_.detail = {};
    refusal_.detail << detail;
    refusal_.value = value;
    links_[a].alarmed = false;
    links_[a].shown_by = 0;
    return true;
}

// A reset of the channels that show the alarm asks again.
void Couplings::forget_refusal(const Core& core, std::size_t a) noexcept {
    Link& link = links_[a];
    if (!link.refused && !link.conflict_told) return;
    bool shown = false;
    for (std::uint32_t l = 1; link.shown_by >> (l - 1); ++l)
        shown = shown || ((link.shown_by >> (l - 1) & 1u) && core.signals.nc(signals::cn_alarm(l)));
    if (link.alarmed && !shown)
        link.refused = link.conflict_told = link.alarmed = false;
    else
        link.alarmed = shown;
}

// A request waits until both axes rest. True: now.
bool Couplings::may_switch(Core& core, std::size_t a, std::size_t other, std::int64_t& since,
                           const char* what) noexcept {
    Link& link = links_[a];
    if (link.refused) return false;
    if (rests(core, a) && stand(core, a, other)) {
        since = -1;
        switched_ = true;
        return true;
    }
    if (since < 0) since = core.tick;
    const std::int64_t waited = core.tick - since;
    if (timeout_s_ > 0 && waited >= std::llround(timeout_s_ / core.config.tick_s)) {
        ShortText text;
        text << what << " " << name_of('A', a).view();
        link.refused = refuse(a, other, Alarm::CoupleTimeout, text.view(), timeout_s_);
        if (link.refused) since = -1;
    }
    return false;
}

// Two roles of one axis, two owners of one drive, a master that follows its slave.
bool Couplings::contradicts(const Core& core, std::size_t a, bool sync, bool add,
                            bool mix) const noexcept {
    const Link& link = links_[a];
    if (static_cast<int>(sync) + static_cast<int>(add) + static_cast<int>(mix) > 1) return true;
    if ((sync || add) && link.route) return true;  // its drive is at another address
    if (link.ring &&
        (core.signals.plc(signals::ap_syncr(a + 1)) || core.signals.plc(signals::ap_sprpnr(a + 1))))
        return true;
    if (!mix || link.route) return false;
    const Link& other = links_[link.exchange_with - 1];
    return other.route || other.sync.on || other.add.on;  // that drive is at another address, or
                                                          // follows, already
}

void Couplings::switch_requests(Core& core, std::size_t a) noexcept {
    Link& link = links_[a];
    AxisUnit& axis = core.axes[a];
    const auto wanted = [&](std::uint32_t slot) { return core.signals.plc(slot) != 0; };
    const bool sync = link.gantry || (link.sync.master && wanted(signals::ap_syncr(a + 1)));
    const bool add = link.add.master && wanted(signals::ap_sprpnr(a + 1));
    const bool mix = link.exchange_with && wanted(signals::ap_mixr(a + 1));
    if (contradicts(core, a, sync, add, mix)) {
        if (!link.conflict_told)
            link.conflict_told = refuse(a, link.exchange_with ? link.exchange_with - 1 : a,
                                        Alarm::CoupleConflict, name_of('A', a).view(), 0);
        return;  // what acts goes on; nothing is added to it
    }
    link.conflict_told = false;
    // withdrawn
    if (sync == link.sync.on && add == link.add.on && mix == (link.route != 0))
        link.refused = false;
    if (sync != link.sync.on) {
        const std::size_t m = link.sync.master - 1;
        if (link.gantry || may_switch(core, a, m, link.sync_since, "AP_SYNCR")) {
            link.sync.on = sync;
            switched_ = true;
            link.sync.own_ref = axis.own_target();
            link.sync.master_ref = core.axes[m].target();
            link.pull_v = 0;
        }
    } else {
        link.sync_since = -1;
    }
    if (add != link.add.on) {
        const std::size_t m = link.add.master - 1;
        if (may_switch(core, a, m, link.add_since, "AP_SPRPNR")) {
            link.add.on = add;
            link.add.master_ref = core.axes[m].target();
            // its channel goes on from where the axis really is
            if (!add) axis.couple(axis.target() - axis.overlay(), 0);
        }
    } else {
        link.add_since = -1;
    }
    core.signals.set_nc(signals::an_sprpna(a + 1), link.add.on);
    if (link.exchange_with) exchange(core, a);
}

// The drives of two addresses change places. One side may be an axis without a drive.
void Couplings::exchange(Core& core, std::size_t a) noexcept {
    Link& link = links_[a];
    const std::size_t other = link.exchange_with - 1;
    const bool wanted = core.signals.plc(signals::ap_mixr(a + 1)) != 0, is = link.route != 0;
    if (wanted != is) {
        if (may_switch(core, a, other, link.mix_since, "AP_MIXR")) {
            link.route = wanted ? static_cast<std::uint32_t>(other) + 1 : 0;
            links_[other].route = wanted ? static_cast<std::uint32_t>(a) + 1 : 0;
            if (core.axes[a].exists()) core.axes[a].owner = 0;
            if (core.axes[other].exists()) core.axes[other].owner = 0;
        }
    } else {
        link.mix_since = -1;
    }
    core.signals.set_nc(signals::an_mixa(a + 1), link.route != 0);
}

// N2103 is the permitted skew between the slides of a gantry, whatever moves them: also while a
// loop is open and its slide stays behind (nct_parameters_part2 22.3). Before both have their
// reference points their numbers have nothing to do with each other: then what counts is how much
// their distance has changed since the machine was switched on.
void Couplings::watch_gantry(const Core& core, Link& link, std::size_t a) noexcept {
    const AxisUnit &axis = core.axes[a], &master = core.axes[link.sync.master - 1];
    const double apart = link.sync.sign * master.measured() - axis.measured();
    const bool known = axis.referenced && master.referenced;
    if (!core.on()) link.apart_known = false;
    if (!core.on() || !(link.gantry_limit > 0) || !axis.exists() || !master.exists()) return;
    if (!link.apart_known) {
        link.apart_known = true;
        link.apart = apart;
    }
    if (std::fabs(known ? apart : apart - link.apart) > link.gantry_limit)
        skewed_ = static_cast<std::uint32_t>(a) + 1;
}

// N0522 pulls a gantry slave onto its master.
double Couplings::gantry_pull(Core& core, Link& link, std::size_t a) noexcept {
    const AxisUnit& axis = core.axes[a];
    const AxisUnit& master = core.axes[link.sync.master - 1];
    // their numbers have nothing to do with each other yet
    if (!axis.referenced || !master.referenced) return 0;
    const AxisConfig& limits = core.config.axes[a];
    const double most = kGantryPullOfRapid * limits.rapid, dt = core.config.tick_s;
    const double left =
        link.sync.sign * master.target() -
        (link.sync.own_ref + link.sync.sign * (master.target() - link.sync.master_ref));
    double v = std::fmax(-most, std::fmin(most, link.pull_gain * left));
    const double step = limits.acceleration * dt;
    v = std::fmax(link.pull_v - step, std::fmin(link.pull_v + step, v));
    if (std::fabs(v * dt) > std::fabs(left)) v = left / dt;
    link.pull_v = v;
    return v * dt;
}

// Both slides deviate from their commands, the heavier one more. N0522 also lets the slave follow
// what its master has not reached yet: their difference is corrected by the loops' gain and N0522
// together, their common deviation by the loops alone.
void Couplings::pull_after_master(Core& core, const Link& link, std::size_t a) noexcept {
    AxisUnit& axis = core.axes[a];
    const AxisUnit& master = core.axes[link.sync.master - 1];
    if (!(link.pull_gain > 0) || !axis.closed() || !master.closed() || axis.pressing ||
        master.pressing)
        return;
    const double most = kGantryPullOfRapid * core.config.axes[a].rapid;
    axis.pull(
        std::clamp(link.pull_gain * (axis.error() - link.sync.sign * master.error()), -most, most));
}

void Couplings::follow(Core& core, std::size_t a) noexcept {
    Link& link = links_[a];
    AxisUnit& axis = core.axes[a];
    if (!axis.exists() || (!link.sync.on && !link.add.on)) return;
    Follow& by = link.sync.on ? link.sync : link.add;
    const double master = core.axes[by.master - 1].target();
    if (link.gantry) watch_gantry(core, link, a);
    // A loop that was open has let go of its slide: it is closed where the slide is, and counts
    // from there.
    const bool closed = axis.closed() && core.axes[by.master - 1].closed();
    const bool loops_open = core.state == MachineState::Off ||
                            core.tick - powered_since_ < kFollowUpTicks || !closed ||
                            !link.was_closed;
    link.was_closed = closed;
    // follow-up gives both axes new numbers: the distance between them is what they now have
    if (loops_open) {
        by.own_ref = axis.own_target();
        by.master_ref = link.sync.on ? master : master - by.sign * axis.added();
        return;
    }
    if (link.sync.on) {
        if (link.gantry) by.own_ref += gantry_pull(core, link, a);
        axis.couple(by.own_ref + by.sign * (master - by.master_ref), 0);
        axis.rapid = core.axes[by.master - 1].rapid;
        axis.tap_like(core.axes[by.master - 1]);
        pull_after_master(core, link, a);
    } else {
        axis.couple(axis.own_target(), by.sign * (master - by.master_ref));
    }
}

void Couplings::shifted(std::size_t axis, double by) noexcept {
    for (std::size_t a = 0; a < kMaxAxes; ++a)
        for (Follow* follow : {&links_[a].sync, &links_[a].add}) {
            if (follow->master == axis + 1) follow->master_ref += by;
            if (a == axis) follow->own_ref += by;
        }
    for (std::size_t a = 0; a < kMaxAxes; ++a) {
        if (a == axis) links_[a].apart -= by;
        if (links_[a].sync.master == axis + 1) links_[a].apart += links_[a].sync.sign * by;
    }
}

void Couplings::step(Core& core) noexcept {
    skewed_ = 0;
    refusal_.axis = 0;
    changed_ = 0;
    if (count_ == 0) return;
    if (core.state == MachineState::Off) powered_since_ = core.tick + 1;
    for (std::size_t i = 0; i < count_; ++i) {
        forget_refusal(core, order_[i]);
        switch_requests(core, order_[i]);
        follow(core, order_[i]);
        core.axes[order_[i]].slave = links_[order_[i]].sync.on;
    }
    if (switched_) share_limits(core);
    switched_ = false;
}

}  // namespace polyturn::kernel
