#include "ipc/text/read_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace polyturn::text {

namespace {
constexpr std::uintmax_t kLargest = 64u << 20;

Diagnosis fault(Alarm alarm, const std::string& path, std::string detail) { return Diagnosis{alarm, Place{path, 0, 0, 0}, {}, std::move(detail)}; }
}  // namespace

Result<std::string> read_text_file(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) return fault(Alarm::FileUnreadable, path, "it is a folder");
    std::ifstream file(path, std::ios::binary);
    if (!file) return fault(Alarm::FileUnreadable, path, std::strerror(errno));
    std::string text;
    char block[1 << 16];
    while (file.read(block, sizeof block) || file.gcount() > 0) {
        text.append(block, static_cast<std::size_t>(file.gcount()));
        if (text.size() > kLargest) return fault(Alarm::FileUnreadable, path, "it is larger than 64 MB");
    }
    if (text.size() >= 2 && ((text[0] == '\xff' && text[1] == '\xfe') || (text[0] == '\xfe' && text[1] == '\xff'))) return fault(Alarm::FileUtf16, path, path);
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
