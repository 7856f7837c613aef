// libs: polyturn_channels
//
// Any bytes as a program text: lines and words, or a diagnosis; never a
// crash, never an endless loop.
#include <cstddef>
#include <cstdint>

#include "channels/text/line_source.hpp"
#include "channels/text/word_scanner.hpp"

namespace {

using namespace polyturn::channels;

class NoExpressions final : public ScanHook {
public:
    Read read_value(const char*&, const char*, double&) override { return Read::Fault; }
    bool block_skip(unsigned number) override { return number == 2; }
    std::size_t axis_name(const char*, const char*, int&) override { return 0; }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    LineSource source;
    if (!source.open_text({reinterpret_cast<const char*>(data), size}, "fuzz")) return 0;
    NoExpressions hook;
    WordScanner scanner(hook);
    auto block = Block();
    std::string_view line;
    while (source.next(line) == LineSource::Status::Line) {
        std::size_t from = 0;
        while (scanner.scan(line, from, block) == ScanStop::EndOfBlock &&
               scanner.stopped_at() > from)
            from = scanner.stopped_at();
        for (unsigned k = 0; k < block.count; ++k)
            if (block.words[k].column == 0 ||
                block.words[k].column + block.words[k].length > line.size() + 1)
                __builtin_trap();
    }
    return 0;
}
