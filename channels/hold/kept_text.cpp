#include "channels/hold/kept_text.hpp"

#include "ipc/model/files/regular_file.hpp"
#include "ipc/model/files/replace_file.hpp"

namespace polyturn::channels {

std::string KeptText::path_of(std::string_view name) const {
    return folder_ + "/L" + std::to_string(channel_) + "." + std::string(name);
}

bool KeptText::put(std::string_view name, std::string_view text) const {
    return folder_.empty() || text::replace_file(path_of(name), text).ok();
}

std::string KeptText::get(std::string_view name) const {
    if (folder_.empty()) return {};
    const auto file = text::RegularFile::open(path_of(name));
    auto kept = file ? file->read_all() : Result<std::string>(std::string());
    // nothing has been kept, or it cannot be read: it begins empty
    return kept ? std::move(*kept) : std::string();
}

}  // namespace polyturn::channels
