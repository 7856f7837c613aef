// Shares of an axis' own limits: VELO<place>, ACC<place>, JERK<place> for the path, OVRA<place> for
// the feed of a positioning axis, OVRS<number> for the speed of a spindle; 1 is all of it. PATHTOL
// is the tolerance of corners in mm, SQUARE the turn in degrees from which on a corner is driven
// exactly; a negative value: as the machine has it. They hold from the next move on, until the
// program ends.
#include <algorithm>
#include <charconv>
#include <numbers>

#include "channels/records/record_sink.hpp"

namespace polyturn::channels {

bool RecordSink::takes_share(std::string_view name, double value) {
    const auto number_behind = [&](std::string_view word, unsigned& number) {
        if (name.substr(0, word.size()) != word) return false;
        const char* const end = name.data() + name.size();
        return std::from_chars(name.data() + word.size(), end, number).ptr == end;
    };
    unsigned i = 0;
    if (number_behind("OVRS", i) && i <= kMaxSpindles) {
        shares_.spindle[i] = value;
        return true;
    }
    if (name == "PATHTOL") {
        shares_.tolerance = value;
        return limits_forgotten_ = true;
    }
    if (name == "SQUARE") {
        shares_.square_turn =
            value < 0 ? PathLimits{}.square_turn : value * std::numbers::pi / 180.0;
        return limits_forgotten_ = true;
    }
    if (number_behind("OVRA", i) && i < view_->axis_count) {
        shares_.beside[i] = value;
        return true;
    }
    for (const auto& [word, shares] : {std::pair{std::string_view("VELO"), &shares_.velocity},
                                       std::pair{std::string_view("ACC"), &shares_.acceleration},
                                       std::pair{std::string_view("JERK"), &shares_.jerk}}) {
        if (!number_behind(word, i) || i >= view_->axis_count) continue;
        (*shares)[i] = value;
        limits_forgotten_ = true;  // taken over with the next move of the path
        return true;
    }
    return false;
}

// No axis becomes faster than the machine lets it; a transformation keeps the machine's limits.
const PathLimits& RecordSink::limits_of_path() {
    shared_limits_ = *drives_;
    if (shares_.tolerance >= 0) shared_limits_.tolerance = shares_.tolerance;
    shared_limits_.square_turn = shares_.square_turn;
    for (unsigned i = 0; i < view_->axis_count; ++i) {
        PathAxis& axis = shared_limits_.axis[view_->axes[i].machine_axis];
        const double v = std::min(1.0, shares_.velocity[i]);
        axis.rapid *= v;
        axis.feed *= v;
        axis.accel *= shares_.acceleration[i];
        axis.normal *= shares_.acceleration[i];
        axis.jerk *= shares_.jerk[i];
    }
    return shared_limits_;
}

}  // namespace polyturn::channels
