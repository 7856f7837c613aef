#include "kernel/supervisor/base/event_joiner.hpp"

#include <charconv>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "kernel/supervisor/base/event_text.hpp"
#include "kernel/supervisor/base/json_fields.hpp"

namespace polyturn::supervisor {

namespace {
void append_key(std::string& text, std::string_view key, double value) {
    if (!text.empty() && text.back() == '}') text.pop_back();
    text += ",\"";
    text += key;
    text += "\":";
    append_json_number(text, value);
    text += '}';
}

// The same rounding as in the text, so that order and text never disagree.
double rounded(double t_s) {
    const double micro = t_s * 1e6;
    return static_cast<double>(static_cast<long long>(micro < 0 ? micro - 0.5 : micro + 0.5)) / 1e6;
}

// One JSON object on one line, so far as whoever reads the log line by line needs it: what a
// channel sends must not look like an event of somebody else.
bool one_object(std::string_view text) {
    constexpr int kDeepest = 32;
    if (text.size() < 2 || text.front() != '{') return false;
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (static_cast<unsigned char>(c) < 0x20) return false;
        if (quoted && c == '\\') {
            if (++i == text.size() || static_cast<unsigned char>(text[i]) < 0x20) return false;
        } else if (c == '"') {
            quoted = !quoted;
        } else if (!quoted && (c == '{' || c == '[')) {
            if (++depth > kDeepest) return false;
        } else if (!quoted && (c == '}' || c == ']')) {
            if (--depth == 0) return i + 1 == text.size() && c == '}';
        }
    }
    return false;
}

bool speaks_for_another(std::string_view text, unsigned channel) {
    constexpr std::string_view kChannel = "\"ch\":";
    const auto at = text.find(kChannel);
    if (at == std::string_view::npos) return false;
    unsigned said = 0;
    const auto read =
        std::from_chars(text.data() + at + kChannel.size(), text.data() + text.size(), said);
    return read.ec != std::errc{} || said != channel;
}
}  // namespace

bool EventJoiner::note(unsigned channel, std::uint64_t number, std::string_view text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.remove_suffix(1);
    if (!one_object(text) || speaks_for_another(text, channel)) return false;
    Channel& own = channels_[channel];
    if (!own.skip || own.skip_number != number) {
        std::string& place = own.waiting[number];
        own.bytes += text.size() - place.size();
        place = std::string(text);
        while (own.waiting.size() > kMostWaiting || own.bytes > kMostBytes)
            drop_waiting(own, std::next(own.waiting.begin()));
        return true;
    }
    if (const auto entry = entries_.find(*own.skip); entry != entries_.end()) {
        entry->second.text = std::string(text);
        append_key(entry->second.text, "t", own.skip->t_s);
    }
    settle_skip(own);
    return true;
}

void EventJoiner::drop_waiting(Channel& own, std::map<std::uint64_t, std::string>::iterator end) {
    for (auto at = own.waiting.begin(); at != end; at = own.waiting.erase(at))
        own.bytes -= at->second.size();
}

// Nothing more is said about it: it may be given out as soon as it has ended.
void EventJoiner::settle_skip(Channel& own) {
    const std::optional<Key> key = std::exchange(own.skip, std::nullopt);
    if (!key) return;
    if (const auto entry = entries_.find(*key); entry != entries_.end() && entry->second.ended)
        entry->second.complete = true;
}

std::string_view EventJoiner::insert(unsigned channel, double t_s, std::string text, Entry entry,
                                     Key* key_out) {
    const Key key{rounded(t_s), channel, ++sequence_};
    append_key(text, "t", key.t_s);
    entry.text = std::move(text);
    if (key_out) *key_out = key;
    return entries_.emplace(key, std::move(entry)).first->second.text;
}

void EventJoiner::hold(unsigned channel, std::uint64_t number) {
    Channel& own = channels_[channel];
    const auto found = own.waiting.find(number);
    if (found == own.waiting.end()) return;
    own.bytes -= found->second.size();
    own.held.insert(own.waiting.extract(found));
    if (own.held.size() > kMostWaiting) own.held.erase(own.held.begin());
}

std::string_view EventJoiner::begin(unsigned channel, std::uint64_t number, double t_s) {
    Channel& own = channels_[channel];
    std::string text;
    if (const auto step = own.held.find(number); step != own.held.end()) {
        text = std::move(step->second);
        own.held.erase(step);
    } else {
        const auto found = own.waiting.find(number);
        if (found == own.waiting.end()) return {};
        text = found->second;
        drop_waiting(own, std::next(found));  // older ones were discarded with their records
        settle_skip(own);
        own.last = text;
    }
    const bool skip = text.find("\"kind\":\"skip\"") != std::string::npos;
    const std::string_view kind = event_kind(text);
    Entry entry;
    entry.number = number;
    entry.shows_end = kind == "move" || kind == "dwell";
    entry.complete = !entry.shows_end && !(measure_all_ && (kind == "wait" || kind == "aux"));
    Key key{};
    const std::string_view out = insert(channel, t_s, std::move(text), std::move(entry), &key);
    // The same number twice: the first one has ended, or it would hold back for ever what comes
    // behind it.
    if (own.open.contains(number)) end(channel, number, t_s);
    own.open.emplace(number, key);
    if (skip) {
        own.skip = key;
        own.skip_number = number;
    }
    return out;
}

void EventJoiner::end(unsigned channel, std::uint64_t number, double t_s) {
    Channel& own = channels_[channel];
    const auto found = own.open.find(number);
    if (found == own.open.end()) return;
    const auto entry = entries_.find(found->second);
    own.open.erase(found);
    if (entry == entries_.end()) return;  // given out already: it showed no end
    entry->second.end_s = rounded(t_s);
    entry->second.ended = true;
    entry->second.complete = !own.skip || own.skip_number != number;
}

void EventJoiner::close_channel(unsigned channel, double t_s) {
    Channel& own = channels_[channel];
    while (!own.open.empty()) end(channel, own.open.begin()->first, t_s);
    settle_skip(own);
    own.held.clear();
}

std::string_view EventJoiner::plain(unsigned channel, double t_s, std::string text) {
    Entry entry;
    entry.complete = true;
    return insert(channel, t_s, std::move(text), std::move(entry), nullptr);
}

void EventJoiner::drain(double until_s, const Sink& sink) {
    while (!entries_.empty()) {
        const auto first = entries_.begin();
        if (!first->second.complete || first->first.t_s >= until_s) return;
        Event event{std::move(first->second.text), first->first.t_s,
                    first->second.ended ? first->second.end_s : -1.0, first->first.channel};
        if (first->second.shows_end && first->second.ended)
            append_key(event.text, "end", first->second.end_s);
        entries_.erase(first);
        sink(event);
    }
}

void EventJoiner::finish(const Sink& sink) {
    for (auto& [key, entry] : entries_) entry.complete = true;
    drain(1e300, sink);
    for (auto& [number, channel] : channels_) channel.open.clear();
}

const std::string* EventJoiner::last_begun(unsigned channel) const {
    const auto found = channels_.find(channel);
    return found == channels_.end() || found->second.last.empty() ? nullptr : &found->second.last;
}

std::string EventJoiner::file_of(unsigned channel, unsigned line) const {
    const std::string* last = last_begun(channel);
    if (!last || line == 0) return {};
    const nlohmann::json block =
        nlohmann::json::parse(last->back() == '}' ? *last : *last + "}", nullptr, false);
    return block.is_object() && count_field(block, "line") == line ? text_field(block, "file")
                                                                   : std::string();
}

}  // namespace polyturn::supervisor
