// What the numbers in PLC_ALARM and PLC_NOTE say: the machine builder's messages, each with its text in four languages, its
// cause and its remedy. The built-in PLC brings its own; a file messages.csv beside the machine adds to them and replaces
// them, one message a line:
//
//   number,en,ru,cs,hu,cause,remedy
//   101,"hydraulics too hot","...","...","...","the cooler is dirty","Clean the cooler."
#pragma once
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::text {

enum class MessageLanguage : unsigned char { English, Russian, Czech, Hungarian };

struct BuilderMessage {
    std::array<std::string, 4> text;   // by MessageLanguage; empty: English serves
    std::string cause, remedy;
    std::string_view in(MessageLanguage language) const {
        const std::string& own = text[static_cast<std::size_t>(language)];
        return own.empty() ? text[0] : own;
    }
};

class BuilderMessages {
public:
    BuilderMessages();                                   // those of the built-in PLC
    // A file that is not there adds nothing; what is wrong in it is told line by line, and the other lines count.
    std::vector<Diagnosis> add_file(const std::string& path);
    std::vector<Diagnosis> add(std::string_view content, const std::string& name);
    const BuilderMessage* find(int number) const;
    // ": text. Cause: ... Remedy": behind the number in an alarm; empty for a number that nobody explains.
    std::string explain(int number, MessageLanguage language = MessageLanguage::English) const;

private:
    std::map<int, BuilderMessage> messages_;
};

}  // namespace polyturn::text
