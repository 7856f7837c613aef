// G31: a move that a signal ends, or a torque. G36, G37 (G37.1, G37.2): measuring the tool's offset
// with such a move.
//
//   start ----- rapid -----> T . . . feed . . . U ===== target ===== V      T: rapid distance before the target
//                                               '- the signal counts here -'
//
// The block has two halves: moves up to the barrier, and what follows from where the axes stopped
// (finish_skip).
#include <cmath>

#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {
namespace {
constexpr std::string_view kSignals[] = {"SKIP", "SKIP2", "SKIP3", "SKIP4"};
}

bool Interpreter::g_skip(const GCode&) {
    if (!axis_word_count_) return core_.fail(Alarm::CoordinateAxisNone, 'G', "G31");
    // Four signals, distinguished by P. P98 ends at the torque of Q percent, P99 at that torque or
    // at SKIP; nct: Q98 ends at the torque of R percent, or at the limit that the PLC gives
    // (AP_TORQ).
    std::int64_t which = 1, percent = 0;
    if (block_.has('P') && !whole('P', which)) return false;
    double torque = 0.0;
    if (settings_.nct && block_.has('Q')) {
        if (!whole('Q', percent)) return false;
        if (percent != 98)
            return core_.fail(Alarm::CycleValueIllegal, 'Q', "Q", static_cast<double>(percent));
        if (block_.has('R')) {
            if (!whole('R', percent)) return false;
            if (percent < 1 || percent > 99)
                return core_.fail(Alarm::CycleValueIllegal, 'R', "R", static_cast<double>(percent));
            torque = static_cast<double>(percent) * 10.0;
        } else {
            torque = kTorqueOfPlc;
        }
        which = 98;
    } else if (which == 98 || which == 99) {
        if (settings_.nct)
            return core_.fail(Alarm::CycleValueIllegal, 'P', "P", static_cast<double>(which));
        if (!block_.has('Q')) return core_.fail(Alarm::CycleWordMissing, 'G', "Q");
        if (!whole('Q', percent)) return false;
        if (percent < 1 || percent > 99)
            return core_.fail(Alarm::CycleValueIllegal, 'Q', "Q", static_cast<double>(percent));
        torque = static_cast<double>(percent) * 10.0;
    } else if (block_.has('Q') || block_.has('R')) {
        return core_.fail(Alarm::AddressIllegal, block_.has('Q') ? 'Q' : 'R',
                          block_.has('Q') ? "Q" : "R");
    }
    if (torque != 0 && core_.compensating()) return core_.fail(Alarm::CompReference, 'G');
    if (torque == 0 && (which < 1 || which > 4))
        return core_.fail(Alarm::CycleValueIllegal, 'P', "P", static_cast<double>(which));
    if (!read_axis_words(target_)) return false;
    const std::uint64_t before = core_.moves();
    const std::string_view signal = torque == 0   ? kSignals[which - 1]
                                    : which == 99 ? kSignals[0]
                                                  : std::string_view{};
    if (!core_.skip(target_, settings_.skip_feed, FeedMode::PerMinute, signal, false, torque))
        return false;
    if (core_.moves() != before) {
        measuring_.skipping = wants_barrier_ = true;
        measuring_.measuring = false;
    }
    return true;
}

// G4 Q: the dwell ends early at the signal of G31 Pn (n = Q), so that steps of G31 and a spark-out
// follow one another.
std::string_view Interpreter::dwell_signal() {
    std::int64_t which = 0;
    if (!block_.has('Q') || !whole('Q', which)) return {};
    if (which >= 1 && which <= 4) return kSignals[which - 1];
    core_.fail(Alarm::CycleValueIllegal, 'Q', "Q", static_cast<double>(which));
    return {};
}

// The offset that T selects; where lengths are called by G43 H (nct: milling, N1414 TCM), the one
// of H.
std::int32_t Interpreter::measured_offset() const {
    const ToolState& tool = core_.path.tool;
    const std::int32_t by_tool = settings_.measure_to_wear ? tool.wear : tool.geometry;
    return by_tool != 0 ? by_tool : length_.number;
}

bool Interpreter::g_measure(const GCode& row) {
    const bool decimal = row.tenths == 371 || row.tenths == 372;
    if (!settings_.nct && decimal != settings_.measure_by_decimal)
        return core_.fail(Alarm::GCodeUnknown, 'G', std::string(row.name));
    if (settings_.nct && decimal)
        return core_.fail(Alarm::GCodeUnknown, 'G', std::string(row.name));
    if (block_.has('T')) return core_.fail(Alarm::MeasureWithTool, 'T');
    if (axis_word_count_ != 1)
        return core_.fail(Alarm::CoordinateAxisNone, 'G', std::string(row.name));
    // fanuc_lathe 5: G40 before
    if (core_.compensating()) return core_.fail(Alarm::CompReference, 'G');
    const bool along_z = row.tenths == 370 || row.tenths == 372;
    AxisSet named = 0;
    if (!read_axis_words(target_, &named)) return false;
    const auto place = static_cast<unsigned>(__builtin_ctz(named));
    const PlaneRole role = core_.view().axes[place].role;
    const bool fits =
        along_z ? role == PlaneRole::BasicZ
                : role == PlaneRole::BasicX || (settings_.nct && role == PlaneRole::BasicY);
    if (!fits)
        return core_.fail(Alarm::AddressIllegal, core_.view().axes[place].name[0],
                          std::string(core_.view().axes[place].name));
    if (measured_offset() == 0) return core_.fail(Alarm::MeasureNoOffset, 'G');
    if (settings_.nct && settings_.measure_input == 0)
        return core_.fail(Alarm::MeasureInputNone, 'G');

    const std::size_t k = role == PlaneRole::BasicX ? 0 : role == PlaneRole::BasicY ? 1 : 2;
    const double target = target_[place], now = core_.path.programmed[place];
    const double towards = target < now ? -1.0 : 1.0;
    // nct: a mill measures along Z with distances of its own (N3004, N3005).
    const bool mill = settings_.nct && core_.view().config().kind == ChannelKind::Mill;
    const double unit =
        params::bit(core_.view().table(), params::n0104_unit_of_measure, core_.view().channel, 0)
            ? 25.4
            : 1.0;
    const double range = mill ? params::get(core_.view().table(), params::n3005_alarm_distance,
                                            core_.view().channel) *
                                    unit
                              : settings_.measure_range[k];
    const double rapid = mill ? params::get(core_.view().table(), params::n3004_rapid_distance,
                                            core_.view().channel) *
                                    unit
                              : settings_.measure_rapid[k];
    measuring_ = {false, true, place, target, range};
    AxisValues point = core_.path.programmed;
    const double begin = target - towards * rapid;
    if ((begin - now) * towards > 0) {  // already closer than that: no rapid move
        point[place] = begin;
        if (!core_.rapid(point)) return false;
    }
    point = core_.path.programmed;
    point[place] = target + towards * range;
    const std::string number = std::to_string(settings_.measure_input);
    const std::string_view input = settings_.nct               ? std::string_view(number)
                                   : role == PlaneRole::BasicX ? "XAE"
                                                               : "ZAE";
    if (!core_.skip(point, settings_.measure_feed, FeedMode::PerMinute, input)) return false;
    measuring_.skipping = wants_barrier_ = true;
    return true;
}

// Behind the barrier: the axes stand where the signal came.
Step Interpreter::finish_skip() {
    const Measuring done = measuring_;
    measuring_ = {};
    core_.begin_block();
    const AxisSet early = core_.take_skip();
    if (!done.measuring) return Step::Continue;
    const MachineView& view = core_.view();
    const double stopped = core_.skip_point(done.place), difference = stopped - done.target;
    const bool came = (early >> done.place & 1u) != 0;
    if (!came || std::fabs(difference) > done.range + 1e-9)
        return fault({Alarm::MeasureNoSignal, 'G', done.range, 0.0, {}, {}});
    const OffsetTable table = settings_.measure_to_wear ? OffsetTable::Wear : OffsetTable::Geometry;
    const std::int32_t number = measured_offset();
    const PlaneRole role = view.axes[done.place].role;
    const OffsetField field = role == PlaneRole::BasicX   ? OffsetField::X
                              : role == PlaneRole::BasicY ? OffsetField::Y
                                                          : OffsetField::Z;
    const OffsetCell& cell = view.store->offsets[static_cast<std::size_t>(number)];
    const double before =
        (settings_.measure_to_wear ? cell.wear : cell.geometry)[static_cast<std::size_t>(field)];
    // Fanuc: where the offset is that of the nose's centre, the nose touches one radius ahead of it
    // (fanuc_lathe 5.2). The way went from before the target towards it.
    const ToolState& tool = core_.path.tool;
    const bool centre = !settings_.nct && (tool.tip == 0 || tool.tip == 9);
    const double ahead =
        centre ? std::copysign(tool.nose_radius,
                               static_cast<double>(core_.path.last_travel[done.place]))
               : 0.0;
    const double change = view.to_offset(done.place, difference + ahead);
    write_offset(table, number, field, settings_.measure_added ? before + change : before - change);
    core_.end_block();
    fresh_ = false;
    return Step::Continue;
}

}  // namespace polyturn::channels::fanuc
