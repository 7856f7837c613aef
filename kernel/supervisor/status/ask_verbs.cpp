#include "kernel/supervisor/status/ask_verbs.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "ipc/diagnosis/display_language.hpp"
#include "ipc/memory/controller_door.hpp"
#include "ipc/memory/segment.hpp"
#include "kernel/supervisor/base/access.hpp"
#include "kernel/supervisor/base/json_fields.hpp"
#include "kernel/supervisor/check/job_plan.hpp"
#include "kernel/supervisor/press/phrases.hpp"
#include "kernel/supervisor/start/request_socket.hpp"
#include "kernel/supervisor/status/machine_status.hpp"

namespace polyturn::supervisor {

using Json = nlohmann::json;

void print(std::string_view words) { std::fwrite(words.data(), 1, words.size(), stdout); }

text::BuilderMessages builder_messages(const std::string& instance) {
    text::BuilderMessages out;
    if (const auto supervisor = PeerSegment<SupervisorSegment>::attach(instance); supervisor)
        // the controller has reported what is wrong in it
        if (const std::string base = (*supervisor)->options.machine_folder.data(); !base.empty())
            (void)out.add_file(
                (std::filesystem::path(base).parent_path() / "messages.csv").string());
    return out;
}

std::string told(const std::string& number, std::string english,
                 const text::BuilderMessages& messages) {
    english = messages.told_in(std::move(english),
                               static_cast<text::MessageLanguage>(display_language_now()));
    if (display_language_now() == DisplayLanguage::English) return english;
    const std::string padded =
        number.size() < 3 ? std::string(3 - number.size(), '0') + number : number;
    for (const Dialect dialect : {Dialect::Polyturn, Dialect::Fanuc, Dialect::Nct, Dialect::Fagor,
                                  Dialect::Sinumerik, Dialect::Mefi})
        for (const std::string& written : {number, padded})
            if (auto found = retell(written, dialect, english, display_language_now()))
                return found->text;
    return english;
}

int refuse(const Diagnosis& diagnosis) {
    print_diagnosis(diagnosis, Dialect::Polyturn);
    return 2;
}

bool ask(const std::string& instance, const std::string& request, std::string* answer) {
    // Whoever has logged in says so.
    std::string line = request;
    if (const std::string token = kept_token(instance); !token.empty())
        if (Json with = Json::parse(request, nullptr, false); with.is_object()) {
            with["token"] = token;
            line = with.dump(-1, ' ', false, Json::error_handler_t::replace);
        }
    const auto got = ask_controller(instance, line);
    if (!got) {
        print_diagnosis(got.diagnosis(), Dialect::Polyturn);
        return false;
    }
    const Json reply = Json::parse(*got, nullptr, false);
    if (const auto ok = reply.is_object() ? reply.find("ok") : reply.end();
        reply.is_object() && ok != reply.end() && ok->is_boolean() && ok->get<bool>()) {
        if (answer) *answer = *got;
        return true;
    }
    const auto shown = [](const Json& one) {
        std::string place;
        if (one.contains("row"))
            place += fmt::format(fmt::runtime(say("row {}, ")), count_field(one, "row"));
        if (one.contains("column"))
            place += fmt::format(fmt::runtime(say("column {}: ")), text_field(one, "column"));
        else if (!place.empty())
            place.replace(place.size() - 2, 2, ": ");
        return fmt::format("{}alarm {}: {}\n   {}\n", place, text_field(one, "number"),
                           text_field(one, "text"), text_field(one, "remedy"));
    };
    std::string words;
    if (!reply.is_object())
        words = *got;
    else if (const auto faults = reply.find("faults"); faults != reply.end() && faults->is_array())
        for (const Json& one : *faults) words += shown(one);
    else
        words = shown(reply);
    std::fwrite(words.data(), 1, words.size(), stderr);
    return false;
}

int press_words(const CommandLine& line) {
    Json request;
    request["do"] = line.verb == Verb::Press ? "press" : line.verb == Verb::Set ? "set" : "release";
    request["words"] = line.words;
    // programs are named from the caller's folder
    request["folder"] = std::filesystem::current_path().string();
    std::string answer;
    if (!ask(line.instance.empty() ? "polyturn" : line.instance,
             request.dump(-1, ' ', false, Json::error_handler_t::replace), &answer))
        return 2;
    const Json reply = Json::parse(answer, nullptr, false);
    // what a selected job has otherwise
    if (const auto notes = reply.find("notes"); notes != reply.end() && notes->is_array())
        for (const Json& one : *notes)
            if (one.is_string()) std::fputs((one.get<std::string>() + "\n").c_str(), stderr);
    return 0;
}

int show_status(const CommandLine& line) {
    std::vector<std::string> instances;
    if (line.instance.empty())
        instances = running_instances();
    else
        instances.push_back(line.instance);
    if (instances.empty()) {
        print(line.json ? "[]\n" : say("No controller runs here.\n"));
        return 0;
    }
    std::string out;
    for (const std::string& instance : instances) {
        const auto status = line.json ? status_json(instance) : status_page(instance);
        if (!status) {
            print_diagnosis(status.diagnosis(), Dialect::Polyturn);
            if (!line.instance.empty()) return 2;
            continue;
        }
        if (line.json && !out.empty()) out += ",\n";
        out += *status;
    }
    print(line.json && line.instance.empty() ? "[" + out + "]\n" : line.json ? out + "\n" : out);
    return 0;
}

int show_alarms(const CommandLine& line) {
    std::string answer;
    if (!ask(line.instance.empty() ? "polyturn" : line.instance, R"({"do":"alarms"})", &answer))
        return 2;
    const Json reply = Json::parse(answer, nullptr, false);
    if (!reply.is_object() || !reply.contains("alarms") || !reply["alarms"].is_array()) return 2;
    if (line.json) {
        print(reply["alarms"].dump() + "\n");
        return 0;
    }
    const text::BuilderMessages messages =
        builder_messages(line.instance.empty() ? "polyturn" : line.instance);
    for (const auto& alarm : reply["alarms"]) {
        const std::string number = !alarm.contains("number") ? std::string(say("message"))
                                   : alarm["number"].is_string()
                                       ? alarm["number"].get<std::string>()
                                       : alarm["number"].dump();
        print(fmt::format(
            "{:>10.3f} s  {:<4} {:<8} {}\n", alarm.value("t", 0.0),
            alarm.contains("ch") ? fmt::format("L{}", alarm.value("ch", 0)) : std::string(), number,
            told(number, alarm.value("text", ""), messages)));
    }
    if (reply["alarms"].empty()) print(say("No alarms.\n"));
    return 0;
}

int clean_up() {
    auto removed = remove_dead_instances();
    for (std::string& door : remove_dead_doors()) removed.push_back(std::move(door));
    for (const auto& name : removed) print(fmt::format(fmt::runtime(say("removed {}\n")), name));
    if (removed.empty()) print(say("Nothing to remove.\n"));
    return 0;
}

}  // namespace polyturn::supervisor
