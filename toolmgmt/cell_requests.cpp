#include "toolmgmt/cell_requests.hpp"

#include <cstring>
#include <filesystem>
#include <string>

#include "ipc/model/files/read_file.hpp"
#include "ipc/model/files/replace_file.hpp"

namespace polyturn::toolmgmt {

std::optional<CellEntry> cell_of(const StoreRequest& request) {
    if (static_cast<StoreRequestKind>(request.kind) != StoreRequestKind::Parameter)
        return std::nullopt;
    return cell_entry({request.name.data(), ::strnlen(request.name.data(), request.name.size())});
}

std::string compensation_file(const RunOptions& options) {
    const std::string base(options.machine_folder.data(),
                           ::strnlen(options.machine_folder.data(), options.machine_folder.size()));
    return base.empty() || options.virtual_time ? std::string() : base + ".compensation";
}

Result<std::string> read_compensation(const std::string& path) {
    std::error_code none;
    return std::filesystem::exists(path, none) ? text::read_text_file(path)
                                               : Result<std::string>(std::string());
}

Result<void> keep_cells(const RunOptions& options, const params::Table& parameters,
                        std::span<const CellEntry> cells) {
    if (cells.empty() || options.virtual_time) return {};
    const std::string path = compensation_file(options);
    if (path.empty())
        return Diagnosis{Alarm::CompensationTable, {}, {}, "the machine has no folder for it"};
    const Result<std::string> content = read_compensation(path);
    if (!content) return content.diagnosis();
    return text::replace_file(path, with_cells(*content, parameters, cells));
}

}  // namespace polyturn::toolmgmt
