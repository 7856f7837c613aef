// Where the sources lie and where the programs are built, for tests that read examples or start
// programs. Only places.cpp knows the folders when it is compiled: with their names among
// everyone's definitions, a clone at another place could share no compiled test.
#pragma once

extern const char* const kSourceFolder;  // absolute, no slash at its end
extern const char* const kProgramFolder;
