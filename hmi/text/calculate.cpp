#include "hmi/text/calculate.hpp"

#include <charconv>
#include <cmath>
#include <string>

namespace polyturn::hmi {
namespace {

constexpr int kDeepest = 32;  // brackets in brackets

//   sum     = product { (+|-) product }
//   product = factor { (*|/) factor }
//   factor  = [+|-] (number | "(" sum ")")
class Reader {
public:
    explicit Reader(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

    std::optional<double> all() {
        const auto value = sum(0);
        blanks();
        if (!value || at_ != end_ || !std::isfinite(*value)) return std::nullopt;
        return value;
    }

private:
    void blanks() {
        while (at_ != end_ && *at_ == ' ') ++at_;
    }
    bool take(char letter) {
        blanks();
        if (at_ == end_ || *at_ != letter) return false;
        ++at_;
        return true;
    }
    std::optional<double> sum(int depth) {
        auto value = product(depth);
        while (value) {
            const bool plus = take('+');
            if (!plus && !take('-')) break;
            const auto next = product(depth);
            if (!next) return std::nullopt;
            *value += plus ? *next : -*next;
        }
        return value;
    }
    std::optional<double> product(int depth) {
        auto value = factor(depth);
        while (value) {
            const bool times = take('*');
            if (!times && !take('/')) break;
            const auto next = factor(depth);
            if (!next || (!times && *next == 0.0)) return std::nullopt;
            *value = times ? *value * *next : *value / *next;
        }
        return value;
    }
    std::optional<double> factor(int depth) {
        if (depth > kDeepest) return std::nullopt;
        if (take('-')) {
            const auto value = factor(depth + 1);
            return value ? std::optional(-*value) : std::nullopt;
        }
        if (take('+')) return factor(depth + 1);
        if (take('(')) {
            const auto value = sum(depth + 1);
            return value && take(')') ? value : std::nullopt;
        }
        blanks();
        double value = 0;
        const auto read = std::from_chars(at_, end_, value, std::chars_format::fixed);
        if (read.ec != std::errc()) return std::nullopt;
        at_ = read.ptr;
        return value;
    }
    const char* at_;
    const char* end_;
};

}  // namespace

std::optional<Entry> calculate(std::string_view text) {
    std::string plain(text);
    for (char& letter : plain)
        if (letter == ',') letter = '.';  // as half of Europe writes it
    std::size_t from = plain.find_first_not_of(' ');
    if (from == std::string::npos) return std::nullopt;
    Entry entry;
    entry.added = plain[from] == '+';
    const auto value = Reader(std::string_view(plain).substr(from + (entry.added ? 1 : 0))).all();
    if (!value) return std::nullopt;
    entry.value = *value;
    return entry;
}

}  // namespace polyturn::hmi
