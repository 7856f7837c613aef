// Synchronous spindles: COUPDEF COUPDEL COUPRES COUPON COUPONC COUPOF COUPOFS WAITC
// (sinumerik_part3 7.18). What turns by another's turns is the kernel's
// (kernel/spindles/spindle_couplings.hpp): its record holds the program until the follower runs
// synchronously, so every block-change criterion is met behind COUPON.
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

namespace p = params;

bool one_of(const std::string& text, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names)
        if (text == name) return true;
    return text.empty();
}

}  // namespace

// Following and leading spindle of a call; false: fault().
bool Interpreter::spindle_pair(const Call& c, std::uint16_t& follows, std::uint16_t& leads) {
    if (!feed_source(c.arguments[0], follows)) return false;
    leads = 0;
    if (c.has(1) && c.value(1).type != Type::String && !feed_source(c.arguments[1], leads))
        return false;
    return follows != leads || fail(Alarm::SpindleNumberIllegal, {}, leads);
}

// The ratio that the machine data give: PT_SYNC_TURNS to PT_SYNC_MASTER_TURNS where the leading
// spindle is the configured one.
SpindleRatio Interpreter::configured_ratio(std::uint16_t follows, std::uint16_t leads) {
    const params::Table& table = core_.view().table();
    if (p::get(table, p::pt_spindle_master, follows) != leads) return {};
    return {static_cast<double>(p::get(table, p::pt_sync_turns, follows)),
            static_cast<double>(p::get(table, p::pt_sync_master_turns, follows))};
}

bool Interpreter::p_coupling(Call& c) {
    const std::string_view name = block_.procedures.front().first->name;
    std::uint16_t follows = 0, leads = 0;
    if (!spindle_pair(c, follows, leads)) return false;
    const std::uint32_t key = follows * 100u + leads;
    auto& defined = modal_.couplings;
    const bool coupled = modal_.coupled_spindles >> (follows - 1) & 1u;
    if (name == "WAITC")
        return coupled || fail(Alarm::SpindleCoupleRefused, "S" + std::to_string(follows));
    if (leads == 0) return fail(Alarm::ArgumentMissing, std::string(name), 2);
    if (name == "COUPDEF") {
        const double turns = c.has(2) ? c.number(2) : 1.0,
                     master_turns = c.has(3) ? c.number(3) : 1.0;
        if (turns == 0 || master_turns == 0)
            return fail(Alarm::ValueOutOfRange, "COUPDEF", turns == 0 ? turns : master_turns);
        if (c.has(4) && !one_of(c.value(4).text, {"NOC", "FINE", "COARSE", "IPOSTOP"}))
            return fail(Alarm::FunctionArgument, c.value(4).text);
        if (c.has(5) && !one_of(c.value(5).text, {"DV", "AV", "VV"}))
            return fail(Alarm::FunctionArgument, c.value(5).text);
        if (coupled) return fail(Alarm::CodesContradict, "COUPDEF, COUPON");
        defined[key] = {turns, master_turns};
        return true;
    }
    if (name == "COUPDEL" || name == "COUPRES") {
        if (coupled) return fail(Alarm::CodesContradict, std::string(name) + ", COUPON");
        if (name == "COUPDEL")
            defined.erase(key);
        else
            defined[key] = configured_ratio(follows, leads);
        return true;
    }
    Spindle told;
    told.spindle = leads;
    told.follower = static_cast<std::uint8_t>(kMaxAxes + follows - 1);
    if (name.starts_with("COUPON")) {
        const auto kept = defined.find(key);
        const SpindleRatio ratio =
            kept != defined.end() ? kept->second : configured_ratio(follows, leads);
        if (name == "COUPONC") {  // its own speed lies over the coupling
            const auto other = modal_.spindles.find(follows);
            const SpindleState* const now = core_.path.spindle.spindle == follows
                                                ? &core_.path.spindle
                                            : other != modal_.spindles.end() ? &other->second
                                                                             : nullptr;
            if (now) told.value = now->rpm * static_cast<double>(now->turn);
        }
        told.mode = SpindleModeCode::Couple;
        told.turns = ratio.turns;
        told.master_turns = ratio.master_turns;
        if (c.has(2)) told.phase_deg = c.number(2);
        modal_.coupled_spindles |= 1u << (follows - 1);
    } else {
        // crossing angles before it lets go
        if (c.has(2)) return fail(Alarm::NotBuilt, std::string(name) + ": POSFS");
        if (name == "COUPOF" && !keeps_turning(follows)) return false;
        told.mode = SpindleModeCode::Uncouple;
        told.spindle = modal_.master_spindle;
        told.for_release = name == "COUPOF";
        modal_.coupled_spindles &= ~(1u << (follows - 1));
    }
    stop_reading();
    if (!core_.couple_spindle(told)) return false;
    if (name != "COUPOFS") return true;  // COUPOF: it turns on as fast as it was
    return with_spindle(follows, [&] {
        if (!core_.spindle_turn(SpindleTurn::Stop) || !core_.commit_spindle()) return false;
        Aux stop;  // by the PLC's M5: a later S of it does not set it turning
        stop.value = 5;
        stop.text = "M5";
        stop.silent = true;
        core_.mark_emitted();
        core_.sink().aux(stop, core_.at);
        return true;
    });
}

// COUPOF: the follower turns on as fast as it does. It gets that as its command, and the PLC its
// direction, while it still follows: so nothing brakes it.
bool Interpreter::keeps_turning(std::uint16_t follows) {
    constexpr double kStandsRpm = 1.0;
    if (!need_fresh()) return false;
    const auto now = core_.port().spindle_turns(follows);
    if (!now || std::fabs(*now) < kStandsRpm) return true;
    const double share = core_.port().spindle_override(follows),
                 rpm = std::round(std::fabs(*now) * 10.0) / 10.0 / (share > 0 ? share : 1.0);
    const SpindleTurn turn = *now > 0 ? SpindleTurn::Cw : SpindleTurn::Ccw;
    return with_spindle(follows, [&] {
        SpindleState& state = core_.path.spindle;
        state.turn = turn;
        state.rpm = rpm;
        state.mode = SpindleModeCode::Rpm;
        state.commanded = true;
        Spindle speed;
        speed.spindle = follows;
        speed.value = rpm;
        speed.turn = turn;
        speed.mode_changed = speed.silent = speed.for_release = true;
        core_.mark_emitted();
        core_.sink().spindle(speed, core_.at);
        Aux turns;
        turns.value = turn == SpindleTurn::Cw ? 3 : 4;
        turns.text = turn == SpindleTurn::Cw ? "M3" : "M4";
        turns.silent = true;
        core_.sink().aux(turns, core_.at);
        return true;
    });
}

// POSRANGE(axis, reference, width, system): does the set position lie in the interval about the
// reference? 0 MCS, 1 BCS, 2 SZS, 3 WCS.
bool Interpreter::f_posrange(Call& c) {
    std::size_t place = 0;
    if (!axis_argument(c, 0, "POSRANGE", place)) return false;
    const double system = c.has(3) ? c.number(3) : 0.0;
    if (system != std::floor(system) || system < 0 || system > 3)
        return fail(Alarm::FunctionArgument, "POSRANGE", system);
    if (!need_fresh()) return false;
    double now = core_.machine_now(static_cast<unsigned>(place));
    if (system == 2)
        now = programmable(core_.path.programmed)[place];
    else if (system == 3)
        now = core_.path.programmed[place];
    if (system >= 2) now *= counts_diameter(static_cast<unsigned>(place), false) ? 2.0 : 1.0;
    const double factor = core_.view().axes[place].rotary ? 1.0 : unit();
    c.result = Value::of_bool(std::fabs(now - c.number(1) * factor) <=
                              std::fabs(c.number(2) * factor) / 2 + 1e-9);
    return true;
}

}  // namespace polyturn::channels::sinumerik
