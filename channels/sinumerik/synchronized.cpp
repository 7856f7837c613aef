// Synchronized actions: ID= IDS= WHEN WHENEVER FROM EVERY DO; CANCEL LOCK UNLOCK RESET STOPREOF (sinumerik_part3 1.4, 7.12, 8).
#include "channels/sinumerik/synchronized.hpp"

#include <algorithm>
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

using When = SynchronizedAction::When;
constexpr double kHighestId = 255;

struct Keyword {
    std::string_view name;
    When when;
};
constexpr Keyword kKeywords[] = {{"DO", When::Always}, {"WHEN", When::Once}, {"WHENEVER", When::Whenever}, {"FROM", When::From}, {"EVERY", When::Edge}};

const Keyword* keyword(std::string_view name) {
    for (const Keyword& row : kKeywords)
        if (row.name == name) return &row;
    return nullptr;
}

// What may stand behind DO (1.4) and acts there.
bool allowed(std::string_view address) {
    static constexpr std::string_view kAddresses[] = {"M", "S", "H", "SPOS", "POS", "FA", "OVRA", "ACC"};
    return std::find(std::begin(kAddresses), std::end(kAddresses), address) != std::end(kAddresses);
}

bool allowed_call(std::string_view procedure) {
    static constexpr std::string_view kProcedures[] = {"LOCK", "UNLOCK", "RESET", "STOPREOF", "SETM", "CLEARM", "SETAL", "TRAILON", "TRAILOF", "SYNFCT"};
    return std::find(std::begin(kProcedures), std::end(kProcedures), procedure) != std::end(kProcedures);
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

// A block that only tells what shall be done: it moves nothing and outputs nothing.
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
        if (!id.is_number() || !(id.number >= 1 && id.number <= kHighestId) || id.number != std::floor(id.number)) return fail_at(Alarm::ValueOutOfRange, from, 1, name, id.number);
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
    for (Cursor part = cursor_; !part.at_end();) {   // what cannot be done is refused here, not when its moment has come
        const std::string_view word = part.name_ahead();
        const Symbol symbol = word.size() > 1 ? find_symbol(upper(word)) : Symbol{};
        const bool unknown = symbol.kind == Symbol::Kind::Reserved || (symbol.kind == Symbol::Kind::Command && !symbol.command().act);
        const bool procedure = symbol.kind == Symbol::Kind::Command && !symbol.command().function && !allowed_call(symbol.command().name);
        const bool address = symbol.kind == Symbol::Kind::Address && !allowed(symbol.address().name) && symbol.address().name != "AC" && symbol.address().name != "IC";
        if (unknown && word != "AC" && word != "IC" && word != "TRUE" && word != "FALSE") return fail_at(Alarm::NotBuilt, part.at(), word.size(), "DO " + std::string(word));
        if (procedure || address || symbol.kind == Symbol::Kind::G) return fail_at(Alarm::NotBuilt, part.at(), word.size(), "DO " + std::string(word));
        part.advance(std::max<std::size_t>(word.size(), 1));
    }
    action.text = line_;
    action.line = core_.at.line;
    undo([this, before = actions_] { actions_ = before; });
    if (action.id) std::erase_if(actions_, [&](const SynchronizedAction& one) { return one.id == action.id; });   // a new one takes its place
    actions_.push_back(std::move(action));
    return true;
}

bool Interpreter::read_action(const SynchronizedAction& action) {
    block_.clear();
    statement_ = nullptr;
    cursor_ = Cursor(action.text);
    cursor_.advance(action.action_at);
    if (!parse_words()) return false;
    if (statement_) return fail_at(Alarm::NotBuilt, cursor_.at(), 1, "DO " + std::string(statement_->name));
    if (!block_.codes.empty()) return fail(Alarm::NotBuilt, "DO " + std::string(block_.codes.front()->name));
    if (block_.program.wanted) return fail(Alarm::NotBuilt, "DO " + block_.program.name);
    for (const Word& word : block_.words) {
        const std::string_view name = word.address->name;
        if (name == "axis") return fail_word(Alarm::AddressIllegal, word, axis_name(word.axis));   // an axis moves by POS
        if (!allowed(name)) return fail_word(Alarm::NotBuilt, word, "DO " + std::string(name));
        if (name == "M" && (word.number() == 2 || word.number() == 17 || word.number() == 30)) return fail_word(Alarm::NotBuilt, word, "DO M" + to_text(word.value));
    }
    return true;
}

bool Interpreter::do_action() {
    for (const Word& word : block_.words)
        if (word.address->use == Address::Use::Setting && !(this->*word.address->act)(word)) return false;
    if (!functions_before()) return false;
    std::vector<std::pair<const Command*, Call>> procedures = std::move(block_.procedures);
    for (auto& one : procedures) {
        block_.procedures.clear();
        block_.procedures.push_back(one);
        if (!(this->*one.first->act)(one.second)) return false;
    }
    AxisSet nobody_waits = 0;
    return start_positioning(nobody_waits) && functions_after();
}

// Before an output block acts, its words are read: every condition is looked at, then all that is due is read and done. A
// condition that needs a live value brings the block behind a barrier; nothing has happened until then.
bool Interpreter::synchronized_actions() {
    if (actions_.empty() || (block_.words.empty() && block_.codes.empty())) return true;
    Block output = std::move(block_);
    const Cursor cursor = cursor_;
    const Statement* const statement = statement_;
    std::vector<SynchronizedAction> next = actions_;
    std::vector<std::pair<const SynchronizedAction*, Block>> due;
    const auto said_by = [this](const SynchronizedAction& action) {   // the alarm names the line of the action
        if (needs_barrier_) return false;
        core_.at.line = action.line;
        core_.at.block = -1;
        line_ = action.text;
        return false;
    };
    in_action_ = true;
    for (SynchronizedAction& action : next) {
        if (action.locked) continue;
        bool holds = true;
        cursor_ = Cursor(action.text);
        cursor_.advance(action.condition_at);
        if (action.when != When::Always && !condition(holds)) return in_action_ = false, said_by(action);
        if (action.when != When::Always && upper(cursor_.name_ahead()) != "DO") return in_action_ = false, syntax(cursor_.at(), "DO"), said_by(action);
        if (!action.is_due(holds)) continue;
        if (!read_action(action)) return in_action_ = false, said_by(action);
        due.emplace_back(&action, std::move(block_));
    }
    undo([this, before = actions_] { actions_ = before; });
    actions_ = next;
    reading_ = false;
    for (auto& [action, block] : due) {
        block_ = std::move(block);
        if (!do_action()) return in_action_ = false, said_by(*action);
    }
    in_action_ = false;
    reading_ = true;
    std::erase_if(actions_, [](const SynchronizedAction& one) { return one.is_over(); });
    block_ = std::move(output);
    cursor_ = cursor;
    statement_ = statement;
    return true;
}

bool Interpreter::each_action(Call& c, const std::function<void(SynchronizedAction&)>& change) {
    undo([this, before = actions_] { actions_ = before; });
    for (const Argument& argument : c.arguments) {
        if (!argument.given || !(argument.value.number >= 1 && argument.value.number <= kHighestId)) return fail(Alarm::ValueOutOfRange, "ID", argument.value.number);
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

bool Interpreter::p_lock(Call& c) { return only_in_action("LOCK") && each_action(c, [](SynchronizedAction& one) { one.locked = true; }); }
bool Interpreter::p_unlock(Call& c) { return only_in_action("UNLOCK") && each_action(c, [](SynchronizedAction& one) { one.locked = false; }); }
bool Interpreter::p_action_reset(Call& c) { return only_in_action("RESET") && each_action(c, [](SynchronizedAction&) {}); }   // of technology cycles
bool Interpreter::p_stop_reading_of(Call&) { return only_in_action("STOPREOF") && (stop_reading(), true); }
bool Interpreter::only_in_action(std::string_view name) { return in_action_ || fail(Alarm::AddressIllegal, std::string(name)); }

}  // namespace polyturn::channels::sinumerik
