#include "channels/fagor/variables/coordinates.hpp"

#include "channels/engine/text_search.hpp"
#include "channels/fagor/execution.hpp"
#include "channels/fagor/flow/programs.hpp"
#include "channels/fagor/motion/lengths.hpp"
#include "channels/fagor/variables/named.hpp"

namespace polyturn::channels::fagor {
namespace {

// GPOSX N99 P100: what block 99 of program 100 programs for X; 100000 where it does not name it.
Access block_position(Execution& x, const Target& target, double& value) {
    const auto label = static_cast<std::int64_t>(target.index),
               program = static_cast<std::int64_t>(target.second);
    const auto file = find_program(x, program);
    const auto at = file ? find_label(x, *file, label) : std::nullopt;
    if (!at)
        return variable_fault(x, Alarm::FagorBlockUnknown,
                              "N" + std::to_string(label) + " P" + std::to_string(program));
    LineSource& source = x.programs.files.source(*file);
    const engine::KeepPosition keep(source);
    source.seek(*at);
    std::string_view line;
    Block block;
    Reader reader(x.parsers.values);
    value = 100'000.0;
    if (source.next(line) == LineSource::Status::Line && reader.read(line, block) == BlockKind::Iso)
        for (unsigned k = 0; k < block.count; ++k)
            if (block.words[k].letter == target.axis) value = block.words[k].value;
    return Access::Ok;
}

}  // namespace

Access read_coordinate(Execution& x, const Target& target, double& value) {
    if (target.row->var == Var::BlockPosition) return block_position(x, target, value);
    const int place = x.places.of(target.axis);
    const auto i = static_cast<unsigned>(place);
    const PathState& path = x.core.path;
    const unsigned machine_axis = x.core.view().axes[i].machine_axis;
    // The tool's tip in the machine, commanded and measured; a transformation stands between it and
    // the axes.
    // a probe's point, not the way of braking
    const bool touches = x.probe.moves_at_touch != 0 && x.probe.moves_at_touch == x.core.moves();
    const double commanded =
        x.core.machine_now(i) - path.vector[i] - (touches ? x.probe.braked_mm[i] : 0.0);
    const auto command = x.core.port().axis_command(machine_axis),
               measured = x.core.port().axis_measured(machine_axis);
    const double error = command && measured && !(touches && x.core.skip_moved() >> i & 1u)
                             ? *command - *measured
                             : 0.0;
    switch (target.row->var) {
        case Var::Programmed:
            value = from_length(x, x.core.framed(path.programmed)[i], place);
            return Access::Ok;
        case Var::Position:
            value = from_length(x, commanded - error, place);
            return Access::Ok;
        case Var::Theoretical:
            value = from_length(x, commanded, place);
            return Access::Ok;
        case Var::PartPosition:
            value = from_length(x, commanded - error - path.zero[i], place);
            return Access::Ok;
        case Var::PartTheoretical:
            value = from_length(x, commanded - path.zero[i], place);
            return Access::Ok;
        case Var::Lag:
            value = from_length_plain(x, error);
            return Access::Ok;
        default:
            value = from_length(x, commanded - path.zero[i], place);
            return Access::Ok;
    }
}

}  // namespace polyturn::channels::fagor
