#include "ipc/model/files/replace_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace polyturn::text {
namespace {
namespace fs = std::filesystem;

struct Folder {
    fs::path at = fs::path(::testing::TempDir()) / ("replace_" + std::to_string(::getpid()));
    Folder() {
        fs::remove_all(at);
        fs::create_directories(at);
    }
    ~Folder() { fs::remove_all(at); }
    std::string file() const { return (at / "kept").string(); }
    std::string content() const {
        std::ifstream in(file(), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
};

TEST(ReplaceFile, PutsAllBytesInPlaceOfTheOldOnesWithTheirRights) {
    Folder folder;
    ASSERT_TRUE(replace_file(folder.file(), std::string(100'000, 'a')));
    ::chmod(folder.file().c_str(), 0600);
    const std::string bytes("new\0bytes", 9);
    ASSERT_TRUE(replace_file(folder.file(), bytes));
    EXPECT_EQ(folder.content(), bytes);
    struct stat now {};
    ASSERT_EQ(::stat(folder.file().c_str(), &now), 0);
    EXPECT_EQ(now.st_mode & 0777, 0600u);
    EXPECT_FALSE(fs::exists(folder.file() + ".new"));
}

TEST(ReplaceFile, LeavesTheOldOneWhereTheNewOneCannotBeWritten) {
    Folder folder;
    ASSERT_TRUE(replace_file(folder.file(), "old"));
    fs::create_directories(folder.file() + ".new/in the way");
    const auto result = replace_file(folder.file(), "new");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.diagnosis().alarm, Alarm::OutputFile);
    EXPECT_NE(result.diagnosis().text().find(folder.file()), std::string::npos);
    EXPECT_EQ(folder.content(), "old");
}

TEST(ReplaceFile, NamesAFolderThatIsNotThere) {
    Folder folder;
    EXPECT_FALSE(replace_file((folder.at / "none" / "file").string(), "x"));
}

}  // namespace
}  // namespace polyturn::text
