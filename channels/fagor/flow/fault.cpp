#include "channels/fagor/flow/fault.hpp"

#include <utility>

#include "channels/engine/fault_place.hpp"
#include "channels/fagor/execution.hpp"
#include "channels/text/word_scanner.hpp"

namespace polyturn::channels::fagor {

Step fault_at(Execution& x, Alarm alarm, std::uint32_t column, std::uint32_t length,
              std::string detail, double v0, double v1) {
    Diagnosis diagnosis;
    diagnosis.alarm = alarm;
    diagnosis.place = {x.programs.files.path(x.calls.here().file),
                       x.line.fault.line ? x.line.fault.line : x.core.at.line,
                       column ? character_column(x.line.text, column) : 0, length};
    diagnosis.values = {v0, v1};
    diagnosis.detail = std::move(detail);
    return engine::report(x.core, x.run, diagnosis, x.core.at);
}

Step fault(Execution& x, Fault fault) {
    if (fault.block)
        return engine::report_elsewhere(x.core, x.run, x.programs.files, std::move(fault));
    std::uint32_t column = x.line.fault.column, length = x.line.fault.length;
    if (!column && fault.letter >= 'A' && fault.letter <= 'Z') {
        const Word* word = x.words.by_letter[static_cast<std::size_t>(fault.letter - 'A')];
        for (unsigned k = 0; !word && k < x.line.block.count; ++k)
            if (x.line.block.words[k].letter == fault.letter) word = &x.line.block.words[k];
        if (word) {
            column = word->column;
            length = word->length;
        }
    }
    return fault_at(x, fault.alarm, column, length, std::move(fault.detail), fault.value0,
                    fault.value1);
}

}  // namespace polyturn::channels::fagor
