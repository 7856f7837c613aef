// Verbs that ask a running controller: press, set, release, status, alarms; and clean.
#pragma once
#include <string>
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/files/builder_messages.hpp"
#include "kernel/supervisor/base/options.hpp"

namespace polyturn::supervisor {
int press_words(const CommandLine& line);  // press, set, release
int show_status(const CommandLine& line);
int show_alarms(const CommandLine& line);
int clean_up();
void print(std::string_view words);  // on stdout
// Tells on stderr what was wrong with a command line; the exit code of one that was refused.
int refuse(const Diagnosis& diagnosis);
// Sends a request (JSON) and reads the answer; false when it was refused, then the reason is on
// stderr.
bool ask(const std::string& instance, const std::string& request, std::string* answer = nullptr);
// Those of the machine of a running controller.
text::BuilderMessages builder_messages(const std::string& instance);
// The text of an alarm, given in English or the controller's language, in the language of this
// process; lists do not say whose numbers they speak.
std::string told(const std::string& number, std::string english,
                 const text::BuilderMessages& messages);
}  // namespace polyturn::supervisor
