#include "kernel/supervisor/base/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "ipc/memory/life_line.hpp"
#include "ipc/model/files/machine_path.hpp"

namespace polyturn::supervisor {

Child::Child(Child&& other) noexcept { *this = std::move(other); }

Child& Child::operator=(Child&& other) noexcept {
    if (this != &other) {
        kill_and_reap();
        close_all();
        pid_ = std::exchange(other.pid_, 0);
        pidfd_ = std::exchange(other.pidfd_, -1);
        input_ = std::exchange(other.input_, -1);
        output_ = std::exchange(other.output_, -1);
        status_ = other.status_;
    }
    return *this;
}

Child::~Child() {
    kill_and_reap();
    close_all();
}

void Child::close_input() {
    if (input_ >= 0) close(std::exchange(input_, -1));
}

void Child::close_all() {
    close_input();
    if (output_ >= 0) close(std::exchange(output_, -1));
    if (pidfd_ >= 0) close(std::exchange(pidfd_, -1));
}

Result<Child> Child::start(const std::string& program, const std::vector<std::string>& arguments,
                           Pipes pipes, WhenLeftAlone alone) {
    const std::string path =
        program.front() == '/' ? program : text::program_folder() + "/" + program;
    const auto fault = [&](const char* what) {
        return Diagnosis{Alarm::ProcessStart,
                         {},
                         {},
                         fmt::format("{} ({}: {})", path, what, std::strerror(errno))};
    };

    // everything the child needs is made before fork: after it only async-signal-safe calls
    std::vector<char*> argv;
    argv.push_back(const_cast<char*>(program.c_str()));
    for (const auto& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const bool in_order = alone == WhenLeftAlone::EndsInOrder;
    std::string supervisor = fmt::format("{}={}", kSupervisorWord, getpid());
    std::vector<char*> environment;
    for (char** word = environ; *word; ++word)
        // not our own supervisor's
        if (!std::string_view(*word).starts_with(fmt::format("{}=", kSupervisorWord)))
            environment.push_back(*word);
    if (in_order) environment.push_back(supervisor.data());
    environment.push_back(nullptr);

    int in[2] = {-1, -1}, out[2] = {-1, -1}, told[2] = {-1, -1};
    if (pipe2(told, O_CLOEXEC) != 0) return fault("pipe");
    if (pipes.input && pipe2(in, O_CLOEXEC) != 0) return fault("pipe");
    if (pipes.output && pipe2(out, O_CLOEXEC) != 0) return fault("pipe");
    static const int usual = getpriority(PRIO_PROCESS, 0);  // the first is started before the loop
    const pid_t parent = getpid(), pid = fork();
    if (pid < 0) return fault("fork");
    if (pid == 0) {
        if (!in_order) prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent) _exit(127);  // the parent died before prctl
        // the supervisor's loop may have raised its own
        (void)setpriority(PRIO_PROCESS, 0, usual);
        // Ctrl-C is for the supervisor, which stops its children in order
        setpgid(0, 0);
        if (pipes.input) dup2(in[0], 0);
        if (pipes.output) dup2(out[1], 1);
        sigset_t none;
        sigemptyset(&none);
        sigprocmask(SIG_SETMASK, &none, nullptr);
        ::signal(SIGPIPE, SIG_DFL);
        execve(path.c_str(), argv.data(), environment.data());
        const int why = errno;
        if (write(told[1], &why, sizeof why) < 0) {}
        _exit(127);
    }
    close(told[1]);
    int why = 0;
    const bool failed = read(told[0], &why, sizeof why) == static_cast<ssize_t>(sizeof why);
    close(told[0]);
    if (pipes.input) close(in[0]);
    if (pipes.output) close(out[1]);
    Child child;
    child.pid_ = pid;
    child.input_ = in[1];
    child.output_ = out[0];
    if (failed) {
        child.kill_and_reap();
        errno = why;
        return fault("cannot be started");
    }
    child.pidfd_ = static_cast<int>(syscall(SYS_pidfd_open, pid, 0));
    return child;
}

bool Child::reap() {
    if (pid_ <= 0) return true;
    int status = 0;
    const pid_t got = waitpid(pid_, &status, WNOHANG);
    if (got == 0 || (got < 0 && errno == EINTR)) return false;
    status_ = got < 0 ? 0 : WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
    pid_ = 0;
    return true;
}

void Child::signal(int number) const {
    if (pid_ > 0) ::kill(pid_, number);
}

void Child::kill_and_reap() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {}
    status_ = WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
    pid_ = 0;
}

void Child::end_within(int milliseconds) {
    if (pid_ <= 0) return;
    if (pidfd_ >= 0) {
        pollfd ended{pidfd_, POLLIN, 0};
        while (poll(&ended, 1, milliseconds) < 0 && errno == EINTR) {}
    }
    if (!reap()) kill_and_reap();
}

std::string describe_end(int status) {
    if (status < 0) return fmt::format("was killed by signal {} ({})", -status, strsignal(-status));
    return fmt::format("ended with status {}", status);
}

}  // namespace polyturn::supervisor
