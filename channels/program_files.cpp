#include "channels/program_files.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "ipc/model/files/replace_file.hpp"

namespace polyturn::channels {
namespace {

namespace fs = std::filesystem;

std::string upper(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return out;
}

// The number that a file name such as O0200.nc, 200.txt or %200 stands for.
std::optional<std::int64_t> number_of_name(const std::string& path) {
    std::string stem = upper(fs::path(path).stem().string());
    std::size_t from = 0;
    if (!stem.empty() && (stem[0] == 'O' || stem[0] == 'P' || stem[0] == '%')) from = 1;
    if (from == stem.size() || stem.size() - from > 9) return std::nullopt;
    std::int64_t number = 0;
    for (std::size_t i = from; i < stem.size(); ++i) {
        if (!std::isdigit(static_cast<unsigned char>(stem[i]))) return std::nullopt;
        number = number * 10 + (stem[i] - '0');
    }
    return number;
}

// The number in the first O word (or :) of a text.
std::optional<std::int64_t> number_of_text(const std::string& path) {
    LineSource source;
    if (!source.open(path).ok()) return std::nullopt;
    std::string_view line;
    for (int i = 0; i < 20 && source.next(line) == LineSource::Status::Line; ++i) {
        std::size_t at = line.find_first_not_of(" \t%");
        if (at == std::string_view::npos) continue;
        const char first = line[at];
        if (first != 'O' && first != 'o' && first != ':') continue;
        std::int64_t number = 0;
        std::size_t digits = 0;
        for (++at;
             at < line.size() && std::isdigit(static_cast<unsigned char>(line[at])) && digits < 9;
             ++at, ++digits)
            number = number * 10 + (line[at] - '0');
        if (digits) return number;
    }
    return std::nullopt;
}

}  // namespace

Result<FileId> ProgramFiles::open(const std::string& path) {
    for (std::size_t i = 0; i < files_.size(); ++i)
        if (files_[i]->path == path && files_[i]->source.is_open()) return static_cast<FileId>(i);
    auto file = std::make_unique<File>();
    file->path = path;
    if (auto opened = file->source.open(path); !opened) return opened.diagnosis();
    files_.push_back(std::move(file));
    return static_cast<FileId>(files_.size() - 1);
}

Result<FileId> ProgramFiles::open_text(std::string_view text, std::string_view name) {
    auto file = std::make_unique<File>();
    file->path = name;
    if (auto opened = file->source.open_text(text, name); !opened) return opened.diagnosis();
    files_.push_back(std::move(file));
    return static_cast<FileId>(files_.size() - 1);
}

std::optional<FileId> ProgramFiles::open_if(const std::string& path) {
    auto opened = open(path);
    if (!opened) return std::nullopt;
    return *opened;
}

std::optional<FileId> ProgramFiles::find_number(std::int64_t number) {
    if (const auto known = by_number_.find(number); known != by_number_.end()) return known->second;
    const auto found = search_number(number);
    // it stays open; what is missing may still come
    if (found) by_number_.emplace(number, *found);
    return found;
}

std::optional<FileId> ProgramFiles::search_number(std::int64_t number) {
    for (const std::string& path : library_)
        if (number_of_name(path) == number) return open_if(path);
    for (const std::string& path : library_)
        if (number_of_text(path) == number) return open_if(path);
    for (const std::string& folder : folders_)
        if (const auto found = search_folder(folder, number)) return found;
    return std::nullopt;
}

std::optional<FileId> ProgramFiles::search_folder(const std::string& folder, std::int64_t number) {
    std::error_code error;
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error)) {
        const std::string path = entry.path().string();
        const std::string name = upper(entry.path().filename().string());
        if (!name.empty() && name[0] == 'O' && number_of_name(path) == number &&
            entry.is_regular_file(error))
            found.push_back(path);
    }
    std::sort(found.begin(), found.end());  // the same file on every computer
    return found.empty() ? std::nullopt : open_if(found.front());
}

std::optional<FileId> ProgramFiles::find_number_in(const std::string& folder, std::int64_t number) {
    return search_folder(folder, number);
}

void ProgramFiles::add_folders(std::string_view list, const std::string& from) {
    while (!list.empty()) {
        const std::size_t colon = list.find(':');
        const std::string_view one = list.substr(0, colon);
        // an absolute path is taken as it is
        if (!one.empty()) folders_.push_back((fs::path(from) / one).string());
        list = colon == std::string_view::npos ? std::string_view{} : list.substr(colon + 1);
    }
}

bool ProgramFiles::keep(const std::string& name, std::string_view text) {
    return static_cast<bool>(text::replace_file((fs::path(kept_) / name).string(), text));
}

const std::vector<std::string>& ProgramFiles::memory(std::string_view extension) {
    if (memory_of_ == extension) return memory_;
    memory_of_ = extension;
    memory_ = library_;
    for (const std::string& folder : folders_) {
        std::error_code error;
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error))
            if (entry.is_regular_file(error) &&
                upper(entry.path().extension().string()) == extension)
                found.push_back(entry.path().string());
        std::sort(found.begin(), found.end());
        memory_.insert(memory_.end(), found.begin(), found.end());
    }
    return memory_;
}

std::optional<FileId> ProgramFiles::find_number(std::int64_t number, std::string_view extension) {
    for (const std::string& path : memory(extension))
        if (number_of_name(path) == number) return open_if(path);
    return std::nullopt;
}

std::size_t ProgramFiles::memory_count(std::string_view extension) {
    return memory(extension).size();
}

std::optional<FileId> ProgramFiles::memory_file(std::string_view extension, std::size_t index) {
    return open_if(memory(extension)[index]);
}

std::optional<FileId> ProgramFiles::find_name(std::string_view name) {
    const std::string want = upper(name);
    const auto fits = [&](const fs::path& path) {
        return upper(path.filename().string()) == want || upper(path.stem().string()) == want;
    };
    for (const std::string& path : library_)
        if (fits(path)) return open_if(path);
    for (const std::string& folder : folders_) {
        std::error_code error;
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error))
            if (entry.is_regular_file(error) && fits(entry.path()))
                found.push_back(entry.path().string());
        std::sort(found.begin(), found.end());
        if (!found.empty()) return open_if(found.front());
    }
    return std::nullopt;
}

}  // namespace polyturn::channels
