// A block whose words are read: what must not be, and the order in which the rest acts.
#include "channels/sinumerik/act.hpp"

#include <algorithm>

#include "channels/sinumerik/actions/delete_way.hpp"
#include "channels/sinumerik/actions/overlays.hpp"
#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/axes/feeds.hpp"
#include "channels/sinumerik/axes/fixed_stop.hpp"
#include "channels/sinumerik/axes/positioning.hpp"
#include "channels/sinumerik/coordination/functions_ms.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/frames/settable_frames.hpp"
#include "channels/sinumerik/spindles/spindle_commands.hpp"
#include "channels/sinumerik/tools/tools.hpp"
#include "channels/sinumerik/variables/variables.hpp"
#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// Groups whose handler acts before tools and functions, in this order: units and plane first, since
// the words count in them.
constexpr std::uint8_t kEarly[] = {13, 6,  14, 29, 4,  10, 11, 12, 19, 20, 21, 24, 25, 26,
                                   27, 28, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 41, 42,
                                   45, 46, 47, 49, 50, 51, 52, 53, 54, 55, 56, 57, 59, 61,
                                   62, 64, 16, 17, 18, 22, 23, 40, 43, 44, 48, 60, 15, 8};
constexpr std::uint8_t kFrameGroup = 3, kSuppression = 9, kCompensation = 7, kMotion = 1,
                       kOneShot = 2;

bool in_list(std::string_view list, std::string_view name) {
    for (std::size_t at = list.find(name); at != std::string_view::npos;
         at = list.find(name, at + 1)) {
        const bool front = at == 0 || list[at - 1] == ' ',
                   back = at + name.size() == list.size() || list[at + name.size()] == ' ';
        if (front && back) return true;
    }
    return false;
}

bool is_function(std::string_view name) {
    return name.size() == 1 && std::string_view("MHSTDF").find(name[0]) != std::string_view::npos;
}

bool settings_and_tools(Execution& x) {
    const auto run = [&x](std::uint8_t group) {
        const GCode* code = x.block.coded[group];
        if (!code) return true;
        if (!code->act(x, *code)) return false;
        if (code->modal) x.modal.active[group] = code->number;
        return true;
    };
    if (!x.block.codes.empty())
        for (const std::uint8_t group : kEarly)
            if (!run(group)) return false;
    if (const GCode* code = x.block.coded[kMotion]) {
        if (code->number != x.modal.active[kMotion] && !motion_changes(x, *code)) return false;
        x.modal.active[kMotion] = code->number;
    }
    x.core.at.display_swapped = display_swapped(x);
    x.pass.feed = 0.0;
    if (x.block.words.empty()) return true;
    if (!tool_words(x)) return false;
    x.core.at.tool = x.core.path.tool.ref;
    for (const Word& word : x.block.words) {
        if (word.address->name == "F" && !feed_word(x, word)) return false;
        if (word.address->use == Address::Use::Setting && !word.address->act(x, word)) return false;
    }
    return true;
}

bool motion(Execution& x) {
    if (const GCode* code = x.block.coded[kSuppression]; code && !code->act(x, *code)) return false;
    if (const GCode* code = x.block.coded[kFrameGroup]; code && !code->act(x, *code)) return false;
    if (const GCode* code = x.block.coded[kCompensation]) {
        if (!code->act(x, *code)) return false;
        x.modal.active[kCompensation] = code->number;
    }
    const GCode* one_shot = x.block.coded[kOneShot];
    const GCode* code = one_shot;
    if (!code && !x.block.coded[kFrameGroup]) {
        const bool wanted =
            std::any_of(x.block.words.begin(), x.block.words.end(), [&](const Word& word) {
                return word.address->use == Address::Use::Block &&
                       !is_function(word.address->name) && word.address->name != "P";
            });
        if (wanted || x.block.coded[kMotion] || x.block.coded[kCompensation])
            code = find_g(kMotion, x.modal.active[kMotion]);
    }
    if (!code) return true;
    if (!code->act) return fail(x, Alarm::NotBuilt, std::string(code->name));
    // straight ways only
    if (code->group == kMotion && code->number > 2 && deletes_travel(x))
        return fail(x, Alarm::NotBuilt, "DELDTG: " + std::string(code->name));
    // straight segments only
    if (x.modal.curve && (code->group != 1 || code->number > 2))
        return fail(x, Alarm::CodesContradict, "CTABDEF, " + std::string(code->name));
    const bool thread =
        code->group == 1 && ((code->number >= 10 && code->number <= 12) || code->number >= 16);
    // FPR
    const bool other =
        x.modal.feed_spindle && x.modal.feed_revolution && code->group == 1 && !thread;
    if (!update_feed(x) || !with_spindle(x, other ? x.modal.feed_spindle : std::uint16_t{0},
                                         [&] { return code->act(x, *code); }))
        return false;
    for (AxisSet left = axis_words(x); left; left &= left - 1) {
        const auto i = static_cast<unsigned>(__builtin_ctz(left));
        x.modal.pending_zero[i] = x.modal.pending_tool[i] = 0.0;
    }
    return true;
}

}  // namespace

bool takes(const GCode& code, const Address& address) {
    return in_list(code.takes, address.name == "axis" ? "axes" : address.name);
}

// The G command that drives the axis words: of group 2, 3 or, when none of them wants them, group
// 1.
const GCode* motion_code(const Execution& x) {
    for (const std::uint8_t group : {kOneShot, kFrameGroup})
        if (const GCode* code = x.block.coded[group]) return code;
    return find_g(
        kMotion, x.block.coded[kMotion] ? x.block.coded[kMotion]->number : x.modal.active[kMotion]);
}

bool check_block(Execution& x) {
    const GCode* motion = motion_code(x);
    unsigned m = 0, s = 0, h = 0, others = 0;
    for (const Word& word : x.block.words) {
        const Address& address = *word.address;
        for (const std::string_view name : {"T", "D", "DL", "F", "FA"})
            others += address.name == name;
        if (address.name == "M" && ++m > 5) return fail_word(x, Alarm::FunctionsTooMany, word, "M");
        if (address.name == "H" && ++h > 3) return fail_word(x, Alarm::FunctionsTooMany, word, "H");
        if (address.name == "S" && ++s > 3) return fail_word(x, Alarm::FunctionsTooMany, word, "S");
        if (address.use == Address::Use::Setting) continue;
        if (is_function(address.name)) continue;
        if (address.name == "P" && (x.block.program.wanted || x.line.statement)) continue;
        bool taken = motion && takes(*motion, address);
        for (const GCode* code : x.block.codes) taken = taken || takes(*code, address);
        if (!taken)
            return fail_word(
                x, Alarm::AddressIllegal, word,
                address.name == "axis" ? axis_name(x, word.axis) : std::string(address.name));
    }
    // sinumerik_part2 14
    if (m + s + h + others > 10) return fail(x, Alarm::FunctionsTooMany, "M S H T D F");
    if (const GCode* frame = x.block.coded[kFrameGroup];
        frame && x.block.codes.size() > 1 && (frame->number < 9 || frame->number > 14))
        // frame commands (sinumerik_part2 13.2)
        return fail(x, Alarm::OwnBlockNeeded, std::string(frame->name));
    // Poles, and the limits of G25 and G26: their axis words are no way (sinumerik_part1 10.3,
    // sinumerik_part2 15.3.1).
    if (const GCode* pole = x.block.coded[kFrameGroup];
        pole && pole->number >= 10 && pole->number <= 14 &&
        (x.block.coded[kMotion] || x.block.coded[kOneShot]))
        return fail(x, Alarm::OwnBlockNeeded, std::string(pole->name));
    // 15.7
    if (const GCode* dwell = x.block.coded[kOneShot];
        dwell && dwell->name == "G4" && axis_words(x) != 0)
        return fail(x, Alarm::OwnBlockNeeded, "G4");
    const std::size_t other = x.block.words.size() + x.block.codes.size();
    for (const auto& [command, call] : x.block.procedures)
        if (command->own_block && (other > 0 || x.block.procedures.size() > 1))
            return fail(x, Alarm::OwnBlockNeeded, std::string(command->name));
    return true;
}

bool act(Execution& x) {
    for (const Written& one : x.changes.written) report_variable(x, one.name, one.value);
    x.changes.written.clear();
    tell_written_zeros(x);
    if (!settings_and_tools(x) || !functions_before(x)) return false;
    for (auto& [command, call] : x.block.procedures)
        if (!command->act(x, call)) return false;
    // what they have given back
    for (const Written& one : x.changes.written) report_variable(x, one.name, one.value);
    x.changes.written.clear();
    AxisSet under_way = 0;
    if (!drive_overlays(x) || !begin_stops(x) || !start_positioning(x, under_way) || !motion(x) ||
        !position_in_parts(x))
        return false;
    if (x.core.due_at_barrier()) stop_reading(x);
    if (under_way) x.core.arrive(under_way, 0);  // POS: the block ends when they are there
    return functions_after(x);
}

// --- where axis words want their axes

}  // namespace polyturn::channels::sinumerik
