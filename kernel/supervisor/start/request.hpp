// What may come through the socket. A line is judged here once, before any parser looks at it (its
// length, how deep it nests, how many values it has), then by a table of what each request may
// hold; behind this nothing of it is JSON any more but the text that goes to the store, which
// judges it itself.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::supervisor {

enum class RequestVerb : std::uint8_t {
    Press,
    Set,
    Release,
    Parameters,
    Store,
    Alarms,
    Who,
    Logout,
    End
};

// In which order the supervisor does what has come (request_socket.hpp).
enum class RequestClass : std::uint8_t {
    Stop,     // feed hold, emergency stop, reset: at once
    Machine,  // other presses, signals, what the supervisor knows itself
    Store,    // goes to the store and is answered by it
    Files,    // reads files or computes long: by a worker
};

struct Request {
    RequestVerb verb = RequestVerb::Who;
    RequestClass rank = RequestClass::Machine;
    std::string token;
    std::string words, folder;       // press, set, release
    std::vector<std::string> lines;  // parameters
    bool import = false;
    std::uint64_t since = 0;                // alarms
    std::string operation, operation_text;  // store: its `do`, and all of it
};

inline constexpr std::size_t kLongestLine = 64 * 1024;      // of a request
inline constexpr std::size_t kLongestImport = 1024 * 1024;  // of one that imports
inline constexpr std::size_t kDeepest = 32;
inline constexpr std::size_t kMostValues = 4096, kMostImported = 131'072;
// what is longer is decoded by a worker
inline constexpr std::size_t kDecodedAtOnce = 4 * 1024;
inline constexpr std::size_t kStopLine = 4 * 1024;

// RequestBad says what is wrong with it.
Result<Request> decode_request(std::string_view line);

// Is this line the press of a stop, written as programs write it (an object of plain texts)? One
// pass over at most kStopLine bytes that ends at the first thing that does not fit, so that a flood
// of other lines costs nothing. A stop written otherwise acts in its turn.
bool is_stop(std::string_view line);

// Is this text within the limits, so that a parser may recurse into it? Empty, or what is wrong.
std::string_view json_beyond_limits(std::string_view text, std::size_t deepest,
                                    std::size_t most_values);

// One line for each request: its fields with their types and limits (the manual's list is made of
// it).
std::string describe_requests();

}  // namespace polyturn::supervisor
