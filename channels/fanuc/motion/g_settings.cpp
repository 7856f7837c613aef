// Handlers of settings: units, plane, feed mode, zeros, coordinate setting, dwell.
#include <array>
#include <cmath>
#include <limits>

#include "channels/fanuc/interpreter.hpp"
#include "channels/state/tip_control.hpp"
#include "channels/state/zero_rows.hpp"
#include "ipc/kinematics/five_axis.hpp"

namespace polyturn::channels::fanuc {

bool Interpreter::g_nothing(const GCode& row) {
    if (row.tenths == 110) {
        parameter_input_ = false;
        life_ = {};
    }
    return true;
}

bool Interpreter::g_units(const GCode& row) {
    const bool inch = row.tenths == units_code(true);
    if (inch == inch_) return true;
    inch_ = inch;
    unit_ = inch ? 25.4 : 1.0;
    return true;
}

bool Interpreter::g_plane(const GCode& row) {
    const Plane before = core_.path.plane;
    const Plane plane = row.tenths == 170 ? Plane::XY : row.tenths == 180 ? Plane::ZX : Plane::YZ;
    if (plane != before && core_.compensating()) return core_.fail(Alarm::CompPlaneChanged, 'G');
    core_.path.plane = plane;
    if (before != core_.path.plane) core_.path.after_thread = false;
    return true;
}

bool Interpreter::g_distance(const GCode& row) {
    absolute_ = row.tenths == 900;
    return true;
}

bool Interpreter::g_feed_mode(const GCode& row) {
    const FeedMode mode =
        row.tenths == 990 || row.tenths == 950 ? FeedMode::PerRevolution : FeedMode::PerMinute;
    if (mode == core_.path.feed_mode) return true;
    core_.path.feed_mode = mode;
    // A number of the other kind would be a thousand times too fast: F must be programmed again.
    core_.path.feed =
        mode == FeedMode::PerRevolution ? settings_.feed_per_revolution : settings_.feed_per_minute;
    return true;
}

bool Interpreter::g_exact_stop(const GCode& row) {
    core_.path.exact_stop_mode = row.tenths == 610 || row.tenths == 600;
    // #3004 outlasts G64
    core_.path.override_locked = row.tenths == 630 || (automatic_control_ & 2) != 0;
    const std::uint32_t before = control_bits();
    active_[static_cast<std::size_t>(GGroup::ExactStop)] = &row;
    if (control_bits() != before) tell_control();
    return true;
}

bool Interpreter::g_exact_once(const GCode&) {
    core_.force_exact_stop();
    return true;
}

// P means another G code of the block (G70 P Q, G4 P, a drilling cycle that drills here): it is not
// the axis of G96 as well.
bool Interpreter::surface_shares_p() const {
    for (std::size_t group = 0; group < coded_.size(); ++group)
        if (group != static_cast<std::size_t>(GGroup::Surface) && coded_groups_ >> group & 1u &&
            takes_[static_cast<std::size_t>(coded_[group] - g_codes().data())] & letter_bit('P'))
            return true;
    const bool one_shot = coded_groups_ >> static_cast<unsigned>(GGroup::OneShot) & 1u;
    return drilling_ && !one_shot && (axis_word_count_ || block_.has('R'));
}

// P of G96 names the axis whose place is the radius: by its number in nct, by its place in the
// channel elsewhere. P0 and G96 without P mean the parameter's axis (N0687, "default").
bool Interpreter::g_surface(const GCode& row) {
    if (row.tenths != 960) return core_.surface_speed(false);
    bool own = block_.has('P') && !surface_shares_p();
    for (unsigned k = 0; k < m_count_; ++k) {  // nor where an M code takes it
        const double code = block_.words[m_words_[k]].value;
        own = own && code != 98 && code != 99 && code != 198 && code != settings_.interrupt.on &&
              !core_.view().machine.is_wait_code(code);
    }
    std::int64_t number = 0;
    if (own && !whole('P', number)) return false;
    int place = -1;
    for (unsigned i = 0; number != 0 && i < core_.view().axis_count; ++i)
        if ((settings_.nct ? core_.view().axes[i].machine_axis : i) + 1u ==
            static_cast<std::uint64_t>(number))
            place = static_cast<int>(i);
    if (number != 0 && (place < 0 || core_.view().axes[static_cast<std::size_t>(place)].rotary))
        return core_.fail(Alarm::CycleValueIllegal, 'P', "P", static_cast<double>(number));
    return core_.surface_axis_is(place) && core_.surface_speed(true);
}

bool Interpreter::g_comp_on(const GCode& row) {
    if (block_.has('D') && !radius_offset()) return false;
    if (reads_contour_) return true;
    if (!core_.compensating()) comp_moves_ = core_.moves();
    // The block right behind the one that begins must go on on its side (fanuc_lathe 3.9).
    else if (!settings_.nct && core_.holds_block() && core_.moves() == comp_moves_ + 1 &&
             row.tenths != comp_code_)
        return core_.fail(Alarm::CompSideAtBegin, 'G');
    comp_code_ = row.tenths;
    return core_.compensation(row.tenths == 410 ? CompSide::Left : CompSide::Right);
}

// I, K tell how the contour would go on; in an arc they are its centre.
bool Interpreter::g_comp_off(const GCode&) {
    const GCode* motion = coded_groups_ >> static_cast<unsigned>(GGroup::Motion) & 1u
                              ? coded_[static_cast<std::size_t>(GGroup::Motion)]
                              : motion_;
    if (motion->act == &Interpreter::g_arc) return core_.compensation_off(0.0, 0.0);
    // by plane: first, second axis
    static constexpr char kWish[3][2] = {{'I', 'J'}, {'K', 'I'}, {'J', 'K'}};
    const auto& letters = kWish[static_cast<std::size_t>(core_.path.plane)];
    return core_.compensation_off(radius_length(letters[0]), radius_length(letters[1]));
}

bool Interpreter::g_zero(const GCode& row) {
    core_.select_zero(kZeroG54Row + (row.tenths - 540) / 10);
    return true;
}

bool Interpreter::g_zero_extended(const GCode&) {
    std::int64_t number = 1;
    if (block_.has('P') && !whole('P', number)) return false;
    if (number < 1 || number > 300)
        return core_.fail(Alarm::OffsetNumberIllegal, 'P', {}, static_cast<double>(number), 300);
    core_.select_zero(kZeroG541Row + static_cast<std::int32_t>(number));
    return true;
}

// G54.2 Pn: the n-th fixture offset, which turns with the table (N3200 2 or 3); P0: none. Nothing
// moves.
bool Interpreter::g_fixture(const GCode&) {
    std::int64_t number = 0;
    if (!block_.has('P')) return core_.fail(Alarm::CycleWordMissing, 'G', "P");
    if (!whole('P', number)) return false;
    if (number > static_cast<std::int64_t>(kFixtureRows.size()))
        return core_.fail(Alarm::OffsetNumberIllegal, 'P', {}, static_cast<double>(number),
                          static_cast<double>(kFixtureRows.size()));
    if (core_.reads_ahead()) return core_.fail(Alarm::TransformPlace, 'G', "G41 G42");
    if (number == 0) {
        core_.fixture_off();
        return true;
    }
    if (core_.transformed()) return core_.fail(Alarm::TransformPlace, 'G', "G54.2");
    Transformation described;
    if (!describe_head(core_, false, described)) return false;
    FixtureOffset fixture;
    fixture.table = described.kinematics;
    const auto turns_part = [&](std::size_t head, std::size_t direction) {
        return fixture.table.value[head] == 0 && five_axis::exists(fixture.table, direction);
    };
    if (!turns_part(five_axis::kFirstIsHead, five_axis::kFirstDirection) &&
        !turns_part(five_axis::kSecondIsHead, five_axis::kSecondDirection))
        return core_.fail(Alarm::FiveAxisUndefined, 'G', "N3200: a head turns no workpiece");
    const MachineView& view = core_.view();
    const double* const row =
        view.store->zeros.data() +
        static_cast<std::size_t>(kFixtureRows[static_cast<std::size_t>(number - 1)]) * kChannelAxes;
    constexpr std::array kRoles{PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t k = 0; k < 3; ++k) {
        // describe_head has found all three
        const auto place = static_cast<unsigned>(view.axis_by_role(kRoles[k]));
        fixture.measured[k] = view.from_shown(place, row[place]);
    }
    for (std::size_t r = 0; r < 2; ++r) {
        const std::uint8_t place = fixture.table.axis[3 + r];
        fixture.at_deg[r] = place == kNoPlace ? fixture.table.centre[3 + r] : row[place];
    }
    fixture.rotary_alone = params::bit(view.table(), params::n3212_5d_control, view.channel, 7);
    core_.set_fixture(fixture);
    return true;
}

// G22, G23: both sides must mean the same, so the path comes to rest.
bool Interpreter::g_stroke_area(const GCode& row) {
    const bool off = row.tenths == 230;
    const bool limits = axis_word_count_ || block_.has('I') || block_.has('J') || block_.has('K');
    if (limits && !stroke_limits()) return false;
    wants_barrier_ = wants_barrier_ || limits;
    if (off == core_.path.stroke2_off) return true;
    core_.path.stroke2_off = off;
    core_.signal("STROKE2", off ? 0.0 : 1.0);
    wants_barrier_ = true;
    return true;
}

// G25, G26: supervision of the spindle's speed. Q R are percents; P is a time, seconds in nct and
// milliseconds elsewhere; the absolute limit is D in nct and I elsewhere. What is not programmed is
// the parameter's.
bool Interpreter::g_spindle_watch(const GCode& code) {
    if (code.tenths == 250) return core_.spindle_watch(false);
    if (const char foreign = settings_.nct ? 'I' : 'D'; block_.has(foreign))
        return core_.fail(Alarm::AddressIllegal, foreign, std::string(1, foreign));
    std::array<double, 4> values;
    const char letters[] = {'P', 'Q', 'R', settings_.nct ? 'D' : 'I'};
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = block_.has(letters[i]) ? block_.value(letters[i])
                                           : std::numeric_limits<double>::quiet_NaN();
        if (values[i] < 0)
            return core_.fail(Alarm::NegativeSign, letters[i], std::string(1, letters[i]));
    }
    if (!settings_.nct) values[0] *= 1e-3;
    return core_.spindle_watch(true, values);
}

// G50 (system A), G92: the present point gets the programmed coordinates, or the spindle its
// highest speed.
bool Interpreter::g_preset(const GCode&) {
    if (!axis_word_count_) {
        if (!block_.has('S')) return core_.fail(Alarm::CycleWordMissing, 'G', "S");
        return true;  // S was taken as the limit already
    }
    // no motion: the offset called here belongs to the point (fanuc_lathe 1.4)
    if (block_.has('T')) core_.take_wanted();
    for (unsigned k = 0; k < axis_word_count_; ++k) {
        const Word& word = block_.words[axis_words_[k]];
        const auto [place, incremental] = axis_of(word);
        const auto i = static_cast<unsigned>(place);
        const double value = length(word, place) * (core_.view().axes[i].diameter ? 0.5 : 1.0);
        if (incremental)
            core_.preset_by(i, value);
        else
            core_.preset(i, value);
    }
    return true;
}

// G10.9 X0: X words are radii from here on; X1: diameters. In nct an axis is switched by the
// program or by the PLC (N0106 MGD).
bool Interpreter::g_diameter(const GCode&) {
    if (axis_word_count_ == 0) return core_.fail(Alarm::CoordinateAxisNone, 'G', "G10.9");
    for (unsigned k = 0; k < axis_word_count_; ++k) {
        const Word& word = block_.words[axis_words_[k]];
        const int place = axis_of(word).place;
        if (settings_.nct &&
            !params::bit(core_.view().table(), params::n0106_axis_properties,
                         core_.view().axes[static_cast<std::size_t>(place)].machine_axis + 1u, 5)) {
            fault_column_ = word.column;
            fault_length_ = word.length;
            return core_.fail(Alarm::AddressIllegal, 0,
                              std::string(text_of(word)) + " (N0106 MGD = 0)");
        }
        if (word.value != 0 && word.value != 1)
            return core_.fail(Alarm::CycleValueIllegal, word.address, std::string(1, word.address),
                              word.value);
        core_.view().axes[static_cast<std::size_t>(place)].diameter = word.value == 1;
    }
    return true;
}

// G50.3, G92.1: the named axes count from their work zero again, as if G50 and G52 had not been.
bool Interpreter::g_preset_off(const GCode& row) {
    for (unsigned k = 0; k < axis_word_count_; ++k) {
        const auto place = static_cast<unsigned>(axis_of(block_.words[axis_words_[k]]).place);
        core_.preset_by(place, core_.path.preset[place]);
        core_.local_zero(place, 0.0);
    }
    return axis_word_count_ ? true
                            : core_.fail(Alarm::CoordinateAxisNone, 'G', std::string(row.name));
}

bool Interpreter::g_local_zero(const GCode&) {
    AxisSet named = 0;
    for (unsigned k = 0; k < axis_word_count_; ++k) {
        const Word& word = block_.words[axis_words_[k]];
        int place = word.axis >= 0 ? word.axis
                                   : absolute_axis_[static_cast<std::size_t>(word.address - 'A')];
        if (place < 0)
            return core_.fail(Alarm::AddressIllegal, word.address, std::string(1, word.address));
        const auto i = static_cast<unsigned>(place);
        named |= 1u << i;
        core_.local_zero(i, length(word, place) * (core_.view().axes[i].diameter ? 0.5 : 1.0));
    }
    return named ? true : core_.fail(Alarm::CoordinateAxisNone, 'G', "G52");
}

double Interpreter::seconds(const Word& word) const {
    if (word.address == 'P') {
        if (!settings_.dwell_p_milliseconds) return word.value;
        // thousandths
        return word.has_point && !word.from_expression ? word.value : word.value * 0.001;
    }
    return word.has_point || settings_.point_means_nothing || settings_.nct ? word.value
                                                                            : word.value * 0.001;
}

bool Interpreter::g_dwell(const GCode&) {
    char letter = 0;
    for (const char candidate : {'P', 'X', 'U'})
        if (block_.has(candidate)) letter = candidate;
    if (!letter) return core_.fail(Alarm::CycleWordMissing, 'G', "P");
    const Word& word = block_.word(letter);
    if (letter == 'P' && word.has_point && !word.from_expression && !settings_.nct)
        return core_.fail(Alarm::PointForbidden, 'P', "P");
    if (word.value < 0) return core_.fail(Alarm::NegativeSign, letter, std::string(1, letter));
    const bool revolutions =
        settings_.dwell_by_feed_mode && core_.path.feed_mode == FeedMode::PerRevolution;
    std::string_view signal;
    if (block_.has('Q') && (signal = dwell_signal()).empty()) return false;
    return core_.dwell(seconds(word), revolutions, signal);
}

}  // namespace polyturn::channels::fanuc
