#include "kernel/supervisor/press/phrases.hpp"

#include <algorithm>
#include <array>

#include "ipc/diagnosis/display_language.hpp"

namespace polyturn::supervisor {

namespace {

constexpr auto kPhrases = std::to_array<Phrase>({
    // report of a run
    {"the run", "прогон", "běh", "a futás"},
    {"channel", "канал", "kanál", "csatorna"},
    {"channel {}", "канал {}", "kanál {}", "{}. csatorna"},
    {"cycle", "цикл", "cyklus", "ciklus"},
    {"cutting", "резание", "řezání", "forgácsolás"},
    {"rapid", "ускор.", "rychlop.", "gyorsmenet"},
    {"waiting", "ожидание", "čekání", "várakozás"},
    {"other", "прочее", "ostatní", "egyéb"},
    {"line {}", "строка {}", "řádek {}", "{}. sor"},
    {"lines {} to {}", "строки {}–{}", "řádky {} až {}", "{}–{}. sor"},
    {"One turret after the other would take {:.1f} s; working at once they save {:.1f} s ({:.0f} "
     "%).",
     "Револьверные головки по очереди заняли бы {:.1f} с; одновременная работа экономит {:.1f} с "
     "({:.0f} %).",
     "Hlavy po sobě by potřebovaly {:.1f} s; současnou prací se ušetří {:.1f} s ({:.0f} %).",
     "Egymás után a revolverfejek {:.1f} s-ig dolgoznának; egyszerre dolgozva {:.1f} s-ot "
     "takarítanak meg ({:.0f} %)."},
    {"Who waited", "Кто ждал", "Kdo čekal", "Ki várt"},
    {"at", "на", "na", "itt:"},
    {"for L{}", "ждал L{}", "na L{}", "L{}-re"},
    {"(nobody came)", "(никто не пришёл)", "(nikdo nepřišel)", "(senki sem jött)"},
    {"and {} shorter ones, {:.2f} s together", "и ещё {} более коротких, вместе {:.2f} с",
     "a {} kratších, dohromady {:.2f} s", "és {} rövidebb, együtt {:.2f} s"},
    {"Which cut to move", "Какой проход перенести", "Který řez přesunout",
     "Melyik fogást érdemes áttenni"},
    {"{} {} of L{} ({:.1f} s{}): L{} waits {:.1f} s for it at {}. Given to L{} it saves up to "
     "{:.1f} s.",
     "{} {}, L{} ({:.1f} с{}): L{} ждёт этого {:.1f} с на {}. Переданный в L{}, он экономит до "
     "{:.1f} с.",
     "{} {}, L{} ({:.1f} s{}): L{} na to čeká {:.1f} s u {}. Předáno kanálu L{} ušetří "
     "až {:.1f} s.",
     "{} {}, L{} ({:.1f} s{}): L{} {:.1f} s-ot vár rá itt: {}. L{} csatornára téve akár {:.1f} "
     "s-ot takarít meg."},
    // dialogues
    {"No program asks anything.\n", "Ни одна программа ничего не спрашивает.\n",
     "Žádný program se na nic neptá.\n", "Egy program sem kérdez semmit.\n"},
    // status
    {"{}: machine {}, {:.1f} s, {} alarms\n", "{}: станок {}, {:.1f} с, аварий {}\n",
     "{}: stroj {}, {:.1f} s, poruch {}\n", "{}: gép {}, {:.1f} s, {} hiba\n"},
    {"no program", "нет программы", "bez programu", "nincs program"},
    {"the job is for the machine {}, and this controller runs {}",
     "задание для станка {}, а этот контроллер ведёт {}",
     "zakázka je pro stroj {}, a tento řadič řídí {}",
     "a munka a(z) {} géphez való, ez a vezérlő a(z) {} gépet hajtja"},
    {"the job has {} = {:.4f}, entered is {:.4f}, and that holds",
     "в задании {} = {:.4f}, введено {:.4f}, и действует введённое",
     "zakázka má {} = {:.4f}, zadáno je {:.4f}, a to platí",
     "a munkában {} = {:.4f}, beírva {:.4f}, és a beírt érvényes"},
    {"L{}: other offsets than in the job's setup are entered, and those hold: {}",
     "L{}: введены не те корректоры, что в наладке задания, и действуют введённые: {}",
     "L{}: zadány jsou jiné korekce než v seřízení zakázky, a ty platí: {}",
     "L{}: más korrekciók vannak beírva, mint a munka beállításában, és a beírtak érvényesek: {}"},
    {"the job has {} = {:.4f}, which this machine does not have",
     "в задании {} = {:.4f}, у этого станка такого нет",
     "zakázka má {} = {:.4f}, tento stroj to nemá",
     "a munkában {} = {:.4f}, ennek a gépnek nincs ilyen"},
    {"{}: {:.4f}, which this machine does not have\n", "{}: {:.4f}, у этого станка такого нет\n",
     "{}: {:.4f}, tento stroj to nemá\n", "{}: {:.4f}, ennek a gépnek nincs ilyen\n"},
    {"The zeros and offsets of the job are entered.\n",
     "Нулевые точки и корректоры задания введены.\n",
     "Nulové body a korekce zakázky jsou zadány.\n",
     "A munka nullpontjai és korrekciói be vannak írva.\n"},
    {"polyturn: all drives are simulated: a late tick stops nothing (PT_LATE_MAX=1000).\n",
     "polyturn: все приводы смоделированы: опоздавший такт ничего не останавливает "
     "(PT_LATE_MAX=1000).\n",
     "polyturn: všechny pohony jsou simulované: opožděný takt nic nezastaví (PT_LATE_MAX=1000).\n",
     "polyturn: minden hajtás szimulált: késő ütem semmit sem állít le (PT_LATE_MAX=1000).\n"},
    {"   waits at {}", "   ждёт на {}", "   čeká na {}", "   vár itt: {}"},
    {"not referenced ", "без референта ", "bez reference ", "nem referált "},
    {"moves ", "движется ", "v pohybu ", "mozog "},
    {"drive fault", "отказ привода", "porucha pohonu", "hajtáshiba"},
    {"  processes:", "  процессы:", "  procesy:", "  folyamatok:"},
    {"absent", "нет", "není", "nincs"},
    {"reset", "сброс", "reset", "alaphelyzet"},
    {"running", "работает", "běží", "fut"},
    {"held", "пауза", "pozastaven", "felfüggesztve"},
    {"waits", "ждёт", "čeká", "vár"},
    {"program_stop", "стоп прогр.", "stop progr.", "programstop"},
    {"ended", "окончен", "ukončen", "vége"},
    {"interrupted", "прерван", "přerušen", "megszakítva"},
    {"dead", "не отвечает", "neodpovídá", "leállt"},
    {"on", "включён", "zapnut", "bekapcsolva"},
    {"off", "выключен", "vypnut", "kikapcsolva"},
    {"emergency_stop", "аварийный останов", "nouzové zastavení", "vészleállítás"},
    {"No controller runs here.\n", "Здесь не работает ни одна система ЧПУ.\n",
     "Neběží zde žádný řídicí systém.\n", "Itt nem fut vezérlés.\n"},
    {"No alarms.\n", "Аварий нет.\n", "Žádné poruchy.\n", "Nincs hiba.\n"},
    {"message", "сообщение", "hlášení", "üzenet"},
    {"removed {}\n", "удалено: {}\n", "odstraněno: {}\n", "törölve: {}\n"},
    {"Nothing to remove.\n", "Удалять нечего.\n", "Není co odstranit.\n", "Nincs mit törölni.\n"},
    // start
    {"polyturn: the controller \"{}\" runs with {} channels, {} axes, {} spindles. End it with "
     "Ctrl-C or SIGTERM.\n",
     "polyturn: система «{}» работает: каналов {}, осей {}, шпинделей {}. Завершение: Ctrl-C или "
     "SIGTERM.\n",
     "polyturn: systém „{}“ běží: kanálů {}, os {}, vřeten {}. Ukončení: Ctrl-C nebo SIGTERM.\n",
     "polyturn: a(z) „{}” vezérlés fut: {} csatorna, {} tengely, {} főorsó. Leállítás: Ctrl-C "
     "vagy SIGTERM.\n"},
    {"polyturn: the controller \"{}\" has ended.\n", "polyturn: система «{}» завершена.\n",
     "polyturn: systém „{}“ skončil.\n", "polyturn: a(z) „{}” vezérlés leállt.\n"},
    {"polyturn: {} has died {} times in {} s and stays dead.\n",
     "polyturn: {}: завершался аварийно {} раз за {} с и больше не запускается.\n",
     "polyturn: {} spadl {}krát za {} s a zůstává vypnut.\n",
     "polyturn: {} {} alkalommal állt le {} s alatt, és nem indul újra.\n"},
    // parameters
    {"polyturn: say --instance NAME (a running controller) or --machine FILE (a machine's file)\n",
     "polyturn: укажите --instance ИМЯ (работающая система) или --machine ФАЙЛ (файл станка)\n",
     "polyturn: zadejte --instance JMÉNO (běžící systém) nebo --machine SOUBOR (soubor stroje)\n",
     "polyturn: adja meg: --instance NÉV (futó vezérlés) vagy --machine FÁJL (a gép fájlja)\n"},
    {"polyturn: a compensation table is imported with --machine FILE, or with --instance NAME "
     "into a controller that runs a machine\n",
     "polyturn: таблица компенсации импортируется с --machine ФАЙЛ или с --instance ИМЯ в "
     "систему, на которой работает станок\n",
     "polyturn: kompenzační tabulka se importuje s --machine SOUBOR, nebo s --instance JMÉNO "
     "do systému, na kterém běží stroj\n",
     "polyturn: a kompenzációs táblázat --machine FÁJL megadásával vagy --instance NÉV "
     "megadásával egy gépet futtató vezérlésbe olvasható be\n"},
    {"{}: acts as soon as the axes rest\n", "{}: действует, как только оси остановятся\n",
     "{}: platí, jakmile se osy zastaví\n", "{}: hat, amint a tengelyek állnak\n"},
    {"{}: acts from the next start of the machine\n",
     "{}: действует со следующего запуска станка\n", "{}: platí od příštího spuštění stroje\n",
     "{}: a gép következő indításától hat\n"},
    {"consistent\n", "противоречий нет\n", "bez rozporů\n", "ellentmondásmentes\n"},
    {"no difference\n", "различий нет\n", "bez rozdílů\n", "nincs különbség\n"},
    {"{}{} parameters{}\n", "{}параметров: {}{}\n", "{}parametrů: {}{}\n", "{}{} paraméter{}\n"},
    {" without effect", " (не действуют)", " (bez účinku)", " (hatástalan)"},
    {"no effect", "не действует", "bez účinku", "hatástalan"},
    // tools, offsets, parts, users, backups
    {"    ... and {} more\n", "    ... и ещё {}\n", "    ... a dalších {}\n",
     "    ... és további {}\n"},
    {"  file {}\n", "  файл {}\n", "  soubor {}\n", "  fájl: {}\n"},
    {" (limited)", " (ограничено)", " (omezeno)", " (korlátozva)"},
    {"Backup {}\n", "Резервная копия {}\n", "Záloha {}\n", "Mentés: {}\n"},
    {"First to stop the machine: {} after {:.0f} more parts.\n",
     "Первым остановит станок {}: ещё через {:.0f} деталей.\n",
     "Stroj zastaví jako první {} po dalších {:.0f} kusech.\n",
     "Elsőként {} állítja meg a gépet, még {:.0f} darab után.\n"},
    {"Nothing would change.\n", "Ничего не изменится.\n", "Nic by se nezměnilo.\n",
     "Semmi sem változna.\n"},
    {"Nothing was changed yet: say --yes to do it.\n",
     "Пока ничего не изменено: для выполнения добавьте --yes.\n",
     "Zatím se nic nezměnilo: proveďte pomocí --yes.\n",
     "Még semmi sem változott: a --yes kapcsolóval hajtható végre.\n"},
    {"\n  touched at {} mm, the setter stands at {} mm\n",
     "\n  касание в {} мм, датчик стоит в {} мм\n", "\n  dotyk v {} mm, sonda stojí v {} mm\n",
     "\n  érintés: {} mm, a bemérő helye: {} mm\n"},
    {"\n  touched at {} mm; the surface is to be {} mm\n",
     "\n  касание в {} мм; поверхность должна быть на {} мм\n",
     "\n  dotyk v {} mm; plocha má být na {} mm\n", "\n  érintés: {} mm; a felület helye: {} mm\n"},
    {"zero", "ноль", "nulový bod", "nullpont"},
    {"Written.\n", "Записано.\n", "Zapsáno.\n", "Beírva.\n"},
    {"{:.4f} um a pixel, tilted by {:.3f} degrees; kept in {}\n",
     "{:.4f} мкм на пиксель, наклон {:.3f} градуса; сохранено в {}\n",
     "{:.4f} µm na pixel, sklon {:.3f} stupně; uloženo v {}\n",
     "{:.4f} µm képpontonként, {:.3f} fok dőlés; mentve ide: {}\n"},
    {"  T {}; edges at {:.2f} and {:.2f} degrees, {:.2f} between them\n",
     "  T {}; кромки под {:.2f} и {:.2f} градуса, между ними {:.2f}\n",
     "  T {}; břity pod {:.2f} a {:.2f} stupně, mezi nimi {:.2f}\n",
     "  T {}; élek {:.2f} és {:.2f} fokon, köztük {:.2f}\n"},
    {"Restored.\n", "Восстановлено.\n", "Obnoveno.\n", "Visszaállítva.\n"},
    {"There are no dimensions.\n", "Размеров нет.\n", "Žádné rozměry.\n", "Nincsenek méretek.\n"},
    {"There are no tools.\n", "Инструментов нет.\n", "Žádné nástroje.\n",
     "Nincsenek szerszámok.\n"},
    {"This replaces the store in {}. Say --yes to do it.\n",
     "Это заменит хранилище в {}. Для выполнения добавьте --yes.\n",
     "Tím se nahradí úložiště v {}. Proveďte pomocí --yes.\n",
     "Ez lecseréli a tárolót itt: {}. A --yes kapcsolóval hajtható végre.\n"},
    {"all", "все", "vše", "összes"},
    {"column {}: ", "столбец {}: ", "sloupec {}: ", "{} oszlop: "},
    {"row {}, ", "строка {}, ", "řádek {}, ", "{}. sor, "},
    {"dimension", "размер", "rozměr", "méret"},
    {"measured", "измерено", "změřeno", "mért"},
    {"good", "годен", "dobrý", "jó"},
    {"too large", "велик", "příliš velký", "túl nagy"},
    {"too small", "мал", "příliš malý", "túl kicsi"},
    {"proposed correction", "предлагаемая коррекция", "navržená korekce", "javasolt korrekció"},
    {"trend a part", "тренд на деталь", "trend na kus", "trend darabonként"},
    {"parts to the limit", "деталей до предела", "kusů do meze", "darab a határig"},
    {"tool {} stands in {}\n", "инструмент {} стоит: {}\n", "nástroj {} stojí: {}\n",
     "{}. szerszám helye: {}\n"},
    {"{} (level {})\n", "{} (уровень {})\n", "{} (úroveň {})\n", "{} (szint: {})\n"},
    {"{} is logged in as {}.\n", "{} вошёл с уровнем {}.\n", "{} je přihlášen s úrovní {}.\n",
     "{} bejelentkezett, szint: {}.\n"},
    {"{} tools, {} of them new, {} values changed\n",
     "инструментов: {}, из них новых: {}, изменено значений: {}\n",
     "nástrojů: {}, z toho nových: {}, změněných hodnot: {}\n",
     "szerszámok: {}, ebből új: {}, módosult érték: {}\n"},
    {"{}: {} bytes, with {} files\n", "{}: {} байт, файлов: {}\n", "{}: {} bajtů, souborů: {}\n",
     "{}: {} bájt, fájlok: {}\n"},
    {"tool", "инстр.", "nástroj", "szerszám"},
    {"type", "тип", "typ", "típus"},
    {"duplo", "дублёр", "duplo", "duplo"},
    {"name", "имя", "jméno", "név"},
    {"offset", "корректор", "korekce", "korrektor"},
    {"place", "место", "místo", "hely"},
    {"life", "ресурс", "životnost", "éltartam"},
    {"state", "состояние", "stav", "állapot"},
    {"works in", "в работе", "pracuje v", "működik"},
    {"group", "группа", "skupina", "csoport"},
    {"used up", "израсходовано", "spotřebováno", "elhasznált"},
    {"left", "осталось", "zbývá", "maradék"},
    {"unit", "ед.", "jednotka", "egység"},
    {"parts left", "осталось деталей", "zbývá kusů", "hátralévő darab"},
    {"minutes left", "осталось минут", "zbývá minut", "hátralévő perc"},
    {"broken", "сломан", "zlomený", "törött"},
    {"locked", "заблокирован", "blokovaný", "zárolt"},
    {"worn", "изношен", "opotřebený", "kopott"},
    {"warned", "предупр.", "varování", "figyelmeztetés"},
    {"active", "активен", "aktivní", "aktív"},
    {"not enabled", "не разрешён", "nepovolený", "nem engedélyezett"},
});

}  // namespace

std::string_view say(std::string_view english) {
    const DisplayLanguage display_language = display_language_now();
    if (display_language == DisplayLanguage::English) return english;
    const auto is_it = [&](const Phrase& p) { return p.english == english; };
    const Phrase* found = nullptr;
    if (const auto in = std::find_if(kPhrases.begin(), kPhrases.end(), is_it); in != kPhrases.end())
        found = &*in;
    const auto help = help_phrases();
    if (const auto in = std::find_if(help.begin(), help.end(), is_it); !found && in != help.end())
        found = &*in;
    if (!found) return english;
    return display_language == DisplayLanguage::Russian ? found->russian
           : display_language == DisplayLanguage::Czech ? found->czech
                                                        : found->hungarian;
}

}  // namespace polyturn::supervisor
