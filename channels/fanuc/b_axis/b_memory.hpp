// The registered programs of the B axis as a text that survives power-off (fanuc_lathe 10.4.6).
//
//   b-axis programs 1
//   program 1 2                                one line for each of its 2 steps follows
//   motion=2 feed_mode=0 one_shot=0 drilling=0 set=3 b=40 r=0 q=0 p=0 feed=200 turn=0.02 code=0
//   letter=- ...
//   end                                        a text without it was cut off
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "channels/fanuc/b_axis/b_state.hpp"

namespace polyturn::channels::fanuc {

inline constexpr std::string_view kBProgramsKept = "b_programs";  // its name (Port::keep)

using BProgramTexts = std::array<std::vector<BStep>, 3>;

std::string b_text(const BProgramTexts& programs);
// Nothing: the text is no such thing, or not whole.
std::optional<BProgramTexts> b_programs(std::string_view text);

}  // namespace polyturn::channels::fanuc
