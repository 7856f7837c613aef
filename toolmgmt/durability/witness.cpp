#include "toolmgmt/durability/witness.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstring>

namespace polyturn::toolmgmt {
namespace {

constexpr std::uint64_t kWitnessMagic = 0x314e544957545031u;
constexpr std::size_t kHalf = 4096;  // apart by what a disk writes at once

struct Half {
    std::uint64_t magic = kWitnessMagic, turn = 0;
    Witness witness;
    std::uint64_t sum = 0;
};
static_assert(sizeof(Half) == 16 + sizeof(Witness) + 8 && sizeof(Half) <= 512,
              "no holes, one sector");

std::string_view summed(const Half& half) {
    return {reinterpret_cast<const char*>(&half), sizeof half - sizeof half.sum};
}

bool read_half(std::string_view file, std::size_t which, Half& out) {
    if (file.size() < which * kHalf + sizeof out) return false;
    std::memcpy(&out, file.data() + which * kHalf, sizeof out);
    out.witness.why.back() = 0;
    return out.magic == kWitnessMagic && out.sum == check_sum(summed(out), which) &&
           (out.turn & 1) == which;
}

}  // namespace

WitnessFile::State WitnessFile::read() {
    std::string bytes;
    if (!read_whole_file(path_, bytes))
        return ::access(path_.c_str(), F_OK) == 0 ? State::Damaged : State::Missing;
    bool any = false;
    for (std::size_t which = 0; which < 2; ++which) {
        Half half;
        if (!read_half(bytes, which, half) || (any && half.turn < turn_)) continue;
        any = true;
        turn_ = half.turn;
        now_ = half.witness;
    }
    return any ? State::Good : State::Damaged;
}

bool WitnessFile::write(const Witness& next) {
    Half half;
    half.turn = turn_ + 1;
    half.witness = next;
    half.sum = check_sum(summed(half), half.turn & 1);
    const std::string_view bytes(reinterpret_cast<const char*>(&half), sizeof half);
    if (!file_) file_ = OpenFile(::open(path_.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW));
    if (!file_ || turn_ == 0) {  // a new file: whole or not at all
        std::string both(2 * kHalf, '\0');
        std::memcpy(both.data() + (half.turn & 1) * kHalf, bytes.data(), bytes.size());
        if (!replace_private(path_, both)) return false;
        file_ = OpenFile(::open(path_.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW));
    } else if (!write_at(file_.get(), bytes, (half.turn & 1) * kHalf) ||
               ::fdatasync(file_.get()) != 0) {
        return false;
    }
    turn_ = half.turn;
    now_ = next;
    return true;
}

}  // namespace polyturn::toolmgmt
