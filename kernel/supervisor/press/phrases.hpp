// Texts of `polyturn` for people besides alarms: the report of a run, status, lists. In the
// language of display_language_now(). The English text is the key, so that a call reads like what
// it prints; {} stand in the same order in all languages.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace polyturn::supervisor {

struct Phrase {
    std::string_view english, russian, czech, hungarian;
};
std::span<const Phrase> help_phrases();  // help_phrases.cpp: --help, steps of the machine, restart
// A message that shows the approach of a restart, in the language of this process; any other text
// as it is.
std::string retold_restart(std::string_view english);

// The text in the language of this process; English where the table has none.
std::string_view say(std::string_view english);

}  // namespace polyturn::supervisor
