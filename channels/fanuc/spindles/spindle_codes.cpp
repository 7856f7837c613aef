// Spindles in their closed loop (nct_parameters_part1 9): M19, codes that turn by an angle (N0820),
// addresses (N0817).
//
//   M19 or N0823  ->  closed  --M(m+i-1): i times the basic angle; C90.: to an angle-->  closed
//   M3, M4, M5    ->  open: neither may be programmed. Codes of N0689 to N0690 may do either; the
//                 machine is asked then.
#include "channels/fanuc/spindles/spindle_codes.hpp"

#include <cmath>

#include "channels/fanuc/execution.hpp"

namespace polyturn::channels::fanuc {

// M3, M4, M5 and M19 mean the spindle that was named last (N0605), otherwise the channel's.
unsigned spindle_of_codes(const Execution& x) {
    return x.core.path.named.spindle ? x.core.path.named.spindle : x.core.path.spindle.spindle;
}

// Each spindle has codes of its own; where two have the same, the one that M19 means.
const Settings::Indexing* indexing_of(const Execution& x, double code) {
    const Settings::Indexing* found = nullptr;
    for (const Settings::Indexing& turns : x.settings.indexing) {
        if (code < turns.first || code >= turns.first + turns.count) continue;
        if (!found || turns.spindle == spindle_of_codes(x)) found = &turns;
    }
    return found;
}

void note_loop(Execution& x, double code) {
    const unsigned spindle = spindle_of_codes(x);
    if (spindle == 0 || spindle > kMaxSpindles) return;
    const params::Table& table = x.core.view().table();
    const auto closes =
        static_cast<double>(params::get(table, params::n0823_m_code_for_closing_s_loop, spindle));
    const auto low = static_cast<double>(params::get(table, params::n0689_spindle_m_low, spindle)),
               high =
                   static_cast<double>(params::get(table, params::n0690_spindle_m_high, spindle));
    SpindleLoop& loop = x.machine.turned[spindle].loop;
    if (code == 3 || code == 4 || code == 5)
        loop = SpindleLoop::Open;
    else if (code == 19 || (code > 0 && code == closes))
        loop = SpindleLoop::Closed;
    else if (code > 0 && code >= low && code <= high)
        loop = SpindleLoop::Unknown;
}

// 8.2: ORI is the condition of everything that orients, by M19 or in a cycle.
bool can_orient(Execution& x, unsigned spindle) {
    if (spindle == 0 || spindle > kMaxSpindles ||
        params::bit(x.core.view().table(), params::n0607_spindle_config, spindle, 1))
        return true;
    return x.core.fail(Alarm::SpindleCannotClose, 'M', "S" + std::to_string(spindle));
}

// Every spindle keeps its own angle; the core knows that of the channel's.
bool turn_spindle(Execution& x, unsigned spindle, double degrees, bool incremental, bool closed,
                  double rpm) {
    if (spindle == 0 || spindle > kMaxSpindles) return x.core.fail(Alarm::SpindleMissing, 'M');
    TurnedSpindle& turned = x.machine.turned[spindle];
    if (turned.loop == SpindleLoop::Open)
        return x.core.fail(Alarm::SpindleNotClosed, 'M', "S" + std::to_string(spindle));
    const bool own = spindle == x.core.path.spindle.spindle;
    const double others = x.core.path.spindle.angle_deg;
    if (!own) x.core.path.spindle.angle_deg = turned.angle_deg;
    const bool good = x.core.spindle_angle(spindle, degrees, incremental, closed, rpm);
    const double angle = std::fmod(incremental ? turned.angle_deg + degrees : degrees, 360.0);
    turned.angle_deg = angle < 0 ? angle + 360.0 : angle;
    if (!own) x.core.path.spindle.angle_deg = others;
    return good;
}

}  // namespace polyturn::channels::fanuc
