#include "hmi/text/retold.hpp"

#include <algorithm>

#include "hmi/text/display_languages.hpp"
#include "ipc/requests/start_words.hpp"

namespace polyturn::hmi {

namespace {

text::BuilderMessages& builderMessages() {
    static text::BuilderMessages known;
    return known;
}

// The kernel lists what a start still needs in English; its words are those of the cards.
QString startWordsIn(QString text) {
    for (const StartWords& row : kStartWords)
        for (const std::string_view words : {row.text, row.remedy})
            text.replace(fromView(words), word(words));
    return text;
}

}  // namespace

void knowBuilderMessages(text::BuilderMessages messages) {
    builderMessages() = std::move(messages);
}

QString alarmNumberText(const QString& number) {
    return !number.isEmpty() && number.size() < 3 &&
                   std::all_of(number.begin(), number.end(), [](QChar c) { return c.isDigit(); })
               ? number.rightJustified(3, '0')
               : number;
}

RetoldWords retold(const QString& number, const QString& text) {
    if (number.isEmpty()) return {text, {}, false};
    std::string told = text.toStdString();
    // logs have numbers, tables have texts: 020
    const std::string plain = number.toStdString(), padded = alarmNumberText(number).toStdString();
    if (plain == alarm_number(Alarm::BuilderMessage, Dialect::Polyturn) ||
        plain == alarm_number(Alarm::BuilderNote, Dialect::Polyturn))
        told = builderMessages().told_in(std::move(told),
                                         static_cast<text::MessageLanguage>(spoken()));
    for (const Dialect dialect : {Dialect::Polyturn, Dialect::Fanuc, Dialect::Nct, Dialect::Fagor,
                                  Dialect::Sinumerik, Dialect::Mefi})
        for (const std::string& written : {plain, padded})
            if (const auto found = retell(written, dialect, told, spoken())) {
                const QString in = QString::fromStdString(found->text);
                return {plain == alarm_number(Alarm::NotReady, Dialect::Polyturn) ? startWordsIn(in)
                                                                                  : in,
                        fromView(found->remedy), true};
            }
    return {text, {}, false};
}

}  // namespace polyturn::hmi
