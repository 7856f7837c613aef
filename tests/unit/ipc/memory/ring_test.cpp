// Rings and notes: what one process pushes, the other takes: all of it, in order, once.
#include <gtest/gtest.h>

#include <deque>
#include <memory>
#include <string>
#include <thread>

#include "ipc/memory/note_ring.hpp"
#include "ipc/memory/spsc_ring.hpp"
#include "tests/property.hpp"

namespace polyturn {
namespace {

struct Item {
    std::uint64_t a, b;
};

TEST(SpscRing, RefusesWhenFullAndLosesNothing) {
    RingHead<Item, 4> head;
    RingTail tail;
    RingProducer producer(head, tail);
    RingConsumer consumer(head, tail);
    EXPECT_EQ(consumer.front(), nullptr);
    for (std::uint64_t i = 0; i < 4; ++i) ASSERT_TRUE(producer.push({i, ~i}));
    EXPECT_FALSE(producer.push({9, 9}));
    ASSERT_NE(consumer.front(), nullptr);
    EXPECT_EQ(consumer.front()->a, 0u);
    consumer.pop();
    EXPECT_TRUE(producer.push({4, ~4ull}));
    for (std::uint64_t i = 1; i < 5; ++i) {
        ASSERT_NE(consumer.front(), nullptr);
        EXPECT_EQ(consumer.front()->a, i);
        consumer.pop();
    }
    EXPECT_EQ(consumer.front(), nullptr);
}

TEST(SpscRing, ClaimedButNotCommittedIsNotSent) {
    RingHead<Item, 4> head;
    RingTail tail;
    RingProducer producer(head, tail);
    RingConsumer consumer(head, tail);
    *producer.claim() = {1, 1};
    EXPECT_EQ(consumer.front(), nullptr);
    ASSERT_TRUE(producer.push({2, 2}));  // the next one overwrites its slot
    EXPECT_EQ(consumer.front()->a, 2u);
}

PROPERTY(SpscRing, BehavesAsAQueue, (const std::vector<bool>& pushes)) {
    RingHead<Item, 8> head;
    RingTail tail;
    RingProducer producer(head, tail);
    RingConsumer consumer(head, tail);
    std::deque<std::uint64_t> model;
    std::uint64_t next = 0;
    for (const bool push : pushes) {
        if (push) {
            RC_ASSERT(producer.push({next, 0}) == (model.size() < 8));
            if (model.size() < 8) model.push_back(next);
            ++next;
        } else {
            const Item* front = consumer.front();
            RC_ASSERT((front == nullptr) == model.empty());
            if (!front) continue;
            RC_ASSERT(front->a == model.front());
            model.pop_front();
            consumer.pop();
        }
    }
}

TEST(SpscRing, TwoThreadsSeeEveryItemWhole) {
    auto head = std::make_unique<RingHead<Item, 64>>();
    RingTail tail;
    constexpr std::uint64_t kCount = 300'000;
    std::thread maker([&] {
        RingProducer producer(*head, tail);
        for (std::uint64_t i = 0; i < kCount;)
            if (producer.push({i, ~i}))
                ++i;
            else
                std::this_thread::yield();
    });
    RingConsumer consumer(*head, tail);
    std::uint64_t wrong = 0;
    for (std::uint64_t i = 0; i < kCount;) {
        const Item* item = consumer.front();
        if (!item) {
            std::this_thread::yield();
            continue;
        }
        wrong += item->a != i || item->b != ~i;
        consumer.pop();
        ++i;
    }
    maker.join();
    EXPECT_EQ(wrong, 0u);
}

TEST(NoteRing, CarriesTextsOfAnyLengthRoundItsEnd) {
    auto head = std::make_unique<NoteHead>();
    std::atomic<std::uint64_t> tail{0};
    NoteWriter writer(*head, tail);
    NoteReader reader(*head, tail);
    std::deque<std::string> model;
    std::uint64_t written = 0, read = 0;
    for (int round = 0; round < 40'000; ++round) {
        const std::string text(static_cast<std::size_t>((round * 7919) % 997),
                               static_cast<char>('a' + round % 26));
        if (writer.push(written, text)) {
            model.push_back(text);
            ++written;
        }
        if (round % 3 == 0 || model.size() > 1500) {
            std::uint64_t number = 0;
            std::string_view got;
            while (reader.front(number, got)) {
                ASSERT_EQ(number, read);
                ASSERT_EQ(got, model.front());
                model.pop_front();
                reader.pop();
                ++read;
            }
            ASSERT_TRUE(model.empty());
        }
    }
    EXPECT_GT(written, 39'000u);
}

TEST(NoteRing, RefusesWhatDoesNotFit) {
    auto head = std::make_unique<NoteHead>();
    std::atomic<std::uint64_t> tail{0};
    NoteWriter writer(*head, tail);
    const std::string text(kNoteRing / 4, 'x');
    EXPECT_TRUE(writer.push(0, text) && writer.push(1, text) && writer.push(2, text));
    EXPECT_FALSE(writer.push(3, text));
}

}  // namespace
}  // namespace polyturn
