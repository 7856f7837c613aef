// M, H and S words: what a block says to spindles and PLC, and how it ends (sinumerik_part2 14).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {
namespace {

bool ends_block(std::int64_t m) { return m == 0 || m == 1 || m == 2 || m == 17 || m == 30; }
bool is_spindle_function(std::int64_t m) { return m == 3 || m == 4 || m == 5; }

}  // namespace

// The number of an M word and the spindle it means (0: none named).
bool Interpreter::m_number(const Word& word, std::int64_t& number, std::uint16_t& spindle) {
    const double value = word.number();
    if (value != std::floor(value) || value > 2147483647.0)
        return fail_word(Alarm::PointForbidden, word, "M");
    number = static_cast<std::int64_t>(value);
    spindle = word.index > 0 ? static_cast<std::uint16_t>(word.index) : 0;
    if (word.index >= 0 && ends_block(number))
        return fail_word(Alarm::ExtensionForbidden, word, fmt::format("M{}", number));
    return true;
}

bool Interpreter::with_spindle(std::uint16_t spindle, const std::function<bool()>& act) {
    SpindleState& now = core_.path.spindle;
    if (spindle == 0 || spindle == now.spindle) return act();
    if (spindle > kMaxSpindles || !core_.view().machine.spindle(spindle).exists())
        return fail(Alarm::SpindleNumberIllegal, {}, spindle);
    const SpindleState master = now;
    if (const auto kept = modal_.spindles.find(spindle); kept != modal_.spindles.end())
        now = kept->second;
    else {
        now = {};
        now.spindle = spindle;
    }
    const bool ok = act();
    modal_.spindles[spindle] = now;
    now = master;
    return ok;
}

// S words and M3 M4 M5, output once for each spindle.
bool Interpreter::spindle_words() {
    const GCode* one_shot = block_.coded[2];
    const GCode* frame = block_.coded[3];
    std::vector<std::uint16_t> spindles{modal_.master_spindle};
    const auto number_of_spindle = [&](const Word& word) {
        return word.index > 0 ? static_cast<std::uint16_t>(word.index) : modal_.master_spindle;
    };
    const auto speaks = [&](const Word& word) {
        if (word.address->name == "S")
            return !(one_shot && takes(*one_shot, *word.address)) &&
                   !(frame && takes(*frame, *word.address));
        return word.address->name == "M" &&
               is_spindle_function(static_cast<std::int64_t>(word.number()));
    };
    for (const Word& word : block_.words)
        if (speaks(word) &&
            std::find(spindles.begin(), spindles.end(), number_of_spindle(word)) == spindles.end())
            spindles.push_back(number_of_spindle(word));
    for (const std::uint16_t spindle : spindles) {
        const bool ok = with_spindle(spindle, [&] {
            std::int64_t told = 0;  // M3 M4 M5
            for (const Word& word : block_.words) {
                if (!speaks(word) || number_of_spindle(word) != spindle) continue;
                fault_column_ = word.column;
                fault_length_ = word.length;
                if (word.address->name == "S") {
                    double value = word.number();
                    // SVC holds no more
                    if (spindle) modal_.cutting_speeds &= ~(1u << (spindle - 1));
                    // G331 G332 count revolutions
                    const bool taps = active(1) == 11 || active(1) == 12;
                    // the master spindle has changed under G96
                    if (spindle == modal_.master_spindle && surface_speed_active() && !taps)
                        if (!core_.surface_speed(true) || !refresh_speed_limit()) return false;
                    // feet a minute
                    if (core_.path.spindle.mode == SpindleModeCode::SurfaceSpeed &&
                        !metric_lengths())
                        value *= 0.3048;
                    // GWPSON: m/s, feet a second
                    if (spindle && (modal_.wheel_speeds >> (spindle - 1) & 1u))
                        value *= (metric_lengths() ? 1.0 : 0.3048) * 60'000.0 /
                                 (2.0 * std::numbers::pi * modal_.wheel_radius_mm[spindle]);
                    if (spindle && (modal_.wheel_speeds >> (spindle - 1) & 1u) &&
                        modal_.wheel_most_rpm[spindle] > 0)
                        value = std::fmin(value, modal_.wheel_most_rpm[spindle]);
                    if (!(core_.path.spindle.mode == SpindleModeCode::SurfaceSpeed
                              ? core_.spindle_speed(value)
                              : ask_speed(value)))
                        return false;
                } else {
                    const auto m = static_cast<std::int64_t>(word.number());
                    if (told && told != m)
                        return fail_word(Alarm::CodesContradict, word,
                                         fmt::format("M{}, M{}", told, m));
                    told = m;
                    if (!core_.spindle_turn(m == 3   ? SpindleTurn::Cw
                                            : m == 4 ? SpindleTurn::Ccw
                                                     : SpindleTurn::Stop))
                        return false;
                    modal_.closed_spindles &= ~(1u << (core_.path.spindle.spindle - 1));
                }
                fault_column_ = fault_length_ = 0;
            }
            if (!core_.commit_spindle()) return false;
            // the PLC's M3 means the spindle that was commanded last
            for (const Word& word : block_.words)
                if (word.address->name == "M" && speaks(word) && number_of_spindle(word) == spindle)
                    m_to_plc(word, static_cast<std::int64_t>(word.number()));
            return true;
        });
        if (!ok) return false;
    }
    return true;
}

void Interpreter::m_to_plc(const Word& word, std::int64_t m) {
    // an axis gets its drive back: its position is known behind it
    const bool frees = m == 5 && core_.frees_axis();
    core_.aux('M', static_cast<double>(m),
              word.index > 0 ? fmt::format("M{}={}", word.index, m) : fmt::format("M{}", m), frees);
    if (frees) stop_reading();
}

bool Interpreter::functions_before() {
    if (block_.words.empty() && block_.codes.empty()) return true;
    if (!spindle_words()) return false;
    for (const Word& word : block_.words) {
        if (word.address->name == "H") {
            core_.aux('H', word.number(),
                      word.index > 0 ? fmt::format("H{}={}", word.index, to_text(word.value))
                                     : fmt::format("H{}", to_text(word.value)),
                      false);
        } else if (word.address->name == "M") {
            std::int64_t m = 0;
            std::uint16_t spindle = 0;
            if (!m_number(word, m, spindle)) return false;
            if (ends_block(m)) continue;
            if (settings_.tool_by_m6 && m == settings_.tool_change_m) {
                if (!change_tool()) return false;
                core_.at.tool = core_.path.tool.ref;
            }
            if (m == 19 || m == 70 || (m >= 40 && m <= 45)) {
                const bool ok = with_spindle(spindle, [&] {
                    if (core_.path.spindle.spindle == 0)
                        return fail_word(Alarm::SpindleMissing, word, "M");
                    std::uint32_t& closed = modal_.closed_spindles;
                    const std::uint32_t bit = 1u << (core_.path.spindle.spindle - 1);
                    if (m == 70) modal_.cutting_speeds &= ~bit;
                    if (m == 70 && core_.frees_axis()) {
                        spindle_to_axis();
                        stop_reading();
                    } else if (m == 70 && !(closed & bit))
                        close_spindle(false);
                    if (m >= 40 && m <= 45) closed &= ~bit;
                    if (m != 19) return true;
                    closed |= bit;
                    modal_.cutting_speeds &= ~bit;
                    static constexpr SpindleApproach kHow[] = {SpindleApproach::Shortest,
                                                               SpindleApproach::Positive,
                                                               SpindleApproach::Negative};
                    const auto how = static_cast<std::size_t>(params::get(
                        core_.view().table(), params::sd43250, core_.path.spindle.spindle));
                    core_.position_feed(spindle_feed_rpm(core_.path.spindle.spindle));
                    const bool told = core_.spindle_position(m19_position(spindle),
                                                             kHow[std::min<std::size_t>(how, 2)]);
                    core_.position_feed(0.0);
                    return told;
                });
                if (!ok) return false;
            }
            // before the barrier
            const bool told = settings_.tool_by_m6 && m == settings_.tool_change_m &&
                              managed_serial_ == core_.at.serial;
            if (!is_spindle_function(m) && !told) m_to_plc(word, m);
        }
    }
    return true;
}

double Interpreter::m19_position(std::uint16_t spindle) const {
    const MachineView& view = core_.view();
    const unsigned s = spindle ? spindle : modal_.master_spindle;
    return s ? params::get(view.table(), params::sd43240, s) : 0.0;
}

// M0 M1 M2 M17 M30: behind the motion of the block.
bool Interpreter::functions_after() {
    for (const Word& word : block_.words) {
        if (word.address->name != "M") continue;
        std::int64_t m = 0;
        std::uint16_t spindle = 0;
        if (!m_number(word, m, spindle)) return false;
        if (!ends_block(m)) continue;
        if (m == 0 || m == 1) {
            if (m == 1 && !core_.port().optional_stop()) {
                core_.sink().stop({StopReason::M01, nullptr, false}, core_.at);
                continue;
            }
            core_.mark_emitted();
            core_.sink().stop({m == 0 ? StopReason::M00 : StopReason::M01}, core_.at);
            stop_reading();
            continue;
        }
        called_ = true;
        unsigned programs = 0;
        for (const Level& level : levels_) programs += !level.section;
        // M2 and M30 of a subprogram are its end; of M17 the PLC hears, other than of RET
        // (sinumerik_part3 7.15)
        if (programs > 1) {
            if (m == 17) m_to_plc(word, m);
            return return_from_level();
        }
        if (modal_.geo.open_line) return fail(Alarm::ContourLineOpen);
        if (modal_.geo.approach) return fail(Alarm::ApproachNoEnd);
        if (modal_.curve) return fail(Alarm::StructureNesting, "CTABDEF");
        core_.mark_emitted();
        core_.sink().part(++parts_, core_.at);
        finish(m == 2 ? StopReason::M02 : StopReason::M30);  // M17 of a main program acts as M30
        return true;
    }
    return true;
}

// A spindle that is not in position control yet gets there by the PLC's M19, at any position.
void Interpreter::close_spindle(bool told, bool beside) {
    SpindleState& now = core_.path.spindle;
    now.turn = SpindleTurn::Stop;
    if (!told) {  // the program has named no angle
        Spindle silent;
        silent.spindle = now.spindle;
        silent.mode = SpindleModeCode::Position;
        silent.value = now.angle_deg;
        silent.mode_changed = silent.silent = true;
        core_.mark_emitted();
        core_.sink().spindle(silent, core_.at);
    }
    Aux orient;
    orient.value = 19;
    orient.text = "M19";
    orient.silent = true;
    orient.beside = beside;
    core_.mark_emitted();
    core_.sink().aux(orient, core_.at);
    modal_.closed_spindles |= 1u << (now.spindle - 1);
}

// SPOS, SPOSA: a plain value and DC go the short way, IC counts from its position.
bool Interpreter::a_spindle_position(const Word& word) {
    unsigned count = 0;
    for (const Word& other : block_.words)
        count += other.address->name == "SPOS" || other.address->name == "SPOSA";
    if (count > 3) return fail_word(Alarm::FunctionsTooMany, word, "SPOS");
    const bool beside = word.address->name == "SPOSA";  // over the end of the block
    core_.position_outside_path(beside);
    const bool good =
        with_spindle(word.index > 0 ? static_cast<std::uint16_t>(word.index) : 0, [&] {
            if (core_.path.spindle.spindle == 0)
                return fail_word(Alarm::SpindleMissing, word, "SPOS");
            const std::uint16_t spindle = core_.path.spindle.spindle;
            modal_.cutting_speeds &= ~(1u << (spindle - 1));
            const double angle = word.number();
            core_.position_feed(spindle_feed_rpm(spindle));
            if (word.mode == Mode::IC) {
                if (std::fabs(angle) >= 100'000.0)
                    return fail_word(Alarm::ValueOutOfRange, word, "SPOS");
                if (spindle_closed(spindle)) return core_.spindle_index(angle);
                if (!core_.spindle_position(core_.path.spindle.angle_deg + angle,
                                            SpindleApproach::Shortest))
                    return false;
            } else {
                if (angle < 0 || angle >= 360.0)
                    return fail_word(Alarm::ValueOutOfRange, word, "SPOS");
                const SpindleApproach how = word.mode == Mode::ACP   ? SpindleApproach::Positive
                                            : word.mode == Mode::ACN ? SpindleApproach::Negative
                                                                     : SpindleApproach::Shortest;
                if (!core_.spindle_position(angle, how)) return false;
            }
            if (!spindle_closed(spindle)) close_spindle(true, beside);
            return true;
        });
    core_.position_outside_path(false);
    core_.position_feed(0.0);
    return good;
}

// FA of the block counts wherever it is in it; what holds from before is modal.
double Interpreter::spindle_feed_rpm(std::uint16_t spindle) const {
    double degrees = modal_.spindle_feed[spindle];
    for (const Word& word : block_.words)
        if (word.address->name == "FA" && word.axis < 0 &&
            (word.index > 0 ? word.index : modal_.master_spindle) == spindle)
            degrees = word.number();
    return degrees / 360.0;
}

}  // namespace polyturn::channels::sinumerik
