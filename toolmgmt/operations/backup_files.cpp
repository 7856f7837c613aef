#include "toolmgmt/operations/backup_files.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>

#include "ipc/image/segments.hpp"
#include "ipc/memory/segment.hpp"
#include "ipc/text/replace_file.hpp"
#include "toolmgmt/schema.hpp"

namespace polyturn::toolmgmt {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t kLargest = 256u << 20;
constexpr std::size_t kNameBytes = 256;

bool read_bytes(const fs::path& path, std::string& out) {
    std::error_code none;
    if (!fs::is_regular_file(path, none) || fs::file_size(path, none) > kLargest) return false;
    std::ifstream in(path, std::ios::binary);
    if (!in) return false;
    out.assign(std::istreambuf_iterator<char>(in), {});
    return !in.bad();
}

void add_tree(const fs::path& root, const std::string& prefix, std::vector<Database::File>& files) {
    std::error_code none;
    for (fs::recursive_directory_iterator at(root, fs::directory_options::skip_permission_denied, none), end; !none && at != end; at.increment(none)) {
        if (at->path().filename().string().front() == '.') {
            if (at->is_directory(none)) at.disable_recursion_pending();
            continue;
        }
        Database::File file{prefix + fs::relative(at->path(), root, none).string(), at->path().string(), {}};
        if (read_bytes(at->path(), file.bytes)) files.push_back(std::move(file));
    }
}

// Programs that the channels have open just now.
void add_open_programs(const std::string& instance, std::vector<Database::File>& files) {
    std::set<std::string> seen;
    auto names = std::make_unique<ProgramNames>();
    for (std::size_t channel = 1; channel <= kMaxChannels; ++channel) {
        const auto segment = PeerSegment<ChannelSegment>::attach(instance, channel);
        if (!segment || !(*segment)->programs.read(*names)) continue;
        for (std::size_t i = 0; i < std::min<std::size_t>(names->count, names->name.size() / kNameBytes); ++i) {
            const char* text = names->name.data() + i * kNameBytes;
            const std::string path(text, ::strnlen(text, kNameBytes));
            if (!path.empty() && seen.insert(path).second) add_programs(path, files);
        }
    }
}

}  // namespace

std::vector<Database::File> collect_files(const std::string& machine_folder, const std::string& instance) {
    std::vector<Database::File> files;
    if (!machine_folder.empty()) add_tree(machine_folder, "machine/", files);
    if (!instance.empty()) add_open_programs(instance, files);
    return files;
}

bool add_programs(const std::string& path, std::vector<Database::File>& files) {
    std::error_code none;
    const fs::path whole = fs::absolute(path, none);
    if (fs::is_directory(whole, none)) return add_tree(whole, "program/", files), true;
    Database::File file{"program/" + whole.filename().string(), whole.string(), {}};
    if (!read_bytes(whole, file.bytes)) return false;
    files.push_back(std::move(file));
    return true;
}

std::string target_of(const Database::File& file, const std::string& machine_folder) {
    constexpr std::string_view kMachine = "machine/";
    if (file.name.rfind(kMachine, 0) == 0 && !machine_folder.empty()) {
        const fs::path relative = fs::path(file.name.substr(kMachine.size())).lexically_normal();
        if (!relative.is_absolute() && *relative.begin() != "..") return (fs::path(machine_folder) / relative).string();
    }
    return file.path;
}

bool differs_from_disk(const Database::File& file, const std::string& target) {
    std::string now;
    return !read_bytes(target, now) || now != file.bytes;
}

Result<void> put_file(const std::string& target, const std::string& bytes) {
    std::error_code wrong;
    fs::create_directories(fs::path(target).parent_path(), wrong);
    return text::replace_file(target, bytes);
}

Result<std::string> make_automatic_backup(Database& disk, const std::string& store_folder, const std::vector<Database::File>& files, std::size_t keep) {
    const fs::path folder = fs::path(store_folder) / "backups";
    std::error_code none;
    fs::create_directories(folder, none);
    const std::string file = (folder / ("auto-" + utc_now() + ".ptb")).string();
    if (const Result<void> made = disk.backup(file, files); !made) return made.diagnosis();
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(folder, none))
        if (entry.path().filename().string().rfind("auto-", 0) == 0 && entry.path().extension() == ".ptb") old.push_back(entry.path());
    std::sort(old.begin(), old.end());
    for (std::size_t i = 0; i + keep < old.size(); ++i) fs::remove(old[i], none);
    return file;
}

Result<std::string> newest_good_backup(const std::string& store_folder) {
    std::vector<fs::path> all;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(fs::path(store_folder) / "backups", none))
        if (entry.path().extension() == ".ptb") all.push_back(entry.path());
    // By the time of writing: hand-made ones have names of their own.
    std::sort(all.begin(), all.end(), [&](const fs::path& a, const fs::path& b) { return fs::last_write_time(a, none) > fs::last_write_time(b, none); });
    for (const fs::path& one : all) {
        auto values = std::make_unique<StoreValues>();
        clear(*values);
        std::vector<Database::File> files;
        std::vector<Diagnosis> warnings;
        if (Database::read_backup(one.string(), *values, files, warnings)) return one.string();
    }
    return Diagnosis{Alarm::BackupBad, {}, {}, "no usable backup in " + store_folder + "/backups"};
}

}  // namespace polyturn::toolmgmt
