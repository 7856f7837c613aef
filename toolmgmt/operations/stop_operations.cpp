// The log of stops. The supervisor reports them (kernel/supervisor/start/stop_watch.hpp), anybody
// may read them:
//
//   {"do":"stops.note","utc":"2026-01-31T12:00:00.000Z","channel":1,"cause":"hold",
//    "seconds":12.5, ...}   without seconds: it is not over yet
//   {"do":"stops.list","since":"2026-01-31T00:00:00","most":200}   newest first
//
// A table of its own, not values: a stop is never changed and nothing works with it, so it stays
// out of image and history.
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ipc/model/machine/stop_causes.hpp"
#include "toolmgmt/operations/operation.hpp"

namespace polyturn::toolmgmt {
namespace {

Json note(const Json& request, Work& work) {
    Database::Stop stop{read_text(request, "utc"),
                        0,
                        read_text(request, "cause"),
                        read_text(request, "number").substr(0, 12),
                        read_text(request, "detail").substr(0, 400),
                        read_text(request, "program").substr(0, 400),
                        0,
                        std::nan("")};
    std::int64_t channel = 0, line = 0;
    if (!read_whole(request, "channel", channel, work)) return {};
    read_whole(request, "line", line, work, false);
    read_real(request, "seconds", stop.seconds, work, false);
    if (stop.utc.size() < 20) work.fault(Alarm::StoreRequestBad, "utc is missing", 0, "utc");
    if (channel < 1 || channel > static_cast<std::int64_t>(kMaxChannels))
        work.fault(Alarm::StoreRequestBad, "channels are 1 to 16", 0, "channel");
    if (std::find(kStopCauses.begin(), kStopCauses.end(), stop.cause) == kStopCauses.end())
        work.fault(Alarm::StoreRequestBad, "there is no cause " + stop.cause, 0, "cause");
    if (!work.good()) return {};
    stop.channel = static_cast<int>(channel);
    stop.line = static_cast<int>(line);
    if (const auto done = work.disk->note_stop(stop); !done) work.fault(done.diagnosis());
    return Json::object();
}

}  // namespace

Json stop_operation(std::string_view what, const Json& request, Work& work) {
    if (!work.disk) {
        work.fault(Alarm::StoreRequestBad, "this controller keeps no log of stops");
        return Json();
    }
    if (what == "note") return note(request, work);
    if (what != "list") {
        work.fault(Alarm::StoreRequestBad, "stops." + std::string(what));
        return Json();
    }
    std::int64_t most = 200;
    read_whole(request, "most", most, work, false);
    const auto stops =
        work.disk->stops(read_text(request, "since"), std::clamp<std::int64_t>(most, 1, 5000));
    if (!stops) {
        work.fault(stops.diagnosis());
        return Json();
    }
    Json out = Json::array();
    for (const Database::Stop& one : *stops) {
        out.push_back({{"utc", one.utc},
                       {"channel", one.channel},
                       {"cause", one.cause},
                       {"number", one.number},
                       {"detail", one.detail},
                       {"program", one.program},
                       {"line", one.line}});
        if (!std::isnan(one.seconds)) out.back()["seconds"] = one.seconds;
    }
    return {{"stops", std::move(out)}};
}

}  // namespace polyturn::toolmgmt
