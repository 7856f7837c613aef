#include "channels/fanuc/motion/compensation.hpp"

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/tools/g_length.hpp"

namespace polyturn::channels::fanuc {

bool g_comp_on(Execution& x, const GCode& row) {
    if (x.block.has('D') && !radius_offset(x)) return false;
    if (x.reading.contour) return true;
    if (!x.core.compensating()) x.corners.comp_moves = x.core.moves();
    // The block right behind the one that begins must go on on its side (fanuc_lathe 3.9).
    else if (x.settings.policy.motion.side_at_begin && x.core.holds_block() &&
             x.core.moves() == x.corners.comp_moves + 1 && row.tenths != x.corners.comp_code)
        return x.core.fail(Alarm::CompSideAtBegin, 'G');
    x.corners.comp_code = row.tenths;
    return x.core.compensation(row.tenths == 410 ? CompSide::Left : CompSide::Right);
}

// I, K tell how the contour would go on; in an arc they are its centre.
bool g_comp_off(Execution& x, const GCode&) {
    const GCode* motion =
        x.words.has(GGroup::Motion) ? x.words.row(GGroup::Motion) : x.modal.motion;
    if (motion->is(Trait::Arc)) return x.core.compensation_off(0.0, 0.0);
    // by plane: first, second axis
    static constexpr char kWish[3][2] = {{'I', 'J'}, {'K', 'I'}, {'J', 'K'}};
    const auto& letters = kWish[static_cast<std::size_t>(x.core.path.plane)];
    return x.core.compensation_off(radius_length_of(x, letters[0]),
                                   radius_length_of(x, letters[1]));
}

}  // namespace polyturn::channels::fanuc
