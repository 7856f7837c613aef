// A file that is replaced whole or not at all, whatever is killed or switched off meanwhile: the
// new one is complete on the disk before it takes the old one's name, and the name is on the disk
// before this returns.
//
//   path.new   written, fsync        path.new -> path   rename        folder   fsync
#pragma once
#include <string>
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::text {

// Keeps the access rights of the old file. On an error (OutputFile, with the system's words) the
// old file is as it was. May take as long as the disk does: not for a thread that must not wait.
Result<void> replace_file(const std::string& path, std::string_view bytes);

}  // namespace polyturn::text
