// Text files that programs have written or deleted, and when. The operator's files stay as they
// are; a program finds its own again until the process of its channel ends.
#pragma once
#include <map>
#include <optional>
#include <string>

#include "channels/port.hpp"

namespace polyturn::channels::sinumerik {

struct TextFileState {
    std::map<std::string, std::optional<std::string>, std::less<>> written;  // nullopt: deleted
    std::map<std::string, CalendarTime, std::less<>> written_at;
};

}  // namespace polyturn::channels::sinumerik
