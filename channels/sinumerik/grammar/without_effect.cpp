// Words that change nothing here: accepted as they are, or with a warning once a program.
#include "channels/sinumerik/grammar/without_effect.hpp"

#include <algorithm>

#include "channels/angles.hpp"
#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/geometry/g_settings.hpp"
#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"

namespace polyturn::channels::sinumerik {

bool p_as_machine(Execution&, Call&) { return true; }
bool a_without_effect(Execution& x, const Word& word) {
    // F2 to F7
    const std::string number =
        word.address->name == "F" && word.index >= 0 ? std::to_string(word.index) : std::string();
    return without_effect(x, std::string(word.address->name) + number, word.column, word.length);
}
bool without_effect(Execution& x, std::string name, std::size_t column, std::size_t length) {
    std::vector<std::string>& told = x.modal.told;
    if (std::find(told.begin(), told.end(), name) != told.end()) return true;
    x.core.mark_emitted();
    x.core.sink().alarm({Alarm::WordWithoutEffect,
                         {x.files.path(x.calls.levels.back().file), x.core.at.line,
                          static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(length)},
                         {},
                         name},
                        x.core.at);
    told.push_back(std::move(name));
    return x.run.state_changed = true;
}
bool g_mode(Execution&, const GCode&) { return true; }
bool g_as_machine(Execution&, const GCode&) { return true; }
bool g_without_effect(Execution& x, const GCode& code) {
    for (std::size_t k = 0; k < x.block.codes.size(); ++k)  // not where a return restores it
        if (x.block.codes[k] == &code)
            return without_effect(x, std::string(code.name), x.block.code_columns[k],
                                  code.name.size());
    return true;
}
bool g_as_continuous(Execution& x, const GCode& code) {
    return g_exact_stop(x, code) && g_without_effect(x, code);
}
bool geo_not_built(Execution& x, const GCode& code) {
    return axis_words(x) == 0 || fail(x, Alarm::NotBuilt, std::string(code.name));
}
bool a_elsewhere(Execution&, const Word&) { return true; }
bool a_as_machine(Execution&, const Word&) { return true; }
// ADIS=0: as G64
bool a_rounding(Execution& x, const Word& word) {
    return word.number() == 0 || a_without_effect(x, word);
}
// TCARR=0, CUTMOD=0 at the head of a program: no holder that turns the tool. There is none that it
// could be turned by.
bool a_no_holder(Execution& x, const Word& word) {
    return word.number() == 0 ||
           fail_word(x, Alarm::NotBuilt, word, std::string(word.address->name));
}
bool p_profile_without_effect(Execution& x, Call& c) {
    return axes_only(x, c) && p_without_effect(x, c);
}
bool p_without_effect(Execution& x, Call& c) {
    const std::string name(x.block.procedures.back().first->name);
    return without_effect(x, name, c.column, c.column ? name.size() : 0);
}
}  // namespace polyturn::channels::sinumerik
