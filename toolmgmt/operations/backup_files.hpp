// The files that a backup carries besides the store: the machine's folder (parameters, PLC,
// compensation, machine model) and the programs that the channels have open. And the backups that
// the store makes by itself.
#pragma once

#include <string>
#include <vector>

#include "toolmgmt/database.hpp"

namespace polyturn::toolmgmt {

// "machine/<path in its folder>", "program/<name>".
std::vector<Database::File> collect_files(const std::string& machine_folder,
                                          const std::string& instance);
// Adds a file or every file of a folder as programs. False: it cannot be read.
bool add_programs(const std::string& path, std::vector<Database::File>& files);
// Where files of a backup may go: nowhere else, whatever the backup says.
struct RestoreTo {
    std::string machine_folder, store_folder;
};
struct RestoredFile {
    std::string target, base;  // base: the folder that it must not leave
    bool native = false;       // a program of the processor: the builder's PLC or drives
};
// «machine/<path>» into the machine's folder, «program/<name>» into its folder programs; without a
// machine's folder into <store>/restored. A fault (BackupForeign) for a name that no backup has, or
// content that its reader refuses.
Result<RestoredFile> judge_file(const Database::File& file, const RestoreTo& to);
bool differs_from_disk(const Database::File& file, const std::string& target);
// The whole file or the old one, on disk when it returns well. No link leads out of the base.
Result<void> put_file(const RestoredFile& file, const std::string& bytes);

// <store>/backups/auto-<UTC>.ptb; the newest `keep` stay. Returns its name.
Result<std::string> make_automatic_backup(Database& disk, const std::string& store_folder,
                                          const std::vector<Database::File>& files,
                                          std::size_t keep);
// The newest backup in the folder that can be used; a fault when there is none.
Result<std::string> newest_good_backup(const std::string& store_folder);

}  // namespace polyturn::toolmgmt
