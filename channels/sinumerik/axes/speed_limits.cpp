// What the spindles may turn at: G25 S, G26 S, LIMS (sinumerik_part1 7.3, 7.5). The limits are
// setting data and hold for the programs that follow; S is kept as it was programmed, so that a
// spindle is as fast as asked when its limit goes up again.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {

bool Interpreter::limits_spindle_speed(const params::Row& row) {
    return row.number == "SD43210" || row.number == "SD43220" || row.number == "SD43230";
}

// Setting data of the spindle that is meant now.
double Interpreter::spindle_data(std::string_view name) const {
    if (core_.path.spindle.spindle == 0) return 0.0;
    const params::Row& row = *params::find(name);
    return core_.view()
        .table()
        .numbers[row.first_slot + (core_.path.spindle.spindle - 1u) * row.array];
}

void Interpreter::keep_spindle_data(std::string_view name, double value) {
    if (core_.path.spindle.spindle == 0) return;
    const params::Row& row = *params::find(name);
    const std::size_t slot = row.first_slot + (core_.path.spindle.spindle - 1u) * row.array;
    params::Table& table = *core_.view().parameters;
    undo([this, slot, before = table.numbers[slot]] {
        core_.view().parameters->numbers[slot] = before;
    });
    table.numbers[slot] = value;
    tell_speed_limit(row, slot, value);
}

// Setting data are everybody else's too when the machine comes here (7.3, 7.5), unless REDEF ...
// PRLOC has made them the program's own.
void Interpreter::tell_speed_limit(const params::Row& row, std::size_t slot, double value) {
    if (!limits_spindle_speed(row) ||
        std::find(program_local_.begin(), program_local_.end(), &row) != program_local_.end())
        return;
    core_.mark_emitted();
    core_.sink().parameter(fmt::format("{} S{}={}", row.number, slot - row.first_slot + 1, value),
                           core_.at);
}

// Of the spindle that is meant: G26 binds it always, LIMS the master spindle under G96, G961, G962
// and G97; 0: no limit.
double Interpreter::highest_speed() const {
    const double most = spindle_data("SD43220");
    const bool lims = core_.path.spindle.spindle == modal_.master_spindle &&
                      (surface_speed_active() || active(15) == 5);
    const double under_surface = lims ? spindle_data("SD43230") : 0.0;
    if (most <= 0 || under_surface <= 0) return std::fmax(most, under_surface);
    return std::fmin(most, under_surface);
}

double Interpreter::limited_speed(double rpm) const {
    if (rpm <= 0) return rpm;
    const double most = highest_speed(), least = std::fmax(rpm, spindle_data("SD43210"));
    return most > 0 ? std::fmin(least, most) : least;
}

// A speed in revolutions is asked of the spindle that is meant.
bool Interpreter::ask_speed(double rpm) {
    modal_.asked_rpm[core_.path.spindle.spindle] = rpm;
    return refresh_speed_limit() && core_.spindle_speed(limited_speed(rpm));
}

// `said`: the block names a limit. A speed in revolutions is limited here, so that the machine need
// not hear of the rest.
bool Interpreter::refresh_speed_limit(bool said) {
    SpindleState& spindle = core_.path.spindle;
    const double most = highest_speed(),
                 least = spindle.spindle == 0 ? 0.0 : spindle_data("SD43210");
    if (least != spindle.least_rpm && !core_.spindle_least(least)) return false;
    if (spindle.spindle == 0 || most == spindle.limit_rpm) return true;
    if (said || spindle.mode == SpindleModeCode::SurfaceSpeed) return core_.spindle_limit(most);
    spindle.limit_rpm = most;
    return true;
}

// A limit has changed, or whether it acts: the spindle that is meant turns as it may now.
bool Interpreter::refresh_speed(bool said) {
    const SpindleState& spindle = core_.path.spindle;
    if (!refresh_speed_limit(said)) return false;
    if (spindle.spindle == 0 || spindle.mode == SpindleModeCode::SurfaceSpeed) return true;
    const double rpm = limited_speed(modal_.asked_rpm[spindle.spindle]);
    return rpm <= 0 || rpm == spindle.rpm || core_.spindle_speed(rpm);
}

// LIMS: the highest speed under G96, G961, G97; never above that of G26.
bool Interpreter::a_limit(const Word& word) {
    constexpr std::ptrdiff_t kMostLimits = 4;  // in a block (7.3)
    if (std::count_if(block_.words.begin(), block_.words.end(), [&](const Word& other) {
            return other.address == word.address;
        }) > kMostLimits)
        return fail_word(Alarm::FunctionsTooMany, word, "LIMS");
    return with_spindle(word.index > 0 ? static_cast<std::uint16_t>(word.index) : 0, [&] {
        keep_spindle_data("SD43230", word.number());
        return refresh_speed(true);
    });
}

// G25 S, G26 S.
bool Interpreter::limit_speed(const Word& word, bool high) {
    return with_spindle(word.index > 0 ? static_cast<std::uint16_t>(word.index) : 0, [&] {
        keep_spindle_data(high ? "SD43220" : "SD43210", word.number());
        return refresh_speed(true) && core_.commit_spindle();
    });
}

}  // namespace polyturn::channels::sinumerik
