#include "ipc/image/signal_tongue.hpp"

#include "polyturn/signal_tongues.hpp"

namespace polyturn {

std::string_view meaning_of(const SignalRow& row, Tongue tongue) {
    if (tongue == Tongue::English) return row.meaning;
    const std::string_view own = kSignalTongues[static_cast<std::size_t>(tongue) - 1][static_cast<std::size_t>(&row - signal_rows().data())];
    return own.empty() ? row.meaning : own;
}

}  // namespace polyturn
