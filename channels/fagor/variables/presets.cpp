#include "channels/fagor/variables/presets.hpp"

#include <cmath>
#include <utility>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/variables/named.hpp"

namespace polyturn::channels::fagor {

bool preset_variable(Execution& x, std::string_view name, double value) {
    const char* at = name.data();
    Target to;
    if (x.parsers.expression.target(at, name.data() + name.size(), to) != Expression::Status::Ok ||
        at != name.data() + name.size())
        return false;
    if (!to.row) {
        if (!Values::exists(to.number)) return false;
        x.values.parameter(to.number) = std::isnan(value) ? 0.0 : value;
        return true;
    }
    const bool fresh = std::exchange(x.run.fresh, true);
    const bool good = to.row->writable && write_named(x, to, value) == Access::Ok;
    x.run.fresh = fresh;
    return good;
}

}  // namespace polyturn::channels::fagor
