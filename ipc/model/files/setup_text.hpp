// A setup as TOML, to hand on to another process what was put together from several files.
#pragma once
#include <string>

#include "ipc/model/files/setup.hpp"

namespace polyturn::text {

// Reads back to the same setup wherever it is stored: paths are made absolute.
std::string setup_text(const Setup& setup);

}  // namespace polyturn::text
