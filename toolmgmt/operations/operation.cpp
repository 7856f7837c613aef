#include "toolmgmt/operations/operation.hpp"

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "ipc/diagnosis/display_language.hpp"
#include "ipc/model/machine/shortest_text.hpp"

namespace polyturn::toolmgmt {
namespace {

struct Row {
    const char* what;  // "tools.set", or "tools." for the rest of its family
    UserLevel least;
    Json (*act)(std::string_view, const Json&, Work&);
};
// The first row that fits says who may.
constexpr Row kRows[] = {
    {"tools.list", UserLevel::None, tool_operation},
    {"tools.show", UserLevel::None, tool_operation},
    {"tools.places", UserLevel::None, tool_operation},
    {"tools.answers", UserLevel::None, tool_operation},
    {"tools.fields", UserLevel::None, tool_operation},
    {"tools.export", UserLevel::None, table_operation},
    {"tools.import", UserLevel::Setter, table_operation},
    {"tools.load", UserLevel::Operator, tool_operation},
    {"tools.unload", UserLevel::Operator, tool_operation},
    {"tools.move", UserLevel::Operator, tool_operation},
    {"tools.", UserLevel::Setter, tool_operation},
    {"life.report", UserLevel::None, life_operation},
    {"life.reset", UserLevel::Operator, life_operation},
    {"life.", UserLevel::Setter, life_operation},
    {"offsets.list", UserLevel::None, offset_operation},
    {"offsets.history", UserLevel::None, offset_operation},
    {"offsets.", UserLevel::Operator, offset_operation},
    {"history.", UserLevel::None, offset_operation},
    {"parts.list", UserLevel::None, part_operation},
    {"zeros.list", UserLevel::None, zero_operation},
    {"zeros.", UserLevel::Setter, zero_operation},
    {"parts.measure", UserLevel::Operator, part_operation},
    {"parts.accept", UserLevel::Operator, part_operation},
    {"parts.", UserLevel::Setter, part_operation},
    {"users.login", UserLevel::None, user_operation},
    {"users.password", UserLevel::None, user_operation},
    {"users.", UserLevel::Maker, user_operation},
    {"parameters.", UserLevel::None, parameter_operation},
    {"pallets.list", UserLevel::None, pallet_operation},
    {"pallets.", UserLevel::Operator, pallet_operation},
    {"backup.", UserLevel::Setter, backup_operation},
    {"compensation.", UserLevel::Maker, compensation_operation},
    {"restore.", UserLevel::Maker, backup_operation},
    {"store.state", UserLevel::None, store_operation},
    {"store.", UserLevel::Maker, store_operation},
    {"stops.", UserLevel::None, stop_operation},
    {"alarms.", UserLevel::None, alarm_operation},
};

constexpr const char* kLevelNames[] = {"none", "operator", "setter", "maker"};

}  // namespace

Json run_operation(const Json& request, Work& work) {
    const std::string what = read_text(request, "do");
    for (const Row& row : kRows) {
        const std::string_view name = row.what;
        if (name.back() == '.' ? what.rfind(name, 0) != 0 : what != name) continue;
        if (work.caller.level < row.least) {
            work.fault(Alarm::LevelTooLow,
                       what + " (" + kLevelNames[static_cast<std::size_t>(row.least)] + ")");
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
            one["text"] = text_in(fault.diagnosis, display_language_now());
            one["remedy"] =
                std::string(alarm_text(fault.diagnosis.alarm, display_language_now()).remedy);
            if (fault.row > 0) one["row"] = fault.row;
            if (!fault.column.empty()) one["column"] = fault.column;
            list.push_back(std::move(one));
        }
        out["number"] = list[0]["number"];
        out["text"] = list[0]["text"];
        out["remedy"] = list[0]["remedy"];
        out["faults"] = std::move(list);
    }
    return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string read_text(const Json& request, const char* key) {
    const auto at = request.find(key);
    if (at == request.end()) return {};
    return at->is_string()                       ? at->get<std::string>()
           : at->is_number() || at->is_boolean() ? at->dump()
                                                 : std::string();
}

bool read_real(const Json& request, const char* key, double& out, Work& work, bool needed) {
    const auto at = request.find(key);
    if (at == request.end()) {
        if (needed) work.fault(Alarm::StoreRequestBad, std::string(key) + " is missing", 0, key);
        return false;
    }
    if (at->is_number()) {
        const double value = at->get<double>();
        if (std::isfinite(value)) {
            out = value;
            return true;
        }
    }
    const std::string text = at->is_string() ? at->get<std::string>() : std::string();
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (!text.empty() && end == text.c_str() + text.size() && std::isfinite(value)) {
        out = value;
        return true;
    }
    work.fault(Alarm::StoreRequestBad,
               std::string(key) + "=" +
                   (at->is_string() ? text.substr(0, 60) : std::string(at->type_name())) +
                   ": not a number",
               0, key);
    return false;
}

bool as_expected(const Json& request, double present, const std::string& what, Work& work) {
    double expected = 0;
    if (!request.contains("expected")) return true;
    if (!read_real(request, "expected", expected, work)) return false;
    if (std::abs(expected - present) <= 5e-7) return true;
    work.fault(Alarm::StoreRequestBad,
               what + " is " + shortest_text(present) + " by now, not " + shortest_text(expected),
               0, "expected");
    return false;
}

bool read_entry(const Json& request, double present, const std::string& what, double& out,
                Work& work) {
    if (!as_expected(request, present, what, work)) return false;
    const bool delta = request.contains("delta");
    if (delta && request.contains("value")) {
        work.fault(Alarm::RequestBad, "value or delta, not both", 0, "delta");
        return false;
    }
    const bool added = read_flag(request, "incremental", work) || delta;
    if (!work.good() || !read_real(request, delta ? "delta" : "value", out, work)) return false;
    if (added) out = std::round((present + out) * 1e9) / 1e9;
    return true;
}

bool read_flag(const Json& request, const char* key, Work& work) {
    const auto at = request.find(key);
    if (at == request.end()) return false;
    if (at->is_boolean()) return at->get<bool>();
    work.fault(Alarm::RequestBad, std::string(key) + ": true or false is wanted", 0, key);
    return false;
}

Json read_object(const Json& request, const char* key, Work& work) {
    const auto at = request.find(key);
    if (at == request.end()) return Json::object();
    if (at->is_object()) return *at;
    work.fault(Alarm::RequestBad, std::string(key) + ": an object is wanted", 0, key);
    return Json::object();
}

Result<Json> parse_request(std::string_view text) {
    if (text.size() > kLargestRequest)
        return Diagnosis{Alarm::RequestTooMany,
                         {},
                         {},
                         "a request of " + std::to_string(text.size()) + " characters, at most " +
                             std::to_string(kLargestRequest)};
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && c == '\\')
            ++i;
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted && (c == '{' || c == '[') && ++depth > kDeepestRequest)
            return Diagnosis{
                Alarm::TextTooDeep,
                {},
                {},
                "a request of more than " + std::to_string(kDeepestRequest) + " levels"};
        else if (!quoted && (c == '}' || c == ']'))
            --depth;
    }
    Json out = Json::parse(text, nullptr, false);
    if (out.is_discarded() || !out.is_object())
        return Diagnosis{Alarm::StoreRequestBad, {}, {}, "not a JSON object"};
    return out;
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
