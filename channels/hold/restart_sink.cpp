#include "channels/hold/restart_sink.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "channels/hold/approach.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::channels {
namespace {

// Groups below are the machine's (N1341 to N1372: 1 to 16); those of every machine follow, then one
// for each letter and number.
constexpr int kMachineGroups = 16, kTurning = 17, kCoolant = 18, kToolChange = 19, kLetter = 100,
              kNumber = 1'000;

bool excludes(const Spindle& a, const Spindle& b) {  // the newer of the two holds
    const auto kind = [](SpindleModeCode mode) {
        switch (mode) {
            case SpindleModeCode::Limit:
                return 1;
            case SpindleModeCode::Watch:
            case SpindleModeCode::WatchOff:
                return 2;
            default:
                return 0;
        }
    };
    return a.spindle == b.spindle && kind(a.mode) == kind(b.mode);
}

}  // namespace

RestartSink::RestartSink(const MachineView& view, Sink& next) : view_(&view), next_(&next) {}

void RestartSink::search(std::int64_t block, std::uint32_t together) {
    searching_ = true;
    block_ = block;
    together_ = together;
    from_ = position_ = view_->start;
    macros_too_ = params::bit(view_->table(), params::n1338_block_no_search, view_->channel, 1);
    by_m6_ = params::bit(view_->table(), params::n1338_block_no_search, view_->channel, 0);
}

double RestartSink::position(unsigned machine_axis) const {
    for (unsigned i = 0; i < view_->axis_count; ++i)
        if (view_->axes[i].machine_axis == machine_axis) return position_[i];
    return 0.0;
}

bool RestartSink::here(const BlockContext& at, const Move* first) {
    if (searching_ && at.stack_depth == 0 && at.block == block_) arrive(at, first);
    return !searching_;
}

void RestartSink::move(const Move& m, const BlockContext& at) {
    if (here(at, &m)) return next_->move(m, at);
    position_ = m.machine;
    pos_ = m.pos;
    placed_ = true;
}

int RestartSink::group_of(const Aux& a) const {
    if (a.letter != 'M') return a.letter == 'T' ? kToolChange : kLetter + a.letter;
    const params::Table& table = view_->table();
    for (unsigned n = 0; n < kMachineGroups; ++n) {
        const auto low = params::get(table, params::nth(params::n1341_m_gr_low_1, n + 1),
                                     view_->channel),
                   high = params::get(table, params::nth(params::n1357_m_gr_high_1, n + 1),
                                      view_->channel);
        if (high > 0 && a.value >= static_cast<double>(low) && a.value <= static_cast<double>(high))
            return static_cast<int>(n) + 1;
    }
    if (a.value == 3 || a.value == 4 || a.value == 5 || a.value == 19) return kTurning;
    if (a.value == 7 || a.value == 8 || a.value == 9) return kCoolant;
    if (a.value == 6 && by_m6_) return kToolChange;
    return kNumber + static_cast<int>(a.value);
}

void RestartSink::aux(const Aux& a, const BlockContext& at) {
    if (here(at)) return next_->aux(a, at);
    if (at.own_axis >= 0) return;  // of a positioning axis' program
    if (look_up_tool && (a.letter == 'T' || (a.letter == 'M' && a.value == 6))) look_up_tool(a, at);
    if (at.by_code && !macros_too_) return;  // N1338 DSM
    const int group = group_of(a);
    // With M6 the tool that is loaded and the one that is prepared behind it are two: T M6 T.
    const bool change = group == kToolChange && by_m6_;
    if (change && a.letter == 'M') {
        const auto load = std::find_if(aux_.rbegin(), aux_.rend(), [&](const KeptAux& k) {
            return k.group == kToolChange && k.letter == 'T';
        });
        std::vector<KeptAux> kept;
        if (load != aux_.rend()) kept.push_back(*load);
        std::erase_if(aux_, [](const KeptAux& k) { return k.group == kToolChange; });
        aux_.insert(aux_.end(), kept.begin(), kept.end());
    } else if (change) {
        // two without a change between
        if (!aux_.empty() && aux_.back().group == kToolChange && aux_.back().letter == 'T')
            aux_.pop_back();
        else
            while (std::count_if(aux_.begin(), aux_.end(), [](const KeptAux& k) {
                       return k.group == kToolChange && k.letter == 'T';
                   }) > 1)
                aux_.erase(std::find_if(aux_.begin(), aux_.end(), [](const KeptAux& k) {
                    return k.group == kToolChange && k.letter == 'T';
                }));
    } else {
        std::erase_if(aux_, [&](const KeptAux& k) { return k.group == group; });
    }
    aux_.push_back({group, a.letter, a.value, std::string(a.text), a.by, std::string(a.name)});
}

void RestartSink::spindle(const Spindle& s, const BlockContext& at) {
    if (here(at)) return next_->spindle(s, at);
    if (at.by_code && !macros_too_) return;
    std::erase_if(spindles_, [&](const Spindle& kept) { return excludes(s, kept); });
    spindles_.push_back(s);
    Spindle& kept = spindles_.back();
    kept.silent = false;
    kept.mode_changed = kept.speed_changed = kept.turn_changed = true;
    kept.limit_changed = kept.limit_changed || s.mode == SpindleModeCode::Limit;
}

void RestartSink::wait(const Wait& w, const BlockContext& at) {
    if (w.act == Wait::Act::Arrive && !here(at)) return;
    if (here(at) || w.act != Wait::Act::Meet) return next_->wait(w, at);
    const std::uint32_t own = 1u << (view_->channel - 1);
    const std::uint32_t partners = w.channels & together_ & ~own;
    if (!partners) return;
    Wait replayed = w;
    replayed.channels = partners | own;
    replayed.flying = false;
    next_->wait(replayed, at);
}

void RestartSink::interrupts(const Interrupts& i, const BlockContext& at) {
    if (here(at)) return next_->interrupts(i, at);
    interrupts_ = i;
    interrupts_told_ = true;
}

void RestartSink::signal(std::string_view name, double value, const BlockContext& at) {
    if (here(at)) return next_->signal(name, value, at);
    if (at.own_axis >= 0) return;
    std::erase_if(signals_, [&](const auto& kept) { return kept.first == name; });
    signals_.emplace_back(name, value);
}

// "restart at N120: T0303 M3 M8 S1=800, then Z 5 -> -20, then X 60 -> 30"
std::string RestartSink::shown(const AxisValues& target) const {
    std::string words;
    for (const KeptAux& kept : aux_)
        words += (words.empty() ? "" : " ") +
                 (kept.text.empty() ? fmt::format("{}{:g}", kept.letter, kept.value) : kept.text);
    for (const Spindle& s : spindles_)
        if (s.mode == SpindleModeCode::Rpm || s.mode == SpindleModeCode::SurfaceSpeed)
            words += fmt::format("{}S{}={:g}{}", words.empty() ? "" : " ", s.spindle, s.value,
                                 s.mode == SpindleModeCode::Rpm ? "" : " m/min");
    return fmt::format("restart at N{}: {}{}{}", block_, words, words.empty() ? "" : ", then ",
                       approach_text(*view_, from_, target));
}

void RestartSink::arrive(const BlockContext& at, const Move* first) {
    searching_ = false;
    const AxisValues target = first ? first->machine_start : position_;
    AxisValues pos = target;
    if (first) {
        for (unsigned i = 0; i < view_->axis_count; ++i)
            pos[i] = first->pos[i] + first->machine_start[i] - first->machine[i];
    } else if (placed_) {
        pos = pos_;
    }
    next_->message(shown(target), at);
    next_->stop({StopReason::Restart}, at);
    for (const bool tools : {true, false})
        for (const KeptAux& kept : aux_)
            if ((kept.group == kToolChange) == tools)
                next_->aux({.letter = kept.letter,
                            .value = kept.value,
                            .text = kept.text,
                            .by = kept.by,
                            .name = kept.name},
                           at);
    // Limits before the speeds that they limit.
    for (const bool limits : {true, false})
        for (const Spindle& s : spindles_)
            if ((s.mode == SpindleModeCode::Limit) == limits) next_->spindle(s, at);
    approach(*view_, from_, target, pos, at, *next_);
    for (const auto& [name, value] : signals_) next_->signal(name, value, at);
    if (interrupts_told_) next_->interrupts(interrupts_, at);
    aux_.clear();
    spindles_.clear();
    signals_.clear();
}

}  // namespace polyturn::channels
