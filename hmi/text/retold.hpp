// Texts that the controller has reported with a number (an alarm of the log, a refusal, a fault of
// a check), in the language of the screens: its processes speak the machine's language, logs speak
// English.
#pragma once
#include <QString>

#include "ipc/model/files/builder_messages.hpp"

namespace polyturn::hmi {

struct RetoldWords {
    QString text, remedy;
    bool found = false;  // no row of that number reads so: the text is as it was
};
RetoldWords retold(const QString& number, const QString& text);
// As the control's manual writes it: 020, where a log has the number 20.
QString alarmNumberText(const QString& number);
// Those of the machine; without them those of the built-in PLC are known.
void knowBuilderMessages(text::BuilderMessages messages);

}  // namespace polyturn::hmi
