// Which screens there are, in the order of Alt+1, Alt+2 ...
#include "hmi/app/main_window.hpp"
#include "hmi/screens/graphics/graphics.hpp"
#include "hmi/screens/machine/alarms.hpp"
#include "hmi/screens/machine/diagnosis.hpp"
#include "hmi/screens/machine/parameters.hpp"
#include "hmi/screens/machine/system.hpp"
#include "hmi/screens/overview/manual.hpp"
#include "hmi/screens/overview/overview.hpp"
#include "hmi/screens/programs/programs.hpp"
#include "hmi/screens/tools/offsets.hpp"
#include "hmi/screens/tools/tools.hpp"

namespace polyturn::hmi {

std::vector<Screen*> makeScreens(Context& context) {
    return {new Overview(context), new Manual(context), new Programs(context),
            new Offsets(context),  new Tools(context),  new Parameters(context),
            new Graphics(context), new Alarms(context), new Diagnosis(context),
            new System(context)};
}

}  // namespace polyturn::hmi
