// Which picture holds at a block: against a plain list, with programs that are taken back and with
// more changes than are kept.
#include "ipc/image/block_pictures.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/property.hpp"

namespace polyturn {
namespace {

BlockPicture picture(std::uint64_t serial, double feed) {
    BlockPicture out{};
    out.serial = serial;
    out.feed = feed;
    return out;
}

TEST(BlockPictures, TheNewestUpToTheBlockHolds) {
    auto channel = std::make_unique<ChannelSegment>();
    BlockPicture found{};
    EXPECT_FALSE(find_picture(*channel, 5, found));
    push_picture(*channel, picture(3, 0.3));
    push_picture(*channel, picture(7, 0.7));
    EXPECT_FALSE(find_picture(*channel, 2, found)) << "nothing is known of what was before";
    ASSERT_TRUE(find_picture(*channel, 6, found));
    EXPECT_EQ(found.feed, 0.3);
    ASSERT_TRUE(find_picture(*channel, 7, found));
    EXPECT_EQ(found.feed, 0.7);
}

TEST(BlockPictures, AProgramThatWasTakenBackIsReadAnew) {
    auto channel = std::make_unique<ChannelSegment>();
    for (const double serial : {10.0, 20.0, 30.0})
        push_picture(*channel, picture(static_cast<std::uint64_t>(serial), serial));
    push_picture(*channel, picture(15, 1.5));  // taken back to 15: 20 and 30 were void
    BlockPicture found{};
    ASSERT_TRUE(find_picture(*channel, 22, found));
    EXPECT_EQ(found.feed, 1.5);
    ASSERT_TRUE(find_picture(*channel, 12, found));
    EXPECT_EQ(found.feed, 10.0);
}

TEST(BlockPictures, AnotherProgramKnowsNothingOfTheOneBefore) {
    auto channel = std::make_unique<ChannelSegment>();
    push_picture(*channel, picture(1, 1));
    channel->picture_first.store(channel->pictures.head.load());
    BlockPicture found{};
    EXPECT_FALSE(find_picture(*channel, 4, found));
}

PROPERTY(BlockPictures, AgreesWithAPlainList, ()) {
    static auto channel = std::make_unique<ChannelSegment>();
    channel->picture_first.store(channel->pictures.head.load());
    std::vector<BlockPicture> model;
    const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-3, 6));
    std::uint64_t serial = 10;
    for (const int step : steps) {
        serial = static_cast<std::uint64_t>(
            std::max<std::int64_t>(1, static_cast<std::int64_t>(serial) + step));
        model.push_back(picture(serial, static_cast<double>(model.size())));
        push_picture(*channel, model.back());
    }
    const auto wanted = *rc::gen::inRange<std::uint64_t>(0, 40);
    const BlockPicture* expected = nullptr;
    for (const BlockPicture& one : model)
        if (one.serial <= wanted) expected = &one;
    BlockPicture found{};
    RC_ASSERT(find_picture(*channel, wanted, found) == (expected != nullptr));
    if (expected) RC_ASSERT(found.feed == expected->feed);
}

// A loop of G0 and G1 in turn: each record that waits in the ring has a picture of its own, and
// some blocks have no record.
TEST(BlockPictures, AllBlocksThatAChannelIsAheadAreKnown) {
    auto channel = std::make_unique<ChannelSegment>();
    BlockPicture found;
    const std::uint64_t ahead = kPathRing + kPathRing / 4;
    for (std::uint64_t i = 1; i <= 3 * ahead; ++i) {
        push_picture(*channel, picture(i, static_cast<double>(i)));
        if (i < ahead || i % 97 != 0) continue;
        ASSERT_TRUE(find_picture(*channel, i - ahead + 1, found)) << i;
        ASSERT_EQ(found.serial, i - ahead + 1);
    }
}

TEST(BlockPictures, WhatIsNotFoundLeavesTheLastOneAsItWas) {
    auto channel = std::make_unique<ChannelSegment>();
    BlockPicture found = picture(3, 0.3);
    for (std::uint64_t i = 10; i <= 2 * kPictures; ++i)
        push_picture(*channel, picture(i, static_cast<double>(i)));
    EXPECT_FALSE(find_picture(*channel, 12, found));
    EXPECT_EQ(found.feed, 0.3);
}

TEST(BlockPictures, WhatWasWrittenOverIsNotToldAsIfItHeld) {
    auto channel = std::make_unique<ChannelSegment>();
    for (std::uint64_t i = 1; i <= 2 * kPictures; ++i)
        push_picture(*channel, picture(i, static_cast<double>(i)));
    BlockPicture found{};
    EXPECT_FALSE(find_picture(*channel, kPictures / 2, found));
    ASSERT_TRUE(find_picture(*channel, 2 * kPictures - 5, found));
    EXPECT_EQ(found.feed, static_cast<double>(2 * kPictures - 5));
}

}  // namespace
}  // namespace polyturn
