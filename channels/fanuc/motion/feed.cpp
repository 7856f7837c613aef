#include "channels/fanuc/motion/feed.hpp"

#include <fmt/format.h>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/motion/feed_words.hpp"

namespace polyturn::channels::fanuc {
namespace {

// Series 15 only (fanuc_lathe 8.1). A value of 0 is reported by the code that needs a feed.
bool feed_in_range(Core& core, const Word& word, FeedKind kind, double value, bool inch) {
    // IS-C
    const bool fine_axes = core.view().axis_count > 0 && core.view().axes[0].increment < 0.0005;
    const FeedRange range = series15_range(kind, word.has_point, inch, fine_axes);
    return range.holds(value) ||
           core.fail(Alarm::ValueOutOfRange, word.address,
                     fmt::format("{}: {} to {}", word.address, range.low, range.high));
}

}  // namespace

bool lead_in_range(Execution& x) {
    if (!x.settings.series15 || !x.block.has('E') || x.block.value('E') == 0) return true;
    const Word& word = x.block.word('E');
    const bool plain = word.has_point || word.from_expression || x.settings.point_means_nothing;
    return feed_in_range(x.core, word, FeedKind::Lead,
                         fine_feed(word, plain, true, x.modal.input.inch), x.modal.input.inch);
}

bool set_feed(Execution& x, const Word& word) {
    if (word.value < 0) return x.core.fail(Alarm::NegativeSign, 'F', "F");
    const GCode* one_shot = x.words.has(GGroup::OneShot) ? x.words.row(GGroup::OneShot) : nullptr;
    const bool plain = word.has_point || word.from_expression || x.settings.point_means_nothing;
    const bool threading =
        one_shot ? one_shot->is(Trait::Thread) : x.modal.motion->is(Trait::Thread);
    const double programmed = fine_feed(word, plain, x.settings.series15, x.modal.input.inch),
                 fine = programmed * x.modal.input.unit;
    if (x.settings.series15 && word.value != 0) {
        const bool per_turn = threading || x.core.path.feed_mode == FeedMode::PerRevolution;
        const FeedKind kind = threading  ? FeedKind::Lead
                              : per_turn ? FeedKind::PerRevolution
                                         : FeedKind::PerMinute;
        if (!feed_in_range(x.core, word, kind, per_turn ? programmed : word.value,
                           x.modal.input.inch))
            return false;
    }
    if (threading) x.modal.lead = fine;
    if (x.core.path.feed_mode == FeedMode::PerRevolution)
        x.core.path.feed = fine;
    else if (!threading)
        x.core.path.feed = word.value * x.modal.input.unit;
    return true;
}

bool g_feed_mode(Execution& x, const GCode& row) {
    const FeedMode mode =
        row.tenths == 990 || row.tenths == 950 ? FeedMode::PerRevolution : FeedMode::PerMinute;
    if (mode == x.core.path.feed_mode) return true;
    x.core.path.feed_mode = mode;
    // A number of the other kind would be a thousand times too fast: F must be programmed again.
    x.core.path.feed = mode == FeedMode::PerRevolution ? x.settings.feed_per_revolution
                                                       : x.settings.feed_per_minute;
    return true;
}

}  // namespace polyturn::channels::fanuc
