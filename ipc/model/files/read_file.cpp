#include "ipc/model/files/read_file.hpp"

#include "ipc/model/files/regular_file.hpp"

namespace polyturn::text {

namespace {
Diagnosis fault(Alarm alarm, const std::string& path, std::string detail) {
    return Diagnosis{alarm, Place{path, 0, 0, 0}, {}, std::move(detail)};
}
}  // namespace

Result<std::string> read_text_file(const std::string& path, std::uint64_t largest) {
    const auto file = RegularFile::open(path, largest);
    if (!file) return file.diagnosis();
    auto read = file->read_all();
    if (!read) return read.diagnosis();
    std::string text = std::move(*read);
    if (text.size() >= 2 &&
        ((text[0] == '\xff' && text[1] == '\xfe') || (text[0] == '\xfe' && text[1] == '\xff')))
        return fault(Alarm::FileUtf16, path, path);
    if (text.find('\0') != std::string::npos) return fault(Alarm::FileBinary, path, path);
    return text;
}

std::string_view line_of(std::string_view text, std::uint32_t line) {
    std::size_t from = 0;
    for (std::uint32_t number = 1; number < line; ++number) {
        from = text.find('\n', from);
        if (from == std::string_view::npos) return {};
        ++from;
    }
    std::string_view rest = text.substr(from);
    rest = rest.substr(0, rest.find('\n'));
    if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
    return rest;
}

}  // namespace polyturn::text
