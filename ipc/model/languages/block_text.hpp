// The words of one block as they stand in its line, so that a word can be changed while everything
// else stays as it is.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polyturn::forms {

// comments in brackets; behind a semicolon, values may be P5; the same, SF=180, Z=R1+2
enum class Notation { Family, Fagor, Sinumerik };

struct TextWord {
    std::string address;           // in capital letters
    std::size_t from = 0, to = 0;  // bytes of the line, the address included
    std::size_t value_from = 0;
    std::string value;   // as written, without blanks
    bool plain = false;  // a number; otherwise an expression
    double number = 0.0;
    bool has_point = false;
};

// CYCLE82(10, 0, , R1+2): what stands between the commas, an empty one with an empty value. No
// address; `from` is behind the bracket or comma.
struct TextCall {
    // in capital letters, with MCALL before it where that stands there
    std::string name;
    std::size_t open = 0, close = 0;  // the brackets
    std::vector<TextWord> arguments;
};

class BlockText {
public:
    BlockText(std::string line, Notation notation);
    const std::string& line() const { return line_; }
    const std::vector<TextWord>& words() const { return words_; }
    const std::optional<TextCall>& call() const { return call_; }
    // Nothing stands in it but words or one call, block number, skip sign and comments: it can be a
    // cycle's.
    bool plain() const { return plain_; }
    bool empty() const { return words_.empty() && !call_ && plain_; }
    const TextWord* find(std::string_view address) const;
    // Of a call, from 0; nullptr where nothing stands.
    const TextWord* argument(std::size_t i) const;
    // G71, G83.1, MCALL CYCLE82: as it stands in the tables.
    bool has_code(std::string_view code) const;

    // a new one stands behind the words that are there
    void set(std::string_view address, const std::string& value);
    void erase(std::string_view address);
    // Of a call. What is empty at its end goes with the last argument.
    void set_argument(std::size_t i, const std::string& value);
    void erase_argument(std::size_t i);

private:
    void read();
    void read_letters();
    void read_names();
    void read_call(std::string name, std::size_t open);
    std::string line_;
    Notation notation_;
    std::vector<TextWord> words_;
    std::optional<TextCall> call_;
    bool plain_ = true;
};

// A plain number of a word: sign, digits, point. Nothing: it is none.
std::optional<double> plain_number(std::string_view text);
// The shortest writing with so many decimals at the most.
std::string number_text(double value, int decimals, bool with_point);

}  // namespace polyturn::forms
