#include "channels/sinumerik/flow/text_index.hpp"

#include "channels/sinumerik/grammar/cursor.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// A jump in the line of an IF makes it a statement of its own.
bool has_jump(Cursor cursor) {
    bool text = false;
    for (const char* p = cursor.at(); p != cursor.end(); ++p) {
        if (*p == '"') text = !text;
        if (text || !is_name_start(*p) || (p != cursor.begin() && is_name(p[-1]))) continue;
        const char* q = p;
        while (q != cursor.end() && is_name(*q)) ++q;
        const std::string name = upper({p, static_cast<std::size_t>(q - p)});
        if (name == "GOTO" || name == "GOTOF" || name == "GOTOB" || name == "GOTOC" ||
            name == "GOTOS")
            return true;
        p = q - 1;
    }
    return false;
}

}  // namespace

void TextIndex::build(LineSource& source) {
    built_ = true;
    const TextPosition back = source.next_position();
    source.seek({0, 1});
    std::vector<std::size_t> open;
    std::string_view line;
    std::uint32_t program = 0;
    while (source.next(line) == LineSource::Status::Line) {
        const TextPosition here = source.position(), behind = source.next_position();
        Cursor cursor(line);
        if (cursor.peek() == '%') {
            // the next program of a file from an archive
            if (program++ != 0 || here.offset > 0) break;
            continue;
        }
        while (cursor.eat('/'))
            if (is_digit(cursor.peek())) cursor.advance(1);
        if (cursor.peek() == ':' ||
            ((cursor.peek() == 'N' || cursor.peek() == 'n') && is_digit(cursor.next_raw(1)))) {
            cursor.advance(1);
            while (is_digit(cursor.next_raw())) cursor.advance(1);
        }
        std::string word;
        for (;;) {
            const std::string_view name = cursor.name_ahead();
            if (name.empty()) break;
            word = upper(name);
            Cursor after = cursor;
            after.advance(name.size());
            if (after.peek() != ':') break;
            after.eat(':');
            cursor = after;
            labels_[word].push_back(here);
            if (word == "ENDLABEL") end_labels_.emplace_back(here, behind);
            word.clear();
        }
        if (word.empty()) continue;
        const auto push = [&](Structure::Kind kind) {
            Structure s;
            s.kind = kind;
            s.head = here;
            s.behind_head = behind;
            open.push_back(structures_.size());
            by_line_[here.offset] = structures_.size();
            structures_.push_back(s);
        };
        const auto tail = [&](Structure::Kind kind, bool middle) {
            if (open.empty() || structures_[open.back()].kind != kind ||
                (middle && structures_[open.back()].has_middle)) {
                if (!lonely_) lonely_ = Lonely{here, word};
                return;
            }
            Structure& s = structures_[open.back()];
            by_line_[here.offset] = open.back();
            if (middle) {
                s.has_middle = true;
                s.middle = here;
                s.behind_middle = behind;
                return;
            }
            s.tail = here;
            s.behind_tail = behind;
            open.pop_back();
        };
        Cursor after = cursor;
        after.advance(word.size());
        if (word == "IF") {
            if (!has_jump(after)) push(Structure::Kind::If);
        } else if (word == "ELSE") {
            tail(Structure::Kind::If, true);
        } else if (word == "ENDIF") {
            tail(Structure::Kind::If, false);
        } else if (word == "WHILE") {
            push(Structure::Kind::While);
        } else if (word == "ENDWHILE") {
            tail(Structure::Kind::While, false);
        } else if (word == "FOR") {
            push(Structure::Kind::For);
        } else if (word == "ENDFOR") {
            tail(Structure::Kind::For, false);
        } else if (word == "LOOP") {
            push(Structure::Kind::Loop);
        } else if (word == "ENDLOOP") {
            tail(Structure::Kind::Loop, false);
        } else if (word == "REPEAT") {
            if (after.at_end()) push(Structure::Kind::Repeat);
        } else if (word == "UNTIL") {
            tail(Structure::Kind::Repeat, false);
        }
    }
    if (!open.empty() && !lonely_) {
        constexpr const char* kNames[] = {"IF", "WHILE", "FOR", "LOOP", "REPEAT"};
        const Structure& s = structures_[open.front()];
        lonely_ = Lonely{s.head, kNames[static_cast<std::size_t>(s.kind)]};
    }
    source.seek(back);
}

const Structure* TextIndex::at(std::uint64_t offset) const {
    const auto found = by_line_.find(offset);
    return found == by_line_.end() ? nullptr : &structures_[found->second];
}

const std::vector<TextPosition>* TextIndex::label(std::string_view name) const {
    const auto found = labels_.find(name);
    return found == labels_.end() ? nullptr : &found->second;
}

std::optional<TextPosition> TextIndex::end_label(std::uint64_t from, TextPosition& behind) const {
    for (const auto& [at, after] : end_labels_)
        if (at.offset >= from) {
            behind = after;
            return at;
        }
    return std::nullopt;
}

}  // namespace polyturn::channels::sinumerik
