// Threads for what the supervisor's loop must not wait for: files, long checks. A piece of work
// computes from what it was given by value and touches nothing of the supervisor's; what it returns
// is called by the loop.
#pragma once
#include <cstddef>
#include <functional>
#include <memory>

namespace polyturn::supervisor {

class Workers {
public:
    using Done = std::function<void()>;
    using Work = std::function<Done()>;
    static constexpr std::size_t kThreads = 2, kMostAtOnce = 16;

    explicit Workers(std::size_t threads = kThreads, std::size_t most_at_once = kMostAtOnce);
    ~Workers();  // does not wait for one that hangs in a file
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    // False: so many wait already that this one must come again.
    [[nodiscard]] bool offer(Work work);
    int fd() const;  // readable when finish() has something to call
    void finish();   // calls what has been returned
    std::size_t busy() const;

private:
    struct Shared;
    std::shared_ptr<Shared> shared_;
};

}  // namespace polyturn::supervisor
