#include "channels/fanuc/motion/targets.hpp"

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/frames/g_frames.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/spindles/g_couplings.hpp"

namespace polyturn::channels::fanuc {

bool axis_word(Execution& x, const Word& word, AxisValues& target, AxisSet& named) {
    const auto [place, incremental] = axis_of(x, word);
    const auto i = static_cast<std::size_t>(place);
    const ChannelAxis& axis = x.core.view().axes[i];
    if (x.machine.polygon_on && turns_polygon(x, static_cast<unsigned>(place)))
        return x.core.fail(Alarm::PolygonAxisMoved, word.address, std::string(axis.name));
    double value = length_of(x, word, place) * (axis.diameter ? 0.5 : 1.0);
    const Transformation& transformation = x.core.path.transformation;
    // an angle
    if (transformation.degrees && transformation.rotary_place() == place)
        value /= x.modal.input.unit * transformation.degrees_per_mm();
    named |= 1u << i;
    if (axis.rollover)
        target[i] = x.core.rollover_target(static_cast<unsigned>(place), value, !incremental);
    else
        target[i] = incremental ? x.core.path.programmed[i] + value : value;
    return true;
}

// The target of the block: the programmed point with the block's axis words in it.
bool read_axis_words(Execution& x, AxisValues& target, AxisSet* named) {
    if (x.machine.away) {
        bool incremental = false;
        for (unsigned k = 0; k < x.words.axis_count; ++k)
            incremental |= axis_of(x, x.block.words[x.words.axes[k]]).incremental;
        if (incremental) x.core.displaced(*x.machine.away);
        if (x.words.axis_count) x.machine.away.reset();
    }
    const unsigned count = x.core.view().axis_count;
    for (unsigned i = 0; i < count; ++i) target[i] = x.core.path.programmed[i];
    AxisSet set = 0;
    for (unsigned k = 0; k < x.words.axis_count; ++k)
        if (!axis_word(x, x.block.words[x.words.axes[k]], target, set)) return false;
    if (x.modal.polar.on && !polar_target(x, target, set)) return false;
    if (named) *named = set;
    x.core.fixture_names(set);
    return true;
}

}  // namespace polyturn::channels::fanuc
