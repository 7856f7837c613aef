#include "kernel/supervisor/store/presetter_verb.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "kernel/supervisor/base/child.hpp"
#include "kernel/supervisor/check/job_plan.hpp"
#include "kernel/supervisor/press/phrases.hpp"
#include "kernel/supervisor/status/ask_verbs.hpp"

namespace polyturn::supervisor {

using Json = nlohmann::json;

namespace {

// What the program answers; its refusal is printed as every other one.
bool run(const std::vector<std::string>& arguments, Json& answer) {
    auto child = Child::start("polyturn-presetter", arguments, {.input = false, .output = true});
    if (!child) {
        refuse(child.diagnosis());
        return false;
    }
    std::string text;
    char piece[4096];
    for (ssize_t got = 0; (got = read(child->output_fd(), piece, sizeof piece)) > 0;)
        text.append(piece, static_cast<std::size_t>(got));
    child->end_within(-1);
    answer = Json::parse(text, nullptr, false);
    if (child->status() < 0 || !answer.is_object()) {
        refuse({Alarm::PresetterImage,
                {},
                {},
                "polyturn-presetter is not here: it is built where OpenCV is installed"});
        return false;
    }
    if (answer.value("ok", false)) return true;
    fmt::print(stderr, "{} {}\n   {}\n", answer.value("number", ""), answer.value("text", ""),
               answer.value("remedy", ""));
    return false;
}

}  // namespace

int presetter_verb(const StoreOptions& options, const std::string& instance, bool json) {
    const auto& w = options.words;
    const std::string file = options.name.empty() ? "presetter.json" : options.name;
    Json answer;
    const auto with_frames = [&](std::vector<std::string> arguments) {
        if (options.frames > 0) arguments.push_back("--frames=" + std::to_string(options.frames));
        return arguments;
    };
    if (options.action == "calibrate") {
        std::vector<std::string> arguments = {"calibrate", w[0], "--save", file};
        for (std::size_t i = 1; i < w.size(); ++i) {
            const std::size_t at = w[i].find('=');
            const std::string name = w[i].substr(0, at),
                              value = at == std::string::npos ? std::string() : w[i].substr(at + 1);
            if (name == "mirrored" && value == "1")
                arguments.push_back("--mirrored");
            else if ((name == "diameter" || name == "x" || name == "z" || name == "error") &&
                     !value.empty())
                arguments.push_back("--" + name + "=" + value);
            else
                return refuse({Alarm::PressArgument, {}, {}, w[i]});
        }
        if (!run(with_frames(arguments), answer)) return 2;
        if (json)
            fmt::print("{}\n", answer.dump());
        else
            fmt::print(
                fmt::runtime(say("{:.4f} um a pixel, tilted by {:.3f} degrees; kept in {}\n")),
                answer.value("um_per_pixel", 0.0), answer.value("tilt_deg", 0.0), file);
        return 0;
    }
    if (w.size() == 2) return refuse({Alarm::PressArgument, {}, {}, w[1]});
    if (!run(with_frames({"measure", w[0], "--calibration", file}), answer)) return 2;
    if (!json) {
        const auto line = [&](const char* name, const char* unit) {
            fmt::print("  {} {:>10.4f} +-{:.4f} {}\n", name, answer.value(name, 0.0),
                       answer.value(std::string(name) + "_error", 0.0), unit);
        };
        line("X", "mm (radius)");
        line("Z", "mm");
        line("R", "mm");
        fmt::print(
            fmt::runtime(say("  T {}; edges at {:.2f} and {:.2f} degrees, {:.2f} between them\n")),
            answer.value("T", 0), answer["edges_deg"][0].get<double>(),
            answer["edges_deg"][1].get<double>(), answer.value("included_deg", 0.0));
    }
    if (w.size() < 3) return json ? fmt::print("{}\n", answer.dump()), 0 : 0;
    Json op = {{"do", "offsets.preset"},
               {"channel", w[1][0] == 'L' || w[1][0] == 'l' ? w[1].substr(1) : w[1]},
               {"preview", !options.yes}};
    int tool = 0, edge = 0, used = 0;  // an edge as T3.D1, else the number of an offset
    if (std::sscanf(w[2].c_str(), "T%d.D%d%n", &tool, &edge, &used) == 2 &&
        static_cast<std::size_t>(used) == w[2].size()) {
        op["tool"] = tool;
        op["edge"] = edge;
    } else
        op["number"] = w[2];
    for (const char* name : {"X", "Z", "R", "T"}) op[name] = answer[name];
    std::string text;
    if (!ask(instance,
             Json{{"do", "store"}, {"op", op}}.dump(-1, ' ', false, Json::error_handler_t::replace),
             &text))
        return 2;
    const Json entered = Json::parse(text, nullptr, false);
    if (json) {
        answer["entries"] = entered.value("entries", Json::array());
        answer["written"] = options.yes;
        fmt::print("{}\n", answer.dump());
        return 0;
    }
    for (const auto& one : entered.value("entries", Json::array()))
        fmt::print("{}: {:g} -> {:g} ({:+g})\n", one.value("what", ""), one.value("old", 0.0),
                   one.value("new", 0.0), one.value("difference", 0.0));
    fmt::print("{}",
               say(options.yes ? "Written.\n" : "Nothing was changed yet: say --yes to do it.\n"));
    return 0;
}

}  // namespace polyturn::supervisor
