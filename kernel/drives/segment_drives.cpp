#include "kernel/drives/segment_drives.hpp"

#include <unistd.h>

#include <algorithm>

namespace polyturn::kernel {
namespace {
// whose slots open() gives out: the C interface knows no context
SegmentDrives* opening = nullptr;

std::string commands_name(const std::string& instance) {
    return "polyturn." + instance + ".drives";
}
std::string statuses_name(const std::string& instance) {
    return "polyturn." + instance + ".slaves";
}

// The segment of the drive process `pid` (0: of any), complete and of this version; else nothing.
const PolyturnDriveStatuses* look(const std::string& instance, int pid,
                                  std::vector<RawSegment>& into) {
    auto raw = RawSegment::attach(statuses_name(instance), sizeof(PolyturnDriveStatuses));
    if (!raw) return nullptr;
    const auto* found = static_cast<const PolyturnDriveStatuses*>(raw->address());
    // P1: the header is complete
    if (__atomic_load_n(&found->ready, __ATOMIC_ACQUIRE) != 1 ||
        found->magic != POLYTURN_DRIVES_MAGIC || found->version != POLYTURN_DRIVE_VERSION ||
        found->size != sizeof(PolyturnDriveStatuses) || (pid && found->writer_pid != pid) ||
        !process_lives(found->writer_pid))
        return nullptr;
    into.push_back(std::move(*raw));
    return found;
}
}  // namespace

Result<std::unique_ptr<SegmentDrives>> SegmentDrives::create(std::string instance,
                                                             bool is_virtual) {
    auto raw = RawSegment::create(commands_name(instance), sizeof(PolyturnDriveCommands));
    if (!raw) return raw.diagnosis();
    std::unique_ptr<SegmentDrives> out(new SegmentDrives);
    out->own_ = std::move(*raw);
    out->instance_ = std::move(instance);
    PolyturnDriveCommands& c =
        *(out->commands_ = static_cast<PolyturnDriveCommands*>(out->own_.address()));
    c.magic = POLYTURN_DRIVES_MAGIC;
    c.version = POLYTURN_DRIVE_VERSION;
    c.size = sizeof c;
    c.writer_pid = getpid();
    c.is_virtual = is_virtual ? 1 : 0;
    if (auto shown = out->own_.reveal(); !shown) return shown.diagnosis();
    for (std::uint32_t i = 0; i < POLYTURN_DRIVE_SLOTS; ++i) out->slots_[i] = {out.get(), i, 0};
    opening = out.get();
    return out;
}

void* SegmentDrives::open_slot(const PolyturnDriveSetup& setup, std::uint32_t first) {
    const std::uint32_t index = first + setup.number - 1;
    if (!opening || setup.version != POLYTURN_DRIVE_VERSION || setup.number == 0 ||
        index >= POLYTURN_DRIVE_SLOTS)
        return nullptr;
    opening->commands_->setup[index] = setup;
    return &opening->slots_[index];
}

const PolyturnDriveApi& SegmentDrives::axis_api() {
    static constexpr PolyturnDriveApi kApi{
        POLYTURN_DRIVE_VERSION,
        [](const PolyturnDriveSetup* setup) { return open_slot(*setup, 0); }, [](void*) {},
        [](void* slot, const PolyturnDriveCommand* c, PolyturnDriveStatus* s) {
            static_cast<Slot*>(slot)->drives->exchange(*static_cast<Slot*>(slot), *c, *s);
        }};
    return kApi;
}

const PolyturnDriveApi& SegmentDrives::spindle_api() {
    static const PolyturnDriveApi kApi{
        POLYTURN_DRIVE_VERSION,
        [](const PolyturnDriveSetup* setup) { return open_slot(*setup, POLYTURN_DRIVE_AXES); },
        axis_api().close, axis_api().exchange};
    return kApi;
}

bool SegmentDrives::attach(std::int64_t tick_ns, std::chrono::milliseconds timeout) {
    commands_->tick_ns = static_cast<std::uint64_t>(tick_ns);
    end();  // nobody moves yet
    // P1: setups, header and the first frame
    __atomic_store_n(&commands_->ready, 1u, __ATOMIC_RELEASE);
    for (auto waited = std::chrono::milliseconds(0); waited < timeout;
         waited += std::chrono::milliseconds(1)) {
        wake();
        // P4: the tick does not run yet
        if (!statuses_.load()) statuses_.store(look(instance_, 0, theirs_));
        if (statuses_.load() && answered()) {
            begin();
            return true;
        }
        sleep_ms(1);
    }
    return false;
}

bool SegmentDrives::attach_successor(int pid) {
    const PolyturnDriveStatuses* found = look(instance_, pid, theirs_);
    // P7: offered; begin() takes it
    if (found) next_.store(found, std::memory_order_release);
    return found != nullptr;
}

// A frame that is just being overwritten is a lost one: the next begin() finds the newer.
void SegmentDrives::begin() noexcept {
    // P7: a look, then it is taken
    if (next_.load(std::memory_order_relaxed))
        if (const PolyturnDriveStatuses* next = next_.exchange(nullptr, std::memory_order_acquire))
            statuses_.store(next);
    // P4: only this thread stores it
    const PolyturnDriveStatuses* from = statuses_.load(std::memory_order_relaxed);
    if (!from) return;
    // P1, P5: the frame counts when the number is still the same behind the copy
    const std::uint64_t cycle = __atomic_load_n(&from->cycle, __ATOMIC_ACQUIRE);
    if (cycle == newest_.cycle) return;
    static_assert(sizeof(PolyturnStatusFrame) < 8192);
    PolyturnStatusFrame frame = from->frame[cycle & 1u];
    // P5: the second look at the number stays behind the copy
    std::atomic_thread_fence(std::memory_order_acquire);
    if (__atomic_load_n(&from->cycle, __ATOMIC_RELAXED) != cycle) return;
    for (Slot& slot : slots_) {
        const std::uint64_t before = newest_.answers[slot.index], now = frame.answers[slot.index];
        if (now > before && before != 0)
            slot.step = (frame.status[slot.index].position - newest_.status[slot.index].position) /
                        static_cast<std::int64_t>(now - before);
    }
    newest_ = frame;
}

void SegmentDrives::end() noexcept {
    ++draft_.cycle;
    // P5: the frame is written behind the number of before: else a reader could miss it
    std::atomic_thread_fence(std::memory_order_release);
    commands_->frame[draft_.cycle & 1u] = draft_;
    // P1: the frame, then its number. P6: then the bell
    __atomic_store_n(&commands_->cycle, draft_.cycle, __ATOMIC_RELEASE);
    __atomic_fetch_add(&commands_->bell, 1u, __ATOMIC_RELEASE);
}

bool SegmentDrives::answered() const noexcept {
    // P4: own word. P1: the frame of that cycle is complete
    const PolyturnDriveStatuses* from = statuses_.load(std::memory_order_relaxed);
    return from && __atomic_load_n(&from->cycle, __ATOMIC_ACQUIRE) >= draft_.cycle;
}

void SegmentDrives::exchange(Slot& slot, const PolyturnDriveCommand& command,
                             PolyturnDriveStatus& status) noexcept {
    draft_.command[slot.index] = command;
    status = newest_.status[slot.index];
    // What was commanded last tick is draft_.cycle; its answer is the fresh one.
    const std::uint64_t old = draft_.cycle - std::min(draft_.cycle, newest_.answers[slot.index]);
    status.lost = static_cast<std::uint16_t>(std::min<std::uint64_t>(old, 0xFFFF));
    constexpr std::uint64_t kMost = 100;  // beyond it the last speed is no longer valid
    status.position += slot.step * static_cast<std::int64_t>(std::min(old, kMost));
}

void SegmentDrives::wake() noexcept { polyturn_bell_wake(&commands_->bell); }

void SegmentDrives::await_answer(std::int64_t timeout_us) noexcept {
    // P4: own word. P6: the bell is read before the look for an answer
    const PolyturnDriveStatuses* from = statuses_.load(std::memory_order_relaxed);
    if (!from) return;
    const std::uint32_t seen = __atomic_load_n(&from->bell, __ATOMIC_ACQUIRE);
    if (!answered()) polyturn_bell_wait(&from->bell, seen, timeout_us);
}

}  // namespace polyturn::kernel
