// How a state of the machine is to be seen, before anybody has chosen a colour: the model says a tone
// and a sign, hmi/widgets paints them (colourOf, drawSign).
#pragma once
#include <QString>
#include <cstdint>

namespace polyturn::hmi {

enum class Tone : std::uint8_t {
    Good,     // it works, it may be used
    Waiting,  // for another channel
    Warning,  // it stands, it will soon be over
    Bad,      // it is broken, nothing goes on
    Note,     // done, or the operator's own
    Quiet,    // nothing is going on
    None,     // an empty place
};

enum class Sign : std::uint8_t {
    None,
    Run,
    Hold,
    Wait,
    Stop,
    Ended,
    Alarm,
    Warning,
    Note,
    Reset,
    Off,
    Good,
    Overview,
    Manual,
    Programs,
    Offsets,
    Tools,
    Parameters,
    Graphics,
    Bell,
    Left,
    Right,
    Up,
    Down,
    Lock,
    Sun,
    Moon,
    DisplayLanguage,
    Key,
    Spindle,
    Feed,
    Help,
    Diagnosis,
    Undo,
    Bin,
};

struct StateWords {
    QString text;
    Sign sign = Sign::None;
    Tone tone = Tone::None;
};

}  // namespace polyturn::hmi
