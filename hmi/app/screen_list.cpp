// Which screens there are, in the order of Alt+1, Alt+2 ...
#include "hmi/app/main_window.hpp"
#include "hmi/screens/alarms.hpp"
#include "hmi/screens/overview.hpp"

namespace polyturn::hmi {

std::vector<Screen*> makeScreens(Desk& desk) { return {new Overview(desk), new Alarms(desk)}; }

}  // namespace polyturn::hmi
