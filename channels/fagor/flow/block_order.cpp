#include "channels/fagor/flow/block_order.hpp"

#include <cmath>

#include "channels/fagor/cycles/cycle_words.hpp"
#include "channels/fagor/execution.hpp"
#include "channels/fagor/motion/arcs.hpp"
#include "channels/fagor/motion/compensation.hpp"
#include "channels/fagor/motion/dwell.hpp"
#include "channels/fagor/motion/feed.hpp"
#include "channels/fagor/motion/lines.hpp"
#include "channels/fagor/tools/m_functions.hpp"
#include "channels/fagor/tools/spindle.hpp"
#include "channels/fagor/tools/tool_words.hpp"

namespace polyturn::channels::fagor {
namespace {

constexpr double kLargestInch = 3'937.00787;  // of ±4.5 (part 1, 3.3)

}  // namespace

bool act_in_order(Execution& x) {
    const BlockWords& words = x.words;
    const auto run = [&](GGroup group) {
        const GCode* row = words.code(group);
        return !row || !row->act || row->act(x, *row);
    };
    for (const GGroup group :
         {GGroup::Units, GGroup::XFormat, GGroup::Plane, GGroup::Distance, GGroup::Feed})
        if (!run(group)) return false;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (words.axis[i] && x.modal.inch && !x.core.view().axes[i].rotary &&
            !words.has(GGroup::Machine) && std::fabs(words.axis[i]->value) > kLargestInch + 5e-6)
            return x.fail_word(*words.axis[i], Alarm::DigitsTooMany,
                               std::string(1, words.axis[i]->letter));
    const GCode* one_shot = words.code(GGroup::OneShot);
    const GCode* cycle = words.code(GGroup::Cycle);
    const bool own_words = (one_shot && one_shot->number != 4 && one_shot->number != 52 &&
                            one_shot->number != 75 && one_shot->number != 76) ||
                           cycle;
    if (words.has(GGroup::Motion)) x.modal.motion = words.code(GGroup::Motion)->number;
    if (!own_words && words.has('F') && !feed_word(x)) return false;
    if (!run(GGroup::Spindle)) return false;
    if (!own_words && x.modal.m_done < 0 && !(spindle_word(x) && tool_words(x))) return false;
    if (words.m_count && !m_before(x)) return false;
    if (x.run.called) return true;  // the subroutine of an M function comes first
    if (!x.core.commit_spindle()) return false;
    for (const GGroup group : {GGroup::Corner, GGroup::Mirror, GGroup::Comp})
        if (!run(group)) return false;
    if (one_shot && one_shot->number == 4 && !g_dwell(x, *one_shot)) return false;
    if (words.has(GGroup::Machine) && !begin_machine_block(x)) return false;
    if (one_shot && one_shot->number != 4) {
        if (!one_shot->act(x, *one_shot)) return false;
    } else if (cycle) {
        x.core.at.cycle = cycle_name(cycle->number);
        const bool good = cycle->act(x, *cycle);
        x.core.at.cycle = {};
        if (!good) return false;
    } else if (words.has(GGroup::Modifier) && words.code(GGroup::Modifier)->number != 6) {
        if (!g_arc(x, *words.code(GGroup::Modifier))) return false;
    } else if (words.has_axes() || words.has('Q') || words.has('R') ||
               (x.modal.motion >= 2 && (words.letters & letter_set("IJK")))) {
        const GCode* motion = find_g_code(x.modal.motion);
        if (words.has(GGroup::Plane) && x.modal.plane == 16) return true;
        const bool ends_comp = words.has(GGroup::Comp) && words.code(GGroup::Comp)->number == 40;
        // no arc without a way
        if (ends_comp && (x.modal.motion == 2 || x.modal.motion == 3) && at_standstill(x))
            return !words.m_count || m_after(x);
        if (!motion->act(x, *motion)) return false;
    } else if (words.has(GGroup::Element)) {
        return x.fail(Alarm::FagorMotionWord, 'G', "a motion", words.code(GGroup::Element)->number);
    }
    if (x.run.ended) return true;
    return words.m_count ? m_after(x) : true;
}

}  // namespace polyturn::channels::fagor
