// One parameter line. Reading order: name, bit, element, scope, value; each step checks what it
// read at once, so that a diagnosis names the first thing that is wrong and points at it.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "ipc/params/limits_text.hpp"
#include "ipc/params/param_file.hpp"
#include "ipc/params/utf8.hpp"

namespace polyturn::params {
namespace {

constexpr std::size_t kQuoteAtMost = 40;  // characters of the bad text that a diagnosis repeats

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name(char c) {
    return is_digit(c) || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '.';
}
bool is_blank(char c) { return c == ' ' || c == '\t'; }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

// The text as a diagnosis may show it: no control characters, not endless.
std::string shown(std::string_view text) {
    std::string out;
    std::size_t characters = 0;
    for (std::size_t at = 0; at < text.size(); ++characters) {
        if (characters == kQuoteAtMost) return out + "...";
        const std::size_t length = utf8::length_at(text, at);
        if (length == 0 || utf8::is_control(text[at])) {
            out += '?';
            ++at;
        } else {
            out += text.substr(at, length);
            at += length;
        }
    }
    return out;
}

class LineReader {
public:
    explicit LineReader(std::string_view line) : line_(line) {}

    Result<Assignment> assignment() {
        Assignment out;
        if (auto fault = target(out)) return *std::move(fault);
        skip_blanks();
        if (at_ == line_.size() || line_[at_] != '=')
            return wrong(Alarm::ParamSyntax, at_, word_length(),
                         fmt::format("{}: '=' and a value are missing", out.row->number));
        ++at_;
        skip_blanks();
        if (auto fault = value(out)) return *std::move(fault);
        return out;
    }

    Result<Target> only_target() {
        Target out;
        if (auto fault = target(out)) return *std::move(fault);
        skip_blanks();
        if (at_ < line_.size())
            return wrong(Alarm::ParamSyntax, at_, word_length(),
                         fmt::format("'{}' is too much here", word()));
        return out;
    }

private:
    using Fault = std::optional<Diagnosis>;

    Fault target(Target& out) {
        skip_blanks();
        const std::size_t begin = at_;
        while (at_ < line_.size() && is_name(line_[at_])) ++at_;
        const std::string_view name = line_.substr(begin, at_ - begin);
        if (name.empty())
            return wrong(Alarm::ParamSyntax, begin, word_length(),
                         begin == line_.size() || line_[begin] == ';'
                             ? std::string("a parameter's name is missing")
                             : fmt::format("'{}' where a parameter's name should be", word()));
        out.row = find(name);
        if (out.row == nullptr) return unknown(begin, name);
        fagor_ =
            name.size() > 3 && upper(name[0]) == 'F' && upper(name[1]) == 'G' && name[2] == '.';
        if (auto fault = bit(out)) return fault;
        if (auto fault = element(out)) return fault;
        return scope(out);
    }

    Fault unknown(std::size_t begin, std::string_view name) const {
        std::string detail = shown(name);
        const auto proposals = nearest(name);
        for (std::size_t i = 0; i < proposals.size(); ++i)
            detail +=
                fmt::format("{}{}", i == 0 ? "; nearest: " : ", ", find(proposals[i])->title());
        return wrong(Alarm::ParamUnknown, begin, name.size(), detail);
    }

    Fault bit(Target& out) {
        if (at_ == line_.size() || line_[at_] != '#') return std::nullopt;
        const std::size_t begin = at_++;
        const std::size_t length = digits();
        if (out.row->type != Type::Bits)
            return wrong(Alarm::ParamBit, begin, length + 1,
                         fmt::format("{} is one value and has no bits", out.row->title()));
        if (length != 1 || line_[begin + 1] > '7')
            return wrong(Alarm::ParamBit, begin, length + 1,
                         fmt::format("{} has the bits #0 to #7", out.row->title()));
        out.bit = line_[begin + 1] - '0';
        return std::nullopt;
    }

    Fault element(Target& out) {
        if (at_ == line_.size() || line_[at_] != '[') return std::nullopt;
        const std::size_t begin = at_++;
        const std::size_t length = digits();
        const auto index = whole(line_.substr(begin + 1, length));
        if (!index || at_ == line_.size() || line_[at_] != ']')
            return wrong(Alarm::ParamSyntax, begin, length + 1,
                         "an index in brackets is a number: [5]");
        ++at_;
        if (out.row->array == 1)
            return wrong(Alarm::ParamElement, begin, length + 2,
                         fmt::format("{} has no index", out.row->title()));
        if (*index >= out.row->array)
            return wrong(Alarm::ParamElement, begin, length + 2,
                         fmt::format("{} has the indices [0] to [{}]", out.row->title(),
                                     out.row->array - 1));
        out.element = static_cast<int>(*index);
        return std::nullopt;
    }

    Fault scope(Target& out) {
        const std::size_t gap = at_;
        skip_blanks();
        if (at_ == line_.size() || line_[at_] == '=' || line_[at_] == ';') return std::nullopt;
        const std::size_t begin = at_;
        const Row& row = *out.row;
        const char letter = scope_letter(row.scope);
        while (at_ < line_.size() && is_name(line_[at_])) ++at_;
        const std::string_view text = line_.substr(begin, at_ - begin);
        if (text.empty() || gap == begin)
            return wrong(Alarm::ParamSyntax, begin, word_length(),
                         fmt::format("'{}' behind {}", word_from(begin), row.number));
        if (letter == '\0')
            return wrong(
                Alarm::ParamScope, begin, text.size(),
                fmt::format("{} exists once, {} cannot be chosen", row.title(), shown(text)));
        // Fagor names the axis itself: FG.DFORMAT X=4.
        if (row.scope == Scope::Axis && fagor_ && text.size() == 1 &&
            std::string_view("XYZUVWABC").find(upper(text[0])) != std::string_view::npos) {
            out.axis = upper(text[0]);
            return std::nullopt;
        }
        const auto index = whole(text.substr(1));
        if (upper(text[0]) != letter || !index)
            return wrong(Alarm::ParamScope, begin, text.size(),
                         fmt::format("{} exists once per {} ({}1 to {}{}), not per {}", row.title(),
                                     to_string(row.scope), letter, letter, instances(row.scope),
                                     shown(text)));
        if (*index < 1 || *index > instances(row.scope))
            return wrong(Alarm::ParamScope, begin, text.size(),
                         fmt::format("{}: {} is outside {}1 to {}{}", row.title(), shown(text),
                                     letter, letter, instances(row.scope)));
        out.instance = static_cast<unsigned>(*index);
        return std::nullopt;
    }

    Fault value(Assignment& out) {
        const std::size_t begin = at_;
        if (out.row->type == Type::Text) return text_value(out, begin);
        std::size_t end = std::min(line_.find(';', begin), line_.size());
        while (end > begin && is_blank(line_[end - 1])) --end;
        const std::string_view text = line_.substr(begin, end - begin);
        at_ = end;
        if (text.empty())
            return wrong(Alarm::ParamValue, begin, 1,
                         fmt::format("{}: the value is missing", out.row->title()));
        if (out.bit != Target::kWhole) return bit_value(out, begin, text);
        if (out.row->type == Type::Bits && text.size() == 8 &&
            text.find_first_not_of("01") == std::string_view::npos) {
            unsigned pattern = 0;
            // the leftmost digit is #7
            for (const char c : text) pattern = pattern << 1 | (c == '1' ? 1U : 0U);
            out.number = pattern;
        } else if (auto fault = plain_number(*out.row, begin, text, out.number)) {
            return fault;
        }
        if (out.number < out.row->min || out.number > out.row->max)
            return wrong(Alarm::ParamRange, begin, text.size(),
                         fmt::format("{} = {}, allowed {}{}{}", out.row->title(), shown(text),
                                     limits_text(*out.row), out.row->unit.empty() ? "" : " ",
                                     out.row->unit));
        return std::nullopt;
    }

    Fault bit_value(Assignment& out, std::size_t begin, std::string_view text) const {
        const Row& row = *out.row;
        if (text != "0" && text != "1")
            return wrong(
                Alarm::ParamBit, begin, text.size(),
                fmt::format("{} bit #{} is 0 or 1, not '{}'", row.title(), out.bit, shown(text)));
        if (text == "1" && (static_cast<unsigned>(row.max) >> out.bit & 1U) == 0)
            return wrong(Alarm::ParamBit, begin, text.size(),
                         fmt::format("{} bit #{} is reserved and stays 0", row.title(), out.bit));
        out.number = text == "1" ? 1.0 : 0.0;
        return std::nullopt;
    }

    Fault plain_number(const Row& row, std::size_t begin, std::string_view text,
                       double& out) const {
        const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
        const std::string_view digits = plus ? text.substr(1) : text;
        double number = 0.0;
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), number);
        const bool whole_read = end == digits.data() + digits.size();
        if (error == std::errc::result_out_of_range && whole_read)
            return wrong(
                Alarm::ParamRange, begin, text.size(),
                fmt::format("{} = {}, allowed {}", row.title(), shown(text), limits_text(row)));
        // also inf and nan, which from_chars reads
        if (error != std::errc() || !whole_read || !std::isfinite(number)) {
            const bool comma = text.find(',') != std::string_view::npos;
            return wrong(Alarm::ParamValue, begin, text.size(),
                         fmt::format("{}: '{}' is no number{}", row.title(), shown(text),
                                     comma ? "; decimals stand behind a point" : ""));
        }
        if (row.type != Type::Real && number != std::trunc(number))
            return wrong(Alarm::ParamValue, begin, text.size(),
                         fmt::format("{} = {}, wanted a whole number", row.title(), shown(text)));
        out = number + 0.0;  // -0 becomes 0: one value, one spelling
        return std::nullopt;
    }

    Fault text_value(Assignment& out, std::size_t begin) {
        std::size_t end = begin;
        if (begin < line_.size() && line_[begin] == '"') {
            for (end = begin + 1; end < line_.size() && line_[end] != '"'; ++end) {
                if (line_[end] == '\\' && end + 1 < line_.size() &&
                    (line_[end + 1] == '"' || line_[end + 1] == '\\'))
                    ++end;
                out.text += line_[end];
            }
            if (end == line_.size())
                return wrong(Alarm::ParamSyntax, begin, 1,
                             fmt::format("{}: the closing \" is missing", out.row->title()));
            ++end;
            at_ = end;
            skip_blanks();
            if (at_ < line_.size() && line_[at_] != ';')
                return wrong(Alarm::ParamSyntax, at_, word_length(),
                             fmt::format("'{}' behind the text", word()));
        } else {
            end = std::min(line_.find(';', begin), line_.size());
            while (end > begin && is_blank(line_[end - 1])) --end;
            out.text = line_.substr(begin, end - begin);
        }
        at_ = end;
        return check_text(*out.row, out.text, begin, end - begin);
    }

    Fault check_text(const Row& row, std::string_view text, std::size_t begin,
                     std::size_t length) const {
        const auto refuse = [&](std::string_view why) {
            return wrong(Alarm::ParamText, begin, std::max<std::size_t>(length, 1),
                         fmt::format("{}: {}", row.title(), why));
        };
        if (!utf8::is_printable(text))
            return refuse("the text holds control characters or is not UTF-8");
        if (!text_allowed(row, text))
            return refuse(fmt::format("'{}', allowed {}", shown(text), limits_text(row)));
        return std::nullopt;
    }

    void skip_blanks() {
        while (at_ < line_.size() && is_blank(line_[at_])) ++at_;
    }
    // Steps over digits and says how many there were.
    std::size_t digits() {
        const std::size_t begin = at_;
        while (at_ < line_.size() && is_digit(line_[at_])) ++at_;
        return at_ - begin;
    }
    static std::optional<unsigned long> whole(std::string_view text) {
        unsigned long out = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
        if (text.empty() || error != std::errc() || end != text.data() + text.size())
            return std::nullopt;
        return out;
    }
    // From here to the next blank: what a mark goes under when the rest is not understood.
    std::size_t length_from(std::size_t begin) const {
        std::size_t end = begin;
        while (end < line_.size() && !is_blank(line_[end]) && line_[end] != '=' &&
               line_[end] != ';')
            ++end;
        return std::max<std::size_t>(end - begin, begin < line_.size() ? 1 : 0);
    }
    std::size_t word_length() const { return length_from(at_); }
    std::string word_from(std::size_t begin) const {
        return shown(line_.substr(begin, length_from(begin)));
    }
    std::string word() const { return word_from(at_); }

    Diagnosis wrong(Alarm alarm, std::size_t begin, std::size_t length, std::string detail) const {
        Diagnosis out;
        out.alarm = alarm;
        out.place.line = 1;
        out.place.column = static_cast<std::uint32_t>(utf8::characters(line_.substr(0, begin)) + 1);
        out.place.length = static_cast<std::uint32_t>(
            std::max<std::size_t>(utf8::characters(line_.substr(begin, length)), 1));
        out.detail = std::move(detail);
        return out;
    }

    std::string_view line_;
    std::size_t at_ = 0;
    bool fagor_ = false;  // the name began with FG.
};

}  // namespace

Result<Assignment> parse_assignment(std::string_view line) {
    auto result = LineReader(line).assignment();
    if (result.ok()) result->place = Place{"", 1, 0, 0};
    return result;
}

Result<Target> parse_target(std::string_view text) { return LineReader(text).only_target(); }

}  // namespace polyturn::params
