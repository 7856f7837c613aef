#include "toolmgmt/operations/backup_files.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>

#include "ipc/image/segments.hpp"
#include "ipc/model/compensation/compensation_tables.hpp"
#include "ipc/memory/segment.hpp"
#include "ipc/params/param_file.hpp"
#include "ipc/model/files/replace_file.hpp"
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
    for (fs::recursive_directory_iterator
             at(root, fs::directory_options::skip_permission_denied, none),
         end;
         !none && at != end; at.increment(none)) {
        if (at->path().filename().string().front() == '.') {
            if (at->is_directory(none)) at.disable_recursion_pending();
            continue;
        }
        Database::File file{
            prefix + fs::relative(at->path(), root, none).string(), at->path().string(), {}};
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
        for (std::size_t i = 0;
             i < std::min<std::size_t>(names->count, names->name.size() / kNameBytes); ++i) {
            const char* text = names->name.data() + i * kNameBytes;
            const std::string path(text, ::strnlen(text, kNameBytes));
            if (!path.empty() && seen.insert(path).second) add_programs(path, files);
        }
    }
}

}  // namespace

std::vector<Database::File> collect_files(const std::string& machine_folder,
                                          const std::string& instance) {
    std::vector<Database::File> files;
    if (!machine_folder.empty()) add_tree(machine_folder, "machine/", files);
    if (!instance.empty()) add_open_programs(instance, files);
    return files;
}

bool add_programs(const std::string& path, std::vector<Database::File>& files) {
    std::error_code none;
    const fs::path whole = fs::absolute(path, none);
    if (fs::is_directory(whole, none)) {
        add_tree(whole, "program/", files);
        return true;
    }
    Database::File file{"program/" + whole.filename().string(), whole.string(), {}};
    if (!read_bytes(whole, file.bytes)) return false;
    files.push_back(std::move(file));
    return true;
}

namespace {

// A relative path of plain names, none of them hidden: what collect_files() writes.
bool plain(std::string_view path) {
    if (path.empty() || path.size() > 1000) return false;
    for (std::size_t at = 0; at <= path.size();) {
        const std::size_t end = std::min(path.find('/', at), path.size());
        const std::string_view part = path.substr(at, end - at);
        if (part.empty() || part.front() == '.' || part.size() > 200 ||
            part.find('\\') != std::string_view::npos)
            return false;
        for (const char c : part)
            if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return false;
        at = end + 1;
    }
    return true;
}

bool ends_with(std::string_view text, std::string_view end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

bool is_native(std::string_view name, std::string_view bytes) {
    return bytes.substr(0, 4) ==
               "\x7f"
               "ELF" ||
           bytes.substr(0, 2) == "MZ" || bytes.substr(0, 2) == "#!" || ends_with(name, ".so") ||
           name.find(".so.") != std::string_view::npos;
}

// The reader of TOML goes one level down for each part of a dotted key and each bracket.
bool too_deep(std::string_view text) {
    constexpr int kDeepest = 64;
    int dots = 0, open = 0;
    for (const char c : text) {
        if (c == '\n') dots = 0;
        dots += c == '.' ? 1 : 0;
        open += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
        if (dots > 4000 || open > kDeepest) return true;
    }
    return false;
}

// Empty, or what its reader says.
std::string refusal_of(std::string_view name, const std::string& bytes) {
    if (ends_with(name, ".params")) {
        for (const Diagnosis& one : params::parse_param_file(bytes, name).diagnoses)
            if (one.severity() == Severity::Error) return one.text();
    } else if (ends_with(name, ".toml")) {
        if (too_deep(bytes)) return "nested too deeply";
        try {
            (void)toml::parse(bytes, name);
        } catch (const toml::parse_error& wrong) { return std::string(wrong.description()); }
    } else if (ends_with(name, ".compensation")) {
        std::vector<Diagnosis> all;
        (void)parse_compensation(bytes, name, all);
        for (const Diagnosis& one : all)
            if (one.severity() == Severity::Error) return one.text();
    }
    return {};
}

}  // namespace

Result<RestoredFile> judge_file(const Database::File& file, const RestoreTo& to) {
    const auto foreign = [&](const std::string& why) {
        return Diagnosis{Alarm::BackupForeign,
                         {},
                         {},
                         file.name.substr(0, 200) + (why.empty() ? "" : " (" + why + ")")};
    };
    constexpr std::string_view kMachine = "machine/", kProgram = "program/";
    const bool machine = file.name.rfind(kMachine, 0) == 0;
    if (!machine && file.name.rfind(kProgram, 0) != 0) return foreign("");
    const std::string relative = file.name.substr(machine ? kMachine.size() : kProgram.size());
    if (!plain(relative)) return foreign("no name of a backup");
    if (file.bytes.size() > kLargest) return foreign("too large");
    if (const std::string why = refusal_of(relative, file.bytes); !why.empty()) return foreign(why);
    RestoredFile out;
    std::error_code none;
    out.base = to.machine_folder.empty() ? (fs::path(to.store_folder) / "restored").string()
                                         : fs::weakly_canonical(to.machine_folder, none).string();
    if (to.machine_folder.empty())
        out.target = out.base + "/" + file.name;
    else
        out.target = out.base + (machine ? "/" : "/programs/") + relative;
    out.native = is_native(relative, file.bytes);
    return out;
}

bool differs_from_disk(const Database::File& file, const std::string& target) {
    std::string now;
    return !read_bytes(target, now) || now != file.bytes;
}

Result<void> put_file(const RestoredFile& file, const std::string& bytes) {
    const auto link = [&](const fs::path& path) {
        return Diagnosis{
            Alarm::BackupForeign, {}, {}, file.target + " (" + path.string() + " is a link)"};
    };
    std::error_code wrong;
    fs::create_directories(file.base, wrong);
    fs::path at = file.base;
    const fs::path way = fs::path(file.target).lexically_relative(file.base);
    for (auto part = way.begin(); part != way.end(); ++part) {
        at /= *part;
        const fs::file_status status = fs::symlink_status(at, wrong);
        if (fs::is_symlink(status)) return link(at);
        const bool last = std::next(part) == way.end();
        if (!last && !fs::exists(status) && !fs::create_directory(at, wrong))
            return Diagnosis{Alarm::OutputFile, {}, {}, at.string() + " (" + wrong.message() + ")"};
        if (last && fs::exists(status) && !fs::is_regular_file(status))
            return Diagnosis{Alarm::FileKind, {}, {}, at.string()};
    }
    if (fs::is_symlink(fs::symlink_status(file.target + ".new", wrong)))
        return link(file.target + ".new");
    return text::replace_file(file.target, bytes);
}

Result<std::string> make_automatic_backup(Database& disk, const std::string& store_folder,
                                          const std::vector<Database::File>& files,
                                          std::size_t keep) {
    const fs::path folder = fs::path(store_folder) / "backups";
    std::error_code none;
    fs::create_directories(folder, none);
    const std::string file = (folder / ("auto-" + utc_now() + ".ptb")).string();
    if (const Result<void> made = disk.backup(file, files); !made) return made.diagnosis();
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(folder, none))
        if (entry.path().filename().string().rfind("auto-", 0) == 0 &&
            entry.path().extension() == ".ptb")
            old.push_back(entry.path());
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
    std::sort(all.begin(), all.end(), [&](const fs::path& a, const fs::path& b) {
        return fs::last_write_time(a, none) > fs::last_write_time(b, none);
    });
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
