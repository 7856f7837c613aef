#include "kernel/supervisor/start/request_socket.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace polyturn::supervisor {
namespace {

using Taken = RequestServer::Taken;

socklen_t abstract_name(const std::string& instance, sockaddr_un& address) {
    const std::string name = "polyturn." + instance;
    address = {};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path + 1, name.data(), name.size());
    return static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
}

int connect_to(const std::string& instance) {
    auto fd = connect_to_controller(instance, true);
    EXPECT_TRUE(fd) << fd.diagnosis().text();
    return fd ? *fd : -1;
}

std::string read_now(int fd) {
    std::string out;
    char block[65536];
    for (ssize_t got = 0; (got = ::recv(fd, block, sizeof block, MSG_DONTWAIT)) > 0;)
        out.append(block, static_cast<std::size_t>(got));
    return out;
}

bool closed(int fd) {
    char one = 0;
    const auto got = ::recv(fd, &one, 1, MSG_DONTWAIT);
    return got == 0 || (got < 0 && errno != EAGAIN);
}

void tell(int fd, const std::string& lines) {
    std::size_t done = 0;
    while (done < lines.size()) {
        const auto wrote =
            ::send(fd, lines.data() + done, lines.size() - done, MSG_DONTWAIT | MSG_NOSIGNAL);
        if (wrote <= 0) break;
        done += static_cast<std::size_t>(wrote);
    }
}

std::string press(const std::string& words) {
    return R"({"do":"press","words":")" + words + "\"}\n";
}

class Served : public ::testing::Test {
protected:
    void SetUp() override {
        auto opened = RequestServer::open(instance_);
        ASSERT_TRUE(opened) << opened.diagnosis().text();
        server_ = std::make_unique<RequestServer>(std::move(*opened));
    }
    void TearDown() override {
        for (const int fd : open_) ::close(fd);
    }
    int client() {
        open_.push_back(connect_to(instance_));
        serve();
        return open_.back();
    }
    void serve(int turns = 1) {
        for (int i = 0; i < turns; ++i)
            server_->serve(1, [&](RequestServer::Client client, const Request& request) {
                asked_.emplace_back(client, request.words);
                return take_ ? take_(client, request) : Taken::Yes;
            });
    }
    std::vector<std::string> words() const {
        std::vector<std::string> out;
        for (const auto& [client, words] : asked_) out.push_back(words);
        return out;
    }
    RequestServer::Client who(const std::string& words) const {
        for (const auto& [client, said] : asked_)
            if (said == words) return client;
        return 0;
    }
    std::string instance_ = "served-" + std::to_string(::getpid());
    std::unique_ptr<RequestServer> server_;
    std::vector<std::pair<RequestServer::Client, std::string>> asked_;
    RequestServer::Handler take_;
    std::vector<int> open_;
};

// A screen asks the store something that takes its time, and meanwhile for the alarms: it must not
// take the one for the other.
TEST_F(Served, TheLinesOfAConnectionAreAnsweredInTheirOrder) {
    const int first = client(), second = client();
    tell(first, press("slow") + press("quick") + press("last"));
    tell(second, press("other"));
    serve(3);
    ASSERT_EQ(asked_.size(), 4u);
    server_->answer(who("quick"), "to quick");
    EXPECT_EQ(read_now(first), "");
    server_->answer(who("other"), "to other");
    EXPECT_EQ(read_now(second), "to other\n") << "nobody waits for another's answer";
    server_->answer(who("slow"), "to slow");
    EXPECT_EQ(read_now(first), "to slow\nto quick\n");
    server_->answer(who("slow"), "to slow");
    EXPECT_EQ(read_now(first), "") << "a line is answered once";
    server_->answer(who("last"), "to last");
    EXPECT_EQ(read_now(first), "to last\n");
    EXPECT_EQ(server_->uid_of(who("slow")), static_cast<std::int64_t>(::getuid()));
}

TEST_F(Served, WhatIsNoRequestIsAnsweredAndNobodyHearsOfIt) {
    const int one = client();
    tell(one, "\n[[[[\n" + press("reset") + "{\"do\":7}\n");
    serve(3);
    EXPECT_EQ(words(), std::vector<std::string>{"reset"});
    server_->answer(who("reset"), "done");
    const std::string answers = read_now(one);
    EXPECT_EQ(std::count(answers.begin(), answers.end(), '\n'), 4);
    EXPECT_NE(answers.find("PT0335"), std::string::npos);
}

TEST_F(Served, AStopActsBeforeWhatStandsInFrontOfItAndAgainBehindAStart) {
    const int one = client();
    take_ = [this](RequestServer::Client client, const Request& request) {
        // no room yet
        if (request.words == "mode L1=auto" && asked_.size() < 4) return Taken::Later;
        server_->answer(client, request.words);
        return Taken::Yes;
    };
    tell(one, press("mode L1=auto") + press("cycle_start") + press("feed_hold"));
    serve();
    ASSERT_GE(asked_.size(), 2u);
    EXPECT_EQ(asked_[0].second, "feed_hold");
    EXPECT_EQ(read_now(one), "") << "its answer keeps its place";
    serve(5);
    EXPECT_EQ(words().back(), "feed_hold")
        << "a start that stood in front of it does not have the last word";
    EXPECT_EQ(std::count(asked_.begin(), asked_.end(),
                         std::pair(who("feed_hold"), std::string("feed_hold"))),
              2);
    EXPECT_EQ(read_now(one), "mode L1=auto\ncycle_start\nfeed_hold\n");
}

TEST_F(Served, AStopThatComesAloneActsOnce) {
    const int one = client();
    tell(one, press("emergency_stop"));
    serve(3);
    EXPECT_EQ(words(), std::vector<std::string>{"emergency_stop"});
}

TEST_F(Served, WhatStandsBehindOneThatHoldsWaitsForItsAnswer) {
    const int one = client(), other = client();
    take_ = [](RequestServer::Client, const Request& request) {
        return request.words.starts_with("select") ? Taken::Holds : Taken::Yes;
    };
    tell(one, press("select L1=O1.nc") + press("cycle_start"));
    tell(other, press("mode L1=auto"));
    serve(5);
    EXPECT_EQ(who("cycle_start"), 0u) << "no start in front of its program";
    EXPECT_NE(who("mode L1=auto"), 0u) << "nobody else waits";
    server_->answer(who("select L1=O1.nc"), "done");
    serve();
    EXPECT_NE(who("cycle_start"), 0u);
}

TEST_F(Served, OneConnectionDoesNotKeepTheOthersFromTheirTurn) {
    const int flood = client(), quiet = client();
    std::string many;
    for (int i = 0; i < 500; ++i) many += press("jog A1+ 1");
    tell(flood, many);
    tell(quiet, press("mode L1=auto"));
    serve();
    const auto mine = std::find(asked_.begin(), asked_.end(),
                                std::pair(who("mode L1=auto"), std::string("mode L1=auto")));
    ASSERT_NE(mine, asked_.end());
    EXPECT_LE(mine - asked_.begin(), 2) << "one line of each in turn";
}

TEST_F(Served, WhoDoesNotReadIsReadNoMore) {
    const int one = client();
    take_ = [this](RequestServer::Client client, const Request&) {
        server_->answer(client, std::string(20'000, 'x'));
        return Taken::Yes;
    };
    std::string many;
    for (int i = 0; i < 1'000; ++i) many += press("mode L1=auto");
    for (int i = 0; i < 50; ++i) {
        tell(one, many);
        serve();
    }
    EXPECT_LE(asked_.size() * 20'000, RequestServer::kMostUnread + 600'000)
        << "what waits for him, with what the system keeps for him, is bounded";
    const std::size_t before = asked_.size();
    EXPECT_GT(read_now(one).size(), 0u);
    serve(20);
    EXPECT_GT(asked_.size(), before) << "he is heard again when he has read";
}

TEST_F(Served, ALineThatIsTooLongIsRefusedAndPassedOver) {
    const int one = client();
    const std::string much(100'000, 'x');
    std::string told;
    for (int i = 0; i < 40; ++i) {
        tell(one, much);
        serve(16);
        told += read_now(one);
    }
    EXPECT_NE(told.find("PT0335"), std::string::npos);
    EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 1) << "one line, one answer";
    tell(one, "\n" + press("reset"));
    serve(40);
    EXPECT_EQ(words(), std::vector<std::string>{"reset"});
    for (int i = 0; i < 400 && !closed(one); ++i) {
        tell(one, much);
        serve(16);
    }
    EXPECT_TRUE(closed(one)) << "one that never ends";
}

TEST_F(Served, SoManyConnectionsAndNoMore) {
    std::vector<int> many;
    for (std::size_t i = 0; i < RequestServer::kConnections; ++i) many.push_back(client());
    const std::string refused = [&] {
        const int more = client();
        return read_now(more);
    }();
    const std::size_t most = ::geteuid() == 0
                                 ? RequestServer::kConnections
                                 : RequestServer::kConnections - RequestServer::kKeptForRoot;
    EXPECT_NE(refused.find("PT0336"), std::string::npos) << refused;
    tell(many[most - 1], press("reset"));
    serve(2);
    EXPECT_NE(who("reset"), 0u);
    ::close(many[0]);
    open_.erase(std::find(open_.begin(), open_.end(), many[0]));
    serve(2);
    const int again = client();
    tell(again, press("feed_hold"));
    serve(2);
    EXPECT_NE(who("feed_hold"), 0u);
}

// Another user of the computer: needs the right to become one.
TEST_F(Served, AGuestHasHisShareAndRootHasRoomBehindHim) {
    if (::geteuid() != 0) GTEST_SKIP() << "only root can become somebody else";
    server_->set_guests([](std::int64_t uid) { return uid == 12'345; });
    int told[2];
    ASSERT_EQ(::pipe(told), 0);
    const pid_t guest = ::fork();
    if (guest == 0) {
        if (::setgid(12'345) != 0 || ::setuid(12'345) != 0) ::_exit(2);
        int in = 0;
        for (int i = 0; i < 32; ++i)
            if (const auto fd = connect_to_controller(instance_, false); fd) ++in;
        (void)!::write(told[1], &in, sizeof in);
        ::pause();
        ::_exit(0);
    }
    int in = 0;
    ::close(told[1]);
    while (::read(told[0], &in, sizeof in) != static_cast<ssize_t>(sizeof in)) {}
    ::close(told[0]);
    serve(10);
    const int own = client();
    tell(own, press("feed_hold"));
    serve(2);
    EXPECT_NE(who("feed_hold"), 0u) << "32 connections of one guest (" << in << ") shut nobody out";
    ::kill(guest, SIGKILL);
    ::waitpid(guest, nullptr, 0);
}

TEST_F(Served, TheSocketStandsInAFolderThatNobodyElseWrites) {
    ASSERT_FALSE(server_->path().empty());
    struct stat about {};
    ASSERT_EQ(::stat(server_->path().substr(0, server_->path().rfind('/')).c_str(), &about), 0);
    EXPECT_EQ(about.st_uid, ::geteuid());
    EXPECT_EQ(about.st_mode & 022, 0u);
    const std::string path = server_->path();
    server_.reset();
    EXPECT_NE(::access(path.c_str(), F_OK), 0) << "it goes with the controller";
}

TEST(ControllerDoor, TwoOfOneNameDoNotRun) {
    const std::string instance = "twice-" + std::to_string(::getpid());
    const auto first = ControllerDoor::open(instance);
    ASSERT_TRUE(first);
    const auto second = ControllerDoor::open(instance);
    ASSERT_FALSE(second);
    EXPECT_EQ(second.diagnosis().alarm, Alarm::InstanceRuns);
}

TEST(ControllerDoor, NobodyListens) {
    const auto none = connect_to_controller("nobody-" + std::to_string(::getpid()), true);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.diagnosis().alarm, Alarm::SegmentMissing);
}

// faults.md L8: whoever took the name first was sent passwords.
TEST(ControllerDoor, AStrangerWhoTookTheNameIsToldNothingAndKeepsNobodyFromStarting) {
    if (::geteuid() != 0) GTEST_SKIP() << "only root can become somebody else";
    const std::string instance = "taken-" + std::to_string(::getpid());
    int told[2];
    ASSERT_EQ(::pipe(told), 0);
    const pid_t stranger = ::fork();
    if (stranger == 0) {
        if (::setgid(12'345) != 0 || ::setuid(12'345) != 0) ::_exit(2);
        sockaddr_un address;
        const socklen_t size = abstract_name(instance, address);
        const int fd = ::socket(AF_UNIX, SOCK_STREAM, 0);
        const bool good =
            ::bind(fd, reinterpret_cast<sockaddr*>(&address), size) == 0 && ::listen(fd, 5) == 0;
        (void)!::write(told[1], &good, sizeof good);
        for (;;) {
            const int in = ::accept(fd, nullptr, nullptr);
            char heard = 0;
            if (::read(in, &heard, 1) > 0) ::_exit(7);  // a password, perhaps
            ::close(in);
        }
    }
    bool good = false;
    ASSERT_EQ(::read(told[0], &good, sizeof good), static_cast<ssize_t>(sizeof good));
    ASSERT_TRUE(good);
    const auto foreign = ask_controller(
        instance, R"({"do":"store","op":{"do":"users.login","name":"a","password":"secret"}})",
        1000);
    ASSERT_FALSE(foreign);
    EXPECT_EQ(foreign.diagnosis().alarm, Alarm::InstanceForeign);
    {
        const auto door = ControllerDoor::open(instance);
        ASSERT_TRUE(door) << "it runs all the same: " << door.diagnosis().text();
        EXPECT_TRUE(door->name_is_foreign());
        const auto fd = connect_to_controller(instance, true);
        ASSERT_TRUE(fd) << "and is found";
        ::close(*fd);
    }
    ::kill(stranger, SIGTERM);
    int status = 0;
    ::waitpid(stranger, &status, 0);
    EXPECT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) == 7) << "it was told something";
    ::close(told[0]);
    ::close(told[1]);
}

}  // namespace
}  // namespace polyturn::supervisor
