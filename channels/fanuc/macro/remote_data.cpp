// G5 and M198: data and programs from outside.
//
// G5: blocks of binary data, each the way of the axes in one unit of time (fanuc_lathe 9.2).
//
//   | high | low | high | low | ... | check |     two bytes an axis, then the lowest byte of their sum
//     '-- word: 13..7 in bits 15..9, 6..0 in bits 7..1, bits 8 and 0 are 0; least increments, two's
//     complement
//
// A block of nothing but zeros ends it. The data come from PT_REMOTE_INPUT, or from the file beside
// the main program. They are read a piece at a time between two steps, so that a sender that is
// slow holds only this program.
#include <chrono>
#include <cmath>

#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {
namespace {

constexpr int kBlocksPerStep = 128, kTimeoutMs = 20, kConnectMs = 300;

std::int64_t now_ms() {
    return std::chrono::duration_cast<std::chrono::milliseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

// 14 bits with a sign out of the word's two halves; false: a bit is set that must not be.
bool way_of(unsigned high, unsigned low, int& way) {
    if ((high | low) & 1u) return false;
    const int bits = static_cast<int>((high >> 1) << 7 | low >> 1);
    way = bits >= 1 << 13 ? bits - (1 << 14) : bits;
    return true;
}

}  // namespace

bool Interpreter::g_binary_input(const GCode&) {
    if (core_.compensating()) return core_.fail(Alarm::BinaryInputComp, 'G');
    // G5 is alone in its block
    if (const std::uint32_t extra = block_.letters & ~(letter_bit('G') | letter_bit('N'));
        extra || g_count_ != 1) {
        const char letter = extra ? static_cast<char>('A' + __builtin_ctz(extra)) : 'G';
        return core_.fail(Alarm::AddressIllegal, letter, std::string(1, letter));
    }
    if (core_.transformed() || core_.path.framed || drilling_)
        return core_.fail(Alarm::CodesContradict, 'G', "G5");
    if (reads_contour_) return core_.fail(Alarm::ContourCodeIllegal, 'G');
    const MachineView& view = core_.view();
    const params::Table& t = view.table();
    const auto axes = static_cast<unsigned>(params::get(t, params::f7510, view.channel));
    if (axes > view.axis_count) return core_.fail(Alarm::RemoteBad, 'G', "F7510");
    remote_.axes = axes ? axes : view.axis_count;
    static constexpr double kUnitMs[] = {8, 2, 4, 1, 16, 8, 8, 8};
    const auto bits = static_cast<unsigned>(params::get(t, params::f7501, view.channel));
    remote_.unit_minutes = kUnitMs[bits >> 4 & 7u] / 60'000.0;
    std::string name(params::get_text(t, params::pt_remote_input, view.channel));
    if (name.empty()) name = files_->path(frames_.front().file) + ".bin";
    if (!remote_.from.open(name, ByteStream::Open::ToRead, kConnectMs))
        return core_.fail(Alarm::RemoteSource, 'G', name + ": " + remote_.from.why());
    remote_.active = true;
    remote_.filled = 0;
    remote_.blocks = 0;
    remote_.silent_since_ms = -1;
    // overrides have no effect on these data
    remote_.override_was_locked = core_.path.override_locked;
    remote_.feed_was = core_.path.feed;
    remote_.feed_mode_was = core_.path.feed_mode;
    return true;
}

bool Interpreter::binary_block(const unsigned char* bytes, unsigned axes, bool& ends) {
    ++remote_.blocks;
    unsigned sum = 0;
    for (unsigned i = 0; i < 2 * axes; ++i) sum += bytes[i];
    if ((sum & 0xFFu) != bytes[2 * axes])
        return core_.fail(Alarm::RemoteBad, 'G',
                          "check byte of block " + std::to_string(remote_.blocks));
    AxisValues target = core_.path.programmed;
    double linear2 = 0.0, rotary2 = 0.0;
    ends = true;
    for (unsigned i = 0; i < axes; ++i) {
        int way = 0;
        if (!way_of(bytes[2 * i], bytes[2 * i + 1], way))
            return core_.fail(Alarm::RemoteBad, 'G', "block " + std::to_string(remote_.blocks));
        if (way == 0) continue;
        ends = false;
        const ChannelAxis& axis = core_.view().axes[i];
        const bool inch =
            !axis.rotary && params::bit(core_.view().table(), params::n0104_unit_of_measure,
                                        core_.view().channel, 0);
        // an inch has one decimal more
        const double by = way * axis.increment * (inch ? 2.54 : 1.0) * (axis.diameter ? 0.5 : 1.0);
        target[i] += by;
        (axis.rotary ? rotary2 : linear2) += by * by;
    }
    if (ends) return true;
    core_.path.feed_mode = FeedMode::PerMinute;
    core_.path.feed = std::sqrt(linear2 > 0 ? linear2 : rotary2) / remote_.unit_minutes;
    core_.path.override_locked = true;
    return core_.linear(target);
}

Step Interpreter::binary_step() {
    core_.begin_block();
    const unsigned size = 2 * remote_.axes + 1;
    const bool watched = (static_cast<unsigned>(params::get(core_.view().table(), params::f7501,
                                                            core_.view().channel)) >>
                              7 &
                          1u) != 0;
    // fanuc_lathe 9.3: 000 or 179
    const Alarm late = watched ? Alarm::RemoteBroken : Alarm::RemoteLate;
    const auto stop = [&](bool good) {
        remote_.active = false;
        remote_.from.close();
        core_.path.feed = remote_.feed_was;
        core_.path.feed_mode = remote_.feed_mode_was;
        core_.path.override_locked = remote_.override_was_locked;
        if (core_.emitted()) {
            fresh_ = false;
            core_.end_block();
        }
        return good ? Step::Continue : fault(core_.fault());
    };
    for (int n = 0; n < kBlocksPerStep; ++n) {
        while (remote_.filled < size) {
            std::size_t got = 0;
            switch (
                remote_.from.read(reinterpret_cast<char*>(remote_.block.data()) + remote_.filled,
                                  size - remote_.filled, got, kTimeoutMs)) {
                case ByteStream::Got::Data:
                    remote_.filled += static_cast<unsigned>(got);
                    remote_.silent_since_ms = -1;
                    break;
                case ByteStream::Got::Nothing: {
                    if (remote_.silent_since_ms < 0) remote_.silent_since_ms = now_ms();
                    const double limit_s = params::get(
                        core_.view().table(), params::pt_remote_timeout, core_.view().channel);
                    if (static_cast<double>(now_ms() - remote_.silent_since_ms) < limit_s * 1000) {
                        if (core_.emitted()) core_.end_block();
                        return Step::Continue;  // what else there is to do comes first
                    }
                    core_.fail(late, 'G', "block " + std::to_string(remote_.blocks + 1));
                    return stop(false);
                }
                case ByteStream::Got::End:
                    core_.fail(late, 'G',
                               "the data end in block " + std::to_string(remote_.blocks + 1));
                    return stop(false);
                case ByteStream::Got::Error:
                    core_.fail(Alarm::RemoteSource, 'G', remote_.from.why());
                    return stop(false);
            }
        }
        remote_.filled = 0;
        bool ends = false;
        if (!binary_block(remote_.block.data(), remote_.axes, ends)) return stop(false);
        if (ends) return stop(true);
    }
    if (core_.emitted()) core_.end_block();
    return Step::Continue;
}

// M198 P: from a folder at once; through a socket the text comes between two steps, whole, before
// its first block is read.
bool Interpreter::external_call(std::int64_t number, std::int64_t repeats) {
    const MachineView& view = core_.view();
    const std::string name(params::get_text(view.table(), params::pt_external, view.channel));
    if (name.empty()) return call_program(number, repeats, nullptr, false, false, 'P');
    if (!call_levels_left(false, false, 'P')) return false;
    if (!ByteStream::is_socket(name)) {
        const auto file = files_->find_number_in(name, number);
        if (!file)
            return core_.fail(Alarm::SubprogramMissing, 'P', name + "/O" + std::to_string(number));
        return repeats < 1 || enter_program(*file, number, repeats, nullptr, false, false);
    }
    if (core_.compensating()) return core_.fail(Alarm::BinaryInputComp, 'M');
    if (!remote_.from.open(name, ByteStream::Open::ToRead, kConnectMs))
        return core_.fail(Alarm::RemoteSource, 'P', name + ": " + remote_.from.why());
    if (!remote_.from.write("O" + std::to_string(number) + "\n", kConnectMs))
        return core_.fail(Alarm::RemoteSource, 'P', name + ": " + remote_.from.why());
    external_ = {true, number, repeats, -1, {}, name + "/O" + std::to_string(number)};
    return true;
}

Step Interpreter::external_step() {
    constexpr std::size_t kPiece = 1 << 16, kLargest = 256u << 20;
    core_.begin_block();
    const auto stop = [&](Alarm alarm, std::string detail) {
        external_ = {};
        remote_.from.close();
        core_.fail(alarm, 'P', std::move(detail));
        return fault(core_.fault());
    };
    const std::size_t before = external_.text.size();
    if (before + kPiece > kLargest) return stop(Alarm::RemoteBad, external_.name);
    external_.text.resize(before + kPiece);
    std::size_t got = 0;
    const ByteStream::Got what =
        remote_.from.read(external_.text.data() + before, kPiece, got, kTimeoutMs);
    external_.text.resize(before + got);
    if (what == ByteStream::Got::Data) external_.silent_since_ms = -1;
    if (what == ByteStream::Got::Error) return stop(Alarm::RemoteSource, remote_.from.why());
    if (what == ByteStream::Got::Nothing) {
        if (external_.silent_since_ms < 0) external_.silent_since_ms = now_ms();
        const double limit_s =
            params::get(core_.view().table(), params::pt_remote_timeout, core_.view().channel);
        if (static_cast<double>(now_ms() - external_.silent_since_ms) >= limit_s * 1000)
            return stop(Alarm::RemoteLate, external_.name);
    }
    if (what != ByteStream::Got::End) return Step::Continue;
    remote_.from.close();
    if (external_.text.find_first_not_of(" \t\r\n%") == std::string::npos)
        return stop(Alarm::SubprogramMissing, external_.name);
    external_texts_.push_back(std::move(external_.text));
    const auto file = files_->open_text(external_texts_.back(), external_.name);
    const ExternalProgram done = std::move(external_);
    external_ = {};
    if (!file) return stop(Alarm::RemoteBad, done.name);
    if (done.repeats >= 1 &&
        !enter_program(*file, done.number, done.repeats, nullptr, false, false))
        return fault(core_.fault());
    return Step::Continue;
}

}  // namespace polyturn::channels::fanuc
