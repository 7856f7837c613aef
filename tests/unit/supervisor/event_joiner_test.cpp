// Events leave in the order of t, channel, sequence, each once, moves with their end; whatever the
// order in which the kernel reports.
#include "kernel/supervisor/base/event_joiner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/property.hpp"

namespace polyturn::supervisor {
namespace {

struct Out {
    std::vector<std::string> lines;
    EventJoiner::Sink sink = [this](const EventJoiner::Event& event) {
        lines.push_back(event.text);
    };
};

TEST(EventJoiner, AMoveWaitsForItsEndAndHoldsBackWhatIsLater) {
    EventJoiner joiner;
    Out out;
    (void)joiner.note(1, 1, R"({"ev":"move","ch":1})");
    (void)joiner.note(2, 1, R"({"ev":"aux","ch":2,"code":"M8"})");
    EXPECT_EQ(joiner.begin(1, 1, 0.0), R"({"ev":"move","ch":1,"t":0})");
    joiner.begin(2, 1, 1.0);
    joiner.drain(3.0, out.sink);
    EXPECT_TRUE(out.lines.empty());
    joiner.end(1, 1, 5.25);
    joiner.drain(3.0, out.sink);
    EXPECT_EQ(out.lines, (std::vector<std::string>{R"({"ev":"move","ch":1,"t":0,"end":5.25})",
                                                   R"({"ev":"aux","ch":2,"code":"M8","t":1})"}));
}

// The kernel's own alarms know the line of a block: in which file it stands, a subprogram's
// perhaps, the block that began last says.
TEST(EventJoiner, ALineIsOfTheFileInWhichItsBlockBegan) {
    EventJoiner joiner;
    (void)joiner.note(1, 1, R"({"ev":"move","file":"/p/O\"9.nc","line":63,"ch":1})");
    EXPECT_EQ(joiner.file_of(1, 63), "");
    joiner.begin(1, 1, 0.0);
    EXPECT_EQ(joiner.file_of(1, 63), "/p/O\"9.nc");
    EXPECT_EQ(joiner.file_of(1, 6), "") << "another block";
    EXPECT_EQ(joiner.file_of(2, 63), "");
}

TEST(EventJoiner, ASkipMoveIsToldWithThePointAtWhichItEnded) {
    EventJoiner joiner;
    Out out;
    (void)joiner.note(1, 1, R"({"ev":"move","kind":"skip","pos":20})");
    joiner.begin(1, 1, 0.5);
    joiner.end(1, 1, 1.5);
    joiner.drain(9.0, out.sink);
    EXPECT_TRUE(out.lines.empty());
    (void)joiner.note(1, 1, R"({"ev":"move","kind":"skip","pos":30})");
    joiner.drain(9.0, out.sink);
    EXPECT_EQ(
        out.lines,
        (std::vector<std::string>{R"({"ev":"move","kind":"skip","pos":30,"t":0.5,"end":1.5})"}));
}

TEST(EventJoiner, ASkipMoveThatNobodyDescribesAgainIsNotLost) {
    EventJoiner joiner;
    Out out;
    (void)joiner.note(1, 1, R"({"ev":"move","kind":"skip"})");
    (void)joiner.note(1, 2, R"({"ev":"move","kind":"rapid"})");
    joiner.begin(1, 1, 0.5);
    joiner.end(1, 1, 1.5);
    joiner.begin(1, 2, 2.0);
    joiner.drain(2.0, out.sink);
    EXPECT_EQ(out.lines.size(), 1u);
    joiner.close_channel(1, 3.0);
    joiner.drain(9.0, out.sink);
    EXPECT_EQ(out.lines.size(), 2u);
}

TEST(EventJoiner, WhatMayStillComeEarlierHoldsBack) {
    EventJoiner joiner;
    Out out;
    joiner.plain(2, 1.0, R"({"ev":"flag"})");
    joiner.drain(1.0, out.sink);  // an event of channel 1 at t 1 would come first
    EXPECT_TRUE(out.lines.empty());
    joiner.plain(1, 1.0, R"({"ev":"stop"})");
    joiner.drain(1.001, out.sink);
    EXPECT_EQ(out.lines,
              (std::vector<std::string>{R"({"ev":"stop","t":1})", R"({"ev":"flag","t":1})"}));
}

// Notes cross in a ring of their own: in virtual time the next start's are here before the log
// tells of the reset.
TEST(EventJoiner, NotesOfTheNextStartOutlastAResetThatIsToldAfterThem) {
    EventJoiner joiner;
    Out out;
    (void)joiner.note(1, 1, R"({"ev":"move"})");
    (void)joiner.note(1, 2, R"({"ev":"move","n":2})");
    joiner.begin(1, 1, 0.5);
    (void)joiner.note(1, 3, R"({"ev":"aux","n":3})");
    joiner.close_channel(1, 0.75);
    joiner.begin(1, 3, 2.0);
    joiner.finish(out.sink);
    EXPECT_EQ(out.lines, (std::vector<std::string>{R"({"ev":"move","t":0.5,"end":0.75})",
                                                   R"({"ev":"aux","n":3,"t":2})"}));
}

TEST(EventJoiner, AResetEndsWhatWasUnderWay) {
    EventJoiner joiner;
    Out out;
    (void)joiner.note(1, 1, R"({"ev":"move"})");
    (void)joiner.note(1, 2, R"({"ev":"move","n":2})");
    joiner.begin(1, 1, 0.5);
    joiner.close_channel(1, 0.75);
    joiner.finish(out.sink);
    EXPECT_EQ(out.lines, (std::vector<std::string>{R"({"ev":"move","t":0.5,"end":0.75})"}));
}

TEST(EventJoiner, WhatNeverEndedIsGivenOutWithoutAnEnd) {
    EventJoiner joiner;
    Out out;
    (void)joiner.note(1, 7, R"({"ev":"dwell","seconds":9})");
    joiner.begin(1, 7, 2.0);
    joiner.finish(out.sink);
    EXPECT_EQ(out.lines, (std::vector<std::string>{R"({"ev":"dwell","seconds":9,"t":2})"}));
}

TEST(EventJoiner, NotesThatWereSkippedAreDropped) {
    EventJoiner joiner;
    Out out;
    for (int i = 1; i <= 3; ++i)
        (void)joiner.note(1, static_cast<std::uint64_t>(i), R"({"ev":"aux"})");
    joiner.begin(1, 3, 1.0);
    EXPECT_TRUE(joiner.begin(1, 1, 1.0).empty());
    joiner.finish(out.sink);
    EXPECT_EQ(out.lines.size(), 1u);
}

PROPERTY(EventJoiner, EveryEventOnceInOrderWhateverTheDrains, ()) {
    struct Block {
        unsigned channel;
        std::uint64_t number;
        int begin, end;
    };
    // Blocks of a channel follow one another; channels overlap as they like.
    std::vector<Block> blocks;
    for (unsigned channel = 1; channel <= 3; ++channel) {
        int t = *rc::gen::inRange(0, 5);
        const int count = *rc::gen::inRange(0, 15);
        for (int i = 0; i < count; ++i) {
            const int duration = *rc::gen::inRange(0, 6);
            blocks.push_back({channel, static_cast<std::uint64_t>(i + 1), t, t + duration});
            t += duration + *rc::gen::inRange(0, 3);
        }
    }
    EventJoiner joiner;
    std::vector<std::pair<double, unsigned>> order;
    const EventJoiner::Sink sink = [&](const EventJoiner::Event& event) {
        order.emplace_back(event.t_s, event.channel);
        RC_ASSERT(event.text.find("\"end\":") != std::string::npos);
    };
    for (const Block& block : blocks)
        (void)joiner.note(block.channel, block.number, R"({"ev":"move"})");
    for (int tick = 0; tick <= 200; ++tick) {
        // in the log a block's end stands before the next one's begin
        for (const Block& block : blocks) {
            if (block.end == tick && block.begin != tick)
                joiner.end(block.channel, block.number, tick);
            if (block.begin == tick) joiner.begin(block.channel, block.number, tick);
            if (block.end == tick && block.begin == tick)
                joiner.end(block.channel, block.number, tick);
        }
        joiner.drain(tick, sink);
    }
    RC_ASSERT(order.size() == blocks.size());
    RC_ASSERT(std::is_sorted(order.begin(), order.end()));
}

}  // namespace
}  // namespace polyturn::supervisor
