// Which screens there are, in the order of Alt+1, Alt+2 ...
#include "hmi/app/main_window.hpp"
#include "hmi/screens/alarms.hpp"
#include "hmi/screens/diagnosis.hpp"
#include "hmi/screens/graphics.hpp"
#include "hmi/screens/manual.hpp"
#include "hmi/screens/offsets.hpp"
#include "hmi/screens/overview.hpp"
#include "hmi/screens/parameters.hpp"
#include "hmi/screens/programs.hpp"
#include "hmi/screens/system.hpp"
#include "hmi/screens/tools.hpp"

namespace polyturn::hmi {

std::vector<Screen*> makeScreens(Desk& desk) { return {new Overview(desk), new Manual(desk), new Programs(desk), new Offsets(desk), new Tools(desk), new Parameters(desk), new Graphics(desk), new Alarms(desk), new Diagnosis(desk), new System(desk)}; }

}  // namespace polyturn::hmi
