// Synchronous spindles: COUPDEF COUPDEL COUPRES COUPON COUPONC COUPOF COUPOFS WAITC
// (sinumerik_part3 7.18). What turns by another's turns is the kernel's
// (kernel/spindles/spindle_couplings.hpp): its record holds the program until the follower runs
// synchronously, so every block-change criterion is met behind COUPON.
#include "channels/sinumerik/coupling/couplings.hpp"

#include <cmath>

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/axes/positioning.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/frames/settable_frames.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/spindles/spindle_commands.hpp"

namespace polyturn::channels::sinumerik {
namespace {

namespace p = params;

bool one_of(const std::string& text, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names)
        if (text == name) return true;
    return text.empty();
}

// Following and leading spindle of a call; false: fault().
bool spindle_pair(Execution& x, const Call& c, std::uint16_t& follows, std::uint16_t& leads) {
    if (!feed_source(x, c.arguments[0], follows)) return false;
    leads = 0;
    if (c.has(1) && c.value(1).type != Type::String && !feed_source(x, c.arguments[1], leads))
        return false;
    return follows != leads || fail(x, Alarm::SpindleNumberIllegal, {}, leads);
}

// The ratio that the machine data give: PT_SYNC_TURNS to PT_SYNC_MASTER_TURNS where the leading
// spindle is the configured one.
SpindleRatio configured_ratio(Execution& x, std::uint16_t follows, std::uint16_t leads) {
    const params::Table& table = x.core.view().table();
    if (p::get(table, p::pt_spindle_master, follows) != leads) return {};
    return {static_cast<double>(p::get(table, p::pt_sync_turns, follows)),
            static_cast<double>(p::get(table, p::pt_sync_master_turns, follows))};
}

// COUPOF: the follower turns on as fast as it does. It gets that as its command, and the PLC its
// direction, while it still follows: so nothing brakes it.
bool keeps_turning(Execution& x, std::uint16_t follows) {
    constexpr double kStandsRpm = 1.0;
    if (!need_fresh(x)) return false;
    const auto now = x.core.port().spindle_turns(follows);
    if (!now || std::fabs(*now) < kStandsRpm) return true;
    const double share = x.core.port().spindle_override(follows),
                 rpm = std::round(std::fabs(*now) * 10.0) / 10.0 / (share > 0 ? share : 1.0);
    const SpindleTurn turn = *now > 0 ? SpindleTurn::Cw : SpindleTurn::Ccw;
    return with_spindle(x, follows, [&] {
        SpindleState& state = x.core.path.spindle;
        state.turn = turn;
        state.rpm = rpm;
        state.mode = SpindleModeCode::Rpm;
        state.commanded = true;
        Spindle speed;
        speed.spindle = follows;
        speed.value = rpm;
        speed.turn = turn;
        speed.mode_changed = speed.silent = speed.for_release = true;
        x.core.mark_emitted();
        x.core.sink().spindle(speed, x.core.at);
        Aux turns;
        turns.value = turn == SpindleTurn::Cw ? 3 : 4;
        turns.text = turn == SpindleTurn::Cw ? "M3" : "M4";
        turns.silent = true;
        x.core.sink().aux(turns, x.core.at);
        return true;
    });
}

}  // namespace

bool p_coupling(Execution& x, Call& c) {
    const std::string_view name = x.block.procedures.front().first->name;
    std::uint16_t follows = 0, leads = 0;
    if (!spindle_pair(x, c, follows, leads)) return false;
    const std::uint32_t key = follows * 100u + leads;
    auto& defined = x.modal.couplings;
    const bool coupled = x.modal.coupled_spindles >> (follows - 1) & 1u;
    if (name == "WAITC")
        return coupled || fail(x, Alarm::SpindleCoupleRefused, "S" + std::to_string(follows));
    if (leads == 0) return fail(x, Alarm::ArgumentMissing, std::string(name), 2);
    if (name == "COUPDEF") {
        const double turns = c.has(2) ? c.number(2) : 1.0,
                     master_turns = c.has(3) ? c.number(3) : 1.0;
        if (turns == 0 || master_turns == 0)
            return fail(x, Alarm::ValueOutOfRange, "COUPDEF", turns == 0 ? turns : master_turns);
        if (c.has(4) && !one_of(c.value(4).text, {"NOC", "FINE", "COARSE", "IPOSTOP"}))
            return fail(x, Alarm::FunctionArgument, c.value(4).text);
        if (c.has(5) && !one_of(c.value(5).text, {"DV", "AV", "VV"}))
            return fail(x, Alarm::FunctionArgument, c.value(5).text);
        if (coupled) return fail(x, Alarm::CodesContradict, "COUPDEF, COUPON");
        defined[key] = {turns, master_turns};
        return true;
    }
    if (name == "COUPDEL" || name == "COUPRES") {
        if (coupled) return fail(x, Alarm::CodesContradict, std::string(name) + ", COUPON");
        if (name == "COUPDEL")
            defined.erase(key);
        else
            defined[key] = configured_ratio(x, follows, leads);
        return true;
    }
    Spindle told;
    told.spindle = leads;
    told.follower = static_cast<std::uint8_t>(kMaxAxes + follows - 1);
    if (name.starts_with("COUPON")) {
        const auto kept = defined.find(key);
        const SpindleRatio ratio =
            kept != defined.end() ? kept->second : configured_ratio(x, follows, leads);
        if (name == "COUPONC") {  // its own speed lies over the coupling
            const auto other = x.modal.spindles.find(follows);
            const SpindleState* const now = x.core.path.spindle.spindle == follows
                                                ? &x.core.path.spindle
                                            : other != x.modal.spindles.end() ? &other->second
                                                                              : nullptr;
            if (now) told.value = now->rpm * static_cast<double>(now->turn);
        }
        told.mode = SpindleModeCode::Couple;
        told.turns = ratio.turns;
        told.master_turns = ratio.master_turns;
        if (c.has(2)) told.phase_deg = c.number(2);
        x.modal.coupled_spindles |= 1u << (follows - 1);
    } else {
        // crossing angles before it lets go
        if (c.has(2)) return fail(x, Alarm::NotBuilt, std::string(name) + ": POSFS");
        if (name == "COUPOF" && !keeps_turning(x, follows)) return false;
        told.mode = SpindleModeCode::Uncouple;
        told.spindle = x.modal.master_spindle;
        told.for_release = name == "COUPOF";
        x.modal.coupled_spindles &= ~(1u << (follows - 1));
    }
    stop_reading(x);
    if (!x.core.couple_spindle(told)) return false;
    if (name != "COUPOFS") return true;  // COUPOF: it turns on as fast as it was
    return with_spindle(x, follows, [&] {
        if (!x.core.spindle_turn(SpindleTurn::Stop) || !x.core.commit_spindle()) return false;
        Aux stop;  // by the PLC's M5: a later S of it does not set it turning
        stop.value = 5;
        stop.text = "M5";
        stop.silent = true;
        x.core.mark_emitted();
        x.core.sink().aux(stop, x.core.at);
        return true;
    });
}

// POSRANGE(axis, reference, width, system): does the set position lie in the interval about the
// reference? 0 MCS, 1 BCS, 2 SZS, 3 WCS.
bool f_posrange(Execution& x, Call& c) {
    std::size_t place = 0;
    if (!axis_argument(x, c, 0, "POSRANGE", place)) return false;
    const double system = c.has(3) ? c.number(3) : 0.0;
    if (system != std::floor(system) || system < 0 || system > 3)
        return fail(x, Alarm::FunctionArgument, "POSRANGE", system);
    if (!need_fresh(x)) return false;
    double now = x.core.machine_now(static_cast<unsigned>(place));
    if (system == 2)
        now = programmable(x, x.core.path.programmed)[place];
    else if (system == 3)
        now = x.core.path.programmed[place];
    if (system >= 2) now *= counts_diameter(x, static_cast<unsigned>(place), false) ? 2.0 : 1.0;
    const double factor = x.core.view().axes[place].rotary ? 1.0 : unit(x);
    c.result = Value::of_bool(std::fabs(now - c.number(1) * factor) <=
                              std::fabs(c.number(2) * factor) / 2 + 1e-9);
    return true;
}

}  // namespace polyturn::channels::sinumerik
