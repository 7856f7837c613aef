#include "channels/fagor/grammar/reader.hpp"

#include "channels/text/chars.hpp"
#include "channels/text/number.hpp"

namespace polyturn::channels::fagor {
namespace {

// Behind the skip conditions.
void skip_conditions(const char*& at, const char* end) {
    for (blanks(at, end); at != end && *at == '/'; blanks(at, end)) {
        ++at;
        blanks(at, end);
        if (at != end && is_digit(*at)) ++at;
    }
}

// N and up to eight digits; -1: no label here.
std::int64_t take_label(const char*& at, const char* end) {
    if (at == end || *at != 'N') return -1;
    const char* p = at + 1;
    blanks(p, end);
    if (p == end || !is_digit(*p)) return -1;
    std::int64_t number = 0;
    for (unsigned digits = 0; p != end && is_digit(*p) && digits < 9; ++p, ++digits)
        number = number * 10 + (*p - '0');
    at = p;
    return number;
}

}  // namespace

std::int64_t label_of(std::string_view line) {
    const char* at = line.data();
    const char* const end = at + line.size();
    skip_conditions(at, end);
    return take_label(at, end);
}

std::string_view statement_of(std::string_view line) {
    const char* at = line.data();
    const char* const end = at + line.size();
    skip_conditions(at, end);
    take_label(at, end);
    blanks(at, end);
    if (at == end || *at != '(') return {};
    ++at;
    blanks(at, end);
    return {at, static_cast<std::size_t>(end - at)};
}

bool Reader::fail(Alarm alarm, const char* at, std::size_t length, std::string detail) {
    fault_ = {alarm, static_cast<std::uint32_t>(at - begin_) + 1,
              static_cast<std::uint32_t>(length), std::move(detail)};
    return false;
}

BlockKind Reader::read(std::string_view line, Block& block) {
    begin_ = line.data();
    end_ = begin_ + line.size();
    block.count = 0;
    block.label = block.repeat = -1;
    const char* at = begin_;
    blanks(at, end_);
    if (at == end_) return BlockKind::Blank;
    if (*at == '%') return BlockKind::Title;
    bool skipped = false;
    unsigned conditions = 0;
    while (at != end_ && *at == '/') {
        const char* const sign = at++;
        blanks(at, end_);
        unsigned number = 1;
        if (at != end_ && is_digit(*at)) number = static_cast<unsigned>(*at++ - '0');
        if (number < 1 || number > 3 || ++conditions > 3) {
            fail(Alarm::FagorSkip, sign, static_cast<std::size_t>(at - sign));
            return BlockKind::Fault;
        }
        skipped = skipped || host_->block_skip(number);
        blanks(at, end_);
    }
    if (skipped) return BlockKind::Skipped;
    if (at != end_ && *at == 'N') {
        const char* const begin = at;
        block.label = take_label(at, end_);
        if (block.label < 0 || (at != end_ && (is_digit(*at) || *at == '.'))) {
            fail(Alarm::FagorLabel, begin, static_cast<std::size_t>(at - begin) + 1);
            return BlockKind::Fault;
        }
        if (block.label > 99'999'999) {
            fail(Alarm::FagorLabel, begin, static_cast<std::size_t>(at - begin));
            return BlockKind::Fault;
        }
    }
    blanks(at, end_);
    if (at == end_ || *at == ';') return BlockKind::Comment;
    if (*at == '(') return statement(at, block);
    for (;;) {
        blanks(at, end_);
        if (at == end_ || *at == ';') return BlockKind::Iso;
        if (!word(at, block)) return BlockKind::Fault;
    }
}

BlockKind Reader::statement(const char* at, Block& block) {
    const char* const open = at++;
    unsigned depth = 1;
    bool quoted = false;
    for (block.statement = static_cast<std::size_t>(at - begin_); at != end_; ++at) {
        if (*at == '"') quoted = !quoted;
        if (quoted) continue;
        if (*at == '(') ++depth;
        if (*at == ')' && --depth == 0) break;
    }
    if (at == end_) {
        fail(Alarm::FagorBracket, open, 1);
        return BlockKind::Fault;
    }
    block.statement_end = static_cast<std::size_t>(at - begin_);
    ++at;
    blanks(at, end_);
    if (at != end_ && *at == 'N') {
        const char* const begin = at;
        block.repeat = take_label(at, end_);
        if (block.repeat < 0 || block.repeat > 9999) {
            fail(Alarm::FagorLabel, begin, static_cast<std::size_t>(at - begin) + 1);
            return BlockKind::Fault;
        }
        blanks(at, end_);
    }
    if (at != end_ && *at != ';') {
        fail(Alarm::CharacterUnknown, at, 1, std::string(1, *at));
        return BlockKind::Fault;
    }
    return BlockKind::Statement;
}

// A letter and its number; blanks may be between letter, sign and digits; P<n> stands for the
// value of a parameter.
bool Reader::word(const char*& at, Block& block) {
    const char* const begin = at;
    if (!is_capital(*at)) {
        if (is_digit(*at) || *at == '.' || *at == '-' || *at == '+')
            return fail(Alarm::AddressMissing, at, 1, std::string(1, *at));
        return fail(Alarm::CharacterUnknown, at, 1, std::string(1, *at));
    }
    if (block.count == Block::kMostWords) return fail(Alarm::WordsTooMany, at, 1);
    Word& word = block.words[block.count];
    word = {};
    word.letter = *at++;
    const char* p = at;
    blanks(p, end_);
    double sign = 1.0;
    bool signed_number = false;
    while (p != end_ && (*p == '-' || *p == '+') && !signed_number) {
        if (*p == '-') sign = -1.0;
        signed_number = true;
        ++p;
        blanks(p, end_);
    }
    if (p != end_ && *p == 'P' && p + 1 != end_ && is_digit(p[1])) {
        const char* const name = p++;
        std::int64_t number = 0;
        for (unsigned digits = 0; p != end_ && is_digit(*p) && digits < 6; ++p, ++digits)
            number = number * 10 + (*p - '0');
        double value = 0.0;
        if (word.letter == 'N' && block.count == 0)
            return fail(Alarm::FagorLabel, begin, static_cast<std::size_t>(p - begin));
        if (const auto alarm = host_->parameter_value(number, value))
            return fail(*alarm, name, static_cast<std::size_t>(p - name), std::string(name, p));
        word.value = sign * value;
        word.given = word.parameter = true;
        at = p;
    } else if (p != end_ && (is_digit(*p) || *p == '.')) {
        const ScannedNumber number = scan_number(p, end_);
        if (number.status != ScannedNumber::Status::Ok) {
            const Alarm alarm =
                number.status == ScannedNumber::Status::SecondPoint     ? Alarm::SecondPoint
                : number.status == ScannedNumber::Status::TooManyDigits ? Alarm::DigitsTooMany
                                                                        : Alarm::NumberMissing;
            return fail(alarm, begin, static_cast<std::size_t>(p - begin), std::string(begin, p));
        }
        word.value = sign * number.value;
        word.given = true;
        at = p;
    } else if (signed_number) {
        return fail(Alarm::NumberMissing, begin, static_cast<std::size_t>(p - begin),
                    std::string(1, word.letter));
    }
    word.column = static_cast<std::uint16_t>(begin - begin_ + 1);
    word.length = static_cast<std::uint16_t>(at - begin);
    ++block.count;
    return true;
}

}  // namespace polyturn::channels::fagor
