#include "channels/fagor/tools/m_functions.hpp"

#include <fmt/format.h>

#include <cmath>

#include "channels/engine/block_edges.hpp"
#include "channels/fagor/execution.hpp"
#include "channels/fagor/flow/calls.hpp"
#include "channels/fagor/grammar/words.hpp"
#include "channels/fagor/statements/written_programs.hpp"
#include "channels/fagor/tools/managed_tools.hpp"
#include "channels/fagor/tools/spindle.hpp"
#include "channels/fagor/tools/tool_words.hpp"

namespace polyturn::channels::fagor {
namespace {

bool ends_program(double code) { return code == 0 || code == 1 || code == 2 || code == 30; }

// Does the M function act behind the block's motion? The stops always do; another one as its entry
// of the table says. What has no entry acts before the motion (5.5), but M05 must not stop the
// spindle before the cut.
bool acts_late(double code, const MEntry* entry) {
    return ends_program(code) || (entry ? entry->after_motion : code == 5);
}

// The 8037 T has one channel and no waits of its own; beside others it waits for those of its group
// by the machine's codes, unless the M table has the code (architecture 4, 12: channels of
// different languages wait for each other).
bool wait_code(Execution& x, std::int32_t code) {
    const MachineConfig& machine = x.core.view().machine;
    const std::uint32_t channels =
        machine.channels_of_group(machine.channel(x.core.view().channel).group);
    if (!machine.is_wait_code(code) || __builtin_popcount(channels) < 2) return false;
    x.core.mark_emitted();
    x.core.sink().wait({code, {}, channels, false}, x.core.at);
    return x.run.wants_barrier = true;
}

// M41 to M44. `same`: the speed belongs to this gear already, so nothing is done (5.5.2).
bool change_gear(Execution& x, std::int32_t code, bool& same) {
    const double speed = x.core.path.spindle.rpm,
                 most = x.settings.gear_max[static_cast<std::size_t>(code - 41)];
    same = x.modal.gear == code - 40 && most > 0 && speed <= most;
    x.modal.gear = code - 40;
    return limit_surface_speed(x) && x.core.commit_spindle();
}

bool inside_subroutine_of(const Execution& x, std::int32_t code) {
    for (const CallFrame& frame : x.calls.frames())
        if (frame.m_code == code) return true;
    return false;
}

bool call_m_subroutine(Execution& x, const MEntry& entry, bool behind) {
    CallFrame frame;
    frame.m_code = entry.code;
    frame.m_itself = !entry.only_subroutine;
    if (entry.code == 6 && x.settings.change_by_m06 && x.modal.next_tool >= 0 && !managed(x) &&
        !change_tool(x, x.modal.next_tool, x.modal.next_offset))
        return false;
    if (!call_subroutine(x, entry.subroutine, frame, nullptr)) return false;
    // the rest of the block comes behind the subroutine
    if (!behind && x.line.block.count > 1) {
        x.calls.here().resume = x.line.at;
        x.calls.here().reads_again = true;
    }
    return true;
}

// M19. A spindle whose loop is closed already turns from its position, by as many degrees as the
// difference says (5.5.1).
bool orient_spindle(Execution& x) {
    const double angle = x.words.has('S') ? x.words.number('S') : 0.0;
    const bool closed = (x.modal.m_states >> 19 & 1u) != 0;
    if (!x.core.spindle_unwrapped(angle,
                                  closed ? std::optional(angle - x.modal.stands_at) : std::nullopt))
        return false;
    x.modal.position_angle = angle;
    x.modal.stands_at = std::fabs(angle) > 360.0 ? std::fmod(angle, 360.0) : angle;
    return true;
}

// The function is output; with TOFFM06 M06 brings the tool that T has named.
bool output(Execution& x, std::int32_t code, const MEntry* entry) {
    char text[16];
    const auto end = fmt::format_to_n(text, sizeof text, "M{}", code);
    // M05 gives the drive back to an axis that shares it: its next move counts from where the drive
    // is at standstill then.
    const bool changes = code == 6 && x.settings.change_by_m06 && x.modal.next_tool >= 0,
               waits = changes && !x.core.reads_ahead() && managed(x);
    const bool drains = (entry && entry->stops_preparation) || waits ||
                        (code == 5 && x.core.frees_axis() && !x.core.reads_ahead());
    Aux told;
    told.value = code;
    told.text = {text, end.size};
    told.drained = drains;
    told.beside = entry && entry->goes_on && !drains;
    x.core.mark_emitted();
    x.core.sink().aux(told, x.core.at);
    if (drains) x.run.wants_barrier = true;
    if (waits) {
        x.facts.change_pending = true;
    } else if (changes) {
        if (!change_tool(x, x.modal.next_tool, x.modal.next_offset)) return false;
        x.modal.next_tool = x.modal.next_offset = -1;
    }
    return true;
}

// What MS<n> reads: of spindle, coolant and gears the last one.
void note_state(Modal& modal, std::int32_t code) {
    const auto set = [&modal](int n, std::uint64_t clears) {
        modal.m_states = (modal.m_states & ~clears) | std::uint64_t{1} << n;
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
}

bool m_function(Execution& x, const Word& word, bool behind) {
    const auto code = static_cast<std::int32_t>(word.value);
    if (code == x.modal.m_done) return true;
    const MEntry* entry = m_entry(x, code);
    if (!entry && wait_code(x, code)) return true;
    if (code >= 41 && code <= 44) {
        bool same = false;
        if (!change_gear(x, code, same)) return false;
        if (same) return true;
    }
    if (entry && entry->subroutine) {
        if (!inside_subroutine_of(x, code)) return call_m_subroutine(x, *entry, behind);
        entry = nullptr;  // there it is the function itself
    }
    if (code == 5 && !(x.core.spindle_turn(SpindleTurn::Stop) && x.core.commit_spindle()))
        return false;
    if (code == 19 && !orient_spindle(x)) return false;
    // output already
    if (code == 6 && x.settings.change_by_m06 && x.run.tool_serial == x.core.at.serial &&
        x.modal.next_tool >= 0)
        return take_over_change(x);
    if (!output(x, code, entry)) return false;
    note_state(x.modal, code);
    return true;
}

bool m_end(Execution& x, double code) {
    if (code <= 1) {
        if (code == 1 && !x.core.port().optional_stop()) {
            x.core.sink().stop({StopReason::M01, nullptr, false}, x.core.at);
            return true;
        }
        x.core.mark_emitted();
        x.core.sink().stop({code == 0 ? StopReason::M00 : StopReason::M01}, x.core.at);
        x.run.wants_barrier = true;
        return true;
    }
    // The end of a program that EXEC or MEXEC runs leads back to the one that called it (12.7).
    for (std::size_t k = x.calls.depth(); k-- > 1;) {
        const CallFrame& frame = x.calls.frames()[k];
        if (frame.interrupt) break;  // within an interrupt subroutine it ends everything
        if (frame.kind != CallFrame::Kind::Program) continue;
        while (x.calls.depth() > k + 1) pop_frame(x);
        return return_from_frame(x);
    }
    // The end of the program stops the spindle and sets the initial state (5.5).
    if (x.core.path.spindle.turn != SpindleTurn::Stop &&
        !(x.core.spindle_turn(SpindleTurn::Stop) && x.core.commit_spindle()))
        return false;
    if (!keep_written(x)) return false;
    x.modal.writing = -1;
    x.core.sink().part(++x.modal.parts, x.core.at);
    engine::finish(x.core, x.run, code == 2 ? StopReason::M02 : StopReason::M30);
    return true;
}

}  // namespace

bool m_before(Execution& x) {
    for (unsigned k = 0; k < x.words.m_count; ++k) {
        std::int64_t code = 0;
        if (!whole(x, *x.words.m[k], code)) return false;
        if (code > 9999)
            return x.fail_word(*x.words.m[k], Alarm::FagorValueRange, "M",
                               static_cast<double>(code));
        if (code == 3 || code == 4) {
            if (!x.core.spindle_turn(code == 3 ? SpindleTurn::Cw : SpindleTurn::Ccw)) return false;
        }
    }
    if (!x.core.commit_spindle()) return false;
    for (unsigned k = 0; k < x.words.m_count; ++k) {
        const MEntry* entry = m_entry(x, x.words.m[k]->value);
        if (!acts_late(x.words.m[k]->value, entry) && !m_function(x, *x.words.m[k], false))
            return false;
    }
    return true;
}

bool m_after(Execution& x) {
    for (unsigned k = 0; k < x.words.m_count; ++k) {
        const Word& word = *x.words.m[k];
        const double code = word.value;
        if (!acts_late(code, m_entry(x, code))) continue;
        if (ends_program(code)) {
            if (!m_end(x, code)) return false;
        } else if (!m_function(x, word, true)) {
            return false;
        }
    }
    return true;
}

const MEntry* m_entry(const Execution& x, double code) {
    for (const MEntry& entry : x.settings.m_table)
        if (entry.code == static_cast<std::int32_t>(code)) return &entry;
    return nullptr;
}

}  // namespace polyturn::channels::fagor
