// The alarms of all days in the store's file.
#include "toolmgmt/database_parts.hpp"
#include "toolmgmt/statement.hpp"

namespace polyturn::toolmgmt {

Result<void> Database::note_alarms(const std::vector<AlarmEvent>& alarms) {
    Transaction transaction(parts_->db);
    if (!transaction.begun()) return parts_->fault(Alarm::StoreWrite);
    {
        Statement row(parts_->db, "INSERT INTO alarms(utc, event) VALUES(?, ?)");
        for (const AlarmEvent& one : alarms)
            if (!row.bind(1, std::string_view(one.utc)).bind(2, std::string_view(one.event)).run())
                return parts_->fault(Alarm::StoreWrite);
    }
    if (!run(parts_->db, "DELETE FROM alarms WHERE id <= (SELECT max(id) FROM alarms) - 100000"))
        return parts_->fault(Alarm::StoreWrite);
    return parts_->seal(transaction);
}

Result<std::vector<Database::AlarmEvent>> Database::alarms(std::string_view before_utc,
                                                           std::int64_t before_id,
                                                           std::int64_t most) {
    Statement rows(
        parts_->db,
        "SELECT id, utc, event FROM alarms WHERE (?1 = '' OR utc < ?1) AND (?2 <= 0 OR id < "
        "?2) ORDER BY id DESC LIMIT ?3");
    rows.bind(1, before_utc).bind(2, before_id).bind(3, most);
    std::vector<AlarmEvent> out;
    while (rows.row()) out.push_back({rows.whole(0), rows.text(1), rows.text(2)});
    if (!rows.done()) return parts_->open_fault();
    return out;
}

}  // namespace polyturn::toolmgmt
