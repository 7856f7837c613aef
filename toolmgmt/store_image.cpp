#include "toolmgmt/store_image.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>

namespace polyturn::toolmgmt {

namespace {

// The segment of a dead predecessor that served the same supervisor.
std::optional<OwnSegment<StoreSegment>> take_over(const std::string& instance, const SegmentHeader& supervisor) {
    auto own = OwnSegment<StoreSegment>::adopt(instance);
    if (!own) return {};
    const SegmentHeader& header = (*own)->header;
    const bool serves = (*own)->supervisor.load() == supervisor.writer_pid && header.generation == supervisor.generation;
    const bool dead = kill(header.writer_pid, 0) != 0 && errno == ESRCH;
    if (!serves || !dead) return {};
    return std::move(*own);
}

}  // namespace

Result<StoreImage> StoreImage::create(const std::string& instance, const SegmentHeader& supervisor) {
    StoreImage image;
    if (auto own = take_over(instance, supervisor)) {
        image.own_ = std::move(*own);
        image.taken_over_ = true;
        image.replay_from_ = image.own_->on_disk.load();
        return image;
    }
    auto own = OwnSegment<StoreSegment>::create(instance, supervisor.generation);
    if (!own) return own.diagnosis();
    image.own_ = std::move(*own);
    image.own_->supervisor.store(supervisor.writer_pid);
    return image;
}

void StoreImage::read_into(StoreValues& values) const {
    const StoreSegment& from = *own_;   // nobody writes it but us
    values.parameters = from.parameters.published();
    values.counters = from.totals.published().counters;
    values.last_position = from.totals.published().last_position;
    for (std::size_t l = 0; l < kMaxChannels; ++l) values.channels[l] = from.channels[l].published();
}

void StoreImage::read_zeros_into(StoreValues& values) const {
    for (std::size_t l = 0; l < kMaxChannels; ++l) values.channels[l].zeros = own_->channels[l].published().zeros;
}

void StoreImage::publish_all(const StoreValues& values) {
    StoreSegment& to = *own_;
    to.parameters.write(values.parameters);
    for (std::size_t l = 0; l < kMaxChannels; ++l) to.channels[l].write(values.channels[l]);
    publish_totals(values);
    to.version.fetch_add(1, std::memory_order_release);
    to.header.writer_pid = getpid();   // whoever waits for this process sees only what it published
    own_.publish();
    to.bell.ring();
}

void StoreImage::publish_totals(const StoreValues& values) {
    StoreTotals& draft = own_->totals.draft();
    draft.counters = values.counters;
    draft.last_position = values.last_position;
    own_->totals.publish();
}

void StoreImage::publish(const StoreValues& values, const std::vector<Change>& changes) {
    bool parameters = false, totals = false;
    std::array<bool, kMaxChannels> channels{};
    for (const Change& change : changes) {
        if (change.key.kind == Kind::Counter || change.key.kind == Kind::Position) totals = true;
        if (change.key.kind == Kind::Parameter || change.key.kind == Kind::Counter) parameters = true;
        else if (change.key.kind <= Kind::Variable) channels[static_cast<std::size_t>(change.key.scope - 1)] = true;
    }
    StoreSegment& to = *own_;
    if (parameters) to.parameters.write(values.parameters);
    if (totals) publish_totals(values);
    for (std::size_t l = 0; l < kMaxChannels; ++l)
        if (channels[l]) to.channels[l].write(values.channels[l]);
    // Counters and positions are the kernel's own: nobody has to look because of them.
    const bool news = std::any_of(changes.begin(), changes.end(), [](const Change& c) { return c.key.kind != Kind::Counter && c.key.kind != Kind::Position; });
    if (news) to.version.fetch_add(1, std::memory_order_release);
}

}  // namespace polyturn::toolmgmt
