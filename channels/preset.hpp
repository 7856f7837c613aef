// What the setup enters into a language before its program runs: variables and tools. The same in
// check and run mode.
#pragma once
#include "channels/language.hpp"
#include "ipc/model/files/setup.hpp"

namespace polyturn::channels {

void preset(Language& language, const text::ChannelSetup& setup);

}  // namespace polyturn::channels
