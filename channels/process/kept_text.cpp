#include "channels/process/kept_text.hpp"

#include <fstream>
#include <iterator>

#include "ipc/text/replace_file.hpp"

namespace polyturn::channels {

std::string KeptText::path_of(std::string_view name) const { return folder_ + "/L" + std::to_string(channel_) + "." + std::string(name); }

bool KeptText::put(std::string_view name, std::string_view text) const { return folder_.empty() || text::replace_file(path_of(name), text).ok(); }

std::string KeptText::get(std::string_view name) const {
    if (folder_.empty()) return {};
    std::ifstream in(path_of(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace polyturn::channels
