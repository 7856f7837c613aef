#include "channels/fanuc/motion/threads.hpp"

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/motion/feed_words.hpp"
#include "channels/fanuc/motion/g_motion.hpp"
#include "channels/fanuc/motion/targets.hpp"

namespace polyturn::channels::fanuc {
namespace {

// Lead (F, E) and start angle (Q) of a thread.
void thread_words(Execution& x, ThreadCall& call) {
    if (x.block.has('E')) {
        const Word& word = x.block.word('E');
        x.modal.lead =
            fine_feed(word,
                      word.has_point || word.from_expression || x.settings.point_means_nothing,
                      x.settings.series15, x.modal.input.inch) *
            x.modal.input.unit;
    }
    call.lead = x.modal.lead > 0                                   ? x.modal.lead
                : x.core.path.feed_mode == FeedMode::PerRevolution ? x.core.path.feed
                                                                   : 0.0;
    if (!x.block.has('Q')) return;
    const Word& word = x.block.word('Q');
    // Fanuc counts thousandths of a degree and knows no point here; series 15 programs accept Q
    // without effect.
    call.start_angle = word.has_point || x.settings.policy.words.whole_start_angle
                           ? word.value
                           : word.value * 0.001;
    if (x.settings.series15) call.start_angle = 0.0;
}

}  // namespace

bool g_thread(Execution& x, const GCode&) {
    if (!x.words.axis_count) return true;
    if (!read_axis_words(x, x.words.target)) return false;
    ThreadCall call;
    thread_words(x, call);
    return x.core.thread(x.words.target, call);
}

// G35: a thread on an arc, clockwise.
bool g_thread_arc(Execution& x, const GCode&) {
    ArcCall arc;
    arc.clockwise = true;
    bool goes = false;
    if (!arc_words(x, arc, goes)) return false;
    if (!goes) return true;
    ThreadCall call;
    thread_words(x, call);
    call.arc = &arc;
    return x.core.thread(x.words.target, call);
}

bool g_thread_variable(Execution& x, const GCode&) {
    if (!x.words.axis_count) return true;
    if (!read_axis_words(x, x.words.target)) return false;
    ThreadCall call;
    call.lead = x.modal.lead > 0                                   ? x.modal.lead
                : x.core.path.feed_mode == FeedMode::PerRevolution ? x.core.path.feed
                                                                   : 0.0;
    call.lead_change = x.block.has('K') ? x.block.value('K') * x.modal.input.unit : 0.0;
    if (x.block.has('Q'))
        call.start_angle = x.block.word('Q').has_point || x.settings.policy.words.whole_start_angle
                               ? x.block.value('Q')
                               : x.block.value('Q') * 0.001;
    return x.core.thread(x.words.target, call);
}

}  // namespace polyturn::channels::fanuc
