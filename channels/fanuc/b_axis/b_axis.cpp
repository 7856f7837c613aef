// B-axis programs G100 to G103 and the single motion G110 (fanuc_lathe 10.4).
//
//   G101          registration: blocks are read, variables evaluated, nothing moves
//   G01 B40. F200
//   G100          the program is there; the M code of F8251 starts it
//
//   M81           handed over step by step (BlockContext::own_axis); the kernel drives them beside
//                 the path
//   G1 X.. Z..    goes on meanwhile; a move of B by the path waits for the end of its own program
//
// Positions in front of the first absolute one of a program count from B's position when the
// kernel begins it: with F8250 = 3 the program of another channel may have left it elsewhere. Then
// only such programs move it, each channel has its own, and they follow each other in the order in
// which they were started (10.4.3, 10.4.5).
//
// Codes of it, feed and mode are its own: what the main program has set does not hold in it, and
// the other way round. What it says to the PLC goes over the axis' own signals (AN_PAXFSTR).
#include "channels/fanuc/b_axis/b_axis.hpp"

#include <cmath>
#include <utility>

#include "channels/cycles/drilling.hpp"
#include "channels/fanuc/b_axis/b_memory.hpp"
#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/motion/feed_words.hpp"
#include "channels/fanuc/program/faults.hpp"

namespace polyturn::channels::fanuc {
namespace {

constexpr std::size_t kMostBlocks = 65'535;

// They survive power-off. What only looks at a contour registers nothing.
bool b_keep(Execution& x) {
    if (x.reading.contour || x.core.port().keep(kBProgramsKept, b_text(x.b_axis.programs)))
        return true;
    return x.core.fail(Alarm::BMemoryFull, 'G');
}

bool b_axis_here(Execution& x) {
    return x.core.view().axis_by_name("B") >= 0 || x.core.fail(Alarm::BNotEnabled, 'G', "F8250");
}

// A block of words as a step of the B program.
bool b_step(Execution& x, BStep& step, bool single) {
    const params::Table& t = x.core.view().table();
    const unsigned l = x.core.view().channel;
    step = {};
    unsigned others = 0;
    const Word* time = nullptr;  // of G4; no axis
    step.absolute = params::bit(t, params::f8240, l, 6);
    for (unsigned k = 0; k < x.block.count; ++k) {
        const Word& word = x.block.words[k];
        const auto refuse = [&] {
            blame(x, word);
            return x.core.fail(Alarm::BProgramCode, 0,
                               text_of(x, word).empty() ? "" : std::string(text_of(x, word)));
        };
        switch (word.address) {
            case 'N':
                break;
            case 'G': {
                const auto tenths = std::lround(word.value * 10);
                if (single && tenths == 1100) break;
                if (tenths == 980 || tenths == 990)
                    step.feed_mode = tenths == 980 ? 1 : 2;
                else if (tenths == 0 || tenths == 10)
                    step.motion = tenths == 0 ? 1 : 2;
                else if (tenths == 40 || tenths == 280)
                    step.one_shot = static_cast<int>(tenths);
                else if (tenths >= 800 && tenths <= 860)
                    step.drilling = static_cast<int>(tenths);
                else
                    return refuse();
                break;
            }
            case 'B':
                step.has_b = true;
                step.b = length_of(x, word, x.core.view().axis_by_name("B"));
                break;
            case 'F':
                if (word.value < 0) return x.core.fail(Alarm::NegativeSign, 'F', "F");
                step.feed = word.value * x.modal.input.unit;
                step.feed_turn = fine_feed(word,
                                           word.has_point || word.from_expression ||
                                               x.settings.point_means_nothing,
                                           x.settings.series15, x.modal.input.inch) *
                                 x.modal.input.unit;
                break;
            case 'R':
                step.has_r = true;
                step.r = length_of(x, word, x.core.view().axis_by_name("B"));
                break;
            case 'Q':
                step.q = std::fabs(length_of(x, word, x.core.view().axis_by_name("B")));
                break;
            case 'X':
            case 'U':
                time = &word;
                [[fallthrough]];
            case 'P':
                step.p = seconds_of(x, word);
                step.has_p = true;
                break;
            case 'M':
            case 'S':
            case 'T':
                step.letter = word.address;
                step.code = word.value;
                ++others;
                break;
            default:
                return refuse();
        }
    }
    if (time && step.one_shot != 40) {
        blame(x, *time);
        return x.core.fail(Alarm::BProgramCode, 0, std::string(text_of(x, *time)));
    }
    if (others > 1 || (others == 1 && (step.has_b || step.drilling > 0)))
        return x.core.fail(Alarm::BProgramCode, step.letter, std::string(1, step.letter));
    if (step.one_shot == 280 && step.has_b) return x.core.fail(Alarm::BProgramCode, 'B', "G28 B");
    if (step.drilling > 800 && !step.has_r) return x.core.fail(Alarm::BLevelMissing, 'G');
    if (step.drilling == 830 && !(step.q > 0)) return x.core.fail(Alarm::BPeckMissing, 'G');
    if (single && step.drilling > 0) return x.core.fail(Alarm::BSingleCycle, 'G');
    return true;
}

// M, S, T of the B program. T from F8257 on is an offset of B: it moves B by the difference at
// once. The values are those of the offset table's Y column.
bool b_function(Execution& x, const BStep& step, bool line) {
    const params::Table& t = x.core.view().table();
    const auto base = static_cast<double>(params::get(t, params::f8257, x.core.view().channel));
    if (step.letter == 'T' && base > 0 && step.code >= base && step.code <= base + 9) {
        const auto b = static_cast<unsigned>(x.core.view().axis_by_name("B"));
        const auto number = static_cast<std::size_t>(step.code - base);
        const OffsetCell& cell = x.core.view().store->offsets[number];
        AxisValues wanted = x.core.path.wanted;
        wanted[b] = number ? cell.geometry[1] + cell.wear[1] : 0.0;
        x.core.set_wanted(wanted);
        const AxisValues here = x.core.path.programmed;
        return line ? x.core.linear(here) : x.core.rapid(here);
    }
    const std::string text =
        std::string(1, step.letter) + std::to_string(static_cast<long>(step.code));
    x.core.aux(step.letter, step.code, text, false);
    return true;
}

bool b_steps(Execution& x, const std::vector<BStep>& program, unsigned b) {
    const params::Table& t = x.core.view().table();
    const unsigned l = x.core.view().channel;
    bool line = params::bit(t, params::f8241, l, 1),
         per_revolution = params::bit(t, params::f8241, l, 2);
    double feed = 0.0, feed_turn = 0.0;
    BStep cycle;
    bool good = true, known = false;  // where B is, whatever another channel did with it
    x.core.path.feed_mode = per_revolution ? FeedMode::PerRevolution : FeedMode::PerMinute;
    x.core.path.feed = 0.0;
    for (std::size_t n = 0; good && n < program.size(); ++n) {
        const BStep& step = program[n];
        if (step.feed_mode)
            x.core.path.feed_mode =
                step.feed_mode == 2 ? FeedMode::PerRevolution : FeedMode::PerMinute;
        if (step.feed > 0) {
            feed = step.feed;
            feed_turn = step.feed_turn;
        }
        x.core.path.feed = x.core.path.feed_mode == FeedMode::PerRevolution ? feed_turn : feed;
        if (step.motion) {
            line = step.motion == 2;
            cycle = {};
        }
        if (step.drilling == 800)
            cycle = {};
        else if (step.drilling)
            cycle = step;
        known = known || step.one_shot == 280 || (step.has_b && step.absolute && !cycle.drilling);
        x.core.at.own_by_way = !known;
        if (step.has_b && (line || cycle.drilling) && !(x.core.path.feed > 0)) {
            good = x.core.fail(Alarm::BFeedMissing);
            break;
        }
        if (step.letter) good = b_function(x, step, line);
        AxisValues target = x.core.path.programmed;
        if (!good) break;
        if (step.one_shot == 40) {
            good = x.core.dwell(step.p, false);
        } else if (step.one_shot == 280) {
            AxisValues machine = x.core.path.machine;
            machine[b] = x.core.view().axes[b].reference_mm[0];
            good = x.core.reference(machine, 1u << b, MoveKind::Reference);
        } else if (cycle.drilling && step.has_b) {
            cycles::Drilling hole;
            hole.axis = b;
            hole.initial = x.core.path.programmed[b];
            hole.r_level = hole.initial + (step.has_r ? step.r : cycle.r);
            hole.bottom = hole.r_level + step.b;
            hole.dwells = cycle.has_p && cycle.p > 0;
            hole.dwell = cycle.p;
            if (cycle.drilling == 830) {
                hole.peck = cycle.q;
                hole.clearance = params::get(t, params::f8258, l);
            }
            using Way = cycles::Drilling::Way;
            hole.travel_out = cycle.drilling == 840   ? Way::Tap
                              : cycle.drilling == 850 ? Way::Feed
                              : cycle.drilling == 860 ? Way::StopRapid
                                                      : Way::Rapid;
            good = cycles::drill(x.core, hole);
        } else if (step.has_b) {
            target[b] = step.absolute ? step.b : target[b] + step.b;
            good = line ? x.core.linear(target) : x.core.rapid(target);
        }
    }
    return good;
}

// The steps are handed over; the axis runs them asynchronously.
bool b_run(Execution& x, const std::vector<BStep>& program) {
    const auto b = x.core.view().axis_by_name("B");
    x.core.at.own_axis = static_cast<std::int8_t>(b);
    const FeedMode mode = x.core.path.feed_mode;
    const double feed = x.core.path.feed;
    const bool locked = x.core.path.override_locked, exact = x.core.path.exact_stop_mode;
    const std::uint64_t ways = x.core.ways();
    x.core.path.exact_stop_mode = x.core.path.override_locked = false;
    x.core.signal("OWN_BEGIN", b);
    const bool good = b_steps(x, program, static_cast<unsigned>(b));
    x.core.signal("OWN_END", b);
    x.core.at.own_axis = -1;
    x.core.at.own_by_way = false;
    x.core.path.feed_mode = mode;
    x.core.path.feed = feed;
    x.core.path.override_locked = locked;
    x.core.path.exact_stop_mode = exact;
    x.b_axis.ways += x.core.ways() - ways;
    return good;
}

}  // namespace

// G101 G102 G103 begin a registration, G100 ends it.
bool g_b_register(Execution& x, const GCode& row) {
    if (x.words.g_count > 1 || x.words.axis_count || x.words.m_count || x.block.has('S') ||
        x.block.has('T') || x.block.has('F'))
        return x.core.fail(Alarm::BProgramCode, 'G', std::string(row.name));
    if (row.tenths == 1000) {
        if (x.b_axis.registering == 0) return x.core.fail(Alarm::BEndAlone, 'G');
        x.b_axis.programs[x.b_axis.registering - 1u] = std::move(x.b_axis.draft);
        x.b_axis.registering = 0;
        x.b_axis.draft.clear();
        return b_keep(x);
    }
    if (x.b_axis.registering != 0) {
        x.b_axis.registering = 0;
        return x.core.fail(Alarm::BBeginTwice, 'G');
    }
    if (!b_axis_here(x)) return false;
    x.b_axis.registering = static_cast<unsigned>(row.tenths - 1000) / 10u;
    x.b_axis.programs[x.b_axis.registering - 1u].clear();  // an error leaves it empty
    x.b_axis.draft.clear();
    return b_keep(x);
}

bool b_record(Execution& x) {
    if (x.b_axis.draft.size() >= kMostBlocks) return x.core.fail(Alarm::BMemoryFull, 'G');
    BStep step;
    if (!b_step(x, step, false)) {
        x.b_axis.registering = 0;
        return false;
    }
    x.b_axis.draft.push_back(step);
    return true;
}

bool g_b_single(Execution& x, const GCode&) {
    if (!b_axis_here(x)) return false;
    if (x.core.compensating() && x.b_axis.single_before)
        return x.core.fail(Alarm::BSingleTwice, 'G');
    x.b_axis.single_now = true;
    BStep step;
    return b_step(x, step, true) && b_run(x, {step});
}

// The M code of F8251 to F8253 starts a program.
bool b_start(Execution& x, double code) {
    const params::Table& t = x.core.view().table();
    const unsigned l = x.core.view().channel;
    const double codes[] = {static_cast<double>(params::get(t, params::f8251, l)),
                            static_cast<double>(params::get(t, params::f8252, l)),
                            static_cast<double>(params::get(t, params::f8253, l))};
    for (std::size_t n = 0; n < 3; ++n) {
        if (codes[n] <= 0 || codes[n] != code) continue;
        if (x.b_axis.programs[n].empty())
            return x.core.fail(Alarm::BNotRegistered, 'M', "G" + std::to_string(101 + n));
        return b_run(x, x.b_axis.programs[n]);
    }
    return true;
}

}  // namespace polyturn::channels::fanuc
