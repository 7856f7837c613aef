// A real polyturn-toolmgmt process with a supervisor's and a kernel's segment made by the test,
// which plays both.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ipc/requests/store_requests.hpp"
#include "ipc/memory/segment.hpp"
#include "tests/places.hpp"

namespace polyturn::test {

// A store as a version left it that acknowledged nothing: somebody may have worked on its file with
// other tools.
inline void forget_acknowledged(const std::string& folder) {
    for (const char* name : {"store.witness", "store.sums"})
        std::filesystem::remove(folder + "/" + name);
    sqlite3* db = nullptr;
    if (sqlite3_open((folder + "/store.sqlite").c_str(), &db) == SQLITE_OK)
        sqlite3_exec(db, "UPDATE promise SET commits = 0", nullptr, nullptr, nullptr);
    sqlite3_close(db);
}

class StoreRig {
public:
    explicit StoreRig(const std::string& name)
        : instance("test-" + name + "-" + std::to_string(getpid())) {
        remove_instance(instance);
        auto made = OwnSegment<SupervisorSegment>::create(instance, 1);
        if (!made) throw std::runtime_error(made.diagnosis().text());
        supervisor = std::move(*made);
        supervisor.publish();
        folder = (std::filesystem::temp_directory_path() / instance).string();
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
    }
    ~StoreRig() {
        kill_now();
        remove_instance(instance);
        std::error_code none;
        std::filesystem::remove_all(folder, none);
    }

    // Starts the program; true when it has published. Its messages go to folder/stderr.
    bool start(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {std::string(kProgramFolder) + "/polyturn-toolmgmt",
                                             "--instance", instance});
        pid = spawn(arguments);
        for (int ms = 0; ms < 10'000; ms += 2) {
            auto peer = PeerSegment<StoreSegment>::attach(instance);
            if (peer && (*peer)->header.writer_pid == pid) {
                store.emplace(std::move(*peer));
                return true;
            }
            if (ended()) return false;
            sleep_ms(2);
        }
        return false;
    }
    void make_kernel() {
        auto made = OwnSegment<KernelSegment>::create(instance, 1);
        if (!made) throw std::runtime_error(made.diagnosis().text());
        kernel.emplace(std::move(*made));
        kernel->publish();
        supervisor->processes[kProcessKernel].pid = getpid();
    }

    // Sends as the supervisor; its answer, or nothing within `timeout_ms` or when the process ends.
    std::uint64_t send(StoreRequest request) {
        request.id = ++last_id;
        auto& ring = supervisor->requests;
        const auto head = ring.head.load();
        ring.slot(head) = request;
        ring.head.store(head + 1);
        supervisor->store_bell.ring();
        return request.id;
    }
    std::optional<StoreAnswer> take_answer() {
        auto& tail = supervisor->answer_tail.tail;
        if (!store || tail.load() >= (*store)->answers.head.load()) return {};
        const StoreAnswer answer = (*store)->answers.slot(tail.load());
        tail.fetch_add(1);
        return answer;
    }
    std::optional<StoreAnswer> ask(const StoreRequest& request, int timeout_ms = 10'000) {
        const auto id = send(request);
        const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(timeout_ms);
        while (std::chrono::steady_clock::now() < until) {
            if (auto answer = take_answer(); answer && answer->id == id) return answer;
            usleep(50);
        }
        return {};
    }
    std::string value_of(const std::string& parameter) {
        StoreRequest request = store_request(StoreRequestKind::Query, 0, 0, 0, 0);
        put_name(request, parameter);
        const auto answer = ask(request);
        return answer ? std::string(answer->text.data()) : "no answer";
    }
    // Sends as the kernel: what a program writes. The index behind it in the ring.
    std::uint64_t push(StoreRequest request) {
        auto& ring = (*kernel)->persist;
        const auto head = ring.head.load();
        request.id = head + 1;
        ring.slot(head) = request;
        ring.head.store(head + 1);
        (*kernel)->store_bell.ring();
        return head + 1;
    }
    // Waits until the counter has come that far.
    static bool reached(const std::atomic<std::uint64_t>& counter, std::uint64_t index,
                        int timeout_ms = 10'000) {
        const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(timeout_ms);
        while (counter.load() < index) {
            if (std::chrono::steady_clock::now() > until) return false;
            usleep(50);
        }
        return true;
    }
    std::unique_ptr<ChannelStore> channel(unsigned number) {
        auto out = std::make_unique<ChannelStore>();
        EXPECT_TRUE((*store)->channels[number - 1].read(*out));
        return out;
    }
    std::unique_ptr<params::Table> parameters() {
        auto out = std::make_unique<params::Table>();
        EXPECT_TRUE((*store)->parameters.read(*out));
        return out;
    }

    bool ended() {
        if (pid <= 0) return true;
        if (waitpid(pid, &status, WNOHANG) != pid) return false;
        pid = 0;
        return true;
    }
    int wait_end() {
        if (pid > 0) waitpid(pid, &status, 0);
        pid = 0;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    int stop() {
        if (pid > 0) ::kill(pid, SIGTERM);
        return wait_end();
    }
    void kill_now() {
        if (pid > 0) {
            ::kill(pid, SIGKILL);
            wait_end();
        }
    }
    std::string messages() const {
        std::ifstream file(folder + "/stderr");
        return {std::istreambuf_iterator<char>(file), {}};
    }

    std::string instance, folder;
    OwnSegment<SupervisorSegment> supervisor;
    std::optional<OwnSegment<KernelSegment>> kernel;
    std::optional<PeerSegment<StoreSegment>> store;
    pid_t pid = 0;
    int status = 0;
    std::uint64_t last_id = 0;

private:
    pid_t spawn(const std::vector<std::string>& arguments) const {
        std::vector<char*> argv;
        for (const std::string& argument : arguments)
            argv.push_back(const_cast<char*>(argument.c_str()));
        argv.push_back(nullptr);
        const std::string log = folder + "/stderr";
        const pid_t child = fork();
        if (child != 0) return child;
        const int fd = open(log.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0644);
        dup2(fd, 2);
        execv(argv[0], argv.data());
        _exit(127);
    }
};

}  // namespace polyturn::test
