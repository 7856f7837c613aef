// G10 L3 ... G11: tool life groups that a program registers. What the blocks say is handed to tool
// management step by step, in path order; which tool of a group works, and how long, is its
// business.
//
//   G10 L3         all groups are forgotten first (P1: only those that are named, P2: those named
//                  are forgotten)
//   P1 L30 Q1      group 1; life 30: uses (Q1, or none) or minutes (Q2)
//   T0101          its tools in the order in which they are used: station 1 of the turret with
//                  offset 1
//   T0202
//   P2 L15 Q2
//   T0303
//   G11
#include "channels/fanuc/tools/life_groups.hpp"

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"

namespace polyturn::channels::fanuc {
namespace {

constexpr std::int64_t kMostGroups = 9'999;  // as many as tool management knows

constexpr double kLongestLife = 999'999.0;

void tell_life_group(Execution& x, const LifeGroup& group) {
    x.core.mark_emitted();
    x.core.sink().life_group(group, x.core.at);
}

}  // namespace

bool begin_life_groups(Execution& x) {
    if (!x.settings.policy.program.life_groups) return x.core.fail(Alarm::NotBuilt, 'L', "G10 L3");
    std::int64_t how = 0;
    if (x.block.has('P') && !whole_number(x, 'P', how)) return false;
    if (how > 2) return x.core.fail(Alarm::ValueOutOfRange, 'P', "P");
    x.modal.life = {how == 0   ? LifeInput::Register
                    : how == 1 ? LifeInput::Change
                               : LifeInput::Forget,
                    0};
    if (how == 0) tell_life_group(x, {LifeGroupStep::ForgetAll});
    return true;
}

// A block between G10 L3 and G11.
bool life_group_block(Execution& x) {
    const auto misplaced = [&x](char letter) {
        return x.core.fail(letter == 'T' ? Alarm::TWordIllegal : Alarm::AddressIllegal, letter,
                           std::string(1, letter));
    };
    const auto out_of_range = [&x](char letter) {
        return x.core.fail(Alarm::ValueOutOfRange, x.block.has(letter) ? letter : 'P',
                           std::string(1, letter));
    };
    if (const std::uint32_t other = x.block.letters & ~letter_set("NPLQT"))
        return misplaced(static_cast<char>('A' + __builtin_ctz(other)));
    if (!(x.block.letters & ~letter_bit('N'))) return true;
    LifeGroup told;
    if (x.block.has('P')) {
        std::int64_t group = 0, kind = 1;
        if (!whole_number(x, 'P', group)) return false;
        if (x.block.has('T')) return misplaced('T');
        if (group < 1 || group > kMostGroups) return out_of_range('P');
        told.group = static_cast<std::int32_t>(group);
        if (x.modal.life.mode == LifeInput::Forget) {
            if (x.block.has('L') || x.block.has('Q'))
                return misplaced(x.block.has('L') ? 'L' : 'Q');
            told.step = LifeGroupStep::Forget;
            tell_life_group(x, told);
            return true;
        }
        if (x.block.has('Q') && !whole_number(x, 'Q', kind)) return false;
        const double life = x.block.has('L') ? x.block.value('L') : 0.0;
        if (kind < 1 || kind > 2) return out_of_range('Q');
        if (!(life > 0) || life > kLongestLife) return out_of_range('L');
        told.kind = kind == 2 ? LifeKind::Minutes : LifeKind::Uses;
        told.life = life;
        x.modal.life.group = told.group;
        tell_life_group(x, told);
        return true;
    }
    if (x.block.has('L') || x.block.has('Q')) return misplaced(x.block.has('L') ? 'L' : 'Q');
    if (x.modal.life.mode == LifeInput::Forget || x.modal.life.group == 0)
        return misplaced('T');  // of no group
    std::int64_t tool = 0, modulus = 1;
    if (!whole_number(x, 'T', tool)) return false;
    for (unsigned n = 0; n < x.settings.tool.offset_digits; ++n) modulus *= 10;
    told.step = LifeGroupStep::Tool;
    told.group = x.modal.life.group;
    told.station = static_cast<std::int32_t>(tool / modulus);
    told.offset = static_cast<std::int32_t>(tool % modulus);
    const int limit = x.core.view().config().offset_count;
    if (told.offset > limit)
        return x.core.fail(Alarm::OffsetNumberIllegal, 'T', {}, told.offset, limit);
    if (told.station < 1) return out_of_range('T');
    tell_life_group(x, told);
    return true;
}

}  // namespace polyturn::channels::fanuc
