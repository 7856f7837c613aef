#include "kernel/supervisor/press/dialogue_verb.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "ipc/model/machine/machine_config.hpp"
#include "ipc/memory/segment.hpp"
#include "kernel/supervisor/press/phrases.hpp"
#include "kernel/supervisor/status/ask_verbs.hpp"

namespace polyturn::supervisor {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kNote = 64, kKey = 32;

Json page_of(unsigned channel, const Dialogue& page) {
    Json out{{"ch", channel},
             {"title", page.title.data()},
             {"fields", Json::array()},
             {"notes", Json::array()},
             {"keys", Json::array()}};
    for (std::size_t i = 0; i < page.field_count; ++i) {
        const DialogueField& field = page.fields[i];
        Json one{{"name", field.name.data()}, {"variable", field.variable.data()}};
        one["value"] = std::isfinite(field.value) ? Json(field.value) : Json(nullptr);
        out["fields"].push_back(one);
    }
    for (std::size_t i = 0; i < page.note_count; ++i)
        out["notes"].push_back(std::string(&page.notes[i * kNote]));
    for (std::size_t k = 0; k < page.keys.size() / kKey; ++k)
        if (page.keys[k * kKey])
            out["keys"].push_back(
                Json{{"key", k + 1}, {"text", std::string(&page.keys[k * kKey])}});
    return out;
}

std::string page_lines(const Json& page) {
    std::string out =
        fmt::format("L{}  {}\n", page["ch"].get<unsigned>(), page["title"].get<std::string>());
    for (const Json& field : page["fields"])
        out += fmt::format("  {:<12} {:<12} {}\n", field["variable"].get<std::string>(),
                           field["name"].get<std::string>(),
                           field["value"].is_null()
                               ? std::string("-")
                               : fmt::format("{:.10g}", field["value"].get<double>()));
    for (const Json& note : page["notes"]) out += "  " + note.get<std::string>() + "\n";
    for (const Json& key : page["keys"])
        out += fmt::format("  key={:<8} {}\n", key["key"].get<unsigned>(),
                           key["text"].get<std::string>());
    return out;
}

}  // namespace

int dialogue_verb(const CommandLine& line) {
    const std::string instance = line.instance.empty() ? "polyturn" : line.instance;
    if (!line.words.empty())
        return ask(instance, Json{{"do", "press"}, {"words", "answer " + line.words}}.dump(
                                 -1, ' ', false, Json::error_handler_t::replace))
                   ? 0
                   : 2;
    auto kernel = PeerSegment<KernelSegment>::attach(instance);
    if (!kernel) return refuse(kernel.diagnosis());
    auto status = std::make_unique<MachineStatus>();
    if (!(*kernel)->status.read(*status)) return refuse({Alarm::SegmentNotReady, {}, {}, instance});
    Json pages = Json::array();
    for (unsigned number = 1; number <= kMaxChannels; ++number) {
        const ChannelStatus& channel = status->channels[number - 1];
        if (static_cast<ChannelState>(channel.state) != ChannelState::ProgramStop ||
            static_cast<StopReason>(channel.stop_reason) != StopReason::Dialogue)
            continue;
        auto segment = PeerSegment<ChannelSegment>::attach(instance, number);
        auto page = std::make_unique<Dialogue>();
        if (segment && (*segment)->dialogue.read(*page) && page->serial != 0)
            pages.push_back(page_of(number, *page));
    }
    std::string out;
    if (line.json)
        out = pages.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    else
        for (const Json& page : pages) out += page_lines(page);
    if (out.empty()) out = std::string(say("No program asks anything.\n"));
    std::fwrite(out.data(), 1, out.size(), stdout);
    return 0;
}

}  // namespace polyturn::supervisor
