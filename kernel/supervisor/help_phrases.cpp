// What --help says, in the four languages. Names of options, words to press and values stay as they are: they are typed.
#include <array>

#include "kernel/supervisor/phrases.hpp"

namespace polyturn::supervisor {
namespace {

constexpr auto kHelp = std::to_array<Phrase>({
    {"What programs ask the operator; with words: the answer, 'L1 #500=12.5 key=1'", "Что программы спрашивают у оператора; со словами: ответ, 'L1 #500=12.5 key=1'",
     "Na co se programy ptají obsluhy; se slovy: odpověď, 'L1 #500=12.5 key=1'", "Mit kérdeznek a programok a kezelőtől; szavakkal: a válasz, 'L1 #500=12.5 key=1'"},
    {"Exit status: 0 done; 1 the job ended with an alarm; 2 wrong usage or unreadable input.",
     "Код завершения: 0 выполнено; 1 задание закончилось аварией; 2 неверный вызов или нечитаемый ввод.",
     "Návratový kód: 0 hotovo; 1 úloha skončila poruchou; 2 chybné použití nebo nečitelný vstup.",
     "Kilépési kód: 0 kész; 1 a feladat hibával ért véget; 2 hibás használat vagy olvashatatlan bemenet."},
    {"A job's zeros and offsets, on a running controller", "Нулевые точки и корректоры задания на работающем контроллере", "Nulové body a korekce zakázky na běžícím řízení", "Egy munka nullpontjai és korrekciói a futó vezérlőn"},
    {"Selects the job and enters its zeros and the offsets of its setup", "Выбирает задание и вводит его нулевые точки и корректоры наладки", "Zvolí zakázku a zadá její nulové body a korekce seřízení",
     "Kiválasztja a munkát, és beírja nullpontjait és a beállítás korrekcióit"},
    {"What is entered otherwise than the job has it", "Что введено иначе, чем в задании", "Co je zadáno jinak než v zakázce", "Mi van másképp beírva, mint a munkában"},
    {"NAME.job.toml", "ИМЯ.job.toml", "JMÉNO.job.toml", "NÉV.job.toml"},
    {"Exit status: 0 done, or nothing differs; 1 something differs or this machine does not have it; 2 refused.",
     "Код завершения: 0 выполнено или различий нет; 1 есть различия либо у станка этого нет; 2 отказано.",
     "Návratový kód: 0 hotovo, nebo se nic neliší; 1 něco se liší nebo to stroj nemá; 2 odmítnuto.",
     "Kilépési kód: 0 kész, vagy nincs eltérés; 1 eltérés van, vagy a gépnek nincs ilyenje; 2 elutasítva."},
    {"Usage", "Вызов", "Použití", "Használat"},
    {"OPTIONS", "ПАРАМЕТРЫ", "VOLBY", "KAPCSOLÓK"},
    {"Options", "Параметры", "Volby", "Kapcsolók"},
    {"Positionals", "Аргументы", "Argumenty", "Argumentumok"},
    {"Subcommands", "Команды", "Příkazy", "Parancsok"},
    {"SUBCOMMAND", "КОМАНДА", "PŘÍKAZ", "PARANCS"},
    {"REQUIRED", "обязательно", "povinné", "kötelező"},
    {"TEXT", "ТЕКСТ", "TEXT", "SZÖVEG"},
    {"Print this help message and exit", "Показать эту справку и закончить", "Vypíše tuto nápovědu a skončí", "Kiírja ezt a súgót, és kilép"},
    {"Display program version information and exit", "Показать версию и закончить", "Vypíše verzi a skončí", "Kiírja a verziót, és kilép"},
    {"Polyturn: a multi-channel lathe controller", "Polyturn: многоканальная система управления токарными станками", "Polyturn: vícekanálový řídicí systém soustruhů",
     "Polyturn: többcsatornás esztergavezérlés"},
    {"L=FILE (channel and file), FILE (the first for channel 1, and so on), or one NAME.job.toml",
     "L=ФАЙЛ (канал и файл), ФАЙЛ (первый для канала 1 и так далее) или одно ИМЯ.job.toml",
     "L=SOUBOR (kanál a soubor), SOUBOR (první pro kanál 1 a tak dále) nebo jedno JMÉNO.job.toml",
     "L=FÁJL (csatorna és fájl), FÁJL (az első az 1. csatornáé és így tovább), vagy egy NÉV.job.toml"},
    {"[L=]NAME: fanuc, nct, fagor, sinumerik or mefi; otherwise the machine says", "[L=]ИМЯ: fanuc, nct, fagor, sinumerik или mefi; иначе решает станок",
     "[L=]JMÉNO: fanuc, nct, fagor, sinumerik nebo mefi; jinak určuje stroj", "[L=]NÉV: fanuc, nct, fagor, sinumerik vagy mefi; különben a gép dönt"},
    {"parameter file, or folder with machine.params; default: examples/machines/twin-turret",
     "файл параметров или папка с machine.params; по умолчанию examples/machines/twin-turret",
     "soubor parametrů nebo složka s machine.params; výchozí examples/machines/twin-turret",
     "paraméterfájl vagy machine.params-ot tartalmazó mappa; alapérték: examples/machines/twin-turret"},
    {"one parameter: 'NAME [SCOPE]=VALUE', such as 'N1300 L1=5'; repeatable", "один параметр: 'ИМЯ [ОБЛАСТЬ]=ЗНАЧЕНИЕ', например 'N1300 L1=5'; можно повторять",
     "jeden parametr: 'JMÉNO [ROZSAH]=HODNOTA', např. 'N1300 L1=5'; lze opakovat", "egy paraméter: 'NÉV [HATÓKÖR]=ÉRTÉK', például 'N1300 L1=5'; ismételhető"},
    {"file of such lines; repeatable", "файл таких строк; можно повторять", "soubor takových řádků; lze opakovat", "ilyen sorokból álló fájl; ismételhető"},
    {"what an operator would have entered: positions, zeros, offsets, variables, keys (TOML)", "то, что ввёл бы оператор: положения, нули, коррекции, переменные, клавиши (TOML)",
     "co by zadala obsluha: polohy, nulové body, korekce, proměnné, tlačítka (TOML)", "amit a kezelő adna meg: helyzetek, nullpontok, korrekciók, változók, gombok (TOML)"},
    {"name of the private controller", "имя собственной системы", "jméno vlastního systému", "a saját vezérlés neve"},
    {"copies offsets, tools, zeros and parameters of this running controller", "берёт коррекции, инструменты, нули и параметры этой работающей системы",
     "převezme korekce, nástroje, nulové body a parametry tohoto běžícího systému", "átveszi ennek a futó vezérlésnek a korrekcióit, szerszámait, nullpontjait és paramétereit"},
    {"keeps what the programs write in this folder", "сохраняет в этой папке то, что записывают программы", "uchová v této složce, co programy zapíší", "ebben a mappában őrzi meg, amit a programok írnak"},
    {"also report every variable that a program writes", "сообщать и о каждой переменной, которую записывает программа", "hlásit také každou proměnnou, kterou program zapíše",
     "minden változót is jelent, amelyet egy program ír"},
    {"blocks after which a program counts as endless (default 10000000); 0: no limit", "кадры, после которых программа считается бесконечной (по умолчанию 10000000); 0: без предела",
     "bloky, po nichž program platí za nekonečný (výchozí 10000000); 0: bez meze", "mondatok, amelyek után a program végtelennek számít (alapérték 10000000); 0: nincs határ"},
    {"only alarms, messages and the summary", "только аварии, сообщения и итог", "jen poruchy, hlášení a souhrn", "csak hibák, üzenetek és az összegzés"},
    {"what happens while it runs (TOML)", "что происходит во время прогона (TOML)", "co se děje za běhu (TOML)", "ami futás közben történik (TOML)"},
    {"report each change of this flag or register, such as 'CN_WTNG L1' (run); repeatable", "сообщать о каждом изменении этого флага или регистра, например 'CN_WTNG L1' (run); можно повторять",
     "hlásit každou změnu tohoto příznaku nebo registru, např. 'CN_WTNG L1' (run); lze opakovat", "jelenti ennek a jelzőnek vagy regiszternek minden változását, például 'CN_WTNG L1' (run); ismételhető"},
    {"virtual time: as fast as it goes, identical every time", "виртуальное время: с наибольшей скоростью, каждый раз одинаково", "virtuální čas: co nejrychleji, pokaždé stejně",
     "virtuális idő: a lehető leggyorsabban, minden alkalommal ugyanúgy"},
    {"positions, speeds and states of each tick (CSV)", "положения, скорости и состояния каждого такта (CSV)", "polohy, rychlosti a stavy každého taktu (CSV)", "helyzetek, sebességek és állapotok ütemenként (CSV)"},
    {"a line each so many ticks", "строка через столько тактов", "řádek po tolika taktech", "ennyi ütemenként egy sor"},
    {"[L=]PERCENT: feed override at the start", "[L=]ПРОЦЕНТ: коррекция подачи в начале", "[L=]PROCENTO: korekce posuvu na začátku", "[L=]SZÁZALÉK: előtolás-szorzó induláskor"},
    {"also programs of the PLC and of drives that the backup holds", "также программы ПЛК и приводов из резервной копии", "také programy PLC a pohonů ze zálohy", "a mentésben lévő PLC- és hajtásprogramokat is"},
    {"L=N120: program restart at a block; repeatable", "L=N120: пуск программы с кадра; можно повторять", "L=N120: start programu od bloku; lze opakovat", "L=N120: a program indítása egy mondattól; ismételhető"},
    {"parts to make (default 1)", "сколько деталей изготовить (по умолчанию 1)", "kolik kusů vyrobit (výchozí 1)", "gyártandó darabok (alapérték 1)"},
    {"tool paths and the channels' timeline (SVG)", "траектории инструмента и временная диаграмма каналов (SVG)", "dráhy nástrojů a časová osa kanálů (SVG)", "szerszámpályák és a csatornák idődiagramja (SVG)"},
    {"print where the time went, for reading, after the events", "после событий напечатать для чтения, на что ушло время", "po událostech vypsat k přečtení, kam se poděl čas", "az események után kiírja olvasásra, mire ment el az idő"},
    {"What can be pressed:", "Что можно нажать:", "Co lze stisknout:", "Mit lehet megnyomni:"},
    {"Interprets programs and matches their waits; nothing moves", "Разбирает программы и сверяет их ожидания; ничего не движется", "Projde programy a porovná jejich čekání; nic se nepohne",
     "Értelmezi a programokat, és egyezteti a várakozásaikat; semmi sem mozog"},
    {"Runs programs on a private machine, in real or virtual time", "Выполняет программы на собственном станке, в реальном или виртуальном времени", "Spustí programy na vlastním stroji ve skutečném nebo virtuálním čase",
     "Programokat futtat egy saját gépen, valós vagy virtuális időben"},
    {"The controller; it stays in the foreground, SIGTERM is a controlled stop", "Система управления; остаётся на переднем плане, SIGTERM останавливает её управляемо", "Řídicí systém; zůstává v popředí, SIGTERM je řízené zastavení",
     "A vezérlés; előtérben marad, a SIGTERM szabályozott leállítás"},
    {"parameter file or folder; default: examples/machines/twin-turret", "файл параметров или папка; по умолчанию examples/machines/twin-turret", "soubor parametrů nebo složka; výchozí examples/machines/twin-turret",
     "paraméterfájl vagy mappa; alapérték: examples/machines/twin-turret"},
    {"its name; default polyturn", "её имя; по умолчанию polyturn", "jeho jméno; výchozí polyturn", "a neve; alapérték: polyturn"},
    {"folder of what must survive power-off; default $XDG_STATE_HOME/polyturn/NAME", "папка того, что должно пережить выключение; по умолчанию $XDG_STATE_HOME/polyturn/ИМЯ",
     "složka toho, co musí přežít vypnutí; výchozí $XDG_STATE_HOME/polyturn/JMÉNO", "a kikapcsolást túlélő adatok mappája; alapérték: $XDG_STATE_HOME/polyturn/NÉV"},
    {"without screens", "без экранов", "bez obrazovek", "képernyők nélkül"},
    {"one parameter; repeatable", "один параметр; можно повторять", "jeden parametr; lze opakovat", "egy paraméter; ismételhető"},
    {"file of parameter lines; repeatable", "файл строк параметров; можно повторять", "soubor řádků parametrů; lze opakovat", "paramétersorokból álló fájl; ismételhető"},
    {"What an operator does, on a running controller", "То, что делает оператор, на работающей системе", "Co dělá obsluha na běžícím systému", "Amit a kezelő tesz egy futó vezérlésen"},
    {"Forces a PLC signal, register, input or drive fault, or sets a parameter: 'AP_SYNCR A3=1'", "Задаёт сигнал ПЛК, регистр, вход, отказ привода или параметр: 'AP_SYNCR A3=1'",
     "Vnutí signál PLC, registr, vstup nebo poruchu pohonu, nebo nastaví parametr: 'AP_SYNCR A3=1'", "PLC-jelet, regisztert, bemenetet vagy hajtáshibát kényszerít, vagy paramétert állít: 'AP_SYNCR A3=1'"},
    {"Gives a forced signal back to the PLC: 'AP_SYNCR A3'", "Возвращает заданный сигнал ПЛК: 'AP_SYNCR A3'", "Vrátí vnucený signál PLC: 'AP_SYNCR A3'", "Visszaadja a kényszerített jelet a PLC-nek: 'AP_SYNCR A3'"},
    {"the controller; default polyturn", "система; по умолчанию polyturn", "systém; výchozí polyturn", "a vezérlés; alapérték: polyturn"},
    {"the controller; default: all that run", "система; по умолчанию все работающие", "systém; výchozí všechny běžící", "a vezérlés; alapérték: mind, amely fut"},
    {"What runs, and what it does", "Что работает и чем занято", "Co běží a co dělá", "Mi fut, és mit csinál"},
    {"The alarms since the controller was started", "Аварии с запуска системы", "Poruchy od spuštění systému", "A vezérlés indítása óta keletkezett hibák"},
    {"for programs", "для программ", "pro programy", "programoknak"},
    {"Parameters of a running controller (--instance) or of a machine file", "Параметры работающей системы (--instance) или файла станка", "Parametry běžícího systému (--instance) nebo souboru stroje",
     "Egy futó vezérlés (--instance) vagy egy gépfájl paraméterei"},
    {"All parameters, or those whose number or name holds a text", "Все параметры или те, в номере или имени которых есть текст", "Všechny parametry nebo ty, jejichž číslo či jméno obsahuje text",
     "Minden paraméter, vagy azok, amelyeknek száma vagy neve tartalmaz egy szöveget"},
    {"part of number, name or group", "часть номера, имени или группы", "část čísla, jména nebo skupiny", "a szám, a név vagy a csoport része"},
    {"Everything about one parameter; its value last", "Всё об одном параметре; в конце его значение", "Vše o jednom parametru; nakonec jeho hodnota", "Minden egy paraméterről; végül az értéke"},
    {"Sets one or more; returns when they are on disk", "Задаёт один или несколько; возвращается, когда они на диске", "Nastaví jeden nebo více; vrátí se, až jsou na disku", "Egyet vagy többet beállít; akkor tér vissza, amikor lemezen vannak"},
    {"Parameter lines that read in again to the same values", "Строки параметров, которые читаются обратно в те же значения", "Řádky parametrů, které se načtou zpět na stejné hodnoty", "Paramétersorok, amelyek visszaolvasva ugyanazokat az értékeket adják"},
    {"where to; default: standard output", "куда; по умолчанию стандартный вывод", "kam; výchozí standardní výstup", "hová; alapérték: szabványos kimenet"},
    {"Sets all lines of a file, or none when one is wrong", "Задаёт все строки файла или ни одной, если одна неверна", "Nastaví všechny řádky souboru, nebo žádný, je-li jeden chybný", "A fájl minden sorát beállítja, vagy egyet sem, ha valamelyik hibás"},
    {"parameter file", "файл параметров", "soubor parametrů", "paraméterfájl"},
    {"What differs between two machines or files", "Чем различаются два станка или файла", "Čím se liší dva stroje nebo soubory", "Miben tér el két gép vagy fájl"},
    {"one file (compared with the machine) or two", "один файл (сравнивается со станком) или два", "jeden soubor (porovná se se strojem) nebo dva", "egy fájl (a géppel összevetve) vagy kettő"},
    {"Is the file right, and do its values fit together?", "Верен ли файл и согласуются ли его значения?", "Je soubor správný a jdou jeho hodnoty dohromady?", "Helyes-e a fájl, és összeillenek-e az értékei?"},
    {"parameter file or machine folder; default: the machine", "файл параметров или папка станка; по умолчанию станок", "soubor parametrů nebo složka stroje; výchozí stroj", "paraméterfájl vagy gépmappa; alapérték: a gép"},
    {"a running controller", "работающая система", "běžící systém", "egy futó vezérlés"},
    {"only those without effect, with the reason", "только недействующие, с причиной", "jen ty bez účinku, s důvodem", "csak a hatástalanok, az okkal"},
    {"also what has its default", "и то, что имеет значение по умолчанию", "i to, co má výchozí hodnotu", "azt is, ami alapértékű"},
    {"Removes what no living process holds: shared memory, sockets", "Удаляет то, чего не держит ни один живой процесс: общую память, сокеты", "Odstraní, co nedrží žádný živý proces: sdílenou paměť, sokety",
     "Eltávolítja, amit élő folyamat nem tart: megosztott memória, foglalatok"},
    {"Runs the benchmarks of this build and prints their figures", "Выполняет измерения этой сборки и печатает их результаты", "Spustí měření tohoto sestavení a vypíše výsledky", "Lefuttatja ennek a változatnak a méréseit, és kiírja az eredményeket"},
    // from power-on to ready
    {"the emergency stop is active", "действует аварийный останов", "působí nouzové zastavení", "a vészleállítás él"},
    {"turn the button back, then press machine on", "поверните кнопку назад, затем включите станок", "otočte tlačítko zpět, pak zapněte stroj", "fordítsa vissza a gombot, majd kapcsolja be a gépet"},
    {"the machine is off", "станок выключен", "stroj je vypnut", "a gép ki van kapcsolva"},
    {"press machine on", "включите станок", "zapněte stroj", "kapcsolja be a gépet"},
    {"not all axes are referenced", "не все оси в референте", "ne všechny osy mají referenci", "nem minden tengelynek van referenciája"},
    {"press reference all", "выведите все оси в референт", "najeďte všemi osami do reference", "vegyen fel referenciát minden tengelyen"},
    {"axes are on their way to their reference points", "оси идут в референтные точки", "osy jedou do referenčních bodů", "a tengelyek úton vannak a referenciapontjukhoz"},
    {"wait", "подождите", "počkejte", "várjon"},
    {"the machine is ready", "станок готов", "stroj je připraven", "a gép üzemkész"},
    {"an alarm has stopped everything", "авария остановила всё", "porucha vše zastavila", "egy hiba mindent leállított"},
    {"remove its cause, then press reset", "устраните причину и нажмите сброс", "odstraňte příčinu a stiskněte reset", "szüntesse meg az okát, majd nyomjon alaphelyzetet"},
    // what holds for a channel
    {"drives backwards", "идёт назад по траектории", "jede zpět po dráze", "visszafelé halad a pályán"},
    {"drives forwards again", "снова идёт вперёд", "jede opět vpřed", "ismét előre halad"},
    {"driven by the handwheel", "ведёт маховичок", "vede ruční kolečko", "a kézikerék vezeti"},
    {"a block entered by hand runs", "выполняется кадр, введённый вручную", "běží ručně zadaný blok", "kézzel beírt mondat fut"},
    {"cycle start runs a block entered by hand", "пуск выполнит кадр, введённый вручную", "start provede ručně zadaný blok", "a start kézzel beírt mondatot hajt végre"},
    {"cycle start drives backwards", "пуск поведёт назад", "start pojede zpět", "a start visszafelé hajt"},
    {"passes its waits over, nobody waits for it", "ожидания пропускаются, его никто не ждёт", "čekání se přeskakují, nikdo na něj nečeká", "a várakozásokat átlépi, senki sem vár rá"},
    {"handwheel superposed", "маховичок наложен", "ruční kolečko superponováno", "rászuperponált kézikerék"},
    {"looks for the block of the restart", "ищет кадр повторного пуска", "hledá blok opětovného startu", "az újraindítás mondatát keresi"},
    {"at the block of the restart: others are not at theirs yet", "у кадра повторного пуска: другие ещё не у своих", "u bloku opětovného startu: ostatní ještě nejsou u svých", "az újraindítás mondatánál: a többiek még nincsenek ott"},
    {"its restart was refused: restart again, or reset", "повторный пуск отклонён: пустите снова с кадра или сбросьте", "opětovný start byl odmítnut: začněte znovu od bloku, nebo reset", "az újraindítást elutasította: indítsa újra, vagy reset"},
    {"at the block of the restart: cycle start approaches", "у кадра повторного пуска: пуск цикла начнёт подход", "u bloku opětovného startu: start cyklu zahájí nájezd", "az újraindítás mondatánál: a ciklusstart megközelíti"},
    // approach of a restart
    {"restart at", "повторный пуск с", "opětovný start od", "újraindítás itt:"},
    {", then ", ", затем ", ", pak ", ", majd "},
    {" and ", " и ", " a ", " és "},
    {"the axes are there", "оси уже на месте", "osy jsou na místě", "a tengelyek ott vannak"},
});

}  // namespace

std::span<const Phrase> help_phrases() { return kHelp; }

// "restart at N120: T0303 M3, then X 60 -> 30": an event's own words, which logs have in English.
std::string retold_restart(std::string_view english) {
    constexpr std::string_view kHead = "restart at";
    if (english.substr(0, kHead.size()) != kHead) return std::string(english);
    std::string out(say(kHead));
    english.remove_prefix(kHead.size());
    while (!english.empty()) {
        bool found = false;
        for (const std::string_view word : {std::string_view(", then "), std::string_view(" and "), std::string_view("the axes are there")})
            if (english.substr(0, word.size()) == word) {
                out += say(word);
                english.remove_prefix(word.size());
                found = true;
                break;
            }
        if (found) continue;
        out += english.front();
        english.remove_prefix(1);
    }
    return out;
}

}  // namespace polyturn::supervisor
