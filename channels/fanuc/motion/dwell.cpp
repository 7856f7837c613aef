#include "channels/fanuc/motion/dwell.hpp"

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/motion/measuring.hpp"

namespace polyturn::channels::fanuc {

bool g_dwell(Execution& x, const GCode&) {
    char letter = 0;
    for (const char candidate : {'P', 'X', 'U'})
        if (x.block.has(candidate)) letter = candidate;
    if (!letter) return x.core.fail(Alarm::CycleWordMissing, 'G', "P");
    const Word& word = x.block.word(letter);
    if (letter == 'P' && word.has_point && !word.from_expression &&
        !x.settings.policy.words.dwell_with_point)
        return x.core.fail(Alarm::PointForbidden, 'P', "P");
    if (word.value < 0) return x.core.fail(Alarm::NegativeSign, letter, std::string(1, letter));
    const bool revolutions =
        x.settings.dwell_by_feed_mode && x.core.path.feed_mode == FeedMode::PerRevolution;
    std::string_view signal;
    if (x.block.has('Q') && (signal = dwell_signal(x)).empty()) return false;
    return x.core.dwell(seconds_of(x, word), revolutions, signal);
}

}  // namespace polyturn::channels::fanuc
