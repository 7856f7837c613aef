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
#include <cmath>

#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {
namespace {
constexpr std::int64_t kMostGroups = 9'999;  // as many as tool management knows
constexpr double kLongestLife = 999'999.0;
}  // namespace

bool Interpreter::begin_life_groups() {
    if (settings_.nct || settings_.mefi) return core_.fail(Alarm::NotBuilt, 'L', "G10 L3");
    std::int64_t how = 0;
    if (block_.has('P') && !whole('P', how)) return false;
    if (how > 2) return core_.fail(Alarm::ValueOutOfRange, 'P', "P");
    life_ = {how == 0 ? LifeInput::Register : how == 1 ? LifeInput::Change : LifeInput::Forget, 0};
    if (how == 0) tell_life_group({LifeGroupStep::ForgetAll});
    return true;
}

void Interpreter::tell_life_group(const LifeGroup& group) {
    core_.mark_emitted();
    core_.sink().life_group(group, core_.at);
}

// A block between G10 L3 and G11.
bool Interpreter::life_group_block() {
    const auto misplaced = [this](char letter) {
        return core_.fail(letter == 'T' ? Alarm::TWordIllegal : Alarm::AddressIllegal, letter,
                          std::string(1, letter));
    };
    const auto out_of_range = [this](char letter) {
        return core_.fail(Alarm::ValueOutOfRange, block_.has(letter) ? letter : 'P',
                          std::string(1, letter));
    };
    if (const std::uint32_t other = block_.letters & ~letter_set("NPLQT"))
        return misplaced(static_cast<char>('A' + __builtin_ctz(other)));
    if (!(block_.letters & ~letter_bit('N'))) return true;
    LifeGroup told;
    if (block_.has('P')) {
        std::int64_t group = 0, kind = 1;
        if (!whole('P', group)) return false;
        if (block_.has('T')) return misplaced('T');
        if (group < 1 || group > kMostGroups) return out_of_range('P');
        told.group = static_cast<std::int32_t>(group);
        if (life_.mode == LifeInput::Forget) {
            if (block_.has('L') || block_.has('Q')) return misplaced(block_.has('L') ? 'L' : 'Q');
            told.step = LifeGroupStep::Forget;
            tell_life_group(told);
            return true;
        }
        if (block_.has('Q') && !whole('Q', kind)) return false;
        const double life = block_.has('L') ? block_.value('L') : 0.0;
        if (kind < 1 || kind > 2) return out_of_range('Q');
        if (!(life > 0) || life > kLongestLife) return out_of_range('L');
        told.kind = kind == 2 ? LifeKind::Minutes : LifeKind::Uses;
        told.life = life;
        life_.group = told.group;
        tell_life_group(told);
        return true;
    }
    if (block_.has('L') || block_.has('Q')) return misplaced(block_.has('L') ? 'L' : 'Q');
    if (life_.mode == LifeInput::Forget || life_.group == 0) return misplaced('T');  // of no group
    std::int64_t tool = 0, modulus = 1;
    if (!whole('T', tool)) return false;
    for (unsigned n = 0; n < settings_.tool.offset_digits; ++n) modulus *= 10;
    told.step = LifeGroupStep::Tool;
    told.group = life_.group;
    told.station = static_cast<std::int32_t>(tool / modulus);
    told.offset = static_cast<std::int32_t>(tool % modulus);
    const int limit = core_.view().config().offset_count;
    if (told.offset > limit)
        return core_.fail(Alarm::OffsetNumberIllegal, 'T', {}, told.offset, limit);
    if (told.station < 1) return out_of_range('T');
    tell_life_group(told);
    return true;
}

}  // namespace polyturn::channels::fanuc
