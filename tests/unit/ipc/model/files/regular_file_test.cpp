// The door for files: an ordinary file comes in, whole and bounded; whatever else bears a name is
// refused at once.
#include "ipc/model/files/regular_file.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "ipc/model/files/read_file.hpp"

namespace polyturn::text {
namespace {
namespace fs = std::filesystem;

class RegularFiles : public ::testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("polyturn-door-" + std::to_string(::getpid()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    std::string path(const char* name) const { return (folder_ / name).string(); }
    std::string write(const char* name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
        return path(name);
    }
    fs::path folder_;
};

TEST_F(RegularFiles, AreReadWhole) {
    const std::string bytes = "O1\nM30\n" + std::string(200'000, 'x');
    const auto file = RegularFile::open(write("a.nc", bytes));
    ASSERT_TRUE(file);
    EXPECT_EQ(file->size(), bytes.size());
    const auto text = file->read_all();
    ASSERT_TRUE(text);
    EXPECT_EQ(*text, bytes);
    fs::create_symlink(path("a.nc"), path("link.nc"));
    EXPECT_TRUE(RegularFile::open(path("link.nc"))) << "a link counts as what it leads to";
}

// Without the door the first of these waits for a writer, the second never ends.
TEST_F(RegularFiles, WhatIsNoFileIsRefusedAndNamed) {
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    fs::create_symlink(path("pipe"), path("link"));
    const int listener = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path("socket").c_str(), sizeof address.sun_path - 1);
    ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    struct Row {
        std::string path;
        Alarm alarm;
        const char* says;
    };
    for (const Row& row :
         {Row{path("pipe"), Alarm::FileKind, "pipe"}, Row{path("link"), Alarm::FileKind, "pipe"},
          Row{"/dev/zero", Alarm::FileKind, "device"}, Row{"/dev/tty", Alarm::FileKind, ""},
          Row{path("socket"), Alarm::FileKind, "socket"},
          Row{folder_.string(), Alarm::FileKind, "folder"},
          Row{path("nowhere"), Alarm::FileUnreadable, "No such file"},
          Row{"", Alarm::FileUnreadable, "No such file"},
          Row{std::string("/dev/null\0.nc", 13), Alarm::FileUnreadable, ""}}) {
        if (row.path == "/dev/tty") {  // who has no terminal cannot open it at all
            EXPECT_FALSE(RegularFile::open(row.path));
            continue;
        }
        const auto file = RegularFile::open(row.path);
        ASSERT_FALSE(file) << row.path;
        EXPECT_EQ(file.diagnosis().alarm, row.alarm) << row.path;
        EXPECT_NE(file.diagnosis().detail.find(row.says), std::string::npos)
            << row.path << ": " << file.diagnosis().detail;
        EXPECT_FALSE(read_text_file(row.path)) << row.path;
    }
    ::close(listener);
}

TEST_F(RegularFiles, HaveALimitAlsoWhenTheyGrowWhileTheyAreRead) {
    constexpr std::uint64_t kMost = 1 << 20;
    const std::string name = write("long", std::string(kMost, 'a'));
    const auto file = RegularFile::open(name, kMost);
    ASSERT_TRUE(file);
    EXPECT_TRUE(file->read_all());
    std::ofstream(name, std::ios::app) << 'b';
    const auto grown = file->read_all();
    ASSERT_FALSE(grown);
    EXPECT_EQ(grown.diagnosis().alarm, Alarm::FileTooLarge);
    const auto again = RegularFile::open(name, kMost);
    ASSERT_FALSE(again);
    EXPECT_EQ(again.diagnosis().alarm, Alarm::FileTooLarge);
    EXPECT_FALSE(again.diagnosis().text().empty());
    // an ordinary file that says it is empty
    const auto endless = RegularFile::open("/proc/self/maps", 64);
    ASSERT_TRUE(endless);
    EXPECT_FALSE(endless->read_all());
}

}  // namespace
}  // namespace polyturn::text
