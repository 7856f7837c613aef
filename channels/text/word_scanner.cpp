#include "channels/text/word_scanner.hpp"

#include <algorithm>

#include "channels/text/chars.hpp"
#include "channels/text/number.hpp"

namespace polyturn::channels {
namespace {

enum class Kind : std::uint8_t {
    Other,
    Blank,
    Letter,
    Digit,
    Open,
    Slash,
    Semicolon,
    Percent,
    Hash,
    Comma,
    Colon,
    Name
};

constexpr std::array<Kind, 256> make_kinds() {
    std::array<Kind, 256> kinds{};
    for (unsigned c = 'A'; c <= 'Z'; ++c) kinds[c] = Kind::Letter;
    for (unsigned c = 'a'; c <= 'z'; ++c) kinds[c] = Kind::Letter;
    for (unsigned c = '0'; c <= '9'; ++c) kinds[c] = Kind::Digit;
    kinds[' '] = kinds['\t'] = Kind::Blank;
    kinds['('] = Kind::Open;
    kinds['/'] = Kind::Slash;
    kinds[';'] = Kind::Semicolon;
    kinds['%'] = Kind::Percent;
    kinds['<'] = Kind::Name;
    kinds['#'] = Kind::Hash;
    kinds[','] = Kind::Comma;
    kinds[':'] = Kind::Colon;
    // begin a value without address
    kinds['.'] = kinds['-'] = kinds['+'] = kinds['['] = kinds['='] = Kind::Digit;
    return kinds;
}
constexpr auto kKinds = make_kinds();

Kind kind_of(char c) { return kKinds[static_cast<unsigned char>(c)]; }

}  // namespace

ScanStop WordScanner::fail(Alarm alarm, const char* line, const char* at, std::size_t length,
                           char letter) {
    fault_ = {alarm, static_cast<std::uint16_t>(at - line + 1), static_cast<std::uint16_t>(length),
              letter};
    return ScanStop::Fault;
}

ScanStop WordScanner::scan(std::string_view text, std::size_t from, Block& block) {
    const char* const line = text.data();
    const char* const end = line + text.size();
    const char* p = line + from;
    block.clear();
    bool only_number = true;  // nothing but N so far: a macro statement may begin here
    for (;;) {
        while (p != end && (*p == ' ' || *p == '\t')) ++p;
        if (p == end) {
            stopped_at_ = text.size();
            return ScanStop::EndOfLine;
        }
        const char* const begin = p;
        char comma = 0;
        switch (kind_of(*p)) {
            case Kind::Open: {
                while (p != end && *p != ')') ++p;
                if (p == end) return fail(Alarm::CommentOpen, line, begin, 1);
                ++p;
                continue;
            }
            case Kind::Slash: {
                ++p;
                unsigned number = 1;
                if (p != end && *p >= '1' && *p <= '9') number = static_cast<unsigned>(*p++ - '0');
                if (hook_->skip_sign_waits()) return ScanStop::NeedsBarrier;
                // the rest of the block, which may not be that of the line
                if (hook_->block_skip(number)) {
                    while (p != end && *p != ';') p = *p == '(' ? std::find(p, end, ')') : p + 1;
                    stopped_at_ = static_cast<std::size_t>(p - line) + (p != end ? 1 : 0);
                    return ScanStop::Skipped;
                }
                continue;
            }
            case Kind::Name: {  // M98 <NAME>
                if (!hook_->takes_program_names)
                    return fail(Alarm::CharacterUnknown, line, begin, 1, '<');
                while (p != end && *p != '>') ++p;
                if (p == end || p == begin + 1 || block.name_length)
                    return fail(Alarm::CharacterUnknown, line, begin, 1, '<');
                block.name_from = static_cast<std::uint16_t>(begin + 1 - line);
                block.name_length = static_cast<std::uint16_t>(p - begin - 1);
                only_number = false;
                ++p;
                continue;
            }
            case Kind::Semicolon:
                stopped_at_ = static_cast<std::size_t>(p - line) + 1;
                return ScanStop::EndOfBlock;
            case Kind::Percent:
                stopped_at_ = static_cast<std::size_t>(p - line);
                return ScanStop::TapeMark;
            case Kind::Hash:
                if (!only_number) return fail(Alarm::AddressMissing, line, begin, 1);
                stopped_at_ = static_cast<std::size_t>(p - line);
                return ScanStop::Macro;
            case Kind::Digit:
                if (*begin == '[' && only_number && hook_->names_in_brackets) {
                    stopped_at_ = static_cast<std::size_t>(p - line);
                    return ScanStop::Macro;
                }
                return fail(Alarm::AddressMissing, line, begin, 1);
            case Kind::Comma:
                ++p;
                if (p == end || kind_of(*p) != Kind::Letter)
                    return fail(Alarm::CharacterUnknown, line, begin, 1, ',');
                comma = ',';
                break;
            case Kind::Other:
                return fail(Alarm::CharacterUnknown, line, begin, 1, *begin);
            default:
                break;
        }
        if (block.count == Block::kMaxWords) return fail(Alarm::WordsTooMany, line, begin, 1);
        Word& word = block.words[block.count];
        word.address = *p == ':' ? 'O' : capital(*p);
        word.axis = -1;
        if (hook_->has_long_names && !comma) {
            int axis = -1;
            if (const std::size_t taken = hook_->axis_name(p, end, axis)) {
                word.axis = static_cast<std::int8_t>(axis);
                p += taken - 1;
            }
        }
        ++p;
        while (p != end && (*p == ' ' || *p == '\t')) ++p;
        if (p != end && *p == '(') skip_comments(p, end);
        if (p != end && *p == '=' && (word.axis >= 0 || word.address == 'P')) ++p;
        if (p != end && word.axis < 0 && kind_of(*p) == Kind::Letter) {
            // Two letters in a row: a control word of the macro language, or an address without a
            // number.
            if (!only_number) return fail(Alarm::NumberMissing, line, begin, 1, word.address);
            stopped_at_ = static_cast<std::size_t>(begin - line);
            return ScanStop::Macro;
        }
        const char* q = p;
        if (q != end && (*q == '-' || *q == '+')) ++q;
        while (q != end && *q == ' ') ++q;
        if (q != end && *q == '(') skip_comments(q, end);
        if (q != end && (*q == '#' || *q == '[')) {
            word.from_expression = true;
            word.has_point = true;
            double value = 0.0;
            const bool negative = *p == '-';
            p = q;
            switch (hook_->read_value(p, end, value)) {
                case ScanHook::Read::NeedsBarrier:
                    return ScanStop::NeedsBarrier;
                case ScanHook::Read::Fault: {
                    stopped_at_ = static_cast<std::size_t>(p - line);
                    fault_ = {};  // the hook knows more
                    return ScanStop::Fault;
                }
                case ScanHook::Read::Null:
                    if (word.address == 'N' || word.address == 'O')
                        return fail(Alarm::MacroFormat, line, begin, 1, word.address);
                    only_number = false;
                    if (word.axis < 0 && !comma && block.empty_count < block.empties.size())
                        block.empties[block.empty_count++] = {
                            word.address, static_cast<std::uint8_t>(block.count)};
                    continue;  // a word whose variable is empty does not exist
                case ScanHook::Read::Value:
                    break;
            }
            word.value = negative ? -value : value;
        } else {
            // X - 5
            const bool apart = q > p + 1 && (*p == '-' || *p == '+') && q != end &&
                               ((*q >= '0' && *q <= '9') || *q == '.');
            const bool turned = apart && *p == '-';
            if (apart) p = q;
            const ScannedNumber number = scan_number(p, end);
            word.from_expression = false;
            switch (number.status) {
                case ScannedNumber::Status::Missing:
                    return fail(Alarm::NumberMissing, line, begin, 1, word.address);
                case ScannedNumber::Status::SecondPoint:
                    if (word.address == 'P') {
                        while (p != end && ((*p >= '0' && *p <= '9') || *p == '.')) ++p;
                        block.has_list = true;
                        break;
                    }
                    return fail(Alarm::SecondPoint, line, p, 1, word.address);
                case ScannedNumber::Status::TooManyDigits:
                    return fail(Alarm::DigitsTooMany, line, begin,
                                static_cast<std::size_t>(p - begin), word.address);
                case ScannedNumber::Status::Ok:
                    break;
            }
            word.has_point = number.has_point;
            word.value = turned ? -number.value : number.value;
        }
        word.column = static_cast<std::uint16_t>(begin - line + 1);
        word.length = static_cast<std::uint16_t>(p - begin);
        if (comma) {
            word.address = static_cast<char>(word.address + 32);
        } else if (word.axis < 0) {
            if (word.address != 'N' && word.address != 'O') only_number = false;
            block.letters |= letter_bit(word.address);
            block.last[static_cast<std::size_t>(word.address - 'A')] =
                static_cast<std::uint8_t>(block.count);
        } else {
            only_number = false;
        }
        ++block.count;
    }
}

std::uint32_t character_column(std::string_view line, std::uint32_t column) {
    std::uint32_t characters = 1;
    for (std::size_t i = 0; i + 1 < column && i < line.size(); ++i)
        if ((static_cast<unsigned char>(line[i]) & 0xC0) != 0x80) ++characters;
    return characters;
}

}  // namespace polyturn::channels
