// Texts of a channel that survive power-off: one file each in the folder of the controller's store.
// A write is whole or has not happened: the new text is on the disk before it takes the place of
// the old one.
#pragma once
#include <string>
#include <string_view>

namespace polyturn::channels {

class KeptText {
public:
    KeptText(std::string folder, unsigned channel)
        : folder_(std::move(folder)), channel_(channel) {}
    // False: the disk has not taken it; the old text is still there. Without a folder nothing is
    // kept, and nothing fails.
    bool put(std::string_view name, std::string_view text) const;
    // Empty: there is none.
    std::string get(std::string_view name) const;

private:
    std::string path_of(std::string_view name) const;
    std::string folder_;  // empty: a run that leaves nothing behind
    unsigned channel_;
};

}  // namespace polyturn::channels
