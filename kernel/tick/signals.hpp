// All flags and registers between NC and PLC with their effective values: what the PLC wrote, or
// what operator and scenario force.
//
// A forced signal (set AP_SYNCR A3=1) holds until it is released, whatever its writer writes. Both
// directions can be forced, because a scenario may also stand in for the NC towards the PLC.
#pragma once
#include <array>
#include <bitset>
#include <cstdint>
#include <span>

#include "polyturn/image_structs.hpp"

namespace polyturn::kernel {

class Signals {
public:
    // What acts.
    std::int32_t plc(std::uint32_t slot) const noexcept { return plc_[slot]; }
    std::int32_t nc(std::uint32_t slot) const noexcept { return nc_[slot]; }
    bool input(std::size_t number) const noexcept { return input_[number]; }

    // The NC's own writes; a forced slot keeps its forced value.
    void set_nc(std::uint32_t slot, std::int32_t value) noexcept {
        if (!forced_nc_[slot]) nc_[slot] = value;
    }
    // The PLC's answer of one of its cycles.
    void take_plc(const PlcOutputs& outputs) noexcept {
        answered_ = outputs.signal;
        for (std::size_t i = 0; i < fast_count_; ++i) answered_[fast_[i].slot] = fast_[i].value;
        // nearly always: a copy of thousands of slots, not a decision for each
        if (forced_plc_.none()) {
            plc_ = answered_;
            return;
        }
        for (std::size_t i = 0; i < kPlcSignals; ++i)
            if (!forced_plc_[i]) plc_[i] = answered_[i];
    }
    // Of these the PLC's fast task is the only writer; what its cycle says of them does not count.
    void give_to_fast_task(std::span<const std::uint32_t> slots) noexcept {
        fast_count_ = 0;
        for (const std::uint32_t slot : slots)
            if (slot < kPlcSignals && fast_count_ < fast_.size())
                fast_[fast_count_++] = {slot, answered_[slot]};
    }
    // The n-th of them.
    void take_fast(std::size_t n, std::int32_t value) noexcept {
        if (n >= fast_count_) return;
        fast_[n].value = answered_[fast_[n].slot] = value;
        if (!forced_plc_[fast_[n].slot]) plc_[fast_[n].slot] = value;
    }
    std::uint32_t fast_slot(std::size_t n) const noexcept { return fast_[n].slot; }
    std::size_t fast_count() const noexcept { return fast_count_; }
    void force_plc(std::uint32_t slot, std::int32_t value) noexcept {
        forced_plc_[slot] = true;
        plc_[slot] = value;
    }
    void force_nc(std::uint32_t slot, std::int32_t value) noexcept {
        forced_nc_[slot] = true;
        nc_[slot] = value;
    }
    void release_plc(std::uint32_t slot) noexcept {
        forced_plc_[slot] = false;
        plc_[slot] = answered_[slot];
    }
    void release_nc(std::uint32_t slot) noexcept { forced_nc_[slot] = false; }
    // Forced until it is given back; sensors write what is not forced.
    void set_input(std::size_t number, bool on) noexcept {
        forced_input_[number] = true;
        input_[number] = on;
    }
    void release_input(std::size_t number) noexcept {
        forced_input_[number] = false;
        input_[number] = sensed_[number];
    }
    void sense(std::size_t number, bool on) noexcept {
        sensed_[number] = on;
        if (!forced_input_[number]) input_[number] = on;
    }

    void fill(PlcInputs& inputs) const noexcept {
        inputs.signal = nc_;
        for (std::size_t i = 0; i < kInputs; ++i) inputs.input[i] = input_[i];
    }
    void fill(PlcOutputs& seen) const noexcept { seen.signal = plc_; }

private:
    std::array<std::int32_t, kNcSignals> nc_{};
    std::array<std::int32_t, kPlcSignals> plc_{}, answered_{};
    std::bitset<kNcSignals> forced_nc_;
    std::bitset<kPlcSignals> forced_plc_;
    struct Fast {
        std::uint32_t slot;
        std::int32_t value;
    };
    std::array<Fast, kFastSignals> fast_{};
    std::size_t fast_count_ = 0;
    std::bitset<kInputs> input_, sensed_, forced_input_;
};

}  // namespace polyturn::kernel
