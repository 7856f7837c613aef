// The layout of the shared image, printed from its generated table and compared with the reviewed
// listing: whoever moves a field sees it in the difference. To accept a change: POLYTURN_BLESS=1,
// then read the diff of the listing.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "ipc/image/segments.hpp"
#include "tests/places.hpp"

namespace polyturn {
namespace {

std::string listing() {
    std::ostringstream out;
    std::string_view structure;
    for (const FieldRow& field : image_fields()) {
        if (field.structure != structure) {
            structure = field.structure;
            out << structure << " (written by " << field.writer << ")\n";
        }
        out << "  " << field.offset << " +" << field.size << " " << field.field << " " << field.type
            << (field.unit.empty() ? "" : " [") << field.unit << (field.unit.empty() ? "" : "]")
            << "\n";
    }
    return out.str();
}

TEST(ImageLayout, IsTheReviewedOne) {
    const std::string path = std::string(kSourceFolder) + "/tests/golden/image_layout.txt";
    if (std::getenv("POLYTURN_BLESS")) {
        std::ofstream(path) << listing();
        FAIL() << "written: read the difference, and run again without POLYTURN_BLESS";
    }
    std::stringstream golden;
    golden << std::ifstream(path).rdbuf();
    EXPECT_EQ(golden.str(), listing());
}

TEST(ImageTable, EveryFieldHasAMeaningAndLiesBehindTheOneBefore) {
    std::string_view structure;
    std::uint32_t end = 0;
    for (const FieldRow& field : image_fields()) {
        if (field.structure != structure) {
            structure = field.structure;
            end = 0;
        }
        EXPECT_GE(field.offset, end) << structure << "." << field.field;
        EXPECT_FALSE(field.meaning.empty()) << structure << "." << field.field;
        end = field.offset + field.size;
    }
}

TEST(Signals, HaveOneSlotForEachInstance) {
    std::set<std::pair<SignalWriter, std::uint32_t>> used;
    for (const SignalRow& row : signal_rows()) {
        const std::size_t count = row.scope == SignalScope::Global    ? 1
                                  : row.scope == SignalScope::Channel ? kMaxChannels
                                  : row.scope == SignalScope::Axis    ? kMaxAxes
                                                                      : kMaxSpindles;
        const std::size_t slots =
            count * (row.elements ? row.elements : 1) * (row.kind == SignalKind::Double ? 2 : 1);
        for (std::size_t i = 0; i < slots; ++i)
            EXPECT_TRUE(used.insert({row.writer, row.slot + static_cast<std::uint32_t>(i)}).second)
                << row.name;
    }
}

}  // namespace
}  // namespace polyturn
