// F, S, T, D and M words.
#include <fmt/format.h>

#include <cmath>

#include "channels/fagor/interpreter.hpp"

namespace polyturn::channels::fagor {
namespace {

bool ends_program(double code) { return code == 0 || code == 1 || code == 2 || code == 30; }

// Does the M function act behind the block's motion? The stops always do; another one as its entry
// of the table says. What has no entry acts before the motion (5.5), but M05 must not stop the
// spindle before the cut.
bool acts_late(double code, const MEntry* entry) {
    return ends_program(code) || (entry ? entry->after_motion : code == 5);
}

}  // namespace

bool Interpreter::feed_word() {
    const Word& f = *word('F');
    if (f.value < 0) return fail_word(f, Alarm::NegativeSign, "F");
    if (modal_.motion >= 33 && has_axes())
        return fail_word(f, Alarm::FagorIncompatible, "F in a thread");
    switch (modal_.feed_code) {
        case 94:
            modal_.feed_minute = f.value * unit();
            break;
        case 95:
            modal_.feed_revolution = f.value * unit();
            break;
        default:
            modal_.feed_inverse = f.value;
            break;
    }
    return true;
}

// S: a speed, a cutting speed with G96, an angle with M19.
bool Interpreter::spindle_word() {
    if (!has('S')) return true;
    const Word& s = *word('S');
    for (unsigned k = 0; k < m_count_; ++k)
        if (m_words_[k]->value == 19) return true;  // its angle
    if (s.value < 0) return fail_word(s, Alarm::NegativeSign, "S");
    if (modal_.motion >= 33 && has_axes())
        return fail_word(s, Alarm::FagorIncompatible, "S in a thread");
    double value = s.value;
    if (core_.path.spindle.mode == SpindleModeCode::SurfaceSpeed) {
        if (modal_.inch) value *= 0.3048;
    } else {
        // G92 S: none above it is taken
        if (modal_.speed_limit > 0) value = std::fmin(value, modal_.speed_limit);
        if (settings_.gear_automatic && !spindle_gear(value)) return false;
        if (const double most = gear_limit(); most > 0) value = std::fmin(value, most);
    }
    return core_.spindle_speed(value);
}

// Highest speed of the gear that the block comes to; 0: not limited by the gear.
double Interpreter::gear_limit() const {
    int gear = modal_.gear;
    for (unsigned k = 0; k < m_count_; ++k)
        if (m_words_[k]->value >= 41 && m_words_[k]->value <= 44)
            gear = static_cast<int>(m_words_[k]->value) - 40;
    return gear ? settings_.gear_max[static_cast<std::size_t>(gear - 1)] : 0.0;
}

// AUTOGEAR: the gear whose speeds contain this one, reported to the PLC by its M function.
bool Interpreter::spindle_gear(double rpm) {
    int gear = 0, fastest = 0;
    for (int n = 4; n >= 1; --n) {
        const double most = settings_.gear_max[static_cast<std::size_t>(n - 1)];
        if (most >= rpm) gear = n;
        if (most > 0 &&
            (!fastest || most > settings_.gear_max[static_cast<std::size_t>(fastest - 1)]))
            fastest = n;
    }
    if (gear == 0) gear = fastest;  // no gear is fast enough: the fastest one, at its limit
    if (gear == 0 || gear == modal_.gear) return true;
    const MEntry* entry = m_entry(40 + gear);
    if (entry && entry->subroutine) {
        if (block_.count > 1) return core_.fail(Alarm::FagorGearAlone, 'S');
        modal_.gear = gear;
        CallFrame frame;
        frame.m_code = entry->code;
        frame.m_itself = !entry->only_subroutine;
        return call_subroutine(entry->subroutine, frame, nullptr);
    }
    modal_.gear = gear;
    core_.aux('M', 40 + gear, fmt::format("M{}", 40 + gear), false);
    return true;
}

bool Interpreter::tool_words() {
    if (!has('T') && !has('D')) return true;
    std::int64_t tool = core_.path.tool.ref.number, offset = -1;
    if (has('T')) {
        if (!whole(*word('T'), tool)) return false;
        if (tool > 255)
            return fail_word(*word('T'), Alarm::FagorValueRange, "T", static_cast<double>(tool));
        // tool management has chosen (managed_tools.cpp)
        const bool told = managed_serial_ == core_.at.serial;
        if (told && settings_.change_by_m06) {  // M06 says which of its family it is
            if (has('D') && !whole(*word('D'), offset)) return false;
            if (offset >
                std::min<std::int64_t>(settings_.offsets, static_cast<std::int64_t>(kOffsets) - 1))
                return fail_word(*word('D'), Alarm::OffsetNumberIllegal, {},
                                 static_cast<double>(offset),
                                 static_cast<double>(settings_.offsets));
            modal_.next_tool = tool;
            modal_.next_offset = offset;
            return true;
        }
        if (told) tool = core_.port().tool_at_work().value_or(Port::ToolAtWork{}).number;
        // An expended tool gives way to another one of its family that is not (11.2.2).
        const auto expended = [this](std::int64_t n) {
            const double life = values_.tool(ToolField::Life, static_cast<std::size_t>(n));
            return life > 0 && values_.tool(ToolField::Used, static_cast<std::size_t>(n)) >= life;
        };
        if (!told && tool > 0 && expended(tool)) {
            const double family = values_.tool(ToolField::Family, static_cast<std::size_t>(tool));
            std::int64_t other = 0;
            for (std::size_t pocket = 1; pocket < kTools && !other; ++pocket) {
                const auto n = static_cast<std::int64_t>(values_.tool(ToolField::Pocket, pocket));
                if (n > 0 && n != tool &&
                    values_.tool(ToolField::Family, static_cast<std::size_t>(n)) == family &&
                    !expended(n))
                    other = n;
            }
            if (!other)
                return fail_word(*word('T'), Alarm::FagorToolExpended, {},
                                 static_cast<double>(tool));
            tool = other;
        }
        offset = told ? core_.port().tool_at_work().value_or(Port::ToolAtWork{}).offset
                      : static_cast<std::int64_t>(
                            values_.tool(ToolField::Offset, static_cast<std::size_t>(tool)));
    }
    if (has('D')) {
        if (!whole(*word('D'), offset)) return false;
    }
    const std::int64_t most =
        std::min<std::int64_t>(settings_.offsets, static_cast<std::int64_t>(kOffsets) - 1);
    if (offset > most)
        return fail_word(has('D') ? *word('D') : *word('T'), Alarm::OffsetNumberIllegal, {},
                         static_cast<double>(offset), static_cast<double>(most));
    if (has('T') && managed_serial_ != core_.at.serial)
        core_.aux('T', static_cast<double>(tool), fmt::format("T{}", tool), false);
    if (has('T') && settings_.change_by_m06) {
        modal_.next_tool = tool;
        modal_.next_offset = offset;
        return true;
    }
    return change_tool(tool, offset);
}

bool Interpreter::change_tool(std::int64_t tool, std::int64_t offset) {
    ToolState& state = core_.path.tool;
    state.ref.number = tool;
    state.ref.offset = static_cast<std::int32_t>(offset);
    state.geometry = state.wear = static_cast<std::int32_t>(offset);
    core_.at.tool = state.ref;
    load_tool();
    return true;
}

// Lengths and wear of the offset in use, both as radii: the next move brings the new tip to where
// the old one was (8.1).
void Interpreter::load_tool() {
    ToolState& state = core_.path.tool;
    MachineView& view = core_.view();
    const auto number = static_cast<std::size_t>(state.geometry);
    const bool none = number == 0;
    const OffsetCell& cell = view.store->offsets[number];
    AxisValues vector{};
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t k = 0; k < 3; ++k) {
        const int place = view.axis_by_role(kRoles[k]);
        if (place >= 0 && !none)
            vector[static_cast<std::size_t>(place)] = cell.geometry[k] + cell.wear[k];
    }
    state.nose_off = none;
    state.nose_radius = none ? 0.0 : cell.geometry_r + cell.wear_r;
    state.tip = none ? 0 : static_cast<std::int32_t>(cell.tip);
    core_.set_wanted(vector);
}

const MEntry* Interpreter::m_entry(double code) const {
    for (const MEntry& entry : settings_.m_table)
        if (entry.code == static_cast<std::int32_t>(code)) return &entry;
    return nullptr;
}

bool Interpreter::m_before() {
    for (unsigned k = 0; k < m_count_; ++k) {
        std::int64_t code = 0;
        if (!whole(*m_words_[k], code)) return false;
        if (code > 9999)
            return fail_word(*m_words_[k], Alarm::FagorValueRange, "M", static_cast<double>(code));
        if (code == 3 || code == 4) {
            if (!core_.spindle_turn(code == 3 ? SpindleTurn::Cw : SpindleTurn::Ccw)) return false;
        }
    }
    if (!core_.commit_spindle()) return false;
    for (unsigned k = 0; k < m_count_; ++k) {
        const MEntry* entry = m_entry(m_words_[k]->value);
        if (!acts_late(m_words_[k]->value, entry) && !m_function(*m_words_[k], false)) return false;
    }
    return true;
}

bool Interpreter::m_function(const Word& word, bool behind) {
    const auto code = static_cast<std::int32_t>(word.value);
    if (code == modal_.m_done) return true;
    const MEntry* entry = m_entry(code);
    if (!entry && waits(code)) return true;
    if (code >= 41 && code <= 44) {
        const double speed = core_.path.spindle.rpm,
                     most = settings_.gear_max[static_cast<std::size_t>(code - 41)];
        const bool same = modal_.gear == code - 40 && most > 0 && speed <= most;
        modal_.gear = code - 40;
        if (!limit_surface_speed() || !core_.commit_spindle()) return false;
        if (same) return true;  // the speed belongs to this gear already: nothing is done (5.5.2)
    }
    if (entry && entry->subroutine) {
        for (const CallFrame& frame : frames_)
            // inside its own subroutine the function itself
            if (frame.m_code == code) entry = nullptr;
        if (entry) {
            CallFrame frame;
            frame.m_code = code;
            frame.m_itself = !entry->only_subroutine;
            if (code == 6 && settings_.change_by_m06 && modal_.next_tool >= 0 && !managed() &&
                !change_tool(modal_.next_tool, modal_.next_offset))
                return false;
            if (!call_subroutine(entry->subroutine, frame, nullptr)) return false;
            // the rest of the block comes behind the subroutine
            if (!behind && block_.count > 1) {
                frames_.back().resume = line_at_;
                frames_.back().reads_again = true;
            }
            return true;
        }
    }
    if (code == 5 && !(core_.spindle_turn(SpindleTurn::Stop) && core_.commit_spindle()))
        return false;
    if (code == 19) {
        const double angle = has('S') ? number('S') : 0.0;
        // A spindle whose loop is closed already turns from its position, by as many degrees as
        // the difference says (5.5.1).
        const bool closed = (modal_.m_states >> 19 & 1u) != 0;
        if (!core_.spindle_unwrapped(
                angle, closed ? std::optional(angle - modal_.stands_at) : std::nullopt))
            return false;
        modal_.position_angle = angle;
        modal_.stands_at = std::fabs(angle) > 360.0 ? std::fmod(angle, 360.0) : angle;
    }
    // output already
    if (code == 6 && settings_.change_by_m06 && managed_serial_ == core_.at.serial &&
        modal_.next_tool >= 0)
        return take_over_change();
    char text[16];
    const auto end = fmt::format_to_n(text, sizeof text, "M{}", code);
    // M05 gives the drive back to an axis that shares it: its next move counts from where the drive
    // is at standstill then.
    const bool changes = code == 6 && settings_.change_by_m06 && modal_.next_tool >= 0,
               waits = changes && !core_.reads_ahead() && managed();
    const bool drains = (entry && entry->stops_preparation) || waits ||
                        (code == 5 && core_.frees_axis() && !core_.reads_ahead());
    Aux told;
    told.value = code;
    told.text = {text, end.size};
    told.drained = drains;
    told.beside = entry && entry->goes_on && !drains;
    core_.mark_emitted();
    core_.sink().aux(told, core_.at);
    if (drains) wants_barrier_ = true;
    if (waits) {
        change_pending_ = true;
    } else if (changes) {
        if (!change_tool(modal_.next_tool, modal_.next_offset)) return false;
        modal_.next_tool = modal_.next_offset = -1;
    }
    const auto set = [this](int n, std::uint64_t clears) {
        modal_.m_states = (modal_.m_states & ~clears) | std::uint64_t{1} << n;
    };
    constexpr std::uint64_t kTurning = 1ull << 3 | 1ull << 4 | 1ull << 5 | 1ull << 19,
                            kCoolant = 1ull << 8 | 1ull << 9, kGears = 0xFull << 41;
    if (code == 3 || code == 4 || code == 5 || code == 19)
        set(code, kTurning);
    else if (code == 8 || code == 9)
        set(code, kCoolant);
    else if (code >= 41 && code <= 44)
        set(code, kGears);
    else if (code == 6)
        set(code, 0);
    return true;
}

// The 8037 T has one channel and no waits of its own; beside others it waits for those of its group
// by the machine's codes, unless the M table has the code (architecture 4, 12: channels of
// different languages wait for each other).
bool Interpreter::waits(std::int32_t code) {
    const MachineConfig& machine = core_.view().machine;
    const std::uint32_t channels =
        machine.channels_of_group(machine.channel(core_.view().channel).group);
    if (!machine.is_wait_code(code) || __builtin_popcount(channels) < 2) return false;
    core_.mark_emitted();
    core_.sink().wait({code, {}, channels, false}, core_.at);
    return wants_barrier_ = true;
}

bool Interpreter::m_after() {
    for (unsigned k = 0; k < m_count_; ++k) {
        const Word& word = *m_words_[k];
        const double code = word.value;
        if (!acts_late(code, m_entry(code))) continue;
        if (ends_program(code)) {
            if (!m_end(code)) return false;
        } else if (!m_function(word, true)) {
            return false;
        }
    }
    return true;
}

bool Interpreter::m_end(double code) {
    if (code <= 1) {
        if (code == 1 && !core_.port().optional_stop()) {
            core_.sink().stop({StopReason::M01, nullptr, false}, core_.at);
            return true;
        }
        core_.mark_emitted();
        core_.sink().stop({code == 0 ? StopReason::M00 : StopReason::M01}, core_.at);
        wants_barrier_ = true;
        return true;
    }
    // The end of a program that EXEC or MEXEC runs leads back to the one that called it (12.7).
    for (std::size_t k = frames_.size(); k-- > 1;) {
        if (frames_[k].interrupt) break;  // within an interrupt subroutine it ends everything
        if (frames_[k].kind != CallFrame::Kind::Program) continue;
        while (frames_.size() > k + 1) pop_frame();
        return return_from_frame();
    }
    // The end of the program stops the spindle and sets the initial state (5.5).
    if (core_.path.spindle.turn != SpindleTurn::Stop &&
        !(core_.spindle_turn(SpindleTurn::Stop) && core_.commit_spindle()))
        return false;
    if (!keep_written()) return false;
    modal_.writing = -1;
    core_.sink().part(++modal_.parts, core_.at);
    finish(code == 2 ? StopReason::M02 : StopReason::M30);
    return true;
}

}  // namespace polyturn::channels::fagor
