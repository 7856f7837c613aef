// G80 to G89: the words of a drilling block, kept from hole to hole, into what
// channels/cycles/drilling does.
#include "channels/fanuc/cycles/g_drilling.hpp"

#include <cmath>

#include "channels/cycles/drilling.hpp"
#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/motion/targets.hpp"
#include "channels/fanuc/spindles/spindle_codes.hpp"

namespace polyturn::channels::fanuc {
namespace {

// F5102#3 F16 switches the series 15 drilling cycles off; L gives the repeats all the same
// (fanuc_lathe 8.5).
bool series15_drills(const Settings& settings, MachineView& view) {
    return settings.series15 && !params::bit(view.table(), params::f5102, view.channel, 3);
}

// Place of the drilling axis: by the plane, or Z where 5101#0 fixes it; G87 to G89 of a fanuc lathe
// drill along X.
int drilling_axis(Execution& x) {
    const MachineView& view = x.core.view();
    if (!x.settings.policy.drilling.along_plane && !series15_drills(x.settings, x.core.view())) {
        const bool along_x = x.modal.drilling->tenths >= 870;
        return view.axis_by_role(along_x ? PlaneRole::BasicX : PlaneRole::BasicZ);
    }
    if (!x.settings.policy.drilling.along_plane && !x.settings.drill_axis_by_plane)
        return view.axis_by_role(PlaneRole::BasicZ);
    switch (x.core.path.plane) {
        case Plane::XY:
            return view.axis_by_role(PlaneRole::BasicZ);
        case Plane::YZ:
            return view.axis_by_role(PlaneRole::BasicX);
        case Plane::ZX:
            break;
    }
    if (!x.settings.policy.drilling.along_plane) return -1;
    // A lathe is in G18 from power-on: where nothing can drill along Y, the face is meant, as
    // on other lathes.
    const int y = view.axis_by_role(PlaneRole::BasicY);
    return y < 0 && view.config().kind == ChannelKind::Lathe ? view.axis_by_role(PlaneRole::BasicZ)
                                                             : y;
}

// N1502, or I in the block: percent of the feed of the retract.
void bore_out(Execution& x, cycles::Drilling& hole) {
    hole.travel_out_factor =
        x.settings.policy.drilling.retract_word && x.block.has('I') && x.block.value('I') > 0
            ? x.block.value('I') / 100.0
            : x.settings.bore_out_factor;
}

// G87 of a milling channel needs the orientation of the spindle (nct part 1 8.2, ORI): it bores
// from behind. A lathe drills its side.
bool bores_back(Execution& x, const GCode& row) {
    return x.settings.policy.drilling.bores_back && row.tenths == 870 &&
           x.core.view().config().kind == ChannelKind::Mill;
}

// nct G86.1 (G76 of a milling channel) and G87: I, J, K lead the tool from the wall, in the plane
// across the hole, as increments.
void fine_way(Execution& x, cycles::Drilling& hole) {
    constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t k = 0; k < 3; ++k) {
        const char letter = static_cast<char>('I' + static_cast<int>(k));
        if (x.block.has(letter)) x.modal.cycles.drill.aside[k] = radius_length_of(x, letter);
        if (const int place = x.core.view().axis_by_role(kRoles[k]);
            place >= 0 && place != static_cast<int>(hole.axis))
            hole.aside[static_cast<std::size_t>(place)] = x.modal.cycles.drill.aside[k];
    }
}

bool tap_pitch(Execution& x, cycles::Drilling& hole) {
    const double rpm = x.core.path.spindle.rpm, feed = x.core.path.feed;
    if (!(rpm > 0)) return x.core.fail(Alarm::SpindleStopped, 'G');
    hole.pitch = x.core.path.feed_mode == FeedMode::PerRevolution ? feed : feed / rpm;
    return hole.pitch > 0 || x.core.fail(Alarm::FeedMissing, 'F');
}

// Rigid tapping of fanuc: G84.2, M29 before G84, F5200#0. The axis leads the spindle, as in nct
// (the field's standard), where the machine's builder has said how its loop closes; elsewhere it is
// refused (Core::rigid_loop).
bool rigid_form(const Execution& x, const GCode& row) {
    if (row.tenths == 842) return true;
    return (row.tenths == 840 || row.tenths == 880) &&
           (x.modal.last.m == 29 ||
            params::bit(x.core.view().table(), params::f5200, x.core.view().channel, 0));
}

bool lead_spindle(Execution& x, cycles::Drilling& hole) {
    Core::TapLoop loop;
    if (!x.core.rigid_loop(loop) || !tap_pitch(x, hole)) return false;
    hole.rigid = true;
    hole.orients = loop.orients;
    hole.closing_code = loop.code;
    return true;
}

// nct G84.2, G84.3: how the thread is cut and left (nct part 1 16.1, 16.4).
bool begin_rigid_tap(Execution& x, cycles::Drilling& hole) {
    const Settings::Tapping& tapping = x.settings.tapping;
    if (!lead_spindle(x, hole)) return false;
    hole.peck = x.modal.cycles.drill.q;
    hole.chip_break = !tapping.leaves_hole;
    hole.clearance = x.modal.cycles.drill.e_set ? x.modal.cycles.drill.e
                     : tapping.leaves_hole      ? tapping.clearance
                                                : tapping.chip_break;
    hole.out_factor = tapping.out_factor;
    hole.return_factor = tapping.return_factor;
    if (tapping.word_i && x.block.has('I') && x.block.value('I') > 0)
        hole.out_factor = x.block.value('I') / 100.0;
    hole.feedforward = tapping.feedforward;
    hole.own_acceleration_out = tapping.own_acceleration_out;
    return true;
}

// The rows take the words of all formats; here those that have no meaning in this one are refused:
// repeats are L in nct and in series 15 and K elsewhere, E and the percentage I are nct's.
bool drilling_words(Execution& x, const GCode& row) {
    const bool beside = row.tenths == 861 || bores_back(x, row);  // I, J, K lead from the wall
    const std::string_view foreign = x.settings.policy.drilling.own_words ? (beside ? "" : "JK")
                                     : x.settings.series15                ? "KEIJ"
                                                                          : "LEIJ";
    for (const char letter : foreign)
        if (x.block.has(letter) && !(letter == 'L' && x.words.m_count))
            return x.core.fail(Alarm::AddressIllegal, letter, std::string(1, letter));
    return true;
}

// R, Q, P, E of a hole: they stay from hole to hole.
void depth_words(Execution& x, unsigned axis) {
    DrillWords& drill = x.modal.cycles.drill;
    const DrillingPolicy& policy = x.settings.policy.drilling;
    const double scale = x.core.view().axes[axis].diameter ? 0.5 : 1.0;
    if (!drill.initial_known) {
        drill.initial = x.core.path.programmed[axis];
        drill.initial_known = true;
    }
    if (x.block.has('R')) {
        const double r = length_of(x, x.block.word('R'),
                                   x.settings.r_in_diameter ? static_cast<int>(axis) : -1) *
                         (x.settings.r_in_diameter ? scale : 1.0);
        const bool absolute =
            policy.r_by_distance || x.settings.system != kA
                ? x.modal.input.absolute && (policy.r_by_distance || x.settings.r_absolute)
                : x.settings.r_absolute;
        drill.r_level = absolute ? r : drill.initial + r;
        drill.r_set = true;
    }
    if (!drill.r_set) drill.r_level = drill.initial;
    if (x.block.has('Q')) drill.q = std::fabs(length_of(x, x.block.word('Q'), -1));
    if (x.block.has('P')) {
        drill.p = seconds_of(x, x.block.word('P'));
        drill.p_set = true;
    }
    if (x.block.has('E')) {
        drill.e = std::fabs(length_of(x, x.block.word('E'), -1));
        drill.e_set = true;
    }
}

struct HolePlace {
    AxisValues target{};
    // steps: named by an increment, which each repetition travels again
    AxisSet named = 0, steps = 0;
};

// Axis words: the drilling axis gives the bottom, all others the hole's place.
bool place_words(Execution& x, int place, HolePlace& hole) {
    DrillWords& drill = x.modal.cycles.drill;
    const ChannelAxis& axis = x.core.view().axes[static_cast<std::size_t>(place)];
    const double scale = axis.diameter ? 0.5 : 1.0;
    hole.target = x.core.path.programmed;
    for (unsigned k = 0; k < x.words.axis_count; ++k) {
        const Word& word = x.block.words[x.words.axes[k]];
        const int incremental =
            word.axis >= 0
                ? -1
                : x.vocabulary.incremental_axis[static_cast<std::size_t>(word.address - 'A')];
        const int absolute =
            word.axis >= 0
                ? word.axis
                : x.vocabulary.absolute_axis[static_cast<std::size_t>(word.address - 'A')];
        if ((absolute >= 0 ? absolute : incremental) == place) {
            const double value = length_of(x, word, place) * scale;
            const bool from_r = absolute < 0 || !x.modal.input.absolute;
            drill.bottom = from_r ? drill.r_level + value : value;
            drill.bottom_set = true;
        } else {
            if (!axis_word(x, word, hole.target, hole.named)) return false;
            if (absolute < 0 || !x.modal.input.absolute) hole.steps |= 1u << axis_of(x, word).place;
        }
    }
    return drill.bottom_set || x.core.fail(Alarm::CycleWordMissing, 'G', std::string(axis.name));
}

// How the code goes down and comes back.
bool hole_form(Execution& x, const GCode& row, cycles::Drilling& hole) {
    const DrillWords& drill = x.modal.cycles.drill;
    const DrillingPolicy& policy = x.settings.policy.drilling;
    const bool dwell_word = drill.p_set && drill.p > 0;
    switch (row.tenths) {
        case 810:
            break;
        case 820:
            hole.dwells = dwell_word;
            break;
        case 870:
            if (bores_back(x, row)) {
                if (!can_orient(x, x.core.path.spindle.spindle)) return false;
                hole.travel_out = cycles::Drilling::Way::Back;
                fine_way(x, hole);
                hole.dwells = dwell_word;
                break;
            }
            if (x.block.has('I')) return x.core.fail(Alarm::AddressIllegal, 'I', "I");
            [[fallthrough]];
        case 830:
        case 831:
            hole.peck = drill.q;
            hole.dwells = dwell_word;
            hole.chip_break = row.tenths == 831 || (!policy.pecks_by_code &&
                                                    !series15_drills(x.settings, x.core.view()) &&
                                                    !x.settings.peck_full);
            hole.clearance = drill.e_set       ? drill.e
                             : hole.chip_break ? x.settings.chip_break_return
                                               : x.settings.peck_clearance;
            break;
        case 842:
        case 843:
            if (policy.rigid_by_code && !begin_rigid_tap(x, hole)) return false;
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
            bore_out(x, hole);
            hole.dwells = dwell_word && !series15_drills(x.settings, x.core.view());
            break;
        case 861:
            if (!can_orient(x, x.core.path.spindle.spindle)) return false;
            hole.travel_out = cycles::Drilling::Way::Fine;
            fine_way(x, hole);
            hole.dwells = dwell_word;
            break;
        case 860:
            hole.travel_out = cycles::Drilling::Way::StopRapid;
            hole.dwells = dwell_word;
            break;
        case 890:
            hole.travel_out = cycles::Drilling::Way::Feed;
            hole.dwells = dwell_word;
            bore_out(x, hole);
            break;
        default:
            return x.core.fail(Alarm::NotBuilt, 'G', std::string(row.name));
    }
    return policy.rigid_by_code || !rigid_form(x, row) || lead_spindle(x, hole);
}

}  // namespace

bool g_drilling_off(Execution& x, const GCode&) {
    x.modal.drilling = nullptr;
    return true;
}

bool g_drilling(Execution& x, const GCode& row) {
    const bool series15_only =
        row.tenths == 810 || row.tenths == 820 || row.tenths == 831 || row.tenths == 842;
    const bool native_only = row.tenths == 870 || row.tenths == 880;
    if (!x.settings.policy.drilling.every_cycle &&
        (series15_drills(x.settings, x.core.view()) ? native_only : series15_only))
        return x.core.fail(Alarm::GCodeUnknown, 'G', std::string(row.name));
    // G80 has ended all data of the cycle before: the bottom, too, is said anew
    if (!x.modal.drilling) x.modal.cycles.drill = {};
    x.modal.drilling = &row;
    return true;
}

// One block while a drilling cycle is active: to the hole, down and back, as often as L or K says.
bool run_drilling(Execution& x) {
    const GCode& row = *x.modal.drilling;
    const DrillWords& drill = x.modal.cycles.drill;
    if (!drilling_words(x, row)) return false;
    const int place = drilling_axis(x);
    if (place < 0) return x.core.fail(Alarm::PlaneAxisMissing, 'G');
    const auto axis = static_cast<unsigned>(place);
    x.core.at.cycle = row.name;
    depth_words(x, axis);
    HolePlace at;
    if (!place_words(x, place, at)) return false;
    std::int64_t repeats = 1;
    const char count = x.settings.policy.drilling.repeats_by_l || x.settings.series15 ? 'L' : 'K';
    if (x.block.has(count) && !whole_number(x, count, repeats)) return false;

    cycles::Drilling hole;
    hole.axis = axis;
    hole.initial = drill.initial;
    hole.r_level = drill.r_level;
    hole.bottom = drill.bottom;
    hole.to_r_level = x.settings.system != kA && x.modal.in_force(GGroup::ReturnLevel) &&
                      x.modal.in_force(GGroup::ReturnLevel)->tenths == 990;
    if (!hole_form(x, row, hole)) return false;
    hole.dwell = drill.p;
    hole.dwells_at_r = x.settings.policy.drilling.dwells_at_r;
    hole.dwell_revolutions =
        x.settings.dwell_by_feed_mode && x.core.path.feed_mode == FeedMode::PerRevolution;
    const AxisValues from = x.core.path.programmed;
    // once at the hole's place it stays there: a rotary axis may have come to it by another turn
    for (std::int64_t k = 0; k < repeats; ++k) {
        AxisValues position = x.core.path.programmed;
        for (unsigned i = 0; i < x.core.view().axis_count; ++i)
            if (at.named >> i & 1u && (k == 0 || at.steps >> i & 1u))
                position[i] =
                    k == 0 ? at.target[i] : x.core.path.programmed[i] + (at.target[i] - from[i]);
        if (!x.core.rapid(position) || !cycles::drill(x.core, hole)) return false;
    }
    return true;
}

}  // namespace polyturn::channels::fanuc
