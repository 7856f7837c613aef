#include "toolmgmt/durability/page_sums.hpp"

#include <unistd.h>

#include <cstring>

#include "toolmgmt/durability/store_files.hpp"

namespace polyturn::toolmgmt {
namespace {

constexpr std::uint64_t kSumsMagic = 0x31534d5553545031u;

struct Head {
    std::uint64_t magic = kSumsMagic, store = 0, page_size = 0, pages = 0;
};

}  // namespace

std::uint64_t page_sum(std::uint32_t page, std::string_view content) {
    return check_sum(content, page);
}

PageSums::State PageSums::read(const std::string& folder) {
    const std::string path = folder + "/" + kName;
    std::string bytes;
    if (!read_whole_file(path, bytes))
        return ::access(path.c_str(), F_OK) == 0 ? State::Damaged : State::Missing;
    Head head;
    if (bytes.size() < sizeof head + 8) return State::Damaged;
    std::memcpy(&head, bytes.data(), sizeof head);
    std::uint64_t sum = 0;
    const std::size_t end = bytes.size() - sizeof sum;
    std::memcpy(&sum, bytes.data() + end, sizeof sum);
    if (head.magic != kSumsMagic ||
        sum != check_sum(std::string_view(bytes).substr(0, end), kSumsMagic) ||
        end != sizeof head + head.pages * 8)
        return State::Damaged;
    store = head.store;
    page_size = static_cast<std::uint32_t>(head.page_size);
    sums.resize(head.pages);
    std::memcpy(sums.data(), bytes.data() + sizeof head, head.pages * 8);
    return State::Good;
}

bool PageSums::write(const std::string& folder) const {
    const Head head{kSumsMagic, store, page_size, sums.size()};
    std::string bytes(reinterpret_cast<const char*>(&head), sizeof head);
    bytes.append(reinterpret_cast<const char*>(sums.data()), sums.size() * 8);
    const std::uint64_t sum = check_sum(bytes, kSumsMagic);
    bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    return replace_private(folder + "/" + kName, bytes);
}

void PageSums::fold(const LogPages& log) {
    if (log.pages == 0) return;
    page_size = log.page_size;
    sums.resize(log.pages);
    for (const auto& [page, sum] : log.sums)
        if (page <= log.pages) sums[page - 1] = sum;
}

void PageSums::take(std::string_view file, std::uint32_t size) {
    page_size = size;
    sums.clear();
    if (size == 0) return;
    for (std::uint32_t page = 1; static_cast<std::size_t>(page) * size <= file.size(); ++page)
        sums.push_back(
            page_sum(page, file.substr(static_cast<std::size_t>(page - 1) * size, size)));
}

std::uint32_t PageSums::damaged(std::string_view file, const LogPages& log) const {
    for (std::uint32_t page = 1; page <= sums.size(); ++page) {
        if (log.sums.contains(page) || (log.pages != 0 && page > log.pages)) continue;
        const std::size_t at = static_cast<std::size_t>(page - 1) * page_size;
        if (at + page_size > file.size() ||
            page_sum(page, file.substr(at, page_size)) != sums[page - 1])
            return page;
    }
    return 0;
}

}  // namespace polyturn::toolmgmt
