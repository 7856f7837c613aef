// The alarms of all days. The supervisor reports them, anybody may read them:
//
//   {"do":"alarms.note","events":[{"ev":"alarm","utc":"2026-01-31T12:00:00Z", ...}]}
//   {"do":"alarms.list","before_utc":"2026-01-31T00:00:00Z","most":200}   newest first
//
// before_id instead of before_utc: what is older than that row.
// As the log of stops (stop_operations.cpp) a table of its own, not values.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "toolmgmt/operations/operation.hpp"

namespace polyturn::toolmgmt {
namespace {

constexpr std::size_t kLongestEvent = 4000;

Json note_alarms(const Json& request, Work& work) {
    std::vector<Database::AlarmEvent> alarms;
    if (const auto events = request.find("events"); events != request.end() && events->is_array())
        for (const Json& one : *events)
            if (std::string text = one.dump(-1, ' ', false, Json::error_handler_t::replace);
                one.is_object() && text.size() <= kLongestEvent)
                alarms.push_back({0, read_text(one, "utc"), std::move(text)});
    if (alarms.empty()) {
        work.fault(Alarm::StoreRequestBad, "events is missing", 0, "events");
        return Json();
    }
    if (const auto done = work.disk->note_alarms(alarms); !done) work.fault(done.diagnosis());
    return Json::object();
}

}  // namespace

Json alarm_operation(std::string_view what, const Json& request, Work& work) {
    if (!work.disk) {
        work.fault(Alarm::StoreRequestBad, "this controller keeps no history");
        return Json();
    }
    if (what == "note") return note_alarms(request, work);
    if (what != "list") {
        work.fault(Alarm::StoreRequestBad, "alarms." + std::string(what));
        return Json();
    }
    std::int64_t most = 200, before = 0;
    read_whole(request, "most", most, work, false);
    read_whole(request, "before_id", before, work, false);
    const auto alarms = work.disk->alarms(read_text(request, "before_utc"), before,
                                          std::clamp<std::int64_t>(most, 1, 1000));
    if (!alarms) {
        work.fault(alarms.diagnosis());
        return Json();
    }
    Json out = Json::array();
    for (const Database::AlarmEvent& one : *alarms) {
        Json event = Json::parse(one.event, nullptr, false);
        if (!event.is_object()) continue;
        event["id"] = one.id;
        out.push_back(std::move(event));
    }
    return {{"alarms", std::move(out)}};
}

}  // namespace polyturn::toolmgmt
