#include "kernel/supervisor/check/wait_match.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace polyturn::supervisor {

namespace {

std::string place_text(unsigned channel, const WaitPoint& wait) {
    return fmt::format("L{} {}:{}", channel, std::filesystem::path(wait.file).filename().string(),
                       wait.line);
}

const std::string& written(const WaitPoint& wait) {
    return wait.written.empty() ? wait.code : wait.written;
}

std::string set_text(std::uint32_t set) {
    std::string out;
    for (unsigned channel = 1; channel <= 32; ++channel)
        if (set & (1u << (channel - 1)))
            out += fmt::format("{}L{}", out.empty() ? "" : " ", channel);
    return out;
}

std::uint32_t bit_of(unsigned channel) { return 1u << (channel - 1); }

const std::string kProgramEnd = "WAITE";  // a wait that the end of the others' programs opens

}  // namespace

void WaitMatcher::arrive(unsigned channel, WaitPoint wait) {
    Track& track = tracks_[channel];
    track.waits.push_back(std::move(wait));
    if (track.next + 1 == track.waits.size()) track.arrived = ++clock_;
}

void WaitMatcher::begin(unsigned channel) {
    Track& track = tracks_[channel];
    track.ended = track.broken = false;
    track.markers.erase(kProgramEnd);
}

void WaitMatcher::mark(unsigned channel, const std::string& code) {
    tracks_[channel].markers.insert(code);
}

void WaitMatcher::end(unsigned channel, bool broken) {
    tracks_[channel].ended = true;
    tracks_[channel].markers.insert(kProgramEnd);
    tracks_[channel].broken = broken;
}

const WaitPoint* WaitMatcher::standing(unsigned channel) const {
    const auto found = tracks_.find(channel);
    if (found == tracks_.end() || found->second.next >= found->second.waits.size()) return nullptr;
    return &found->second.waits[found->second.next];
}

bool WaitMatcher::stands(unsigned channel) const { return standing(channel) != nullptr; }

bool WaitMatcher::comes_to(unsigned channel, const std::string& code) const {
    const auto found = tracks_.find(channel);
    if (found == tracks_.end()) return false;
    const Track& track = found->second;
    return std::any_of(track.waits.begin() + static_cast<std::ptrdiff_t>(track.next),
                       track.waits.end(), [&](const WaitPoint& wait) { return wait.code == code; });
}

void WaitMatcher::advance(unsigned channel) {
    Track& track = tracks_[channel];
    ++track.next;
    if (track.next < track.waits.size()) track.arrived = ++clock_;
}

std::vector<unsigned> WaitMatcher::meet() {
    std::vector<unsigned> released;
    for (bool again = true; again;) {
        again = false;
        for (const auto& [channel, track] : tracks_) {
            const WaitPoint* wait = standing(channel);
            if (!wait) continue;
            const std::uint32_t set = wait->set | bit_of(channel);
            std::uint32_t here = 0, marked = 0;
            for (const auto& [other, one] : tracks_) {
                const WaitPoint* there = standing(other);
                if (wait->code == kProgramEnd && other != channel)
                    marked |= one.ended ? set & bit_of(other) : 0u;
                else if (there && (set & bit_of(other)) && there->code == wait->code &&
                         (there->set | bit_of(other)) == set)
                    here |= bit_of(other);
                else if ((set & bit_of(other)) && one.markers.count(wait->code))
                    marked |= bit_of(other);
            }
            if ((here | marked) != set) continue;
            // a set of one channel passes at once and is no rendezvous
            if (set != bit_of(channel) && wait->code != kProgramEnd) ++meetings_;
            const std::string code = wait->code;
            for (unsigned other = 1; other <= 32; ++other)
                if (here & bit_of(other)) {
                    tracks_[other].markers.erase(code);
                    advance(other);
                    released.push_back(other);
                }
            again = true;
            break;
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
            const auto from =
                other_track.waits.begin() + static_cast<std::ptrdiff_t>(other_track.next);
            const auto at = std::find_if(from, other_track.waits.end(),
                                         [&](const WaitPoint& w) { return w.code == wait->code; });
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
            const auto at = std::find_if(
                other.waits.begin() + static_cast<std::ptrdiff_t>(other.next), other.waits.end(),
                [&](const WaitPoint& w) { return w.code == wait->code; });
            const bool stands_there =
                at == other.waits.begin() + static_cast<std::ptrdiff_t>(other.next);
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
        // Repaired by taking this code's next occurrence out of every channel.
        const std::string code = wait->code;
        for (const unsigned member : members) {
            Track& other = tracks_[member];
            const auto at =
                std::find_if(other.waits.begin() + static_cast<std::ptrdiff_t>(other.next),
                             other.waits.end(), [&](const WaitPoint& w) { return w.code == code; });
            other.waits.erase(at);
        }
        faults.push_back(std::move(fault));
        return true;
    }
    return false;
}

bool WaitMatcher::report_missing(std::vector<WaitFault>& faults) {
    for (const auto& [channel, track] : tracks_) {
        const WaitPoint* wait = standing(channel);
        if (!wait) continue;
        for (unsigned partner = 1; partner <= 32; ++partner) {
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
            // Repaired by taking the code out of every channel that has it next with this set.
            const std::string code = wait->code;
            const std::uint32_t set = wait->set;
            for (auto& [other, other_track] : tracks_) {
                const auto at = std::find_if(
                    other_track.waits.begin() + static_cast<std::ptrdiff_t>(other_track.next),
                    other_track.waits.end(), [&](const WaitPoint& w) { return w.code == code; });
                if (at != other_track.waits.end() && (set & bit_of(other)))
                    other_track.waits.erase(at);
            }
            faults.push_back(std::move(fault));
            return true;
        }
    }
    return false;
}

bool WaitMatcher::report_cycle(std::vector<WaitFault>& faults) {
    // Every partner will come; so each stopped channel waits for one that is at another code.
    // Follow that until it closes.
    unsigned at = 0;
    for (const auto& [channel, track] : tracks_)
        if (standing(channel)) {
            at = channel;
            break;
        }
    if (!at) return false;
    std::vector<unsigned> way;
    while (std::find(way.begin(), way.end(), at) == way.end()) {
        way.push_back(at);
        const WaitPoint* wait = standing(at);
        unsigned next = 0;
        for (const auto& [other, track] : tracks_) {
            const WaitPoint* there = standing(other);
            if (other != at && (wait->set & bit_of(other)) && there && there->code != wait->code) {
                next = other;
                break;
            }
        }
        if (!next) return false;
        at = next;
    }
    way.erase(way.begin(), std::find(way.begin(), way.end(), at));
    WaitFault fault;
    fault.diagnosis.alarm = Alarm::SyncCycle;
    std::string text = "deadlock:";
    std::uint64_t latest = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
        const unsigned channel = way[i], partner = way[(i + 1) % way.size()];
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
    // Repaired by taking every code of the cycle out of all channels once.
    std::set<std::string> codes;
    for (const auto& [channel, wait] : fault.places) codes.insert(wait.code);
    for (const auto& code : codes)
        for (auto& [other, track] : tracks_) {
            const auto found =
                std::find_if(track.waits.begin() + static_cast<std::ptrdiff_t>(track.next),
                             track.waits.end(), [&](const WaitPoint& w) { return w.code == code; });
            if (found != track.waits.end()) track.waits.erase(found);
        }
    faults.push_back(std::move(fault));
    return true;
}

bool WaitMatcher::drop_open_end() {
    // What is left waits for a program that ended with an alarm: nothing can be said about it.
    for (auto& [channel, track] : tracks_)
        if (standing(channel)) {
            ++track.next;
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
