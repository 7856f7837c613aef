// What is wrong with something that somebody wrote: a program, a parameter file, a setup, a job.
// Errors are data: functions return Result<T>, nothing is thrown across a folder's border.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "polyturn/alarm_ids.hpp"  // generated from alarms.csv: enum class Alarm

namespace polyturn {

enum class Severity : std::uint8_t { Message, Warning, Error };

// The control whose numbers and words an alarm is reported in.
enum class Dialect : std::uint8_t { Polyturn, Fanuc, Nct, Fagor, Sinumerik, Mefi };

struct AlarmRow {
    Alarm id;
    std::string_view key;  // name in alarms.csv
    Severity severity;
    std::array<std::string_view, 6> number;  // per Dialect; empty: Polyturn's number serves
    std::string_view text;                   // with {0} {1} for values and {d} for detail
    std::string_view remedy;
};

const AlarmRow& alarm_row(Alarm id);
// The number an operator of that control expects to see; Polyturn's own where that control has
// none.
std::string_view alarm_number(Alarm id, Dialect dialect);

// A place in a text. line and column count from 1 in characters, column 0 means the whole line,
// line 0 the whole file.
struct Place {
    std::string file;
    std::uint32_t line = 0, column = 0, length = 0;
};

struct Diagnosis {
    Alarm alarm{};
    Place place;
    std::array<double, 2> values{};  // what the text quotes, in the unit that the text names
    std::string detail;              // a name or a word that the text quotes

    std::string text() const;  // the alarm's text with values and detail filled in
    std::string_view remedy() const { return alarm_row(alarm).remedy; }
    Severity severity() const { return alarm_row(alarm).severity; }
};

// "file:line:column: alarm 020: text" with the line, a mark under the word, and the remedy (style:
// one screenful).
// source_line may be empty.
std::string render(const Diagnosis& diagnosis, Dialect dialect, std::string_view source_line);

// A T, or the diagnosis that prevented it.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Diagnosis diagnosis) : state_(std::in_place_index<1>, std::move(diagnosis)) {}
    bool ok() const { return state_.index() == 0; }
    explicit operator bool() const { return ok(); }
    T& value() { return std::get<0>(state_); }
    const T& value() const { return std::get<0>(state_); }
    T& operator*() { return value(); }
    const T& operator*() const { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }
    const Diagnosis& diagnosis() const { return std::get<1>(state_); }
    Diagnosis& diagnosis() { return std::get<1>(state_); }

private:
    std::variant<T, Diagnosis> state_;
};

template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Diagnosis diagnosis) : diagnosis_(std::move(diagnosis)) {}
    bool ok() const { return !diagnosis_.has_value(); }
    explicit operator bool() const { return ok(); }
    const Diagnosis& diagnosis() const { return *diagnosis_; }
    Diagnosis& diagnosis() { return *diagnosis_; }

private:
    std::optional<Diagnosis> diagnosis_;
};

}  // namespace polyturn
