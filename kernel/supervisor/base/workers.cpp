#include "kernel/supervisor/base/workers.hpp"

#include <signal.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace polyturn::supervisor {

struct Workers::Shared {
    std::mutex mutex;
    std::condition_variable some;
    std::deque<Work> waiting;
    std::deque<Done> done;
    std::size_t under_way = 0, most = 0;  // offered and not yet finished
    bool end = false;
    int ready = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    ~Shared() { close(ready); }

    void run() {
        for (;;) {
            Work work;
            {
                std::unique_lock lock(mutex);
                some.wait(lock, [this] { return end || !waiting.empty(); });
                if (end) return;
                work = std::move(waiting.front());
                waiting.pop_front();
            }
            Done result = work();
            {
                const std::lock_guard lock(mutex);
                done.push_back(std::move(result));
            }
            const std::uint64_t one = 1;
            (void)!write(ready, &one, sizeof one);
        }
    }
};

Workers::Workers(std::size_t threads, std::size_t most_at_once)
    : shared_(std::make_shared<Shared>()) {
    shared_->most = most_at_once;
    sigset_t all, before;  // signals are the loop's: they interrupt its waits
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    for (std::size_t i = 0; i < threads; ++i)
        std::thread([shared = shared_] { shared->run(); }).detach();
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Workers::~Workers() {
    const std::lock_guard lock(shared_->mutex);
    shared_->end = true;
    shared_->some.notify_all();
}

bool Workers::offer(Work work) {
    {
        const std::lock_guard lock(shared_->mutex);
        if (shared_->under_way >= shared_->most) return false;
        ++shared_->under_way;
        shared_->waiting.push_back(std::move(work));
    }
    shared_->some.notify_one();
    return true;
}

int Workers::fd() const { return shared_->ready; }

std::size_t Workers::busy() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->under_way;
}

void Workers::finish() {
    std::uint64_t count = 0;
    if (read(shared_->ready, &count, sizeof count) < 0) return;  // nothing has come
    std::deque<Done> done;
    {
        const std::lock_guard lock(shared_->mutex);
        done.swap(shared_->done);
        shared_->under_way -= done.size();
    }
    for (const Done& one : done)
        if (one) one();
}

}  // namespace polyturn::supervisor
