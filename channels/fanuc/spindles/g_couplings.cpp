// Polygon turning (fanuc_lathe 10.1) and the electronic gear box (nct_parameters_part2 19): a
// cutter or a workpiece axis turns by the turns of a spindle. What that means while it runs is the
// kernel's (kernel/spindles/spindle_couplings.hpp).
#include "channels/fanuc/spindles/g_couplings.hpp"

#include <cmath>

#include "channels/fanuc/execution.hpp"

namespace polyturn::channels::fanuc {
namespace {

namespace p = params;

constexpr double kPi = 3.14159265358979323846;

// The axis of F7610, or the driven tool spindle of the channel.
bool polygon_follower(Execution& x, std::uint8_t& follower) {
    const MachineView& view = x.core.view();
    const auto place = static_cast<unsigned>(p::get(view.table(), p::f7610, view.channel));
    const auto spindle =
        static_cast<unsigned>(p::get(view.table(), p::pt_driven_spindle, view.channel));
    if (place > view.axis_count || (place == 0 && spindle == 0))
        return x.core.fail(Alarm::PolygonTool, 'G');
    follower = place != 0 ? view.axes[place - 1].machine_axis
                          : static_cast<std::uint8_t>(kMaxAxes + spindle - 1);
    return true;
}

}  // namespace

bool gear_block(const Execution& x) {
    return x.words.has(GGroup::OneShot) && x.words.row(GGroup::OneShot)->tenths == 818;
}

bool turns_polygon(const Execution& x, unsigned place) {
    const MachineView& view = x.core.view();
    return x.machine.polygon_on && x.settings.policy.spindles.polygon_holds_axis &&
           p::get(view.table(), p::f7610, view.channel) == static_cast<std::int64_t>(place) + 1;
}

// fanuc_lathe 10.1: G50.2 has a block of its own; alarm 219 of the control says the same of
// G51.2.
bool polygon_alone(Execution& x) {
    if (!x.settings.policy.spindles.polygon_alone || !x.words.has(GGroup::OneShot)) return true;
    const GCode* row = x.words.row(GGroup::OneShot);
    if (!row->is(Trait::Polygon)) return true;
    return x.words.g_count == 1 && !x.words.axis_count && !x.words.m_count && !x.block.has('S') &&
                   !x.block.has('T') && !x.block.has('F')
               ? true
               : x.core.fail(Alarm::PolygonNotAlone, 'G');
}

bool g_polygon(Execution& x, const GCode&) {
    if (x.machine.polygon_on) return x.core.fail(Alarm::PolygonTwice, 'G');
    if (x.machine.balance_on) return x.core.fail(Alarm::PolygonBalance, 'G');
    const auto ratio = [&](char letter, bool negative, double& out) {
        out = x.block.has(letter) ? x.block.value(letter) : 0.0;
        const double size = negative ? std::fabs(out) : out;
        return size >= 1 && size <= 9 && out == std::floor(out)
                   ? true
                   : x.core.fail(Alarm::PolygonRatio, x.block.has(letter) ? letter : 'G',
                                 std::string(1, letter), out);
    };
    Spindle told;
    told.mode = SpindleModeCode::Couple;
    told.spindle = x.core.path.spindle.spindle;
    if (told.spindle == 0) return x.core.fail(Alarm::SpindleMissing, 'G');
    if (!ratio('P', false, told.master_turns) || !ratio('Q', true, told.turns) ||
        !polygon_follower(x, told.follower))
        return false;
    told.phase_deg = 0;  // from the one-rotation signal on
    told.cutter = true;
    x.machine.polygon_on = x.run.wants_barrier = true;
    return x.core.couple_spindle(told);
}

bool g_polygon_off(Execution& x, const GCode&) {
    Spindle told;
    told.mode = SpindleModeCode::Uncouple;
    told.spindle = x.core.path.spindle.spindle;
    if (!polygon_follower(x, told.follower)) return false;
    x.machine.polygon_on = false;
    x.run.wants_barrier = true;
    return x.core.couple_spindle(told);
}

// G81.8 T(teeth) L(starts) Q(module) P(helix angle): the workpiece turns L/T of the tool's turns,
// and by Z sin P / (pi Q T) of a turn more for the helix.
bool g_gear(Execution& x, const GCode&) {
    const MachineView& view = x.core.view();
    const params::Table& t = view.table();
    const auto number = [&](auto handle) {
        return static_cast<unsigned>(p::get(t, handle, view.channel));
    };
    const unsigned master = number(p::n1801_egb_master), slave = number(p::n1802_egb_slave),
                   helix = number(p::n1803_helical_comp_axis);
    if (master == 0 || slave == 0)
        return x.core.fail(Alarm::GearUndefined, 'G', master == 0 ? "N1801" : "N1802");
    const double teeth = x.block.has('T') ? x.block.value('T') : 0.0,
                 starts = x.block.has('L') ? x.block.value('L') : 1.0;
    if (!(teeth >= 1) || teeth != std::floor(teeth))
        return x.core.fail(Alarm::GearUndefined, x.block.has('T') ? 'T' : 'G', "T", teeth);
    if (starts == 0 || starts != std::floor(starts))
        return x.core.fail(Alarm::GearUndefined, 'L', "L", starts);
    Spindle told;
    told.mode = SpindleModeCode::Couple;
    told.spindle = static_cast<std::uint16_t>(master);
    told.follower = static_cast<std::uint8_t>(slave - 1);
    told.turns = starts;
    told.master_turns = teeth;
    told.gear = true;
    const double angle = x.block.has('P') ? x.block.value('P') : 0.0;
    if (angle != 0) {
        const double module = x.block.has('Q') ? x.block.value('Q') : 0.0;
        if (helix == 0 || !(module > 0))
            return x.core.fail(Alarm::GearUndefined, 'P', helix == 0 ? "N1803" : "Q");
        told.helix = static_cast<std::uint8_t>(helix - 1);
        told.helix_deg_mm = std::sin(angle * kPi / 180.0) / (kPi * module * teeth) * 360.0;
    }
    x.core.gear_feed = {
        master, p::bit(t, p::n1800_egb_contr, view.channel, 1) ? std::fabs(starts / teeth) : 1.0};
    x.run.wants_barrier = true;
    return x.core.couple_spindle(told);
}

bool g_gear_off(Execution& x, const GCode&) {
    const MachineView& view = x.core.view();
    const auto slave =
        static_cast<unsigned>(p::get(view.table(), p::n1802_egb_slave, view.channel));
    if (slave == 0) return x.core.fail(Alarm::GearUndefined, 'G', "N1802");
    Spindle told;
    told.mode = SpindleModeCode::Uncouple;
    told.follower = static_cast<std::uint8_t>(slave - 1);
    x.core.gear_feed = {};
    x.run.wants_barrier = true;
    return x.core.couple_spindle(told);
}

}  // namespace polyturn::channels::fanuc
