#include "toolmgmt/operations/operation.hpp"

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "ipc/diagnosis/tongue.hpp"

namespace polyturn::toolmgmt {
namespace {

struct Row {
    const char* what;             // "tools.set", or "tools." for the rest of its family
    UserLevel least;
    Json (*act)(std::string_view, const Json&, Work&);
};
// The first row that fits says who may.
constexpr Row kRows[] = {
    {"tools.list", UserLevel::None, tool_operation},       {"tools.show", UserLevel::None, tool_operation},    {"tools.places", UserLevel::None, tool_operation},
    {"tools.answers", UserLevel::None, tool_operation},    {"tools.fields", UserLevel::None, tool_operation},
    {"tools.export", UserLevel::None, table_operation},    {"tools.import", UserLevel::Setter, table_operation},
    {"tools.load", UserLevel::Operator, tool_operation},   {"tools.unload", UserLevel::Operator, tool_operation}, {"tools.move", UserLevel::Operator, tool_operation},
    {"tools.", UserLevel::Setter, tool_operation},         {"life.report", UserLevel::None, life_operation},   {"life.reset", UserLevel::Operator, life_operation},
    {"life.", UserLevel::Setter, life_operation},          {"offsets.list", UserLevel::None, offset_operation}, {"offsets.history", UserLevel::None, offset_operation},
    {"offsets.", UserLevel::Operator, offset_operation},   {"history.", UserLevel::None, offset_operation},    {"parts.list", UserLevel::None, part_operation},
    {"zeros.list", UserLevel::None, zero_operation},        {"zeros.", UserLevel::Setter, zero_operation},
    {"parts.measure", UserLevel::Operator, part_operation}, {"parts.accept", UserLevel::Operator, part_operation}, {"parts.", UserLevel::Setter, part_operation},
    {"users.login", UserLevel::None, user_operation},      {"users.password", UserLevel::None, user_operation}, {"users.", UserLevel::Maker, user_operation},
    {"pallets.list", UserLevel::None, pallet_operation},   {"pallets.", UserLevel::Operator, pallet_operation}, {"backup.", UserLevel::Setter, backup_operation},
    {"compensation.", UserLevel::Maker, compensation_operation},
    {"restore.", UserLevel::Maker, backup_operation},      {"stops.", UserLevel::None, stop_operation},          {"alarms.", UserLevel::None, alarm_operation},
};

constexpr const char* kLevelNames[] = {"none", "operator", "setter", "maker"};

}  // namespace

Json run_operation(const Json& request, Work& work) {
    const std::string what = read_text(request, "do");
    for (const Row& row : kRows) {
        const std::string_view name = row.what;
        if (name.back() == '.' ? what.rfind(name, 0) != 0 : what != name) continue;
        if (work.caller.level < row.least) {
            work.fault(Alarm::LevelTooLow, what + " (" + kLevelNames[static_cast<std::size_t>(row.least)] + ")");
            return Json::object();
        }
        return row.act(std::string_view(what).substr(what.find('.') + 1), request, work);
    }
    work.fault(Alarm::StoreRequestBad, what.empty() ? "no operation" : what.substr(0, 60));
    return Json::object();
}

std::string answer_text(const Json& answer, const std::vector<Fault>& faults) {
    Json out = answer.is_object() ? answer : Json::object();
    out["ok"] = faults.empty();
    if (!faults.empty()) {
        out = {{"ok", false}};
        Json list = Json::array();
        for (const Fault& fault : faults) {
            Json one;
            one["number"] = std::string(alarm_number(fault.diagnosis.alarm, Dialect::Polyturn));
            one["text"] = text_in(fault.diagnosis, tongue_now());
            one["remedy"] = std::string(alarm_text(fault.diagnosis.alarm, tongue_now()).remedy);
            if (fault.row > 0) one["row"] = fault.row;
            if (!fault.column.empty()) one["column"] = fault.column;
            list.push_back(std::move(one));
        }
        out["number"] = list[0]["number"], out["text"] = list[0]["text"], out["remedy"] = list[0]["remedy"];
        out["faults"] = std::move(list);
    }
    return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string read_text(const Json& request, const char* key) {
    const auto at = request.find(key);
    if (at == request.end()) return {};
    return at->is_string() ? at->get<std::string>() : at->is_number() || at->is_boolean() ? at->dump() : std::string();
}

bool read_real(const Json& request, const char* key, double& out, Work& work, bool needed) {
    const auto at = request.find(key);
    if (at != request.end() && at->is_number()) return out = at->get<double>(), true;
    if (at != request.end() && at->is_string()) {
        const std::string text = at->get<std::string>();
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        if (!text.empty() && *end == 0 && std::isfinite(value)) return out = value, true;
        work.fault(Alarm::StoreRequestBad, std::string(key) + "=" + text + ": not a number", 0, key);
        return false;
    }
    if (needed) work.fault(Alarm::StoreRequestBad, std::string(key) + " is missing", 0, key);
    return false;
}

bool read_whole(const Json& request, const char* key, std::int64_t& out, Work& work, bool needed) {
    double value = 0;
    if (!read_real(request, key, value, work, needed)) return false;
    if (value != std::trunc(value) || std::abs(value) > 1e9) {
        work.fault(Alarm::StoreRequestBad, std::string(key) + ": not a whole number", 0, key);
        return false;
    }
    out = static_cast<std::int64_t>(value);
    return true;
}

}  // namespace polyturn::toolmgmt
