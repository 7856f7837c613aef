#include "channels/fanuc/program/block_index.hpp"

#include <algorithm>
#include <limits>

#include "channels/text/chars.hpp"

namespace polyturn::channels::fanuc {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }
constexpr std::uint64_t kBytes = (std::uint64_t{1} << 48) - 1;
constexpr std::uint64_t kNoEnd = std::numeric_limits<std::uint64_t>::max();

}  // namespace

std::int64_t leading_number(std::string_view line, char letter, bool colon) {
    std::size_t i = 0;
    for (;;) {
        while (i < line.size() && is_blank(line[i])) ++i;
        if (i < line.size() && line[i] == '/') {
            ++i;
            if (i < line.size() && is_digit(line[i])) ++i;
            continue;
        }
        if (i < line.size() && line[i] == '(') {  // a comment may stand anywhere
            const std::size_t end = line.find(')', i);
            if (end != std::string_view::npos) {
                i = end + 1;
                continue;
            }
        }
        break;
    }
    if (i == line.size()) return -1;
    const char c = line[i];
    if (c != letter && c != letter + 32 && !(colon && c == ':')) return -1;
    ++i;
    while (i < line.size() && is_blank(line[i])) ++i;
    if (i == line.size() || !is_digit(line[i])) return -1;
    std::int64_t number = 0;
    for (unsigned digits = 0; i < line.size() && is_digit(line[i]) && digits < 15; ++i, ++digits)
        number = number * 10 + (line[i] - '0');
    return number;
}

void BlockIndex::build(LineSource& source) {
    built_ = true;
    blocks_.clear();
    marks_.clear();
    const TextPosition now = source.position(), back = source.next_position();
    source.seek({0, 1});
    std::string_view line;
    while (source.next(line) == LineSource::Status::Line) {
        const TextPosition at = source.position();
        if (!line.empty() && line[0] == '%') {
            marks_.push_back({at.offset, at.line, -1, blocks_.size()});
            continue;
        }
        if (const std::int64_t program = leading_number(line, 'O', true); program >= 0)
            marks_.push_back({at.offset, at.line, program, blocks_.size()});
        for (std::size_t column = 0; column != std::string_view::npos;
             column = next_block(line, column)) {
            const std::int64_t number = leading_number(line.substr(column), 'N', false);
            if (number < 0 || number > std::numeric_limits<std::uint32_t>::max()) continue;
            blocks_.push_back({static_cast<std::uint32_t>(number), at.line,
                               (at.offset + column) & kBytes, column & 0xFFFFu});
        }
    }
    source.seek(now);
    if (back.offset != now.offset) (void)source.next(line);  // the line in hand is that one again
    blocks_.shrink_to_fit();
    if (!std::is_sorted(blocks_.begin(), blocks_.end())) std::sort(blocks_.begin(), blocks_.end());
}

const BlockIndex::Mark* BlockIndex::next_mark(std::uint64_t from) const {
    const auto mark =
        std::lower_bound(marks_.begin(), marks_.end(), from,
                         [](const Mark& m, std::uint64_t offset) { return m.offset < offset; });
    return mark == marks_.end() ? nullptr : &*mark;
}

// The program's own % and O are no end: they stand before its first block.
std::uint64_t BlockIndex::end_of(std::uint64_t begin) const {
    const Mark* mark = next_mark(begin);
    const Mark* const last = marks_.data() + marks_.size();
    const std::uint64_t before =
        begin == 0 || !mark || mark->offset != begin ? 0 : mark->blocks_before;
    bool own_number = false;
    for (; mark && mark != last; ++mark) {
        if (own_number || mark->blocks_before != before) return mark->offset;
        own_number = mark->program >= 0;
    }
    return kNoEnd;
}

std::optional<TextPlace> BlockIndex::block(std::int64_t number, std::uint64_t begin,
                                           std::uint64_t here) const {
    if (number < 0 || number > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
    const auto find = [&](std::uint64_t from, std::uint64_t until) -> std::optional<TextPlace> {
        const Block wanted{static_cast<std::uint32_t>(number), 0, from & kBytes, 0};
        const auto found = std::lower_bound(blocks_.begin(), blocks_.end(), wanted);
        if (found == blocks_.end() || found->number != wanted.number || found->byte >= until)
            return std::nullopt;
        return TextPlace({found->byte - found->column, found->line}, found->column);
    };
    const std::uint64_t end = end_of(begin);
    if (const auto ahead = find(std::max(here, begin), end)) return ahead;
    return find(begin, std::min(here, end));
}

std::optional<TextPosition> BlockIndex::program(std::int64_t number) const {
    for (const Mark& mark : marks_)
        if (mark.program == number) return TextPosition{mark.offset, mark.line};
    return std::nullopt;
}

}  // namespace polyturn::channels::fanuc
