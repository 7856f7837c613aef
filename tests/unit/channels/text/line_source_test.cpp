#include "channels/text/line_source.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/property.hpp"

namespace polyturn::channels {
namespace {

std::vector<std::string> all_lines(LineSource& source) {
    std::vector<std::string> lines;
    std::string_view line;
    while (source.next(line) == LineSource::Status::Line) lines.emplace_back(line);
    return lines;
}

struct TempFile {
    std::string path = (std::filesystem::temp_directory_path() /
                        ("polyturn_line_source_" + std::to_string(::getpid()) + ".nc"))
                           .string();
    explicit TempFile(const std::string& content) {
        std::ofstream(path, std::ios::binary) << content;
    }
    ~TempFile() { std::filesystem::remove(path); }
};

struct Row {
    std::string_view text;
    std::vector<std::string> lines;
};

TEST(LineSource, EndsLinesAtLfCrlfAndCr) {
    const Row rows[] = {
        {"", {}},
        {"G0", {"G0"}},
        {"G0\n", {"G0"}},
        {"G0\r\nG1\r\n", {"G0", "G1"}},
        {"G0\rG1\r", {"G0", "G1"}},
        {"G0\n\nG1", {"G0", "", "G1"}},
        {"G0\r\rG1\n", {"G0", "", "G1"}},
        {"\xEF\xBB\xBFG0\nG1", {"G0", "G1"}},  // byte order mark of UTF-8
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(std::string(row.text));
        LineSource source;
        ASSERT_TRUE(source.open_text(row.text, "t").ok());
        EXPECT_EQ(all_lines(source), row.lines);
    }
}

TEST(LineSource, RefusesWhatIsNoText) {
    LineSource source;
    EXPECT_EQ(source.open("/does/not/exist").diagnosis().alarm, Alarm::FileUnreadable);
    EXPECT_EQ(source.open("/tmp").diagnosis().alarm, Alarm::FileKind);
    EXPECT_EQ(source.open_text(std::string_view("\xFF\xFEG\0", 4), "t").diagnosis().alarm,
              Alarm::FileUtf16);
    EXPECT_EQ(source.open_text(std::string_view("G\0000\0", 4), "t").diagnosis().alarm,
              Alarm::FileUtf16);
    EXPECT_EQ(source.open_text(std::string_view("G0 X1\nG1\0Z", 10), "t").diagnosis().alarm,
              Alarm::FileBinary);
}

TEST(LineSource, ALineLongerThanABlockCanBeIsToldNotKept) {
    const std::string text(LineSource::kLongestLine + 1, 'X');
    LineSource source;
    ASSERT_TRUE(source.open_text(text, "t").ok());
    std::string_view line;
    EXPECT_EQ(source.next(line), LineSource::Status::TooLong);
}

// The window moves; the lines and every position handed out stay right.
TEST(LineSource, SeeksBackToEveryLineOfAFileLargerThanItsWindow) {
    std::string content;
    for (int k = 0; content.size() < 3 * LineSource::kWindow; ++k)
        content +=
            "N" + std::to_string(k) + " G1 X" + std::to_string(k % 100) + (k % 3 ? "\n" : "\r\n");
    const TempFile file(content);
    LineSource source;
    ASSERT_TRUE(source.open(file.path).ok());
    std::vector<std::pair<TextPosition, std::string>> seen;
    std::string_view line;
    while (source.next(line) == LineSource::Status::Line)
        seen.emplace_back(source.position(), std::string(line));
    ASSERT_GT(seen.size(), 10000u);
    for (std::size_t k = 0; k < seen.size(); k += 997) {
        const auto& [position, text] = seen[seen.size() - 1 - k];
        source.seek(position);
        ASSERT_EQ(source.next(line), LineSource::Status::Line);
        EXPECT_EQ(line, text);
        EXPECT_EQ(source.position().line, position.line);
    }
}

PROPERTY(LineSource, LosesNoCharacterWhateverTheLineEnds, ()) {
    const auto parts = *rc::gen::container<std::vector<std::string>>(
        rc::gen::container<std::string>(rc::gen::elementOf(std::string("GX1 .\n\r"))));
    std::string text, kept;
    for (const std::string& part : parts) text += part;
    for (const char c : text)
        if (c != '\n' && c != '\r') kept += c;
    LineSource source;
    RC_ASSERT(source.open_text(text, "t").ok());
    std::string joined;
    for (const std::string& line : all_lines(source)) joined += line;
    RC_ASSERT(joined == kept);
}

}  // namespace
}  // namespace polyturn::channels
