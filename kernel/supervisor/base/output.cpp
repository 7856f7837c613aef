#include "kernel/supervisor/base/output.hpp"

#include <poll.h>
#include <unistd.h>

#include <cerrno>

namespace polyturn::supervisor {

void Output::flush() {
    std::size_t done = 0;
    while (done < buffer_.size() && !broken_) {
        const auto wrote = ::write(fd_, buffer_.data() + done, buffer_.size() - done);
        if (wrote > 0) {
            done += static_cast<std::size_t>(wrote);
        } else if (wrote < 0 && errno == EAGAIN) {
            pollfd ready{fd_, POLLOUT, 0};
            poll(&ready, 1, 1000);
        } else if (wrote < 0 && errno != EINTR) {
            broken_ = true;
        }
    }
    buffer_.clear();
}

}  // namespace polyturn::supervisor
