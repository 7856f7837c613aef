// The log of stops in the store's file.
#include "toolmgmt/database_parts.hpp"
#include "toolmgmt/statement.hpp"

namespace polyturn::toolmgmt {
namespace {

// Some years of a machine that stops every few minutes.
constexpr const char* kPruneStops =
    "DELETE FROM stops WHERE utc < (SELECT utc FROM stops ORDER BY utc DESC LIMIT 1 OFFSET 100000)";

}  // namespace

Result<void> Database::note_stop(const Stop& stop) {
    Transaction transaction(parts_->db);
    if (!transaction.begun()) return parts_->fault(Alarm::StoreWrite);
    {
        Statement row(
            parts_->db,
            "INSERT OR REPLACE INTO stops(utc, channel, cause, number, detail, program, line, "
            "seconds) VALUES(?, ?, ?, ?, ?, ?, ?, ?)");
        row.bind(1, std::string_view(stop.utc))
            .bind(2, std::int64_t{stop.channel})
            .bind(3, std::string_view(stop.cause))
            .bind(4, std::string_view(stop.number));
        row.bind(5, std::string_view(stop.detail))
            .bind(6, std::string_view(stop.program))
            .bind(7, std::int64_t{stop.line})
            .bind(8, stop.seconds);
        if (!row.run()) return parts_->fault(Alarm::StoreWrite);
    }
    if (!run(parts_->db, kPruneStops)) return parts_->fault(Alarm::StoreWrite);
    return parts_->seal(transaction);
}

Result<std::vector<Database::Stop>> Database::stops(std::string_view since, std::int64_t most) {
    Statement rows(
        parts_->db,
        "SELECT utc, channel, cause, number, detail, program, line, seconds FROM stops WHERE "
        "utc >= ? ORDER BY utc DESC, channel LIMIT ?");
    rows.bind(1, since).bind(2, most);
    std::vector<Stop> out;
    while (rows.row())
        out.push_back({rows.text(0), static_cast<int>(rows.whole(1)), rows.text(2), rows.text(3),
                       rows.text(4), rows.text(5), static_cast<int>(rows.whole(6)),
                       rows.number(7)});
    if (!rows.done()) return parts_->open_fault();
    return out;
}

}  // namespace polyturn::toolmgmt
