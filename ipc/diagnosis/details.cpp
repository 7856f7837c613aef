#include "ipc/diagnosis/details.hpp"

#include <array>

#include "ipc/diagnosis/os_errors.hpp"

namespace polyturn {
namespace {

constexpr auto kDetails = std::to_array<DetailRow>({
    // requests to the store: offsets, zeros, history
    {{"there is no such offset", "такого корректора нет", "taková korekce není", "nincs ilyen korrekció"}},
    {{"value or delta, not both", "value или delta, не оба сразу", "value nebo delta, ne obojí", "value vagy delta, nem mindkettő"}},
    {{"{0} is {1} by now, not {2}", "{0}: сейчас там {1}, а не {2}", "{0}: teď je tam {1}, ne {2}", "{0}: most {1} áll ott, nem {2}"}},
    {{"channel {0}: its notes", "канал {0}: его записи о кадрах", "kanál {0}: jeho záznamy o blocích", "{0}. csatorna: a mondatokról szóló bejegyzései"}},
    // what a store has lost
    {{"{0} of {1} changes are missing at the end of {2}", "в конце {2} не хватает изменений: {0} из {1}", "na konci {2} chybí změn: {0} z {1}", "{2} végéről {1} módosításból {0} hiányzik"}},
    {{"{0} ends with another change than the one that was acknowledged", "{0} кончается не тем изменением, которое было подтверждено", "{0} končí jinou změnou než tou, která byla potvrzena", "{0} nem azzal a módosítással végződik, amelyet nyugtáztak"}},
    {{"{0} is not the file that this store had", "{0} — не тот файл, который был у этого хранилища", "{0} není soubor, který toto úložiště mělo", "{0} nem az a fájl, amely ezé a tárolóé volt"}},
    {{"{0} cannot be read to its end", "{0} не читается до конца", "{0} nelze dočíst do konce", "{0} nem olvasható végig"}},
    {{"{0} belongs to another store", "{0} от другого хранилища", "{0} patří jinému úložišti", "{0} egy másik tárolóé"}},
    {{"page {0} of {1}", "страница {0} файла {1}", "strana {0} souboru {1}", "{1} {0}. lapja"}},
    {{"{0} is damaged", "{0} повреждён", "{0} je poškozen", "{0} sérült"}},
    {{"{0} is empty", "{0} пуст", "{0} je prázdný", "{0} üres"}},
    {{"{0}: nothing is added to it", "{0}: к этому ничего не прибавляют", "{0}: k tomu se nic nepřičítá", "{0}: ehhez nem lehet hozzáadni"}},
    {{"{0}: nothing is added to bits", "{0}: к битам ничего не прибавляют", "{0}: k bitům se nic nepřičítá", "{0}: bitekhez nem lehet hozzáadni"}},
    {{"{0}: one number of a parameter is wanted", "{0}: нужно одно число параметра", "{0}: je třeba jedno číslo parametru", "{0}: a paraméter egyetlen száma kell"}},
    {{"{0}: true or false is wanted", "{0}: нужно true или false", "{0}: je třeba true nebo false", "{0}: true vagy false kell"}},
    {{"{0}: an object is wanted", "{0}: нужен объект", "{0}: je třeba objekt", "{0}: objektum kell"}},
    {{"a request of {0} characters, at most {1}", "запрос длиной {0} знаков, не больше {1}", "požadavek o {0} znacích, nejvýše {1}", "{0} karakteres kérés, legfeljebb {1}"}},
    {{"a request of more than {0} levels", "запрос глубже {0} уровней", "požadavek o více než {0} úrovních", "{0} szintnél mélyebb kérés"}},
    {{"no block by hand can run where the program is held", "там, где стоит программа, кадр вручную выполнить нельзя", "tam, kde je program pozastaven, nelze ručně zadaný blok provést", "ahol a program fel van függesztve, ott kézzel beírt mondat nem futhat"}},
    {{"a block entered by hand waits for the start", "введённый вручную кадр ждёт пуска", "ručně zadaný blok čeká na start", "egy kézzel beírt mondat az indításra vár"}},
    {{"a program runs", "выполняется программа", "běží program", "program fut"}},
    {{"a program is restarted at a block only in automatic mode (choose it)", "повторный пуск с кадра возможен только в автоматическом режиме (выберите его)", "nový start od bloku je možný jen v automatickém režimu (zvolte jej)", "mondattól újraindítani csak automatikus üzemmódban lehet (válassza azt)"}},
    {{"the program of another channel was to start this one, whose mode is MDI (choose automatic)", "программа другого канала должна была запустить этот, а он в режиме РВД (выберите автоматический)", "program jiného kanálu měl spustit tento, který je v režimu MDI (zvolte automatický)", "egy másik csatorna programja indította volna ezt, amely MDI módban van (válassza az automatikust)"}},
    {{"the handwheel drives a program only while the machine is on", "маховичок ведёт программу только при включённом станке", "ruční kolečko vede program jen při zapnutém stroji", "a kézikerék csak bekapcsolt gépnél vezeti a programot"}},
    {{"the door is open: close it, or switch to setup mode", "дверь открыта: закройте её или включите режим наладки", "dveře jsou otevřené: zavřete je nebo přepněte na seřizování", "az ajtó nyitva van: csukja be, vagy kapcsoljon beállító módra"}},
    {{"axes are moved by hand only while the machine is on", "оси двигают вручную только при включённом станке", "osami se ručně pohybuje jen při zapnutém stroji", "a tengelyek kézzel csak bekapcsolt gépnél mozgathatók"}},
    {{"{0}: there is no such offset", "{0}: такого корректора нет", "{0}: taková korekce není", "{0}: nincs ilyen korrekció"}},
    {{"{0}: channel {1} has {2} (N1400)", "{0}: в канале {1} их {2} (N1400)", "{0}: kanál {1} jich má {2} (N1400)", "{0}: a(z) {1} csatornában {2} van (N1400)"}},
    {{"{0}: geometry is the setter's", "{0}: геометрию меняет наладчик", "{0}: geometrii mění seřizovač", "{0}: a geometriát a beállító módosítja"}},
    {{"{0}: tip directions are 0 to 9", "{0}: направления вершины — от 0 до 9", "{0}: směry špičky jsou 0 až 9", "{0}: a csúcsirány 0–9 lehet"}},
    {{"tip directions are 0 to 9", "направления вершины — от 0 до 9", "směry špičky jsou 0 až 9", "a csúcsirány 0–9 lehet"}},
    {{"planes are 17, 18 and 19", "плоскости: 17, 18 и 19", "roviny jsou 17, 18 a 19", "a síkok: 17, 18 és 19"}},
    {{"tool {0} D{1} has no length along {2} in G{3}", "у инструмента {0} D{1} нет длины вдоль {2} при G{3}", "nástroj {0} D{1} nemá v G{3} délku podél {2}", "a(z) {0} szerszám D{1} élének G{3}-ban nincs hossza {2} mentén"}},
    {{"tool {0} D{1} has no length along {2}", "у инструмента {0} D{1} нет длины вдоль {2}", "nástroj {0} D{1} nemá délku podél {2}", "a(z) {0} szerszám D{1} élének nincs hossza {2} mentén"}},
    {{"{0}: wear is {1} mm at the most (N1415)", "{0}: износ не больше {1} мм (N1415)", "{0}: opotřebení je nejvýše {1} mm (N1415)", "{0}: a kopás legfeljebb {1} mm (N1415)"}},
    {{"{0}: one entry changes wear by {1} mm at the most (PT_WEAR_STEP)", "{0}: за один ввод износ меняется не больше чем на {1} мм (PT_WEAR_STEP)", "{0}: jedno zadání změní opotřebení nejvýše o {1} mm (PT_WEAR_STEP)", "{0}: egy bevitel a kopást legfeljebb {1} mm-rel módosítja (PT_WEAR_STEP)"}},
    {{"table {0}: geometry, wear or second", "таблица {0}: geometry, wear или second", "tabulka {0}: geometry, wear nebo second", "{0} táblázat: geometry, wear vagy second"}},
    {{"table {0}: geometry or wear", "таблица {0}: geometry или wear", "tabulka {0}: geometry nebo wear", "{0} táblázat: geometry vagy wear"}},
    {{"field {0}: X Y Z R or T", "поле {0}: X Y Z R или T", "pole {0}: X Y Z R nebo T", "{0} mező: X Y Z R vagy T"}},
    {{"measuring needs a channel and X, Y or Z", "для измерения нужны канал и X, Y или Z", "k měření je třeba kanál a X, Y nebo Z", "a méréshez csatorna és X, Y vagy Z kell"}},
    {{"channel L{0} does not exist", "канала L{0} нет", "kanál L{0} není", "L{0} csatorna nincs"}},
    {{"channel L{0} has no axis {1}", "в канале L{0} нет оси {1}", "kanál L{0} nemá osu {1}", "az L{0} csatornának nincs {1} tengelye"}},
    {{"channel L{0} has {1} offsets (N1400)", "в канале L{0} корректоров {1} (N1400)", "kanál L{0} má {1} korekcí (N1400)", "az L{0} csatornának {1} korrekciója van (N1400)"}},
    {{"channel L{0}, workpiece", "канал L{0}, заготовка", "kanál L{0}, obrobek", "L{0} csatorna, munkadarab"}},
    {{"channel L{0}, workpiece, axis {1}", "канал L{0}, заготовка, ось {1}", "kanál L{0}, obrobek, osa {1}", "L{0} csatorna, munkadarab, {1} tengely"}},
    {{"channel L{0}, axis {1}", "канал L{0}, ось {1}", "kanál L{0}, osa {1}", "L{0} csatorna, {1} tengely"}},
    {{"channel L{0}", "канал L{0}", "kanál L{0}", "L{0} csatorna"}},
    {{"channels are 1 to 16", "каналы — от 1 до 16", "kanály jsou 1 až 16", "a csatornák száma 1–16"}},
    {{"the kernel does not say where the axis stands", "ядро не говорит, где стоит ось", "jádro neříká, kde osa stojí", "a mag nem mondja meg, hol áll a tengely"}},
    {{"the kernel does not say where the tool has touched", "ядро не говорит, где инструмент коснулся", "jádro neříká, kde se nástroj dotkl", "a mag nem mondja meg, hol érintett a szerszám"}},
    {{"the kernel does not say where the workpiece was touched", "ядро не говорит, где коснулись заготовки", "jádro neříká, kde se dotklo obrobku", "a mag nem mondja meg, hol érintették a munkadarabot"}},
    {{"no such machine here, and none among the examples of this installation", "такого станка нет ни здесь, ни среди примеров", "takový stroj zde není a není ani mezi příklady", "nincs ilyen gép sem itt, sem a példák között"}},
    {{"there is no such machine file or folder", "такого файла или папки станка нет", "takový soubor nebo složka stroje není", "nincs ilyen gépfájl vagy mappa"}},
    {{"a machine's folder holds its parameters in machine.params", "в папке станка параметры лежат в machine.params", "ve složce stroje jsou parametry v machine.params", "a gép mappájában a paraméterek a machine.params fájlban vannak"}},
    {{"there is no such zero offset", "такого смещения нуля нет", "takové posunutí nuly není", "nincs ilyen nullponteltolás"}},
    {{"there is no zero offset {0}", "смещения нуля {0} нет", "posunutí nuly {0} není", "nincs {0} nullponteltolás"}},
    {{"a zero offset of {0} mm", "смещение нуля {0} мм", "posunutí nuly {0} mm", "{0} mm-es nullponteltolás"}},
    {{"the PLC has chosen offset {0} (N3016 ONS, CP_OFFSNO)", "ПЛК выбрал корректор {0} (N3016 ONS, CP_OFFSNO)", "PLC zvolilo korekci {0} (N3016 ONS, CP_OFFSNO)", "a PLC a(z) {0} korrekciót választotta (N3016 ONS, CP_OFFSNO)"}},
    {{"G{0} is measured here (N3016 WPS)", "здесь измеряется G{0} (N3016 WPS)", "zde se měří G{0} (N3016 WPS)", "itt a G{0} mérése folyik (N3016 WPS)"}},
    {{"offset is missing: the number of the probe's offset, 0 for none", "нет offset: номер корректора щупа, 0 — без него", "chybí offset: číslo korekce sondy, 0 znamená žádná", "hiányzik az offset: a tapintó korrekciójának száma, 0: nincs"}},
    {{"the workpiece was touched in {0}", "заготовки коснулись по {0}", "obrobku se dotklo v {0}", "a munkadarabot {0} irányban érintették"}},
    {{"the relative counter has no origin yet: offsets origin", "у относительного счётчика ещё нет начала: offsets origin", "relativní čítač ještě nemá počátek: offsets origin", "a relatív számlálónak még nincs kezdőpontja: offsets origin"}},
    {{"this controller keeps no history", "эта система не ведёт истории", "tento řídicí systém nevede historii", "ez a vezérlés nem vezet előzményeket"}},
    {{"this controller keeps no log of stops", "эта система не ведёт журнала простоев", "tento řídicí systém nevede deník stání", "ez a vezérlés nem vezet állásnaplót"}},
    {{"there is nothing to take back", "нечего отменять", "není co vrátit", "nincs mit visszavonni"}},
    {{"{0} is {1} now: something else has changed it since {2}", "{0} теперь {1}: с {2} это изменили иначе", "{0} je nyní {1}: od {2} to změnilo něco jiného", "{0} most {1}: {2} óta más módosította"}},
    // tables of measured errors
    {{"no cell of the table: {0}", "такой ячейки в таблице нет: {0}", "taková buňka v tabulce není: {0}", "a táblázatban nincs ilyen cella: {0}"}},
    {{"L{0}: the grid has no point {1}", "L{0}: в сетке нет точки {1}", "L{0}: mřížka nemá bod {1}", "L{0}: a rácsnak nincs {1}. pontja"}},
    {{"L{0}: point {1} is machine zero and must be 0 0 0", "L{0}: точка {1} — нуль станка, в ней должно быть 0 0 0", "L{0}: bod {1} je nula stroje a musí být 0 0 0", "L{0}: a(z) {1}. pont a gépi nullpont, értéke 0 0 0 kell legyen"}},
    {{"L{0}: point {1} of the grid has no value", "L{0}: у точки {1} сетки нет значения", "L{0}: bod {1} mřížky nemá hodnotu", "L{0}: a rács {1}. pontjának nincs értéke"}},
    {{"{0}: cell {1} has no value", "{0}: у ячейки {1} нет значения", "{0}: buňka {1} nemá hodnotu", "{0}: a(z) {1} cellának nincs értéke"}},
    {{"{0}: cyclic, but cell {1} differs from cell {2} at machine zero", "{0}: таблица повторяется, но ячейка {1} не равна ячейке {2} в нуле станка", "{0}: tabulka se opakuje, ale buňka {1} se liší od buňky {2} v nule stroje", "{0}: ismétlődő, de a(z) {1} cella eltér a gépi nullpont {2} cellájától"}},
    // what the store's file says (SQLite), and files of the presetter and of channels
    {{"unable to open database file", "файл хранилища не открыть", "soubor úložiště nelze otevřít", "a tároló fájlja nem nyitható meg"}},
    {{"{0} (unable to open database file)", "{0} (файл не открыть)", "{0} (soubor nelze otevřít)", "{0} (a fájl nem nyitható meg)"}},
    {{"{0} (unable to open database: {1})", "{0} (файл не открыть: {1})", "{0} (soubor nelze otevřít: {1})", "{0} (a fájl nem nyitható meg: {1})"}},
    {{"{0} (database or disk is full)", "{0} (диск полон)", "{0} (disk je plný)", "{0} (a lemez megtelt)"}},
    {{"{0} (disk I/O error)", "{0} (ошибка диска)", "{0} (chyba disku)", "{0} (lemezhiba)"}},
    {{"{0} (database is locked)", "{0} (файл занят другой программой)", "{0} (soubor používá jiný program)", "{0} (a fájlt másik program használja)"}},
    {{"{0} (attempt to write a readonly database)", "{0} (файл только для чтения)", "{0} (soubor je jen pro čtení)", "{0} (a fájl csak olvasható)"}},
    {{"{0} (file is not a database)", "{0} (это не резервная копия)", "{0} (není to záloha)", "{0} (ez nem mentés)"}},
    {{"{0} (output file already exists)", "{0} (такой файл уже есть)", "{0} (soubor už existuje)", "{0} (a fájl már létezik)"}},
    {{"{0} (it cannot be brought to the disk)", "{0} (на диск не записывается)", "{0} (nelze zapsat na disk)", "{0} (nem írható a lemezre)"}},
    {{"{0} (it is a folder)", "{0} (это папка)", "{0} (je to složka)", "{0} (ez mappa)"}},
    {{"{0} (no answer)", "{0} (ответа нет)", "{0} (neodpovídá)", "{0} (nem válaszol)"}},
    {{"{0} (it takes nothing more)", "{0} (больше ничего не принимает)", "{0} (nic dalšího nepřijímá)", "{0} (nem fogad többet)"}},
    {{"it is a folder", "это папка", "je to složka", "ez mappa"}},
    {{"reading failed", "чтение прервалось", "čtení se nezdařilo", "az olvasás nem sikerült"}},
    {{"it is larger than {0} MB", "он больше {0} МБ", "je větší než {0} MB", "nagyobb, mint {0} MB"}},
    {{"a zero byte at offset {0}", "нулевой байт на месте {0}", "nulový bajt na místě {0}", "nulla bájt a(z) {0}. helyen"}},
    // restarts of several channels, meetings that are none (kernel/cyclic/restarts.cpp, channel_commands.cpp)
    {{"L{0} was reset ({1})", "L{0} сброшен ({1})", "L{0} byl resetován ({1})", "L{0} resetelve lett ({1})"}},
    {{"L{0} has an alarm ({1})", "в L{0} авария ({1})", "L{0} má alarm ({1})", "L{0} hibában van ({1})"}},
    {{"L{0} has lost its process ({1})", "процесс L{0} прекратился ({1})", "L{0} ztratil svůj proces ({1})", "L{0} folyamata megszűnt ({1})"}},
    {{"L{0} has come to the end of its program ({1})", "L{0} дошёл до конца программы ({1})", "L{0} došel na konec programu ({1})", "L{0} a programja végére ért ({1})"}},
    {{"L{0} was never asked to ({1})", "L{0} не получил команды ({1})", "L{0} nedostal povel ({1})", "L{0} nem kapott parancsot ({1})"}},
    {{"L{0} cannot begin ({1})", "L{0} не может начать ({1})", "L{0} nemůže začít ({1})", "L{0} nem kezdheti el ({1})"}},
    {{"{0}, one of the two is in dry run", "{0}, один из двух в пробном прогоне", "{0}, jeden z obou má chod naprázdno", "{0}, a kettő közül az egyik próbafutásban van"}},
    {{"{0}, one of the two is there by a block entered by hand", "{0}, один из двух стоит там по кадру, введённому вручную", "{0}, jeden z obou tam je blokem zadaným ručně", "{0}, a kettő közül az egyik kézzel bevitt mondattal van ott"}},
    {{"{0}, one of the two restarts", "{0}, один из двух пускается с кадра", "{0}, jeden z obou začíná od bloku", "{0}, a kettő közül az egyik újraindul"}},
    // what the computer says of its date, its network, its keyboard (timedatectl, nmcli, localectl)
    {{"Access denied", "нет прав", "přístup odepřen", "hozzáférés megtagadva"}},
    {{"Interactive authentication required.", "нужны права администратора компьютера", "jsou třeba práva správce počítače", "a számítógép rendszergazdájának joga kell"}},
    {{"NTP not supported", "времени из сети здесь нет", "čas ze sítě tu není", "itt nincs hálózati idő"}},
    {{"Automatic time synchronization is enabled", "время приходит из сети", "čas přichází ze sítě", "az idő a hálózatról jön"}},
    {{"Failed to connect to bus: {0}", "службы компьютера не отвечают: {0}", "služby počítače neodpovídají: {0}", "a számítógép szolgáltatásai nem válaszolnak: {0}"}},
    {{"Failed to query server: {0}", "служба времени не отвечает: {0}", "služba času neodpovídá: {0}", "az időszolgáltatás nem válaszol: {0}"}},
    {{"Failed to set time: {0}", "время не установлено: {0}", "čas se nenastavil: {0}", "az idő nincs beállítva: {0}"}},
    {{"Failed to set time zone: {0}", "часовой пояс не установлен: {0}", "časové pásmo se nenastavilo: {0}", "az időzóna nincs beállítva: {0}"}},
    {{"Failed to set ntp: {0}", "время из сети не включено: {0}", "čas ze sítě se nezapnul: {0}", "a hálózati idő nincs bekapcsolva: {0}"}},
    {{"Failed to set keymap: {0}", "раскладка не установлена: {0}", "rozložení se nenastavilo: {0}", "a kiosztás nincs beállítva: {0}"}},
    {{"Error: NetworkManager is not running.", "служба сети не работает", "služba sítě neběží", "a hálózati szolgáltatás nem fut"}},
    {{"Error: Connection activation failed: {0}", "соединение не установилось: {0}", "spojení se nenavázalo: {0}", "a kapcsolat nem jött létre: {0}"}},
    // requests in general
    {{"no operation", "нет операции", "žádná operace", "nincs művelet"}},
    {{"not a JSON object", "не объект JSON", "není objekt JSON", "nem JSON-objektum"}},
    {{"fields are missing", "нет fields", "chybí fields", "hiányzik: fields"}},
    {{"{0} is missing", "нет {0}", "chybí {0}", "hiányzik: {0}"}},
    {{"{0}: not a whole number", "{0}: не целое число", "{0}: není celé číslo", "{0}: nem egész szám"}},
    {{"{0}: not a number", "{0}: не число", "{0}: není číslo", "{0}: nem szám"}},
    {{"{0} (operator)", "{0} (оператор)", "{0} (obsluha)", "{0} (kezelő)"}},
    {{"{0} (setter)", "{0} (наладчик)", "{0} (seřizovač)", "{0} (beállító)"}},
    {{"{0} (maker)", "{0} (изготовитель)", "{0} (výrobce)", "{0} (gyártó)"}},
    {{"format {0}: csv, fanuc or sinumerik", "формат {0}: csv, fanuc или sinumerik", "formát {0}: csv, fanuc nebo sinumerik", "{0} formátum: csv, fanuc vagy sinumerik"}},
    {{"there is no column {0}: this machine has {1} free ones (N2903)", "столбца {0} нет: у этого станка {1} свободных (N2903)", "sloupec {0} není: tento stroj má {1} volných (N2903)", "nincs {0} oszlop: ennek a gépnek {1} szabad oszlopa van (N2903)"}},
    {{"there is no column {0}", "столбца {0} нет", "sloupec {0} není", "nincs {0} oszlop"}},
    {{"offsets need a channel that exists", "для корректоров нужен существующий канал", "korekce potřebují existující kanál", "a korrekciókhoz létező csatorna kell"}},
    {{"an import of more than {0} lines", "импорт длиннее {0} строк", "import delší než {0} řádků", "{0} sornál hosszabb import"}},
    // backups, users
    {{"no usable backup in {0}", "в {0} нет годной резервной копии", "v {0} není použitelná záloha", "nincs használható mentés itt: {0}"}},
    {{"this controller keeps nothing, so there is nothing to back up", "эта система ничего не хранит, сохранять нечего", "tento řídicí systém nic neukládá, není co zálohovat", "ez a vezérlés semmit sem tárol, nincs mit menteni"}},
    {{"file: a whole path is needed", "file: нужен полный путь", "file: je třeba celá cesta", "file: teljes elérési út kell"}},
    {{"a password has {0} to {1} characters", "в пароле от {0} до {1} знаков", "heslo má {0} až {1} znaků", "a jelszó {0}–{1} karakter"}},
    {{"the password cannot be hashed", "пароль нельзя зашифровать", "heslo nelze zašifrovat", "a jelszó nem titkosítható"}},
    {{"level {0}: operator, setter or maker", "уровень {0}: operator, setter или maker", "úroveň {0}: operator, setter nebo maker", "{0} szint: operator, setter vagy maker"}},
    {{"a name has 1 to 31 characters without blanks", "в имени от 1 до 31 знака без пробелов", "jméno má 1 až 31 znaků bez mezer", "a név 1–31 karakter, szóköz nélkül"}},
    {{"the user {0} exists", "пользователь {0} уже есть", "uživatel {0} už existuje", "{0} felhasználó már van"}},
    {{"there are {0} users already", "пользователей уже {0}", "uživatelů je už {0}", "már {0} felhasználó van"}},
    {{"the first user must be a maker", "первый пользователь должен быть изготовителем", "první uživatel musí být výrobce", "az első felhasználó csak gyártó lehet"}},
    {{"there is no user {0}", "пользователя {0} нет", "uživatel {0} není", "nincs {0} felhasználó"}},
    {{"{0} is the only maker", "{0} — единственный изготовитель", "{0} je jediný výrobce", "{0} az egyetlen gyártó"}},
    {{"user {0} of this computer is no user of the controller (users add NAME LEVEL uid={1})", "пользователь {0} этого компьютера не пользователь системы (users add NAME LEVEL uid={1})", "uživatel {0} tohoto počítače není uživatelem řídicího systému (users add NAME LEVEL uid={1})", "a számítógép {0} felhasználója nem felhasználója a vezérlésnek (users add NAME LEVEL uid={1})"}},
    // measured parts, pallets, stops
    {{"name: at most 60 characters", "name: не больше 60 знаков", "name: nejvýše 60 znaků", "name: legfeljebb 60 karakter"}},
    {{"upper lies below lower", "верхнее отклонение ниже нижнего", "horní mez leží pod dolní", "a felső határ az alsó alatt van"}},
    {{"dimensions are 1 to 999", "размеры — от 1 до 999", "rozměry jsou 1 až 999", "a méretek száma 1–999"}},
    {{"there is no dimension {0}", "размера {0} нет", "rozměr {0} není", "nincs {0}. méret"}},
    {{"dimension {0} exists", "размер {0} уже есть", "rozměr {0} už existuje", "a(z) {0}. méret már van"}},
    {{"{0} is more than 10 mm from the nominal {1}: another dimension or unit?", "{0} дальше 10 мм от номинала {1}: другой размер или единица?", "{0} je víc než 10 mm od jmenovité hodnoty {1}: jiný rozměr nebo jednotka?", "{0} több mint 10 mm-re van a névleges {1} mérettől: más méret vagy mértékegység?"}},
    {{"nothing was measured since the last correction", "после последней коррекции ничего не измерено", "od poslední korekce se nic neměřilo", "az utolsó korrekció óta nem volt mérés"}},
    {{"a correction of {0} mm: at most {1}", "коррекция {0} мм: не больше {1}", "korekce {0} mm: nejvýše {1}", "{0} mm-es korrekció: legfeljebb {1}"}},
    {{"dimension {0} names neither an offset nor a tool with one", "размер {0} не называет ни корректора, ни инструмента с ним", "rozměr {0} nejmenuje korekci ani nástroj, který ji má", "a(z) {0}. mérethez sem korrekció, sem azzal bíró szerszám nincs megadva"}},
    {{"axis={0}: X, Y or Z", "axis={0}: X, Y или Z", "axis={0}: X, Y nebo Z", "axis={0}: X, Y vagy Z"}},
    {{"program: the path is too long", "program: путь слишком длинный", "program: cesta je příliš dlouhá", "program: az elérési út túl hosszú"}},
    {{"program {0}: 4 or 8 digits (N3300 PRI = 0)", "программа {0}: 4 или 8 цифр (N3300 PRI = 0)", "program {0}: 4 nebo 8 číslic (N3300 PRI = 0)", "{0} program: 4 vagy 8 számjegy (N3300 PRI = 0)"}},
    {{"{0}: a whole number from 0 to {1}", "{0}: целое число от 0 до {1}", "{0}: celé číslo od 0 do {1}", "{0}: egész szám 0 és {1} között"}},
    {{"pallet {0} stands in {1} too", "паллета {0} стоит и в {1}", "paleta {0} stojí i v {1}", "a(z) {0}. paletta itt is áll: {1}"}},
    {{"this machine has no pallets (N3300 PAL)", "у этого станка нет паллет (N3300 PAL)", "tento stroj nemá palety (N3300 PAL)", "ennek a gépnek nincs palettája (N3300 PAL)"}},
    {{"{0}: the table has {1} rows (N3300, N3301)", "{0}: в таблице {1} строк (N3300, N3301)", "{0}: tabulka má {1} řádků (N3300, N3301)", "{0}: a táblázatban {1} sor van (N3300, N3301)"}},
    {{"there is no cause {0}", "причины {0} нет", "příčina {0} není", "nincs {0} ok"}},
    // tools
    {{"tool {0}: the table has {1} rows (N2902)", "инструмент {0}: в таблице {1} строк (N2902)", "nástroj {0}: tabulka má {1} řádků (N2902)", "{0}. szerszám: a táblázatban {1} sor van (N2902)"}},
    {{"{0} tools (N2902)", "{0} инструментов (N2902)", "{0} nástrojů (N2902)", "{0} szerszám (N2902)"}},
    {{"tool {0} exists", "инструмент {0} уже есть", "nástroj {0} už existuje", "a(z) {0}. szerszám már van"}},
    {{"counter: not below 0", "counter: не меньше 0", "counter: ne pod 0", "counter: nem lehet 0 alatt"}},
    {{"{0}: edges are D1 to D12, parameters DP1 to DP35", "{0}: кромки D1–D12, параметры DP1–DP35", "{0}: břity jsou D1 až D12, parametry DP1 až DP35", "{0}: az élek D1–D12, a paraméterek DP1–DP35"}},
    {{"{0}: use tools load, unload or move", "{0}: для этого tools load, unload или move", "{0}: k tomu je tools load, unload nebo move", "{0}: erre a tools load, unload vagy move való"}},
    {{"{0} holds tool {1}", "в {0} стоит инструмент {1}", "v {0} je nástroj {1}", "{0}: ott a(z) {1}. szerszám áll"}},
    {{"{0} is locked", "{0}: место закрыто", "{0}: místo je zamčené", "{0}: a hely zárolt"}},
    {{"tool {0} works in channel L{1}: it cannot be moved", "инструмент {0} работает в канале L{1}: его нельзя переместить", "nástroj {0} pracuje v kanálu L{1}: nelze ho přemístit", "a(z) {0}. szerszám az L{1} csatornában dolgozik: nem helyezhető át"}},
    {{"tool {0} works in channel L{1}: it cannot be unloaded", "инструмент {0} работает в канале L{1}: его нельзя выгрузить", "nástroj {0} pracuje v kanálu L{1}: nelze ho vyjmout", "a(z) {0}. szerszám az L{1} csatornában dolgozik: nem vehető ki"}},
    {{"tool {0} works in channel L{1}: it cannot be deleted", "инструмент {0} работает в канале L{1}: его нельзя удалить", "nástroj {0} pracuje v kanálu L{1}: nelze ho smazat", "a(z) {0}. szerszám az L{1} csatornában dolgozik: nem törölhető"}},
    {{"several tools are called {0}: say the number", "инструментов с именем {0} несколько: укажите номер", "nástrojů jménem {0} je víc: udejte číslo", "több szerszám neve {0}: adja meg a számot"}},
    {{"tool {0} stands nowhere: load it", "инструмент {0} нигде не стоит: загрузите его", "nástroj {0} nikde nestojí: vložte ho", "a(z) {0}. szerszám sehol sem áll: töltse be"}},
    {{"tool {0} stands nowhere", "инструмент {0} нигде не стоит", "nástroj {0} nikde nestojí", "a(z) {0}. szerszám sehol sem áll"}},
    {{"tool {0} stands in {1}: move or unload it", "инструмент {0} стоит в {1}: переместите или выгрузите его", "nástroj {0} stojí v {1}: přemístěte ho nebo vyjměte", "a(z) {0}. szerszám itt áll: {1}; helyezze át vagy vegye ki"}},
    {{"magazine {0} has no free place for tool {1}", "в магазине {0} нет свободного места для инструмента {1}", "zásobník {0} nemá volné místo pro nástroj {1}", "a(z) {0}. tárban nincs szabad hely a(z) {1}. szerszámnak"}},
    {{"tool {0} needs places of kind {1}, {2} is of kind {3}", "инструменту {0} нужны места вида {1}, {2} вида {3}", "nástroj {0} potřebuje místa druhu {1}, {2} je druhu {3}", "a(z) {0}. szerszámnak {1} fajtájú hely kell, {2} fajtája {3}"}},
    {{"tool {0} needs {1} half places, the magazine has {2}", "инструменту {0} нужно {1} полумест, в магазине {2}", "nástroj {0} potřebuje {1} půlmíst, zásobník má {2}", "a(z) {0}. szerszámnak {1} félhely kell, a tárban {2} van"}},
    {{"tool {0} in {1} would touch tool {2} in {3}", "инструмент {0} в {1} заденет инструмент {2} в {3}", "nástroj {0} v {1} by zavadil o nástroj {2} v {3}", "a(z) {0}. szerszám itt: {1} hozzáérne a(z) {2}. szerszámhoz itt: {3}"}},
    {{"station {0} of channel L{1}", "позиция {0} канала L{1}", "pozice {0} kanálu L{1}", "az L{1} csatorna {0}. állomása"}},
    {{"tool life group {0}", "группа стойкости {0}", "skupina trvanlivosti {0}", "{0}. éltartamcsoport"}},
    // the presetter
    {{"the frames do not show the same: tool, camera or light move", "кадры различаются: движется инструмент, камера или свет", "snímky se liší: hýbe se nástroj, kamera nebo světlo", "a képek eltérnek: a szerszám, a kamera vagy a fény mozog"}},
    {{"the calibration is for pictures of {0} x {1} pixels", "калибровка для снимков {0} x {1} точек", "kalibrace je pro snímky {0} x {1} bodů", "a kalibrálás {0} x {1} képpontos képekhez való"}},
    {{"what it shows is held by nothing: it is dirt, or it is cut off", "то, что видно, ничто не держит: это грязь, или снимок обрезан", "to, co je vidět, nic nedrží: je to nečistota, nebo je snímek uříznutý", "amit mutat, azt nem tartja semmi: szennyeződés, vagy le van vágva"}},
    {{"polyturn-presetter is not here: it is built where OpenCV is installed", "polyturn-presetter здесь нет: он собирается там, где есть OpenCV", "polyturn-presetter tu není: sestaví se tam, kde je OpenCV", "a polyturn-presetter nincs itt: ott épül, ahol van OpenCV"}},
    // what the kernel refuses
    {{"the program waits for an answer to its dialogue", "программа ждёт ответа на свой вопрос", "program čeká na odpověď ve svém dialogu", "a program a párbeszédére vár választ"}},
    {{"no dialogue of the program is open", "программа ничего не спрашивает", "program se na nic neptá", "a program nem kérdez semmit"}},
    {{"too many answers at a time", "слишком много ответов сразу", "příliš mnoho odpovědí najednou", "túl sok válasz egyszerre"}},
    {{"more than {0} answers at a time", "больше {0} ответов сразу", "víc než {0} odpovědí najednou", "{0} válasznál több egyszerre"}},
    {{"a program is restarted at a block only in reset or after the end", "с кадра программа запускается только после сброса или конца", "od věty se program spouští jen po resetu nebo po konci", "mondatról a program csak alaphelyzetben vagy a vége után indítható"}},
    {{"another program is selected only in reset or after the end", "другая программа выбирается только после сброса или конца", "jiný program se volí jen po resetu nebo po konci", "másik program csak alaphelyzetben vagy a vége után választható"}},
    {{"a block is entered only in reset or after the end", "кадр вводится только после сброса или конца", "věta se zadává jen po resetu nebo po konci", "mondat csak alaphelyzetben vagy a vége után adható meg"}},
    {{"axes were moved in the hold, and this block cannot go on from elsewhere (press return)", "на паузе оси сдвинули, а этот кадр не может продолжиться из другого места (возврат)", "v pozastavení se osy posunuly a tato věta nemůže pokračovat odjinud (návrat)", "felfüggesztésben a tengelyek elmozdultak, és ez a mondat máshonnan nem folytatható (visszatérés)"}},
    {{"the program cannot be left in this block", "в этом кадре программу нельзя покинуть", "v této větě nelze program opustit", "ebben a mondatban a program nem hagyható el"}},
    {{"the block in which the program is held cannot be read again", "кадр, на котором программа стоит, нельзя прочитать заново", "větu, ve které je program pozastaven, nelze číst znovu", "a mondat, amelyben a program áll, nem olvasható be újra"}},
    {{"since the search for the block another sister has taken its place; restart again", "после поиска кадра его место заняла другая замена; запустите снова", "od hledání věty zaujal místo jiný náhradní nástroj; spusťte znovu", "a mondatkeresés óta másik testvérszerszám lépett a helyére; indítsa újra"}},
    {{"the store does not run", "хранилище не работает", "úložiště neběží", "a tároló nem fut"}},
    {{"the store does not answer", "хранилище не отвечает", "úložiště neodpovídá", "a tároló nem válaszol"}},
    {{"the store has not yet taken what was written before", "хранилище ещё не приняло записанного раньше", "úložiště ještě nepřevzalo, co se zapsalo dříve", "a tároló még nem vette át a korábban írottakat"}},
    {{"the spindle has become too fast for the axes", "шпиндель стал слишком быстрым для осей", "vřeteno je pro osy příliš rychlé", "az orsó túl gyors lett a tengelyeknek"}},
    {{"not in this block", "не в этом кадре", "ne v této větě", "ebben a mondatban nem"}},
    {{"the program is not held", "программа не на паузе", "program není pozastaven", "a program nincs felfüggesztve"}},
    {{"the axes are not on the path that is to be driven back", "оси не на траектории, по которой нужно вернуться", "osy nejsou na dráze, po které se má jet zpět", "a tengelyek nincsenek a visszafelé bejárandó pályán"}},
    {{"a thread of too many steps", "резьба из слишком многих шагов", "závit z příliš mnoha kroků", "túl sok lépésből álló menet"}},
    {{"unknown kind", "неизвестный вид", "neznámý druh", "ismeretlen fajta"}},
    {{"axes are moved in a hold when the path has come to rest in it", "на паузе оси двигают, когда движение в ней остановилось", "v pozastavení se osy posouvají, až se v něm dráha zastaví", "felfüggesztésben a tengelyek akkor mozgathatók, ha a pálya már megállt"}},
    {{"the tool touches the setter: move it away", "инструмент касается датчика: отведите его", "nástroj se dotýká sondy: odjeďte s ním", "a szerszám a bemérőhöz ér: vigye el"}},
    {{"no block is entered", "кадр не введён", "není zadána žádná věta", "nincs beírva mondat"}},
    {{"the axis still moves", "ось ещё движется", "osa se ještě pohybuje", "a tengely még mozog"}},
    {{"the axis is at the end of its stroke; the other direction is free", "ось в конце хода; в другую сторону свободно", "osa je na konci zdvihu; druhý směr je volný", "a tengely a löket végén áll; a másik irány szabad"}},
    {{"the handwheel drives a program only after program_wheel", "маховик ведёт программу только после program_wheel", "kolečko vede program až po program_wheel", "a kézikerék csak a program_wheel után viszi a programot"}},
    {{"the emergency stop circuit is open: turn the button back", "цепь аварийного останова разомкнута: отпустите кнопку", "obvod nouzového zastavení je rozpojený: uvolněte tlačítko", "a vészleállító kör nyitott: engedje vissza a gombot"}},
    {{"the machine is not on", "станок не включён", "stroj není zapnut", "a gép nincs bekapcsolva"}},
    {{"machine.compensation was not taken (params check says why)", "machine.compensation не принят (почему, скажет params check)", "machine.compensation se nepřevzal (proč, řekne params check)", "a machine.compensation átvétele elmaradt (az okát a params check mondja meg)"}},
    {{"the machine has no folder for it", "у станка нет для этого папки", "stroj na to nemá složku", "a gépnek nincs ehhez mappája"}},
    // what the supervisor refuses, and processes
    {{"no program is selected", "программа не выбрана", "není zvolen program", "nincs kiválasztott program"}},
    {{"two jobs at once: {0}", "два задания сразу: {0}", "dvě zakázky najednou: {0}", "két feladat egyszerre: {0}"}},
    {{"the machine has no drive {0}", "у станка нет привода {0}", "stroj nemá pohon {0}", "a gépnek nincs {0} hajtása"}},
    {{"the machine has no {0}", "у станка нет {0}", "stroj nemá {0}", "a gépnek nincs {0}"}},
    {{"'{0}' is not of the form: {1}", "'{0}' не по образцу: {1}", "'{0}' nemá tvar: {1}", "'{0}' alakja nem: {1}"}},
    {{"longer than {0} characters: {1}", "длиннее {0} знаков: {1}", "delší než {0} znaků: {1}", "{0} karakternél hosszabb: {1}"}},
    {{"the line is too long: {0}", "строка слишком длинная: {0}", "řádek je příliš dlouhý: {0}", "a sor túl hosszú: {0}"}},
    {{"an input is 0 or 1", "вход — 0 или 1", "vstup je 0 nebo 1", "egy bemenet 0 vagy 1"}},
    {{"{0} is an input of the program: 0 or 1", "{0} — вход программы: 0 или 1", "{0} je vstup programu: 0 nebo 1", "{0} a program bemenete: 0 vagy 1"}},
    {{"{0} is no value of {1}", "{0} — не значение {1}", "{0} není hodnota {1}", "{0} nem értéke ennek: {1}"}},
    {{"a drive is set to fault, encoder, silent, dead, 'delay N' or 'loses N' (1 to 60 cycles) or ok", "приводу задают fault, encoder, silent, dead, 'delay N' или 'loses N' (от 1 до 60 циклов) или ok", "pohonu se zadává fault, encoder, silent, dead, 'delay N' nebo 'loses N' (1 až 60 cyklů) nebo ok", "a hajtásnak fault, encoder, silent, dead, 'delay N' vagy 'loses N' (1–60 ciklus) vagy ok adható"}},
    {{"it gave no answer", "ответа нет", "neodpověděl", "nem válaszolt"}},
    {{"too many programs ask at once", "спрашивают слишком многие программы сразу", "ptá se příliš mnoho programů najednou", "túl sok program kérdez egyszerre"}},
    {{"the machine was started anew", "станок запущен заново", "stroj byl spuštěn znovu", "a gép újraindult"}},
    {{"the process {0} died while it started", "процесс {0} завершился при запуске", "proces {0} skončil při spouštění", "a(z) {0} folyamat indulás közben leállt"}},
    {{"{0} does not get ready", "{0} не становится готов", "{0} není připraven", "{0} nem készül el"}},
    {{"stopped while it started", "остановлен при запуске", "zastaven při spouštění", "indulás közben leállították"}},
    {{"the machine does not come to rest after its start", "после запуска станок не приходит в покой", "stroj se po spuštění neustálí", "a gép indulás után nem jut nyugalomba"}},
    {{"its socket ({0})", "его сокет ({0})", "jeho soket ({0})", "a foglalata ({0})"}},
    {{"its name is longer than {0} characters", "его имя длиннее {0} знаков", "jeho jméno je delší než {0} znaků", "a neve {0} karakternél hosszabb"}},
});

// The parts of `text` that stand for {0} to {3}; they match as little as they can. False: it does not read so.
bool read_detail(std::string_view pattern, std::string_view text, std::string_view (&parts)[4]) {
    const std::size_t open = pattern.find('{');
    if (open == std::string_view::npos) return pattern == text;
    if (text.substr(0, open) != pattern.substr(0, open)) return false;
    const auto part = static_cast<std::size_t>(pattern[open + 1] - '0');
    const std::string_view rest = pattern.substr(open + 3);
    for (std::size_t end = open + 1; end <= text.size(); ++end)
        if (read_detail(rest, text.substr(end), parts)) return parts[part] = text.substr(open, end - open), true;
    return false;
}

// A part that is a detail itself, or quotes the operating system.
std::string detail_part(std::string_view told, Tongue tongue) {
    for (const DetailRow& row : kDetails)
        for (const Tongue from : kTongues)
            if (row.in[static_cast<std::size_t>(from)] == told) return std::string(row.in[static_cast<std::size_t>(tongue)]);
    return os_errors_in(told, tongue);
}

}  // namespace

std::span<const DetailRow> detail_rows() { return kDetails; }

std::string detail_in(std::string_view told, Tongue tongue) {
    for (const Tongue from : kTongues)
        for (const DetailRow& row : kDetails) {
            std::string_view parts[4];
            if (!read_detail(row.in[static_cast<std::size_t>(from)], told, parts)) continue;
            std::string out;
            const std::string_view text = row.in[static_cast<std::size_t>(tongue)];
            for (std::size_t i = 0; i < text.size(); ++i) {
                if (text[i] == '{') out += detail_part(parts[text[i + 1] - '0'], tongue), i += 2;
                else out += text[i];
            }
            return out;
        }
    return os_errors_in(told, tongue);
}

}  // namespace polyturn
