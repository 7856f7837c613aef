// Synchronized actions: ID= IDS= WHEN WHENEVER FROM EVERY DO; CANCEL LOCK UNLOCK RESET STOPREOF
// (sinumerik_part3 1.4, 7.12, 8).
#include "channels/sinumerik/actions/synchronized.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "channels/sinumerik/actions/delete_way.hpp"
#include "channels/sinumerik/actions/overlays.hpp"
#include "channels/sinumerik/actions/synchronized_action.hpp"
#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/axes/positioning.hpp"
#include "channels/sinumerik/coordination/functions_ms.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/control.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/grammar/expression.hpp"
#include "channels/sinumerik/grammar/without_effect.hpp"
#include "channels/sinumerik/grammar/words.hpp"
#include "channels/sinumerik/variables/changes.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {
namespace {

using When = SynchronizedAction::When;
constexpr double kHighestId = 255;

struct Keyword {
    std::string_view name;
    When when;
};
constexpr Keyword kKeywords[] = {{"DO", When::Always},
                                 {"WHEN", When::Once},
                                 {"WHENEVER", When::Whenever},
                                 {"FROM", When::From},
                                 {"EVERY", When::Edge}};

const Keyword* keyword(std::string_view name) {
    for (const Keyword& row : kKeywords)
        if (row.name == name) return &row;
    return nullptr;
}

template <std::size_t n>
bool among(const std::string_view (&names)[n], std::string_view name) {
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

// What may stand behind DO: the + of column SA (1.4 and 3), and what other sections let stand there
// (FA with POS; FXS: part 2, 15.6).
bool allowed(std::string_view address) {
    static constexpr std::string_view kAddresses[] = {
        "M",   "S",        "H",       "SPOS",     "POS", "FA",   "OVRA",
        "ACC", "VELOLIMA", "ACCLIMA", "JERKLIMA", "FXS", "FXST", "FXSW"};
    return among(kAddresses, address);
}

bool allowed_call(std::string_view procedure) {
    static constexpr std::string_view kProcedures[] = {
        "LOCK",     "UNLOCK",    "RESET",   "STOPREOF", "SETM",     "CLEARM",
        "SETAL",    "TRAILON",   "TRAILOF", "SYNFCT",   "LEADON",   "LEADOF",
        "PRESETON", "PRESETONS", "RELEASE", "AXTOCHAN", "CTABLOCK", "CTABUNLOCK",
        "IPOBRKA",  "ICYCON",    "ICYCOF",  "RDISABLE", "DELDTG"};
    return among(kProcedures, procedure);
}

bool allowed_function(std::string_view function) {
    static constexpr std::string_view kFunctions[] = {
        "ABS",   "SIN",   "COS",     "TAN", "ASIN", "ACOS",   "ATAN2",  "SQRT",  "POT",
        "TRUNC", "ROUND", "ROUNDUP", "LN",  "EXP",  "MINVAL", "MAXVAL", "BOUND", "POSRANGE"};
    return function.starts_with("CTAB") || among(kFunctions, function);
}

// The DO behind a condition; texts do not count.
bool find_do(Cursor& at) {
    bool text = false;
    while (!at.at_end()) {
        if (at.next_raw() == '"') text = !text;
        const std::string_view name = text ? std::string_view{} : at.name_ahead();
        if (upper(name) == "DO") return true;
        at.advance(std::max<std::size_t>(name.size(), 1));
    }
    return false;
}

// What cannot be done is refused where it is programmed, not when its moment has come: by words of
// the block, those behind an operator or within brackets are operands.
bool action_is_reportable(Execution& x, bool& deletes_travel) {
    unsigned brackets = 0;
    bool text = false, operand = false;
    for (Cursor part = x.line.cursor; !part.at_end();) {
        const char c = part.next_raw();
        if (c == '"') text = !text;
        const std::string word = text ? std::string() : upper(part.name_ahead());
        if (word.empty()) {
            if (!text && (c == '(' || c == '[')) ++brackets;
            if (!text && (c == ')' || c == ']') && brackets > 0) --brackets;
            if (!is_blank(c))
                operand = !text && std::string_view("=<>+-*/,").find(c) != std::string_view::npos;
            part.advance(1);
            continue;
        }
        const bool numbered = word.size() > 1 && is_digit(word[1]);
        const Symbol symbol =
            find_variable(x, word) ? Symbol{} : find_symbol(numbered ? word.substr(0, 1) : word);
        const auto refuse = [&](Alarm alarm) {
            return fail_at(x, alarm, part.at(), word.size(), "DO " + word);
        };
        operand = operand || brackets > 0;
        if (numbered && word[0] == 'G') return refuse(Alarm::AddressIllegal);
        if (operand) {
            if (symbol.kind == Symbol::Kind::Command && symbol.command().function &&
                !allowed_function(symbol.command().name))
                return refuse(Alarm::AddressIllegal);
        } else {
            switch (symbol.kind) {
                case Symbol::Kind::G:
                case Symbol::Kind::Statement:
                    return refuse(Alarm::AddressIllegal);
                case Symbol::Kind::Reserved:
                    return refuse(Alarm::NotBuilt);
                case Symbol::Kind::Address:
                    if (!allowed(symbol.address().name)) return refuse(Alarm::AddressIllegal);
                    break;
                case Symbol::Kind::Command:
                    if (!symbol.command().act) return refuse(Alarm::NotBuilt);
                    if (!allowed_call(symbol.command().name)) return refuse(Alarm::AddressIllegal);
                    if (word == "DELDTG") {
                        Cursor behind = part;
                        behind.advance(word.size());
                        // of one positioning axis
                        if (behind.eat('(') && behind.peek() != ')') return refuse(Alarm::NotBuilt);
                        deletes_travel = true;
                    }
                    break;
                default:
                    // it moves by POS
                    if (const int axis = find_axis(x, numbered ? word.substr(0, 1) : word);
                        axis >= 0 && axis < kSpindleAxis)
                        return refuse(Alarm::AddressIllegal);
            }
        }
        operand = symbol.kind == Symbol::Kind::Operator;
        part.advance(word.size());
    }
    return true;
}

// A dwell may stand behind the actions: WHEN TRUE DO $AA_OFF[X]=10 G4 F5 (sinumerik_part2 13.11).
// It is the output block with which they act, so it is taken off the line and comes next.
void split_dwell(Execution& x) {
    bool text = false;
    unsigned brackets = 0;
    for (Cursor part = x.line.cursor; !part.at_end();) {
        const char c = part.next_raw();
        if (c == '"') text = !text;
        if (!text && (c == '(' || c == '[')) ++brackets;
        if (!text && (c == ')' || c == ']') && brackets > 0) --brackets;
        const std::string word = text ? std::string() : upper(part.name_ahead());
        if (brackets == 0 && (word == "G4" || word == "G04") && part.at() > x.line.cursor.at()) {
            const auto here = static_cast<std::size_t>(x.line.cursor.at() - x.line.cursor.begin());
            x.line.execute = std::string(part.at(), part.end());
            x.line.text.resize(static_cast<std::size_t>(part.at() - part.begin()));
            x.line.cursor = Cursor(x.line.text);
            x.line.cursor.advance(here);
            return;
        }
        part.advance(std::max<std::size_t>(word.size(), 1));
    }
}

bool read_action(Execution& x, const SynchronizedAction& action) {
    x.block.clear();
    x.line.statement = nullptr;
    x.line.cursor = Cursor(action.text);
    x.line.cursor.advance(action.action_at);
    if (!parse_words(x)) return false;
    if (x.line.statement)
        return fail_at(x, Alarm::NotBuilt, x.line.cursor.at(), 1,
                       "DO " + std::string(x.line.statement->name));
    if (!x.block.codes.empty())
        return fail(x, Alarm::NotBuilt, "DO " + std::string(x.block.codes.front()->name));
    if (x.block.program.wanted) return fail(x, Alarm::NotBuilt, "DO " + x.block.program.name);
    for (const Word& word : x.block.words) {
        const std::string_view name = word.address->name;
        // an axis moves by POS
        if (name == "axis")
            return fail_word(x, Alarm::AddressIllegal, word, axis_name(x, word.axis));
        if (!allowed(name)) return fail_word(x, Alarm::NotBuilt, word, "DO " + std::string(name));
        if (name == "M" && (word.number() == 2 || word.number() == 17 || word.number() == 30))
            return fail_word(x, Alarm::NotBuilt, word, "DO M" + to_text(word.value));
    }
    return true;
}

bool do_action(Execution& x) {
    for (const Word& word : x.block.words)
        if (word.address->use == Address::Use::Setting && !word.address->act(x, word)) return false;
    if (!functions_before(x) || !drive_overlays(x)) return false;
    std::vector<std::pair<const Command*, Call>> procedures = std::move(x.block.procedures);
    for (auto& one : procedures) {
        x.block.procedures.clear();
        x.block.procedures.push_back(one);
        if (!one.first->act(x, one.second)) return false;
    }
    AxisSet nobody_waits = 0;
    return start_positioning(x, nobody_waits) && functions_after(x);
}

bool each_action(Execution& x, Call& c, const std::function<void(SynchronizedAction&)>& change) {
    undo(x, [&x, before = x.actions.all] { x.actions.all = before; });
    for (const Argument& argument : c.arguments) {
        if (!argument.given || !(argument.value.number >= 1 && argument.value.number <= kHighestId))
            return fail(x, Alarm::ValueOutOfRange, "ID", argument.value.number);
        for (SynchronizedAction& one : x.actions.all)
            if (one.id == static_cast<unsigned>(argument.value.number)) change(one);
    }
    return true;
}

bool machine_there(Execution& x) {
    return x.core.view().axis_count > 0 &&
           x.core.port().axis_command(x.core.view().axes[0].machine_axis).has_value();
}

}  // namespace

// A block that only registers actions: it moves nothing and outputs nothing.
bool st_synchronized(Execution& x) {
    SynchronizedAction action;
    std::string name(x.line.statement->name);
    const char* at = x.line.cursor.at() - name.size();
    if (name == "ID" || name == "IDS") {
        action.is_static = name == "IDS";
        Value id;
        if (!x.line.cursor.at_assign()) return syntax(x, x.line.cursor.at(), "=");
        x.line.cursor.advance(1);
        const char* const from = x.line.cursor.at();
        if (!expression(x, id)) return false;
        if (!id.is_number() || !(id.number >= 1 && id.number <= kHighestId) ||
            id.number != std::floor(id.number))
            return fail_at(x, Alarm::ValueOutOfRange, from, 1, name, id.number);
        action.id = static_cast<unsigned>(id.number);
        at = x.line.cursor.at();
        name = upper(x.line.cursor.name_ahead());
        x.line.cursor.advance(name.size());
    }
    const Keyword* const row = keyword(name);
    if (!row) return syntax(x, at, name.empty() ? "DO" : name);
    action.when = row->when;
    action.condition_at = static_cast<std::size_t>(x.line.cursor.at() - x.line.cursor.begin());
    if (row->when != When::Always) {
        if (upper(x.line.cursor.name_ahead()) == "DO") return syntax(x, x.line.cursor.at(), "DO");
        if (!find_do(x.line.cursor)) return syntax(x, x.line.cursor.at(), "DO");
        x.line.cursor.advance(2);
    }
    action.action_at = static_cast<std::size_t>(x.line.cursor.at() - x.line.cursor.begin());
    if (x.line.cursor.at_end()) return syntax(x, x.line.cursor.at(), "DO");
    const std::size_t said_at = x.line.cursor.column(at);
    split_dwell(x);
    if (!action_is_reportable(x, action.deletes_travel)) {
        x.line.execute.clear();
        return false;
    }
    if (action.deletes_travel && row->when != When::Always) {
        Cursor asked(x.line.text);
        asked.advance(action.condition_at);
        if (!asks_positions_only(x, asked, action.action_at - 2)) return false;  // up to DO
    }
    action.text = x.line.text;
    action.line = x.core.at.line;
    // the first one of a program says what they have in common; a way is deleted where its
    // condition holds
    if (!x.modal.actions_told && !action.deletes_travel) {
        x.modal.actions_told = true;
        x.core.mark_emitted();
        x.core.sink().alarm(
            {Alarm::ActionsAtBlocks,
             {x.files.path(x.calls.levels.back().file), x.core.at.line,
              static_cast<std::uint32_t>(said_at), static_cast<std::uint32_t>(name.size())},
             {},
             name},
            x.core.at);
    }
    undo(x, [&x, before = x.actions.all] { x.actions.all = before; });
    // a new one takes its place
    if (action.id)
        std::erase_if(x.actions.all,
                      [&](const SynchronizedAction& one) { return one.id == action.id; });
    x.actions.all.push_back(std::move(action));
    // it is reported, also where the rest of the line has to be read again
    if (!x.line.execute.empty()) x.changes.of_block.clear();
    return true;
}

// Before an output block acts, its words are read: every condition is looked at, then all that is
// due is read and done. So it is before a procedure (STOPRE, CANCEL), but for what only goes on
// holding and outputs something. A condition that needs a live value brings the block behind a
// barrier; nothing has happened until then.
bool synchronized_actions(Execution& x) {
    x.actions.travel_deleted = false;
    const bool outputs = !x.block.words.empty() || !x.block.codes.empty();
    if (x.actions.all.empty() || (!outputs && x.block.procedures.empty())) return true;
    Block output = std::move(x.block);
    const Cursor cursor = x.line.cursor;
    const Statement* const statement = x.line.statement;
    std::vector<SynchronizedAction> next = x.actions.all;
    std::vector<std::pair<const SynchronizedAction*, Block>> due;
    // the alarm names the line of the action
    const auto said_by = [&x](const SynchronizedAction& action) {
        if (x.pass.needs_barrier) return false;
        x.core.at.line = action.line;
        x.core.at.block = -1;
        x.line.text = action.text;
        return false;
    };
    x.actions.in_action = true;
    bool holds_reading = false;  // RDISABLE
    const std::size_t own_undo = x.changes.of_block.size();
    for (SynchronizedAction& action : next) {
        if (action.locked) continue;
        // its block is still to come
        if (!outputs && action.id == 0 && action.looks == 0) continue;
        bool holds = true;
        x.line.cursor = Cursor(action.text);
        x.line.cursor.advance(action.condition_at);
        if (action.when != When::Always && !condition(x, holds)) {
            x.actions.in_action = false;
            return said_by(action);
        }
        if (action.when != When::Always && upper(x.line.cursor.name_ahead()) != "DO") {
            x.actions.in_action = false;
            syntax(x, x.line.cursor.at(), "DO");
            return said_by(action);
        }
        // its DELDTG is done, the rest of it is due
        const bool at_its_end = std::exchange(action.has_cut, false);
        if (!action.is_due(holds || at_its_end)) continue;
        if (!read_action(x, action) || !take_back_released_axes(x)) {
            x.actions.in_action = false;
            return said_by(action);
        }
        // its M or H comes with each output block
        if (!outputs && action.when != When::Once && action.when != When::Edge &&
            !x.block.words.empty())
            continue;
        // not behind its own block
        if (action.deletes_travel && !at_its_end && (action.id != 0 || action.looks < 2))
            x.actions.travel_deleted = true;
        for (const auto& [command, call] : x.block.procedures)
            holds_reading = holds_reading || command->name == "RDISABLE";
        due.emplace_back(&action, std::move(x.block));
    }
    undo(x, [&x, before = x.actions.all] { x.actions.all = before; });
    x.actions.all = next;
    x.pass.reads = false;
    for (auto& [action, block] : due) {
        x.block = std::move(block);
        if (!do_action(x)) {
            x.actions.in_action = false;
            return said_by(*action);
        }
    }
    x.actions.in_action = false;
    x.pass.reads = true;
    // the block is read again behind a barrier; what the actions have done stays
    if (holds_reading && machine_there(x)) {
        x.changes.of_block.resize(own_undo);
        for (SynchronizedAction& one : x.actions.all)
            if (one.id == 0 && one.when != When::Always) one.looks = 0;
        x.pass.needs_barrier = true;
        return false;
    }
    std::erase_if(x.actions.all, [](const SynchronizedAction& one) { return one.is_over(); });
    x.block = std::move(output);
    x.line.cursor = cursor;
    x.line.statement = statement;
    return true;
}

bool p_cancel(Execution& x, Call& c) {
    if (x.actions.in_action) return fail(x, Alarm::NotBuilt, "DO CANCEL");
    constexpr unsigned kGone = ~0u;
    if (!each_action(x, c, [](SynchronizedAction& one) { one.id = kGone; })) return false;
    std::erase_if(x.actions.all, [](const SynchronizedAction& one) { return one.id == kGone; });
    return true;
}

bool p_lock(Execution& x, Call& c) {
    return only_in_action(x, "LOCK") &&
           each_action(x, c, [](SynchronizedAction& one) { one.locked = true; });
}
bool p_unlock(Execution& x, Call& c) {
    return only_in_action(x, "UNLOCK") &&
           each_action(x, c, [](SynchronizedAction& one) { one.locked = false; });
}
// of technology cycles
bool p_action_reset(Execution& x, Call& c) {
    return only_in_action(x, "RESET") && each_action(x, c, [](SynchronizedAction&) {}) &&
           p_without_effect(x, c);
}
// limited_travel() does it
bool p_delete_travel(Execution& x, Call&) { return only_in_action(x, "DELDTG"); }
// RDISABLE: the block behind is not read while the condition holds. Without a machine nothing would
// ever change it.
bool p_read_disable(Execution& x, Call& c) {
    return only_in_action(x, "RDISABLE") && (machine_there(x) || p_without_effect(x, c));
}

// ICYCON, ICYCOF: of technology cycles
bool p_cycle_steps(Execution& x, Call& c) {
    return only_in_action(x, x.block.procedures.front().first->name) && p_without_effect(x, c);
}
bool p_stop_reading_of(Execution& x, Call&) {
    return only_in_action(x, "STOPREOF") && (stop_reading(x), true);
}
bool only_in_action(Execution& x, std::string_view name) {
    return x.actions.in_action || fail(x, Alarm::AddressIllegal, std::string(name));
}

}  // namespace polyturn::channels::sinumerik
