// Variables of the language: R parameters, what DEF declares, parameters of subprograms.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "channels/sinumerik/grammar/value.hpp"

namespace polyturn::channels::sinumerik {

// A scalar is an array of one element. Several names (VAR parameters) may share one store.
struct Variable {
    Type type = Type::Real;
    std::vector<unsigned> dimensions;  // empty: scalar; at most three
    std::size_t text_length = 200;     // STRING[n]
    bool has_lower = false, has_upper = false;
    double lower = 0.0, upper = 0.0;  // LLI, ULI
    int unit = 0;                     // PHU
    std::vector<Value> defaults;      // what DEF gave it, where it gave something
    std::vector<Value> cells;
    std::string name;  // as declared, capital letters
};

// One element of a variable: what is to the left of =, and what a VAR parameter refers to.
struct Reference {
    std::shared_ptr<Variable> variable;
    std::size_t element = 0;
    // an array without its indices: a VAR parameter takes all of it
    bool whole = false;
    // of a frame variable: the axis and the part (TR FI RT SC MI) that are meant
    std::vector<Value> component{};
    explicit operator bool() const { return variable != nullptr; }
    Value& cell() const { return variable->cells[element]; }
};

// The names of one program level.
struct Scope {
    std::map<std::string, Reference, std::less<>> names;
};

}  // namespace polyturn::channels::sinumerik
