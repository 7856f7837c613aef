#include "kernel/supervisor/check/wait_match.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "ipc/model/languages/wait_name.hpp"

namespace polyturn::supervisor {

namespace {

std::string place_text(unsigned channel, const WaitPoint& wait) {
    return fmt::format("L{} {}:{}", channel, std::filesystem::path(wait.file).filename().string(),
                       wait.line);
}

std::string written(const WaitPoint& wait) {
    return wait.written.empty() ? wait_name(Dialect::Fanuc, wait.code) : wait.written;
}

std::string set_text(std::uint32_t set) {
    std::string out;
    for (unsigned channel = 1; channel <= kMaxChannels; ++channel)
        if (set & (1u << (channel - 1)))
            out += fmt::format("{}L{}", out.empty() ? "" : " ", channel);
    return out;
}

std::uint32_t bit_of(unsigned channel) { return 1u << (channel - 1); }

constexpr std::int32_t kProgramEnd = kernel::WaitBoard::kProgramEnd;

}  // namespace

std::vector<WaitPoint>::iterator WaitMatcher::Track::coming(std::int32_t code) {
    return std::find_if(here(), waits.end(), [&](const WaitPoint& w) { return w.code == code; });
}

std::vector<WaitPoint>::const_iterator WaitMatcher::Track::coming(std::int32_t code) const {
    return std::find_if(here(), waits.end(), [&](const WaitPoint& w) { return w.code == code; });
}

// The board sees the channel at its next wait, as ended when it has none and its text is read, and
// else on its way.
void WaitMatcher::place(unsigned channel) {
    const Track& track = tracks_[channel];
    const WaitPoint* wait = standing(channel);
    board_.leave(channel - 1);
    board_.tell(channel - 1, {.live = !track.ended, .ended = track.ended && !wait});
    if (wait) board_.arrive(channel - 1, wait->code, wait->set | bit_of(channel));
}

void WaitMatcher::arrive(unsigned channel, WaitPoint wait) {
    Track& track = tracks_[channel];
    track.waits.push_back(std::move(wait));
    if (track.next + 1 != track.waits.size()) return;
    track.arrived = ++clock_;
    place(channel);
}

void WaitMatcher::begin(unsigned channel) {
    Track& track = tracks_[channel];
    track.ended = track.broken = false;
    place(channel);
}

void WaitMatcher::mark(unsigned channel, std::int32_t code) {
    board_.mark(channel - 1, code, true);
}

void WaitMatcher::end(unsigned channel, bool broken) {
    tracks_[channel].ended = true;
    tracks_[channel].broken = broken;
    place(channel);
}

const WaitPoint* WaitMatcher::standing(unsigned channel) const {
    const auto found = tracks_.find(channel);
    if (found == tracks_.end() || found->second.next >= found->second.waits.size()) return nullptr;
    return &found->second.waits[found->second.next];
}

bool WaitMatcher::stands(unsigned channel) const { return standing(channel) != nullptr; }

// Every program comes to its end, once nothing in front of it is in the way.
bool WaitMatcher::comes_to(unsigned channel, std::int32_t code) const {
    const auto found = tracks_.find(channel);
    if (found == tracks_.end()) return false;
    const Track& track = found->second;
    return code == kProgramEnd || track.coming(code) != track.waits.end();
}

void WaitMatcher::advance(unsigned channel) {
    Track& track = tracks_[channel];
    ++track.next;
    if (track.next < track.waits.size()) track.arrived = ++clock_;
    place(channel);
}

// A fault is repaired by taking the next wait at this code out of the program.
void WaitMatcher::take_out(unsigned channel, std::int32_t code) {
    Track& track = tracks_[channel];
    if (const auto at = track.coming(code); at != track.waits.end()) track.waits.erase(at);
    place(channel);
}

std::vector<unsigned> WaitMatcher::meet() {
    std::vector<unsigned> released;
    while (kernel::ChannelSet leave = board_.release(0)) {
        for (unsigned first = 1; first <= kMaxChannels; ++first) {
            if (!(leave & bit_of(first))) continue;
            const WaitPoint wait = *standing(first);
            const std::uint32_t set = wait.set | bit_of(first);
            // a set of one channel passes at once and is no rendezvous
            if (set != bit_of(first) && wait.code != kProgramEnd) ++meetings_;
            for (unsigned other = first; other <= kMaxChannels; ++other) {
                if (!(leave & bit_of(other))) continue;
                const WaitPoint& there = *standing(other);
                const bool same = there.code == wait.code && (there.set | bit_of(other)) == set;
                if (other != first && !same) continue;
                leave &= ~bit_of(other);
                released.push_back(other);
                advance(other);
            }
        }
    }
    return released;
}

bool WaitMatcher::report_different_sets(std::vector<WaitFault>& faults) {
    for (const auto& [channel, track] : tracks_) {
        const WaitPoint* wait = standing(channel);
        if (!wait || wait->code == kProgramEnd) continue;
        // A partner that is at the same code with another set, or will next come to it with
        // another one.
        std::vector<unsigned> members;
        bool different = false;
        for (const auto& [other, other_track] : tracks_) {
            const auto at = other_track.coming(wait->code);
            if (at == other_track.waits.end()) continue;
            members.push_back(other);
            different = different || (at->set | bit_of(other)) != (wait->set | bit_of(channel));
        }
        if (!different) continue;
        WaitFault fault;
        std::string text =
            fmt::format("waiting code {} with different sets of channels:", written(*wait));
        std::uint64_t latest = 0;
        for (const unsigned member : members) {
            const Track& other = tracks_[member];
            const auto at = other.coming(wait->code);
            const bool stands_there = at == other.here();
            fault.places.emplace_back(member, *at);
            text += fmt::format("{} {} waits for {}", fault.places.size() > 1 ? "," : "",
                                place_text(member, *at), set_text(at->set | bit_of(member)));
            const std::uint64_t when = stands_there ? other.arrived : UINT64_MAX;
            if (when >= latest) {
                latest = when;
                fault.channel = member;
                fault.diagnosis.place = Place{at->file, at->line, 0, 0};
            }
        }
        fault.diagnosis.alarm = Alarm::SyncDifferentSets;
        fault.diagnosis.detail = std::move(text);
        const std::int32_t code = wait->code;
        for (const unsigned member : members) take_out(member, code);
        faults.push_back(std::move(fault));
        return true;
    }
    return false;
}

bool WaitMatcher::report_missing(std::vector<WaitFault>& faults) {
    for (const auto& [channel, track] : tracks_) {
        const WaitPoint* wait = standing(channel);
        if (!wait) continue;
        for (unsigned partner = 1; partner <= kMaxChannels; ++partner) {
            if (!(wait->set & bit_of(partner)) || partner == channel ||
                comes_to(partner, wait->code))
                continue;
            const auto found = tracks_.find(partner);
            if (found != tracks_.end() && found->second.broken) continue;  // its alarm says why
            WaitFault fault;
            fault.channel = channel;
            fault.places.emplace_back(channel, *wait);
            fault.diagnosis.place = Place{wait->file, wait->line, 0, 0};
            if (found == tracks_.end()) {
                fault.diagnosis.alarm = Alarm::SyncAbsent;
                fault.diagnosis.detail =
                    fmt::format("{} waits at {} for L{}, which has no program",
                                place_text(channel, *wait), written(*wait), partner);
            } else {
                fault.diagnosis.alarm = Alarm::SyncUnpaired;
                std::string why = "its program ends without it";
                if (const WaitPoint* there = standing(partner)) {
                    why = fmt::format("its program stands at {} in line {} and has no {} after it",
                                      written(*there), there->line, written(*wait));
                    fault.places.emplace_back(partner, *there);
                }
                fault.diagnosis.detail =
                    fmt::format("{} waits at {} for L{}, which never comes: {}",
                                place_text(channel, *wait), written(*wait), partner, why);
            }
            const std::int32_t code = wait->code;
            const std::uint32_t set = wait->set;
            for (const auto& [other, other_track] : tracks_)
                if (set & bit_of(other)) take_out(other, code);
            faults.push_back(std::move(fault));
            return true;
        }
    }
    return false;
}

bool WaitMatcher::report_cycle(std::vector<WaitFault>& faults) {
    // Every partner will come; so each stopped channel waits for one that is at another code, and
    // following that from any of them leads into a ring.
    kernel::WaitBoard::Ring ring;
    for (unsigned channel = 1; channel <= kMaxChannels && ring.count == 0; ++channel)
        if (standing(channel)) ring = board_.deadlock(channel - 1, 0);
    if (ring.count == 0) return false;
    WaitFault fault;
    fault.diagnosis.alarm = Alarm::SyncCycle;
    std::string text = "deadlock:";
    std::uint64_t latest = 0;
    for (unsigned i = 0; i < ring.count; ++i) {
        const unsigned channel = ring.channel[i] + 1u,
                       partner = ring.channel[(i + 1) % ring.count] + 1u;
        const WaitPoint& wait = *standing(channel);
        text += fmt::format("{} {} waits at {} for L{}", i ? "," : "", place_text(channel, wait),
                            written(wait), partner);
        fault.places.emplace_back(channel, wait);
        const Track& track = tracks_[channel];
        if (track.arrived >= latest) {
            latest = track.arrived;
            fault.channel = channel;
            fault.diagnosis.place = Place{wait.file, wait.line, 0, 0};
        }
    }
    fault.diagnosis.detail = std::move(text);
    // repaired by taking every code of the ring out of all channels once
    std::set<std::int32_t> codes;
    for (const auto& [channel, wait] : fault.places) codes.insert(wait.code);
    for (const std::int32_t code : codes)
        for (const auto& [other, track] : tracks_) take_out(other, code);
    faults.push_back(std::move(fault));
    return true;
}

bool WaitMatcher::drop_open_end() {
    // What is left waits for a program that ended with an alarm: nothing can be said about it.
    for (auto& [channel, track] : tracks_)
        if (standing(channel)) {
            ++track.next;
            place(channel);
            return true;
        }
    return false;
}

std::vector<WaitFault> WaitMatcher::find_faults() {
    std::vector<WaitFault> faults;
    for (;;) {
        meet();
        if (report_different_sets(faults) || report_missing(faults) || report_cycle(faults))
            continue;
        if (!drop_open_end()) return faults;
    }
}

}  // namespace polyturn::supervisor
