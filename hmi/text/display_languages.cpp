#include "hmi/text/display_languages.hpp"

#include <QCoreApplication>
#include <QTranslator>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>

// of a static library: nobody else would ask for them; not in a namespace
static void takeWords() { Q_INIT_RESOURCE(words); }

namespace polyturn::hmi {
namespace {

DisplayLanguage g_display_language = DisplayLanguage::English;
std::unique_ptr<QTranslator> g_words;
std::unordered_map<const char*, QString> g_known;
std::map<std::string, QString, std::less<>> g_units;

}  // namespace

const char* codeOf(DisplayLanguage display_language) {
    static constexpr const char* kCodes[] = {"en", "ru", "cs", "hu"};
    return kCodes[static_cast<std::size_t>(display_language)];
}

const char* nameOf(DisplayLanguage display_language) {
    static constexpr const char* kNames[] = {"English", "Русский", "Čeština", "Magyar"};
    return kNames[static_cast<std::size_t>(display_language)];
}

DisplayLanguage spoken() { return g_display_language; }

void speak(DisplayLanguage display_language) {
    if (g_words) QCoreApplication::removeTranslator(g_words.get());
    g_words.reset();
    g_known.clear();
    g_units.clear();
    g_display_language = display_language;
    choose_display_language(codeOf(display_language));
    if (display_language == DisplayLanguage::English) return;
    takeWords();
    g_words = std::make_unique<QTranslator>();
    if (g_words->load(QString(":/translations/polyturn_%1.qm").arg(codeOf(display_language))))
        QCoreApplication::installTranslator(g_words.get());
}

// A literal does not move in memory: it is looked up once in each language, then found by its
// address.
QString word(const char* english) {
    const auto at = g_known.find(english);
    return at != g_known.end()
               ? at->second
               : g_known.emplace(english, QCoreApplication::translate("hmi", english))
                     .first->second;
}
// Units of parameters.csv are collected with its groups; these stand elsewhere too, or only there.
[[maybe_unused]] constexpr const char* kUnits[] = {
    WORD("mm"),   WORD("mm/min"), WORD("mm/rev"), WORD("m/min"), WORD("1/min"),
    WORD("mm/s"), WORD("ms"),     WORD("s"),      WORD("min"),   WORD("kB"),
    WORD("us"),   WORD("µm"),     WORD("mm/s2"),  WORD("mm/s3")};

QString unitWord(std::string_view unit) {
    if (unit.empty()) return {};
    const auto at = g_units.find(unit);
    if (at != g_units.end()) return at->second;
    QString shown = word(unit);
    // The table of parameters writes plain letters; in English the other languages' signs are used
    // as well.
    if (spoken() == DisplayLanguage::English) {
        if (shown == "us") shown = QString::fromUtf8("µs");
        if (shown.startsWith("deg")) shown.replace(0, 3, QString::fromUtf8("°"));
        if (shown.endsWith("/s2")) shown.replace(shown.size() - 1, 1, QString::fromUtf8("²"));
    }
    return g_units.emplace(std::string(unit), shown).first->second;
}

QString word(std::string_view english) {
    return QCoreApplication::translate("hmi", std::string(english).c_str());
}

}  // namespace polyturn::hmi
