#include "kernel/supervisor/check/program_stops.hpp"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>

namespace polyturn::supervisor {

namespace fs = std::filesystem;

namespace {
constexpr std::uintmax_t kLargest = 256u << 20;  // looked through in under a second
constexpr std::size_t kMostNeighbours = 200;

using Finds = bool (*)(std::string_view);

bool file_holds(const fs::path& path, Finds finds) {
    std::ifstream file(path, std::ios::binary);
    std::string block(1 << 20, '\0'), kept;
    while (file.read(block.data(), static_cast<std::streamsize>(block.size())) ||
           file.gcount() > 0) {
        kept.append(block.data(), static_cast<std::size_t>(file.gcount()));
        if (finds(kept)) return true;
        // a word across the border of two blocks
        kept.erase(0, kept.size() > 16 ? kept.size() - 16 : 0);
    }
    return false;
}

bool any_holds(const std::vector<std::string>& files, Finds finds) {
    std::set<fs::path> paths, folders;
    for (const auto& file : files) {
        const fs::path path = fs::path(file).lexically_normal();
        paths.insert(path);
        folders.insert(path.has_parent_path() ? path.parent_path() : fs::path("."));
    }
    std::error_code none;
    for (const auto& folder : folders) {
        std::size_t count = 0;
        for (const auto& entry : fs::directory_iterator(folder, none)) {
            if (!entry.is_regular_file(none)) continue;
            const std::string extension = entry.path().extension().string();
            if (extension == ".toml" || extension == ".csv" || extension == ".svg" ||
                extension == ".json" || extension == ".md" || extension == ".params")
                continue;
            if (++count > kMostNeighbours) return true;
            paths.insert(entry.path().lexically_normal());
        }
    }
    for (const auto& path : paths) {
        const auto size = fs::file_size(path, none);
        if (none) continue;  // not there: its channel says so
        if (size > kLargest || file_holds(path, finds)) return true;
    }
    return false;
}
}  // namespace

bool text_holds_program_stop(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != 'M' && text[i] != 'm') continue;
        std::size_t k = i + 1;
        while (k < text.size() && (text[k] == ' ' || text[k] == '=')) ++k;
        // computed: anything is possible
        if (k < text.size() && (text[k] == '#' || text[k] == '[')) return true;
        const std::size_t digits = k;
        while (k < text.size() && text[k] == '0') ++k;
        const bool zero = k > digits, one = k < text.size() && text[k] == '1';
        if (one) ++k;
        const bool ends = k >= text.size() ||
                          (!std::isdigit(static_cast<unsigned char>(text[k])) && text[k] != '.');
        if ((zero || one) && ends) return true;
    }
    return false;
}

// A name with a bracket behind it; what is in a comment or a text only costs the time of some
// processes.
bool text_starts_programs(std::string_view text) {
    constexpr std::string_view kStart = "START";
    for (std::size_t i = 0; i + kStart.size() < text.size(); ++i) {
        std::size_t k = 0;
        while (k < kStart.size() &&
               std::toupper(static_cast<unsigned char>(text[i + k])) == kStart[k])
            ++k;
        if (k < kStart.size()) continue;
        for (k += i; k < text.size() && (text[k] == ' ' || text[k] == '\t'); ++k) {}
        if (k < text.size() && text[k] == '(') return true;
    }
    return false;
}

bool may_hold_program_stop(const std::vector<std::string>& files) {
    return any_holds(files, text_holds_program_stop);
}
bool may_start_programs(const std::vector<std::string>& files) {
    return any_holds(files, text_starts_programs);
}

}  // namespace polyturn::supervisor
