// The values a program finds by name beside those of its levels (Level::scope): R parameters,
// names of the channel, macros, and what it has written into system variables.
#pragma once
#include <map>
#include <memory>
#include <string>

#include "channels/sinumerik/grammar/value.hpp"
#include "channels/sinumerik/variables/variable.hpp"

namespace polyturn::channels::sinumerik {

struct NameState {
    std::shared_ptr<Variable> r;
    std::shared_ptr<Scope> of_channel = std::make_shared<Scope>();  // DEF CHAN
    bool declares_for_channel = false;                              // a DEF CHAN is being read
    std::map<std::string, std::string, std::less<>> macros;
    // markers and other values that a program may write
    std::map<std::string, Value, std::less<>> system;
};

}  // namespace polyturn::channels::sinumerik
