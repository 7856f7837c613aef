#include "kernel/supervisor/base/refusal.hpp"

#include <nlohmann/json.hpp>

#include "ipc/diagnosis/display_language.hpp"

namespace polyturn::supervisor {

using Json = nlohmann::json;

std::string refusal(const Diagnosis& diagnosis) {
    Json out;
    out["ok"] = false;
    out["number"] = std::string(alarm_number(diagnosis.alarm, Dialect::Polyturn));
    out["text"] = text_in(diagnosis, display_language_now());
    out["remedy"] = std::string(alarm_text(diagnosis.alarm, display_language_now()).remedy);
    return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Of several, each is named.
std::string refusal(const std::vector<Diagnosis>& diagnoses) {
    if (diagnoses.size() == 1) return refusal(diagnoses.front());
    Json out = Json::parse(refusal(diagnoses.front()));
    out["faults"] = Json::array();
    for (const Diagnosis& diagnosis : diagnoses)
        out["faults"].push_back(Json::parse(refusal(diagnosis)));
    return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace polyturn::supervisor
