#include "ipc/model/files/machine_path.hpp"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>

namespace polyturn::text {
namespace fs = std::filesystem;

namespace {
bool is_file(const fs::path& path) {
    std::error_code none;
    return fs::is_regular_file(path, none) || fs::is_character_file(path, none) ||
           fs::is_fifo(path, none);
}
bool is_program(const fs::path& path) { return is_file(path) && access(path.c_str(), X_OK) == 0; }
bool is_folder(const fs::path& path) {
    std::error_code none;
    return fs::is_directory(path, none);
}

Result<MachinePath> from_folder(const fs::path& folder) {
    const fs::path params = folder / "machine.params", room = folder / "machine.toml";
    if (!is_file(params))
        return Diagnosis{Alarm::FileUnreadable,
                         Place{params.string(), 0, 0, 0},
                         {},
                         "a machine's folder holds its parameters in machine.params"};
    const fs::path plc = fs::absolute(folder / "plc.so"), drives = fs::absolute(folder / "drives");
    return MachinePath{params.string(), folder.string(),
                       is_file(room) ? room.string() : std::string(),
                       is_file(plc) ? plc.string() : std::string(),
                       is_program(drives) ? drives.string() : std::string()};
}
}  // namespace

std::string program_folder() {
    std::array<char, 4096> buffer{};
    const auto size = readlink("/proc/self/exe", buffer.data(), buffer.size() - 1);
    return size > 0 ? fs::path(std::string(buffer.data(), static_cast<std::size_t>(size)))
                          .parent_path()
                          .string()
                    : std::string(".");
}

std::string share_folder() {
    if (const char* chosen = std::getenv("POLYTURN_SHARE"); chosen && *chosen) return chosen;
    const fs::path program = program_folder();
    // The build tree lies somewhere below the sources, build/bin or build/<name>/bin; elsewhere it
    // has a link to them where an installation has the files themselves.
    for (fs::path folder = program; folder.has_relative_path(); folder = folder.parent_path())
        if (is_folder(folder / "examples" / "machines")) return folder.string();
    const fs::path installed = program / ".." / "share" / "polyturn";
    if (is_folder(installed / "machines") || is_folder(installed / "examples" / "machines"))
        return installed.lexically_normal().string();
    return {};
}

Result<MachinePath> resolve_machine(std::string_view option) {
    if (!option.empty()) {
        const fs::path path{option};
        if (is_folder(path)) return from_folder(path);
        if (is_file(path)) return MachinePath{path.string(), {}, {}, {}, {}};
        if (option.find('/') != std::string_view::npos)
            return Diagnosis{Alarm::FileUnreadable,
                             Place{std::string(option), 0, 0, 0},
                             {},
                             "there is no such machine file or folder"};
    }
    const fs::path name{option.empty() ? std::string_view("twin-turret") : option};
    const fs::path share = share_folder();
    if (!share.empty())
        for (const fs::path& folder :
             {share / "examples" / "machines" / name, share / "machines" / name})
            if (is_folder(folder)) return from_folder(folder);
    return Diagnosis{Alarm::FileUnreadable,
                     Place{name.string(), 0, 0, 0},
                     {},
                     "no such machine here, and none among the examples of this installation"};
}

}  // namespace polyturn::text
