#include "kernel/supervisor/start/request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

namespace polyturn::supervisor {

using Json = nlohmann::json;

namespace {

enum class Type { Text, Flag, Count, Texts, Object };

struct Field {
    std::string_view name;
    Type type;
    bool needed = false;
    std::size_t most = 0;  // characters of a text, and of each of several
    std::string Request::*text = nullptr;
};

constexpr std::size_t kPathLength = 4096, kWordsLength = 4096, kToken = 128, kParameterLine = 1024;
constexpr Field kTokenField{"token", Type::Text, false, kToken, &Request::token};
constexpr Field kWordsField{"words", Type::Text, true, kWordsLength, &Request::words};
// programs are named from there
constexpr Field kFolderField{"folder", Type::Text, false, kPathLength, &Request::folder};

struct Row {
    std::string_view name;
    RequestVerb verb;
    RequestClass rank;
    std::string_view meaning;
    Field fields[4];
};

constexpr Row kRows[] = {
    {"press",
     RequestVerb::Press,
     RequestClass::Machine,
     "what an operator presses",
     {kWordsField, kFolderField, kTokenField}},
    {"set",
     RequestVerb::Set,
     RequestClass::Machine,
     "a signal, an offset, a zero, a parameter",
     {kWordsField, kFolderField, kTokenField}},
    {"release",
     RequestVerb::Release,
     RequestClass::Machine,
     "gives a signal back to the PLC",
     {kWordsField, kFolderField, kTokenField}},
    {"parameters",
     RequestVerb::Parameters,
     RequestClass::Store,
     "parameter lines; import: all of them or none",
     {{"lines", Type::Texts, true, kParameterLine}, {"import", Type::Flag}, kTokenField}},
    {"store",
     RequestVerb::Store,
     RequestClass::Store,
     "an operation of the store",
     {{"op", Type::Object, true}, kTokenField}},
    {"alarms",
     RequestVerb::Alarms,
     RequestClass::Machine,
     "the alarms behind so many",
     {{"since", Type::Count}, kTokenField}},
    {"who", RequestVerb::Who, RequestClass::Machine, "who asks, and his level", {kTokenField}},
    {"logout",
     RequestVerb::Logout,
     RequestClass::Machine,
     "the login of the token ends",
     {kTokenField}},
    {"end", RequestVerb::End, RequestClass::Machine, "the controller ends", {kTokenField}},
};

constexpr std::string_view kStops[] = {"feed_hold", "emergency_stop", "reset"};

Diagnosis bad(std::string why) { return Diagnosis{Alarm::RequestBad, {}, {}, std::move(why)}; }

// As press_words splits it.
std::string_view first_word(std::string_view words) {
    const auto begin = words.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    words.remove_prefix(begin);
    return words.substr(0, words.find_first_of(" \t"));
}
bool stops(std::string_view words) {
    return std::find(std::begin(kStops), std::end(kStops), first_word(words)) != std::end(kStops);
}

std::string_view type_words(Type type) {
    switch (type) {
        case Type::Text:
            return "a text";
        case Type::Flag:
            return "true or false";
        case Type::Count:
            return "a whole number from 0";
        case Type::Texts:
            return "a list of texts";
        case Type::Object:
            return "an object";
    }
    return "";
}

// What a file name or a word cannot hold, and what no field needs.
bool good_text(const std::string& text, std::size_t most) {
    return text.size() <= most && text.find('\0') == std::string::npos;
}

// Takes the field; what is wrong with it, or nothing.
std::string take(const Field& field, const Json& value, Request& out) {
    const auto wrong = [&] {
        return fmt::format("{}: {} is expected", field.name, type_words(field.type));
    };
    const auto too_long = [&] {
        return fmt::format("{}: longer than {} characters, or a zero byte in it", field.name,
                           field.most);
    };
    switch (field.type) {
        case Type::Text:
            if (!value.is_string()) return wrong();
            if (!good_text(value.get_ref<const std::string&>(), field.most)) return too_long();
            if (field.text) out.*field.text = value.get_ref<const std::string&>();
            return {};
        case Type::Flag:
            if (!value.is_boolean()) return wrong();
            out.import = value.get<bool>();
            return {};
        case Type::Count:
            if (!value.is_number_unsigned()) return wrong();
            out.since = value.get<std::uint64_t>();
            return {};
        case Type::Texts:
            if (!value.is_array()) return wrong();
            for (const Json& one : value) {
                if (!one.is_string()) return wrong();
                if (!good_text(one.get_ref<const std::string&>(), field.most)) return too_long();
                out.lines.push_back(one.get_ref<const std::string&>());
            }
            return {};
        case Type::Object: {
            if (!value.is_object()) return wrong();
            const auto what = value.find("do");
            if (what == value.end() || !what->is_string() ||
                !good_text(what->get_ref<const std::string&>(), kToken))
                return fmt::format("{}: no `do`", field.name);
            out.operation = what->get<std::string>();
            out.operation_text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
            return {};
        }
    }
    return wrong();
}

bool imports(const Request& request) {
    return request.import || request.operation.ends_with(".import");
}

}  // namespace

std::string_view json_beyond_limits(std::string_view text, std::size_t deepest,
                                    std::size_t most_values) {
    std::size_t depth = 0, values = 1;
    bool inside = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inside) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                inside = false;
            continue;
        }
        if (c == '"')
            inside = true;
        else if (c == '[' || c == '{') {
            if (++depth > deepest) return "nested too deeply";
        } else if (c == ']' || c == '}') {
            if (depth) --depth;
        } else if (c == ',' && ++values > most_values)
            return "too many values";
    }
    return {};
}

bool is_stop(std::string_view line) {
    if (line.size() > kStopLine) return false;
    std::size_t at = 0;
    const auto skip = [&] { at = std::min(line.find_first_not_of(" \t\r", at), line.size()); };
    const auto is = [&](char c) {
        skip();
        return at < line.size() && line[at] == c ? ++at, true : false;
    };
    const auto text = [&](std::string_view& out) {
        if (!is('"')) return false;
        const std::size_t begin = at;
        for (; at < line.size() && line[at] != '"'; ++at)
            if (line[at] == '\\') ++at;
        if (at >= line.size()) return false;
        out = line.substr(begin, at++ - begin);
        return true;
    };
    bool press = false, stop = false;
    if (!is('{')) return false;
    do {
        std::string_view key, value;
        if (!text(key) || !is(':') || !text(value)) return false;
        if (key == "do") press = value == "press";
        if (key == "words") stop = stops(value);
    } while (is(','));
    return is('}') && press && stop;
}

Result<Request> decode_request(std::string_view line) {
    if (line.size() > kLongestImport)
        return bad(fmt::format("a line longer than {} bytes", kLongestImport));
    const bool large = line.size() > kLongestLine;
    if (const auto why = json_beyond_limits(line, kDeepest, kMostImported); !why.empty())
        return bad(std::string(why));
    const Json read = Json::parse(line, nullptr, false);
    if (read.is_discarded() || !read.is_object())
        return bad(fmt::format("no JSON object: {}", line.substr(0, 100)));
    const auto what = read.find("do");
    if (what == read.end() || !what->is_string()) return bad("no `do`");
    const std::string& name = what->get_ref<const std::string&>();
    const auto row = std::find_if(std::begin(kRows), std::end(kRows),
                                  [&](const Row& one) { return one.name == name; });
    if (row == std::end(kRows)) return Diagnosis{Alarm::PressUnknown, {}, {}, name.substr(0, 100)};
    Request out;
    out.verb = row->verb;
    out.rank = row->rank;
    for (const auto& [key, value] : read.items()) {
        if (key == "do") continue;
        const auto field =
            std::find_if(std::begin(row->fields), std::end(row->fields),
                         [&](const Field& one) { return !one.name.empty() && one.name == key; });
        if (field == std::end(row->fields))
            return bad(fmt::format("{} has no field {}", name, key.substr(0, 100)));
        if (std::string why = take(*field, value, out); !why.empty()) return bad(std::move(why));
    }
    for (const Field& field : row->fields)
        if (field.needed && !read.contains(field.name))
            return bad(fmt::format("{} needs {}", name, field.name));
    if (!imports(out)) {
        if (large) return bad(fmt::format("a line longer than {} bytes", kLongestLine));
        if (const auto why = json_beyond_limits(line, kDeepest, kMostValues); !why.empty())
            return bad(std::string(why));
    } else if (out.verb == RequestVerb::Parameters) {
        out.rank = RequestClass::Files;  // the whole machine is checked with it
    }
    if (out.verb == RequestVerb::Press && stops(out.words)) out.rank = RequestClass::Stop;
    if (out.verb == RequestVerb::Press && first_word(out.words) == "select")
        out.rank = RequestClass::Files;
    return out;
}

std::string describe_requests() {
    std::string out;
    for (const Row& row : kRows) {
        out += fmt::format("| `{}` | ", row.name);
        const char* comma = "";
        for (const Field& field : row.fields) {
            if (field.name.empty()) continue;
            out += fmt::format("{}`{}`{}: {}{}", comma, field.name,
                               field.needed ? "" : " (optional)", type_words(field.type),
                               field.most ? fmt::format(" (at most {} characters{})", field.most,
                                                        field.type == Type::Texts ? " each" : "")
                                          : std::string());
            comma = "; ";
        }
        out += fmt::format(" | {} |\n", row.meaning);
    }
    return out;
}

}  // namespace polyturn::supervisor
