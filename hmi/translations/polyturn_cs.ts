<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="cs_CZ" sourcelanguage="en">
<context>
    <name>hmi</name>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>%1 in all</source>
        <translation>celkem %1</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>%1 is selected in L%2</source>
        <translation>%1 zvolen v L%2</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>%1 is selected in its channels</source>
        <translation>%1 zvoleno ve svých kanálech</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>%1 s after the start of the controller</source>
        <translation>%1 s po startu řízení</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>+ Input</source>
        <translation>+ Vstup</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>A block by hand (MDI)</source>
        <translation>Blok ručně (MDI)</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>A start needs:</source>
        <translation>Start vyžaduje:</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>A text: it is changed by polyturn params set</source>
        <translation>Text: mění se příkazem polyturn params set</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Absent</source>
        <translation>Není</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Active at the next T</source>
        <translation>Od dalšího T</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Active from the next blocks</source>
        <translation>Od dalších bloků</translation>
    </message>
    <message>
        <location filename="../screens/alarms.hpp"/>
        <source>Alarms</source>
        <translation>Alarmy</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>All</source>
        <translation>Vše</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>All groups</source>
        <translation>Všechny skupiny</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>All zeros together</source>
        <translation>Všechny nuly</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Applied now</source>
        <translation>Nyní platí</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>As held</source>
        <translation>Při stisku</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Automatic</source>
        <translation>Automatika</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Axes</source>
        <translation>Osy</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Axes and drives</source>
        <translation>Osy a pohony</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Axis</source>
        <translation>Osa</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Block skip</source>
        <translation>Vypuštění bloků</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Changed</source>
        <translation>Změněno</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Changed only</source>
        <translation>Jen změněné</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Changes since the start of these screens</source>
        <translation>Změny od startu obrazovek</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Channel</source>
        <translation>Kanál</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Check, waits</source>
        <translation>Kontrola, čekání</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>Choose a field</source>
        <translation>Zvolte pole</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Choose a job or a program</source>
        <translation>Zvolte úlohu nebo program</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Clear</source>
        <translation>Smazat</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Clear search</source>
        <translation>Smazat hledání</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Commanded</source>
        <translation>Zadáno</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Compensation</source>
        <translation>Kompenzace</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Computing time of ticks</source>
        <translation>Doba výpočtu taktů</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Couplings</source>
        <translation>Vazby</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Couplings and exchanges</source>
        <translation>Vazby a záměny</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>Cutting</source>
        <translation>Řez</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Cycle</source>
        <translation>Cyklus</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Dark</source>
        <translation>Tmavý</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Default</source>
        <translation>Výchozí</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Default value</source>
        <translation>Výchozí hodnota</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Depends on</source>
        <translation>Závisí na</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Drive fault</source>
        <translation>Porucha pohonu</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Dry run</source>
        <translation>Chod naprázdno</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Dry run, timeline</source>
        <translation>Zkušební běh, osa</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>Dwell</source>
        <translation>Prodleva</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Emergency stop</source>
        <translation>Nouzový stop</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>End with this part</source>
        <translation>Konec po tomto kusu</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Ended</source>
        <translation>Ukončen</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Ends all programs: press again</source>
        <translation>Ukončí vše: znovu</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Ends the program: press again</source>
        <translation>Ukončí program: znovu</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Every axis and spindle is on its own: nothing is coupled, exchanged or followed.</source>
        <translation>Každá osa a vřeteno je samostatné: žádná vazba, záměna ani sledování.</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>External</source>
        <translation>Externí</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Feed</source>
        <translation>Posuv</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Feed hold: start goes on</source>
        <translation>Stop posuvu: start pokračuje</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Files</source>
        <translation>Soubory</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>First part</source>
        <translation>První kus</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>First part: start goes on with this tool</source>
        <translation>První kus: start pokračuje tímto nástrojem</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Follow. error</source>
        <translation>Odchylka</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>From</source>
        <translation>Od</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Geom.</source>
        <translation>Geom.</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Geometry + wear</source>
        <translation>Geometrie + opotř.</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Graphics</source>
        <translation>Grafika</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Handwheel</source>
        <translation>Kolečko</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Held</source>
        <translation>Pozastaven</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>History</source>
        <translation>Historie</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Hold %1</source>
        <translation>Stop posuvu %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Hold all</source>
        <translation>Stop všech</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>How</source>
        <translation>Jak</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>In position</source>
        <translation>V poloze</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Input</source>
        <translation>Vstup</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Interrupted</source>
        <translation>Přerušen</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>It cannot be shown.</source>
        <translation>Nelze zobrazit.</translation>
    </message>
    <message>
        <location filename="../machine/dry_run.cpp"/>
        <source>It gave no result.</source>
        <translation>Nedal výsledek.</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Jog</source>
        <translation>Ruční</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Larger</source>
        <translation>Větší</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Last</source>
        <translation>Minulý</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Leave the hold %1</source>
        <translation>Odjet %1</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Level</source>
        <translation>Úroveň</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Light</source>
        <translation>Světlý</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Lock</source>
        <translation>Zámek</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Locked for cleaning</source>
        <translation>Uzamčeno pro čištění</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>Longest wait: L%1 stands %2 s at M%3 (line %4). Work moved from the channel that comes last to L%1 saves up to this time.</source>
        <translation>Nejdelší čekání: L%1 stojí %2 s na M%3 (řádek %4). Práce přesunutá z posledního kanálu na L%1 ušetří až tento čas.</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>Look whether the controller runs; try again.</source>
        <translation>Ověřte, zda řízení běží; zkuste znovu.</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>MDI</source>
        <translation>MDI</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Machine</source>
        <translation>Stroj</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Machine lock</source>
        <translation>Blokování os</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Machine on</source>
        <translation>Stroj zap.</translation>
    </message>
    <message>
        <location filename="../screens/manual.hpp"/>
        <source>Manual</source>
        <translation>Ručně</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Mean</source>
        <translation>Průměr</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Meaning</source>
        <translation>Význam</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Measured</source>
        <translation>Změřeno</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Message</source>
        <translation>Zpráva</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Moves</source>
        <translation>Jede</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Name</source>
        <translation>Název</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>No alarm stands.</source>
        <translation>Žádný alarm netrvá.</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>No controller answers</source>
        <translation>Řízení neodpovídá</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>No faults found</source>
        <translation>Bez závad</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>No job names the stock of the running program</source>
        <translation>Žádná úloha neuvádí polotovar programu</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>No parameter has this in its number, name or meaning.</source>
        <translation>Žádný parametr to nemá v čísle, názvu ani významu.</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>No signal has this in its name or meaning.</source>
        <translation>Žádný signál to nemá v názvu ani významu.</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>No.</source>
        <translation>Č.</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>None is known.</source>
        <translation>Není známa.</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Not in position</source>
        <translation>Mimo polohu</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Not in use by the running program</source>
        <translation>Program ji nepoužívá</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Nothing has been told since the controller started.</source>
        <translation>Od startu řízení nebylo nic hlášeno.</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Nothing is missing</source>
        <translation>Nic nechybí</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Number</source>
        <translation>Číslo</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Offset</source>
        <translation>Korekce</translation>
    </message>
    <message>
        <location filename="../screens/offsets.hpp"/>
        <source>Offsets</source>
        <translation>Korekce</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Open folder</source>
        <translation>Otevřít složku</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Optional stop</source>
        <translation>Volitelný stop</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Optional stop %1</source>
        <translation>Volitelný stop %1</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Optional stop M1: start goes on</source>
        <translation>Volitelný stop M1: start pokračuje</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Overrides</source>
        <translation>Korekce rychlostí</translation>
    </message>
    <message>
        <location filename="../screens/overview.hpp"/>
        <source>Overview</source>
        <translation>Přehled</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Parameters</source>
        <translation>Parametry</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Parts</source>
        <translation>Kusy</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Place</source>
        <translation>Místo</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Process</source>
        <translation>Proces</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Process dead</source>
        <translation>Proces skončil</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Processes</source>
        <translation>Procesy</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Processes and ticks</source>
        <translation>Procesy a takty</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Programmed stop M0: start goes on</source>
        <translation>Programový stop M0: start pokračuje</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Programs</source>
        <translation>Programy</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Programs and jobs</source>
        <translation>Programy a úlohy</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Radius</source>
        <translation>Rádius</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Range</source>
        <translation>Rozsah</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Rapid</source>
        <translation>Rychlop.</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Read again</source>
        <translation>Načíst znovu</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Reference</source>
        <translation>Reference</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Reference all</source>
        <translation>Reference všech</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Remaining</source>
        <translation>Zbývá</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Remedy</source>
        <translation>Náprava</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Reset</source>
        <translation>Reset</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Reset %1</source>
        <translation>Reset %1</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Reset L%1</source>
        <translation>Reset L%1</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Reset all</source>
        <translation>Reset všech</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Restart: start makes the approach</source>
        <translation>Opakovaný start: start provede najetí</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Retrace has come to its end</source>
        <translation>Zpětný chod je na konci</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Return %1</source>
        <translation>Návrat %1</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Runs</source>
        <translation>Běží</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Search</source>
        <translation>Hledat</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Search: number, name or meaning</source>
        <translation>Hledat: číslo, název nebo význam</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Select in L%1</source>
        <translation>Zvolit v L%1</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Select job</source>
        <translation>Zvolit úlohu</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Sets the default: press again</source>
        <translation>Nastaví výchozí: znovu</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Sets the zero: press again</source>
        <translation>Nastaví nulu: znovu</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Signal</source>
        <translation>Signál</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Signals</source>
        <translation>Signály</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Signals of NC and PLC</source>
        <translation>Signály NC a PLC</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Since the start of these screens; tips as points, without width and radius</source>
        <translation>Od startu obrazovek; břity jako body, bez šířky a rádiusu</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Single block</source>
        <translation>Po bloku</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Single block %1</source>
        <translation>Po bloku %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Single block all</source>
        <translation>Po bloku všechny</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Single block: start does the next one</source>
        <translation>Po bloku: start provede další</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Size</source>
        <translation>Velikost</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Smaller</source>
        <translation>Menší</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Spindle</source>
        <translation>Vřeteno</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Start %1</source>
        <translation>Start %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Start all</source>
        <translation>Start všech</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Starts</source>
        <translation>Startuje</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Starts all channels: press again</source>
        <translation>Spustí vše: znovu</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>State</source>
        <translation>Stav</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Stock</source>
        <translation>Polotovar</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Stopped</source>
        <translation>Zastaven</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Synchronised view</source>
        <translation>Synchronní pohled</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>The controller gave no answer.</source>
        <translation>Řízení neodpovědělo.</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>The controller refused.</source>
        <translation>Řízení odmítlo.</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>The job is being driven in virtual time</source>
        <translation>Úloha běží ve virtuálním čase</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>The machine works with it</source>
        <translation>Stroj s tím pracuje</translation>
    </message>
    <message>
        <location filename="../machine/dry_run.cpp"/>
        <source>The program polyturn is not beside the HMI.</source>
        <translation>Program polyturn není vedle HMI.</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>The programs are being read</source>
        <translation>Programy se čtou</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>There is no connection to the controller.</source>
        <translation>Není spojení s řízením.</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>This folder is empty.</source>
        <translation>Složka je prázdná.</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>This is here</source>
        <translation>Zde je toto</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Time</source>
        <translation>Čas</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Timeline</source>
        <translation>Časová osa</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Tip</source>
        <translation>Břit</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Tip is at this measure: press again</source>
        <translation>Břit je na míře: znovu</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>To go</source>
        <translation>Zbývá</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Tool offsets</source>
        <translation>Korekce nástrojů</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Tools that it needs</source>
        <translation>Potřebné nástroje</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Torque</source>
        <translation>Moment</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Touch the line, type, Enter starts it</source>
        <translation>Dotkněte se řádku, pište, Enter spustí</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Touches and keys do nothing. The machine goes on.</source>
        <translation>Dotyky a klávesy nefungují. Stroj běží dál.</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Type a part of the name</source>
        <translation>Zadejte část názvu</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Undo</source>
        <translation>Zpět</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Unit</source>
        <translation>Jednotka</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Up</source>
        <translation>Nahoru</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Value</source>
        <translation>Hodnota</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>Waiting</source>
        <translation>Čekání</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Waiting for the controller</source>
        <translation>Čekání na řízení</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits</source>
        <translation>Čeká</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits at %1 for %2, since %3</source>
        <translation>Čeká na %1 na %2, již %3</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits at %1, all are there</source>
        <translation>Čeká na %1, všichni jsou tu</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Wear</source>
        <translation>Opotř.</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Wear R</source>
        <translation>Opotř. R</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>What</source>
        <translation>Co</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>What stands</source>
        <translation>Trvající</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Without effect:</source>
        <translation>Bez účinku:</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Work shift</source>
        <translation>Posunutí</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Work zeros</source>
        <translation>Nulové body</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Workpiece</source>
        <translation>Obrobek</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Zero</source>
        <translation>Nula</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Zero here</source>
        <translation>Nula zde</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>a marker</source>
        <translation>značce</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>acts after a restart of the controller</source>
        <translation>působí po restartu řízení</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>acts at once</source>
        <translation>působí ihned</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>acts at the channel's next stop of reading</source>
        <translation>působí při dalším zastavení čtení</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>an alarm has stopped everything</source>
        <translation>alarm vše zastavil</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>an alarm of the channel stands</source>
        <translation>trvá alarm kanálu</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>an axis is being moved by hand</source>
        <translation>osou se ručně pohybuje</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>attach it (AP_DETCHR)</source>
        <translation>připojte ji (AP_DETCHR)</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>axes are on their way to their reference points</source>
        <translation>osy jedou do referenčních bodů</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>axes were moved in the hold</source>
        <translation>osy byly odjety v pozastavení</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>bore</source>
        <translation>otvor</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>bring a tool into place</source>
        <translation>nastavte nástroj</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>bring it to its end</source>
        <translation>dojeďte jím na konec</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>choose auto or mdi</source>
        <translation>zvolte automatiku nebo MDI</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>close it, look at its pressure</source>
        <translation>zavřete je, ověřte tlak</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>close it, or switch to setup mode</source>
        <translation>zavřete je nebo zapněte seřizování</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>detached</source>
        <translation>odpojena</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>everything was stopped by an alarm</source>
        <translation>vše zastavil alarm</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>fill up its oil</source>
        <translation>doplňte olej</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>follows it synchronously</source>
        <translation>sleduje ji synchronně</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>its way is added to the own one</source>
        <translation>její dráha se přičítá</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>line</source>
        <translation>řádek</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>load a new one</source>
        <translation>vložte novou</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>longest %1 of a tick of %2 µs</source>
        <translation>nejdelší %1 z taktu %2 µs</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>maker</source>
        <translation>výrobce</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>moves its drive: the axes are exchanged</source>
        <translation>pohybuje jejím pohonem: osy zaměněny</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>never comes: %1</source>
        <translation>nikdy nepřijde: %1</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no program</source>
        <translation>bez programu</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no ref.</source>
        <translation>bez ref.</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>no tool is in place, the turret is not locked</source>
        <translation>nástroj není na místě, hlava není zajištěna</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no tool known</source>
        <translation>bez nástroje</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>not a number yet</source>
        <translation>ještě ne číslo</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>not all axes are referenced</source>
        <translation>osy nemají referenci</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>not referenced</source>
        <translation>bez reference</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>operator</source>
        <translation>obsluha</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>press machine on</source>
        <translation>zapněte stroj</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>press reference all</source>
        <translation>stiskněte reference všech</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>press reset</source>
        <translation>stiskněte reset</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>press return</source>
        <translation>stiskněte návrat</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>reference it</source>
        <translation>najeďte referenci</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>release it and switch the machine on</source>
        <translation>uvolněte jej a zapněte stroj</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>remove its cause and reset</source>
        <translation>odstraňte příčinu a reset</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>remove its cause, then press reset</source>
        <translation>odstraňte příčinu, pak reset</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>setter</source>
        <translation>seřizovač</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>switch it on</source>
        <translation>zapněte jej</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the bar is used up</source>
        <translation>tyč je spotřebována</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the channel's process is not there</source>
        <translation>proces kanálu neběží</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the chuck does not hold</source>
        <translation>sklíčidlo nedrží</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the door is open</source>
        <translation>dveře jsou otevřené</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the emergency stop is active</source>
        <translation>nouzové zastavení je aktivní</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the lubrication is missing</source>
        <translation>chybí mazání</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>the machine</source>
        <translation>stroj</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the machine is not switched on</source>
        <translation>stroj není zapnut</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>the machine is off</source>
        <translation>stroj je vypnut</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>the machine is ready</source>
        <translation>stroj je připraven</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the mode is for moving by hand</source>
        <translation>režim je ruční</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the reset is not over</source>
        <translation>reset neskončil</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the store is dead: nothing would be kept</source>
        <translation>úložiště neběží: nic by se neuložilo</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the tailstock is neither back nor does it hold</source>
        <translation>koník není vzadu ani nedrží</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>tip</source>
        <translation>břit</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>turn the button back, then press machine on</source>
        <translation>uvolněte tlačítko, pak zapněte stroj</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>turns as spindle S%1</source>
        <translation>otáčí se jako vřeteno S%1</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>turns with it, deviation %1°</source>
        <translation>otáčí se s ním, odchylka %1°</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>wait</source>
        <translation>počkejte</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it is started again, then reset</source>
        <translation>počkejte na jeho spuštění, pak reset</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it rests</source>
        <translation>počkejte, až stojí</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it runs again</source>
        <translation>počkejte, až poběží</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until the axes rest</source>
        <translation>počkejte, až osy stojí</translation>
    </message>
</context>
</TS>
