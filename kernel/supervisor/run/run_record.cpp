#include "kernel/supervisor/run/run_record.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "kernel/supervisor/base/json_fields.hpp"

namespace polyturn::supervisor {

using Json = nlohmann::json;

namespace {

std::optional<double> number_at(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number() ? std::optional<double>(found->get<double>())
                                                       : std::nullopt;
}

std::optional<PlanePoint> point_at(const Json& event, const char* key, double x_scale) {
    const auto found = event.find(key);
    if (found == event.end() || !found->is_object()) return std::nullopt;
    const auto x = number_at(*found, "X"), z = number_at(*found, "Z");
    if (!x || !z) return std::nullopt;
    return PlanePoint{*x * x_scale, *z};
}

}  // namespace

void RunRecord::add(std::string_view event_text, double t_s, double end_s, bool diameter) {
    const Json event = Json::parse(event_text, nullptr, false);
    if (!event.is_object()) return;
    const std::string kind = text_field(event, "ev");
    Activity activity;
    if (kind == "move") {
        const std::string how = text_field(event, "kind");
        activity.doing = how == "rapid" || how == "reference" ? Doing::Rapid
                         : how == "thread"                    ? Doing::Thread
                                                              : Doing::Cut;
        activity.clockwise = how == "cw";
        activity.to = point_at(event, "pos", diameter ? 0.5 : 1.0);
        activity.centre = point_at(event, "centre", 1.0);  // X of a centre is a radius already
        if (const auto tool = event.find("tool"); tool != event.end() && tool->is_object()) {
            if (const auto number = number_at(*tool, "number"))
                activity.tool = fmt::format("T{:g}", *number);
            if (const std::string name = text_field(*tool, "name"); !name.empty())
                activity.tool += (activity.tool.empty() ? "" : " ") + name;
        }
    } else if (kind == "wait") {
        activity.doing = Doing::Wait;
        if (const auto code = event.find("code"); code != event.end())
            activity.code =
                code->is_string() ? code->get<std::string>() : "M" + word_field(event, "code");
        if (const auto set = event.find("channels"); set != event.end() && set->is_array())
            for (const auto& one : *set)
                if (one.is_number_integer() && one.get<int>() >= 1 && one.get<int>() <= 32)
                    activity.partners |= 1u << (one.get<int>() - 1);
    } else if (kind == "dwell") {
        activity.doing = Doing::Dwell;
    } else if (kind == "aux") {
        activity.doing = Doing::Aux;
        activity.code = text_field(event, "code");
    } else {
        return;
    }
    activity.channel = count_field(event, "ch");
    activity.file = text_field(event, "file");
    activity.line = count_field(event, "line");
    activity.t_s = t_s;
    activity.end_s = end_s >= t_s ? end_s : t_s;
    activities.push_back(std::move(activity));
}

}  // namespace polyturn::supervisor
