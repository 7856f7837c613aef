// One mapped shared-memory segment of an instance. Created and mapped writable by its writer,
// attached read-only by all others. Boost.Interprocess is used for the object and its mapping only:
// nothing named inside, no lock that could be left held. Attaching refuses, with the reason, what
// another build, another instance or a stranger has made (trusted_owner.hpp).
#pragma once
#include <chrono>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/image/segments.hpp"

namespace polyturn {

// "polyturn.<instance>.kernel", "polyturn.<instance>.channel3"; instance: letters, digits, - and _
// only (up to 40).
std::string segment_name(std::string_view instance, SegmentKind kind, std::size_t number = 0);
bool valid_instance(std::string_view instance);

// The mapping, without knowledge of what lies in it.
class RawSegment {
public:
    RawSegment();
    RawSegment(RawSegment&&) noexcept;
    RawSegment& operator=(RawSegment&&) noexcept;
    ~RawSegment();
    // Removes an old one of that name and makes a new one under a name that says who makes it
    // ("<name>.of-<pid>"): whoever cleans up knows at any moment whether its maker lives. reveal()
    // gives it its own name, once it says so itself.
    static Result<RawSegment> create(const std::string& name, std::size_t size);
    Result<void> reveal();
    static Result<RawSegment> attach(const std::string& name, std::size_t size);  // read-only
    // an existing one, writable
    static Result<RawSegment> adopt(const std::string& name, std::size_t size);
    void* address() const;

private:
    static Result<RawSegment> map(const std::string& name, std::size_t size, bool writable);
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

Result<void> check_header(const SegmentHeader& header, std::string_view instance);
void fill_header(SegmentHeader& header, std::string_view instance, std::uint64_t generation);
void publish_header(SegmentHeader& header);  // the last step of the writer: others may attach now

// Writer's view.
template <class Layout>
class OwnSegment {
public:
    static Result<OwnSegment> create(std::string_view instance, std::uint64_t generation,
                                     std::size_t number = 0) {
        auto raw =
            RawSegment::create(segment_name(instance, Layout::kKind, number), sizeof(Layout));
        if (!raw) return raw.diagnosis();
        OwnSegment own;
        own.raw_ = std::move(*raw);
        // default-initialises: fresh memory is zero, only members with values are written
        new (own.raw_.address()) Layout;
        fill_header(own->header, instance, generation);
        if (auto shown = own.raw_.reveal(); !shown) return shown.diagnosis();
        return own;
    }
    // A writer that was killed is followed by another in the same segment, so that no process has
    // to attach again: rings and snapshots are whole at any moment. Only for whoever knows that the
    // predecessor is dead, and what it may have begun.
    static Result<OwnSegment> adopt(std::string_view instance, std::size_t number = 0) {
        auto raw = RawSegment::adopt(segment_name(instance, Layout::kKind, number), sizeof(Layout));
        if (!raw) return raw.diagnosis();
        OwnSegment own;
        own.raw_ = std::move(*raw);
        // P1: what the predecessor published
        if (own->header.ready.load(std::memory_order_acquire) != 1)
            return Diagnosis{Alarm::SegmentNotReady, {}, {}, std::string(instance)};
        if (auto good = check_header(own->header, instance); !good) return good.diagnosis();
        return own;
    }
    void publish() { publish_header((*this)->header); }
    Layout* operator->() const { return static_cast<Layout*>(raw_.address()); }
    Layout& operator*() const { return *operator->(); }

private:
    RawSegment raw_;
};

// Everybody else's view.
template <class Layout>
class PeerSegment {
public:
    // Waits until the writer has published it, at most the timeout `patience`.
    static Result<PeerSegment> attach(
        std::string_view instance, std::size_t number = 0,
        std::chrono::milliseconds timeout = std::chrono::milliseconds(0));
    const Layout* operator->() const { return static_cast<const Layout*>(raw_.address()); }
    const Layout& operator*() const { return *operator->(); }
    bool attached() const { return raw_.address() != nullptr; }

private:
    RawSegment raw_;
};

void sleep_ms(int milliseconds);
bool process_lives(int pid);  // and is not just waiting to be reaped

template <class Layout>
Result<PeerSegment<Layout>> PeerSegment<Layout>::attach(std::string_view instance,
                                                        std::size_t number,
                                                        std::chrono::milliseconds timeout) {
    const std::string name = segment_name(instance, Layout::kKind, number);
    for (auto waited = std::chrono::milliseconds(0);; waited += std::chrono::milliseconds(1)) {
        auto raw = RawSegment::attach(name, sizeof(Layout));
        if (raw) {
            const auto& header = static_cast<const Layout*>(raw->address())->header;
            // P1: the header is complete
            if (header.ready.load(std::memory_order_acquire) == 1) {
                if (auto good = check_header(header, instance); !good) return good.diagnosis();
                PeerSegment peer;
                peer.raw_ = std::move(*raw);
                return peer;
            }
        }
        if (waited >= timeout) {
            if (!raw) return raw.diagnosis();
            return Diagnosis{Alarm::SegmentNotReady, {}, {}, name};
        }
        sleep_ms(1);
    }
}

// Removes the segments and sockets of instances none of whose processes live. Returns the names
// removed.
std::vector<std::string> remove_dead_instances();
void remove_instance(std::string_view instance);

}  // namespace polyturn
