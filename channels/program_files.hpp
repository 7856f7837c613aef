// The program files that a channel can reach, under their names and numbers. A file is opened when
// it is first needed and stays open; its number goes into records and events.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "channels/text/line_source.hpp"

namespace polyturn::channels {

using FileId = std::uint16_t;

class ProgramFiles {
public:
    // Files that calls may name, as setup and store give them.
    void add_library(const std::string& path) { library_.push_back(path); }
    void add_folder(const std::string& folder) { folders_.push_back(folder); }

    // More folders, with : between; relative ones begin at `from`.
    void add_folders(std::string_view list, const std::string& from);

    // Programs that programs write are kept in this folder; without one they live as long as the
    // run.
    void keep_in(const std::string& folder) { kept_ = folder; }
    bool keeps() const { return !kept_.empty(); }
    // The whole text or nothing is there afterwards. False: it could not be written.
    bool keep(const std::string& name, std::string_view text);

    Result<FileId> open(const std::string& path);
    // the text must outlive this
    Result<FileId> open_text(std::string_view text, std::string_view name);
    // The file of program `number`: a library file or a file of the folders whose name or first O
    // word says so.
    std::optional<FileId> find_number(std::int64_t number);
    // Likewise, and files of the folders whose name is the number with this extension (fagor:
    // 000611.PIT).
    std::optional<FileId> find_number(std::int64_t number, std::string_view extension);
    std::size_t library_count() const { return library_.size(); }
    // All library files, then all files of the folders with this extension, in the order of their
    // names.
    std::size_t memory_count(std::string_view extension);
    std::optional<FileId> memory_file(std::string_view extension, std::size_t index);
    // Likewise, in this folder only.
    std::optional<FileId> find_number_in(const std::string& folder, std::int64_t number);
    // A file by name ("PROFILE" or "PROFILE.SPF"), whatever its case.
    std::optional<FileId> find_name(std::string_view name);

    LineSource& source(FileId id) { return files_[id]->source; }
    const std::string& path(FileId id) const { return files_[id]->path; }
    std::size_t count() const { return files_.size(); }

private:
    struct File {
        std::string path;
        LineSource source;
    };
    std::optional<FileId> open_if(const std::string& path);
    std::optional<FileId> search_number(std::int64_t number);
    std::optional<FileId> search_folder(const std::string& folder, std::int64_t number);
    const std::vector<std::string>& memory(std::string_view extension);

    std::vector<std::unique_ptr<File>> files_;
    std::vector<std::string> library_, folders_;
    std::string kept_;
    std::map<std::int64_t, FileId> by_number_;  // what find_number() has found
    std::vector<std::string> memory_;  // what memory() has found, for the extension memory_of_
    std::string memory_of_;
};

}  // namespace polyturn::channels
