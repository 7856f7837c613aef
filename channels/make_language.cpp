#include "channels/fagor/interpreter.hpp"
#include "channels/fanuc/interpreter.hpp"
#include "channels/language.hpp"
#include "channels/mefi/settings.hpp"
#include "channels/nct/settings.hpp"
#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels {

Dialect dialect_of(std::string_view language) {
    if (language == "nct") return Dialect::Nct;
    if (language == "fagor") return Dialect::Fagor;
    if (language == "sinumerik") return Dialect::Sinumerik;
    if (language == "mefi") return Dialect::Mefi;
    return Dialect::Fanuc;
}


std::unique_ptr<Language> make_fanuc(MachineView& view, Sink& sink, Port& port, ProgramFiles& files) {
    fanuc::fanuc_axes(view);
    return std::make_unique<fanuc::Interpreter>(view, sink, port, files, &fanuc::fanuc_settings);
}

std::unique_ptr<Language> make_nct(MachineView& view, Sink& sink, Port& port, ProgramFiles& files) {
    return std::make_unique<fanuc::Interpreter>(view, sink, port, files, &nct::nct_settings);
}

std::unique_ptr<Language> make_sinumerik(MachineView& view, Sink& sink, Port& port, ProgramFiles& files) {
    return std::make_unique<sinumerik::Interpreter>(view, sink, port, files);
}

std::unique_ptr<Language> make_fagor(MachineView& view, Sink& sink, Port& port, ProgramFiles& files) {
    fagor::prepare_axes(view);
    return std::make_unique<fagor::Interpreter>(view, sink, port, files);
}

std::unique_ptr<Language> make_language(std::string_view name, MachineView& view, Sink& sink, Port& port, ProgramFiles& files) {
    if (name == "fanuc") return make_fanuc(view, sink, port, files);
    if (name == "nct") return make_nct(view, sink, port, files);
    if (name == "mefi") return std::make_unique<fanuc::Interpreter>(view, sink, port, files, &mefi::mefi_settings);
    if (name == "sinumerik") return make_sinumerik(view, sink, port, files);
    if (name == "fagor") return make_fagor(view, sink, port, files);
    return nullptr;
}

}  // namespace polyturn::channels
