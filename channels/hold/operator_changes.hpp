// Detects changes of this channel's offsets or zeros from outside. The store only reports that
// something is new, and most of that this program has written itself.
#pragma once
#include <memory>
#include <unordered_map>
#include <vector>

#include "channels/sink.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::channels {

class OperatorChanges {
public:
    // What the program has begun with; from here on changes count.
    void begin(const ChannelStore& now);
    // The program writes this; the store will show it when the path has come there.
    void wrote(const OffsetWrite& written);
    // True: a value differs from what was seen last, and the program has not written it. `now` is
    // what was seen afterwards.
    bool look(const ChannelStore& now);

private:
    std::unique_ptr<ChannelStore> seen_;
    // by the place of the number in the store: the last values
    std::unordered_map<std::size_t, std::vector<double>> written_;
};

}  // namespace polyturn::channels
