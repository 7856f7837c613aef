#include "hmi/text/tongues.hpp"

#include <QCoreApplication>
#include <QTranslator>
#include <memory>
#include <string>

static void takeWords() { Q_INIT_RESOURCE(words); }   // of a static library: nobody else would ask for them; not in a namespace

namespace polyturn::hmi {
namespace {

Tongue g_tongue = Tongue::English;
std::unique_ptr<QTranslator> g_words;

}  // namespace

const char* codeOf(Tongue tongue) {
    static constexpr const char* kCodes[] = {"en", "ru", "cs", "hu"};
    return kCodes[static_cast<std::size_t>(tongue)];
}

const char* nameOf(Tongue tongue) {
    static constexpr const char* kNames[] = {"English", "Русский", "Čeština", "Magyar"};
    return kNames[static_cast<std::size_t>(tongue)];
}

Tongue spoken() { return g_tongue; }

void speak(Tongue tongue) {
    if (g_words) QCoreApplication::removeTranslator(g_words.get());
    g_words.reset();
    g_tongue = tongue;
    choose_tongue(codeOf(tongue));
    if (tongue == Tongue::English) return;
    takeWords();
    g_words = std::make_unique<QTranslator>();
    if (g_words->load(QString(":/translations/polyturn_%1.qm").arg(codeOf(tongue)))) QCoreApplication::installTranslator(g_words.get());
}

QString word(const char* english) { return QCoreApplication::translate("hmi", english); }
QString word(std::string_view english) { return word(std::string(english).c_str()); }

}  // namespace polyturn::hmi
