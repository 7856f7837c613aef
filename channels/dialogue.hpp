// What a program asks the operator: a page with named values and soft keys. A language fills it,
// Stop carries it to the machine (StopReason::Dialogue); the channel is stopped there until a key
// is pressed, and the answers are read behind the barrier (Port::dialogue_answers).
#pragma once
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace polyturn::channels {

struct DialoguePage {
    struct Field {
        std::string name, variable;  // variable: as the language writes it; it takes the value
        double value = NAN;          // NaN: empty
    };
    std::string title;
    std::vector<Field> fields;       // 32 at the most
    std::vector<std::string> notes;  // 8 at the most
    // key k (from 1) is at k - 1; empty: no such key; 16 at the most
    std::vector<std::string> keys;
};

struct DialogueAnswers {
    int key = 0;  // 0: nobody has answered (check mode)
    // variable, value: in the order in which they were entered
    std::vector<std::pair<std::string, double>> values;
};

}  // namespace polyturn::channels
