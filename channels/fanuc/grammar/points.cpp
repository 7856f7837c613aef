#include "channels/fanuc/grammar/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/program/fault_place.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fanuc {
namespace {

// A length of the text has a decimal point. Comments, and words that are no lengths (G12.1, P1.12,
// F100.), say nothing.
bool length_with_point(std::string_view line) {
    constexpr std::string_view kLengths = "XYZUVWABCIJKRE";
    for (std::size_t at = 0; at < line.size();) {
        if (line[at] == '(') at = std::min(line.find(')', at), line.size() - 1);
        const char c = capital(line[at++]);
        if (!is_capital(c) || (at < line.size() && is_letter(line[at]))) continue;
        const std::size_t end = behind_value(line, at);
        if (kLengths.find(c) != std::string_view::npos &&
            line.substr(at, end - at).find('.') != std::string_view::npos)
            return true;
        at = std::max(at, end);
    }
    return false;
}

// The reader of the program is not disturbed. A text that cannot be read here says nothing.
bool file_has_points(const std::string& path) {
    std::ifstream text(path);
    if (!text) return true;
    for (std::string line; std::getline(text, line);)
        if (length_with_point(line)) return true;
    return false;
}

}  // namespace

// G0 X50 is 0.05 mm where F3401#0 is 0, as on the control. Whoever writes no point in a whole
// program means millimetres more often than not: one warning, at the first such word.
void judge_points(Execution& x) {
    if (x.text.points_judged || x.settings.point_means_nothing || x.reading.contour ||
        x.words.has(GGroup::OneShot))
        return;
    for (unsigned k = 0; k < x.words.axis_count && !x.text.points_judged; ++k) {
        const Word& word = x.block.words[x.words.axes[k]];
        if (word.value == 0 || word.from_expression) continue;
        x.text.points_judged = true;
        if (word.has_point || file_has_points(x.files.path(x.calls.frames.front().file))) return;
        const AxisOf axis = axis_of(x, word);
        std::string meant =
            fmt::format("{} = {:.4f}", text_of(x, word), length_of(x, word, axis.place));
        meant.erase(meant.find_last_not_of('0') + 1);
        x.core.sink().alarm(
            {Alarm::PointsMissing,
             {{}, x.core.at.line, character_column(x.text.line, word.column), word.length},
             {},
             meant},
            x.core.at);
    }
}

}  // namespace polyturn::channels::fanuc
