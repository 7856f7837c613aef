#include "kernel/supervisor/request_socket.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <vector>

namespace polyturn::supervisor {
namespace {

int connect_to(const std::string& instance) {
    const std::string name = "polyturn." + instance;
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path + 1, name.data(), name.size());
    const int fd = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(::connect(fd, reinterpret_cast<sockaddr*>(&address), static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size())), 0);
    return fd;
}

std::string read_now(int fd) {
    char block[512];
    const auto got = ::recv(fd, block, sizeof block, MSG_DONTWAIT);
    return got > 0 ? std::string(block, static_cast<std::size_t>(got)) : std::string();
}

// A screen asks the store something that takes its time, and meanwhile for the alarms: it must not take the one for the other.
TEST(RequestServer, AnswersTheLinesOfAConnectionInTheirOrder) {
    const std::string instance = "order-" + std::to_string(::getpid());
    auto server = RequestServer::open(instance);
    ASSERT_TRUE(server) << server.diagnosis().text();
    const int first = connect_to(instance), second = connect_to(instance);
    std::vector<std::pair<RequestServer::Client, std::string>> asked;
    const auto serve = [&] { server->serve(50, [&](RequestServer::Client client, const std::string& line) { asked.emplace_back(client, line); }); };
    serve();   // lets them in
    ASSERT_EQ(::send(first, "slow\nquick\nlast\n", 16, 0), 16);
    ASSERT_EQ(::send(second, "other\n", 6, 0), 6);
    for (int i = 0; i < 20 && asked.size() < 4; ++i) serve();
    ASSERT_EQ(asked.size(), 4u);
    const auto tell = [&](const char* line) {
        for (const auto& [client, text] : asked)
            if (text == line) server->answer(client, "to " + text);
    };
    tell("quick");
    EXPECT_EQ(read_now(first), "");
    tell("other");
    EXPECT_EQ(read_now(second), "to other\n") << "nobody waits for another's answer";
    tell("slow");
    EXPECT_EQ(read_now(first), "to slow\nto quick\n");
    tell("slow");
    EXPECT_EQ(read_now(first), "") << "a line is answered once";
    tell("last");
    EXPECT_EQ(read_now(first), "to last\n");
    EXPECT_EQ(server->uid_of(asked.front().first), static_cast<std::int64_t>(::getuid()));
    ::close(first), ::close(second);
}

}  // namespace
}  // namespace polyturn::supervisor
