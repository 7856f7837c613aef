// The cyclic thread's client of tool management: it asks the store which tool a T means and where
// it is, reports which tool is in work, and counts its life while it cuts. It never waits: a T
// stays open until its answer is there.
//
//   T record -> ToolCall -> (store) -> ToolAnswer -> CN_MGZNO CN_POTNO CN_TOOLNO, strobe -> PLC
//   turns the turret, CP_TFIN
//            -> ToolInPlace. In a machine with a tool spindle M06 follows: ToolChanged.
//
// In virtual time an answer acts exactly PT_ANSWER_TICKS after its question. A change notification
// concerns the tool in work: its life was reset, or its wear has grown; a notification that a
// program's write has caused (id) waits for that write's tick. Tool life goes to the store once a
// second, at a tool change and when the program stops; when the kernel dies, at most the last
// second is lost. Nothing is counted in a dry run or with machine lock.
#pragma once
#include <array>
#include <cstdint>
#include <limits>

#include "ipc/image/segments.hpp"

namespace polyturn::kernel {

struct Core;

class ToolClient {
public:
    enum class Call : std::uint8_t { None, Asked, Answered, Refused };

    // Tools that worked when the kernel was started; not in the cyclic thread.
    void start(KernelSegment& image, const StoreSegment& store);
    void rebind(KernelSegment& image, const StoreSegment& store) noexcept;
    static bool managed(const Core& core) noexcept;  // N2900 TMU
    // Of channel index (from 0). False: the ring is full, ask again.
    bool ask(Core& core, unsigned index, const PathRecord& r) noexcept;
    void take_answers(Core& core) noexcept;  // at a tick's start
    Call call(unsigned index) const noexcept { return context_[index].call; }
    const ToolAnswer& answer(unsigned index) const noexcept { return context_[index].answer; }
    std::int64_t asked_at(unsigned index) const noexcept { return context_[index].asked_at; }
    // A restart at a block passes this T (changes: an M06) without calling the tool: the answer has
    // the offset that counts.
    void pass(const Core& core, unsigned index, bool changes) noexcept;
    // Another tool answers now than when the T was passed: its offset is not the one that the
    // program goes on with.
    bool differs(unsigned index) const noexcept;
    void end_search(unsigned index) noexcept {
        context_[index].passed = context_[index].passed_next = {};
    }
    // reset, or the T is done
    void forget(unsigned index) noexcept { context_[index].call = Call::None; }
    void publish(unsigned index, ChannelStatus& out) const noexcept;
    // CN_MGZNO and so on of the answer, before the strobe
    void show(Core& core, unsigned index) noexcept;
    bool in_place(Core& core, unsigned index) noexcept;  // the PLC has finished T
    bool changed(Core& core, unsigned index) noexcept;   // ... and M06
    void spend(Core& core, unsigned index, bool cuts, double seconds, double mm) noexcept;
    void part(Core& core, unsigned index) noexcept;
    // so many by each tool that took part (SETPIECE); false: the store's ring is full
    bool pieces(Core& core, unsigned index, double count) noexcept;
    // what was counted goes to the store; false: its ring is full
    bool flush(Core& core, unsigned index) noexcept;
    // The channel's reaction to the end of tool life: reported once.
    enum class End : std::uint8_t { Nothing, StopAfterPart, Hold };
    End take_end(unsigned index) noexcept {
        const End end = context_[index].end;
        context_[index].end = End::Nothing;
        return end;
    }

private:
    static constexpr std::size_t kPerPart = 64;  // tools that one part uses
    struct Working {
        std::int32_t tool = 0, offset = 0, radius_offset = 0;
        LifeKind kind = LifeKind::None;
        double left = std::numeric_limits<double>::infinity(),
               group_left = std::numeric_limits<double>::infinity(), warning = 0;
        std::array<char, 32> name{};
    };
    struct Context {
        Call call = Call::None;
        std::uint64_t id = 0;
        std::int64_t asked_at = 0;
        ToolAnswer answer{};  // to the last question
        bool next = false;    // it waits for M06
        struct Passed {
            bool any = false;
            std::int32_t tool = 0, offset = 0, radius_offset = 0;
        } passed, passed_next;  // instead of the tool in work while a restart looks for its block
        Working now;
        double counted = 0;  // not yet sent
        double since_s = 0;
        bool near = false, over = false;
        End end = End::Nothing;
        std::array<std::int32_t, kPerPart> used{};
        std::size_t used_count = 0;
        std::int64_t told_at = -1;  // tick of the last SETPIECE: what was cut in it came before
        std::array<std::int32_t, kPerPart> made{};  // pieces that are not reported yet
        std::size_t made_count = 0;
    };
    void work(Core& core, unsigned index, const ToolAnswer& answer) noexcept;
    bool use_in_part(unsigned index, std::int32_t tool) noexcept;
    void use(Core& core, unsigned index, LifeKind kind, double amount) noexcept;
    void look(Core& core, unsigned index) noexcept;

    std::array<Context, kMaxChannels> context_{};
    const StoreSegment* store_ = nullptr;
};

}  // namespace polyturn::kernel
