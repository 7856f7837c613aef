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
#include <cmath>

#include "channels/cycles/drilling.hpp"
#include "channels/fanuc/interpreter.hpp"
#include "channels/fanuc/motion/b_memory.hpp"
#include "channels/fanuc/motion/feed_words.hpp"

namespace polyturn::channels::fanuc {
namespace {
constexpr std::size_t kMostBlocks = 65'535;
}

// G101 G102 G103 begin a registration, G100 ends it.
bool Interpreter::g_b_register(const GCode& row) {
    if (g_count_ > 1 || axis_word_count_ || m_count_ || block_.has('S') || block_.has('T') ||
        block_.has('F'))
        return core_.fail(Alarm::BProgramCode, 'G', std::string(row.name));
    if (row.tenths == 1000) {
        if (b_.registering == 0) return core_.fail(Alarm::BEndAlone, 'G');
        b_.programs[b_.registering - 1u] = std::move(b_.draft);
        b_.registering = 0;
        b_.draft.clear();
        return b_keep();
    }
    if (b_.registering != 0) {
        b_.registering = 0;
        return core_.fail(Alarm::BBeginTwice, 'G');
    }
    if (!b_axis_here()) return false;
    b_.registering = static_cast<unsigned>(row.tenths - 1000) / 10u;
    b_.programs[b_.registering - 1u].clear();  // an error leaves it empty
    b_.draft.clear();
    return b_keep();
}

// They survive power-off. What only looks at a contour registers nothing.
bool Interpreter::b_keep() {
    if (reads_contour_ || core_.port().keep(kBProgramsKept, b_text(b_.programs))) return true;
    return core_.fail(Alarm::BMemoryFull, 'G');
}

bool Interpreter::b_axis_here() {
    return core_.view().axis_by_name("B") >= 0 || core_.fail(Alarm::BNotEnabled, 'G', "F8250");
}

// A block of words as a step of the B program.
bool Interpreter::b_step(BStep& step, bool single) {
    const params::Table& t = core_.view().table();
    const unsigned l = core_.view().channel;
    step = {};
    unsigned others = 0;
    const Word* time = nullptr;  // of G4; no axis
    step.absolute = params::bit(t, params::f8240, l, 6);
    for (unsigned k = 0; k < block_.count; ++k) {
        const Word& word = block_.words[k];
        const auto refuse = [&] {
            fault_column_ = word.column;
            fault_length_ = word.length;
            return core_.fail(Alarm::BProgramCode, 0,
                              text_of(word).empty() ? "" : std::string(text_of(word)));
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
                step.b = length(word, core_.view().axis_by_name("B"));
                break;
            case 'F':
                if (word.value < 0) return core_.fail(Alarm::NegativeSign, 'F', "F");
                step.feed = word.value * unit_;
                step.feed_turn = fine_feed(word,
                                           word.has_point || word.from_expression ||
                                               settings_.point_means_nothing,
                                           settings_.series15, inch_) *
                                 unit_;
                break;
            case 'R':
                step.has_r = true;
                step.r = length(word, core_.view().axis_by_name("B"));
                break;
            case 'Q':
                step.q = std::fabs(length(word, core_.view().axis_by_name("B")));
                break;
            case 'X':
            case 'U':
                time = &word;
                [[fallthrough]];
            case 'P':
                step.p = seconds(word);
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
        fault_column_ = time->column;
        fault_length_ = time->length;
        return core_.fail(Alarm::BProgramCode, 0, std::string(text_of(*time)));
    }
    if (others > 1 || (others == 1 && (step.has_b || step.drilling > 0)))
        return core_.fail(Alarm::BProgramCode, step.letter, std::string(1, step.letter));
    if (step.one_shot == 280 && step.has_b) return core_.fail(Alarm::BProgramCode, 'B', "G28 B");
    if (step.drilling > 800 && !step.has_r) return core_.fail(Alarm::BLevelMissing, 'G');
    if (step.drilling == 830 && !(step.q > 0)) return core_.fail(Alarm::BPeckMissing, 'G');
    if (single && step.drilling > 0) return core_.fail(Alarm::BSingleCycle, 'G');
    return true;
}

bool Interpreter::b_record() {
    if (b_.draft.size() >= kMostBlocks) return core_.fail(Alarm::BMemoryFull, 'G');
    BStep step;
    if (!b_step(step, false)) {
        b_.registering = 0;
        return false;
    }
    b_.draft.push_back(step);
    return true;
}

bool Interpreter::g_b_single(const GCode&) {
    if (!b_axis_here()) return false;
    if (core_.compensating() && b_.single_before) return core_.fail(Alarm::BSingleTwice, 'G');
    b_.single_now = true;
    BStep step;
    return b_step(step, true) && b_run({step});
}

// The steps are handed over; the axis runs them asynchronously.
bool Interpreter::b_run(const std::vector<BStep>& program) {
    const auto b = core_.view().axis_by_name("B");
    core_.at.own_axis = static_cast<std::int8_t>(b);
    const FeedMode mode = core_.path.feed_mode;
    const double feed = core_.path.feed;
    const bool locked = core_.path.override_locked, exact = core_.path.exact_stop_mode;
    const std::uint64_t ways = core_.ways();
    core_.path.exact_stop_mode = core_.path.override_locked = false;
    core_.signal("OWN_BEGIN", b);
    const bool good = b_steps(program, static_cast<unsigned>(b));
    core_.signal("OWN_END", b);
    core_.at.own_axis = -1;
    core_.at.own_by_way = false;
    core_.path.feed_mode = mode;
    core_.path.feed = feed;
    core_.path.override_locked = locked;
    core_.path.exact_stop_mode = exact;
    b_.ways += core_.ways() - ways;
    return good;
}

bool Interpreter::b_steps(const std::vector<BStep>& program, unsigned b) {
    const params::Table& t = core_.view().table();
    const unsigned l = core_.view().channel;
    bool line = params::bit(t, params::f8241, l, 1),
         per_revolution = params::bit(t, params::f8241, l, 2);
    double feed = 0.0, feed_turn = 0.0;
    BStep cycle;
    bool good = true, known = false;  // where B is, whatever another channel did with it
    core_.path.feed_mode = per_revolution ? FeedMode::PerRevolution : FeedMode::PerMinute;
    core_.path.feed = 0.0;
    for (std::size_t n = 0; good && n < program.size(); ++n) {
        const BStep& step = program[n];
        if (step.feed_mode)
            core_.path.feed_mode =
                step.feed_mode == 2 ? FeedMode::PerRevolution : FeedMode::PerMinute;
        if (step.feed > 0) {
            feed = step.feed;
            feed_turn = step.feed_turn;
        }
        core_.path.feed = core_.path.feed_mode == FeedMode::PerRevolution ? feed_turn : feed;
        if (step.motion) {
            line = step.motion == 2;
            cycle = {};
        }
        if (step.drilling == 800)
            cycle = {};
        else if (step.drilling)
            cycle = step;
        known = known || step.one_shot == 280 || (step.has_b && step.absolute && !cycle.drilling);
        core_.at.own_by_way = !known;
        if (step.has_b && (line || cycle.drilling) && !(core_.path.feed > 0)) {
            good = core_.fail(Alarm::BFeedMissing);
            break;
        }
        if (step.letter) good = b_function(step, line);
        AxisValues target = core_.path.programmed;
        if (!good) break;
        if (step.one_shot == 40) {
            good = core_.dwell(step.p, false);
        } else if (step.one_shot == 280) {
            AxisValues machine = core_.path.machine;
            machine[b] = core_.view().axes[b].reference_mm[0];
            good = core_.reference(machine, 1u << b, MoveKind::Reference);
        } else if (cycle.drilling && step.has_b) {
            cycles::Drilling hole;
            hole.axis = b;
            hole.initial = core_.path.programmed[b];
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
            good = cycles::drill(core_, hole);
        } else if (step.has_b) {
            target[b] = step.absolute ? step.b : target[b] + step.b;
            good = line ? core_.linear(target) : core_.rapid(target);
        }
    }
    return good;
}

// M, S, T of the B program. T from F8257 on is an offset of B: it moves B by the difference at
// once. The values are those of the offset table's Y column.
bool Interpreter::b_function(const BStep& step, bool line) {
    const params::Table& t = core_.view().table();
    const auto base = static_cast<double>(params::get(t, params::f8257, core_.view().channel));
    if (step.letter == 'T' && base > 0 && step.code >= base && step.code <= base + 9) {
        const auto b = static_cast<unsigned>(core_.view().axis_by_name("B"));
        const auto number = static_cast<std::size_t>(step.code - base);
        const OffsetCell& cell = core_.view().store->offsets[number];
        AxisValues wanted = core_.path.wanted;
        wanted[b] = number ? cell.geometry[1] + cell.wear[1] : 0.0;
        core_.set_wanted(wanted);
        const AxisValues here = core_.path.programmed;
        return line ? core_.linear(here) : core_.rapid(here);
    }
    const std::string text =
        std::string(1, step.letter) + std::to_string(static_cast<long>(step.code));
    core_.aux(step.letter, step.code, text, false);
    return true;
}

// The M code of F8251 to F8253 starts a program.
bool Interpreter::b_start(double code) {
    const params::Table& t = core_.view().table();
    const unsigned l = core_.view().channel;
    const double codes[] = {static_cast<double>(params::get(t, params::f8251, l)),
                            static_cast<double>(params::get(t, params::f8252, l)),
                            static_cast<double>(params::get(t, params::f8253, l))};
    for (std::size_t n = 0; n < 3; ++n) {
        if (codes[n] <= 0 || codes[n] != code) continue;
        if (b_.programs[n].empty())
            return core_.fail(Alarm::BNotRegistered, 'M', "G" + std::to_string(101 + n));
        return b_run(b_.programs[n]);
    }
    return true;
}

}  // namespace polyturn::channels::fanuc
