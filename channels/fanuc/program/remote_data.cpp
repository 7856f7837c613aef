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
#include "channels/fanuc/program/remote_data.hpp"

#include <chrono>
#include <cmath>
#include <utility>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/program/calls.hpp"
#include "channels/fanuc/program/faults.hpp"

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

bool binary_block(Execution& x, const unsigned char* bytes, unsigned axes, bool& ends) {
    ++x.awaited.remote.blocks;
    unsigned sum = 0;
    for (unsigned i = 0; i < 2 * axes; ++i) sum += bytes[i];
    if ((sum & 0xFFu) != bytes[2 * axes])
        return x.core.fail(Alarm::RemoteBad, 'G',
                           "check byte of block " + std::to_string(x.awaited.remote.blocks));
    AxisValues target = x.core.path.programmed;
    double linear2 = 0.0, rotary2 = 0.0;
    ends = true;
    for (unsigned i = 0; i < axes; ++i) {
        int way = 0;
        if (!way_of(bytes[2 * i], bytes[2 * i + 1], way))
            return x.core.fail(Alarm::RemoteBad, 'G',
                               "block " + std::to_string(x.awaited.remote.blocks));
        if (way == 0) continue;
        ends = false;
        const ChannelAxis& axis = x.core.view().axes[i];
        const bool inch =
            !axis.rotary && params::bit(x.core.view().table(), params::n0104_unit_of_measure,
                                        x.core.view().channel, 0);
        // an inch has one decimal more
        const double by = way * axis.increment * (inch ? 2.54 : 1.0) * (axis.diameter ? 0.5 : 1.0);
        target[i] += by;
        (axis.rotary ? rotary2 : linear2) += by * by;
    }
    if (ends) return true;
    x.core.path.feed_mode = FeedMode::PerMinute;
    x.core.path.feed = std::sqrt(linear2 > 0 ? linear2 : rotary2) / x.awaited.remote.unit_minutes;
    x.core.path.override_locked = true;
    return x.core.linear(target);
}

}  // namespace

bool g_binary_input(Execution& x, const GCode&) {
    if (x.core.compensating()) return x.core.fail(Alarm::BinaryInputComp, 'G');
    // G5 is alone in its block
    if (const std::uint32_t extra = x.block.letters & ~(letter_bit('G') | letter_bit('N'));
        extra || x.words.g_count != 1) {
        const char letter = extra ? static_cast<char>('A' + __builtin_ctz(extra)) : 'G';
        return x.core.fail(Alarm::AddressIllegal, letter, std::string(1, letter));
    }
    if (x.core.transformed() || x.core.path.framed || x.modal.drilling)
        return x.core.fail(Alarm::CodesContradict, 'G', "G5");
    if (x.reading.contour) return x.core.fail(Alarm::ContourCodeIllegal, 'G');
    const MachineView& view = x.core.view();
    const params::Table& t = view.table();
    const auto axes = static_cast<unsigned>(params::get(t, params::f7510, view.channel));
    if (axes > view.axis_count) return x.core.fail(Alarm::RemoteBad, 'G', "F7510");
    x.awaited.remote.axes = axes ? axes : view.axis_count;
    static constexpr double kUnitMs[] = {8, 2, 4, 1, 16, 8, 8, 8};
    const auto bits = static_cast<unsigned>(params::get(t, params::f7501, view.channel));
    x.awaited.remote.unit_minutes = kUnitMs[bits >> 4 & 7u] / 60'000.0;
    std::string name(params::get_text(t, params::pt_remote_input, view.channel));
    if (name.empty()) name = x.files.path(x.calls.frames.front().file) + ".bin";
    if (!x.awaited.remote.from.open(name, ByteStream::Open::ToRead, kConnectMs))
        return x.core.fail(Alarm::RemoteSource, 'G', name + ": " + x.awaited.remote.from.why());
    x.awaited.remote.active = true;
    x.awaited.remote.filled = 0;
    x.awaited.remote.blocks = 0;
    x.awaited.remote.silent_since_ms = -1;
    // overrides have no effect on these data
    x.awaited.remote.override_was_locked = x.core.path.override_locked;
    x.awaited.remote.feed_was = x.core.path.feed;
    x.awaited.remote.feed_mode_was = x.core.path.feed_mode;
    return true;
}

Step binary_step(Execution& x) {
    x.core.begin_block();
    const unsigned size = 2 * x.awaited.remote.axes + 1;
    const bool watched = (static_cast<unsigned>(params::get(x.core.view().table(), params::f7501,
                                                            x.core.view().channel)) >>
                              7 &
                          1u) != 0;
    // fanuc_lathe 9.3: 000 or 179
    const Alarm late = watched ? Alarm::RemoteBroken : Alarm::RemoteLate;
    const auto stop = [&](bool good) {
        x.awaited.remote.active = false;
        x.awaited.remote.from.close();
        x.core.path.feed = x.awaited.remote.feed_was;
        x.core.path.feed_mode = x.awaited.remote.feed_mode_was;
        x.core.path.override_locked = x.awaited.remote.override_was_locked;
        if (x.core.emitted()) {
            x.run.fresh = false;
            x.core.end_block();
        }
        return good ? Step::Continue : report(x, x.core.fault());
    };
    for (int n = 0; n < kBlocksPerStep; ++n) {
        while (x.awaited.remote.filled < size) {
            std::size_t got = 0;
            switch (x.awaited.remote.from.read(
                reinterpret_cast<char*>(x.awaited.remote.block.data()) + x.awaited.remote.filled,
                size - x.awaited.remote.filled, got, kTimeoutMs)) {
                case ByteStream::Got::Data:
                    x.awaited.remote.filled += static_cast<unsigned>(got);
                    x.awaited.remote.silent_since_ms = -1;
                    break;
                case ByteStream::Got::Nothing: {
                    if (x.awaited.remote.silent_since_ms < 0)
                        x.awaited.remote.silent_since_ms = now_ms();
                    const double limit_s = params::get(
                        x.core.view().table(), params::pt_remote_timeout, x.core.view().channel);
                    if (static_cast<double>(now_ms() - x.awaited.remote.silent_since_ms) <
                        limit_s * 1000) {
                        if (x.core.emitted()) x.core.end_block();
                        return Step::Continue;  // what else there is to do comes first
                    }
                    x.core.fail(late, 'G', "block " + std::to_string(x.awaited.remote.blocks + 1));
                    return stop(false);
                }
                case ByteStream::Got::End:
                    x.core.fail(
                        late, 'G',
                        "the data end in block " + std::to_string(x.awaited.remote.blocks + 1));
                    return stop(false);
                case ByteStream::Got::Error:
                    x.core.fail(Alarm::RemoteSource, 'G', x.awaited.remote.from.why());
                    return stop(false);
            }
        }
        x.awaited.remote.filled = 0;
        bool ends = false;
        if (!binary_block(x, x.awaited.remote.block.data(), x.awaited.remote.axes, ends))
            return stop(false);
        if (ends) return stop(true);
    }
    if (x.core.emitted()) x.core.end_block();
    return Step::Continue;
}

// M198 P: from a folder at once; through a socket the text comes between two steps, whole, before
// its first block is read.
bool external_call(Execution& x, std::int64_t number, std::int64_t repeats) {
    const MachineView& view = x.core.view();
    const std::string name(params::get_text(view.table(), params::pt_external, view.channel));
    if (name.empty()) return call_program(x, number, repeats, nullptr, false, false, 'P');
    if (!call_levels_left(x, false, false, 'P')) return false;
    if (!ByteStream::is_socket(name)) {
        const auto file = x.files.find_number_in(name, number);
        if (!file)
            return x.core.fail(Alarm::SubprogramMissing, 'P', name + "/O" + std::to_string(number));
        return repeats < 1 || enter_program(x, *file, number, repeats, nullptr, false, false);
    }
    if (x.core.compensating()) return x.core.fail(Alarm::BinaryInputComp, 'M');
    if (!x.awaited.remote.from.open(name, ByteStream::Open::ToRead, kConnectMs))
        return x.core.fail(Alarm::RemoteSource, 'P', name + ": " + x.awaited.remote.from.why());
    if (!x.awaited.remote.from.write("O" + std::to_string(number) + "\n", kConnectMs))
        return x.core.fail(Alarm::RemoteSource, 'P', name + ": " + x.awaited.remote.from.why());
    x.awaited.external = {true, number, repeats, -1, {}, name + "/O" + std::to_string(number)};
    return true;
}

Step external_step(Execution& x) {
    constexpr std::size_t kPiece = 1 << 16, kLargest = 256u << 20;
    x.core.begin_block();
    const auto stop = [&](Alarm alarm, std::string detail) {
        x.awaited.external = {};
        x.awaited.remote.from.close();
        x.core.fail(alarm, 'P', std::move(detail));
        return report(x, x.core.fault());
    };
    const std::size_t before = x.awaited.external.text.size();
    if (before + kPiece > kLargest) return stop(Alarm::RemoteBad, x.awaited.external.name);
    x.awaited.external.text.resize(before + kPiece);
    std::size_t got = 0;
    const ByteStream::Got what = x.awaited.remote.from.read(x.awaited.external.text.data() + before,
                                                            kPiece, got, kTimeoutMs);
    x.awaited.external.text.resize(before + got);
    if (what == ByteStream::Got::Data) x.awaited.external.silent_since_ms = -1;
    if (what == ByteStream::Got::Error)
        return stop(Alarm::RemoteSource, x.awaited.remote.from.why());
    if (what == ByteStream::Got::Nothing) {
        if (x.awaited.external.silent_since_ms < 0) x.awaited.external.silent_since_ms = now_ms();
        const double limit_s =
            params::get(x.core.view().table(), params::pt_remote_timeout, x.core.view().channel);
        if (static_cast<double>(now_ms() - x.awaited.external.silent_since_ms) >= limit_s * 1000)
            return stop(Alarm::RemoteLate, x.awaited.external.name);
    }
    if (what != ByteStream::Got::End) return Step::Continue;
    x.awaited.remote.from.close();
    if (x.awaited.external.text.find_first_not_of(" \t\r\n%") == std::string::npos)
        return stop(Alarm::SubprogramMissing, x.awaited.external.name);
    x.text.external.push_back(std::move(x.awaited.external.text));
    const auto file = x.files.open_text(x.text.external.back(), x.awaited.external.name);
    const ExternalProgram done = std::move(x.awaited.external);
    x.awaited.external = {};
    if (!file) return stop(Alarm::RemoteBad, done.name);
    if (done.repeats >= 1 &&
        !enter_program(x, *file, done.number, done.repeats, nullptr, false, false))
        return report(x, x.core.fault());
    return Step::Continue;
}

}  // namespace polyturn::channels::fanuc
