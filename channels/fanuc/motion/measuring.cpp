// G31: a move that a signal ends, or a torque. G36, G37 (G37.1, G37.2): measuring the tool's offset
// with such a move.
//
//   start ----- rapid -----> T . . . feed . . . U ===== target ===== V      T: rapid distance before the target
//                                               '- the signal counts here -'
//
// The block has two halves: moves up to the barrier, and what follows from where the axes stopped
// (finish_skip).
#include "channels/fanuc/motion/measuring.hpp"

#include <cmath>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/motion/targets.hpp"
#include "channels/fanuc/program/faults.hpp"
#include "channels/fanuc/tools/offset_tables.hpp"

namespace polyturn::channels::fanuc {
namespace {

constexpr std::string_view kSignals[] = {"SKIP", "SKIP2", "SKIP3", "SKIP4"};

// The offset that T selects; where lengths are called by G43 H (nct: milling, N1414 TCM), the one
// of H.
std::int32_t measured_offset(const Execution& x) {
    const ToolState& tool = x.core.path.tool;
    const std::int32_t by_tool = x.settings.measure_to_wear ? tool.wear : tool.geometry;
    return by_tool != 0 ? by_tool : x.modal.length.number;
}

}  // namespace

bool g_skip(Execution& x, const GCode&) {
    if (!x.words.axis_count) return x.core.fail(Alarm::CoordinateAxisNone, 'G', "G31");
    // Four signals, distinguished by P. P98 ends at the torque of Q percent, P99 at that torque or
    // at SKIP; nct: Q98 ends at the torque of R percent, or at the limit that the PLC gives
    // (AP_TORQ).
    std::int64_t which = 1, percent = 0;
    if (x.block.has('P') && !whole_number(x, 'P', which)) return false;
    double torque = 0.0;
    if (x.settings.policy.measuring.torque_by_q && x.block.has('Q')) {
        if (!whole_number(x, 'Q', percent)) return false;
        if (percent != 98)
            return x.core.fail(Alarm::CycleValueIllegal, 'Q', "Q", static_cast<double>(percent));
        if (x.block.has('R')) {
            if (!whole_number(x, 'R', percent)) return false;
            if (percent < 1 || percent > 99)
                return x.core.fail(Alarm::CycleValueIllegal, 'R', "R",
                                   static_cast<double>(percent));
            torque = static_cast<double>(percent) * 10.0;
        } else {
            torque = kTorqueOfPlc;
        }
        which = 98;
    } else if (which == 98 || which == 99) {
        if (x.settings.policy.measuring.torque_by_q)
            return x.core.fail(Alarm::CycleValueIllegal, 'P', "P", static_cast<double>(which));
        if (!x.block.has('Q')) return x.core.fail(Alarm::CycleWordMissing, 'G', "Q");
        if (!whole_number(x, 'Q', percent)) return false;
        if (percent < 1 || percent > 99)
            return x.core.fail(Alarm::CycleValueIllegal, 'Q', "Q", static_cast<double>(percent));
        torque = static_cast<double>(percent) * 10.0;
    } else if (x.block.has('Q') || x.block.has('R')) {
        return x.core.fail(Alarm::AddressIllegal, x.block.has('Q') ? 'Q' : 'R',
                           x.block.has('Q') ? "Q" : "R");
    }
    if (torque != 0 && x.core.compensating()) return x.core.fail(Alarm::CompReference, 'G');
    if (torque == 0 && (which < 1 || which > 4))
        return x.core.fail(Alarm::CycleValueIllegal, 'P', "P", static_cast<double>(which));
    if (!read_axis_words(x, x.words.target)) return false;
    const std::uint64_t before = x.core.moves();
    const std::string_view signal = torque == 0   ? kSignals[which - 1]
                                    : which == 99 ? kSignals[0]
                                                  : std::string_view{};
    if (!x.core.skip(x.words.target, x.settings.skip_feed, FeedMode::PerMinute, signal, false,
                     torque))
        return false;
    if (x.core.moves() != before) {
        x.awaited.measuring.skipping = x.run.wants_barrier = true;
        x.awaited.measuring.measuring = false;
    }
    return true;
}

// G4 Q: the dwell ends early at the signal of G31 Pn (n = Q), so that steps of G31 and a spark-out
// follow one another.
std::string_view dwell_signal(Execution& x) {
    std::int64_t which = 0;
    if (!x.block.has('Q') || !whole_number(x, 'Q', which)) return {};
    if (which >= 1 && which <= 4) return kSignals[which - 1];
    x.core.fail(Alarm::CycleValueIllegal, 'Q', "Q", static_cast<double>(which));
    return {};
}

bool g_measure(Execution& x, const GCode& row) {
    const bool decimal = row.tenths == 371 || row.tenths == 372;
    if (x.settings.policy.measuring.decimal_codes && decimal != x.settings.measure_by_decimal)
        return x.core.fail(Alarm::GCodeUnknown, 'G', std::string(row.name));
    if (!x.settings.policy.measuring.decimal_codes && decimal)
        return x.core.fail(Alarm::GCodeUnknown, 'G', std::string(row.name));
    if (x.block.has('T')) return x.core.fail(Alarm::MeasureWithTool, 'T');
    if (x.words.axis_count != 1)
        return x.core.fail(Alarm::CoordinateAxisNone, 'G', std::string(row.name));
    // fanuc_lathe 5: G40 before
    if (x.core.compensating()) return x.core.fail(Alarm::CompReference, 'G');
    const bool along_z = row.tenths == 370 || row.tenths == 372;
    AxisSet named = 0;
    if (!read_axis_words(x, x.words.target, &named)) return false;
    const auto place = static_cast<unsigned>(__builtin_ctz(named));
    const PlaneRole role = x.core.view().axes[place].role;
    const bool fits = along_z ? role == PlaneRole::BasicZ
                              : role == PlaneRole::BasicX || (x.settings.policy.measuring.along_y &&
                                                              role == PlaneRole::BasicY);
    if (!fits)
        return x.core.fail(Alarm::AddressIllegal, x.core.view().axes[place].name[0],
                           std::string(x.core.view().axes[place].name));
    if (measured_offset(x) == 0) return x.core.fail(Alarm::MeasureNoOffset, 'G');
    if (x.settings.policy.measuring.input_by_number && x.settings.measure_input == 0)
        return x.core.fail(Alarm::MeasureInputNone, 'G');

    const std::size_t k = role == PlaneRole::BasicX ? 0 : role == PlaneRole::BasicY ? 1 : 2;
    const double target = x.words.target[place], now = x.core.path.programmed[place];
    const double towards = target < now ? -1.0 : 1.0;
    // nct: a mill measures along Z with distances of its own (N3004, N3005).
    const bool mill = x.settings.policy.measuring.distances_of_mills &&
                      x.core.view().config().kind == ChannelKind::Mill;
    const double unit =
        params::bit(x.core.view().table(), params::n0104_unit_of_measure, x.core.view().channel, 0)
            ? 25.4
            : 1.0;
    const double range = mill ? params::get(x.core.view().table(), params::n3005_alarm_distance,
                                            x.core.view().channel) *
                                    unit
                              : x.settings.measure_range[k];
    const double rapid = mill ? params::get(x.core.view().table(), params::n3004_rapid_distance,
                                            x.core.view().channel) *
                                    unit
                              : x.settings.measure_rapid[k];
    x.awaited.measuring = {false, true, place, target, range};
    AxisValues point = x.core.path.programmed;
    const double begin = target - towards * rapid;
    if ((begin - now) * towards > 0) {  // already closer than that: no rapid move
        point[place] = begin;
        if (!x.core.rapid(point)) return false;
    }
    point = x.core.path.programmed;
    point[place] = target + towards * range;
    const std::string number = std::to_string(x.settings.measure_input);
    const std::string_view input = x.settings.policy.measuring.input_by_number
                                       ? std::string_view(number)
                                   : role == PlaneRole::BasicX ? "XAE"
                                                               : "ZAE";
    if (!x.core.skip(point, x.settings.measure_feed, FeedMode::PerMinute, input)) return false;
    x.awaited.measuring.skipping = x.run.wants_barrier = true;
    return true;
}

// Behind the barrier: the axes stand where the signal came.
Step finish_skip(Execution& x) {
    const Measuring done = x.awaited.measuring;
    x.awaited.measuring = {};
    x.core.begin_block();
    const AxisSet early = x.core.take_skip();
    if (!done.measuring) return Step::Continue;
    const MachineView& view = x.core.view();
    const double stopped = x.core.skip_point(done.place), difference = stopped - done.target;
    const bool came = (early >> done.place & 1u) != 0;
    if (!came || std::fabs(difference) > done.range + 1e-9)
        return report(x, {Alarm::MeasureNoSignal, 'G', done.range, 0.0, {}, {}});
    const OffsetTable table =
        x.settings.measure_to_wear ? OffsetTable::Wear : OffsetTable::Geometry;
    const std::int32_t number = measured_offset(x);
    const PlaneRole role = view.axes[done.place].role;
    const OffsetField field = role == PlaneRole::BasicX   ? OffsetField::X
                              : role == PlaneRole::BasicY ? OffsetField::Y
                                                          : OffsetField::Z;
    const OffsetCell& cell = view.store->offsets[static_cast<std::size_t>(number)];
    const double before =
        (x.settings.measure_to_wear ? cell.wear : cell.geometry)[static_cast<std::size_t>(field)];
    // Fanuc: where the offset is that of the nose's centre, the nose touches one radius ahead of it
    // (fanuc_lathe 5.2). The way went from before the target towards it.
    const ToolState& tool = x.core.path.tool;
    const bool centre = x.settings.policy.measuring.nose_centre && (tool.tip == 0 || tool.tip == 9);
    const double ahead =
        centre ? std::copysign(tool.nose_radius,
                               static_cast<double>(x.core.path.last_travel[done.place]))
               : 0.0;
    const double change = view.to_offset(done.place, difference + ahead);
    write_offset(x, table, number, field,
                 x.settings.measure_added ? before + change : before - change);
    x.core.end_block();
    x.run.fresh = false;
    return Step::Continue;
}

}  // namespace polyturn::channels::fanuc
