#include "kernel/supervisor/base/reach.hpp"

#include <algorithm>

#include "ipc/params/handle.hpp"
#include "ipc/model/files/machine_path.hpp"
#include "ipc/model/files/read_file.hpp"

namespace polyturn::supervisor {
namespace fs = std::filesystem;
namespace {

// the builder's list; hmi/machine/programs/file_work.cpp shows it
constexpr const char* kPlaces = "/etc/polyturn/places";

// Whether `file` lies in `root`; both without links and dots.
bool lies_in(const fs::path& file, const fs::path& root) {
    if (root == root.root_path()) return false;
    const auto [root_end, file_at] =
        std::mismatch(root.begin(), root.end(), file.begin(), file.end());
    return root_end == root.end() && file_at != file.end();
}

bool in_one_of(const fs::path& file, const std::vector<fs::path>& roots) {
    return std::any_of(roots.begin(), roots.end(), [&](const fs::path& root) {
        std::error_code missing;
        const fs::path real = fs::canonical(root, missing);
        return !missing && lies_in(file, real);
    });
}

}  // namespace

Result<void> Reach::may_read(const std::string& file, UserLevel level) const {
    if (level >= UserLevel::Maker) return {};
    std::error_code wrong;
    const fs::path real = fs::weakly_canonical(file, wrong);
    if (!wrong &&
        (in_one_of(real, programs_) || (level >= UserLevel::Setter && in_one_of(real, machine_))))
        return {};
    return Diagnosis{Alarm::FileOutside, Place{file, 0, 0, 0}, {}, file};
}

std::vector<fs::path> places_in(std::string_view text) {
    std::vector<fs::path> out;
    while (!text.empty()) {
        const auto end = text.find('\n');
        std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        line = line.substr(0, line.find(';'));
        const auto equals = line.find('=');
        if (equals == 0 || equals == std::string_view::npos) continue;
        line.remove_prefix(equals + 1);
        const auto first = line.find_first_not_of(" \t"), last = line.find_last_not_of(" \t\r");
        if (first != std::string_view::npos && line[first] == '/')
            out.emplace_back(line.substr(first, last - first + 1));
    }
    return out;
}

Reach reach_of(const params::Table& table, const std::string& machine_folder) {
    std::error_code none;
    std::vector<fs::path> programs{fs::current_path(none), "/media", "/run/media"};
    if (const std::string share = text::share_folder(); !share.empty())
        programs.emplace_back(share);
    if (const auto list = text::read_text_file(kPlaces))
        for (fs::path& place : places_in(*list)) programs.push_back(std::move(place));
    for (std::size_t channel = 1; channel <= kMaxChannels; ++channel) {
        std::string_view list = params::get_text(table, params::pt_program_folders, channel);
        while (!list.empty()) {
            const auto colon = list.find(':');
            if (const fs::path one(list.substr(0, colon)); one.is_absolute())
                programs.push_back(one);
            list = colon == std::string_view::npos ? std::string_view{} : list.substr(colon + 1);
        }
    }
    std::vector<fs::path> machine;
    if (!machine_folder.empty()) machine.emplace_back(machine_folder);
    return {std::move(programs), std::move(machine)};
}

}  // namespace polyturn::supervisor
