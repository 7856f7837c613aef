#include "hmi/text/retold.hpp"

#include "hmi/text/tongues.hpp"

namespace polyturn::hmi {

RetoldWords retold(const QString& number, const QString& text) {
    if (number.isEmpty()) return {text, {}, false};
    const std::string told = text.toStdString(), plain = number.toStdString();
    const std::string padded = plain.size() < 3 ? std::string(3 - plain.size(), '0') + plain : plain;   // logs have numbers, tables have texts: 020
    for (const Dialect dialect : {Dialect::Polyturn, Dialect::Fanuc, Dialect::Nct, Dialect::Fagor, Dialect::Sinumerik, Dialect::Mefi})
        for (const std::string& written : {plain, padded})
            if (const auto found = retell(written, dialect, told, spoken())) return {QString::fromStdString(found->text), fromView(found->remedy), true};
    return {text, {}, false};
}

}  // namespace polyturn::hmi
