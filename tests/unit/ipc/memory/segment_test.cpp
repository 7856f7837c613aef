// Who may attach to a segment, and what is cleaned up when its writer is dead.
#include "ipc/memory/segment.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

namespace polyturn {
namespace {

std::string fresh_instance() { return "test-" + std::to_string(getpid()) + "-segment"; }

TEST(Segment, IsReadByAnotherProcessOnceItIsPublished) {
    const std::string instance = fresh_instance();
    auto own = OwnSegment<PlcSegment>::create(instance, 1);
    ASSERT_TRUE(own.ok());
    EXPECT_EQ(PeerSegment<PlcSegment>::attach(instance).diagnosis().alarm, Alarm::SegmentNotReady);
    (*own)->cycle.store(42);
    own->publish();
    const pid_t child = fork();
    if (child == 0) {
        auto peer = PeerSegment<PlcSegment>::attach(instance);
        _exit(peer.ok() && (*peer)->cycle.load() == 42 ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    remove_instance(instance);
    EXPECT_EQ(PeerSegment<PlcSegment>::attach(instance).diagnosis().alarm, Alarm::SegmentMissing);
}

TEST(Segment, OfAnotherLayoutIsRefused) {
    const std::string instance = fresh_instance();
    auto own = OwnSegment<PlcSegment>::create(instance, 1);
    ASSERT_TRUE(own.ok());
    (*own)->header.layout_hash ^= 1;
    own->publish();
    const auto peer = PeerSegment<PlcSegment>::attach(instance);
    ASSERT_FALSE(peer.ok());
    EXPECT_EQ(peer.diagnosis().alarm, Alarm::SegmentLayout);
    remove_instance(instance);
}

TEST(Segment, OfADeadWriterIsCleanedAndThatOfALivingOneIsNot) {
    const std::string dead = fresh_instance() + "-dead", living = fresh_instance() + "-living";
    const pid_t child = fork();
    if (child == 0) {
        auto own = OwnSegment<PlcSegment>::create(dead, 1);
        if (own) own->publish();
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    auto own = OwnSegment<PlcSegment>::create(living, 1);
    ASSERT_TRUE(own.ok());
    own->publish();
    // One is being made just now and has no header yet; the maker of another was killed in that
    // moment.
    const std::string young = segment_name(fresh_instance() + "-young", SegmentKind::Plc),
                      orphan = segment_name(fresh_instance() + "-orphan", SegmentKind::Plc);
    const auto being_made = RawSegment::create(young, sizeof(PlcSegment));
    ASSERT_TRUE(being_made.ok());
    const pid_t maker = fork();
    if (maker == 0) _exit(RawSegment::create(orphan, sizeof(PlcSegment)).ok() ? 0 : 1);
    int made = 1;
    ASSERT_EQ(waitpid(maker, &made, 0), maker);
    ASSERT_EQ(made, 0);
    const auto removed = remove_dead_instances();
    const auto was_removed = [&](const std::string& name, pid_t by) {
        return std::find(removed.begin(), removed.end(), name + ".of-" + std::to_string(by)) !=
               removed.end();
    };
    EXPECT_FALSE(was_removed(young, getpid()));
    EXPECT_TRUE(was_removed(orphan, maker));
    std::filesystem::remove("/dev/shm/" + young + ".of-" + std::to_string(getpid()));
    EXPECT_NE(std::find(removed.begin(), removed.end(), segment_name(dead, SegmentKind::Plc)),
              removed.end());
    EXPECT_EQ(std::find(removed.begin(), removed.end(), segment_name(living, SegmentKind::Plc)),
              removed.end());
    EXPECT_TRUE(PeerSegment<PlcSegment>::attach(living).ok());
    remove_instance(living);
}

TEST(Instance, NamesAreLettersDigitsDashAndUnderscore) {
    for (const char* good : {"a", "line-3_left", "0"}) EXPECT_TRUE(valid_instance(good)) << good;
    for (const char* bad :
         {"", "a.b", "a/b", "a b", "ü", "12345678901234567890123456789012345678901"})
        EXPECT_FALSE(valid_instance(bad)) << bad;
}

constexpr uid_t kStranger = 65534;  // nobody: neither root nor a user of the controller

// What `act` answers as the stranger; -1: it did not come back in ten seconds.
template <class Act>
int as_stranger(Act act) {
    const pid_t child = fork();
    if (child == 0) {
        alarm(10);
        _exit(setgid(kStranger) == 0 && setuid(kStranger) == 0 ? act() : 99);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string shared(const std::string& name) { return "/dev/shm/" + name; }

// Seen before: the start, every run and `clean` waited for a writer of the pipe, for ever.
TEST(ForeignSegments, APipeUnderOurNameHoldsNobody) {
    const std::string instance = fresh_instance() + "-pipe",
                      name = segment_name(instance, SegmentKind::Plc);
    ASSERT_EQ(::mkfifo(shared(name).c_str(), 0666), 0);
    alarm(60);
    EXPECT_EQ(PeerSegment<PlcSegment>::attach(instance).diagnosis().alarm, Alarm::InstanceForeign);
    EXPECT_EQ(OwnSegment<PlcSegment>::adopt(instance).diagnosis().alarm, Alarm::InstanceForeign);
    for (const std::string& removed : remove_dead_instances())
        EXPECT_NE(removed, name) << "it is none of ours";
    // the pipe is our own: its name is taken over
    auto own = OwnSegment<PlcSegment>::create(instance, 1);
    EXPECT_TRUE(own.ok());
    alarm(0);
    remove_instance(instance);
}

TEST(ForeignSegments, AreNeitherReadNorTakenForOurs) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can play another user";
    const std::string instance = fresh_instance() + "-foreign",
                      name = segment_name(instance, SegmentKind::Plc);
    ASSERT_EQ(as_stranger([&] {
                  auto own = OwnSegment<PlcSegment>::create(instance, 1);
                  if (own) own->publish();
                  return own.ok() ? 0 : 1;
              }),
              0);
    EXPECT_EQ(PeerSegment<PlcSegment>::attach(instance).diagnosis().alarm, Alarm::InstanceForeign);
    for (const std::string& removed : remove_dead_instances()) EXPECT_NE(removed, name);
    ::unlink(shared(name).c_str());
    // A link to a file of ours is not ours.
    ASSERT_EQ(as_stranger([&] {
                  return ::symlink("/dev/shm/polyturn.somewhere.plc", shared(name).c_str());
              }),
              0);
    EXPECT_EQ(PeerSegment<PlcSegment>::attach(instance).diagnosis().alarm, Alarm::InstanceForeign);
    ::unlink(shared(name).c_str());
}

TEST(ForeignSegments, WhoseNameIsTakenIsToldByWhom) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can play another user";
    const std::string instance = fresh_instance() + "-taken";
    auto own = OwnSegment<PlcSegment>::create(instance, 1);
    ASSERT_TRUE(own.ok());
    own->publish();
    struct stat info {};
    ASSERT_EQ(::stat(shared(segment_name(instance, SegmentKind::Plc)).c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777, 0600u) << "nobody else reads it";
    EXPECT_EQ(as_stranger([&] {
                  return ::open(shared(segment_name(instance, SegmentKind::Plc)).c_str(),
                                O_RDONLY) < 0
                             ? 7
                             : 0;
              }),
              7);
    EXPECT_EQ(as_stranger([&] {
                  const auto taken = OwnSegment<PlcSegment>::create(instance, 1);
                  return !taken && taken.diagnosis().alarm == Alarm::InstanceForeign ? 7 : 0;
              }),
              7);
    EXPECT_TRUE(PeerSegment<PlcSegment>::attach(instance).ok()) << "it is as it was";
    remove_instance(instance);
}

}  // namespace
}  // namespace polyturn
