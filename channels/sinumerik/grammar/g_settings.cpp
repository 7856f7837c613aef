// G commands that set modes: units, plane, dimensions, feed types, diameters, exact stop, settable
// zeros. And F, FB, FZ.
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/machine/store/work_zeros.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// How a command of group 15 counts the feed.
enum class FeedKind : std::uint8_t { Inverse, Linear, Revolution, Same };
FeedKind feed_kind(unsigned number) {
    switch (number) {
        case 1:
        case 6:
            return FeedKind::Inverse;  // G93 G931
        case 2:
        case 7:
        case 8:
        case 9:
            return FeedKind::Linear;  // G94 G961 G971 G942
        case 11:
        case 12:
            return FeedKind::Same;  // G962 G972
        // G95 G96 G97 G952 G973
        default:
            return FeedKind::Revolution;
    }
}
// G96 G961 G962
bool is_surface(unsigned number) { return number == 4 || number == 7 || number == 11; }

}  // namespace

bool Interpreter::g_mode(const GCode&) { return true; }
bool Interpreter::g_as_machine(const GCode&) { return true; }
bool Interpreter::g_without_effect(const GCode& code) {
    for (std::size_t k = 0; k < block_.codes.size(); ++k)  // not where a return restores it
        if (block_.codes[k] == &code)
            return without_effect(std::string(code.name), block_.code_columns[k], code.name.size());
    return true;
}
bool Interpreter::g_as_continuous(const GCode& code) {
    return g_exact_stop(code) && g_without_effect(code);
}
bool Interpreter::geo_not_built(const GCode& code) {
    return axis_words() == 0 || fail(Alarm::NotBuilt, std::string(code.name));
}
bool Interpreter::g_units(const GCode&) { return true; }
bool Interpreter::g_distance(const GCode&) { return true; }
bool Interpreter::g_diameter(const GCode&) { return true; }

// MD20150 takes only commands that the tables of the groups mark (sinumerik_part3 2 and 6.3); what
// is active as delivered stands there too.
std::optional<Diagnosis> Interpreter::reset_value_fault() const {
    for (unsigned group = 1; group < kGroups; ++group) {
        const unsigned number = settings_.g_reset[group - 1];
        const GCode* row = find_g(group, number);
        if (number == 0 || (row && row->preset)) continue;
        const std::string said = "MD20150[" + std::to_string(group - 1) +
                                 "]=" + std::to_string(number) +
                                 (row ? " (" + std::string(row->name) + ")" : "");
        const bool marked = row && row->modal && group != 7 && group != 26 && group != 31 &&
                            group != 32 && group != 33 && !(group == 35 && number >= 4);
        Diagnosis wrong;
        wrong.alarm = !marked ? Alarm::ParamRange : Alarm::NotBuilt;
        wrong.detail = !marked ? said : std::string(row->name);
        if (!marked || !row->act) return wrong;
    }
    return std::nullopt;
}

bool Interpreter::g_plane(const GCode& code) {
    const auto plane = static_cast<Plane>(code.number - 1);
    if (core_.path.plane == plane) return true;
    if (core_.compensating()) return fail(Alarm::CompPlaneChanged);
    core_.path.plane = plane;
    apply_tool();  // lengths lie along other axes now
    return true;
}

bool Interpreter::g_exact_stop(const GCode& code) {
    core_.path.exact_stop_mode = code.number == 1;
    return true;
}

bool Interpreter::g_exact_once(const GCode&) {
    core_.force_exact_stop();
    return true;
}

bool Interpreter::g_zero(const GCode& code) {
    const int n = code.number - 1;  // $P_UIFR[n]
    if (n >= settings_.frames) return fail(Alarm::GCodeUnknown, std::string(code.name));
    const auto row =
        n == 0 ? work_zero_row("G500") : settable_zero_row(static_cast<std::size_t>(n));
    if (!row) return fail(Alarm::GCodeUnknown, std::string(code.name));
    choose_settable(n, static_cast<std::int32_t>(*row));
    return true;
}

bool Interpreter::g_feed_type(const GCode& code) {
    const unsigned before = active(15);
    const FeedKind old_kind = modal_.feed_revolution                   ? FeedKind::Revolution
                              : feed_kind(before) == FeedKind::Inverse ? FeedKind::Inverse
                                                                       : FeedKind::Linear;
    FeedKind kind = feed_kind(code.number);
    if (kind == FeedKind::Same) kind = old_kind;
    if (kind != old_kind) {
        modal_.feed = modal_.feed_per_tooth = 0.0;  // another kind of feed wants a new F
        modal_.corner_feed_stale = modal_.geo.corner_feed > 0;  // and a new FRCM
    }
    modal_.feed_revolution = kind == FeedKind::Revolution;
    // G942 G952 leave the spindle as it is
    if (code.number == 9 || code.number == 10) return true;
    activate(15, code.number);  // which limits act
    SpindleState& spindle = core_.path.spindle;
    if (is_surface(code.number)) {
        // SVC ends (7.2 rule 6)
        if (spindle.spindle) modal_.cutting_speeds &= ~(1u << (spindle.spindle - 1));
        return core_.surface_speed(true) && refresh_speed();
    }
    if (is_surface(before) && spindle.mode == SpindleModeCode::SurfaceSpeed) {
        if (!core_.surface_speed(false)) return false;
        // G93 G94 G95: the last speed in revolutions
        if (code.number <= 3 || code.number == 6)
            spindle.rpm = limited_speed(modal_.asked_rpm[spindle.spindle]);
        else
            modal_.asked_rpm[spindle.spindle] = spindle.rpm;
    }
    return refresh_speed();
}

bool Interpreter::feed_word(const Word& word) {
    if (const GCode* code = block_.coded[2]; code && takes(*code, *word.address)) return true;
    if (const GCode* code = motion_code(); code && takes(*code, *word.address)) return true;
    if (word.index >= 0)  // F2 to F7 hold while an input is on; there is none
        return word.index >= 2 && word.index <= 7
                   ? a_without_effect(word)
                   : fail_word(Alarm::ArrayIndexIllegal, word, "F", word.index);
    if (word.number() <= 0) return fail_word(Alarm::FeedMissing, word);
    modal_.feed_word_unit = feed_kind(active(15)) == FeedKind::Inverse ? 1.0 : feed_unit();
    modal_.feed = word.number() * modal_.feed_word_unit;
    modal_.feed_per_tooth = 0.0;
    return true;
}

bool Interpreter::a_feed(const Word& word) {  // FB
    if (word.number() <= 0) return fail_word(Alarm::ValueOutOfRange, word, "FB");
    if (has("F") || has("FD")) return fail_word(Alarm::CodesContradict, word, "FB, F");
    block_feed_ = word.number() * (feed_kind(active(15)) == FeedKind::Inverse ? 1.0 : feed_unit());
    return true;
}

bool Interpreter::a_feed_tooth(const Word& word) {
    if (!modal_.feed_revolution) return true;  // outside G95 it has no effect
    modal_.feed_per_tooth = word.number() * feed_unit();
    modal_.feed = 0.0;
    return true;
}

bool Interpreter::update_feed() {
    PathState& path = core_.path;
    path.feed_mode = modal_.feed_revolution                       ? FeedMode::PerRevolution
                     : feed_kind(active(15)) == FeedKind::Inverse ? FeedMode::InverseTime
                                                                  : FeedMode::PerMinute;
    double feed = block_feed_ > 0             ? block_feed_
                  : modal_.feed_per_tooth > 0 ? modal_.feed_per_tooth
                                              : modal_.feed;
    if (modal_.feed_revolution && modal_.feed_per_tooth > 0) feed *= modal_.teeth;
    path.feed = feed;
    if (const double said_in = block_feed_ > 0 ? feed_unit() : modal_.feed_word_unit;
        path.feed_path.degree_unit != said_in) {
        path.feed_path.degree_unit = said_in;
        set_feed_path();
    }
    return true;
}

// G331 and G332 count S in revolutions whatever group 15 says; under G96 the S of the one is none
// for the other (7.1).
bool Interpreter::motion_changes(const GCode& to) {
    const auto taps = [](unsigned number) { return number == 11 || number == 12; };
    const bool before = taps(active(1)), after = taps(to.number);
    if (before == after || !is_surface(active(15))) return true;
    SpindleState& spindle = core_.path.spindle;
    if (after) {
        if (!core_.surface_speed(false)) return false;
        spindle.rpm = modal_.asked_rpm[spindle.spindle] = 0.0;
        core_.forget_pending();
        return true;
    }
    spindle.rpm = spindle.surface_m_min = modal_.asked_rpm[spindle.spindle] = 0.0;
    // output with the S that must come before the spindle turns
    spindle.mode = SpindleModeCode::SurfaceSpeed;
    return true;
}

bool Interpreter::a_elsewhere(const Word&) { return true; }
bool Interpreter::a_as_machine(const Word&) { return true; }
// ADIS=0: as G64
bool Interpreter::a_rounding(const Word& word) {
    return word.number() == 0 || a_without_effect(word);
}
// TCARR=0, CUTMOD=0 at the head of a program: no holder that turns the tool. There is none that it
// could be turned by.
bool Interpreter::a_no_holder(const Word& word) {
    return word.number() == 0 || fail_word(Alarm::NotBuilt, word, std::string(word.address->name));
}

}  // namespace polyturn::channels::sinumerik
