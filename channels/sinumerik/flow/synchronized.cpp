// Synchronized actions: ID= IDS= WHEN WHENEVER FROM EVERY DO; CANCEL LOCK UNLOCK RESET STOPREOF
// (sinumerik_part3 1.4, 7.12, 8).
#include "channels/sinumerik/flow/synchronized.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "channels/sinumerik/interpreter.hpp"

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

}  // namespace

// The DO behind a condition; texts do not count.
bool Interpreter::find_do(Cursor& at) {
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
bool Interpreter::action_is_reportable(bool& deletes_travel) {
    unsigned brackets = 0;
    bool text = false, operand = false;
    for (Cursor part = cursor_; !part.at_end();) {
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
            find_variable(word) ? Symbol{} : find_symbol(numbered ? word.substr(0, 1) : word);
        const auto refuse = [&](Alarm alarm) {
            return fail_at(alarm, part.at(), word.size(), "DO " + word);
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
                    if (const int axis = find_axis(numbered ? word.substr(0, 1) : word);
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
void Interpreter::split_dwell() {
    bool text = false;
    unsigned brackets = 0;
    for (Cursor part = cursor_; !part.at_end();) {
        const char c = part.next_raw();
        if (c == '"') text = !text;
        if (!text && (c == '(' || c == '[')) ++brackets;
        if (!text && (c == ')' || c == ']') && brackets > 0) --brackets;
        const std::string word = text ? std::string() : upper(part.name_ahead());
        if (brackets == 0 && (word == "G4" || word == "G04") && part.at() > cursor_.at()) {
            const auto here = static_cast<std::size_t>(cursor_.at() - cursor_.begin());
            execute_ = std::string(part.at(), part.end());
            line_.resize(static_cast<std::size_t>(part.at() - part.begin()));
            cursor_ = Cursor(line_);
            cursor_.advance(here);
            return;
        }
        part.advance(std::max<std::size_t>(word.size(), 1));
    }
}

// A block that only registers actions: it moves nothing and outputs nothing.
bool Interpreter::st_synchronized() {
    SynchronizedAction action;
    std::string name(statement_->name);
    const char* at = cursor_.at() - name.size();
    if (name == "ID" || name == "IDS") {
        action.is_static = name == "IDS";
        Value id;
        if (!cursor_.at_assign()) return syntax(cursor_.at(), "=");
        cursor_.advance(1);
        const char* const from = cursor_.at();
        if (!expression(id)) return false;
        if (!id.is_number() || !(id.number >= 1 && id.number <= kHighestId) ||
            id.number != std::floor(id.number))
            return fail_at(Alarm::ValueOutOfRange, from, 1, name, id.number);
        action.id = static_cast<unsigned>(id.number);
        at = cursor_.at();
        name = upper(cursor_.name_ahead());
        cursor_.advance(name.size());
    }
    const Keyword* const row = keyword(name);
    if (!row) return syntax(at, name.empty() ? "DO" : name);
    action.when = row->when;
    action.condition_at = static_cast<std::size_t>(cursor_.at() - cursor_.begin());
    if (row->when != When::Always) {
        if (upper(cursor_.name_ahead()) == "DO") return syntax(cursor_.at(), "DO");
        if (!find_do(cursor_)) return syntax(cursor_.at(), "DO");
        cursor_.advance(2);
    }
    action.action_at = static_cast<std::size_t>(cursor_.at() - cursor_.begin());
    if (cursor_.at_end()) return syntax(cursor_.at(), "DO");
    const std::size_t said_at = cursor_.column(at);
    split_dwell();
    if (!action_is_reportable(action.deletes_travel)) {
        execute_.clear();
        return false;
    }
    if (action.deletes_travel && row->when != When::Always) {
        Cursor asked(line_);
        asked.advance(action.condition_at);
        if (!asks_positions_only(asked, action.action_at - 2)) return false;  // up to DO
    }
    action.text = line_;
    action.line = core_.at.line;
    // the first one of a program says what they have in common; a way is deleted where its
    // condition holds
    if (!modal_.actions_told && !action.deletes_travel) {
        modal_.actions_told = true;
        core_.mark_emitted();
        core_.sink().alarm(
            {Alarm::ActionsAtBlocks,
             {files_->path(levels_.back().file), core_.at.line, static_cast<std::uint32_t>(said_at),
              static_cast<std::uint32_t>(name.size())},
             {},
             name},
            core_.at);
    }
    undo([this, before = actions_] { actions_ = before; });
    // a new one takes its place
    if (action.id)
        std::erase_if(actions_, [&](const SynchronizedAction& one) { return one.id == action.id; });
    actions_.push_back(std::move(action));
    // it is reported, also where the rest of the line has to be read again
    if (!execute_.empty()) block_undo_.clear();
    return true;
}

bool Interpreter::read_action(const SynchronizedAction& action) {
    block_.clear();
    statement_ = nullptr;
    cursor_ = Cursor(action.text);
    cursor_.advance(action.action_at);
    if (!parse_words()) return false;
    if (statement_)
        return fail_at(Alarm::NotBuilt, cursor_.at(), 1, "DO " + std::string(statement_->name));
    if (!block_.codes.empty())
        return fail(Alarm::NotBuilt, "DO " + std::string(block_.codes.front()->name));
    if (block_.program.wanted) return fail(Alarm::NotBuilt, "DO " + block_.program.name);
    for (const Word& word : block_.words) {
        const std::string_view name = word.address->name;
        // an axis moves by POS
        if (name == "axis") return fail_word(Alarm::AddressIllegal, word, axis_name(word.axis));
        if (!allowed(name)) return fail_word(Alarm::NotBuilt, word, "DO " + std::string(name));
        if (name == "M" && (word.number() == 2 || word.number() == 17 || word.number() == 30))
            return fail_word(Alarm::NotBuilt, word, "DO M" + to_text(word.value));
    }
    return true;
}

bool Interpreter::do_action() {
    for (const Word& word : block_.words)
        if (word.address->use == Address::Use::Setting && !(this->*word.address->act)(word))
            return false;
    if (!functions_before() || !drive_overlays()) return false;
    std::vector<std::pair<const Command*, Call>> procedures = std::move(block_.procedures);
    for (auto& one : procedures) {
        block_.procedures.clear();
        block_.procedures.push_back(one);
        if (!(this->*one.first->act)(one.second)) return false;
    }
    AxisSet nobody_waits = 0;
    return start_positioning(nobody_waits) && functions_after();
}

// Before an output block acts, its words are read: every condition is looked at, then all that is
// due is read and done. So it is before a procedure (STOPRE, CANCEL), but for what only goes on
// holding and outputs something. A condition that needs a live value brings the block behind a
// barrier; nothing has happened until then.
bool Interpreter::synchronized_actions() {
    travel_deleted_ = false;
    const bool outputs = !block_.words.empty() || !block_.codes.empty();
    if (actions_.empty() || (!outputs && block_.procedures.empty())) return true;
    Block output = std::move(block_);
    const Cursor cursor = cursor_;
    const Statement* const statement = statement_;
    std::vector<SynchronizedAction> next = actions_;
    std::vector<std::pair<const SynchronizedAction*, Block>> due;
    // the alarm names the line of the action
    const auto said_by = [this](const SynchronizedAction& action) {
        if (needs_barrier_) return false;
        core_.at.line = action.line;
        core_.at.block = -1;
        line_ = action.text;
        return false;
    };
    in_action_ = true;
    bool holds_reading = false;  // RDISABLE
    const std::size_t own_undo = block_undo_.size();
    for (SynchronizedAction& action : next) {
        if (action.locked) continue;
        // its block is still to come
        if (!outputs && action.id == 0 && action.looks == 0) continue;
        bool holds = true;
        cursor_ = Cursor(action.text);
        cursor_.advance(action.condition_at);
        if (action.when != When::Always && !condition(holds)) {
            in_action_ = false;
            return said_by(action);
        }
        if (action.when != When::Always && upper(cursor_.name_ahead()) != "DO") {
            in_action_ = false;
            syntax(cursor_.at(), "DO");
            return said_by(action);
        }
        // its DELDTG is done, the rest of it is due
        const bool at_its_end = std::exchange(action.has_cut, false);
        if (!action.is_due(holds || at_its_end)) continue;
        if (!read_action(action) || !take_back_released_axes()) {
            in_action_ = false;
            return said_by(action);
        }
        // its M or H comes with each output block
        if (!outputs && action.when != When::Once && action.when != When::Edge &&
            !block_.words.empty())
            continue;
        // not behind its own block
        if (action.deletes_travel && !at_its_end && (action.id != 0 || action.looks < 2))
            travel_deleted_ = true;
        for (const auto& [command, call] : block_.procedures)
            holds_reading = holds_reading || command->name == "RDISABLE";
        due.emplace_back(&action, std::move(block_));
    }
    undo([this, before = actions_] { actions_ = before; });
    actions_ = next;
    reading_ = false;
    for (auto& [action, block] : due) {
        block_ = std::move(block);
        if (!do_action()) {
            in_action_ = false;
            return said_by(*action);
        }
    }
    in_action_ = false;
    reading_ = true;
    // the block is read again behind a barrier; what the actions have done stays
    if (holds_reading && machine_there()) {
        block_undo_.resize(own_undo);
        for (SynchronizedAction& one : actions_)
            if (one.id == 0 && one.when != When::Always) one.looks = 0;
        needs_barrier_ = true;
        return false;
    }
    std::erase_if(actions_, [](const SynchronizedAction& one) { return one.is_over(); });
    block_ = std::move(output);
    cursor_ = cursor;
    statement_ = statement;
    return true;
}

bool Interpreter::each_action(Call& c, const std::function<void(SynchronizedAction&)>& change) {
    undo([this, before = actions_] { actions_ = before; });
    for (const Argument& argument : c.arguments) {
        if (!argument.given || !(argument.value.number >= 1 && argument.value.number <= kHighestId))
            return fail(Alarm::ValueOutOfRange, "ID", argument.value.number);
        for (SynchronizedAction& one : actions_)
            if (one.id == static_cast<unsigned>(argument.value.number)) change(one);
    }
    return true;
}

bool Interpreter::p_cancel(Call& c) {
    if (in_action_) return fail(Alarm::NotBuilt, "DO CANCEL");
    constexpr unsigned kGone = ~0u;
    if (!each_action(c, [](SynchronizedAction& one) { one.id = kGone; })) return false;
    std::erase_if(actions_, [](const SynchronizedAction& one) { return one.id == kGone; });
    return true;
}

bool Interpreter::p_lock(Call& c) {
    return only_in_action("LOCK") &&
           each_action(c, [](SynchronizedAction& one) { one.locked = true; });
}
bool Interpreter::p_unlock(Call& c) {
    return only_in_action("UNLOCK") &&
           each_action(c, [](SynchronizedAction& one) { one.locked = false; });
}
// of technology cycles
bool Interpreter::p_action_reset(Call& c) {
    return only_in_action("RESET") && each_action(c, [](SynchronizedAction&) {}) &&
           p_without_effect(c);
}
// limited_travel() does it
bool Interpreter::p_delete_travel(Call&) { return only_in_action("DELDTG"); }
// RDISABLE: the block behind is not read while the condition holds. Without a machine nothing would
// ever change it.
bool Interpreter::p_read_disable(Call& c) {
    return only_in_action("RDISABLE") && (machine_there() || p_without_effect(c));
}
bool Interpreter::machine_there() {
    return core_.view().axis_count > 0 &&
           core_.port().axis_command(core_.view().axes[0].machine_axis).has_value();
}
// ICYCON, ICYCOF: of technology cycles
bool Interpreter::p_cycle_steps(Call& c) {
    return only_in_action(block_.procedures.front().first->name) && p_without_effect(c);
}
bool Interpreter::p_stop_reading_of(Call&) {
    return only_in_action("STOPREOF") && (stop_reading(), true);
}
bool Interpreter::only_in_action(std::string_view name) {
    return in_action_ || fail(Alarm::AddressIllegal, std::string(name));
}

}  // namespace polyturn::channels::sinumerik
