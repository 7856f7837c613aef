#include "kernel/supervisor/store/store_verb.hpp"

#include <fmt/format.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "ipc/model/files/read_file.hpp"
#include "kernel/supervisor/base/access.hpp"
#include "kernel/supervisor/base/child.hpp"
#include "kernel/supervisor/check/job_plan.hpp"
#include "kernel/supervisor/press/phrases.hpp"
#include "kernel/supervisor/status/ask_verbs.hpp"
#include "kernel/supervisor/store/presetter_verb.hpp"
#include "kernel/supervisor/store/store_tables.hpp"

namespace polyturn::supervisor {

using Json = nlohmann::json;

namespace {

int wrong_word(const std::string& word) { return refuse({Alarm::PressArgument, {}, {}, word}); }

// Without an echo where somebody types; else a line of standard input.
std::string ask_password(const char* prompt) {
    termios before{};
    const bool typed = isatty(STDIN_FILENO) && tcgetattr(STDIN_FILENO, &before) == 0;
    if (typed) {
        std::fputs(prompt, stderr);
        termios quiet = before;
        quiet.c_lflag &= ~static_cast<tcflag_t>(ECHO);
        tcsetattr(STDIN_FILENO, TCSANOW, &quiet);
    }
    std::string out;
    std::getline(std::cin, out);
    if (typed) {
        tcsetattr(STDIN_FILENO, TCSANOW, &before);
        std::fputs("\n", stderr);
    }
    return out;
}

// "life=100": false when there is no equals sign.
bool split_field(const std::string& word, std::string& name, std::string& value) {
    const std::size_t at = word.find('=');
    if (at == std::string::npos || at == 0) return false;
    name = word.substr(0, at);
    value = word.substr(at + 1);
    return true;
}

// The words from `first` on are columns.
bool add_fields(Json& op, const std::vector<std::string>& words, std::size_t first,
                std::string& wrong) {
    op["fields"] = Json::object();
    for (std::size_t i = first; i < words.size(); ++i) {
        std::string name, value;
        if (!split_field(words[i], name, value)) {
            wrong = words[i];
            return false;
        }
        op["fields"][name] = value;
    }
    return true;
}

std::string channel_of(const std::string& word) {
    return !word.empty() && (word[0] == 'L' || word[0] == 'l') ? word.substr(1) : word;
}

// The operation that the words ask for; `wrong` names a word that does not fit.
Json tools_operation(const StoreOptions& o, std::string& wrong) {
    const auto& w = o.words;
    Json op = {{"do", "tools." + o.action}};
    if (o.action == "list") {
        if (o.magazine >= 0) op["magazine"] = o.magazine;
        if (o.type >= 0) op["type"] = o.type;
    } else if (o.action == "add") {
        std::size_t first = 0;
        if (!w.empty() && w[0].find('=') == std::string::npos) {
            op["tool"] = w[0];
            first = 1;
        }
        add_fields(op, w, first, wrong);
    } else if (o.action == "set") {
        op["tool"] = w[0];
        add_fields(op, w, 1, wrong);
    } else if (o.action == "load" || o.action == "move") {
        op["tool"] = w[0];
        if (w.size() > 1) op["magazine"] = w[1];
        if (w.size() > 2) op["pot"] = w[2];
    } else if (o.action == "place") {
        op["magazine"] = w[0];
        op["pot"] = w[1];
        for (std::size_t i = 2; i < w.size(); ++i) {
            std::string name, value;
            if (!split_field(w[i], name, value)) wrong = w[i];
            op[name] = value;
        }
    } else if (o.action == "life") {
        op["do"] = w.empty() ? "life.report" : "life.reset";
        if (!w.empty() && w[0] != "reset") wrong = w[0];
        op["tools"] = Json::array();
        for (std::size_t i = 1; i < w.size(); ++i) {
            if (w[i].find_first_not_of("0123456789") != std::string::npos || w[i].size() > 6 ||
                w[i].empty())
                wrong = w[i];
            else
                op["tools"].push_back(std::stol(w[i]));
        }
        if (!w.empty() && w.size() == 1) wrong = "reset";
        if (o.channel > 0) op["channel"] = o.channel;
    } else if (o.action == "import" || o.action == "export") {
        op["format"] = o.format;
        if (o.channel > 0) op["channel"] = o.channel;
        if (o.action == "import") op["preview"] = o.preview;
    } else if (!w.empty()) {
        op["tool"] = w[0];
    }
    return op;
}

// A tool's edge as T3.D1 (T3: its first one), else the number of an offset.
void name_offset(Json& op, const std::string& word) {
    int tool = 0, edge = 0, used = 0;
    if (std::sscanf(word.c_str(), "T%d%n", &tool, &used) != 1) return void(op["number"] = word);
    op["tool"] = tool;
    if (static_cast<std::size_t>(used) == word.size()) return;
    if (std::sscanf(word.c_str(), "T%d.D%d%n", &tool, &edge, &used) == 2 &&
        static_cast<std::size_t>(used) == word.size())
        op["edge"] = edge;
    else {
        op.erase("tool");
        op["number"] = word;
    }
}

// «X=40», or of an edge «DP13=0.02».
bool name_value(Json& op, const std::string& word) {
    std::string name, value;
    if (!split_field(word, name, value)) return false;
    int dp = 0, used = 0;
    op.erase("dp");
    op.erase("field");
    if (op.contains("tool") && std::sscanf(name.c_str(), "DP%d%n", &dp, &used) == 1 &&
        static_cast<std::size_t>(used) == name.size())
        op["dp"] = dp;
    else
        op["field"] = name;
    op["value"] = value;
    return true;
}

// Values of an edge may be named without their table: DP13 is one of wear.
std::size_t first_value(const Json& op, const std::vector<std::string>& words) {
    return op.contains("tool") && words.size() > 2 && words[2].find('=') != std::string::npos ? 2
                                                                                              : 3;
}

Json offsets_operation(const StoreOptions& o, std::string& wrong) {
    const auto& w = o.words;
    Json op = {{"do", "offsets." + o.action}};
    if (!w.empty()) op["channel"] = channel_of(w[0]);
    if (o.action == "history") {
        op["most"] = o.most;
        op["who"] = o.who;
    }
    if (o.action == "undo" && w.size() > 1) {
        name_offset(op, w[1]);
        if (!op.contains("tool")) wrong = w[1];
        return op;
    }
    if (o.plane) op["plane"] = o.plane;
    if (o.action == "touch") {
        if (w.size() > 1) name_offset(op, w[1]);
        if (w.size() > 2) op["table"] = w[2];
        op["preview"] = !o.yes;
        return op;
    }
    if (w.size() < 3) return op;
    name_offset(op, w[1]);
    const std::size_t first = first_value(op, w);
    if (w.size() <= first) {
        wrong = w.back();
        return op;
    }
    if (first == 3) op["table"] = w[2];
    if (o.action == "relative")
        op["field"] = w[3];
    else if (!name_value(op, w[first]))
        wrong = w[first];
    op["incremental"] = o.incremental;
    if (!o.zero.empty()) op["zero"] = o.zero;
    return op;
}

// The words behind the channel: a zero's name and one AXIS=VALUE, either may be missing for touch.
Json zeros_operation(const StoreOptions& o, std::string& wrong) {
    const auto& w = o.words;
    Json op = {{"do", "zeros." + o.action}};
    if (!w.empty()) op["channel"] = channel_of(w[0]);
    std::string name, value;
    for (std::size_t i = 1; i < w.size() && i < 3; ++i) {
        if (split_field(w[i], name, value)) {
            op["field"] = name;
            op["value"] = value;
        } else if (i == 1)
            op["zero"] = w[i];
        else
            wrong = w[i];
    }
    if (o.offset >= 0) op["offset"] = o.offset;
    if (o.action == "set") op["incremental"] = o.incremental;
    if (o.action == "touch") op["preview"] = !o.yes;
    return op;
}

Json parts_operation(const StoreOptions& o, std::string& wrong) {
    const auto& w = o.words;
    Json op = {{"do", "parts." + o.action}};
    std::size_t first = 0;
    if (!w.empty() && w[0].find('=') == std::string::npos) {
        op["dimension"] = w[0];
        first = 1;
    }
    if (o.action == "add" || o.action == "set")
        add_fields(op, w, first, wrong);
    else if (w.size() > 1)
        op["value"] = w[1];
    return op;
}

Json pallets_operation(const StoreOptions& o, std::string& wrong) {
    const auto& w = o.words;
    Json op = {{"do", "pallets." + o.action}};
    if (!w.empty()) op["row"] = w[0];
    if (o.action == "exchange") op["with"] = w[1];
    if (o.action == "set") add_fields(op, w, 1, wrong);
    return op;
}

Json users_operation(const StoreOptions& o, std::string& wrong) {
    const auto& w = o.words;
    Json op = {{"do", "users." + o.action}};
    if (!w.empty()) op["name"] = w[0];
    if (w.size() > 1) op["level"] = w[1];
    if (w.size() > 2) {
        std::string name, value;
        if (split_field(w[2], name, value) && name == "uid")
            op["uid"] = value;
        else
            wrong = w[2];
    }
    if (o.action == "add") op["password"] = ask_password("New password: ");
    if (o.action == "password") {
        op["password"] = ask_password("Old password (empty for a maker): ");
        op["new"] = ask_password("New password: ");
    }
    return op;
}

// Sends the operation; false when it was refused and reported.
bool send(const std::string& instance, const Json& op, Json& answer) {
    std::string text;
    const Json request = {{"do", "store"}, {"op", op}};
    if (!ask(instance, request.dump(-1, ' ', false, Json::error_handler_t::replace), &text))
        return false;
    answer = Json::parse(text, nullptr, false);
    return answer.is_object();
}

bool asks_history(const Json& op) {
    return op.value("do", "") == "history.list" || op.value("do", "") == "offsets.history";
}

// Where a text is looked for among years of changes, the store looks at some thousands of them at a
// time and serves the others in between.
bool ask_history(const std::string& instance, Json op, Json& answer) {
    Json all = Json::array();
    const std::size_t most = op.value("most", std::size_t{50});
    for (;;) {
        if (!send(instance, op, answer)) return false;
        for (Json& one : answer["history"]) all.push_back(std::move(one));
        const auto more = answer.find("more");
        if (more == answer.end() || all.size() >= most) break;
        op["before_utc"] = (*more)["utc"];
        op["before_id"] = (*more)["id"];
        op["most"] = most - all.size();
    }
    answer.erase("more");
    answer["history"] = std::move(all);
    return true;
}

// The log is English.
void tell_stops(const std::string& instance, Json& answer) {
    const text::BuilderMessages messages = builder_messages(instance);
    for (Json& one : answer["stops"])
        if (const std::string number = one.value("number", ""); !number.empty())
            one["detail"] = told(number, one.value("detail", ""), messages);
}

int write_file(const std::string& file, const std::string& text) {
    if (file.empty() || file == "-") {
        std::fwrite(text.data(), 1, text.size(), stdout);
        return 0;
    }
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (!out) return refuse({Alarm::OutputFile, {}, {}, file});
    return 0;
}

int log_in(const std::string& instance, const StoreOptions& options) {
    Json answer;
    if (!send(instance,
              {{"do", "users.login"},
               {"name", options.words[0]},
               {"password", ask_password("Password: ")}},
              answer))
        return 2;
    if (!keep_token(instance, answer.value("token", "")))
        return refuse({Alarm::OutputFile, {}, {}, token_file(instance)});
    fmt::print(fmt::runtime(say("{} is logged in as {}.\n")), answer.value("name", ""),
               kLevelWords[answer.value("level", 0u) % 4]);
    return 0;
}

// A store that does not run: the store's own program puts the backup in its place.
int restore_offline(const StoreOptions& options) {
    std::vector<std::string> arguments = {
        "--store", options.store, "--restore",
        options.words.empty() ? "newest" : std::filesystem::absolute(options.words[0]).string()};
    if (!options.machine.empty()) arguments.insert(arguments.end(), {"--machine", options.machine});
    if (options.with_plc) arguments.push_back("--with-plc");
    if (!options.yes) {
        fmt::print(fmt::runtime(say("This replaces the store in {}. Say --yes to do it.\n")),
                   options.store);
        return 2;
    }
    auto child = Child::start("polyturn-toolmgmt", arguments);
    if (!child) return refuse(child.diagnosis());
    child->end_within(-1);
    return child->status() == 0 ? 0 : 2;
}

}  // namespace

int store_verb(const StoreOptions& options, bool json) {
    const std::string instance = options.instance.empty() ? "polyturn" : options.instance;
    if (options.group == "login") return log_in(instance, options);
    if (options.group == "restore" && !options.store.empty()) return restore_offline(options);
    if (options.group == "presetter") return presetter_verb(options, instance, json);
    if (options.group == "logout" || options.group == "who") {
        std::string text;
        if (!ask(instance, Json{{"do", options.group}}.dump(), &text)) return 2;
        if (options.group == "logout") {
            keep_token(instance, {});
            return 0;
        }
        const Json answer = Json::parse(text, nullptr, false);
        if (json)
            fmt::print("{}\n", text);
        else
            fmt::print(fmt::runtime(say("{} (level {})\n")),
                       answer.value("name", "").empty() ? "-" : answer.value("name", ""),
                       answer.value("level", ""));
        return 0;
    }
    std::string wrong;
    Json op;
    if (options.group == "tools")
        op = tools_operation(options, wrong);
    else if (options.group == "offsets")
        op = offsets_operation(options, wrong);
    else if (options.group == "zeros")
        op = zeros_operation(options, wrong);
    else if (options.group == "parts")
        op = parts_operation(options, wrong);
    else if (options.group == "pallets")
        op = pallets_operation(options, wrong);
    else if (options.group == "users")
        op = users_operation(options, wrong);
    else if (options.group == "history")
        op = {{"do", "history.list"},
              {"about", options.words.empty() ? "" : options.words[0]},
              {"who", options.who},
              {"most", options.most}};
    else if (options.group == "stops")
        op = {{"do", "stops.list"}, {"since", options.since}, {"most", options.most}};
    else if (options.group == "backup") {
        op = {{"do", "backup.to"},
              {"file", std::filesystem::absolute(options.words[0]).string()},
              {"with", Json::array()}};
        for (const std::string& one : options.with)
            op["with"].push_back(std::filesystem::absolute(one).string());
    } else if (options.group == "restore") {
        op = {{"do", "restore.from"},
              {"file",
               options.words.empty() ? "" : std::filesystem::absolute(options.words[0]).string()},
              {"preview", !options.yes},
              {"with_plc", options.with_plc}};
    }
    if (!wrong.empty()) return wrong_word(wrong);
    if (op.value("do", "") == "tools.import") {
        const auto text = text::read_text_file(options.words[0]);
        if (!text) return refuse(text.diagnosis());
        op["text"] = *text;
    }
    // Several values of one offset or zero are several entries; the first refusal ends it.
    Json answer;
    const std::size_t first = op.value("do", "") == "offsets.set" ? first_value(op, options.words)
                              : op.value("do", "") == "zeros.set" ? 2
                                                                  : options.words.size();
    const std::size_t entries = first < options.words.size() ? options.words.size() - first : 1;
    for (std::size_t i = 0; i < entries; ++i) {
        if (entries > 1) {
            std::string name, value;
            if (op.value("do", "") == "offsets.set") {
                if (!name_value(op, options.words[first + i]))
                    return wrong_word(options.words[first + i]);
            } else {
                if (!split_field(options.words[first + i], name, value))
                    return wrong_word(options.words[first + i]);
                op["field"] = name;
                op["value"] = value;
            }
        }
        if (!(asks_history(op) ? ask_history(instance, op, answer) : send(instance, op, answer)))
            return 2;
        if (op.value("do", "") == "stops.list" && !json) tell_stops(instance, answer);
        if (op.value("do", "") == "tools.export")
            return write_file(options.words.empty() ? "" : options.words[0],
                              answer.value("text", ""));
        if (json)
            fmt::print("{}\n", answer.dump(-1, ' ', false, Json::error_handler_t::replace));
        else
            fmt::print("{}", store_table(op.value("do", ""), answer, options.yes));
    }
    return 0;
}

}  // namespace polyturn::supervisor
