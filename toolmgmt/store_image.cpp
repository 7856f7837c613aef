#include "toolmgmt/store_image.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>

#include "toolmgmt/tools/places.hpp"

namespace polyturn::toolmgmt {

namespace {

// The segment of a dead predecessor that served the same supervisor.
std::optional<OwnSegment<StoreSegment>> take_over(const std::string& instance,
                                                  const SegmentHeader& supervisor) {
    auto own = OwnSegment<StoreSegment>::adopt(instance);
    if (!own) return {};
    const SegmentHeader& header = (*own)->header;
    // P1: of a segment that was published
    const bool serves = (*own)->supervisor.load() == supervisor.writer_pid &&
                        header.generation == supervisor.generation;
    const bool dead = kill(header.writer_pid, 0) != 0 && errno == ESRCH;
    if (!serves || !dead) return {};
    return std::move(*own);
}

}  // namespace

Result<StoreImage> StoreImage::create(const std::string& instance,
                                      const SegmentHeader& supervisor) {
    StoreImage image;
    if (auto own = take_over(instance, supervisor)) {
        image.own_ = std::move(*own);
        image.taken_over_ = true;
        // P4: the predecessor has died: own word
        image.replay_from_ = image.own_->on_disk.load();
        return image;
    }
    auto own = OwnSegment<StoreSegment>::create(instance, supervisor.generation);
    if (!own) return own.diagnosis();
    image.own_ = std::move(*own);
    // P1: seen with own_.publish()
    image.own_->supervisor.store(supervisor.writer_pid);
    return image;
}

void StoreImage::read_into(StoreValues& values) const {
    const StoreSegment& from = *own_;  // only this process writes it
    values.parameters = from.parameters.published();
    values.counters = from.totals.published().counters;
    values.last_position = from.totals.published().last_position;
    for (std::size_t l = 0; l < kMaxChannels; ++l)
        values.channels[l] = from.channels[l].published();
    values.tools = from.tools.published();
    values.edges = from.edges.published();
}

void StoreImage::read_zeros_into(StoreValues& values) const {
    for (std::size_t l = 0; l < kMaxChannels; ++l)
        values.channels[l].zeros = own_->channels[l].published().zeros;
}

void StoreImage::publish_all(const StoreValues& values) {
    StoreSegment& to = *own_;
    to.parameters.write(values.parameters);
    for (std::size_t l = 0; l < kMaxChannels; ++l) to.channels[l].write(values.channels[l]);
    publish_totals(values);
    all_written_ = true;
    publish_tools(values, {});
    publish_users(values);
    // P1: all tables, then the version that says so
    to.version.fetch_add(1, std::memory_order_release);
    to.header.writer_pid = getpid();  // whoever waits for this process sees only what it published
    own_.publish();
    to.bell.ring();
}

void StoreImage::publish_totals(const StoreValues& values) {
    StoreTotals& draft = own_->totals.draft();
    draft.counters = values.counters;
    draft.last_position = values.last_position;
    own_->totals.publish();
}

// Only the rows that changed since this slot was filled last: life is counted many times a second.
void StoreImage::publish_tools(const StoreValues& values, const std::vector<Change>& changes) {
    std::vector<std::size_t> rows;
    bool edges = all_written_, places = all_written_, more = all_written_, any = all_written_;
    for (const Change& change : changes) {
        const Key& key = change.key;
        if (key.kind == Kind::Tool) {
            if (rows.empty() || rows.back() != static_cast<std::size_t>(key.number - 1))
                rows.push_back(static_cast<std::size_t>(key.number - 1));
            places = places || key.name == "magazine" || key.name == "pot" || key.name == "exists";
            more = more || key.name != "counter";
        }
        edges = edges || key.kind == Kind::Edge;
        places = places || key.kind == Kind::Place || key.kind == Kind::Parameter;
        any = any || key.kind == Kind::Tool || key.kind == Kind::Work;
    }
    more = more || edges || places;
    StoreSegment& to = *own_;
    if (any || more) {
        ToolTable& draft = to.tools.draft();
        if (all_written_) {
            draft = values.tools;
        } else {
            for (const std::size_t row : written_) draft.rows[row] = values.tools.rows[row];
            for (const std::size_t row : rows) draft.rows[row] = values.tools.rows[row];
            draft.in_channel = values.tools.in_channel;
            draft.next = values.tools.next;
        }
        if (more) ++tool_version_;
        draft.version = tool_version_;
        to.tools.publish();
        // The slot that is now behind was filled before this one: what both publications wrote is
        // missing there.
        if (all_written_) {
            to.tools.draft() = values.tools;
            written_.clear();
        } else {
            written_ = std::move(rows);
        }
    }
    if (edges) to.edges.write(values.edges);
    if (places) {
        derive_places(values, to.places.draft());
        to.places.publish();
    }
    all_written_ = false;
}

void StoreImage::publish_users(const StoreValues& values) {
    UserTable& table = own_->users.draft();
    table = {};
    const auto number = [&](std::int32_t user, const char* field, double otherwise) {
        const Cell* cell = values.cell({Kind::User, 0, user, 0, field});
        return cell ? cell->number : otherwise;
    };
    for (std::int32_t user = 1; user <= static_cast<std::int32_t>(kUsers); ++user) {
        const Cell* name = values.cell({Kind::User, 0, user, 0, "name"});
        if (!name) continue;
        UserRow& row = table.rows[table.count++];
        row.number = static_cast<std::uint32_t>(user);
        row.level = static_cast<std::uint32_t>(number(user, "level", 0));
        row.locked = number(user, "locked_until", 0) > 0;
        row.uid = static_cast<std::int64_t>(number(user, "uid", -1));
        std::copy_n(name->text.begin(), std::min(name->text.size(), row.name.size() - 1),
                    row.name.begin());
    }
    if (table.count == 0 && locked_) {
        UserRow& nobody = table.rows[table.count++];
        nobody.locked = 1;
        nobody.uid = -1;
        nobody.name[0] = '-';
    }
    own_->users.publish();
}

bool StoreImage::push(const ToolAnswer& answer, std::uint64_t taken) {
    auto& ring = own_->tool_answers;
    // P4: own head; `taken` was acquired by whoever calls (P2)
    const auto head = ring.head.load(std::memory_order_relaxed);
    if (head - taken >= std::remove_reference_t<decltype(ring)>::capacity) return false;
    ring.slot(head) = answer;
    // P1: the answer is complete
    ring.head.store(head + 1, std::memory_order_release);
    return true;
}

void StoreImage::publish(const StoreValues& values, const std::vector<Change>& changes) {
    bool parameters = false, totals = false;
    std::array<bool, kMaxChannels> channels{};
    for (const Change& change : changes) {
        if (change.key.kind == Kind::Counter || change.key.kind == Kind::Position) totals = true;
        if (change.key.kind == Kind::Parameter || change.key.kind == Kind::Counter)
            parameters = true;
        else if (change.key.kind <= Kind::Variable)
            channels[static_cast<std::size_t>(change.key.scope - 1)] = true;
    }
    StoreSegment& to = *own_;
    if (parameters) to.parameters.write(values.parameters);
    if (totals) publish_totals(values);
    for (std::size_t l = 0; l < kMaxChannels; ++l)
        if (channels[l]) to.channels[l].write(values.channels[l]);
    publish_tools(values, changes);
    if (std::any_of(changes.begin(), changes.end(),
                    [](const Change& c) { return c.key.kind == Kind::User; }))
        publish_users(values);
    // Counters, positions and the life of tools are the kernel's own: nobody has to look because of
    // them.
    const bool news = std::any_of(changes.begin(), changes.end(), [](const Change& c) {
        return c.key.kind <= Kind::Edge && c.key.kind != Kind::Counter &&
               c.key.kind != Kind::Position && c.key.name != "counter";
    });
    // P1: the tables, then the version that says so
    if (news) to.version.fetch_add(1, std::memory_order_release);
}

}  // namespace polyturn::toolmgmt
