#include "ipc/model/files/scenario.hpp"

#include <fmt/format.h>

#include "ipc/model/files/read_file.hpp"
#include "ipc/model/files/toml_reader.hpp"

namespace polyturn::text {

namespace {

void append_quoted(std::string& out, std::string_view words) {
    out += '"';
    for (const char c : words) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20)
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
        else
            out += c;
    }
    out += '"';
}

// TOML as JSON; dates have no counterpart and no event holds one.
bool append_json(std::string& out, const toml::node& node) {
    if (const auto* words = node.as_string())
        append_quoted(out, words->get());
    else if (const auto* whole = node.as_integer())
        out += std::to_string(whole->get());
    else if (const auto* real = node.as_floating_point()) {
        if (!(real->get() - real->get() == 0.0)) return false;  // not finite
        out += fmt::format("{}", real->get());
    } else if (const auto* truth = node.as_boolean())
        out += truth->get() ? "true" : "false";
    else if (const auto* list = node.as_array()) {
        out += '[';
        for (std::size_t i = 0; i < list->size(); ++i) {
            if (i) out += ',';
            if (!append_json(out, *list->get(i))) return false;
        }
        out += ']';
    } else if (const auto* table = node.as_table()) {
        out += '{';
        bool first = true;
        for (const auto& [key, value] : *table) {
            if (!first) out += ',';
            first = false;
            append_quoted(out, key.str());
            out += ':';
            if (!append_json(out, value)) return false;
        }
        out += '}';
    } else
        return false;
    return true;
}

class ScenarioReader {
public:
    ScenarioReader(std::string_view filename, std::vector<Diagnosis>& diagnoses)
        : toml_(filename, diagnoses) {}

    void file(const toml::table& root, Scenario& out) {
        toml_.each(root, [&](const toml::key& key, const toml::node& node) {
            if (key != "at") {
                toml_.unknown(key, "[[at]]");
                return;
            }
            if (const auto* list = toml_.array(key, node))
                for (const auto& one : *list)
                    if (const auto* content = toml_.table(key, one)) entry(*content, out);
        });
    }

private:
    // One [[at]]: a time or an event, and one or more things to do, which act in the order in which
    // they are written.
    void entry(const toml::table& table, Scenario& out) {
        Stimulus common;
        bool timed = false, faulty = false;
        std::vector<Stimulus> actions;
        toml_.each(table, [&](const toml::key& key, const toml::node& node) {
            if (key == "t") {
                common.at_s = toml_.number(key, node);
                if (common.at_s && *common.at_s < 0) {
                    toml_.wrong(key, node, "a time from 0 on");
                    faulty = true;
                }
                timed = true;
                faulty = faulty || !common.at_s;
            } else if (key == "when") {
                timed = true;
                const auto* part = toml_.table(key, node);
                if (!part || !append_json(common.when, *part)) {
                    if (part)
                        toml_.wrong(key, node,
                                    "a part of an event: texts, numbers, lists, true, false");
                    faulty = true;
                }
            } else if (key == "after") {
                const auto seconds = toml_.number(key, node);
                if (seconds && *seconds < 0) {
                    toml_.wrong(key, node, "a time from 0 on");
                    faulty = true;
                }
                common.after_s = seconds.value_or(0.0);
            } else if (key == "for") {
                common.for_s = toml_.number(key, node);
                if (common.for_s && *common.for_s <= 0) {
                    toml_.wrong(key, node, "a time above 0");
                    faulty = true;
                }
            } else if (const auto kind = kind_of(key.str())) {
                if (auto words = toml_.text(key, node)) {
                    Stimulus action;
                    action.kind = *kind;
                    action.words = std::move(*words);
                    action.place = toml_.place(node.source(),
                                               static_cast<std::uint32_t>(action.words.size() + 2));
                    actions.push_back(std::move(action));
                } else
                    faulty = true;
            } else {
                toml_.unknown(key, "t, when, after, press, set, release, kill, stop, for");
                faulty = true;
            }
        });
        if (faulty) return;
        if (common.at_s && !common.when.empty())
            toml_.fault(Alarm::TextSyntax, table.source(), "either t or when, not both");
        else if (!timed)
            toml_.fault(Alarm::TextSyntax, table.source(),
                        "neither t nor when: it is not said when this happens");
        else if (actions.empty())
            toml_.fault(Alarm::TextSyntax, table.source(),
                        "nothing to do: press, set, release, kill or stop is missing");
        else
            for (Stimulus& action : actions) {
                if (common.for_s && action.kind != StimulusKind::Stop) {
                    toml_.fault(Alarm::TextSyntax, table.source(), "'for' belongs to 'stop' only");
                    return;
                }
                action.at_s = common.at_s;
                if (action.at_s) *action.at_s += common.after_s;
                action.when = common.when;
                action.after_s = common.after_s;
                action.for_s = common.for_s;
                out.stimuli.push_back(std::move(action));
            }
    }

    static std::optional<StimulusKind> kind_of(std::string_view key) {
        if (key == "press") return StimulusKind::Press;
        if (key == "set") return StimulusKind::Set;
        if (key == "release") return StimulusKind::Release;
        if (key == "kill") return StimulusKind::Kill;
        if (key == "stop") return StimulusKind::Stop;
        return std::nullopt;
    }

    TomlReader toml_;
};

}  // namespace

Scenario parse_scenario(std::string_view content, std::string_view filename,
                        std::vector<Diagnosis>& diagnoses) {
    Scenario out;
    out.file = std::string(filename);
    if (const auto root = TomlReader(filename, diagnoses).parse(content))
        ScenarioReader(filename, diagnoses).file(*root, out);
    return out;
}

Result<Scenario> load_scenario(const std::string& path) {
    const auto content = read_text_file(path, kLargestToml);
    if (!content) return content.diagnosis();
    std::vector<Diagnosis> diagnoses;
    Scenario scenario = parse_scenario(*content, path, diagnoses);
    if (!diagnoses.empty()) return diagnoses.front();
    return scenario;
}

}  // namespace polyturn::text
