// Measured errors that an operator enters: cells and grid points in the machine's own file, whole
// and checked.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "ipc/model/compensation/compensation_tables.hpp"
#include "ipc/model/files/read_file.hpp"
#include "tests/unit/toolmgmt/tools/tool_rig.hpp"

namespace polyturn {
namespace {

using test::ToolRig;
using toolmgmt::Json;

Json rows(std::initializer_list<Json> all) {  // a list in a list: braces alone leave open how many
    Json out = Json::array();
    for (const Json& one : all) out.push_back(one);
    return out;
}

// A pitch table of A2 with four cells; a grid of L1 over A1 and A2, 2 by 2, machine zero at point
// 1.
struct Measured : ToolRig {
    std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("cells-" + std::to_string(getpid()));
    Measured() {
        std::filesystem::create_directories(folder);
        compensation_file = (folder / "machine.compensation").string();
        for (const char* line : {"N2500 A2=1", "N2501 A2=10", "N2502 A2=10001", "N2503 A2=10000",
                                 "N2504 A2=10003", "N2700 L1=1", "N2701 L1=2", "N2703 L1=2",
                                 "N2704 L1=2", "N2706 L1=1", "N2709 L1=50", "N2710 L1=50"})
            set(line);
    }
    ~Measured() {
        std::error_code none;
        std::filesystem::remove_all(folder, none);
    }
    std::string text() const {
        const auto read = text::read_text_file(compensation_file);
        return read ? *read : std::string();
    }
};

TEST(Compensation, ACellIsKeptWithoutGaps) {
    Measured rig;
    ASSERT_TRUE(
        rig.run({{"do", "compensation.set"}, {"cells", rows({Json::array({10002, 0.004})})}}))
        << rig.said();
    EXPECT_FALSE(rig.answer.contains("warning")) << rig.answer;
    EXPECT_EQ(rig.text(),
              "10000=0\n10001=0\n10002=0.004\n10003=0\n"
              "3D L1 0=0 0 0\n3D L1 1=0 0 0\n3D L1 2=0 0 0\n"
              "3D L1 3=0 0 0\n");
    ASSERT_TRUE(
        rig.run({{"do", "compensation.set"}, {"points", rows({Json::array({1, 2, 1, -0.002})})}}))
        << rig.said();
    EXPECT_NE(rig.text().find("10002=0.004\n"), std::string::npos);
    EXPECT_NE(rig.text().find("3D L1 2=0 -0.002 0\n"), std::string::npos);
}

TEST(Compensation, WhatCannotBeIsRefusedAsAWhole) {
    Measured rig;
    ASSERT_TRUE(
        rig.run({{"do", "compensation.set"}, {"cells", rows({Json::array({10002, 0.004})})}}));
    const std::string kept = rig.text();
    for (const Json& wrong :
         {Json{{"cells", rows({Json::array({9999, 1})})}},
          Json{{"cells", rows({Json::array({10000, "far"})})}},
          Json{{"cells", rows({Json::array({10000, 1e300})})}},
          Json{{"cells", rows({Json::array({10000})})}}, Json{{"cells", Json::array()}},
          Json{{"points", rows({Json::array({1, 4, 0, 1})})}},
          Json{{"points", rows({Json::array({1, 0, 2, 1})})}},
          Json{{"points", rows({Json::array({9, 0, 0, 1})})}},
          Json{{"points", rows({Json::array({1, 1, 0, 0.001})})}},
          Json{{"cells", rows({Json::array({10001, 1}), Json::array({30000, 1})})}}}) {
        Json request = {{"do", "compensation.set"}};
        request.update(wrong);
        EXPECT_FALSE(rig.run(request)) << wrong;
        EXPECT_EQ(rig.text(), kept) << wrong;
    }
    EXPECT_TRUE(
        rig.run({{"do", "compensation.set"}, {"points", rows({Json::array({1, 1, 0, 0})})}}))
        << "machine zero may be given its 0";
    EXPECT_FALSE(rig.run({{"do", "compensation.set"}, {"cells", rows({Json::array({10001, 1})})}},
                         UserLevel::Setter))
        << "as the parameters that lay it out";
    rig.compensation_file.clear();
    EXPECT_FALSE(rig.run({{"do", "compensation.set"}, {"cells", rows({Json::array({10001, 1})})}}))
        << "a machine without a folder";
}

// A program has measured (G10 L50) since the page read the file: what is added is added to that.
TEST(Compensation, WhatIsAddedIsAddedToWhatTheFileHasByThen) {
    Measured rig;
    const auto cell = [&](const Json& value) {
        return rig.run(
            {{"do", "compensation.set"}, {"cells", rows({Json::array({10002, value})})}});
    };
    const auto point = [&](const Json& value) {
        return rig.run(
            {{"do", "compensation.set"}, {"points", rows({Json::array({1, 2, 1, value})})}});
    };
    ASSERT_TRUE(cell(0.025) && point(0.1)) << rig.said();
    ASSERT_TRUE(cell({{"delta", 0.005}})) << rig.said();
    EXPECT_EQ(rig.answer["entries"][0]["old"], 0.025);
    EXPECT_EQ(rig.answer["entries"][0]["new"], 0.03);
    EXPECT_NE(rig.text().find("10002=0.03\n"), std::string::npos) << rig.text();
    ASSERT_TRUE(point({{"delta", -0.02}})) << rig.said();
    EXPECT_NE(rig.text().find("3D L1 2=0 0.08 0\n"), std::string::npos) << rig.text();
    EXPECT_EQ(rig.answer["entries"][0]["new"], 0.08);
    const std::string kept = rig.text();
    EXPECT_FALSE(cell({{"value", 0.025}, {"expected", 0.02}}))
        << "nothing is taken back that does not stand there any more";
    EXPECT_FALSE(cell({{"delta", 1e300}}));
    EXPECT_FALSE(cell(Json::object()));
    EXPECT_FALSE(rig.run({{"do", "compensation.set"},
                          {"points", rows({Json::array({1, 1, 0, {{"delta", 0.001}}})})}}))
        << "machine zero";
    EXPECT_EQ(rig.text(), kept);
    ASSERT_TRUE(rig.run({{"do", "compensation.set"},
                         {"cells", rows({Json::array({10002, {{"delta", 0.001}}}),
                                         Json::array({10002, {{"delta", 0.001}}})})}}))
        << rig.said();
    EXPECT_NE(rig.text().find("10002=0.032\n"), std::string::npos) << rig.text();
}

TEST(Compensation, OneEndOfARepeatingTableIsKeptAndToldOf) {
    Measured rig;
    for (const char* line : {"N2500 A2=5", "N2502 A2=10000", "N2506 A2=30"}) rig.set(line);
    ASSERT_TRUE(
        rig.run({{"do", "compensation.set"}, {"cells", rows({Json::array({10000, 0.001})})}}));
    EXPECT_NE(rig.answer.value("warning", "").find("10003"), std::string::npos) << rig.answer;
    ASSERT_TRUE(
        rig.run({{"do", "compensation.set"}, {"cells", rows({Json::array({10003, 0.001})})}}));
    EXPECT_FALSE(rig.answer.contains("warning")) << rig.answer;
}

TEST(Compensation, AMeasuredFileIsTakenWholeOrNotAtAll) {
    Measured rig;
    const std::string file = (rig.folder / "new.compensation").string(),
                      good =
                          "; gauge\n10000=0.1\n10001=0\n10002=0.2\n"
                          "10003=0.3\n3D L1 0=0 0 0\n3D L1 1=0 0 0\n"
                          "3D L1 2=1 2 0\n3D L1 3=0 0 0\n";
    const auto take = [&](const std::string& text) {
        std::ofstream(file) << text;
        return rig.run({{"do", "compensation.import"}, {"file", file}});
    };
    ASSERT_TRUE(take(good)) << rig.said();
    EXPECT_EQ(rig.text(), good);
    for (const std::string& bad :
         {std::string("10000=0.1\n"), good + "10003=1\n", good + "what\n"}) {
        EXPECT_FALSE(take(bad)) << bad;
        EXPECT_EQ(rig.text(), good);
    }
    EXPECT_FALSE(
        rig.run({{"do", "compensation.import"}, {"file", (rig.folder / "none").string()}}));
}

}  // namespace
}  // namespace polyturn
