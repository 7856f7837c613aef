// Reads one decimal number in place in a program: no copy, no locale, no allocation. Exact:
// up to 18 digits are gathered as an integer and divided once by a power of ten, which rounds
// correctly below 2^53.
#pragma once
#include <cstdint>

namespace polyturn::channels {

struct ScannedNumber {
    enum class Status : std::uint8_t { Ok, Missing, SecondPoint, TooManyDigits };
    Status status = Status::Missing;
    bool has_point = false;
    double value = 0.0;
};

inline constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8, 1e9,
                                          1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18};

// [+-] digits [. digits]; blanks inside are no part of it. `at` is moved behind the number (behind
// the bad character where the status is not Ok).
inline ScannedNumber scan_number(const char*& at, const char* end) {
    ScannedNumber result;
    const char* p = at;
    bool negative = false;
    if (p != end && (*p == '-' || *p == '+')) negative = *p++ == '-';
    std::uint64_t digits = 0;
    unsigned count = 0, places = 0;
    bool any = false;
    for (; p != end; ++p) {
        const unsigned digit = static_cast<unsigned char>(*p) - unsigned{'0'};
        if (digit <= 9) {
            any = true;
            if (count || digit) ++count;
            if (count > 18) {
                result.status = ScannedNumber::Status::TooManyDigits;
                at = p;
                return result;
            }
            digits = digits * 10 + digit;
            places += result.has_point;
        } else if (*p == '.') {
            if (result.has_point) {
                result.status = ScannedNumber::Status::SecondPoint;
                at = p;
                return result;
            }
            result.has_point = true;
        } else {
            break;
        }
    }
    at = p;
    if (!any) return result;
    if (places > 18) {
        result.status = ScannedNumber::Status::TooManyDigits;
        return result;
    }
    const double magnitude = static_cast<double>(digits) / kPowersOfTen[places];
    result.value = negative ? -magnitude : magnitude;
    result.status = ScannedNumber::Status::Ok;
    return result;
}

}  // namespace polyturn::channels
