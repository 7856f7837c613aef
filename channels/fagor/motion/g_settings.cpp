// G codes that set how later words are read: units, plane, dimensions, feed and spindle mode,
// corners, mirror, scale, compensation, zones, zeros.
#include <cmath>

#include "channels/fagor/interpreter.hpp"
#include "ipc/machine/store/work_zeros.hpp"

namespace polyturn::channels::fagor {

bool Interpreter::g_units(const GCode& row) {
    modal_.inch = row.number == 70;
    return true;
}

bool Interpreter::g_x_format(const GCode& row) {
    modal_.diameter = row.number == 151;
    show_diameter();
    return true;
}

bool Interpreter::g_plane(const GCode& row) {
    if (modal_.comp != 40 && row.number != modal_.plane)
        return core_.fail(Alarm::CompPlaneChanged, 'G');
    if (row.number == modal_.plane) return true;  // no change: the polar origin stays (3.6.2)
    modal_.plane = row.number;
    core_.path.plane = static_cast<Plane>(row.number - 17);
    core_.path.plane_p = core_.path.plane_q = -1;
    reset_polar_origin();
    return true;
}

// G16: the axes as they are named, first the abscissa; written as X.. words without numbers.
bool Interpreter::g_plane_of_axes(const GCode&) {
    if (modal_.comp != 40) return core_.fail(Alarm::CompPlaneChanged, 'G');
    int first = -1, second = -1;
    for (unsigned k = 0; k < block_.count; ++k) {
        const Word& word = block_.words[k];
        if (word.letter == 'G') continue;
        const int place = place_[static_cast<std::size_t>(word.letter - 'A')];
        if (place < 0 || word.given || second >= 0)
            return fail_word(word, Alarm::AddressIllegal, std::string(1, word.letter));
        (first < 0 ? first : second) = place;
    }
    if (second < 0) return core_.fail(Alarm::FagorMotionWord, 'G', "two axes", 16);
    modal_.plane = 16;
    core_.path.plane = Plane::ZX;
    core_.path.plane_p = static_cast<std::int8_t>(first);
    core_.path.plane_q = static_cast<std::int8_t>(second);
    reset_polar_origin();
    return true;
}

bool Interpreter::g_distance(const GCode& row) {
    modal_.absolute = row.number == 90;
    return true;
}

bool Interpreter::g_feed_mode(const GCode& row) {
    modal_.feed_code = row.number;
    return true;
}

bool Interpreter::g_spindle_mode(const GCode& row) {
    if (row.number == 97) return core_.surface_speed(false) && limit_surface_speed();
    bool gear = settings_.gear_automatic || modal_.gear != 0;
    for (unsigned k = 0; k < m_count_; ++k)
        if (m_words_[k]->value >= 41 && m_words_[k]->value <= 44) gear = true;
    if (!gear) return core_.fail(Alarm::FagorGear, 'G', "M41 to M44");
    if (!has('S') && core_.path.spindle.surface_m_min <= 0)
        return core_.fail(Alarm::FagorGear, 'G', "S");
    return core_.surface_speed(true) && limit_surface_speed();
}

// Constant surface speed keeps to G92 S and to the gear (5.3.1); otherwise S words are what they
// clamp.
// `said`: by G92 S itself, which is told even where nothing changes here: the spindle may have been
// commanded without a limit since.
bool Interpreter::limit_surface_speed(bool said) {
    const bool surface = core_.path.spindle.mode == SpindleModeCode::SurfaceSpeed;
    const double gear = surface ? gear_limit() : 0.0;
    const double limit = gear > 0 && (modal_.speed_limit <= 0 || gear < modal_.speed_limit)
                             ? gear
                             : modal_.speed_limit;
    return (!said && limit == core_.path.spindle.limit_rpm) || core_.spindle_limit(limit);
}

bool Interpreter::g_corner(const GCode& row) {
    modal_.corner = row.number;
    core_.path.exact_stop_mode = row.number == 7;
    look_ahead(100.0, -1.0, -1.0);
    return true;
}

// G51 A: percent of the axes' own acceleration, until another corner function (7.4). A may be up to
// 255; the path gets no more than the machine's own value all the same: what lies beyond N0400 its
// drives do not follow. E: how far the path may leave a corner; B: a corner whose angle between its
// blocks is smaller is a square one.
void Interpreter::look_ahead(double percent, double error_mm, double square_deg) {
    if (percent != modal_.acceleration)
        for (unsigned i = 0; i < core_.view().axis_count; ++i)
            core_.signal("ACC" + std::to_string(i), std::fmin(1.0, percent / 100.0));
    if (error_mm != modal_.look_ahead_error) core_.signal("PATHTOL", error_mm);
    if (square_deg != modal_.square_angle)
        core_.signal("SQUARE", square_deg < 0 ? -1.0 : 180.0 - square_deg);
    modal_.acceleration = percent;
    modal_.look_ahead_error = error_mm;
    modal_.square_angle = square_deg;
}

bool Interpreter::g_look_ahead(const GCode& row) {
    if (m_count_ || has_positioning_axes("AB") || (letters_ & letter_set("FSTD")))
        return core_.fail(Alarm::FagorAlone, 'G', "G51");
    if (!has('E')) return core_.fail(Alarm::FagorMotionWord, 'G', "E", 51);
    if (number('A') < 0 || number('A') > 255)
        return core_.fail(Alarm::FagorValueRange, 'A', "A", number('A'));
    if (number('E') < 0) return core_.fail(Alarm::FagorValueRange, 'E', "E", number('E'));
    if (number('B') < 0 || number('B') > 180)
        return core_.fail(Alarm::FagorValueRange, 'B', "B", number('B'));
    // The advanced algorithm (bit 15) excludes the doubled interpolation period (7.4).
    if ((settings_.look_ahead_kind & 0x8000) != 0 && settings_.interpolation_period == 1)
        return core_.fail(Alarm::FagorIncompatible, 'G', "FG.LOOKATYP FG.IPOTIME");
    if (modal_.feed_code == 95 || modal_.motion >= 33)
        return core_.fail(Alarm::FagorIncompatible, 'G',
                          modal_.feed_code == 95 ? "G51 G95" : "G51 and a thread");
    modal_.corner = row.number;
    look_ahead(number('A') > 0 ? number('A') : 100.0, distance('E'), has('B') ? number('B') : -1.0);
    core_.path.exact_stop_mode = false;
    return true;
}

// Mirror about the part zero and scale are one frame: the numbers that are programmed lie inside of
// it (7.5, 7.6).
void Interpreter::refresh_frame() {
    const MachineView& view = core_.view();
    double factors[3] = {modal_.scale, modal_.scale, modal_.scale};
    Frame frame;
    for (unsigned i = 0; i < view.axis_count; ++i) {
        double factor = modal_.axis_scale[i] == 0.0 ? 1.0 : modal_.axis_scale[i];
        if (modal_.mirrored >> i & 1u) factor = -factor;
        switch (view.axes[i].role) {
            case PlaneRole::BasicX:
                factors[0] *= factor;
                break;
            case PlaneRole::BasicY:
                factors[1] *= factor;
                break;
            case PlaneRole::BasicZ:
                factors[2] *= factor;
                break;
            default:
                frame = Frame::scaling(i, factor * modal_.scale) * frame;
                break;
        }
    }
    // Those of single axes multiply what compensation has made of the path.
    AxisValues behind{};
    for (unsigned i = 0; i < view.axis_count; ++i)
        behind[i] = modal_.axis_scale[i] == 0.0 ? 1.0 : modal_.axis_scale[i];
    core_.set_factors(behind, Frame::scaling({factors[0], factors[1], factors[2]}) * frame);
}

bool Interpreter::g_mirror(const GCode& row) {
    if (scanning_) return scan_over_ = true;  // what comes behind lies in another system
    if (row.number == 10) {
        modal_.mirrored = 0;
        refresh_frame();
        return true;
    }
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t k = 0; k < 3; ++k) {
        if (!(mirrors_ >> k & 1u)) continue;
        const int place = core_.view().axis_by_role(kRoles[k]);
        if (place < 0)
            return core_.fail(Alarm::CoordinateAxisNone, 'G',
                              std::string("G1") + static_cast<char>('1' + k));
        modal_.mirrored |= 1u << place;
    }
    refresh_frame();
    return true;
}

bool Interpreter::g_mirror_axes(const GCode&) {
    if (scanning_) return scan_over_ = true;  // what comes behind lies in another system
    if (!has_axes()) return core_.fail(Alarm::CoordinateAxisNone, 'G', "G14");
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (axis_words_[i]) modal_.mirrored |= 1u << i;
    refresh_frame();
    return true;
}

bool Interpreter::g_scale(const GCode&) {
    if (scanning_) return scan_over_ = true;  // what comes behind lies in another system
    if (has('S')) {
        if (has_axes()) return core_.fail(Alarm::AddressIllegal, 'S', "S");
        if (number('S') <= 0) return core_.fail(Alarm::FagorValueRange, 'S', "S", number('S'));
        modal_.scale = number('S');
        refresh_frame();
        return true;
    }
    if (!has_axes()) return core_.fail(Alarm::FagorMotionWord, 'G', "S or an axis", 72);
    for (unsigned i = 0; i < core_.view().axis_count; ++i) {
        if (!axis_words_[i]) continue;
        if (axis_words_[i]->value <= 0)
            return fail_word(*axis_words_[i], Alarm::FagorValueRange, core_.view().axes[i].name,
                             axis_words_[i]->value);
        modal_.axis_scale[i] = axis_words_[i]->value;
    }
    refresh_frame();
    return true;
}

// The block names axes, but no way: G91 G40 X0 under a modal G03 ends compensation where the tool
// stands (8.2.6).
bool Interpreter::at_standstill() {
    AxisValues target{};
    if ((letters_ & letter_set("IJKQR")) || !read_point(target, nullptr)) return false;
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (target[i] != core_.path.programmed[i]) return false;
    return true;
}

bool Interpreter::g_comp(const GCode& row) {
    if (scanning_) {  // what comes behind is no part of the contour
        scan_over_ = true;
        return true;
    }
    const std::uint16_t motion = coded(GGroup::Motion)
                                     ? coded_[static_cast<std::size_t>(GGroup::Motion)]->number
                                     : modal_.motion;
    if (row.number == 40) {
        if (modal_.comp != 40 && (motion == 2 || motion == 3) && !at_standstill())
            return core_.fail(Alarm::CompArcStartEnd, 'G');
        modal_.comp = 40;
        modal_.collision_blocks = 0;
        loops_.clear();
        scanned_to_ = 0;
        return core_.compensation_off(0.0, 0.0);
    }
    if (modal_.comp == 40 && (motion == 2 || motion == 3))
        return core_.fail(Alarm::CompArcStartEnd, 'G');
    if (coded(GGroup::OneShot) && coded_[static_cast<std::size_t>(GGroup::OneShot)]->number != 4)
        return core_.fail(
            Alarm::FagorIncompatible, 'G',
            "G" + std::to_string(coded_[static_cast<std::size_t>(GGroup::OneShot)]->number) + " G" +
                std::to_string(row.number));
    if (!settings_.comp_every_plane) {
        int p = -1, q = -1;
        core_.plane_axes(p, q);
        const MachineView& view = core_.view();
        if (p < 0 || q < 0 || view.axes[static_cast<std::size_t>(p)].role != PlaneRole::BasicZ ||
            view.axes[static_cast<std::size_t>(q)].role != PlaneRole::BasicX)
            return core_.fail(Alarm::FagorNotInPlane, 'G', "G" + std::to_string(row.number));
    }
    modal_.collision_blocks = 0;
    if (number_word_) {
        std::int64_t blocks = 0;
        if (!whole(*number_word_, blocks)) return false;
        if (blocks > 50)
            return fail_word(*number_word_, Alarm::FagorValueRange, "N",
                             static_cast<double>(blocks));
        modal_.collision_blocks = blocks >= 3 ? static_cast<int>(blocks) : 0;
    }
    loops_.clear();
    scanned_to_ = 0;
    scan_due_ = modal_.collision_blocks != 0;
    // the side is modal: what is active already begins nothing anew (8.2.3)
    if (modal_.comp == row.number) return true;
    modal_.comp = row.number;
    return core_.compensation(row.number == 41 ? CompSide::Left : CompSide::Right);
}

// --- work zones: limits are radii from machine zero (3.8)

bool Interpreter::g_zone_limit(const GCode& row) {
    if (!has('K')) return core_.fail(Alarm::FagorMotionWord, 'G', "K", row.number);
    std::int64_t zone = 0;
    if (!whole(*word('K'), zone)) return false;
    if (zone < 1 || zone > 4)
        return core_.fail(Alarm::FagorValueRange, 'K', "K", static_cast<double>(zone));
    if (!has_axes())
        return core_.fail(Alarm::CoordinateAxisNone, 'G', row.number == 20 ? "G20" : "G21");
    WorkZone& to = core_.path.zones[static_cast<std::size_t>(zone - 1)];
    for (unsigned i = 0; i < core_.view().axis_count; ++i) {
        if (!axis_words_[i]) continue;
        const double value = axis_words_[i]->value * (core_.view().axes[i].rotary ? 1.0 : unit());
        (row.number == 20 ? to.low : to.high)[i] = value;
        (row.number == 20 ? to.has_low : to.has_high) |= 1u << i;
    }
    return true;
}

bool Interpreter::g_zone(const GCode&) {
    for (const char letter : {'K', 'S'})
        if (!has(letter))
            return core_.fail(Alarm::FagorMotionWord, 'G', std::string(1, letter), 22);
    std::int64_t zone = 0, state = 0;
    if (!whole(*word('K'), zone) || !whole(*word('S'), state)) return false;
    if (zone < 1 || zone > 4)
        return core_.fail(Alarm::FagorValueRange, 'K', "K", static_cast<double>(zone));
    if (state > 2) return core_.fail(Alarm::FagorValueRange, 'S', "S", static_cast<double>(state));
    core_.path.zones[static_cast<std::size_t>(zone - 1)].guard =
        static_cast<WorkZone::Guard>(state);
    return true;
}

// --- dwell, homing

// G04 without K, or with K0, interrupts the preparation of blocks; with K it is a dwell (7.1).
bool Interpreter::ends_reading() const { return !number_word_ || number_word_->value == 0; }

bool Interpreter::g_dwell(const GCode&) {
    const bool alone = block_.count == (number_word_ ? 2u : 1u);
    if (ends_reading()) {
        if (!alone) return core_.fail(Alarm::FagorAlone, 'G', "G04");
        core_.mark_emitted();
        core_.asks_at(frames_.back().file, line_at_.offset);
        core_.sink().barrier(core_.at);
        wants_barrier_ = true;
        return true;
    }
    std::int64_t hundredths = 0;
    if (!whole(*number_word_, hundredths)) return false;
    if (hundredths > 99'999)
        return fail_word(*number_word_, Alarm::FagorValueRange, "K",
                         static_cast<double>(hundredths));
    // each G04 ends the block before it square, as if nothing followed (fagor_8037t part 1, 7.1)
    core_.suspend_for(0);
    return core_.dwell(static_cast<double>(hundredths) / 100.0, false);
}

bool Interpreter::g_home(const GCode&) {
    if (!has_axes()) {
        if (settings_.homing_subroutine == 0)
            return core_.fail(Alarm::ReferenceAxisMissing, 'G', "G74");
        return call_subroutine(settings_.homing_subroutine, {}, nullptr);
    }
    if (modal_.motion == 2 || modal_.motion == 3) modal_.motion = 1;
    modal_.comp = 40;
    core_.compensation_off(0.0, 0.0);
    const MachineView& view = core_.view();
    // The marker is looked for axis by axis, in the order in which they are programmed.
    for (unsigned k = 0; k < block_.count; ++k) {
        const Word& word = block_.words[k];
        const int place =
            word.letter == 'G' ? -1 : place_[static_cast<std::size_t>(word.letter - 'A')];
        if (place < 0) continue;
        const auto i = static_cast<std::size_t>(place);
        if (modal_.inclined && (place == inclined_place_ || place == orthogonal_place_))
            set_inclined(0);
        AxisValues machine = core_.path.machine;
        machine[i] = view.axes[i].reference_mm[0];
        if (!core_.reference(machine, 1u << i, MoveKind::Reference)) return false;
    }
    // an axis finds its reference point
    wants_barrier_ = wants_barrier_ || core_.due_at_barrier();
    return true;
}

// --- zeros

void Interpreter::refresh_zero() {
    core_.load_zeros();
    core_.refresh_surface_zero();
}

bool Interpreter::g_zero(const GCode& row) {
    const auto number = row.number;
    // added to the absolute one of the table; a preset is the other of two ways and ends (4.4)
    if (number >= 58) {
        if (modal_.zero == 92) {
            core_.clear_preset();
            modal_.zero = 0;
        }
        modal_.zero_added = number;
        const auto& zeros = core_.view().store->zeros;
        for (unsigned i = 0; i < core_.view().axis_count; ++i)
            core_.local_zero(i, zeros[static_cast<std::size_t>(number - 53) * kChannelAxes + i]);
        return true;
    }
    core_.clear_preset();
    for (unsigned i = 0; i < core_.view().axis_count; ++i) core_.local_zero(i, 0.0);
    modal_.zero = number;
    modal_.zero_added = 0;
    core_.select_zero(number - 53);
    return true;
}

bool Interpreter::g_zero_table(const GCode&) {
    if (!number_word_) return core_.fail(Alarm::FagorMotionWord, 'G', "N", 159);
    std::int64_t n = 0;
    if (!whole(*number_word_, n)) return false;
    const auto row =
        n >= 1 && n <= 20 ? settable_zero_row(static_cast<std::size_t>(n)) : std::nullopt;
    if (!row) return fail_word(*number_word_, Alarm::FagorValueRange, "N", static_cast<double>(n));
    core_.clear_preset();
    for (unsigned i = 0; i < core_.view().axis_count; ++i) core_.local_zero(i, 0.0);
    modal_.zero = 159;
    modal_.zero_number = static_cast<std::uint16_t>(n);
    modal_.zero_added = 0;
    core_.select_zero(static_cast<std::int32_t>(*row));
    return true;
}

// G92: the present point gets these coordinates; with S the highest spindle speed.
bool Interpreter::g_preset(const GCode&) {
    if (has('S')) {
        if (has_axes()) return core_.fail(Alarm::FagorAlone, 'S', "G92 S");
        modal_.speed_limit = number('S');
        return number('S') >= 0 ? limit_surface_speed(true) && core_.commit_spindle()
                                : core_.spindle_limit(number('S'));
    }
    if (!has_axes()) return core_.fail(Alarm::CoordinateAxisNone, 'G', "G92");
    core_.hold_zeros_as_preset();
    modal_.zero = 92;
    modal_.zero_added = 0;
    for (unsigned i = 0; i < core_.view().axis_count; ++i)
        if (axis_words_[i])
            core_.preset(i, length(axis_words_[i]->value, static_cast<int>(i)) +
                                (core_.path.framed ? 0.0 : core_.path.vector[i]));
    return true;
}

// G93: I is the abscissa, J the ordinate of the plane; alone the present point.
bool Interpreter::g_polar_origin(const GCode&) {
    unsigned p = 0, q = 0;
    if (!plane_places(p, q)) return false;
    double op = core_.path.programmed[p], oq = core_.path.programmed[q];
    if (has('I') || has('J')) {
        op = length(number('I'), static_cast<int>(p));
        oq = length(number('J'), static_cast<int>(q));
    }
    set_polar_origin(op, oq);
    return true;
}

}  // namespace polyturn::channels::fagor
