// Where the labels of a program and the partners of its control structures stand. Made in one pass
// when a program first jumps or meets a structure; its size grows with them, not with the program.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "channels/text/line_source.hpp"

namespace polyturn::channels::sinumerik {

struct Structure {
    enum class Kind : std::uint8_t { If, While, For, Loop, Repeat } kind = Kind::If;
    TextPosition head, middle, tail;  // IF, ELSE, ENDIF; WHILE, -, ENDWHILE
    bool has_middle = false;
    TextPosition behind_head, behind_middle, behind_tail;
};

class TextIndex {
public:
    void build(LineSource& source);
    // The structure that a statement at this line belongs to; nullptr: it is outside all.
    const Structure* at(std::uint64_t offset) const;
    // Lines with this label, ascending.
    const std::vector<TextPosition>* label(std::string_view upper_name) const;
    // Which structure keyword has no partner; nothing: all match.
    struct Lonely {
        TextPosition position;
        std::string keyword;
    };
    const std::optional<Lonely>& lonely() const { return lonely_; }
    // First line at or behind `from` that begins with `ENDLABEL:`.
    std::optional<TextPosition> end_label(std::uint64_t from, TextPosition& behind) const;
    bool built() const { return built_; }

private:
    std::vector<Structure> structures_;
    std::map<std::uint64_t, std::size_t> by_line_;
    std::map<std::string, std::vector<TextPosition>, std::less<>> labels_;
    std::vector<std::pair<TextPosition, TextPosition>> end_labels_;
    std::optional<Lonely> lonely_;
    bool built_ = false;
};

}  // namespace polyturn::channels::sinumerik
