// Which files an operator may name to a running controller: those of the program folders, whatever
// the name looks like.
#include "kernel/supervisor/base/reach.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "kernel/supervisor/press/press_words.hpp"

namespace polyturn::supervisor {
namespace {
namespace fs = std::filesystem;

class ReachOfLevels : public ::testing::Test {
protected:
    void SetUp() override {
        top_ = fs::temp_directory_path() / ("polyturn-reach-" + std::to_string(::getpid()));
        fs::remove_all(top_);
        for (const char* folder : {"programs/sub", "programs-not", "machine", "elsewhere"})
            fs::create_directories(top_ / folder);
        for (const char* file : {"programs/a.nc", "programs/sub/b.nc", "programs-not/c.nc",
                                 "machine/setup.toml", "elsewhere/shadow"})
            std::ofstream(top_ / file) << "M30\n";
        fs::create_symlink(top_ / "elsewhere/shadow", top_ / "programs/link.nc");
        fs::create_directory_symlink(top_ / "programs", top_ / "elsewhere/way");
    }
    void TearDown() override { fs::remove_all(top_); }
    fs::path top_;
};

TEST_F(ReachOfLevels, IsATableOfFoldersAndLevels) {
    const Reach reach({top_ / "programs", top_ / "not-there-yet", "/"}, {top_ / "machine"});
    struct Row {
        std::string file;
        UserLevel least;
    };
    for (const Row& row :
         {Row{"programs/a.nc", UserLevel::None}, Row{"programs/sub/b.nc", UserLevel::None},
          Row{"programs/not-there.nc", UserLevel::None},
          Row{"programs/sub/../a.nc", UserLevel::None}, Row{"elsewhere/way/a.nc", UserLevel::None},
          Row{"programs", UserLevel::Maker}, Row{"programs-not/c.nc", UserLevel::Maker},
          Row{"programs/../elsewhere/shadow", UserLevel::Maker},
          Row{"programs/link.nc", UserLevel::Maker}, Row{"machine/setup.toml", UserLevel::Setter},
          Row{"elsewhere/shadow", UserLevel::Maker}, Row{"../../etc/shadow", UserLevel::Maker}})
        for (const UserLevel level :
             {UserLevel::None, UserLevel::Operator, UserLevel::Setter, UserLevel::Maker}) {
            const auto may = reach.may_read((top_ / row.file).string(), level);
            EXPECT_EQ(may.ok(), level >= row.least)
                << row.file << " at level " << static_cast<int>(level);
            if (!may) { EXPECT_EQ(may.diagnosis().alarm, Alarm::FileOutside); }
        }
}

TEST(Places, AreTheAbsolutePathsOfTheList) {
    EXPECT_EQ(places_in("; the shop's server\nserver = /srv/nc ; of the office\n"
                        "bad=relative\n=/x\nno line\nlast=/a b\r\n"),
              (std::vector<fs::path>{"/srv/nc", "/a b"}));
    EXPECT_TRUE(places_in("").empty());
}

TEST(SelectedFile, IsWhatThePressedWordsName) {
    EXPECT_EQ(selected_file("select L1=a.nc", "/p"), "/p/a.nc");
    EXPECT_EQ(selected_file(" select\tL2= /etc/shadow ", "/p"), "/etc/shadow");
    EXPECT_EQ(selected_file("select sub/x.job.toml", "/p"), "/p/sub/x.job.toml");
    EXPECT_EQ(selected_file("select", "/p"), "");
    EXPECT_EQ(selected_file("selects L1=a.nc", "/p"), "");
    EXPECT_EQ(selected_file("cycle_start", "/p"), "");
}

}  // namespace
}  // namespace polyturn::supervisor
