// A program that is held: the question to its channel whether it can be taken back to a place, and
// the blocks that run by hand meanwhile (program/hold.hpp).
//
//              start, a block waits          its end                    start
//   Program ------------------------> Runs ----------> Done ----------------------> Program
//                                       ^---- start ----'  (taken back to `left`)
#pragma once
#include <cstdint>

namespace polyturn::kernel {

struct ResumePlace {           // in the program, of a path that rests
    std::uint64_t serial = 0;  // block; 0: behind everything that was pushed
    std::uint32_t part = 0;
    bool begun = false;
};

struct Resume {
    // Why the channel is asked: offsets have changed, a block is entered by hand, or it starts
    // where its axes were moved to.
    enum class BackFor : std::uint8_t { Change, ByHand, Away };
    enum class ByHand : std::uint8_t { Program, Runs, Done };

    std::uint64_t question = 0;  // AskResume that is not answered yet; 0 none
    // where it would go back to; where the program was left for a block by hand
    ResumePlace asked, left;
    BackFor asked_for = BackFor::Change;
    // Changes are to be asked about; a start waits for the answer. Both may be while another
    // question is open.
    bool change_due = false, start_wanted = false;
    bool aside = false;  // axes are moved by hand in the hold
    ByHand by_hand = ByHand::Program;

    bool runs_by_hand() const noexcept { return by_hand == ByHand::Runs; }
    // A block by hand has run, and the program is still held where it was left.
    bool program_left() const noexcept { return by_hand == ByHand::Done; }
    bool off_program() const noexcept { return by_hand != ByHand::Program; }
    void clear() noexcept {  // behind a reset
        asked_for = BackFor::Change;
        change_due = start_wanted = aside = false;
        by_hand = ByHand::Program;
        question = 0;
    }
};

}  // namespace polyturn::kernel
