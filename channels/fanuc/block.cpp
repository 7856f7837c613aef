// One block of words: what it codes, whether every word has a taker, and the order in which it
// acts.
#include <fmt/format.h>

#include <cmath>

#include "channels/fanuc/interpreter.hpp"
#include "channels/fanuc/motion/feed_words.hpp"

namespace polyturn::channels::fanuc {
namespace {

constexpr std::uint32_t kAlways = letter_set("NOFSTMG");
constexpr std::uint32_t bit_of(GGroup group) { return 1u << static_cast<unsigned>(group); }

// Series 15 only (fanuc_lathe 8.1). A value of 0 is reported by the code that needs a feed.
bool feed_in_range(Core& core, const Word& word, FeedKind kind, double value, bool inch) {
    // IS-C
    const bool fine_axes = core.view().axis_count > 0 && core.view().axes[0].increment < 0.0005;
    const FeedRange range = series15_range(kind, word.has_point, inch, fine_axes);
    return range.holds(value) ||
           core.fail(Alarm::ValueOutOfRange, word.address,
                     fmt::format("{}: {} to {}", word.address, range.low, range.high));
}

std::string g_name(double value) {
    std::string text = "G" + std::to_string(static_cast<long>(value));
    const long tenth = std::lround((value - std::floor(value)) * 10);
    if (tenth) text += "." + std::to_string(tenth);
    return text;
}

// The bits that would make it a code: G95 is one of systems B and C. Nothing: it is none in any of
// them.
std::string known_elsewhere(const Settings& settings, double tenths) {
    std::uint8_t systems = 0;
    for (const GCode& row : g_codes())
        if (row.tenths == tenths) systems |= row.systems;
    if (settings.nct || settings.mefi || !(systems & kFanuc)) return {};
    std::string where;
    if ((systems & kA) && settings.system != kA) where += "A: F3401#6 = 0, #7 = 0";
    if ((systems & kB) && settings.system != kB)
        where += std::string(where.empty() ? "" : "; ") + "B: F3401#6 = 1" +
                 (settings.system == kC ? ", #7 = 0" : "");
    if ((systems & kC) && settings.system != kC)
        where += std::string(where.empty() ? "" : "; ") + "C: F3401#7 = 1";
    return where.empty() ? where : " (" + where + ")";
}

}  // namespace

bool Interpreter::too_many_words(const Word& word) {
    fault_column_ = word.column;
    fault_length_ = word.length;
    return core_.fail(Alarm::WordsTooMany);
}

// Sorts the words: G rows by group, M words, axis words.
bool Interpreter::classify() {
    coded_groups_ = 0;
    m_count_ = axis_word_count_ = g_count_ = comma_count_ = 0;
    spindle_words_ = false;
    comma_angle_ = -1;
    for (unsigned i = 0; i < block_.count; ++i) {
        const Word& word = block_.words[i];
        if (word.axis >= kSpindleWord) {
            spindle_words_ = true;
            continue;
        }
        if (word.axis >= 0) {
            if (axis_word_count_ == axis_words_.size()) return too_many_words(word);
            axis_words_[axis_word_count_++] = static_cast<std::uint8_t>(i);
            continue;
        }
        const char letter = word.address;
        if (letter >= 'a') {
            if (letter == 'a' && comma_angle_ < 0 && !block_.has('A') && !settings_.mefi) {
                comma_angle_ = static_cast<int>(i);
                continue;
            }
            if (comma_count_ == comma_words_.size() || settings_.mefi) {
                fault_column_ = word.column;
                fault_length_ = word.length;
                return core_.fail(Alarm::AddressIllegal, 0,
                                  std::string(",") + static_cast<char>(letter - 32));
            }
            comma_words_[comma_count_++] = static_cast<std::uint8_t>(i);
            continue;
        }
        if (letter == 'G') {
            const double tenths = word.value * 10.0, whole_tenths = std::nearbyint(tenths);
            const GCode* row =
                std::fabs(tenths - whole_tenths) < 1e-6 && whole_tenths >= 0 && whole_tenths < 10000
                    ? table_.find(drilling_name(static_cast<std::uint32_t>(whole_tenths)))
                    : nullptr;
            if (!row) {
                fault_column_ = word.column;
                fault_length_ = word.length;
                return core_.fail(Alarm::GCodeUnknown, 'G',
                                  g_name(word.value) + known_elsewhere(settings_, whole_tenths));
            }
            if (g_count_ < g_words_.size()) g_words_[g_count_++] = static_cast<std::uint8_t>(i);
            coded_[static_cast<std::size_t>(row->group)] = row;
            coded_groups_ |= bit_of(row->group);
        } else if (letter == 'M') {
            // fanuc_lathe 6.1
            if (word.from_expression) block_.words[i].value = whole_steps(word.value, 1.0);
            if (m_count_ == m_words_.size()) return too_many_words(word);
            m_words_[m_count_++] = static_cast<std::uint8_t>(i);
        } else if (axis_letters_ >> (letter - 'A') & 1u) {
            if (axis_word_count_ == axis_words_.size()) return too_many_words(word);
            axis_words_[axis_word_count_++] = static_cast<std::uint8_t>(i);
        }
    }
    // H behind G43, G44, G43.7, G43.4, G43.1 is an offset number, not the increment of an axis.
    const bool tip_control =
        (coded_groups_ & bit_of(GGroup::Transform)) &&
        coded_[static_cast<std::size_t>(GGroup::Transform)]->act == &Interpreter::g_length;
    if (((coded_groups_ & bit_of(GGroup::Length)) || tip_control) && block_.has('H') &&
        absolute_axis_['H' - 'A'] < 0) {
        unsigned kept = 0;
        for (unsigned k = 0; k < axis_word_count_; ++k)
            if (block_.words[axis_words_[k]].axis >= 0 ||
                block_.words[axis_words_[k]].address != 'H')
                axis_words_[kept++] = axis_words_[k];
        axis_word_count_ = kept;
    }
    return !settings_.mefi || says_it_once();
}

// A milling channel calls three drilling cycles by the numbers that a lathe needs for turning
// (N1503#0, N1611#0).
std::uint32_t Interpreter::drilling_name(std::uint32_t tenths) const {
    constexpr std::uint32_t kNoCode = 9999;
    // aliases of the codes that have moved
    if (settings_.milling_drills && (tenths == 1830 || tenths == 1840 || tenths == 1860))
        return kNoCode;
    // G183 is G83.1 (nct part 2 17.4)
    if (settings_.nct && (tenths == 1830 || tenths == 1840 || tenths == 1860))
        return (tenths - 1000) + 1;
    if (!settings_.milling_drills) return tenths;
    // CSM = 0: these cycles have the numbers below, and no others (nct part 1 16.2)
    if (tenths == 831 || tenths == 841 || tenths == 861) return kNoCode;
    return tenths == 730 ? 831 : tenths == 740 ? 841 : tenths == 760 ? 861 : tenths;
}

// Every word must be used: an unused word is a mistake of the program.
bool Interpreter::check_words() {
    if (!polygon_alone()) return false;
    std::uint32_t taken = kAlways;
    for (std::uint32_t left = coded_groups_; left; left &= left - 1) {
        const GCode* row = coded_[static_cast<std::size_t>(__builtin_ctz(left))];
        // whatever words it has
        if (!row->act) return core_.fail(Alarm::NotBuilt, 'G', std::string(row->name));
        taken |= takes_[static_cast<std::size_t>(row - g_codes().data())];
    }
    if (!(coded_groups_ & (bit_of(GGroup::OneShot) | bit_of(GGroup::Motion))))
        taken |= takes_[static_cast<std::size_t>(motion_ - g_codes().data())];
    if (m_count_) taken |= letter_set("PQL");
    if (settings_.offsets_by_g || core_.view().config().kind == ChannelKind::Mill)
        taken |= letter_set("D");
    if (drilling_ && !(coded_groups_ & bit_of(GGroup::OneShot)))
        taken |= letter_set("RQPLKEIJ") | axis_letters_;
    if (length_word()) taken |= letter_set("H");
    if (parameter_input_) taken |= letter_set("NPR");
    if (life_.mode) taken |= letter_set("NPLQT");
    for (unsigned k = 0; k < m_count_; ++k)
        if (block_.words[m_words_[k]].value == settings_.interrupt.on) taken |= letter_set("P");
    for (const char letter : settings_.aux_letters)
        if (letter) taken |= letter_bit(letter);
    for (const auto& address : settings_.spindle_addresses)
        if (address.name.size() == 1) taken |= letter_bit(address.name[0]);
    bool calls = false;
    for (unsigned k = 0; k < m_count_; ++k) calls = calls || block_.words[m_words_[k]].value == 98;
    if (block_.name_length && !calls) {
        fault_column_ = block_.name_from;
        fault_length_ = block_.name_length + 2u;
        return core_.fail(
            Alarm::AddressIllegal, 0,
            "<" + std::string(line_.substr(block_.name_from, block_.name_length)) + ">");
    }
    const std::uint32_t extra = block_.letters & ~taken;
    if (!extra) return true;
    const char letter = static_cast<char>('A' + __builtin_ctz(extra));
    return core_.fail(Alarm::AddressIllegal, letter, std::string(1, letter));
}

bool Interpreter::length_word() const {
    const GCode* active = active_[static_cast<std::size_t>(GGroup::Length)];
    return settings_.power_on_length != 0 && !(coded_groups_ & bit_of(GGroup::Length)) &&
           block_.has('H') && !(axis_letters_ & letter_bit('H')) && active &&
           (active->tenths == 430 || active->tenths == 440);
}

Step Interpreter::nc_block() {
    jumped_ = called_ = wants_barrier_ = false;
    core_.did();
    const std::uint64_t ways_before = core_.ways();
    bool calls = false;
    if (!settings_.g_calls.empty() || !settings_.m_calls.empty() ||
        !settings_.letter_calls.empty() || settings_.t_calls) {
        if (!life_.mode && !code_calls(calls)) return fault(core_.fault());
    }
    bool called_behind = false;  // by G66.1, when the block has acted
    if (!calls && gives_arguments()) {
        if (const Word* const stop = stops_or_waits()) {
            if (!stands_alone(*stop)) return fault(core_.fault());
            called_behind = true;
        } else {
            if (!per_block_call()) return fault(core_.fault());
            calls = true;
        }
    }
    b_.single_now = false;
    b_.ways = 0;
    // all words of such a block are the B axis'
    if (block_.has('G') && !calls && !b_.registering && !settings_.nct && !settings_.mefi)
        for (std::size_t k = 0; k < block_.count; ++k)
            if (block_.words[k].axis < 0 && block_.words[k].address == 'G' &&
                block_.words[k].value == 110) {
                if (!classify() || !g_b_single(*table_.find(1100))) return fault(core_.fault());
                calls = true;
            }
    if (b_.registering && !calls) {  // G101 to G100: nothing acts
        const bool ends = block_.has('G') && block_.value('G') >= 100 && block_.value('G') <= 103;
        if (!ends && (block_.letters & ~letter_set("NO"))) {
            if (!classify() || !b_record()) return fault(core_.fault());
            return Step::Continue;
        }
    }
    const bool single_b = b_.single_now;
    if (!calls && !fresh_ && block_.has('G')) {
        if (!classify()) return fault(core_.fault());
        // the axes rest first (architecture 5.8); the block is read again behind it
        if (switches_transformation() && !core_.reads_ahead()) {
            reread_ = true;
            line_left_ = false;
            live_value_barrier();
            return Step::AtBarrier;
        }
    }
    if (!calls && block_.has('T') && !life_.mode && managed_serial_ != core_.at.serial &&
        waits_for_tool()) {
        if (core_.reads_ahead() && !fresh_) {  // what is held for its corner ends first
            reread_ = true;
            line_left_ = false;
            live_value_barrier();
            return Step::AtBarrier;
        }
        if (!classify() || !call_managed_tool()) return fault(core_.fault());
        managed_serial_ = core_.at.serial;
        reread_ = true;
        line_left_ = false;
        return Step::AtBarrier;
    }
    if (!calls && !fresh_ && names_managed_offset() && !core_.reads_ahead()) {
        reread_ = true;
        line_left_ = false;
        live_value_barrier();
        return Step::AtBarrier;
    }
    if (!calls && dialogue_.open && ends_program()) {
        bool done = false;
        if (!pattern_dialogue(done)) return fault(core_.fault());
        if (!done) return dialogue_.asked ? Step::AtBarrier : Step::Continue;
    }
    if (!calls && !(classify() && transformation_allows() &&
                    (is_macro_call() ? macro_call() : check_words() && (judge_points(), act()))))
        return fault(core_.fault());
    b_.single_before = b_.single_now;
    if (core_.transformation_failed()) return fault(core_.fault());
    if (interruption_.running && (block_.letters & ~letter_set("NO")))
        interruption_.shows_end = false;
    if (sub_program_ >= 0) {
        const std::int64_t program = sub_program_;
        sub_program_ = -1;
        called_ = true;
        if (!ended_ && !call_program(program, sub_repeats_, nullptr, true, false, 0)) {
            fault_column_ = sub_column_;
            fault_length_ = sub_length_;
            return fault(core_.fault());
        }
    }
    if (local_call_ >= 0 && !call_block(std::exchange(local_call_, -1))) {
        fault_column_ = sub_column_;
        fault_length_ = sub_length_;
        return fault(core_.fault());
    }
    if (finishing_.active && !ended_ && !called_ && frames_.size() == finishing_.depth &&
        core_.at.block == finishing_.last && !end_finishing())
        return fault(core_.fault());
    end_one_block_shift();
    if (core_.reads_ahead()) {
        // calls belong to no path
        const bool counts =
            !called_ && (!calls || single_b) && (block_.letters & ~letter_set("NO")) != 0;
        if (!core_.end_compensated_block(counts, wants_barrier_, ended_))
            return fault(core_.fault());
        if (core_.transformation_failed()) return fault(core_.fault());
    }
    if (managed_serial_ == core_.at.serial) core_.mark_emitted();  // its T came before the barrier
    if (core_.emitted()) {
        fresh_ = false;
        core_.end_block();
    }
    if (called_behind) {
        if (!per_block_call()) return fault(core_.fault());
    } else if (!ended_ && !called_ && !modal_calls_.empty()) {
        const ModalCall& modal = modal_calls_.back();
        if (!modal.every_block && core_.ways() - b_.ways != ways_before) {
            const LocalSet arguments = modal.arguments;
            if (!call_program(modal.program, modal.repeats, &arguments, false, true, 'P'))
                return fault(core_.fault());
        }
    }
    if (!modal_calls_.empty()) modal_calls_.back().armed = true;
    // a barrier ahead may be held back
    if (core_.reads_ahead())
        return core_.halted() ? Step::AtBarrier : ended_ ? Step::Ended : Step::Continue;
    if (ended_) return Step::Ended;
    return wants_barrier_ ? Step::AtBarrier : Step::Continue;
}

// In the block of G65 and G66 all other words are arguments, and no other G code may stand there.
bool Interpreter::is_macro_call() const {
    for (unsigned k = 0; k < g_count_; ++k)
        if (const GCode* row = g_row(k); row && (row->act == &Interpreter::g_macro_call ||
                                                 row->act == &Interpreter::g_macro_modal))
            return true;
    return false;
}

const GCode* Interpreter::g_row(unsigned k) const {
    return table_.find(
        static_cast<std::uint32_t>(std::lround(block_.words[g_words_[k]].value * 10.0)));
}

bool Interpreter::macro_call() {
    const GCode* call = nullptr;
    for (unsigned k = 0; k < g_count_; ++k) {
        const GCode* row = g_row(k);
        if (!call &&
            (row->act == &Interpreter::g_macro_call || row->act == &Interpreter::g_macro_modal)) {
            call = row;
            continue;
        }
        const Word& word = block_.words[g_words_[k]];
        fault_column_ = word.column;
        fault_length_ = word.length;
        return core_.fail(Alarm::MacroArgument, 'G', std::string(text_of(word)));
    }
    if (call->group == GGroup::MacroModal) active_[static_cast<std::size_t>(call->group)] = call;
    return (this->*call->act)(*call);
}

bool Interpreter::act() {
    if (parameter_input_ && !(coded_groups_ & bit_of(GGroup::OneShot)))
        return g10_parameter_block();
    if (life_.mode && !(coded_groups_ & bit_of(GGroup::OneShot))) return life_group_block();
    words_used_ = false;
    block_corner_ = {};
    // Settings, in the order of GGroup.
    constexpr std::uint32_t kLate = bit_of(GGroup::OneShot) | bit_of(GGroup::Motion) |
                                    bit_of(GGroup::MacroModal) | bit_of(GGroup::Surface);
    for (std::uint32_t left = coded_groups_ & ~kLate; left; left &= left - 1) {
        const GCode* row = coded_[static_cast<std::size_t>(__builtin_ctz(left))];
        if (!row->act) return core_.fail(Alarm::NotBuilt, 'G', std::string(row->name));
        if (!(this->*row->act)(*row)) return false;
        active_[static_cast<std::size_t>(row->group)] = row;
    }
    if (length_word() && !g_length(*active_[static_cast<std::size_t>(GGroup::Length)]))
        return false;
    const GCode* one_shot = coded_groups_ & bit_of(GGroup::OneShot)
                                ? coded_[static_cast<std::size_t>(GGroup::OneShot)]
                                : nullptr;
    if (one_shot && one_shot->tenths != 40) {
        cycle_set_ = 0;
        cycle_taper_ = 0.0;
    }
    if (coded_groups_ & bit_of(GGroup::Motion)) {
        const GCode* next = coded_[static_cast<std::size_t>(GGroup::Motion)];
        if (next->act != &Interpreter::g_cycle_turning &&
            next->act != &Interpreter::g_cycle_facing &&
            next->act != &Interpreter::g_cycle_thread) {
            cycle_set_ = 0;
            cycle_taper_ = 0.0;
        }
        motion_ = coded_[static_cast<std::size_t>(GGroup::Motion)];
        active_[static_cast<std::size_t>(GGroup::Motion)] = motion_;
        drilling_ = nullptr;
    }
    if (block_.has('F') && !set_feed(block_.word('F'))) return false;
    if (settings_.series15 && block_.has('E') && block_.value('E') != 0) {
        const Word& word = block_.word('E');
        const bool plain = word.has_point || word.from_expression || settings_.point_means_nothing;
        if (!feed_in_range(core_, word, FeedKind::Lead, fine_feed(word, plain, true, inch_), inch_))
            return false;
    }
    for (unsigned k = 0; k < comma_count_; ++k)
        if (!corner_word(block_.words[comma_words_[k]])) return false;
    // refused
    if (comma_angle_ >= 0 && (motion_->tenths != 10 || one_shot || drilling_))
        return corner_word(block_.words[static_cast<std::size_t>(comma_angle_)]);
    if (coded_groups_ & bit_of(GGroup::Surface)) {
        const GCode* row = coded_[static_cast<std::size_t>(GGroup::Surface)];
        if (!(this->*row->act)(*row)) return false;
        active_[static_cast<std::size_t>(GGroup::Surface)] = row;
    }
    constexpr std::uint32_t kFunctions = letter_set("STMBACUVWDEH");
    const bool functions = (block_.letters & kFunctions & ~axis_letters_) != 0 || spindle_words_;
    if (functions) {
        if (block_.has('S') && !spindle_word()) return false;
        if (spindle_words_ && !named_spindles()) return false;
        if (block_.has('T') && !gear_block() && !tool_word()) return false;
        if (!m_before()) return false;
    } else if (coded_groups_ & bit_of(GGroup::Surface)) {
        if (!core_.commit_spindle()) return false;
    }
    if (coded_groups_ & bit_of(GGroup::MacroModal)) {
        const GCode* row = coded_[static_cast<std::size_t>(GGroup::MacroModal)];
        if (!row->act) return core_.fail(Alarm::NotBuilt, 'G', std::string(row->name));
        active_[static_cast<std::size_t>(GGroup::MacroModal)] = row;
        return (this->*row->act)(*row);
    }
    if (one_shot) {
        if (!one_shot->act) return core_.fail(Alarm::NotBuilt, 'G', std::string(one_shot->name));
        if (!(this->*one_shot->act)(*one_shot)) return false;
    } else if (drilling_) {
        if ((axis_word_count_ || block_.has('R')) && !run_drilling()) return false;
    } else if (words_used_) {
        ;  // G51 X Z P names a point, and nothing moves
    } else if (axis_word_count_ || (coded_groups_ & bit_of(GGroup::Motion)) ||
               (angle_word() && motion_->tenths == 10 && !settings_.mefi) || block_.has('I') ||
               block_.has('J') || block_.has('K') || block_.has('R')) {
        if (!motion_->act) return core_.fail(Alarm::NotBuilt, 'G', std::string(motion_->name));
        // F is the speed in the plane of millimetres and degrees
        core_.path.feed_path.degree_mm = settings_.mefi ? 0.0 : unit_;
        if (!(this->*motion_->act)(*motion_)) return false;
    }
    return m_count_ ? m_after() : true;
}

// Millimetres or degrees of a word, on the scale on which the axis is programmed.
double Interpreter::length(const Word& word, int place) const {
    const MachineView& view = core_.view();
    const bool rotary = place >= 0 && view.axes[static_cast<std::size_t>(place)].rotary;
    const double step =
        place >= 0 ? view.axes[static_cast<std::size_t>(place)].increment : view.axes[0].increment;
    // one more decimal place in inches
    const double increment = inch_ && !rotary ? step * 0.1 : step;
    double value = word.value;
    if (word.from_expression)
        value = whole_steps(value, increment) * increment;
    else if (!word.has_point && !settings_.point_means_nothing)
        value *= increment;
    return rotary ? value : value * unit_;
}

double Interpreter::radius_length(char letter) const {
    return block_.has(letter) ? length(block_.word(letter), -1) : 0.0;
}

Interpreter::AxisOf Interpreter::axis_of(const Word& word) const {
    if (word.axis >= 0) return {word.axis, !absolute_};
    const auto letter = static_cast<std::size_t>(word.address - 'A');
    if (absolute_axis_[letter] >= 0) return {absolute_axis_[letter], !absolute_};
    return {incremental_axis_[letter], true};
}

bool Interpreter::axis_word(const Word& word, AxisValues& target, AxisSet& named) {
    const auto [place, incremental] = axis_of(word);
    const auto i = static_cast<std::size_t>(place);
    const ChannelAxis& axis = core_.view().axes[i];
    if (polygon_on_ && turns_polygon(static_cast<unsigned>(place)))
        return core_.fail(Alarm::PolygonAxisMoved, word.address, std::string(axis.name));
    double value = length(word, place) * (axis.diameter ? 0.5 : 1.0);
    const Transformation& transformation = core_.path.transformation;
    // an angle
    if (transformation.degrees && transformation.rotary_place() == place)
        value /= unit_ * transformation.degrees_per_mm();
    named |= 1u << i;
    if (axis.rollover)
        target[i] = core_.rollover_target(static_cast<unsigned>(place), value, !incremental);
    else
        target[i] = incremental ? core_.path.programmed[i] + value : value;
    return true;
}

// The target of the block: the programmed point with the block's axis words in it.
bool Interpreter::read_axis_words(AxisValues& target, AxisSet* named) {
    if (away_) {
        bool incremental = false;
        for (unsigned k = 0; k < axis_word_count_; ++k)
            incremental |= axis_of(block_.words[axis_words_[k]]).incremental;
        if (incremental) core_.displaced(*away_);
        if (axis_word_count_) away_.reset();
    }
    const unsigned count = core_.view().axis_count;
    for (unsigned i = 0; i < count; ++i) target[i] = core_.path.programmed[i];
    AxisSet set = 0;
    for (unsigned k = 0; k < axis_word_count_; ++k)
        if (!axis_word(block_.words[axis_words_[k]], target, set)) return false;
    if (polar_ && !polar_target(target, set)) return false;
    if (named) *named = set;
    core_.fixture_names(set);
    return true;
}

bool Interpreter::whole(char letter, std::int64_t& value) {
    const Word& word = block_.word(letter);
    const double rounded = whole_steps(word.value, 1.0);
    if (!word.from_expression && word.has_point)
        return core_.fail(Alarm::PointForbidden, letter, std::string(1, letter));
    if (rounded < 0) return core_.fail(Alarm::NegativeSign, letter, std::string(1, letter));
    value = static_cast<std::int64_t>(rounded);
    return true;
}

bool Interpreter::set_feed(const Word& word) {
    if (word.value < 0) return core_.fail(Alarm::NegativeSign, 'F', "F");
    const GCode* one_shot = coded_groups_ & bit_of(GGroup::OneShot)
                                ? coded_[static_cast<std::size_t>(GGroup::OneShot)]
                                : nullptr;
    const bool plain = word.has_point || word.from_expression || settings_.point_means_nothing;
    const bool threading = one_shot ? one_shot->act == &Interpreter::g_thread_passes
                                    : (motion_->act == &Interpreter::g_thread ||
                                       motion_->act == &Interpreter::g_thread_variable ||
                                       motion_->act == &Interpreter::g_thread_arc ||
                                       motion_->act == &Interpreter::g_cycle_thread);
    const double programmed = fine_feed(word, plain, settings_.series15, inch_),
                 fine = programmed * unit_;
    if (settings_.series15 && word.value != 0) {
        const bool per_turn = threading || core_.path.feed_mode == FeedMode::PerRevolution;
        const FeedKind kind = threading  ? FeedKind::Lead
                              : per_turn ? FeedKind::PerRevolution
                                         : FeedKind::PerMinute;
        if (!feed_in_range(core_, word, kind, per_turn ? programmed : word.value, inch_))
            return false;
    }
    if (threading) lead_ = fine;
    if (core_.path.feed_mode == FeedMode::PerRevolution)
        core_.path.feed = fine;
    else if (!threading)
        core_.path.feed = word.value * unit_;
    return true;
}

}  // namespace polyturn::channels::fanuc
