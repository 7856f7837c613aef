// Custom macro B beside its statements: variables and their names, what programs have written into
// system variables, printing, and the page that G65 H90 to H94 build.
#pragma once
#include <cstdint>
#include <string>

#include "channels/dialogue.hpp"
#include "channels/fanuc/macro/expression.hpp"
#include "channels/fanuc/macro/variable_names.hpp"
#include "channels/fanuc/macro/variables.hpp"
#include "channels/fanuc/settings.hpp"

namespace polyturn::channels::fanuc {

// System variables that nothing else in the channel needs.
struct SystemValues {
    double parts_wanted = 0;    // #3902
    double pattern = 0;         // #5900
    std::uint32_t outputs = 0;  // #1132
    double outputs_wide = 0;    // #1133
    // #3005 without a further effect
    bool iso = false, sequence = false, tv = false;
    double timer_ms_offset = 0, timer_h_offset = 0;  // #3001, #3002 as the program has set them
};

struct Printing {
    bool open = false;    // between POPEN and PCLOS
    bool blanks = false;  // leading ones are sent
};

// The page that G65 H90 to H94 build; it is asked where the program ends that has built it.
struct PatternDialogue {
    bool open = false;   // a page has been begun
    bool menu = false;   // of patterns; otherwise of values
    bool asked = false;  // the machine is stopped at it
    DialoguePage page;
};

// Letters that call a program have written their variable; their block may be read twice.
struct LettersWritten {
    std::uint64_t serial = 0;
    std::uint32_t letters = 0;
};

struct Macro {
    Macro(VariableHost& host, ChannelStore& store, const Settings& settings);

    VariableSet variables;
    VariableNames names;
    Expression expression;
    SystemValues system;
    Printing printing;
    PatternDialogue dialogue;
    LettersWritten written;
    std::string message;  // text of #3000, #3006 while it is reported
};

}  // namespace polyturn::channels::fanuc
