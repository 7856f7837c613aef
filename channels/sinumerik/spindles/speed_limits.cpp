// What the spindles may turn at: G25 S, G26 S, LIMS (sinumerik_part1 7.3, 7.5). The limits are
// setting data and hold for the programs that follow; S is kept as it was programmed, so that a
// spindle is as fast as asked when its limit goes up again.
#include "channels/sinumerik/spindles/speed_limits.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/grammar/groups.hpp"
#include "channels/sinumerik/spindles/cutting_speeds.hpp"
#include "channels/sinumerik/spindles/spindle_commands.hpp"
#include "channels/sinumerik/variables/changes.hpp"
#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// Setting data of the spindle that is meant now.
double spindle_data(const Execution& x, std::string_view name) {
    if (x.core.path.spindle.spindle == 0) return 0.0;
    const params::Row& row = *params::find(name);
    return x.core.view()
        .table()
        .numbers[row.first_slot + (x.core.path.spindle.spindle - 1u) * row.array];
}

void keep_spindle_data(Execution& x, std::string_view name, double value) {
    if (x.core.path.spindle.spindle == 0) return;
    const params::Row& row = *params::find(name);
    const std::size_t slot = row.first_slot + (x.core.path.spindle.spindle - 1u) * row.array;
    params::Table& table = *x.core.view().parameters;
    undo(x, [&x, slot, before = table.numbers[slot]] {
        x.core.view().parameters->numbers[slot] = before;
    });
    table.numbers[slot] = value;
    tell_speed_limit(x, row, slot, value);
}

// Of the spindle that is meant: G26 binds it always, LIMS the master spindle under G96, G961, G962
// and G97; 0: no limit.
double highest_speed(const Execution& x) {
    const double most = spindle_data(x, "SD43220");
    const bool lims = x.core.path.spindle.spindle == x.modal.master_spindle &&
                      (surface_speed_active(x) || active(x, 15) == 5);
    const double under_surface = lims ? spindle_data(x, "SD43230") : 0.0;
    if (most <= 0 || under_surface <= 0) return std::fmax(most, under_surface);
    return std::fmin(most, under_surface);
}

}  // namespace

bool limits_spindle_speed(const params::Row& row) {
    return row.number == "SD43210" || row.number == "SD43220" || row.number == "SD43230";
}

// Setting data are everybody else's too when the machine comes here (7.3, 7.5), unless REDEF ...
// PRLOC has made them the program's own.
void tell_speed_limit(Execution& x, const params::Row& row, std::size_t slot, double value) {
    if (!limits_spindle_speed(row) ||
        std::find(x.speed_limits.program_local.begin(), x.speed_limits.program_local.end(), &row) !=
            x.speed_limits.program_local.end())
        return;
    x.core.mark_emitted();
    x.core.sink().parameter(fmt::format("{} S{}={}", row.number, slot - row.first_slot + 1, value),
                            x.core.at);
}

double limited_speed(const Execution& x, double rpm) {
    if (rpm <= 0) return rpm;
    const double most = highest_speed(x), least = std::fmax(rpm, spindle_data(x, "SD43210"));
    return most > 0 ? std::fmin(least, most) : least;
}

// A speed in revolutions is asked of the spindle that is meant.
bool ask_speed(Execution& x, double rpm) {
    x.modal.asked_rpm[x.core.path.spindle.spindle] = rpm;
    return refresh_speed_limit(x) && x.core.spindle_speed(limited_speed(x, rpm));
}

// `said`: the block names a limit. A speed in revolutions is limited here, so that the machine need
// not hear of the rest.
bool refresh_speed_limit(Execution& x, bool said) {
    SpindleState& spindle = x.core.path.spindle;
    const double most = highest_speed(x),
                 least = spindle.spindle == 0 ? 0.0 : spindle_data(x, "SD43210");
    if (least != spindle.least_rpm && !x.core.spindle_least(least)) return false;
    if (spindle.spindle == 0 || most == spindle.limit_rpm) return true;
    if (said || spindle.mode == SpindleModeCode::SurfaceSpeed) return x.core.spindle_limit(most);
    spindle.limit_rpm = most;
    return true;
}

// A limit has changed, or whether it acts: the spindle that is meant turns as it may now.
bool refresh_speed(Execution& x, bool said) {
    const SpindleState& spindle = x.core.path.spindle;
    if (!refresh_speed_limit(x, said)) return false;
    if (spindle.spindle == 0 || spindle.mode == SpindleModeCode::SurfaceSpeed) return true;
    const double rpm = limited_speed(x, x.modal.asked_rpm[spindle.spindle]);
    return rpm <= 0 || rpm == spindle.rpm || x.core.spindle_speed(rpm);
}

// LIMS: the highest speed under G96, G961, G97; never above that of G26.
bool a_limit(Execution& x, const Word& word) {
    constexpr std::ptrdiff_t kMostLimits = 4;  // in a block (7.3)
    if (std::count_if(x.block.words.begin(), x.block.words.end(), [&](const Word& other) {
            return other.address == word.address;
        }) > kMostLimits)
        return fail_word(x, Alarm::FunctionsTooMany, word, "LIMS");
    return with_spindle(x, word.index > 0 ? static_cast<std::uint16_t>(word.index) : 0, [&] {
        keep_spindle_data(x, "SD43230", word.number());
        return refresh_speed(x, true);
    });
}

// G25 S, G26 S.
bool limit_speed(Execution& x, const Word& word, bool high) {
    return with_spindle(x, word.index > 0 ? static_cast<std::uint16_t>(word.index) : 0, [&] {
        keep_spindle_data(x, high ? "SD43220" : "SD43210", word.number());
        return refresh_speed(x, true) && x.core.commit_spindle();
    });
}

}  // namespace polyturn::channels::sinumerik
