// What `polyturn` says to people beside alarms: the report of a run, status, lists. In the language of tongue_now().
// The English text is the key, so that a call reads like what it prints; {} stand in the same order in all languages.
#pragma once
#include <string_view>

namespace polyturn::supervisor {

// The text in the language of this process; English where the table has none.
std::string_view say(std::string_view english);

}  // namespace polyturn::supervisor
