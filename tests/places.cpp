#include "tests/places.hpp"

const char* const kSourceFolder = POLYTURN_SOURCE_DIR;
const char* const kProgramFolder = POLYTURN_BIN_DIR;
