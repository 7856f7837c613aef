// What held before a block: see resume.cpp and interrupts.cpp.
#pragma once
#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {

template <class... Types>
std::tuple<Types...> values_of(std::tuple<Types&...> references) {
    return references;
}

struct Interpreter::ResumeState {
    PathState path;
    decltype(values_of(std::declval<Interpreter&>().modal())) modal;
    std::vector<CallLevel> frames;
    std::vector<Loop> loops;
    std::vector<ModalCall> modal_calls;
    std::vector<LocalSet> levels;
    // not modal: what an interrupt program has turned stays, an M19 or M3 that is void again has
    // turned nothing
    decltype(Interpreter::turned_) turned;
};

}  // namespace polyturn::channels::fanuc
