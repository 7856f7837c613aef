// The meaning of the numbers in PLC_ALARM and PLC_NOTE: the machine builder's messages, each with
// its text in four languages, its cause and its remedy. The built-in PLC brings its own; a file
// messages.csv beside the machine adds to them and replaces them, one message a line:
//
//   number,en,ru,cs,hu,cause,remedy
//   101,"hydraulics too hot","...","...","...","the cooler is dirty","Clean the cooler."
//
// and, where cause and remedy are translated too: cause in ru, cs, hu, remedy in ru, cs, hu.
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
    std::array<std::string, 4> text, cause, remedy;  // by MessageLanguage; empty: English serves
    static std::string_view own(const std::array<std::string, 4>& words, MessageLanguage language) {
        const std::string& one = words[static_cast<std::size_t>(language)];
        return one.empty() ? words[0] : one;
    }
    std::string_view in(MessageLanguage language) const { return own(text, language); }
};

class BuilderMessages {
public:
    BuilderMessages();  // those of the built-in PLC
    // A file that is not there adds nothing; faults in it are reported line by line, and the
    // other lines count.
    std::vector<Diagnosis> add_file(const std::string& path);
    std::vector<Diagnosis> add(std::string_view content, const std::string& name);
    const BuilderMessage* find(int number) const;
    // ": text; cause: ... Remedy": behind the number in an alarm; empty for a number that nobody
    // explains.
    std::string explain(int number, MessageLanguage language = MessageLanguage::English,
                        bool remedy = true) const;
    // A text in which an explanation stands, in whatever language it was told: the same with the
    // explanation in this one.
    std::string told_in(std::string text, MessageLanguage language) const;

private:
    std::map<int, BuilderMessage> messages_;
};

}  // namespace polyturn::text
