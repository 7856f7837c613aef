#include "channels/fanuc/b_axis/b_memory.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace polyturn::channels::fanuc {
namespace {

constexpr std::string_view kHead = "b-axis programs 1\n", kEnd = "end\n";
constexpr unsigned kAbsolute = 1, kHasB = 2, kHasR = 4, kHasP = 8;
constexpr std::size_t kMostSteps = 65'535;

// Takes one thing after the other off the text; a thing that is not there spoils it.
struct Reader {
    std::string_view left;
    bool good = true;

    bool take(std::string_view what) {
        return good =
                   good && left.starts_with(what) ? (left.remove_prefix(what.size()), true) : false;
    }
    template <class Number>
    Number number(std::string_view name, std::string_view behind) {
        Number value{};
        if (!take(name)) return value;
        const auto [end, error] = std::from_chars(left.data(), left.data() + left.size(), value);
        good = error == std::errc{};
        if (good) left.remove_prefix(static_cast<std::size_t>(end - left.data()));
        take(behind);
        return value;
    }
    double real(std::string_view name) {
        const double value = number<double>(name, " ");
        good = good && std::isfinite(value);
        return value;
    }
};

BStep step_of(Reader& in) {
    BStep step;
    step.motion = in.number<int>("motion=", " ");
    step.feed_mode = in.number<int>("feed_mode=", " ");
    step.one_shot = in.number<int>("one_shot=", " ");
    step.drilling = in.number<int>("drilling=", " ");
    const auto set = in.number<unsigned>("set=", " ");
    step.absolute = set & kAbsolute;
    step.has_b = set & kHasB;
    step.has_r = set & kHasR;
    step.has_p = set & kHasP;
    step.b = in.real("b=");
    step.r = in.real("r=");
    step.q = in.real("q=");
    step.p = in.real("p=");
    step.feed = in.real("feed=");
    step.feed_turn = in.real("turn=");
    step.code = in.real("code=");
    if (in.take("letter=") && !in.left.empty()) {
        const char letter = in.left.front();
        in.left.remove_prefix(1);
        in.good = letter == '-' || letter == 'M' || letter == 'S' || letter == 'T';
        step.letter = letter == '-' ? '\0' : letter;
    }
    in.take("\n");
    return step;
}

}  // namespace

std::string b_text(const BProgramTexts& programs) {
    std::string text(kHead);
    for (std::size_t n = 0; n < programs.size(); ++n) {
        text += fmt::format("program {} {}\n", n + 1, programs[n].size());
        for (const BStep& s : programs[n]) {
            const unsigned set = (s.absolute ? kAbsolute : 0u) | (s.has_b ? kHasB : 0u) |
                                 (s.has_r ? kHasR : 0u) | (s.has_p ? kHasP : 0u);
            text += fmt::format(
                "motion={} feed_mode={} one_shot={} drilling={} set={} b={} r={} q={} p={} "
                "feed={} turn={} code={} letter={}\n",
                s.motion, s.feed_mode, s.one_shot, s.drilling, set, s.b, s.r, s.q, s.p, s.feed,
                s.feed_turn, s.code, s.letter ? s.letter : '-');
        }
    }
    return text.append(kEnd);
}

std::optional<BProgramTexts> b_programs(std::string_view text) {
    Reader in{text};
    BProgramTexts programs;
    in.take(kHead);
    for (std::size_t n = 0; n < programs.size(); ++n) {
        if (in.number<std::size_t>("program ", " ") != n + 1) return std::nullopt;
        const auto steps = in.number<std::size_t>("", "\n");
        if (!in.good || steps > kMostSteps) return std::nullopt;
        for (std::size_t k = 0; k < steps && in.good; ++k) programs[n].push_back(step_of(in));
    }
    in.take(kEnd);
    if (!in.good || !in.left.empty()) return std::nullopt;
    return programs;
}

}  // namespace polyturn::channels::fanuc
