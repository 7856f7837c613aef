// G80 to G89: the words of a drilling block, kept from hole to hole, into what
// channels/cycles/drilling does.
#include <cmath>

#include "channels/cycles/drilling.hpp"
#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {
namespace {

// F5102#3 F16 switches the series 15 drilling cycles off; L gives the repeats all the same
// (fanuc_lathe 8.5).
bool series15_drills(const Settings& settings, MachineView& view) {
    return settings.series15 && !params::bit(view.table(), params::f5102, view.channel, 3);
}

}  // namespace

bool Interpreter::g_drilling_off(const GCode&) {
    drilling_ = nullptr;
    return true;
}

bool Interpreter::g_drilling(const GCode& row) {
    const bool series15_only =
        row.tenths == 810 || row.tenths == 820 || row.tenths == 831 || row.tenths == 842;
    const bool native_only = row.tenths == 870 || row.tenths == 880;
    if (!settings_.nct && (series15_drills(settings_, core_.view()) ? native_only : series15_only))
        return core_.fail(Alarm::GCodeUnknown, 'G', std::string(row.name));
    // G80 has ended all data of the cycle before: the bottom, too, is said anew
    if (!drilling_) drill_ = {};
    drilling_ = &row;
    return true;
}

// Place of the drilling axis: by the plane, or Z where 5101#0 fixes it; G87 to G89 of a fanuc lathe
// drill along X.
int Interpreter::drilling_axis() {
    const MachineView& view = core_.view();
    if (!settings_.nct && !series15_drills(settings_, core_.view())) {
        const bool along_x = drilling_->tenths >= 870;
        return view.axis_by_role(along_x ? PlaneRole::BasicX : PlaneRole::BasicZ);
    }
    if (!settings_.nct && !settings_.drill_axis_by_plane)
        return view.axis_by_role(PlaneRole::BasicZ);
    switch (core_.path.plane) {
        case Plane::XY:
            return view.axis_by_role(PlaneRole::BasicZ);
        case Plane::YZ:
            return view.axis_by_role(PlaneRole::BasicX);
        case Plane::ZX:
            break;
    }
    if (!settings_.nct) return -1;
    // A lathe is in G18 from power-on: where nothing can drill along Y, the face is meant, as
    // on other lathes.
    const int y = view.axis_by_role(PlaneRole::BasicY);
    return y < 0 && view.config().kind == ChannelKind::Lathe ? view.axis_by_role(PlaneRole::BasicZ)
                                                             : y;
}

// N1502, or I in the block: percent of the feed of the retract.
void Interpreter::bore_out(cycles::Drilling& hole) {
    hole.travel_out_factor = settings_.nct && block_.has('I') && block_.value('I') > 0
                                 ? block_.value('I') / 100.0
                                 : settings_.bore_out_factor;
}

// G87 of a milling channel needs the orientation of the spindle (nct part 1 8.2, ORI): it bores
// from behind. A lathe drills its side.
bool Interpreter::bores_back(const GCode& row) {
    return settings_.nct && row.tenths == 870 && core_.view().config().kind == ChannelKind::Mill;
}

// nct G86.1 (G76 of a milling channel) and G87: I, J, K lead the tool from the wall, in the plane
// across the hole, as increments.
void Interpreter::fine_way(cycles::Drilling& hole) {
    constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t k = 0; k < 3; ++k) {
        const char letter = static_cast<char>('I' + static_cast<int>(k));
        if (block_.has(letter)) drill_.aside[k] = radius_length(letter);
        if (const int place = core_.view().axis_by_role(kRoles[k]);
            place >= 0 && place != static_cast<int>(hole.axis))
            hole.aside[static_cast<std::size_t>(place)] = drill_.aside[k];
    }
}

bool Interpreter::tap_pitch(cycles::Drilling& hole) {
    const double rpm = core_.path.spindle.rpm, feed = core_.path.feed;
    if (!(rpm > 0)) return core_.fail(Alarm::SpindleStopped, 'G');
    hole.pitch = core_.path.feed_mode == FeedMode::PerRevolution ? feed : feed / rpm;
    return hole.pitch > 0 || core_.fail(Alarm::FeedMissing, 'F');
}

// Rigid tapping of fanuc: G84.2, M29 before G84, F5200#0. The axis leads the spindle, as in nct
// (the field's standard), where the machine's builder has said how its loop closes; elsewhere it is
// refused (Core::rigid_loop).
bool Interpreter::rigid_form(const GCode& row) const {
    if (row.tenths == 842) return true;
    return (row.tenths == 840 || row.tenths == 880) &&
           (last_m_ == 29 ||
            params::bit(core_.view().table(), params::f5200, core_.view().channel, 0));
}

bool Interpreter::lead_spindle(cycles::Drilling& hole) {
    Core::TapLoop loop;
    if (!core_.rigid_loop(loop) || !tap_pitch(hole)) return false;
    hole.rigid = true;
    hole.orients = loop.orients;
    hole.closing_code = loop.code;
    return true;
}

// nct G84.2, G84.3: how the thread is cut and left (nct part 1 16.1, 16.4).
bool Interpreter::begin_rigid_tap(cycles::Drilling& hole) {
    const Settings::Tapping& tapping = settings_.tapping;
    if (!lead_spindle(hole)) return false;
    hole.peck = drill_.q;
    hole.chip_break = !tapping.leaves_hole;
    hole.clearance = drill_.e_set          ? drill_.e
                     : tapping.leaves_hole ? tapping.clearance
                                           : tapping.chip_break;
    hole.out_factor = tapping.out_factor;
    hole.return_factor = tapping.return_factor;
    if (tapping.word_i && block_.has('I') && block_.value('I') > 0)
        hole.out_factor = block_.value('I') / 100.0;
    hole.feedforward = tapping.feedforward;
    hole.own_acceleration_out = tapping.own_acceleration_out;
    return true;
}

// The rows take the words of all formats; here those that have no meaning in this one are refused:
// repeats are L in nct and in series 15 and K elsewhere, E and the percentage I are nct's.
bool Interpreter::drilling_words(const GCode& row) {
    const bool beside = row.tenths == 861 || bores_back(row);  // I, J, K lead from the wall
    const std::string_view foreign = settings_.nct        ? (beside ? "" : "JK")
                                     : settings_.series15 ? "KEIJ"
                                                          : "LEIJ";
    for (const char letter : foreign)
        if (block_.has(letter) && !(letter == 'L' && m_count_))
            return core_.fail(Alarm::AddressIllegal, letter, std::string(1, letter));
    return true;
}

// One block while a drilling cycle is active: to the hole, down and back, as often as L or K says.
bool Interpreter::run_drilling() {
    const GCode& row = *drilling_;
    if (!drilling_words(row)) return false;
    const int place = drilling_axis();
    if (place < 0) return core_.fail(Alarm::PlaneAxisMissing, 'G');
    const auto axis = static_cast<unsigned>(place);
    const double scale = core_.view().axes[axis].diameter ? 0.5 : 1.0;
    core_.at.cycle = row.name;
    if (!drill_.initial_known) {
        drill_.initial = core_.path.programmed[axis];
        drill_.initial_known = true;
    }
    if (block_.has('R')) {
        const double r = length(block_.word('R'), settings_.r_in_diameter ? place : -1) *
                         (settings_.r_in_diameter ? scale : 1.0);
        const bool absolute = settings_.nct || settings_.system != kA
                                  ? absolute_ && (settings_.nct || settings_.r_absolute)
                                  : settings_.r_absolute;
        drill_.r_level = absolute ? r : drill_.initial + r;
        drill_.r_set = true;
    }
    if (!drill_.r_set) drill_.r_level = drill_.initial;
    if (block_.has('Q')) drill_.q = std::fabs(length(block_.word('Q'), -1));
    if (block_.has('P')) {
        drill_.p = seconds(block_.word('P'));
        drill_.p_set = true;
    }
    if (block_.has('E')) {
        drill_.e = std::fabs(length(block_.word('E'), -1));
        drill_.e_set = true;
    }
    // Axis words: the drilling axis gives the bottom, all others the hole's place.
    AxisValues target = core_.path.programmed;
    // steps: named by an increment, which each repetition travels again
    AxisSet named = 0, steps = 0;
    for (unsigned k = 0; k < axis_word_count_; ++k) {
        const Word& word = block_.words[axis_words_[k]];
        const int incremental =
            word.axis >= 0 ? -1 : incremental_axis_[static_cast<std::size_t>(word.address - 'A')];
        const int absolute = word.axis >= 0
                                 ? word.axis
                                 : absolute_axis_[static_cast<std::size_t>(word.address - 'A')];
        if ((absolute >= 0 ? absolute : incremental) == place) {
            const double value = length(word, place) * scale;
            const bool from_r = absolute < 0 || !absolute_;
            drill_.bottom = from_r ? drill_.r_level + value : value;
            drill_.bottom_set = true;
        } else {
            if (!axis_word(word, target, named)) return false;
            if (absolute < 0 || !absolute_) steps |= 1u << axis_of(word).place;
        }
    }
    if (!drill_.bottom_set)
        return core_.fail(Alarm::CycleWordMissing, 'G', std::string(core_.view().axes[axis].name));
    std::int64_t repeats = 1;
    const char count = settings_.nct || settings_.series15 ? 'L' : 'K';
    if (block_.has(count) && !whole(count, repeats)) return false;

    cycles::Drilling hole;
    hole.axis = axis;
    hole.initial = drill_.initial;
    hole.r_level = drill_.r_level;
    hole.bottom = drill_.bottom;
    hole.to_r_level = settings_.system != kA &&
                      active_[static_cast<std::size_t>(GGroup::ReturnLevel)] &&
                      active_[static_cast<std::size_t>(GGroup::ReturnLevel)]->tenths == 990;
    const bool dwell_word = drill_.p_set && drill_.p > 0;
    switch (row.tenths) {
        case 810:
            break;
        case 820:
            hole.dwells = dwell_word;
            break;
        case 870:
            if (bores_back(row)) {
                if (!can_orient(core_.path.spindle.spindle)) return false;
                hole.travel_out = cycles::Drilling::Way::Back;
                fine_way(hole);
                hole.dwells = dwell_word;
                break;
            }
            if (block_.has('I')) return core_.fail(Alarm::AddressIllegal, 'I', "I");
            [[fallthrough]];
        case 830:
        case 831:
            hole.peck = drill_.q;
            hole.dwells = dwell_word;
            hole.chip_break =
                row.tenths == 831 || (!settings_.nct && !series15_drills(settings_, core_.view()) &&
                                      !settings_.peck_full);
            hole.clearance = drill_.e_set      ? drill_.e
                             : hole.chip_break ? settings_.chip_break_return
                                               : settings_.peck_clearance;
            break;
        case 842:
        case 843:
            if (settings_.nct && !begin_rigid_tap(hole)) return false;
            [[fallthrough]];
        case 840:
        case 841:
        case 880:
            hole.travel_out = cycles::Drilling::Way::Tap;
            hole.left_hand = row.tenths == 841 || row.tenths == 843;
            hole.dwells = dwell_word;
            break;
        case 850:
            hole.travel_out = cycles::Drilling::Way::Feed;
            bore_out(hole);
            hole.dwells = dwell_word && !series15_drills(settings_, core_.view());
            break;
        case 861:
            if (!can_orient(core_.path.spindle.spindle)) return false;
            hole.travel_out = cycles::Drilling::Way::Fine;
            fine_way(hole);
            hole.dwells = dwell_word;
            break;
        case 860:
            hole.travel_out = cycles::Drilling::Way::StopRapid;
            hole.dwells = dwell_word;
            break;
        case 890:
            hole.travel_out = cycles::Drilling::Way::Feed;
            hole.dwells = dwell_word;
            bore_out(hole);
            break;
        default:
            return core_.fail(Alarm::NotBuilt, 'G', std::string(row.name));
    }
    if (!settings_.nct && rigid_form(row) && !lead_spindle(hole)) return false;
    hole.dwell = drill_.p;
    hole.dwells_at_r = !settings_.nct;
    hole.dwell_revolutions =
        settings_.dwell_by_feed_mode && core_.path.feed_mode == FeedMode::PerRevolution;
    const AxisValues step = target;
    const AxisValues from = core_.path.programmed;
    // once at the hole's place it stays there: a rotary axis may have come to it by another turn
    for (std::int64_t k = 0; k < repeats; ++k) {
        AxisValues position = core_.path.programmed;
        for (unsigned i = 0; i < core_.view().axis_count; ++i)
            if (named >> i & 1u && (k == 0 || steps >> i & 1u))
                position[i] = k == 0 ? step[i] : core_.path.programmed[i] + (step[i] - from[i]);
        if (!core_.rapid(position) || !cycles::drill(core_, hole)) return false;
    }
    return true;
}

}  // namespace polyturn::channels::fanuc
