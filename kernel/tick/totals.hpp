// What the machine counts over its life (parts, hours) and the last positions of its axes: saved by
// the store, sent through the kernel's ring. Parts are sent at once; hours when a program stops and
// every ten seconds, because each is a write to the disk.
#pragma once
#include <array>
#include <bitset>
#include <cmath>
#include <cstdint>

#include "ipc/requests/counters.hpp"
#include "kernel/axes/axis_unit.hpp"
#include "kernel/tools/store_link.hpp"

namespace polyturn::kernel {

class Totals {
public:
    // From the parameters as the store has them.
    void start(const params::Table& table) noexcept;
    // An operator may have set one of them (a part counter to 0).
    void adopt(const params::Table& table) noexcept;
    void part(unsigned channel) noexcept;  // from 0
    double machined(unsigned channel) const noexcept {
        return values_[static_cast<std::size_t>(
            counter_number(Counter::MachinedParts, channel + 1))];
    }
    void set_machined(unsigned channel, double parts) noexcept {
        value(Counter::MachinedParts, channel) = parts;
        due_[static_cast<std::size_t>(counter_number(Counter::MachinedParts, channel + 1))] = true;
    }
    void part_begins(unsigned channel) noexcept { value(Counter::PartTime, channel) = 0; }
    struct Activity {
        bool operates = false, cuts = false, interval = false;
    };
    void spend(unsigned channel, const Activity& activity, double ms) noexcept;
    void power_on(double ms) noexcept { values_[static_cast<std::size_t>(kPowerOnTime)] += ms; }
    void timers_due() noexcept { due_.set(); }
    // The position of an axis at standstill is saved. Absolute encoders: the encoder's value, not
    // the machine position that is made of it.
    void rests(unsigned axis, double position) noexcept;
    bool strays(unsigned axis, double position, double distance) const noexcept {
        return !known_[axis] || std::fabs(position - kept_[axis]) > distance;
    }
    // What is due goes to the store as far as its ring has room; the table shows it too.
    void send(params::Table& table, StoreLink& store) noexcept;
    bool operated(unsigned channel) const noexcept { return operated_[channel]; }

private:
    static constexpr std::size_t kNumbers = static_cast<std::size_t>(kPowerOnTime) + 1;
    double& value(Counter counter, unsigned channel) noexcept {
        return values_[static_cast<std::size_t>(counter_number(counter, channel + 1))];
    }
    std::array<double, kNumbers> values_{}, shown_{};
    std::bitset<kNumbers> due_;
    std::bitset<kMaxChannels> operated_;
    std::array<double, kMaxAxes> position_{}, kept_{};
    std::bitset<kMaxAxes> moved_, known_;
};

}  // namespace polyturn::kernel
