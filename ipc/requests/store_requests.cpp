#include "ipc/requests/store_requests.hpp"

namespace polyturn {

std::optional<std::size_t> kept_variable(std::string_view name) noexcept {
    if (name.size() != 4 || name[0] != '#') return {};
    std::size_t number = 0;
    for (const char c : name.substr(1)) {
        if (c < '0' || c > '9') return {};
        number = number * 10 + static_cast<std::size_t>(c - '0');
    }
    if (number < 500) return {};
    return number - 500;
}

}  // namespace polyturn
