#include "channels/fanuc/grammar/word_values.hpp"

#include "channels/fanuc/execution.hpp"

namespace polyturn::channels::fanuc {

std::string_view text_of(const Execution& x, const Word& word) {
    return x.text.line.substr(word.column - 1u, word.length);
}

// Millimetres or degrees of a word, on the scale on which the axis is programmed.
double length_of(const Execution& x, const Word& word, int place) {
    const MachineView& view = x.core.view();
    const bool rotary = place >= 0 && view.axes[static_cast<std::size_t>(place)].rotary;
    const double step =
        place >= 0 ? view.axes[static_cast<std::size_t>(place)].increment : view.axes[0].increment;
    // one more decimal place in inches
    const double increment = x.modal.input.inch && !rotary ? step * 0.1 : step;
    double value = word.value;
    if (word.from_expression)
        value = whole_steps(value, increment) * increment;
    else if (!word.has_point && !x.settings.point_means_nothing)
        value *= increment;
    return rotary ? value : value * x.modal.input.unit;
}

double radius_length_of(const Execution& x, char letter) {
    return x.block.has(letter) ? length_of(x, x.block.word(letter), -1) : 0.0;
}

// P and Q as lengths: without a point they count the least increment, also where other words are
// whole millimetres.
double fine_length_of(const Execution& x, char letter) {
    if (!x.block.has(letter)) return 0.0;
    const Word& word = x.block.word(letter);
    if (word.has_point || word.from_expression) return length_of(x, word, -1);
    const double increment = x.core.view().axes[0].increment * (x.modal.input.inch ? 0.1 : 1.0);
    return word.value * increment * x.modal.input.unit;
}

AxisOf axis_of(const Execution& x, const Word& word) {
    if (word.axis >= 0) return {word.axis, !x.modal.input.absolute};
    const auto letter = static_cast<std::size_t>(word.address - 'A');
    if (x.vocabulary.absolute_axis[letter] >= 0)
        return {x.vocabulary.absolute_axis[letter], !x.modal.input.absolute};
    return {x.vocabulary.incremental_axis[letter], true};
}

bool whole_number(Execution& x, char letter, std::int64_t& value) {
    const Word& word = x.block.word(letter);
    const double rounded = whole_steps(word.value, 1.0);
    if (!word.from_expression && word.has_point)
        return x.core.fail(Alarm::PointForbidden, letter, std::string(1, letter));
    if (rounded < 0) return x.core.fail(Alarm::NegativeSign, letter, std::string(1, letter));
    value = static_cast<std::int64_t>(rounded);
    return true;
}

double seconds_of(const Execution& x, const Word& word) {
    if (word.address == 'P') {
        if (!x.settings.dwell_p_milliseconds) return word.value;
        // thousandths
        return word.has_point && !word.from_expression ? word.value : word.value * 0.001;
    }
    return word.has_point || x.settings.point_means_nothing || x.settings.policy.words.whole_dwell
               ? word.value
               : word.value * 0.001;
}

}  // namespace polyturn::channels::fanuc
