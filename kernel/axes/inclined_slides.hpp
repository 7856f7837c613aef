// An inclined X slide moved without a program (fanuc_lathe 10.5): by hand and during referencing.
// The operator moves X at right angles; the slide drives along itself and moves Z with it, so that
// the tip stays at its Z.
//
//        slide  /|        X by d at right angles:  slide by d / cos(a),  Z by -d * tan(a)
//              / |  d     so travel s of the slide moves Z by -s * sin(a)
//             /a |
//   ---------+---+---> Z
//
// NOZAGC leaves Z where it is; so does F8200 AZR = 1 while the slide is being referenced. Programs
// do the same on their own (channels).
//
// Positions count from where both were when the motion began: nothing is summed up tick by tick,
// and the return ends where it began. Cost: a look at each axis a tick.
#pragma once
#include <array>
#include <cstdint>
#include <utility>

#include "kernel/tick/core.hpp"

namespace polyturn::kernel {

class InclinedSlides {
public:
    struct Slide {
        // axes from 1; 0: the channel has no inclined slide
        std::uint32_t angular = 0, square = 0;
        double cosine = 1, sine = 0;
        bool taken_home = false;  // AZR = 0: referencing the slide takes Z along
    };
    void configure(const params::Table& table, const KernelConfig& config) noexcept;

    // The axis (from 0) is an inclined slide; nullptr: it is not.
    const Slide* of(const Core& core, std::uint32_t axis) const noexcept;
    // The slide's motion begins: Z moves along until follow() is called at its end.
    // `always`: on the return from where it moved along, whatever NOZAGC is now.
    void begin(Core& core, std::uint32_t axis, bool always = false) noexcept;
    // New parameters wait for the end of a motion: it ends as it began.
    bool take_due() noexcept { return std::exchange(due_, false); }
    bool takes(std::uint32_t channel) const noexcept { return taken_[channel - 1].on; }
    // Channel (from 1) whose inclined slide takes this axis (from 0) along now; 0: none.
    std::uint32_t carrier(const Core& core, std::uint32_t axis) const noexcept;
    // After jogs and references have said where the slide goes, and what they call it since.
    // `over`: it does not move any more.
    void follow(Core& core, std::uint32_t channel, bool over) noexcept;
    // Referencing gave an axis (from 0) other numbers.
    void shifted(std::uint32_t axis, double by) noexcept;

private:
    struct Taken {
        bool on = false;
        double slide_from = 0, square_from = 0;
    };
    std::array<Slide, kMaxChannels> slides_{};
    std::array<Taken, kMaxChannels> taken_{};
    bool waits_ = false, due_ = false;  // parameters were not taken for a motion; it is over
};

}  // namespace polyturn::kernel
