// The parts that a channel's programs make, and how long they take.
#pragma once
#include <cstdint>

namespace polyturn::kernel {

// Of the program that runs; lit_s: since power-on.
struct CycleTimes {
    double cutting_s = 0, rapid_s = 0, waiting_s = 0, cycle_s = 0;
    double lit_s = 0;  // the cycle start lamp

    void begin() noexcept { cutting_s = rapid_s = waiting_s = cycle_s = 0; }
};

struct Production {
    std::uint32_t parts = 0;
    // of cycle time after which the program ends with its part; 0: none
    double warm_up_s = 0;
    // The operator has asked for the end behind this part; the part is made, and what is to follow
    // is void. The operator may ask again between the two.
    bool stops_after_part = false, ends_with_part = false;
    bool lap_ended = false;  // a part was made in this run
    // Parts, or runs of programs that count none: how many since a program was selected, how long.
    double part_from_s = 0, last_cycle_s = 0, cycles_s = 0;
    std::uint32_t cycles = 0;
    std::uint64_t blocks = 0;
    CycleTimes times;

    void begin() noexcept {  // of a program
        times.begin();
        part_from_s = 0;
        lap_ended = false;
        blocks = 0;
    }
    // A part, or a program that counts none, is over: how long it took.
    void end_lap() noexcept {
        const double took_s = times.cycle_s - part_from_s;
        if (took_s <= 0) return;
        lap_ended = true;
        part_from_s = times.cycle_s;
        last_cycle_s = took_s;
        cycles_s += took_s;
        ++cycles;
    }
    void forget_cycles() noexcept {  // another program is selected
        cycles = 0;
        cycles_s = last_cycle_s = 0;
    }
    double mean_cycle_s() const noexcept { return cycles ? cycles_s / cycles : 0.0; }
};

}  // namespace polyturn::kernel
