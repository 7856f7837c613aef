// Polygon turning (fanuc_lathe 10.1) and the electronic gear box (nct_parameters_part2 19): a
// cutter or a workpiece axis turns by the turns of a spindle. What that means while it runs is the
// kernel's (kernel/spindles/spindle_couplings.hpp).
#include <cmath>

#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {
namespace {
namespace p = params;
constexpr double kPi = 3.14159265358979323846;
}  // namespace

// The axis of F7610, or the driven tool spindle of the channel.
bool Interpreter::polygon_follower(std::uint8_t& follower) {
    const MachineView& view = core_.view();
    const auto place = static_cast<unsigned>(p::get(view.table(), p::f7610, view.channel));
    const auto spindle =
        static_cast<unsigned>(p::get(view.table(), p::pt_driven_spindle, view.channel));
    if (place > view.axis_count || (place == 0 && spindle == 0))
        return core_.fail(Alarm::PolygonTool, 'G');
    follower = place != 0 ? view.axes[place - 1].machine_axis
                          : static_cast<std::uint8_t>(kMaxAxes + spindle - 1);
    return true;
}

bool Interpreter::turns_polygon(unsigned place) const {
    const MachineView& view = core_.view();
    return polygon_on_ && !settings_.nct &&
           p::get(view.table(), p::f7610, view.channel) == static_cast<std::int64_t>(place) + 1;
}

// fanuc_lathe 10.1: G50.2 has a block of its own; alarm 219 of the control says the same of
// G51.2.
bool Interpreter::polygon_alone() {
    if (settings_.nct || !(coded_groups_ >> static_cast<unsigned>(GGroup::OneShot) & 1u))
        return true;
    const GCode* row = coded_[static_cast<std::size_t>(GGroup::OneShot)];
    if (row->act != &Interpreter::g_polygon && row->act != &Interpreter::g_polygon_off) return true;
    return g_count_ == 1 && !axis_word_count_ && !m_count_ && !block_.has('S') &&
                   !block_.has('T') && !block_.has('F')
               ? true
               : core_.fail(Alarm::PolygonNotAlone, 'G');
}

bool Interpreter::g_polygon(const GCode&) {
    if (polygon_on_) return core_.fail(Alarm::PolygonTwice, 'G');
    if (balance_on_) return core_.fail(Alarm::PolygonBalance, 'G');
    const auto ratio = [&](char letter, bool negative, double& out) {
        out = block_.has(letter) ? block_.value(letter) : 0.0;
        const double size = negative ? std::fabs(out) : out;
        return size >= 1 && size <= 9 && out == std::floor(out)
                   ? true
                   : core_.fail(Alarm::PolygonRatio, block_.has(letter) ? letter : 'G',
                                std::string(1, letter), out);
    };
    Spindle told;
    told.mode = SpindleModeCode::Couple;
    told.spindle = core_.path.spindle.spindle;
    if (told.spindle == 0) return core_.fail(Alarm::SpindleMissing, 'G');
    if (!ratio('P', false, told.master_turns) || !ratio('Q', true, told.turns) ||
        !polygon_follower(told.follower))
        return false;
    told.phase_deg = 0;  // from the one-rotation signal on
    told.cutter = true;
    polygon_on_ = wants_barrier_ = true;
    return core_.couple_spindle(told);
}

bool Interpreter::g_polygon_off(const GCode&) {
    Spindle told;
    told.mode = SpindleModeCode::Uncouple;
    told.spindle = core_.path.spindle.spindle;
    if (!polygon_follower(told.follower)) return false;
    polygon_on_ = false;
    wants_barrier_ = true;
    return core_.couple_spindle(told);
}

// G81.8 T(teeth) L(starts) Q(module) P(helix angle): the workpiece turns L/T of the tool's turns,
// and by Z sin P / (pi Q T) of a turn more for the helix.
bool Interpreter::g_gear(const GCode&) {
    const MachineView& view = core_.view();
    const params::Table& t = view.table();
    const auto number = [&](auto handle) {
        return static_cast<unsigned>(p::get(t, handle, view.channel));
    };
    const unsigned master = number(p::n1801_egb_master), slave = number(p::n1802_egb_slave),
                   helix = number(p::n1803_helical_comp_axis);
    if (master == 0 || slave == 0)
        return core_.fail(Alarm::GearUndefined, 'G', master == 0 ? "N1801" : "N1802");
    const double teeth = block_.has('T') ? block_.value('T') : 0.0,
                 starts = block_.has('L') ? block_.value('L') : 1.0;
    if (!(teeth >= 1) || teeth != std::floor(teeth))
        return core_.fail(Alarm::GearUndefined, block_.has('T') ? 'T' : 'G', "T", teeth);
    if (starts == 0 || starts != std::floor(starts))
        return core_.fail(Alarm::GearUndefined, 'L', "L", starts);
    Spindle told;
    told.mode = SpindleModeCode::Couple;
    told.spindle = static_cast<std::uint16_t>(master);
    told.follower = static_cast<std::uint8_t>(slave - 1);
    told.turns = starts;
    told.master_turns = teeth;
    told.gear = true;
    const double angle = block_.has('P') ? block_.value('P') : 0.0;
    if (angle != 0) {
        const double module = block_.has('Q') ? block_.value('Q') : 0.0;
        if (helix == 0 || !(module > 0))
            return core_.fail(Alarm::GearUndefined, 'P', helix == 0 ? "N1803" : "Q");
        told.helix = static_cast<std::uint8_t>(helix - 1);
        told.helix_deg_mm = std::sin(angle * kPi / 180.0) / (kPi * module * teeth) * 360.0;
    }
    core_.gear_feed = {
        master, p::bit(t, p::n1800_egb_contr, view.channel, 1) ? std::fabs(starts / teeth) : 1.0};
    wants_barrier_ = true;
    return core_.couple_spindle(told);
}

bool Interpreter::g_gear_off(const GCode&) {
    const MachineView& view = core_.view();
    const auto slave =
        static_cast<unsigned>(p::get(view.table(), p::n1802_egb_slave, view.channel));
    if (slave == 0) return core_.fail(Alarm::GearUndefined, 'G', "N1802");
    Spindle told;
    told.mode = SpindleModeCode::Uncouple;
    told.follower = static_cast<std::uint8_t>(slave - 1);
    core_.gear_feed = {};
    wants_barrier_ = true;
    return core_.couple_spindle(told);
}

}  // namespace polyturn::channels::fanuc
