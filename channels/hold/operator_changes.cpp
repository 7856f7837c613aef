#include "channels/hold/operator_changes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace polyturn::channels {
namespace {

static_assert(sizeof(OffsetCell) % sizeof(double) == 0 &&
              offsetof(ChannelStore, offsets) % sizeof(double) == 0);
constexpr std::size_t kFirst = offsetof(ChannelStore, offsets) / sizeof(double);
constexpr std::size_t kEnd =
    (offsetof(ChannelStore, zeros) + sizeof(ChannelStore{}.zeros)) / sizeof(double);
constexpr std::size_t kLastWritten = 16;

double number(const ChannelStore& store, std::size_t place) {
    double out = 0;
    std::memcpy(&out, reinterpret_cast<const std::byte*>(&store) + place * sizeof(double),
                sizeof out);
    return out;
}

// Place of a written number; kEnd: none of this channel's.
std::size_t place_of(const OffsetWrite& w) {
    if (w.channel) return kEnd;
    if (w.work)
        return w.row < 0 || w.place < 0 ? kEnd
                                        : offsetof(ChannelStore, zeros) / sizeof(double) +
                                              static_cast<std::size_t>(w.row) * kChannelAxes +
                                              static_cast<std::size_t>(w.place);
    const std::size_t cell =
        (offsetof(ChannelStore, offsets) +
         static_cast<std::size_t>(std::max(w.number, 0)) * sizeof(OffsetCell)) /
        sizeof(double);
    const auto field = static_cast<std::size_t>(w.field);
    const bool length = w.field <= OffsetField::Z;
    switch (w.store_table) {
        case OffsetTable::Geometry:
            return cell + (length ? offsetof(OffsetCell, geometry) / sizeof(double) + field
                           : w.field == OffsetField::R
                               ? offsetof(OffsetCell, geometry_r) / sizeof(double)
                               : offsetof(OffsetCell, tip) / sizeof(double));
        case OffsetTable::Wear:
            return cell + (length ? offsetof(OffsetCell, wear) / sizeof(double) + field
                           : w.field == OffsetField::R
                               ? offsetof(OffsetCell, wear_r) / sizeof(double)
                               : offsetof(OffsetCell, tip) / sizeof(double));
        case OffsetTable::SecondGeometry:
            return length ? cell + offsetof(OffsetCell, second) / sizeof(double) + field : kEnd;
        case OffsetTable::Work:
            break;
    }
    return kEnd;
}

}  // namespace

void OperatorChanges::begin(const ChannelStore& now) {
    if (!seen_) seen_ = std::make_unique<ChannelStore>();
    *seen_ = now;
    written_.clear();
}

void OperatorChanges::wrote(const OffsetWrite& written) {
    const std::size_t place = place_of(written);
    if (place >= kEnd) return;
    std::vector<double>& values = written_[place];
    if (values.size() == kLastWritten) values.erase(values.begin());
    values.push_back(written.value);
}

bool OperatorChanges::look(const ChannelStore& now) {
    if (!seen_) return false;
    bool changed = false;
    for (std::size_t place = kFirst; place < kEnd; ++place) {
        const double value = number(now, place);
        if (value == number(*seen_, place)) continue;
        const auto own = written_.find(place);
        if (own == written_.end() ||
            std::find(own->second.begin(), own->second.end(), value) == own->second.end())
            changed = true;
    }
    *seen_ = now;
    return changed;
}

}  // namespace polyturn::channels
