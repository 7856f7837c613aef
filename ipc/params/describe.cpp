// Words for people: `params get`, the manual.
#include <fmt/format.h>

#include <algorithm>

#include "ipc/params/limits_text.hpp"
#include "ipc/params/registry.hpp"
#include "ipc/params/translations.hpp"

namespace polyturn::params {

namespace {

// What is said of every row, in the languages that people read; the rows themselves are described
// by words_of.
struct Phrase {
    std::string_view english, russian, czech, hungarian;
};
constexpr Phrase kPhrases[] = {
    {"machine group", "на группу станка", "skupinu stroje", "gépcsoportonként"},
    {"channel", "на канал", "kanál", "csatornánként"},
    {"axis", "на ось", "osu", "tengelyenként"},
    {"spindle", "на шпиндель", "vřeteno", "főorsónként"},
    {"eight bits", "восемь битов", "osm bitů", "nyolc bit"},
    {"whole number", "целое число", "celé číslo", "egész szám"},
    {"number", "число", "číslo", "szám"},
    {"text", "текст", "text", "szöveg"},
    {"at the next tick", "со следующего такта", "od příštího taktu", "a következő ütemtől"},
    {"at the channel's next barrier", "со следующего останова чтения канала",
     "od příštího zastavení čtení kanálu", "a csatorna következő olvasási megállásától"},
    {"at the next start", "со следующего пуска", "od příštího spuštění", "a következő indítástól"},
    {"operator", "оператор", "obsluha", "kezelő"},
    {"setter", "наладчик", "seřizovač", "beállító"},
    {"machine builder", "изготовитель станка", "výrobce stroje", "gépgyártó"},
    {"yes", "да", "ano", "igen"},
    {"one of {}", "одно из: {}", "jedno z: {}", "ezek egyike: {}"},
    {"four numbers 0 to 255 with points between, or empty",
     "четыре числа от 0 до 255 через точки или пусто",
     "čtyři čísla 0 až 255 oddělená tečkami, nebo prázdné",
     "négy szám 0 és 255 között, pontokkal, vagy üres"},
    {"{} to {} characters", "от {} до {} знаков", "{} až {} znaků", "{}–{} karakter"},
    {"any", "любое", "libovolné", "bármi"},
    {"up to {}", "до {}", "nejvýše {}", "legfeljebb {}"},
    {"from {}", "от {}", "nejméně {}", "legalább {}"},
    {"{} to {}", "от {} до {}", "{} až {}", "{} … {}"},
    {"{:.0f} to {:.0f}", "от {:.0f} до {:.0f}", "{:.0f} až {:.0f}", "{:.0f} … {:.0f}"},
    {"  once per machine", "  один на станок", "  jednou na stroj", "  gépenként egyszer"},
    {"  once per {}, {}1 to {}{}", "  по одному {}, с {}1 по {}{}", "  jednou na {}, {}1 až {}{}",
     "  {} egyszer, {}1–{}{}"},
    {", [0] to [{}]", ", с [0] по [{}]", ", [0] až [{}]", ", [0] … [{}]"},
    {", in {}", ", единица {}", ", v {}", ", egység: {}"},
    {"; default \"{}\"\n", "; по умолчанию \"{}\"\n", "; výchozí \"{}\"\n",
     "; alapérték: \"{}\"\n"},
    {"; default {}\n", "; по умолчанию {}\n", "; výchozí {}\n", "; alapérték: {}\n"},
    {"  changed by: {}; takes effect {}\n", "  изменяет: {}; действует {}\n",
     "  mění: {}; platí {}\n", "  változtatja: {}; hat {}\n"},
    {"  acts: {}\n", "  действует: {}\n", "  působí: {}\n", "  hatása: {}\n"},
};

std::string_view say(std::string_view english, DisplayLanguage display_language) {
    if (display_language == DisplayLanguage::English) return english;
    const auto found =
        std::find_if(std::begin(kPhrases), std::end(kPhrases),
                     [&](const Phrase& phrase) { return phrase.english == english; });
    if (found == std::end(kPhrases)) return english;
    return display_language == DisplayLanguage::Russian ? found->russian
           : display_language == DisplayLanguage::Czech ? found->czech
                                                        : found->hungarian;
}

template <class... Values>
std::string told(std::string_view english, DisplayLanguage display_language,
                 const Values&... values) {
    return fmt::format(fmt::runtime(say(english, display_language)), values...);
}

}  // namespace

std::string_view to_string(Scope scope) noexcept {
    switch (scope) {
        case Scope::Group:
            return "machine group";
        case Scope::Channel:
            return "channel";
        case Scope::Axis:
            return "axis";
        case Scope::Spindle:
            return "spindle";
        case Scope::Global:
            break;
    }
    return "global";
}

std::string_view to_string(Type type) noexcept {
    switch (type) {
        case Type::Bits:
            return "eight bits";
        case Type::Int:
            return "whole number";
        case Type::Real:
            return "number";
        case Type::Text:
            break;
    }
    return "text";
}

std::string_view to_string(Effect effect) noexcept {
    switch (effect) {
        case Effect::Tick:
            return "at the next tick";
        case Effect::Barrier:
            return "at the channel's next barrier";
        case Effect::Restart:
            break;
    }
    return "at the next start";
}

std::string_view to_string(Protection protection) noexcept {
    switch (protection) {
        case Protection::Operator:
            return "operator";
        case Protection::Setter:
            return "setter";
        case Protection::Maker:
            break;
    }
    return "machine builder";
}

namespace {

std::string limits_in(const Row& row, DisplayLanguage display_language) {
    if (row.text_rule == TextRule::Choice)
        return told("one of {}", display_language, fmt::join(row.choices, ", "));
    if (row.text_rule == TextRule::Ipv4)
        return told("four numbers 0 to 255 with points between, or empty", display_language);
    if (row.type == Type::Text)
        return told("{} to {} characters", display_language, row.min, row.max);
    constexpr double kUnlimited = 1e307;  // the widest range that a row has stands for none
    if (row.min < -kUnlimited && row.max > kUnlimited) return told("any", display_language);
    if (row.min < -kUnlimited) return told("up to {}", display_language, row.max);
    if (row.max > kUnlimited) return told("from {}", display_language, row.min);
    return told(row.type == Type::Real ? "{} to {}" : "{:.0f} to {:.0f}", display_language, row.min,
                row.max);
}

}  // namespace

// a part of diagnoses, which logs have in English
std::string limits_text(const Row& row) { return limits_in(row, DisplayLanguage::English); }

std::string describe(const Row& row) {
    const DisplayLanguage display_language = display_language_now();
    const RowWords words = words_of(row, display_language);
    const char letter = scope_letter(row.scope);
    std::string out =
        fmt::format("{}  {}  ({})\n  {}\n", row.number, words.name, row.group, words.meaning);
    for (const Bit& bit : row.bits)
        out += fmt::format("  #{} {}: {}\n", bit.number, bit.name, words.bits[bit.number]);
    if (letter == '\0')
        out += told("  once per machine", display_language);
    else
        out +=
            told("  once per {}, {}1 to {}{}", display_language,
                 say(to_string(row.scope), display_language), letter, letter, instances(row.scope));
    if (row.array > 1) out += told(", [0] to [{}]", display_language, row.array - 1);
    out += fmt::format("; {}, {}", say(to_string(row.type), display_language),
                       limits_in(row, display_language));
    if (!row.unit.empty()) out += told(", in {}", display_language, row.unit);
    out += row.type == Type::Text
               ? told("; default \"{}\"\n", display_language, row.default_text)
               : told("; default {}\n", display_language, fmt::join(row.default_numbers, " "));
    out += told("  changed by: {}; takes effect {}\n", display_language,
                say(to_string(row.protection), display_language),
                say(to_string(row.effect), display_language));
    out += told("  acts: {}\n", display_language,
                row.acts == "yes" ? say("yes", display_language) : words.acts);
    return out;
}

}  // namespace polyturn::params
