// The record in front of which the path is stopped, from its beginning to its end; and what single
// kinds of records keep meanwhile.
#pragma once
#include <cstdint>

namespace polyturn::kernel {

// A move that ends before its target (G31, G31 P98).
struct SkipMove {
    bool came = false;    // the signal of the last skip move
    bool ending = false;  // the path brakes because of it
    bool torque_given = false;
};

// A rendezvous, from arrival to release. `passing`: a flying one has arrived and drives on; `owed`:
// it was passed before the partners arrived, and the path is stopped behind it until they do.
struct WaitStep {
    bool released = false, passing = false, judged = false, owed = false;
    std::uint32_t warned = 0;  // partners of this wait that were reported to the operator
    std::int64_t since = 0;

    void begin(std::int64_t tick) noexcept {
        since = tick;
        warned = 0;
        judged = false;
    }
};

// M, S and T that the PLC has.
struct Handshake {
    std::int32_t strobe = 0;
    std::int32_t m_code = -1;  // given to the PLC last; -1 none
    bool unfinished = false;   // the code before runs asynchronously to the program
    // this function has begun while the rapid move before it still brakes (N0421 ROL)
    std::uint64_t early = ~0ull;
};

struct DwellStep {
    // broken: what was left of the one that the interrupt signal broke off
    double left = 0, broken = 0;
    std::int64_t since = 0;  // tick at which it began
};

// How far it has come.
enum class RecordPhase : std::uint8_t {
    None,
    Dwell,
    Handshake,
    Waiting,
    Stopped,
    Thread,
    Spindle,
    Home,
    Released
};

struct StandingRecord {
    RecordPhase phase = RecordPhase::None;
    bool begun = false;  // it has reported its beginning
    std::int64_t since = 0;
    bool passes_stop = false;          // it is an M01 whose key was off when it began
    bool goes_on = false;              // a start has come for the stop
    std::uint64_t tool_shown = ~0ull;  // first-part mode has stopped before it
    DwellStep dwell;
    SkipMove skip;
    WaitStep wait;
    Handshake handshake;

    // What was pushed is void, and with it what it had begun.
    void forget() noexcept {
        phase = RecordPhase::None;
        begun = wait.released = wait.passing = skip.ending = false;
        handshake.early = ~0ull;
    }
};

}  // namespace polyturn::kernel
