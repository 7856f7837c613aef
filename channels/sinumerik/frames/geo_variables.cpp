// System variables of the geometry: $P_PFRAME and its components, $P_WORKAREA_CS_..., poles and
// radii that are read by name.
#include "channels/sinumerik/frames/geo_variables.hpp"

#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/frames/geo_frames.hpp"
#include "channels/sinumerik/frames/settable_frames.hpp"
#include "channels/sinumerik/geometry/units.hpp"
#include "channels/sinumerik/variables/changes.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr std::string_view kArea = "$P_WORKAREA_CS_";

}  // namespace

// TR coarse, FI fine translation, RT rotation, SC scale; MI is a bit. Behind the places of the
// axes: those that the channel does not have, which know a rotation only.
double& frame_part(FrameValue& frame, std::size_t place, const std::string& part, bool& known) {
    static double nothing = 0.0;
    known = true;
    if (part == "RT" && place >= kChannelAxes) return frame.absent_deg[place - kChannelAxes];
    if (place >= kChannelAxes) {
        known = false;
        return nothing;
    }
    if (part == "TR") return frame.coarse_mm[place];
    if (part == "FI") return frame.fine_mm[place];
    if (part == "RT") return frame.rotation_deg[place];
    if (part == "SC") return frame.scale[place];
    known = false;
    return nothing;
}

bool geometry_value(Execution& x, const std::string& name, const std::vector<Value>& indices,
                    Value& value, bool& known) {
    if (!outer_frame_value(x, name, indices, value, known)) return false;
    if (known) return true;
    known = true;
    GeoModal& geo = x.modal.geo;
    if (name == "$P_APDV") {
        value = Value::of_bool(geo.approach_known);
        return true;
    }
    if (name == "$P_APR" || name == "$P_AEP") {
        const int place =
            indices.size() == 1 && indices[0].type == Type::Axis ? indices[0].place() : -1;
        if (place < 0 || place >= static_cast<int>(x.core.view().axis_count))
            return fail(x, Alarm::AxisArgumentMissing, name);
        const auto i = static_cast<std::size_t>(place);
        const double mm = (name == "$P_APR" ? geo.approach_start : geo.approach_end)[i] *
                          (counts_diameter(x, static_cast<unsigned>(i), false) ? 2.0 : 1.0);
        value = Value::of_real(x.core.view().axes[i].rotary ? mm : mm / unit(x));
        return true;
    }
    if (name == "$P_PFRAME" || name == "$P_ACTFRAME") {
        return frame_component(x, name, geo.frame, indices, 0, value);
    }
    if (name.starts_with(kArea)) {
        const std::string part = name.substr(kArea.size());
        const double g = indices.empty() ? -1 : indices[0].number;
        if (!(g >= 0 && g <= 9)) return fail(x, Alarm::ArrayIndexIllegal, name, g);
        const AreaGroup& area = geo.areas[static_cast<std::size_t>(g)];
        if (part == "COORD_SYSTEM") {
            value = Value::of_int(area.workpiece ? 1 : 3);
            return true;
        }
        const int place =
            indices.size() == 2 && indices[1].type == Type::Axis ? indices[1].place() : -1;
        if (place < 0 || place >= static_cast<int>(x.core.view().axis_count))
            return fail(x, Alarm::AxisArgumentMissing, name);
        const auto i = static_cast<std::size_t>(place);
        if (part == "PLUS_ENABLE") {
            value = Value::of_bool(area.plus >> i & 1u);
            return true;
        }
        if (part == "MINUS_ENABLE") {
            value = Value::of_bool(area.minus >> i & 1u);
            return true;
        }
        if (part == "LIMIT_PLUS") {
            value = Value::of_real(area.high[i]);
            return true;
        }
        if (part == "LIMIT_MINUS") {
            value = Value::of_real(area.low[i]);
            return true;
        }
    }
    known = false;
    return true;
}

// Acts at once, in the order of the text; a block that has to wait for a barrier puts it back.
bool write_geometry(Execution& x, const std::string& name, const std::vector<Value>& indices,
                    const Value& value, bool& known) {
    if (!write_outer_frame(x, name, indices, value, known)) return false;
    if (known) return true;
    known = true;
    GeoModal& geo = x.modal.geo;
    if (name == "$P_PFRAME") {
        FrameValue frame = geo.frame;
        if (!change_frame_component(x, name, frame, indices, 0, value)) return false;
        const GeoModal before = geo;
        const AxisValues pending = x.modal.pending_zero;
        if (!set_programmable_frame(x, frame)) return false;
        undo(x, [&x, before, pending] {
            x.modal.geo.frame = before.frame;
            x.modal.geo.exact = before.exact;
            x.core.set_frame(outer_frame(x) * before.exact);
            x.modal.pending_zero = pending;
        });
        return true;
    }
    if (name.starts_with(kArea)) {
        const std::string part = name.substr(kArea.size());
        const double g = indices.empty() ? -1 : indices[0].number;
        if (!(g >= 0 && g <= 9)) return fail(x, Alarm::ArrayIndexIllegal, name, g);
        AreaGroup& area = geo.areas[static_cast<std::size_t>(g)];
        undo(x,
             [&x, g, before = area] { x.modal.geo.areas[static_cast<std::size_t>(g)] = before; });
        if (part == "COORD_SYSTEM") {
            if (value.number != 1 && value.number != 3)
                return fail(x, Alarm::ValueOutOfRange, name, value.number);
            area.workpiece = value.number == 1;
            return true;
        }
        const int place =
            indices.size() == 2 && indices[1].type == Type::Axis ? indices[1].place() : -1;
        if (place < 0 || place >= static_cast<int>(x.core.view().axis_count))
            return fail(x, Alarm::AxisArgumentMissing, name);
        const auto i = static_cast<std::size_t>(place);
        const AxisSet bit = 1u << i;
        if (part == "PLUS_ENABLE") {
            area.plus = value.is_true() ? area.plus | bit : area.plus & ~bit;
            return true;
        }
        if (part == "MINUS_ENABLE") {
            area.minus = value.is_true() ? area.minus | bit : area.minus & ~bit;
            return true;
        }
        if (part == "LIMIT_PLUS") {
            area.high[i] = value.number;
            return true;
        }
        if (part == "LIMIT_MINUS") {
            area.low[i] = value.number;
            return true;
        }
    }
    known = false;
    return true;
}

}  // namespace polyturn::channels::sinumerik
