#include "toolmgmt/cell_requests.hpp"

#include <cstring>
#include <filesystem>
#include <string>

#include "ipc/text/read_file.hpp"
#include "ipc/text/replace_file.hpp"

namespace polyturn::toolmgmt {

std::optional<CellEntry> cell_of(const StoreRequest& request) {
    if (static_cast<StoreRequestKind>(request.kind) != StoreRequestKind::Parameter) return std::nullopt;
    return cell_entry({request.name.data(), ::strnlen(request.name.data(), request.name.size())});
}

Result<void> keep_cells(const RunOptions& options, const params::Table& parameters, std::span<const CellEntry> cells) {
    if (cells.empty() || options.virtual_time) return {};
    const std::string base(options.machine_folder.data(), ::strnlen(options.machine_folder.data(), options.machine_folder.size()));
    if (base.empty()) return Diagnosis{Alarm::CompensationTable, {}, {}, "the machine has no folder for it"};
    const std::string path = base + ".compensation";
    std::error_code none;
    std::string content;
    if (std::filesystem::exists(path, none)) {
        Result<std::string> kept = text::read_text_file(path);
        if (!kept) return kept.diagnosis();
        content = std::move(*kept);
    }
    return text::replace_file(path, with_cells(content, parameters, cells));
}

}  // namespace polyturn::toolmgmt
