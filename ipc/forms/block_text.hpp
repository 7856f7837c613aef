// The words of one block as they stand in its line, so that a word can be changed while everything else stays as it is.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polyturn::forms {

enum class Notation { Family, Fagor, Sinumerik };   // comments in brackets; behind a semicolon, values may be P5; the same, SF=180, Z=R1+2

struct TextWord {
    std::string address;          // in capital letters
    std::size_t from = 0, to = 0; // bytes of the line, the address included
    std::size_t value_from = 0;
    std::string value;            // as written, without blanks
    bool plain = false;           // a number; otherwise an expression
    double number = 0.0;
    bool has_point = false;
};

class BlockText {
public:
    BlockText(std::string line, Notation notation);
    const std::string& line() const { return line_; }
    const std::vector<TextWord>& words() const { return words_; }
    // Nothing stands in it but words, block number, skip sign and comments: it can be a cycle's.
    bool plain() const { return plain_; }
    bool empty() const { return words_.empty() && plain_; }
    const TextWord* find(std::string_view address) const;
    // G71, G83.1: as it stands in the tables.
    bool has_code(std::string_view code) const;

    void set(std::string_view address, const std::string& value);   // a new one stands behind the words that are there
    void erase(std::string_view address);

private:
    void read();
    void read_letters();
    void read_names();
    std::string line_;
    Notation notation_;
    std::vector<TextWord> words_;
    bool plain_ = true;
};

// A plain number of a word: sign, digits, point. Nothing: it is none.
std::optional<double> plain_number(std::string_view text);
// The shortest writing with so many decimals at the most.
std::string number_text(double value, int decimals, bool with_point);

}  // namespace polyturn::forms
