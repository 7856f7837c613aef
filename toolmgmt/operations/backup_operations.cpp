// backup.to and restore.from on a running store.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "ipc/model/machine/load_machine.hpp"
#include "ipc/model/machine/shortest_text.hpp"
#include "toolmgmt/operations/backup_files.hpp"
#include "toolmgmt/operations/operation.hpp"
#include "toolmgmt/operations/restore_diff.hpp"
#include "toolmgmt/tools/tool_requests.hpp"

namespace polyturn::toolmgmt {
namespace {

constexpr std::size_t kMostShown = 5000;

std::string shown(double number, const std::string& text, bool is_text) {
    return is_text ? text : std::isnan(number) ? std::string("-") : shortest_text(number);
}

Json back_up(const Json& request, Work& work) {
    if (!work.disk) {
        work.fault(Alarm::StoreRequestBad,
                   "this controller keeps nothing, so there is nothing to back up");
        return Json();
    }
    const std::string file = read_text(request, "file");
    if (file.empty() || file.front() != '/') {
        work.fault(Alarm::StoreRequestBad, "file: a whole path is needed");
        return Json();
    }
    std::vector<Database::File> files = collect_files(work.machine_folder, work.instance);
    if (const auto with = request.find("with"); with != request.end() && with->is_array())
        for (const auto& one : *with)
            if (!one.is_string() || !add_programs(one.get<std::string>(), files))
                work.fault(Alarm::FileUnreadable,
                           one.is_string() ? one.get<std::string>() : "with");
    if (!work.good()) return {};
    // Only on demand: a stick that is not there must not become a folder of the computer. What
    // cannot be made shows in the file.
    std::error_code none;
    if (read_flag(request, "make_folder", work))
        std::filesystem::create_directories(std::filesystem::path(file).parent_path(), none);
    if (const Result<void> done = work.disk->backup(file, files); !done) {
        work.fault(done.diagnosis());
        return Json();
    }
    Json names = Json::array();
    for (const auto& one : files) names.push_back(one.name);
    return {{"file", file},
            {"bytes", std::filesystem::file_size(file, none)},
            {"files", std::move(names)}};
}

Json restore(const Json& request, Work& work) {
    std::string file = read_text(request, "file");
    const bool preview = read_flag(request, "preview", work);
    if (file.empty() && work.disk) {
        const auto newest =
            newest_good_backup(std::filesystem::path(work.disk->path()).parent_path().string());
        if (!newest) {
            work.fault(newest.diagnosis());
            return Json();
        }
        file = *newest;
    }
    auto wanted = std::make_unique<StoreValues>();
    clear(*wanted);
    // What the backup does not name has the machine's value.
    LoadedMachine base = load_machine_file(work.machine_folder);
    wanted->parameters =
        base.ok() && !work.machine_folder.empty() ? *base.table : work.values.parameters;
    std::vector<Database::File> files;
    std::vector<Diagnosis> warnings;
    if (const Result<void> read = Database::read_backup(file, *wanted, files, warnings); !read) {
        work.fault(read.diagnosis());
        return Json();
    }
    for (std::int32_t number = 0; number < kCounters; ++number)
        if (std::isnan(wanted->counters[static_cast<std::size_t>(number)]))
            wanted->counters[static_cast<std::size_t>(number)] =
                work.values.counters[static_cast<std::size_t>(number)];
    std::vector<Change> changes = changes_between(work.values, *wanted);
    Json sections = Json::object(), list = Json::array(), file_list = Json::array(),
         notes = Json::array();
    for (const Diagnosis& warning : warnings) notes.push_back(warning.text());
    const bool with_plc = read_flag(request, "with_plc", work);
    const RestoreTo to{work.machine_folder,
                       work.disk ? std::filesystem::path(work.disk->path()).parent_path().string()
                                 : std::string()};
    Json native = Json::array();
    for (auto& one : files) {
        const auto judged = judge_file(one, to);
        if (!judged) {
            work.fault(judged.diagnosis());
            continue;
        }
        if (!differs_from_disk(one, judged->target)) continue;
        if (judged->native) {
            native.push_back(judged->target);
            if (!with_plc && !preview) work.fault(Alarm::BackupNative, judged->target);
        }
        file_list.push_back(judged->target);
        work.after.push_back(
            [file = *judged, bytes = std::move(one.bytes)] { return put_file(file, bytes); });
    }
    if (!work.good()) return {};
    // A backup from before the first user: those who are there keep their rights, and nobody gets
    // more.
    const bool no_users =
        std::none_of(wanted->cells.begin(), wanted->cells.end(),
                     [](const auto& cell) { return cell.first.kind == Kind::User; });
    if (no_users)
        std::erase_if(changes, [](const Change& change) { return change.key.kind == Kind::User; });
    for (const Change& change : changes) {
        const char* section = section_of(change.key.kind);
        sections[section] = sections.value(section, 0) + 1;
        if (list.size() >= kMostShown || change.key.name == "hash") continue;
        list.push_back({{"what", describe(change.key)},
                        {"old", shown(change.before, change.text_before, change.is_text)},
                        {"new", shown(change.after, change.text_after, change.is_text)}});
    }
    work.confirms = true;
    for (const Change& change : changes)
        if (write_value(work.values, change.key, change.after, change.text_after, change.is_text))
            work.changes.push_back(change);
    if (work.disk)
        work.after.push_back([disk = work.disk, file] {
            const auto merged = disk->merge_history(file);
            return merged ? Result<void>() : Result<void>(merged.diagnosis());
        });
    return {{"file", file},
            {"sections", std::move(sections)},
            {"changes", std::move(list)},
            {"total", changes.size()},
            {"files", std::move(file_list)},
            {"native", std::move(native)},
            {"warnings", std::move(notes)}};
}

}  // namespace

// {"do":"store.state"}     is everything there that was acknowledged? What is missing, and the
//                          newest backup.
// {"do":"store.confirm"}   production goes on with what is left: the maker's.
Json store_operation(std::string_view what, const Json&, Work& work) {
    if (what != "state" && what != "confirm") {
        work.fault(Alarm::StoreRequestBad, "store." + std::string(what));
        return Json();
    }
    Json out = {{"kept", work.disk != nullptr}, {"unfit", false}};
    if (!work.disk) return out;
    const Database::Condition& now = work.disk->condition();
    if (what == "confirm") {
        work.confirms = true;
        return out;
    }
    if (!now.unfit) return out;
    const auto newest =
        newest_good_backup(std::filesystem::path(work.disk->path()).parent_path().string());
    out["unfit"] = true;
    out["number"] = std::string(alarm_number(now.unfit->alarm, Dialect::Polyturn));
    out["missing"] = now.unfit->detail;
    out["readable"] = !now.broken;
    out["backup"] = newest ? *newest : std::string();
    return out;
}

Json backup_operation(std::string_view what, const Json& request, Work& work) {
    if (what == "to") return back_up(request, work);
    if (what == "from") return restore(request, work);
    work.fault(Alarm::StoreRequestBad, std::string(what));
    return Json();
}

}  // namespace polyturn::toolmgmt
