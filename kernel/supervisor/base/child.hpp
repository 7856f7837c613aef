// A child process: its program is in the same bin/, watched by its pidfd; dies with it, or ends in
// order behind it.
#pragma once
#include <sys/types.h>

#include <string>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::supervisor {

class Child {
public:
    struct Pipes {
        bool input = false, output = false;  // our ends become input_fd() and output_fd()
    };
    // When this process is killed: the child at once; or it finds out by itself and ends in order
    // (ipc/memory/life_line.hpp).
    enum class WhenLeftAlone { Dies, EndsInOrder };
    Child() = default;
    Child(Child&& other) noexcept;
    Child& operator=(Child&& other) noexcept;
    ~Child();  // SIGKILL and reaped: nothing of a run outlives it

    // program: name of an executable beside ours.
    static Result<Child> start(const std::string& program,
                               const std::vector<std::string>& arguments, Pipes pipes,
                               WhenLeftAlone alone = WhenLeftAlone::Dies);
    static Result<Child> start(const std::string& program,
                               const std::vector<std::string>& arguments) {
        return start(program, arguments, Pipes{});
    }

    bool running() const { return pid_ > 0; }
    pid_t pid() const { return pid_; }
    int pidfd() const { return pidfd_; }  // readable when it has died
    int input_fd() const { return input_; }
    int output_fd() const { return output_; }
    // Dead already? Reaps it then.
    bool reap();
    // What waitpid said, once reaped: exit status, or minus the signal.
    int status() const { return status_; }
    void signal(int number) const;
    void kill_and_reap();
    // Waits for it to end by itself, at most so long; then it is killed.
    void end_within(int milliseconds);
    void close_input();

private:
    void close_all();
    pid_t pid_ = 0;
    int pidfd_ = -1, input_ = -1, output_ = -1, status_ = 0;
};

// "ended with status 3", "was killed by signal 9 (Killed)".
std::string describe_end(int status);

}  // namespace polyturn::supervisor
