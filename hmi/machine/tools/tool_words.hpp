// A tool as screens show it: its state as word, sign and tone, how much of its life is left.
#pragma once
#include "hmi/machine/live/channel_words.hpp"
#include "hmi/text/display_languages.hpp"

namespace polyturn::hmi {

// The worst that holds: a broken tool that is also worn is broken.
StateWords toolWords(const ToolRow& tool);
QString toolName(const ToolRow& tool, std::int32_t number);  // its name, or «tool 7»
// 0 (used up) to 1; below 0: its life is not watched.
double lifeLeft(const ToolRow& tool);
QString lifeText(const ToolRow& tool);  // «37.5 / 60 min»; empty: not watched
Tone lifeTone(const ToolRow& tool);
QString lifeUnit(unsigned kind);
QString placeText(const Live& live, std::int32_t magazine, std::int32_t pot);  // «M1 / 3», «S2»
QString kindText(std::int32_t kind);  // «roughing» of 500
inline const ToolRow* toolOf(const Live& live, std::int32_t number) {
    return number >= 1 && number <= static_cast<std::int32_t>(kTools) &&
                   live.tools().rows[static_cast<std::size_t>(number - 1)].used
               ? &live.tools().rows[static_cast<std::size_t>(number - 1)]
               : nullptr;
}
const ToolPlace* placeOf(const Live& live, std::int32_t magazine, std::int32_t pot);
QString numberText(double value, int decimals = 3);  // as short as it can be

}  // namespace polyturn::hmi
