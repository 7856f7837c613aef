#include "channels/fanuc/g_codes.hpp"

#include "channels/fanuc/b_axis/b_axis.hpp"
#include "channels/fanuc/cycles/g_cycles.hpp"
#include "channels/fanuc/cycles/g_drilling.hpp"
#include "channels/fanuc/cycles/g_grooving_threading.hpp"
#include "channels/fanuc/cycles/g_repetitive.hpp"
#include "channels/fanuc/frames/g_frames.hpp"
#include "channels/fanuc/frames/g_transform.hpp"
#include "channels/fanuc/frames/tool_direction.hpp"
#include "channels/fanuc/frames/zeros.hpp"
#include "channels/fanuc/macro/calls.hpp"
#include "channels/fanuc/motion/compensation.hpp"
#include "channels/fanuc/motion/dwell.hpp"
#include "channels/fanuc/motion/feed.hpp"
#include "channels/fanuc/motion/g_motion.hpp"
#include "channels/fanuc/motion/measuring.hpp"
#include "channels/fanuc/motion/modes.hpp"
#include "channels/fanuc/motion/stroke_area.hpp"
#include "channels/fanuc/motion/threads.hpp"
#include "channels/fanuc/program/remote_data.hpp"
#include "channels/fanuc/spindles/g_couplings.hpp"
#include "channels/fanuc/spindles/speeds.hpp"
#include "channels/fanuc/tools/data_input.hpp"
#include "channels/fanuc/tools/g_length.hpp"
#include "channels/mefi/shifts.hpp"

namespace polyturn::channels::fanuc {
namespace {

using G = GGroup;

constexpr auto kRows = std::to_array<GCode>({
    {"G0", 0, kShared, G::Motion, &g_rapid, "x", true, "Rapid traverse"},
    {"G1", 10, kShared, G::Motion, &g_linear, "xIKRCA", false, "Line at feed"},
    {"G2", 20, kShared, G::Motion, &g_arc, "xIJKR", false, "Arc, clockwise", Trait::Arc},
    {"G3", 30, kShared, G::Motion, &g_arc, "xIJKR", false, "Arc, anticlockwise", Trait::Arc},
    {"G4", 40, kShared, G::OneShot, &g_dwell, "PXUQ", false, "Dwell"},
    {"G5", 50, kAll, G::OneShot, &g_binary_input, "", false,
     "High-speed binary data, from PT_REMOTE_INPUT"},
    {"G5.1", 51, kAll, G::OneShot, &g_smoothing, "QR", false, "High speed, high precision"},
    {"G7.1", 71, kAll, G::OneShot, &g_cylinder, "x", false,
     "Cylindrical interpolation: with the radius on, with 0 off", Trait::Cylinder},
    {"G9", 90, kShared, G::ExactStop, &g_exact_once, "", false,
     "Exact stop at the end of this block"},
    {"G10", 100, kAll, G::OneShot, &g_data, "xPLRQC", false,
     "Data input: offsets, zeros, parameters"},
    {"G10.9", 109, kAll, G::OneShot, &g_diameter, "x", false,
     "Diameter (1) or radius (0) programming of an axis"},
    {"G11", 110, kAll, G::OneShot, &g_nothing, "", false, "End of data input"},
    {"G12.1", 121, kAll, G::Transform, &g_polar_plane, "", false, "Polar interpolation"},
    {"G13.1", 131, kAll, G::Transform, &g_polar_plane, "", true, "Polar interpolation off"},
    {"G15", 150, kBCN, G::Polar, &g_polar, "", true, "Polar points off"},
    {"G16", 160, kBCN, G::Polar, &g_polar, "", false, "Points by radius and angle"},
    {"G17", 170, kShared, G::Plane, &g_plane, "", false, "Plane X Y"},
    {"G18", 180, kShared, G::Plane, &g_plane, "", true, "Plane Z X"},
    {"G19", 190, kShared, G::Plane, &g_plane, "", false, "Plane Y Z"},
    {"G20", 200, kABN, G::Units, &g_units, "", false, "Input in inches"},
    {"G20", 200, kC, G::Motion, &g_cycle_turning, "xRI", false, "Turning cycle",
     Trait::SimpleCycle},
    {"G21", 210, kABN, G::Units, &g_units, "", true, "Input in millimetres"},
    {"G21", 210, kC, G::Motion, &g_cycle_thread, "xRIQ", false, "Threading cycle",
     Trait::SimpleCycle | Trait::Thread},
    {"G22", 220, kAll, G::StrokeArea, &g_stroke_area, "xIJK", true, "Stroke range 2 counts"},
    {"G23", 230, kAll, G::StrokeArea, &g_stroke_area, "", false, "Stroke range 2 does not count"},
    {"G24", 240, kC, G::Motion, &g_cycle_facing, "xRK", false, "Facing cycle", Trait::SimpleCycle},
    {"G25", 250, kAll, G::SpindleWatch, &g_spindle_watch, "", true, "Spindle speed watch off"},
    {"G26", 260, kAll, G::SpindleWatch, &g_spindle_watch, "PQRDI", false, "Spindle speed watch on"},
    {"G27", 270, kAll, G::OneShot, &g_reference_check, "x", false,
     "Check of the reference position"},
    {"G28", 280, kAll, G::OneShot, &g_reference, "x", false,
     "To the reference position through a point"},
    {"G30", 300, kAll, G::OneShot, &g_reference, "xP", false,
     "To a further reference position through a point"},
    {"G30.1", 301, kAll, G::OneShot, &g_reference, "x", false,
     "To the floating reference position"},
    {"G31", 310, kAll, G::OneShot, &g_skip, "xPQR", false, "Move until a signal; P1 to P4 which"},
    {"G32", 320, kA, G::Motion, &g_thread, "xQE", false, "Thread", Trait::Thread},
    {"G33", 330, kBCNM, G::Motion, &g_thread, "xQE", false, "Thread", Trait::Thread},
    {"G34", 340, kAll, G::Motion, &g_thread_variable, "xKQ", false, "Thread with changing lead",
     Trait::Thread},
    {"G35", 350, kFanuc, G::Motion, &g_thread_arc, "xIJKRQE", false, "Thread on an arc, clockwise",
     Trait::Thread},
    {"G36", 360, kAll, G::OneShot, &g_measure, "x", false, "Automatic tool offset X"},
    {"G37", 370, kAll, G::OneShot, &g_measure, "x", false, "Automatic tool offset Z"},
    {"G37.1", 371, kAll, G::OneShot, &g_measure, "x", false, "Automatic tool offset X"},
    {"G37.2", 372, kAll, G::OneShot, &g_measure, "x", false, "Automatic tool offset Z"},
    {"G40", 400, kShared, G::Comp, &g_comp_off, "IJK", true, "Nose-radius compensation off",
     Trait::CompOff},
    {"G41", 410, kShared, G::Comp, &g_comp_on, "", false, "Compensation, left of the path",
     Trait::CompOn},
    {"G42", 420, kShared, G::Comp, &g_comp_on, "", false, "Compensation, right of the path",
     Trait::CompOn},
    {"G43", 430, kBCN, G::Length, &g_length, "H", false, "Length offset", Trait::Length},
    {"G43.1", 431, kAll, G::Transform, &g_length, "H", false,
     "Length along the tool as the head stands", Trait::Length},
    {"G43.4", 434, kAll, G::Transform, &g_length, "H", false,
     "Tool tip control of head and table on", Trait::Length},
    {"G43.5", 435, kAll, G::Transform, nullptr, "xHIJK", false,
     "Tool tip control by the direction of the tool"},
    {"G43.7", 437, kBCN, G::Length, &g_length, "H", false, "Lathe offset by G code", Trait::Length},
    {"G44", 440, kBCN, G::Length, &g_length, "H", false, "Length offset, negative", Trait::Length},
    {"G49", 490, kBCN, G::Length, &g_length, "", true, "Length compensation off", Trait::Length},
    {"G49", 490, kA, G::Transform, &g_length, "", false, "Tool tip control off", Trait::Length},
    {"G50", 500, kA, G::OneShot, &g_preset, "xS", false, "Coordinate setting; spindle speed limit",
     Trait::Preset},
    {"G50", 500, kBCN, G::Scale, &g_scale, "", true, "Scaling off"},
    {"G50.1", 501, kBCN, G::Mirror, &g_mirror, "x", true, "Mirror off"},
    {"G50.2", 502, kAll, G::OneShot, &g_polygon_off, "", false, "Polygon turning off",
     Trait::Polygon},
    {"G50.3", 503, kA, G::OneShot, &g_preset_off, "x", false, "Coordinate setting undone"},
    {"G51", 510, kBCN, G::Scale, &g_scale, "xPIJK", false, "Scaling"},
    {"G51.1", 511, kBCN, G::Mirror, &g_mirror, "x", false, "Mirror"},
    {"G51.2", 512, kAll, G::OneShot, &g_polygon, "PQ", false, "Polygon turning", Trait::Polygon},
    {"G52", 520, kAll, G::OneShot, &g_local_zero, "x", false, "Local coordinate system"},
    {"G53", 530, kAll, G::OneShot, &g_machine, "x", false, "Move in machine coordinates"},
    {"G53", 530, kM, G::Zero, &g_shift, "", true, "Zero shift 0, from the machine zero"},
    {"G53.1", 531, kAll, G::OneShot, &g_tool_direction, "", false,
     "Tool along the axis of the rotated system"},
    {"G54", 540, kAll, G::Zero, &g_zero, "", true, "Work zero 1"},
    {"G54", 540, kM, G::Zero, &g_shift, "", false, "Zero shift 1"},
    {"G54.1", 541, kAll, G::Zero, &g_zero_extended, "P", false, "Further work zeros"},
    {"G54.2", 542, kAll, G::OneShot, &g_fixture, "P", false,
     "Fixture offset that follows the rotary table"},
    {"G55", 550, kAll, G::Zero, &g_zero, "", false, "Work zero 2"},
    {"G55", 550, kM, G::Zero, &g_shift, "", false, "Zero shift 2"},
    {"G56", 560, kAll, G::Zero, &g_zero, "", false, "Work zero 3"},
    {"G56", 560, kM, G::Zero, &g_shift, "", false, "Zero shift 3"},
    {"G57", 570, kAll, G::Zero, &g_zero, "", false, "Work zero 4"},
    {"G57", 570, kM, G::Zero, &g_shift, "", false, "Zero shift 4"},
    {"G58", 580, kAll, G::Zero, &g_zero, "", false, "Work zero 5"},
    {"G58", 580, kM, G::Zero, &g_shift, "", false, "Zero shift 5, in its block"},
    {"G59", 590, kAll, G::Zero, &g_zero, "", false, "Work zero 6"},
    {"G59", 590, kM, G::Zero, &g_shift, "", false, "Zero shift 6, in its block"},
    {"G60", 600, kM, G::ExactStop, &g_exact_stop, "", false, "Exact stop mode"},
    {"G61", 610, kAll, G::ExactStop, &g_exact_stop, "", false, "Exact stop mode"},
    {"G62", 620, kN, G::ExactStop, &g_exact_stop, "", false,
     "Corner override: inner corners of a compensated contour are cut with N1410"},
    {"G63", 630, kAll, G::ExactStop, &g_exact_stop, "", false, "Feed override off"},
    {"G64", 640, kShared, G::ExactStop, &g_exact_stop, "", true, "Cutting mode"},
    {"G65", 650, kAll, G::OneShot, &g_macro_call, "", false, "Macro call", Trait::MacroCall},
    {"G66", 660, kAll, G::MacroModal, &g_macro_modal, "", false, "Macro call after each move",
     Trait::MacroCall},
    {"G66.1", 661, kAll, G::MacroModal, &g_macro_modal, "", false,
     "Macro call for each block: its words are arguments", Trait::MacroCall},
    {"G67", 670, kAll, G::MacroModal, &g_macro_modal_off, "", true, "End of the modal macro call"},
    {"G68", 680, kFanuc, G::Rotation, &g_turret_mirror, "", false, "Mirror of double turrets"},
    {"G68", 680, kN, G::Rotation, &g_rotation, "xIJKR", false, "Rotation"},
    {"G68.1", 681, kAll, G::Rotation, &g_rotation, "xIJKR", false,
     "Rotation of the coordinate system"},
    {"G69", 690, kAll, G::Rotation, &g_rotation, "", true, "Rotation or mirror off"},
    {"G69.1", 691, kAll, G::Rotation, &g_rotation, "", false, "Rotation off"},
    {"G70", 700, kABN, G::OneShot, &g_finishing, "PQ", false, "Finishing cycle"},
    {"G70", 700, kC, G::Units, &g_units, "", false, "Input in inches"},
    {"G71", 710, kABN, G::OneShot, &g_stock_removal, "PQUWRDIK", false, "Stock removal in turning"},
    {"G71", 710, kC, G::Units, &g_units, "", true, "Input in millimetres"},
    {"G72", 720, kABN, G::OneShot, &g_stock_removal, "PQUWRDIK", false, "Stock removal in facing"},
    {"G72", 720, kC, G::OneShot, &g_finishing, "PQ", false, "Finishing cycle"},
    {"G73", 730, kABN, G::OneShot, &g_pattern, "PQUWRDIK", false, "Pattern repeating"},
    {"G73", 730, kC, G::OneShot, &g_stock_removal, "PQUWRDIK", false, "Stock removal in turning"},
    {"G74", 740, kABN, G::OneShot, &g_grooving, "xPQRIKD", false, "Peck drilling along Z"},
    {"G74", 740, kC, G::OneShot, &g_stock_removal, "PQUWRDIK", false, "Stock removal in facing"},
    {"G75", 750, kABN, G::OneShot, &g_grooving, "xPQRIKD", false, "Grooving along X"},
    {"G75", 750, kC, G::OneShot, &g_pattern, "PQUWRDIK", false, "Pattern repeating"},
    {"G76", 760, kABN, G::OneShot, &g_thread_passes, "xPQRIKDA", false,
     "Threading cycle in several passes", Trait::Thread},
    {"G76", 760, kC, G::OneShot, &g_grooving, "xPQRIKD", false, "Peck drilling along Z"},
    {"G77", 770, kBN, G::Motion, &g_cycle_turning, "xRI", false, "Turning cycle",
     Trait::SimpleCycle},
    {"G77", 770, kC, G::OneShot, &g_grooving, "xPQRIKD", false, "Grooving along X"},
    {"G78", 780, kBN, G::Motion, &g_cycle_thread, "xRIQ", false, "Threading cycle",
     Trait::SimpleCycle | Trait::Thread},
    {"G78", 780, kC, G::OneShot, &g_thread_passes, "xPQRIKDA", false,
     "Threading cycle in several passes", Trait::Thread},
    {"G79", 790, kBN, G::Motion, &g_cycle_facing, "xRK", false, "Facing cycle", Trait::SimpleCycle},
    {"G80", 800, kAll, G::Drilling, &g_drilling_off, "", true, "Drilling cycles off"},
    {"G80.8", 808, kN, G::OneShot, &g_gear_off, "", false, "Electronic gear box off"},
    {"G81", 810, kAll, G::Drilling, &g_drilling, "xRQPLKE", false, "Drilling"},
    {"G81.8", 818, kN, G::OneShot, &g_gear, "TLQP", false, "Electronic gear box"},
    {"G82", 820, kAll, G::Drilling, &g_drilling, "xRQPLKE", false, "Drilling with dwell"},
    {"G83", 830, kAll, G::Drilling, &g_drilling, "xRQPLKE", false, "Peck drilling"},
    {"G83.1", 831, kAll, G::Drilling, &g_drilling, "xRQPLKE", false, "High-speed peck drilling"},
    {"G84", 840, kAll, G::Drilling, &g_drilling, "xRQPLKE", false, "Tapping"},
    {"G84.1", 841, kN, G::Drilling, &g_drilling, "xRQPLKE", false, "Tapping, left"},
    {"G84.2", 842, kAll, G::Drilling, &g_drilling, "xRQPLKEI", false, "Rigid tapping"},
    {"G84.3", 843, kN, G::Drilling, &g_drilling, "xRQPLKEI", false, "Rigid tapping, left"},
    {"G85", 850, kAll, G::Drilling, &g_drilling, "xRQPLKEI", false, "Boring"},
    {"G86", 860, kAll, G::Drilling, &g_drilling, "xRQPLKE", false, "Boring with stop"},
    {"G86.1", 861, kN, G::Drilling, &g_drilling, "xRQPLKIJ", false,
     "Fine boring: out with the spindle oriented, I, J, K beside the wall"},
    {"G87", 870, kFanuc, G::Drilling, &g_drilling, "xRQPLKE", false, "Side drilling"},
    {"G87", 870, kN, G::Drilling, &g_drilling, "xRQPLKEIJ", false,
     "Side drilling; in a milling channel back boring, I, J, K beside the wall"},
    {"G88", 880, kAll, G::Drilling, &g_drilling, "xRQPLKE", false, "Side tapping"},
    {"G89", 890, kAll, G::Drilling, &g_drilling, "xRQPLKEI", false, "Boring with dwell"},
    {"G90", 900, kA, G::Motion, &g_cycle_turning, "xRI", false, "Turning cycle",
     Trait::SimpleCycle},
    {"G90", 900, kBCNM, G::Distance, &g_distance, "", true, "Absolute words"},
    {"G91", 910, kBCNM, G::Distance, &g_distance, "", false, "Incremental words"},
    {"G92", 920, kA, G::Motion, &g_cycle_thread, "xRIQ", false, "Threading cycle",
     Trait::SimpleCycle | Trait::Thread},
    {"G92", 920, kBCN, G::OneShot, &g_preset, "xS", false,
     "Coordinate setting; spindle speed limit", Trait::Preset},
    {"G92", 920, kM, G::OneShot, &g_shift_table, "x", false, "Values of a zero shift"},
    {"G93", 930, kM, G::OneShot, &g_shift_table, "x", false, "Zero shift from the actual position"},
    {"G92.1", 921, kBCN, G::OneShot, &g_preset_off, "x", false, "Coordinate setting undone"},
    {"G94", 940, kA, G::Motion, &g_cycle_facing, "xRK", false, "Facing cycle", Trait::SimpleCycle},
    {"G94", 940, kBCNM, G::FeedMode, &g_feed_mode, "", true, "Feed per minute"},
    {"G95", 950, kBCNM, G::FeedMode, &g_feed_mode, "", false, "Feed per revolution"},
    {"G96", 960, kShared, G::Surface, &g_surface, "P", false, "Constant surface speed"},
    {"G97", 970, kShared, G::Surface, &g_surface, "", true, "Constant spindle speed"},
    {"G98", 980, kA, G::FeedMode, &g_feed_mode, "", true, "Feed per minute"},
    {"G98", 980, kBCN, G::ReturnLevel, &g_nothing, "", true,
     "Drilling returns to the initial level"},
    {"G99", 990, kA, G::FeedMode, &g_feed_mode, "", false, "Feed per revolution"},
    {"G99", 990, kBCN, G::ReturnLevel, &g_nothing, "", false, "Drilling returns to the R level"},
    {"G100", 1000, kFanuc, G::OneShot, &g_b_register, "", false, "End of a B-axis program"},
    {"G101", 1010, kFanuc, G::OneShot, &g_b_register, "", false, "B-axis program 1"},
    {"G102", 1020, kFanuc, G::OneShot, &g_b_register, "", false, "B-axis program 2"},
    {"G103", 1030, kFanuc, G::OneShot, &g_b_register, "", false, "B-axis program 3"},
    {"G107", 1070, kFanuc, G::OneShot, &g_cylinder, "x", false,
     "Cylindrical interpolation: with the radius on, with 0 off", Trait::Cylinder},
    {"G110", 1100, kFanuc, G::OneShot, &g_b_single, "xRPQ", false, "One motion of the B axis"},
    {"G112", 1120, kFanuc, G::Transform, &g_polar_plane, "", false, "Polar interpolation"},
    {"G113", 1130, kFanuc, G::Transform, &g_polar_plane, "", false, "Polar interpolation off"},
    {"G250", 2500, kFanuc, G::OneShot, &g_polygon_off, "", false, "Polygon turning off",
     Trait::Polygon},
    {"G251", 2510, kFanuc, G::OneShot, &g_polygon, "PQ", false, "Polygon turning", Trait::Polygon},
});

// One row for each code of a system.
constexpr bool rows_are_unique() {
    for (std::size_t i = 0; i < kRows.size(); ++i)
        for (std::size_t j = i + 1; j < kRows.size(); ++j)
            if (kRows[i].tenths == kRows[j].tenths && (kRows[i].systems & kRows[j].systems))
                return false;
    return true;
}
constexpr bool one_reset_state_per_group() {
    for (const std::uint8_t system : {kA, kB, kC, kN, kM})
        for (std::size_t i = 0; i < kRows.size(); ++i)
            for (std::size_t j = i + 1; j < kRows.size(); ++j)
                if (kRows[i].at_reset && kRows[j].at_reset && kRows[i].group == kRows[j].group &&
                    kRows[i].group != G::OneShot && (kRows[i].systems & kRows[j].systems & system))
                    return false;
    return true;
}
static_assert(kRows.size() < 255, "GTable keeps the row in a byte");
static_assert(rows_are_unique());
static_assert(one_reset_state_per_group());

}  // namespace

std::span<const GCode> g_codes() { return kRows; }

GTable::GTable(GSystem system) {
    for (std::size_t row = 0; row < kRows.size(); ++row)
        if (kRows[row].systems & system)
            index_[kRows[row].tenths] = static_cast<std::uint8_t>(row + 1);
}

}  // namespace polyturn::channels::fanuc
