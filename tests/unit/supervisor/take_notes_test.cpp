// A channel's notes in the hands of a channel that writes what it likes: the supervisor neither
// leaves the ring nor is kept busy, takes nothing that could pass for another's event, and holds no
// more than it must.
#include "kernel/supervisor/take_notes.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <memory>
#include <random>

namespace polyturn::supervisor {
namespace {

// A ring whose last byte is the last one before a page that nobody may read.
class GuardedRing {
public:
    GuardedRing() {
        const std::size_t page = 4096, whole = (sizeof(NoteHead) + page - 1) / page * page;
        base_ = static_cast<char*>(mmap(nullptr, whole + page, PROT_READ | PROT_WRITE,
                                        MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
        size_ = whole + page;
        mprotect(base_ + whole, page, PROT_NONE);
        ring_ = new (base_ + whole - sizeof(NoteHead)) NoteHead;
    }
    ~GuardedRing() { munmap(base_, size_); }
    GuardedRing(const GuardedRing&) = delete;
    GuardedRing& operator=(const GuardedRing&) = delete;
    NoteHead& operator*() const { return *ring_; }
    NoteHead* operator->() const { return ring_; }

private:
    char* base_ = nullptr;
    std::size_t size_ = 0;
    NoteHead* ring_ = nullptr;
};

bool take(const NoteHead& ring, std::atomic<std::uint64_t>& tail, EventJoiner& joiner) {
    std::string text;
    bool moved = false;
    return take_ring(ring, tail, 1, joiner, text, moved);
}

TEST(TakeNotes, WhatIsWrittenComesRoundTheRing) {
    GuardedRing ring;
    std::atomic<std::uint64_t> tail{0};
    NoteWriter writer(*ring, tail);
    EventJoiner joiner;
    std::mt19937 random(5);
    std::uint64_t number = 0;
    for (int round = 0; round < 200; ++round) {
        for (int i = 0; i < 40; ++i) {
            const std::string text =
                R"({"ev":"aux","ch":1,"x":")" + std::string(random() % 3000, 'x') + "\"}\n";
            if (!writer.push(++number, text)) break;
        }
        ASSERT_TRUE(take(*ring, tail, joiner)) << round;
        ASSERT_EQ(tail.load(), ring->head.load());
        ASSERT_FALSE(joiner.begin(1, number, 1.0).empty()) << "the newest one is there";
        joiner.discard();
    }
    EXPECT_GT(tail.load(), 3 * kNoteRing);
}

TEST(TakeNotes, AHeadOrASizeThatCannotBeEndsTheReading) {
    GuardedRing ring;
    std::atomic<std::uint64_t> tail{64};
    EventJoiner joiner;
    ring->bytes.fill(0);
    for (const std::uint64_t head :
         {std::uint64_t{0}, std::uint64_t{8}, std::uint64_t{65}, 64 + kNoteRing + 8,
          ~std::uint64_t{0}, ~std::uint64_t{0} - 7}) {
        ring->head = head;
        EXPECT_FALSE(take(*ring, tail, joiner)) << head;
        EXPECT_EQ(tail.load(), 64u);
    }
    // Sizes that lead out of what was written, out of the ring, out of the segment.
    tail = kNoteRing - 16;
    for (const std::uint32_t size :
         {2u, 100u, static_cast<std::uint32_t>(kNoteRing / 4 + 2), 0x7fffffffu, 0xffffffffu}) {
        std::memcpy(&ring->bytes[kNoteRing - 16], &size, 4);
        for (const std::uint64_t ahead : {std::uint64_t{8}, std::uint64_t{16}}) {
            ring->head = tail + ahead;
            EXPECT_FALSE(take(*ring, tail, joiner)) << size << " " << ahead;
        }
    }
    // Nothing but zeros: the rest is skipped once and not for ever.
    tail = 8;
    ring->bytes.fill(0);
    ring->head = 8 + kNoteRing;
    EXPECT_FALSE(take(*ring, tail, joiner));
}

TEST(TakeNotes, RandomBytesHurtNobody) {
    GuardedRing ring;
    std::mt19937_64 random(41);
    std::atomic<std::uint64_t> tail{0};
    for (std::size_t i = 0; i < kNoteRing; i += 8) {
        const std::uint64_t word = random();
        std::memcpy(&ring->bytes[i], &word, 8);
    }
    for (int round = 0; round < 3000; ++round) {
        EventJoiner joiner;
        tail = random() % 4 ? random() % (4 * kNoteRing) & ~std::uint64_t{7} : random();
        ring->head =
            random() % 4 ? tail.load() + (random() % kNoteRing & ~std::uint64_t{7}) : random();
        for (int k = 0; k < 64; ++k) {  // some of it looks right
            const std::uint64_t at = (tail.load() + 8 * (random() % 200)) & (kNoteRing - 8);
            const std::uint32_t size = static_cast<std::uint32_t>(random() % 40);
            std::memcpy(&ring->bytes[at], &size, 4);
        }
        const std::uint64_t before = tail.load();
        (void)take(*ring, tail, joiner);
        ASSERT_LE(tail.load() - before, kNoteRing);
        for (std::uint64_t number = 0; number < 20; ++number) {
            joiner.begin(1, random() % 100, 1.0);
            joiner.end(1, random() % 100, 2.0);
        }
        (void)joiner.file_of(1, 1);
    }
}

TEST(TakeNotes, OnlyOneObjectOfItsOwnChannelIsTaken) {
    EventJoiner joiner;
    for (const char* good :
         {"{}", R"({"ev":"move","ch":1})", "{\"ev\":\"aux\",\"ch\":1,\"text\":\"a } \\\" {\"}\n",
          R"({"ev":"sync","ch":1,"with":[{"a":[1]}]})"})
        EXPECT_TRUE(joiner.note(1, 1, good)) << good;
    for (const std::string& bad :
         {std::string(), std::string("x"), std::string("{"), std::string("[]"), std::string("{}{}"),
          std::string("{\"a\":1}\n{\"ev\":\"alarm\"}"), std::string("{\"a\":\"\n\"}"),
          std::string("{\"a\":\"}"), std::string("{\"a\":\"\\"),
          std::string(R"({"ev":"move","ch":2})"), std::string(R"({"ev":"move","ch":x})"),
          "{\"a\":" + std::string(5000, '[') + std::string(5000, ']') + "}",
          std::string("{\0}", 3)})
        EXPECT_FALSE(joiner.note(1, 1, bad)) << bad;
}

TEST(TakeNotes, AFloodIsBounded) {
    EventJoiner joiner;
    const std::string text = R"({"ev":"move","x":")" + std::string(2000, 'x') + "\"}";
    for (std::uint64_t number = 1; number <= 200'000; ++number)
        ASSERT_TRUE(joiner.note(1, number, text));
    EXPECT_TRUE(joiner.begin(1, 1, 0.0).empty()) << "the oldest has gone";
    EXPECT_FALSE(joiner.begin(1, 200'000, 0.0).empty());
    EXPECT_LE(EventJoiner::kMostBytes, std::size_t{32} << 20);
}

// One number for two blocks: what comes behind them comes out all the same.
TEST(TakeNotes, ANumberUsedTwiceHoldsNothingBack) {
    EventJoiner joiner;
    std::size_t out = 0;
    for (int i = 0; i < 2; ++i) {
        ASSERT_TRUE(joiner.note(1, 7, R"({"ev":"move"})"));
        joiner.begin(1, 7, 1.0 + i);
    }
    joiner.end(1, 7, 3.0);
    joiner.plain(2, 4.0, R"({"ev":"flag"})");
    joiner.drain(9.0, [&](const EventJoiner::Event&) { ++out; });
    EXPECT_EQ(out, 3u);
}

}  // namespace
}  // namespace polyturn::supervisor
