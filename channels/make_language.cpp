#include "channels/balance_sink.hpp"
#include "channels/fagor/interpreter.hpp"
#include "channels/fanuc/interpreter.hpp"
#include "channels/fanuc/motion/angular_axis.hpp"
#include "channels/language.hpp"
#include "channels/mefi/settings.hpp"
#include "channels/nct/settings.hpp"
#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels {

namespace {

// The interpreter behind a machine whose X slide is inclined.
struct AngularWorld {
    AngularWorld(MachineView& view, Sink& sink, Port& port, const AngularAxes& axes)
        : sink_of(sink, port, view, axes), port_of(port, view, axes) {}
    fanuc::AngularSink sink_of;
    fanuc::AngularPort port_of;
};
class AngularInterpreter final : private AngularWorld, public fanuc::Interpreter {
public:
    AngularInterpreter(MachineView& view, Sink& sink, Port& port, ProgramFiles& files,
                       const AngularAxes& axes, bool usable)
        : AngularWorld(view, sink, port, axes),
          fanuc::Interpreter(view, sink_of, port_of, files, &fanuc::fanuc_settings),
          view_(&view),
          machine_(&port),
          axes_(axes),
          usable_(usable) {}
    Result<void> start(FileId main) override {
        if (!usable_) return Diagnosis{Alarm::AngularAngle, {}, {}, {}};
        look_at_correction();
        return fanuc::Interpreter::start(main);
    }
    void barrier_done() override {
        look_at_correction();
        fanuc::Interpreter::barrier_done();
    }

private:
    // NOZAGC (fanuc_lathe 10.5): Z keeps what it has been moved by until now; switched off again, Z
    // is where both slides stand.
    void look_at_correction() {
        if (!axes_.on || machine_->angular_correction_off() == axes_.uncorrected) return;
        axes_.uncorrected = !axes_.uncorrected;
        axes_.kept =
            axes_.uncorrected
                ? axes_.x_of(machine_->axis_command(view_->axes[axes_.angular].machine_axis)
                                 .value_or(0.0)) *
                      axes_.tangent
                : 0.0;
        sink_of.follow(axes_);
        port_of.follow(axes_);
    }
    const MachineView* view_;
    Port* machine_;
    AngularAxes axes_;
    bool usable_;
};

// One that may cut in balance with another channel.
struct BalanceWorld {
    explicit BalanceWorld(Sink& sink) : balance_of(sink) {}
    BalanceSink balance_of;
};
class BalanceInterpreter final : private BalanceWorld, public fanuc::Interpreter {
public:
    BalanceInterpreter(MachineView& view, Sink& sink, Port& port, ProgramFiles& files)
        : BalanceWorld(sink),
          fanuc::Interpreter(view, balance_of, port, files, &fanuc::fanuc_settings) {
        balance_of.between(view.channel, static_cast<unsigned>(params::get(
                                             view.table(), params::pt_balance, view.channel)));
    }
    Result<void> start(FileId main) override {
        balance_of.restart();
        return fanuc::Interpreter::start(main);
    }
};

}  // namespace

std::unique_ptr<Language> make_fanuc(MachineView& view, Sink& sink, Port& port,
                                     ProgramFiles& files) {
    const unsigned own = view.axis_count;
    fanuc::fanuc_axes(view);
    for (unsigned i = own; i < view.axis_count; ++i)
        view.start[i] = port.axis_command(view.axes[i].machine_axis).value_or(0.0);
    bool usable = true;
    const AngularAxes angular = fanuc::angular_axes(view, usable);
    if (angular.on || !usable)
        return std::make_unique<AngularInterpreter>(view, sink, port, files, angular, usable);
    if (params::get(view.table(), params::pt_balance, view.channel) != 0)
        return std::make_unique<BalanceInterpreter>(view, sink, port, files);
    return std::make_unique<fanuc::Interpreter>(view, sink, port, files, &fanuc::fanuc_settings);
}

std::unique_ptr<Language> make_nct(MachineView& view, Sink& sink, Port& port, ProgramFiles& files) {
    return std::make_unique<fanuc::Interpreter>(view, sink, port, files, &nct::nct_settings);
}

std::unique_ptr<Language> make_sinumerik(MachineView& view, Sink& sink, Port& port,
                                         ProgramFiles& files) {
    return std::make_unique<sinumerik::Interpreter>(view, sink, port, files);
}

std::unique_ptr<Language> make_fagor(MachineView& view, Sink& sink, Port& port,
                                     ProgramFiles& files) {
    fagor::prepare_axes(view);
    return std::make_unique<fagor::Interpreter>(view, sink, port, files);
}

std::unique_ptr<Language> make_language(std::string_view name, MachineView& view, Sink& sink,
                                        Port& port, ProgramFiles& files) {
    if (name == "fanuc") return make_fanuc(view, sink, port, files);
    if (name == "nct") return make_nct(view, sink, port, files);
    if (name == "mefi")
        return std::make_unique<fanuc::Interpreter>(view, sink, port, files, &mefi::mefi_settings);
    if (name == "sinumerik") return make_sinumerik(view, sink, port, files);
    if (name == "fagor") return make_fagor(view, sink, port, files);
    return nullptr;
}

}  // namespace polyturn::channels
