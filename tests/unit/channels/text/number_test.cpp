#include "channels/text/number.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <string_view>

#include "tests/property.hpp"

namespace polyturn::channels {
namespace {

using Status = ScannedNumber::Status;

struct Row {
    std::string_view text;
    Status status;
    double value;
    bool point;
    std::size_t taken;
};

TEST(ScanNumber, ReadsOneNumberAndLeavesTheRest) {
    const Row rows[] = {
        {"40.", Status::Ok, 40, true, 3},
        {"-.5X", Status::Ok, -0.5, true, 3},
        {"+7 ", Status::Ok, 7, false, 2},
        {"007.250", Status::Ok, 7.25, true, 7},
        {"", Status::Missing, 0, false, 0},
        {"-", Status::Missing, 0, false, 1},
        {".", Status::Missing, 0, true, 1},
        {"4.0.", Status::SecondPoint, 0, true, 3},
        {"1234567890123456789", Status::TooManyDigits, 0, false, 18},
        {"0.0000000000000000001", Status::TooManyDigits, 0, true, 21},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(std::string(row.text));
        const char* at = row.text.data();
        const ScannedNumber number = scan_number(at, row.text.data() + row.text.size());
        EXPECT_EQ(number.status, row.status);
        if (row.status == Status::Ok) {
            EXPECT_DOUBLE_EQ(number.value, row.value);
            EXPECT_EQ(number.has_point, row.point);
        }
        EXPECT_EQ(static_cast<std::size_t>(at - row.text.data()), row.taken);
    }
}

// Up to 15 digits it rounds exactly as the C library does.
PROPERTY(ScanNumber, AgreesWithTheLibrary, ()) {
    const auto digits = *rc::gen::inRange<std::int64_t>(0, 1'000'000'000'000'000);
    const int places = *rc::gen::inRange(0, 16);
    std::string text = std::to_string(digits);
    if (static_cast<int>(text.size()) > places)
        text.insert(text.size() - static_cast<std::size_t>(places), ".");
    else
        text.insert(0, ".");
    const char* at = text.data();
    RC_ASSERT(scan_number(at, text.data() + text.size()).value ==
              std::strtod(text.c_str(), nullptr));
}

}  // namespace
}  // namespace polyturn::channels
