// M, H and S words: what a block says to spindles and PLC, and how it ends (sinumerik_part2 14).
#include "channels/sinumerik/coordination/functions_ms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/calls.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/spindles/spindle_commands.hpp"
#include "channels/sinumerik/tools/tools.hpp"
#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {
namespace {

bool ends_block(std::int64_t m) { return m == 0 || m == 1 || m == 2 || m == 17 || m == 30; }

// The number of an M word and the spindle it means (0: none named).
bool m_number(Execution& x, const Word& word, std::int64_t& number, std::uint16_t& spindle) {
    const double value = word.number();
    if (value != std::floor(value) || value > 2147483647.0)
        return fail_word(x, Alarm::PointForbidden, word, "M");
    number = static_cast<std::int64_t>(value);
    spindle = word.index > 0 ? static_cast<std::uint16_t>(word.index) : 0;
    if (word.index >= 0 && ends_block(number))
        return fail_word(x, Alarm::ExtensionForbidden, word, fmt::format("M{}", number));
    return true;
}

}  // namespace

void m_to_plc(Execution& x, const Word& word, std::int64_t m) {
    // an axis gets its drive back: its position is known behind it
    const bool frees = m == 5 && x.core.frees_axis();
    x.core.aux('M', static_cast<double>(m),
               word.index > 0 ? fmt::format("M{}={}", word.index, m) : fmt::format("M{}", m),
               frees);
    if (frees) stop_reading(x);
}

bool functions_before(Execution& x) {
    if (x.block.words.empty() && x.block.codes.empty()) return true;
    if (!spindle_words(x)) return false;
    for (const Word& word : x.block.words) {
        if (word.address->name == "H") {
            x.core.aux('H', word.number(),
                       word.index > 0 ? fmt::format("H{}={}", word.index, to_text(word.value))
                                      : fmt::format("H{}", to_text(word.value)),
                       false);
        } else if (word.address->name == "M") {
            std::int64_t m = 0;
            std::uint16_t spindle = 0;
            if (!m_number(x, word, m, spindle)) return false;
            if (ends_block(m)) continue;
            if (x.settings.tool_by_m6 && m == x.settings.tool_change_m) {
                if (!change_tool(x)) return false;
                x.core.at.tool = x.core.path.tool.ref;
            }
            if (m == 19 || m == 70 || (m >= 40 && m <= 45)) {
                const bool ok = with_spindle(x, spindle, [&] {
                    if (x.core.path.spindle.spindle == 0)
                        return fail_word(x, Alarm::SpindleMissing, word, "M");
                    std::uint32_t& closed = x.modal.closed_spindles;
                    const std::uint32_t bit = 1u << (x.core.path.spindle.spindle - 1);
                    if (m == 70) x.modal.cutting_speeds &= ~bit;
                    if (m == 70 && x.core.frees_axis()) {
                        spindle_to_axis(x);
                        stop_reading(x);
                    } else if (m == 70 && !(closed & bit))
                        close_spindle(x, false);
                    if (m >= 40 && m <= 45) closed &= ~bit;
                    if (m != 19) return true;
                    closed |= bit;
                    x.modal.cutting_speeds &= ~bit;
                    static constexpr SpindleApproach kHow[] = {SpindleApproach::Shortest,
                                                               SpindleApproach::Positive,
                                                               SpindleApproach::Negative};
                    const auto how = static_cast<std::size_t>(params::get(
                        x.core.view().table(), params::sd43250, x.core.path.spindle.spindle));
                    x.core.position_feed(spindle_feed_rpm(x, x.core.path.spindle.spindle));
                    const bool told = x.core.spindle_position(m19_position(x, spindle),
                                                              kHow[std::min<std::size_t>(how, 2)]);
                    x.core.position_feed(0.0);
                    return told;
                });
                if (!ok) return false;
            }
            // before the barrier
            const bool told = x.settings.tool_by_m6 && m == x.settings.tool_change_m &&
                              x.run.tool_serial == x.core.at.serial;
            if (!is_spindle_function(m) && !told) m_to_plc(x, word, m);
        }
    }
    return true;
}

// M0 M1 M2 M17 M30: behind the motion of the block.
bool functions_after(Execution& x) {
    for (const Word& word : x.block.words) {
        if (word.address->name != "M") continue;
        std::int64_t m = 0;
        std::uint16_t spindle = 0;
        if (!m_number(x, word, m, spindle)) return false;
        if (!ends_block(m)) continue;
        if (m == 0 || m == 1) {
            if (m == 1 && !x.core.port().optional_stop()) {
                x.core.sink().stop({StopReason::M01, nullptr, false}, x.core.at);
                continue;
            }
            x.core.mark_emitted();
            x.core.sink().stop({m == 0 ? StopReason::M00 : StopReason::M01}, x.core.at);
            stop_reading(x);
            continue;
        }
        x.run.called = true;
        unsigned programs = 0;
        for (const Level& level : x.calls.levels) programs += !level.section;
        // M2 and M30 of a subprogram are its end; of M17 the PLC hears, other than of RET
        // (sinumerik_part3 7.15)
        if (programs > 1) {
            if (m == 17) m_to_plc(x, word, m);
            return return_from_level(x);
        }
        if (x.modal.geo.open_line) return fail(x, Alarm::ContourLineOpen);
        if (x.modal.geo.approach) return fail(x, Alarm::ApproachNoEnd);
        if (x.modal.curve) return fail(x, Alarm::StructureNesting, "CTABDEF");
        x.core.mark_emitted();
        x.core.sink().part(++x.shown.parts, x.core.at);
        finish(x, m == 2 ? StopReason::M02 : StopReason::M30);  // M17 of a main program acts as M30
        return true;
    }
    return true;
}

}  // namespace polyturn::channels::sinumerik
