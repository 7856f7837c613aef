// Waits of several programs: every fault named once, and for random programs the same verdict as a
// model of twenty lines.
#include "kernel/supervisor/check/wait_match.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/property.hpp"

namespace polyturn::supervisor {
namespace {

struct Planned {
    std::int32_t code;
    std::uint32_t set;
};
using Programs = std::map<unsigned, std::vector<Planned>>;

WaitMatcher matcher_of(const Programs& programs) {
    WaitMatcher matcher;
    for (const auto& [channel, waits] : programs) {
        matcher.begin(channel);
        std::uint32_t line = 0;
        for (const Planned& wait : waits)
            matcher.arrive(channel,
                           {wait.code, wait.set, "O" + std::to_string(channel), ++line * 10});
        matcher.end(channel, false);
    }
    return matcher;
}

std::vector<Alarm> faults_of(const Programs& programs, std::size_t* meetings = nullptr) {
    WaitMatcher matcher = matcher_of(programs);
    std::vector<Alarm> out;
    for (const WaitFault& fault : matcher.find_faults()) out.push_back(fault.diagnosis.alarm);
    if (meetings) *meetings = matcher.meetings();
    return out;
}

TEST(WaitMatch, FitsTogether) {
    std::size_t meetings = 0;
    EXPECT_TRUE(faults_of({{1, {{501, 3}, {502, 3}, {501, 3}}},
                           {2, {{501, 3}, {502, 3}, {501, 3}}}},
                          &meetings)
                    .empty());
    EXPECT_EQ(meetings, 3u);
    // Three channels, as nct_parameters_part2 23.4: the third comes first and waits.
    EXPECT_TRUE(
        faults_of(
            {{1, {{520, 3}, {521, 7}}}, {2, {{520, 3}, {521, 7}}}, {3, {{521, 7}}}},
            &meetings)
            .empty());
    EXPECT_EQ(meetings, 2u);
    // only itself: passes at once
    EXPECT_TRUE(faults_of({{1, {{501, 1}}}, {2, {}}}, &meetings).empty());
    EXPECT_EQ(meetings, 0u);
}

// WAITE, START, WAITE: the end of the first program does not open the second wait.
TEST(WaitMatch, AProgramMayFollowAnother) {
    WaitMatcher matcher;
    matcher.begin(1);
    matcher.begin(2);
    matcher.arrive(1, {kernel::WaitBoard::kProgramEnd, 3, "O1", 10});
    EXPECT_TRUE(matcher.meet().empty());
    matcher.end(2, false);
    EXPECT_EQ(matcher.meet(), std::vector<unsigned>{1});
    matcher.begin(2);
    matcher.arrive(1, {kernel::WaitBoard::kProgramEnd, 3, "O1", 20});
    EXPECT_TRUE(matcher.meet().empty());
    matcher.end(2, false);
    EXPECT_EQ(matcher.meet(), std::vector<unsigned>{1});
}

TEST(WaitMatch, EachFaultIsNamedOnce) {
    using A = Alarm;
    const std::pair<Programs, std::vector<Alarm>> rows[] = {
        {{{1, {{501, 3}, {502, 3}}}, {2, {{502, 3}, {501, 3}}}}, {A::SyncCycle}},
        {{{1, {{501, 3}}}, {2, {}}}, {A::SyncUnpaired}},
        {{{1, {{501, 3}, {502, 3}}}, {2, {{502, 3}}}}, {A::SyncUnpaired}},
        {{{1, {{501, 5}}}, {2, {}}}, {A::SyncAbsent}},
        {{{1, {{501, 3}}}, {2, {{501, 7}}}, {3, {{501, 7}}}}, {A::SyncDifferentSets}},
        {{{1, {{501, 3}, {503, 3}}}, {2, {{501, 1 | 2 | 4}, {503, 3}}}, {3, {}}},
         {A::SyncDifferentSets}},
        // 1 waits for 2, 2 for 3, 3 for 1, and everybody would come later.
        {{{1, {{501, 3}, {503, 5}}},
          {2, {{502, 6}, {501, 3}}},
          {3, {{503, 5}, {502, 6}}}},
         {A::SyncCycle}},
        // Two independent faults.
        {{{1, {{501, 3}, {502, 3}, {509, 3}}}, {2, {{502, 3}, {501, 3}}}},
         {A::SyncCycle, A::SyncUnpaired}},
    };
    for (std::size_t i = 0; i < std::size(rows); ++i) {
        SCOPED_TRACE(i);
        EXPECT_EQ(faults_of(rows[i].first), rows[i].second);
    }
}

TEST(WaitMatch, AFaultNamesChannelsProgramsAndLines) {
    WaitMatcher matcher =
        matcher_of({{1, {{501, 3}, {502, 3}}}, {2, {{502, 3}, {501, 3}}}});
    const auto faults = matcher.find_faults();
    ASSERT_EQ(faults.size(), 1u);
    const std::string text = faults[0].diagnosis.text();
    for (const char* word : {"L1", "L2", "O1:10", "O2:10", "M501", "M502"})
        EXPECT_NE(text.find(word), std::string::npos) << word << " in " << text;
    EXPECT_EQ(faults[0].channel, 2u);  // it came last
    EXPECT_EQ(faults[0].places.size(), 2u);
}

TEST(WaitMatch, NothingIsSaidAboutWhatFollowsAnAlarm) {
    WaitMatcher matcher;
    matcher.begin(1);
    matcher.begin(2);
    matcher.arrive(1, {501, 3, "O1", 1});
    matcher.end(1, false);
    matcher.end(2, true);
    EXPECT_TRUE(matcher.find_faults().empty());
}

// The obvious model: let everybody whose set is complete go on, until nothing moves. Right when all
// are through.
bool model_fits(Programs programs, std::size_t& meetings) {
    std::map<unsigned, std::size_t> next;
    meetings = 0;
    for (bool moved = true; moved;) {
        moved = false;
        for (const auto& [channel, waits] : programs) {
            if (next[channel] >= waits.size()) continue;
            const Planned wait = waits[next[channel]];
            bool complete = true;
            for (unsigned other = 1; other <= 8; ++other) {
                if (!(wait.set >> (other - 1) & 1u)) continue;
                const auto found = programs.find(other);
                complete = complete && found != programs.end() &&
                           next[other] < found->second.size() &&
                           found->second[next[other]].code == wait.code &&
                           found->second[next[other]].set == wait.set;
            }
            if (!complete) continue;
            for (unsigned other = 1; other <= 8; ++other)
                if (wait.set >> (other - 1) & 1u) ++next[other];
            if (wait.set & (wait.set - 1)) ++meetings;
            moved = true;
            break;
        }
    }
    for (const auto& [channel, waits] : programs)
        if (next[channel] < waits.size()) return false;
    return true;
}

PROPERTY(WaitMatch, AgreesWithTheModel, ()) {
    static constexpr std::int32_t kCodes[] = {501, 502, 503};
    Programs programs;
    const unsigned channels = *rc::gen::inRange(2u, 5u);
    for (unsigned channel = 1; channel <= channels; ++channel) programs[channel];
    const int steps = *rc::gen::inRange(0, 12);
    for (int i = 0; i < steps; ++i) {
        // Mostly meetings that fit; then a mistake is made now and then.
        const std::int32_t code = kCodes[*rc::gen::inRange(0, 3)];
        const auto set = *rc::gen::inRange(1u, 1u << channels);
        for (unsigned channel = 1; channel <= channels; ++channel) {
            if (!(set >> (channel - 1) & 1u)) continue;
            const int luck = *rc::gen::inRange(0, 20);
            if (luck == 0) continue;                                                 // forgotten
            const std::uint32_t own = luck == 1 ? set | 1u << (channels - 1) : set;  // another set
            programs[channel].push_back({luck == 2 ? kCodes[0] : code, own | 1u << (channel - 1)});
        }
    }
    std::size_t wanted = 0, meetings = 0;
    const bool fits = model_fits(programs, wanted);
    const auto faults = faults_of(programs, &meetings);
    RC_ASSERT(faults.empty() == fits);
    if (fits) RC_ASSERT(meetings == wanted);
}

TEST(WaitMatch, TakesAMarkerForAnArrival) {
    WaitMatcher matcher;
    matcher.begin(1);
    matcher.begin(2);
    matcher.mark(1, 7);
    matcher.arrive(2, {7, 3, "B", 1});
    EXPECT_EQ(matcher.meet(), std::vector<unsigned>{2});
    matcher.end(1, false);
    matcher.end(2, false);
    EXPECT_TRUE(matcher.find_faults().empty());
}

}  // namespace
}  // namespace polyturn::supervisor
