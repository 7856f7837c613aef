#include "channels/fagor/cycles/cycle_words.hpp"

#include "channels/fagor/execution.hpp"
#include "channels/fagor/frames/plane.hpp"
#include "channels/fagor/grammar/words.hpp"
#include "channels/fagor/motion/feed.hpp"
#include "channels/fagor/motion/lengths.hpp"
#include "channels/fagor/tools/spindle.hpp"

namespace polyturn::channels::fagor {

using cycles::Point;

bool cycle_needs(Execution& x, std::string_view letters) {
    for (const char letter : letters)
        if (!x.words.has(letter))
            return x.fail(Alarm::CycleWordMissing, 'G', std::string(1, letter));
    return true;
}

bool cycle_not_zero(Execution& x, std::string_view letters) {
    for (const char letter : letters)
        if (x.words.has(letter) && x.words.number(letter) == 0.0)
            return x.fail(Alarm::FagorCycleZero, letter, std::string(1, letter));
    return true;
}

bool cycle_not_negative(Execution& x, std::string_view letters) {
    for (const char letter : letters)
        if (x.words.number(letter) < 0.0)
            return x.fail(Alarm::NegativeSign, letter, std::string(1, letter));
    return true;
}

// K: whole hundredths of a second, as of G04.
bool cycle_dwell(Execution& x, double& seconds) {
    std::int64_t hundredths = 0;
    if (x.words.has('K') && !whole(x, *x.words.word('K'), hundredths)) return false;
    seconds = static_cast<double>(hundredths) / 100.0;
    return true;
}

// A point of a cycle is absolute, whatever G90 and G91 say; its ordinate counts as X does.
Point cycle_point(Execution& x, char abscissa, char ordinate) {
    int p = -1, q = -1;
    x.core.plane_axes(p, q);
    return {length(x, x.words.number(abscissa), p), length(x, x.words.number(ordinate), q)};
}

// The tool's position in the plane.
Point cycle_call_point(Execution& x) {
    int p = -1, q = -1;
    x.core.plane_axes(p, q);
    return {x.core.path.programmed[static_cast<std::size_t>(p)],
            x.core.path.programmed[static_cast<std::size_t>(q)]};
}

std::string_view cycle_name(unsigned number) {
    static constexpr std::string_view kNames[] = {"G81", "G82", "G83", "G84", "G85",
                                                  "G86", "G87", "G88", "G89"};
    if (number >= 81) return kNames[number - 81];
    return number == 66 ? "G66" : number == 68 ? "G68" : "G69";
}

bool begin_cycle_block(Execution& x) {
    unsigned p = 0, q = 0;
    follow_spindle(x, false);
    return plane_places(x, p, q) && set_feed(x, x.core.path.programmed);
}

// G83, G86 to G89 end compensation (9.0.6).
void drop_compensation(Execution& x) {
    x.modal.comp = 40;
    x.core.compensation_off(0.0, 0.0);
}

}  // namespace polyturn::channels::fagor
