// Invariants that headers name (I1, S1 ...) looked at while the program runs: in builds of type Dev
// and with sanitizers, where CMakeLists.txt defines POLYTURN_ASSERT. Elsewhere the condition is
// compiled and not evaluated.
//
//     PT_ASSERT(head - seen_ < Half::capacity, "I1 tail <= head <= tail + kCapacity");
//
// For mistakes of ours only. What another process has written into shared memory may be anything:
// it is checked and refused, never asserted. A machine fault is an alarm, bad input a Diagnosis.
//
// What is printed is put together by the compiler, so that nothing is allocated or formatted, and
// goes out in one write: the cyclic thread may assert, too.
#pragma once

#if defined(POLYTURN_ASSERT) && !defined(NDEBUG)
#include <unistd.h>

#include <cstddef>
#include <cstdlib>

namespace polyturn::detail {
[[noreturn]] inline void invariant_broken(const char* text, std::size_t size) noexcept {
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, size);
    std::abort();
}
}  // namespace polyturn::detail

#define POLYTURN_TEXT_OF(x) #x
#define POLYTURN_TEXT(x) POLYTURN_TEXT_OF(x)
#define POLYTURN_BROKEN(place, condition, invariant) \
    place ": broken: " invariant " (" condition ")\n"
#define PT_ASSERT(condition, invariant)                                                            \
    ((condition)                                                                                   \
         ? static_cast<void>(0)                                                                    \
         : ::polyturn::detail::invariant_broken(                                                   \
               POLYTURN_BROKEN(__FILE__ ":" POLYTURN_TEXT(__LINE__), #condition, invariant),       \
               sizeof(                                                                             \
                   POLYTURN_BROKEN(__FILE__ ":" POLYTURN_TEXT(__LINE__), #condition, invariant)) - \
                   1))
#else
#define PT_ASSERT(condition, invariant) static_cast<void>(sizeof((condition) ? 1 : 0))
#endif
