// PRGSSO: the spindle override of the program (fagor_8037t part 2, 11.2.10). Behind each command of
// a turning spindle goes one for the kernel only, with so much of the speed; events tell what is
// programmed.
#pragma once
#include "channels/forwarding_sink.hpp"

namespace polyturn::channels::fagor {

class SpindleOverride final : public ForwardingSink {
public:
    explicit SpindleOverride(Sink& next) : ForwardingSink(&next) {}

    void spindle(const Spindle& s, const BlockContext& at) override {
        next_->spindle(s, at);
        if (s.silent) return;
        last_ = s;
        if (factor_ != 1.0) tell(at);
    }
    // From here on, 1 is 100 %.
    void set(double factor, const BlockContext& at) {
        if (factor == factor_) return;
        factor_ = factor;
        tell(at);
    }

private:
    void tell(const BlockContext& at) {
        if (last_.turn == SpindleTurn::Stop ||
            (last_.mode != SpindleModeCode::Rpm && last_.mode != SpindleModeCode::SurfaceSpeed))
            return;
        Spindle scaled = last_;
        scaled.silent = true;
        scaled.value *= factor_;
        next_->spindle(scaled, at);
    }

    Spindle last_;
    double factor_ = 1.0;
};

}  // namespace polyturn::channels::fagor
