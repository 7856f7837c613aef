#include "ipc/model/files/toml_limits.hpp"

namespace polyturn::text {
namespace {

class Walk {
public:
    explicit Walk(std::string_view content) : text_(content) {}

    std::optional<TomlExcess> run() {
        while (at_ < text_.size() && !found_) {
            const char c = text_[at_];
            if (c == '"' || c == '\'')
                skip_string(c);
            else if (c == '#')
                skip_comment();
            else
                step(c);
        }
        return found_;
    }

private:
    void step(char c) {
        switch (c) {
            case '\n':
                next_line();
                dots_ = 0;
                break;
            case '[':
            case '{':
                dots_ = 0;
                if (++depth_ > kDeepestToml)
                    excess("more than " + std::to_string(kDeepestToml) + " brackets in each other");
                break;
            case ']':
            case '}':
                dots_ = 0;
                if (depth_ > 0) --depth_;
                break;
            case '=':
            case ',':
                dots_ = 0;
                break;
            case '.':
                if (++dots_ >= kMostKeyParts)
                    excess("a name of more than " + std::to_string(kMostKeyParts) + " parts");
                break;
            default:
                break;
        }
        ++at_;
        if (at_ - line_from_ > kLongestTomlLine)
            excess("a line of more than " + std::to_string(kLongestTomlLine >> 10) + " KB");
    }

    // A string ends with what began it, one of a single line at the latest with the line.
    void skip_string(char quote) {
        const std::string triple(3, quote);
        const bool lines = text_.substr(at_, 3) == triple;
        at_ += lines ? 3 : 1;
        while (at_ < text_.size() && !found_) {
            if (lines ? text_.substr(at_, 3) == triple : text_[at_] == quote) {
                at_ += lines ? 3 : 1;
                return;
            }
            if (text_[at_] == '\n') {
                if (!lines) return;
                next_line();
            }
            at_ += text_[at_] == '\\' && quote == '"' && at_ + 1 < text_.size() &&
                           text_[at_ + 1] != '\n'
                       ? 2
                       : 1;
            if (at_ - line_from_ > kLongestTomlLine)
                excess("a line of more than " + std::to_string(kLongestTomlLine >> 10) + " KB");
        }
    }

    void skip_comment() {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
        if (at_ - line_from_ > kLongestTomlLine)
            excess("a line of more than " + std::to_string(kLongestTomlLine >> 10) + " KB");
    }

    void next_line() {
        ++line_;
        line_from_ = at_ + 1;
    }
    void excess(std::string what) {
        if (!found_)
            found_ = TomlExcess{line_, static_cast<std::uint32_t>(at_ - line_from_ + 1),
                                std::move(what)};
    }

    std::string_view text_;
    std::size_t at_ = 0, line_from_ = 0;
    std::uint32_t line_ = 1;
    unsigned depth_ = 0, dots_ = 0;
    std::optional<TomlExcess> found_;
};

}  // namespace

std::optional<TomlExcess> beyond_toml_limits(std::string_view content) {
    return Walk(content).run();
}

}  // namespace polyturn::text
