#include "toolmgmt/database.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <utility>

#include "ipc/model/machine/shortest_text.hpp"
#include "ipc/params/param_file.hpp"
#include "toolmgmt/database_parts.hpp"
#include "toolmgmt/schema.hpp"
#include "toolmgmt/statement.hpp"

namespace polyturn::toolmgmt {

Database::Database(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Database::Database(Database&&) noexcept = default;
Database& Database::operator=(Database&&) noexcept = default;
Database::~Database() = default;

namespace {

struct TableOf {
    Kind kind;
    const char* name;
};
constexpr TableOf kTables[] = {
    {Kind::Offset, "offsets"},   {Kind::WorkZero, "zeros"},     {Kind::Variable, "variables"},
    {Kind::Counter, "counters"}, {Kind::Position, "positions"},
};

// Everything that acts. The history is checked when it is read: a million rows of it must not
// delay the start.
constexpr const char* kChecked[] = {"sqlite_schema", "migrations", "parameters", "offsets",
                                    "zeros",         "variables",  "counters",   "positions",
                                    "records",       "promise"};

}  // namespace

bool intact(sqlite3* db, int version, std::string& what) {
    for (const char* table : kChecked) {
        if ((version < 2 && std::string_view(table) == "records") ||
            (version < kAcknowledges && std::string_view(table) == "promise"))
            continue;
        Statement check(db, ("PRAGMA quick_check('" + std::string(table) + "')").c_str());
        if (!check.row()) return false;
        what = check.text(0);
        if (what != "ok") return false;
    }
    return true;
}

namespace {

struct RecordKindName {
    Kind kind;
    const char* name;
};
constexpr RecordKindName kRecordKinds[] = {{Kind::Tool, "tool"},     {Kind::Edge, "edge"},
                                           {Kind::Place, "place"},   {Kind::Work, "work"},
                                           {Kind::User, "user"},     {Kind::Dimension, "dimension"},
                                           {Kind::Pallet, "pallet"}, {Kind::Setting, "setting"}};
static_assert(static_cast<std::size_t>(Kind::Setting) - static_cast<std::size_t>(Kind::Tool) + 1 ==
              std::size(kRecordKinds));

const char* name_of(Kind kind) {
    return kRecordKinds[static_cast<std::size_t>(kind) - static_cast<std::size_t>(Kind::Tool)].name;
}

std::string shown(double number, const std::string& text, bool is_text) {
    if (is_text) return text;
    return std::isnan(number) ? std::string("empty") : shortest_text(number);
}

// A stored value must still be within the limits of its row: another version may have narrowed
// them.
bool parameter_fits(const std::string& name, int instance, int element, double number,
                    const std::string& text, bool is_text) {
    const params::Row* row = params::find(name);
    if (!row || instance < 1 || static_cast<unsigned>(instance) > params::instances(row->scope) ||
        element < 0 || element >= row->array)
        return false;
    if (is_text != (row->type == params::Type::Text)) return false;
    if (is_text) return text.size() <= params::kTextCapacity;
    if (!(number >= row->min && number <= row->max)) return false;
    return row->type == params::Type::Real || number == std::trunc(number);
}

// What programs count in variables changes many times a second and is of no use to anybody a year
// later.
bool worth_history(const Key& key, std::string_view who) {
    if (key.kind == Kind::Setting || key.kind == Kind::Work ||
        (key.kind == Kind::User && key.name == "hash"))
        return false;
    if (who != "program") return true;
    return key.kind <= Kind::WorkZero || key.kind == Kind::Edge ||
           (key.kind == Kind::Tool && key.name != "counter");
}

// False: the file cannot be read.
bool read_records(sqlite3* db, StoreValues& values, bool users,
                  const std::function<void(const std::string&)>& left_out) {
    for (const auto& [kind, name] : kRecordKinds) {
        if (kind == Kind::User && !users) continue;
        Statement rows(db, "SELECT scope, number, field, value, text FROM records WHERE kind = ?");
        rows.bind(1, std::string_view(name));
        while (rows.row()) {
            Key key{kind, static_cast<std::int32_t>(rows.whole(0)),
                    static_cast<std::int32_t>(rows.whole(1)), 0, rows.text(2)};
            if (kind == Kind::Edge) key.field = std::atoi(std::exchange(key.name, {}).c_str());
            const bool is_text = !rows.null(4);
            if (!write_value(values, key, rows.number(3), rows.text(4), is_text))
                left_out(describe(key) + "=" + shown(rows.number(3), rows.text(4), is_text));
        }
        if (!rows.done()) return false;
    }
    return true;
}

// A value that is gone leaves no row behind.
bool write_record(sqlite3* db, const Change& change) {
    const Key& key = change.key;
    const bool gone = change.is_text ? change.text_after.empty() : std::isnan(change.after);
    Statement row(
        db, gone ? "DELETE FROM records WHERE kind = ? AND scope = ? AND number = ? AND field = ?"
                 : "INSERT OR REPLACE INTO records(kind, scope, number, field, value, text) "
                   "VALUES(?, ?, ?, ?, ?, ?)");
    row.bind(1, std::string_view(name_of(key.kind)))
        .bind(2, std::int64_t{key.scope})
        .bind(3, std::int64_t{key.number});
    row.bind(4, key.kind == Kind::Edge ? std::to_string(key.field) : key.name);
    if (!gone && change.is_text)
        row.bind_null(5).bind(6, change.text_after);
    else if (!gone)
        row.bind(5, change.after).bind_null(6);
    return row.run();
}

}  // namespace

Result<void> Database::read_into(StoreValues& values, std::vector<Diagnosis>& warnings) {
    const auto left_out = [&](const std::string& what) {
        warnings.push_back({Alarm::StoreRowIgnored, {parts_->path, 0, 0, 0}, {}, what});
    };
    Statement parameters(parts_->db,
                         "SELECT name, instance, element, number, text FROM parameters");
    while (parameters.row()) {
        const Key key{Kind::Parameter, static_cast<std::int32_t>(parameters.whole(1)),
                      static_cast<std::int32_t>(parameters.whole(2)), 0, parameters.text(0)};
        const bool is_text = !parameters.null(4);
        const double number = parameters.number(3);
        const std::string text = parameters.text(4);
        if (!parameter_fits(key.name, key.scope, key.number, number, text, is_text) ||
            !write_value(values, key, number, text, is_text))
            left_out(describe(key) + "=" + shown(number, text, is_text));
    }
    if (!parameters.done()) return parts_->open_fault();
    for (const TableOf& table : kTables) {
        Statement rows(
            parts_->db,
            (std::string("SELECT channel, number, field, value FROM ") + table.name).c_str());
        while (rows.row()) {
            const Key key{table.kind,
                          static_cast<std::int32_t>(rows.whole(0)),
                          static_cast<std::int32_t>(rows.whole(1)),
                          static_cast<std::int32_t>(rows.whole(2)),
                          {}};
            const double value = rows.number(3);
            const bool may_be_empty = table.kind == Kind::Variable || table.kind == Kind::Position;
            if (std::isinf(value) || (std::isnan(value) && !may_be_empty) ||
                !write_value(values, key, value, {}, false))
                left_out(describe(key));
        }
        if (!rows.done()) return parts_->open_fault();
    }
    return read_records(parts_->db, values, !parts_->condition.locked, left_out)
               ? Result<void>()
               : parts_->open_fault();
}

Result<void> Database::commit(const std::vector<Change>& changes, std::string_view who) {
    sqlite3* db = parts_->db;
    Transaction transaction(db);
    if (!transaction.begun()) return parts_->fault(Alarm::StoreWrite);
    Statement parameter(
        db,
        "INSERT OR REPLACE INTO parameters(name, instance, element, number, text) VALUES(?, ?, ?, "
        "?, ?)");
    Statement history(db, "INSERT INTO history(utc, who, what, old, new) VALUES(?, ?, ?, ?, ?)");
    const std::string utc = utc_now();
    for (const Change& change : changes) {
        const Key& key = change.key;
        bool good = false;
        if (key.kind == Kind::Parameter) {
            parameter.bind(1, key.name)
                .bind(2, std::int64_t{key.scope})
                .bind(3, std::int64_t{key.number});
            if (change.is_text)
                parameter.bind_null(4).bind(5, change.text_after);
            else
                parameter.bind(4, change.after).bind_null(5);
            good = parameter.run();
        } else if (key.kind > Kind::Position) {
            good = write_record(db, change);
        } else {
            const char* table =
                kTables[static_cast<std::size_t>(key.kind) - static_cast<std::size_t>(Kind::Offset)]
                    .name;
            Statement row(db, (std::string("INSERT OR REPLACE INTO ") + table +
                               "(channel, number, field, value) VALUES(?, ?, ?, ?)")
                                  .c_str());
            good = row.bind(1, std::int64_t{key.scope})
                       .bind(2, std::int64_t{key.number})
                       .bind(3, std::int64_t{key.field})
                       .bind(4, change.after)
                       .run();
        }
        if (good && worth_history(key, who))
            good = history.bind(1, utc)
                       .bind(2, who)
                       .bind(3, describe(key))
                       .bind(4, shown(change.before, change.text_before, change.is_text))
                       .bind(5, shown(change.after, change.text_after, change.is_text))
                       .run();
        if (!good) return parts_->fault(Alarm::StoreWrite);
    }
    return parts_->seal(transaction,
                        std::any_of(changes.begin(), changes.end(), [](const Change& change) {
                            return change.key.kind == Kind::User;
                        }));
}

// Each condition as its index in schema.cpp has it: a value, the parameters and what was entered
// are found among a million rows without looking at the others. For a part of a text, the newest
// rows are read one by one.
std::string Database::history_query(const HistoryOf& of) {
    std::string sql = "SELECT id, utc, who, what, old, new FROM history";
    // the planner would rather look for all that begins with "tool", and sort it
    if (of.kind == HistoryOf::Kind::EnteredEdges) sql += " INDEXED BY history_edges";
    switch (of.kind) {
        case HistoryOf::Kind::All:
            break;
        case HistoryOf::Kind::Value:
            sql += " WHERE what = ?1";
            break;
        // N1600 L1, F3401, MD20150, PT_HORIZON, SD43300, MEFI...
        case HistoryOf::Kind::Parameters:
            sql += " WHERE what GLOB '[NFMPS]*'";
            break;
        case HistoryOf::Kind::EnteredOffsets:
            sql +=
                " WHERE instr(what, ' offset ') > 0 AND who NOT IN ('program', 'setup') AND "
                "instr(what, ?1) > 0";
            break;
        case HistoryOf::Kind::EnteredEdges:
            sql +=
                " WHERE what GLOB 'tool [0-9]* D[0-9]* DP[0-9]*' AND who NOT IN ('program', "
                "'setup') AND instr(what, ?1) = 1";
            break;
    }
    if (!of.before_utc.empty())
        sql += std::string(of.kind == HistoryOf::Kind::All ? " WHERE" : " AND") +
               " (utc, id) < (?2, ?3)";
    return sql + " ORDER BY utc DESC, id DESC LIMIT ?4";
}

Result<Database::History> Database::history(const HistoryOf& of) {
    const bool about_text = of.kind == HistoryOf::Kind::All && !of.about.empty(),
               by_text = about_text || !of.who.empty();
    const std::int64_t look = by_text ? kHistoryLook : of.most;
    Statement rows(parts_->db, history_query(of).c_str());
    rows.bind(1, std::string_view(of.about))
        .bind(2, std::string_view(of.before_utc))
        .bind(3, of.before_id)
        .bind(4, look);
    History out;
    for (std::int64_t looked = 1; rows.row(); ++looked) {
        if ((!about_text || rows.text(3).find(of.about) != std::string::npos) &&
            (of.who.empty() || rows.text(2).find(of.who) != std::string::npos))
            out.entries.push_back({rows.whole(0), rows.text(1), rows.text(2), rows.text(3),
                                   rows.text(4), rows.text(5)});
        if (static_cast<std::int64_t>(out.entries.size()) == of.most) return out;
        if (by_text && looked == look) out.more = {rows.text(1), rows.whole(0)};
    }
    if (!rows.done()) return parts_->open_fault();
    return out;
}

const std::string& Database::path() const { return parts_->path; }

Result<std::vector<std::string>> Database::history(int most) {
    Statement rows(parts_->db,
                   "SELECT utc, who, what, old, new FROM history ORDER BY id DESC LIMIT ?");
    rows.bind(1, std::int64_t{most});
    std::vector<std::string> lines;
    while (rows.row())
        lines.push_back(rows.text(0) + " " + rows.text(1) + " " + rows.text(2) + ": " +
                        rows.text(3) + " -> " + rows.text(4));
    if (!rows.done()) return parts_->open_fault();
    return lines;
}

}  // namespace polyturn::toolmgmt
