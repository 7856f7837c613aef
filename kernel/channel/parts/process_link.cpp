#include "kernel/channel/parts/process_link.hpp"

#include <algorithm>
#include <cstring>

namespace polyturn::kernel {

std::string_view ProcessLink::program(std::uint32_t file) const noexcept {
    if (!segment || !segment->programs.read(*names)) return {};
    const std::size_t at = std::min<std::size_t>(file, 31) * 256;
    const std::string_view path(&names->name[at], ::strnlen(&names->name[at], 255));
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

}  // namespace polyturn::kernel
