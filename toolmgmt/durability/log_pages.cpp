#include "toolmgmt/durability/log_pages.hpp"

#include <cstddef>
#include <string_view>

#include "toolmgmt/durability/page_sums.hpp"
#include "toolmgmt/durability/store_files.hpp"

namespace polyturn::toolmgmt {
namespace {

constexpr std::size_t kHead = 32, kFrame = 24;

std::uint32_t big(std::string_view bytes, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i]));
    };
    return byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3);
}
std::uint32_t little(std::string_view bytes, std::size_t at) {
    return __builtin_bswap32(big(bytes, at));
}

// The running check sum of the log, in the order of bytes that its head names.
struct Running {
    bool big_endian = false;
    std::uint32_t s0 = 0, s1 = 0;
    void take(std::string_view bytes) {
        for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
            s0 += (big_endian ? big(bytes, at) : little(bytes, at)) + s1;
            s1 += (big_endian ? big(bytes, at + 4) : little(bytes, at + 4)) + s0;
        }
    }
};

}  // namespace

LogPages read_log(const std::string& path) {
    LogPages out;
    std::string bytes;
    if (!read_whole_file(path, bytes) || bytes.size() < kHead) return out;
    const std::string_view log = bytes;
    const std::uint32_t magic = big(log, 0), size = big(log, 8);
    if ((magic & ~1u) != 0x377f0682u || size < 512 || size > 65536 || (size & (size - 1)) != 0)
        return out;
    Running sum{(magic & 1u) != 0};
    sum.take(log.substr(0, 24));
    if (sum.s0 != big(log, 24) || sum.s1 != big(log, 28)) return out;
    out.page_size = size;
    std::map<std::uint32_t, std::uint64_t> open;  // of the transaction that has not ended yet
    for (std::size_t at = kHead; at + kFrame + size <= log.size(); at += kFrame + size) {
        const std::uint32_t page = big(log, at), pages = big(log, at + 4);
        // of an earlier use of the file
        if (page == 0 || log.substr(at + 8, 8) != log.substr(16, 8)) break;
        const std::string_view content = log.substr(at + kFrame, size);
        sum.take(log.substr(at, 8));
        sum.take(content);
        if (sum.s0 != big(log, at + 16) || sum.s1 != big(log, at + 20)) break;
        open[page] = page_sum(page, content);
        if (pages == 0) continue;
        for (const auto& [number, value] : open) out.sums[number] = value;
        open.clear();
        out.pages = pages;
    }
    return out;
}

}  // namespace polyturn::toolmgmt
