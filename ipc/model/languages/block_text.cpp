#include "ipc/model/languages/block_text.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace polyturn::forms {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

}  // namespace

std::optional<double> plain_number(std::string_view text) {
    bool digit = false, point = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (is_digit(text[i]))
            digit = true;
        else if (text[i] == '.' && !point)
            point = true;
        else if (!((text[i] == '+' || text[i] == '-') && i == 0))
            return std::nullopt;
    }
    if (!digit) return std::nullopt;
    double value = 0.0;
    const std::size_t sign = text[0] == '+' || text[0] == '-' ? 1 : 0;
    std::from_chars(text.data() + sign, text.data() + text.size(), value);
    return text[0] == '-' ? -value : value;
}

std::string number_text(double value, int decimals, bool with_point) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
    std::string out = buffer;
    if (out.find('.') != std::string::npos) {
        while (out.back() == '0') out.pop_back();
        if (out.back() == '.' && !with_point) out.pop_back();
    } else if (with_point) {
        out += '.';
    }
    if (out == "-0" || out == "-0.") out.erase(0, 1);
    return out;
}

BlockText::BlockText(std::string line, Notation notation)
    : line_(std::move(line)), notation_(notation) {
    read();
}

// One pass; what is neither word nor comment makes the block one that no form may touch.
void BlockText::read() {
    words_.clear();
    call_.reset();
    plain_ = true;
    if (notation_ == Notation::Sinumerik)
        read_names();
    else
        read_letters();
    const auto take_value = [this](TextWord& word) {
        word.value = line_.substr(word.value_from, word.to - word.value_from);
        const auto number = plain_number(word.value);
        word.plain = number.has_value();
        word.number = number.value_or(0.0);
        word.has_point = word.plain && word.value.find('.') != std::string::npos;
    };
    for (TextWord& word : words_) take_value(word);
    if (call_)
        for (TextWord& argument : call_->arguments) take_value(argument);
}

void BlockText::read_letters() {
    std::size_t i = 0;
    const std::size_t n = line_.size();
    while (i < n) {
        const char c = line_[i];
        if (is_blank(c)) {
            ++i;
        } else if (c == ';') {
            if (notation_ == Notation::Family)  // what follows is another block
                for (std::size_t k = i + 1; k < n; ++k) plain_ = plain_ && is_blank(line_[k]);
            return;
        } else if (c == '(' && notation_ == Notation::Family) {
            const std::size_t end = line_.find(')', i);
            if (end == std::string::npos) return void(plain_ = false);
            i = end + 1;
        } else if (c == '/') {
            ++i;
            while (i < n && is_digit(line_[i])) ++i;
        } else if (is_letter(c)) {
            TextWord word;
            word.address = std::string(1, capital(c));
            word.from = i++;
            while (i < n && is_blank(line_[i])) ++i;
            word.value_from = i;
            const bool variable = i < n && (line_[i] == '#' || line_[i] == '[' ||
                                            ((line_[i] == '-' || line_[i] == '+') && i + 1 < n &&
                                             (line_[i + 1] == '#' || line_[i + 1] == '[')));
            if (variable && notation_ == Notation::Family) {
                int depth = 0;
                while (i < n) {
                    if (line_[i] == '[') ++depth;
                    if (line_[i] == ']') --depth;
                    const char d = line_[i];
                    if (depth == 0 && d != ']' &&
                        !(d == '#' || is_digit(d) ||
                          ((d == '-' || d == '+') && i == word.value_from)))
                        break;
                    ++i;
                    if (depth == 0 && d == ']') break;
                }
                plain_ = plain_ && depth == 0;
            } else if (notation_ == Notation::Fagor && i < n &&
                       (capital(line_[i]) == 'P' ||
                        (line_[i] == '-' && i + 1 < n && capital(line_[i + 1]) == 'P')) &&
                       word.address != "N") {
                i += line_[i] == '-' ? 2 : 1;
                const std::size_t digits = i;
                while (i < n && is_digit(line_[i])) ++i;
                plain_ = plain_ && i > digits;
            } else {
                while (i < n && (is_digit(line_[i]) || line_[i] == '.' ||
                                 ((line_[i] == '-' || line_[i] == '+') && i == word.value_from)))
                    ++i;
            }
            word.to = i;
            if (word.to == word.value_from) plain_ = false;
            words_.push_back(std::move(word));
        } else {
            return void(plain_ = false);
        }
    }
}

// N10 G33 Z=R1+2 K2 SF=180 LFON ;why so: a letter with its number, a name with = and a value, a
// command without one; or a call that stands alone. What is chosen or reported (labels, conditions,
// strings) and a value of several parts with blanks between them are left alone.
void BlockText::read_names() {
    std::size_t i = 0;
    const std::size_t n = line_.size();
    const auto blanks = [&] {
        while (i < n && is_blank(line_[i])) ++i;
    };
    const auto digits = [&] {
        while (i < n && is_digit(line_[i])) ++i;
    };
    const auto is_sign = [](char c) { return c == '+' || c == '-' || c == '*' || c == '/'; };
    for (blanks(); i < n; blanks()) {
        const char c = line_[i];
        if (c == ';') return;
        if (c == '/' && words_.empty()) {
            ++i;
            digits();
            continue;
        }
        if (!is_letter(c) && c != '_') return void(plain_ = false);
        TextWord word;
        word.from = i;
        while (i < n && (is_letter(line_[i]) || line_[i] == '_'))
            word.address += capital(line_[i++]);
        const std::size_t behind_name = i;
        const bool letter = word.address.size() == 1;
        digits();
        std::size_t at = i;
        while (at < n && is_blank(line_[at])) ++at;
        if (at < n && line_[at] == '=') {  // X1=, SF=
            word.address += line_.substr(behind_name, i - behind_name);
            i = at + 1;
            blanks();
            word.value_from = i;
            int depth = 0;
            for (; i < n && (depth > 0 || !is_blank(line_[i])) && line_[i] != ';'; ++i) {
                if (line_[i] == '"') return void(plain_ = false);
                if (line_[i] == '(' || line_[i] == '[') ++depth;
                if (line_[i] == ')' || line_[i] == ']') --depth;
            }
            if (i == word.value_from || depth != 0 || is_sign(line_[i - 1]) ||
                line_[word.value_from] == '=')
                return void(plain_ = false);
        } else if (letter) {  // K2, Z-20.5
            i = behind_name;
            blanks();
            word.value_from = i;
            while (i < n && (is_digit(line_[i]) || line_[i] == '.' ||
                             ((line_[i] == '-' || line_[i] == '+') && i == word.value_from)))
                ++i;
            // 2EX3
            if (i == word.value_from || (i < n && capital(line_[i]) == 'E'))
                return void(plain_ = false);
        } else {
            word.address += line_.substr(behind_name, i - behind_name);
            if (at < n && line_[at] == '(') return read_call(std::move(word.address), at);
            word.value_from = i;
        }
        word.to = i;
        if (i < n && (line_[i] == '(' || line_[i] == '[' || line_[i] == ':'))
            return void(plain_ = false);
        words_.push_back(std::move(word));
    }
}

// N10 MCALL CYCLE82(10, 0, 2, -20, , R1 + 2) ;why so: nothing else may stand in the block of a
// cycle.
void BlockText::read_call(std::string name, std::size_t open) {
    TextCall call{std::move(name), open, 0, {}};
    for (const TextWord& word : words_) {
        if (word.address == "MCALL" && call.name.find(' ') == std::string::npos)
            call.name.insert(0, "MCALL ");
        else if (word.address != "N" || &word != &words_.front())
            return void(plain_ = false);
    }
    const std::size_t n = line_.size();
    int depth = 1;
    std::size_t from = open + 1;
    for (std::size_t i = from; depth > 0; ++i) {
        if (i >= n || line_[i] == '"' || line_[i] == ';') return void(plain_ = false);
        if (line_[i] == '(' || line_[i] == '[') ++depth;
        if (line_[i] == ')' || line_[i] == ']') --depth;
        if (depth > 1 || (depth == 1 && line_[i] != ',')) continue;
        TextWord argument;
        argument.from = argument.value_from = from;
        argument.to = i;
        while (argument.to > from && is_blank(line_[argument.to - 1])) --argument.to;
        while (argument.value_from < argument.to && is_blank(line_[argument.value_from]))
            ++argument.value_from;
        // behind one blank
        if (argument.value_from == argument.to && argument.to < i) {
            ++argument.value_from;
            ++argument.to;
        }
        call.arguments.push_back(std::move(argument));
        from = i + 1;
    }
    if (line_[from - 1] != ')') return void(plain_ = false);
    call.close = from - 1;
    // ()
    if (call.arguments.size() == 1 &&
        call.arguments.front().value_from == call.arguments.front().to)
        call.arguments.clear();
    while (from < n && is_blank(line_[from])) ++from;
    plain_ = plain_ && (from == n || line_[from] == ';');
    call_ = std::move(call);
}

const TextWord* BlockText::argument(std::size_t i) const {
    if (!call_ || i >= call_->arguments.size() || call_->arguments[i].value.empty()) return nullptr;
    return &call_->arguments[i];
}

const TextWord* BlockText::find(std::string_view address) const {
    for (const TextWord& word : words_)
        if (word.address == address) return &word;
    return nullptr;
}

bool BlockText::has_code(std::string_view code) const {
    if (code.empty() || !plain_) return false;
    if (call_) return call_->name == code;
    const auto number = plain_number(code.substr(1));
    for (const TextWord& word : words_)
        if (word.address == code.substr(0, 1) && word.plain && number &&
            std::fabs(word.number - *number) < 1e-9)
            return true;
    return false;
}

void BlockText::set(std::string_view address, const std::string& value) {
    if (const TextWord* word = find(address)) {
        line_.replace(word->value_from, word->to - word->value_from, value);
    } else {
        std::size_t at = words_.empty() ? line_.size() : words_.back().to;
        const bool equals =
            notation_ == Notation::Sinumerik && (address.size() > 1 || !plain_number(value));
        line_.insert(at, std::string(at > 0 && !is_blank(line_[at - 1]) ? " " : "") +
                             std::string(address) + (equals ? "=" : "") + value);
    }
    read();
}

void BlockText::erase(std::string_view address) {
    const TextWord* word = find(address);
    if (!word) return;
    std::size_t from = word->from, to = word->to;
    if (from > 0 && is_blank(line_[from - 1]))
        --from;  // one blank goes with it
    else if (to < line_.size() && is_blank(line_[to]))
        ++to;
    line_.erase(from, to - from);
    read();
}

void BlockText::set_argument(std::size_t i, const std::string& value) {
    const auto& all = call_->arguments;
    if (i < all.size()) {
        line_.replace(all[i].value_from, all[i].to - all[i].value_from, value);
    } else {
        bool dense = all.size() > 1;  // 10,0,2 goes on without blanks
        for (std::size_t k = 1; k < all.size(); ++k) dense = dense && !is_blank(line_[all[k].from]);
        std::string more;
        for (std::size_t k = all.size(); k <= i; ++k) more += k == 0 ? "" : dense ? "," : ", ";
        line_.insert(all.empty() ? call_->open + 1 : all.back().to, more + value);
    }
    read();
}

void BlockText::erase_argument(std::size_t i) {
    if (!argument(i)) return;
    const auto& all = call_->arguments;
    if (i + 1 < all.size()) {
        line_.erase(all[i].value_from, all[i].to - all[i].value_from);
    } else {
        std::size_t first = i;
        while (first > 0 && all[first - 1].value.empty()) --first;
        // the comma too
        const std::size_t from = first == 0 ? call_->open + 1 : all[first].from - 1;
        line_.erase(from, call_->close - from);
    }
    read();
}

}  // namespace polyturn::forms
