// Work that may take long, in another thread than the screens: a folder on a network that does not
// answer must not stop a key. The worker holds all that it needs itself, so that whoever asked may
// forget it at any time; a worker that never comes back costs a thread and nothing else.
#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace polyturn::hmi {

// what is done within it is shown in the same frame; two of them fit into 50 ms
inline constexpr int kTimeout_ms = 20;

template <class T>
class Aside {
public:
    using Work = std::function<T(const std::atomic<bool>& stop)>;

    ~Aside() { forget(); }
    // Forgets what was asked before. Waits for the answer at most so long.
    void start(Work work, int wait_ms = kTimeout_ms) {
        forget();
        box_ = std::make_shared<Box>();
        std::thread([box = box_, work = std::move(work)] {
            T made = work(box->stop);
            const std::lock_guard<std::mutex> lock(box->mutex);
            box->made = std::move(made);
            box->done = true;
            box->ready.notify_all();
        }).detach();
        if (wait_ms <= 0) return;
        std::unique_lock<std::mutex> lock(box_->mutex);
        box_->ready.wait_for(lock, std::chrono::milliseconds(wait_ms), [&] { return box_->done; });
    }
    bool busy() const { return box_ != nullptr; }
    void stop() {
        if (box_) box_->stop = true;
    }
    void forget() {
        stop();
        box_.reset();
    }
    // Once, when it is done.
    std::optional<T> take() {
        if (!box_) return std::nullopt;
        std::optional<T> out;
        {
            const std::lock_guard<std::mutex> lock(box_->mutex);
            if (!box_->done) return std::nullopt;
            out = std::move(box_->made);
        }
        box_.reset();
        return out;
    }

private:
    struct Box {
        std::mutex mutex;
        std::condition_variable ready;
        std::optional<T> made;
        bool done = false;
        // P3: a flag, announces nothing; what was made comes by the mutex
        std::atomic<bool> stop{false};
    };
    std::shared_ptr<Box> box_;
};

}  // namespace polyturn::hmi
