#include "toolmgmt/store_image.hpp"

namespace polyturn::toolmgmt {

Result<StoreImage> StoreImage::create(const std::string& instance, std::uint64_t generation) {
    const auto before = PeerSegment<StoreSegment>::attach(instance);   // that of a predecessor, if there was one
    auto own = OwnSegment<StoreSegment>::create(instance, generation);
    if (!own) return own.diagnosis();
    StoreImage image;
    image.own_ = std::move(*own);
    if (before && (*before)->header.generation == generation) {
        StoreSegment& to = *image.own_;
        const StoreSegment& from = **before;
        to.request_tail.tail = from.request_tail.tail.load();
        // Not persist_tail: what was only in the image died with the predecessor. The kernel's ring still has it.
        to.persist_tail.tail = from.on_disk.load();
        to.on_disk = from.on_disk.load();
        to.param_changes.head = from.param_changes.head.load();
        to.param_changes.slots = from.param_changes.slots;
        to.answers.head = from.answers.head.load();
        to.answers.slots = from.answers.slots;
        to.version = from.version.load();
    }
    return image;
}

void StoreImage::publish_all(const StoreValues& values) {
    StoreSegment& to = *own_;
    to.parameters.write(values.parameters);
    for (std::size_t l = 0; l < kMaxChannels; ++l) to.channels[l].write(values.channels[l]);
    to.version.fetch_add(1, std::memory_order_release);
    own_.publish();
    to.bell.ring();
}

void StoreImage::publish(const StoreValues& values, const std::vector<Change>& changes) {
    bool parameters = false;
    std::array<bool, kMaxChannels> channels{};
    for (const Change& change : changes) {
        if (change.key.kind == Kind::Parameter) parameters = true;
        else if (change.key.kind <= Kind::Variable) channels[static_cast<std::size_t>(change.key.scope - 1)] = true;
    }
    StoreSegment& to = *own_;
    if (parameters) to.parameters.write(values.parameters);
    for (std::size_t l = 0; l < kMaxChannels; ++l)
        if (channels[l]) to.channels[l].write(values.channels[l]);
    if (!changes.empty()) to.version.fetch_add(1, std::memory_order_release);
}

}  // namespace polyturn::toolmgmt
