<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="cs_CZ" sourcelanguage="en">
<context>
    <name>hmi</name>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>A start needs:</source>
        <translation>Start vyžaduje:</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Absent</source>
        <translation>Není</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Automatic</source>
        <translation>Automatika</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Block skip</source>
        <translation>Vypuštění bloků</translation>
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
        <location filename="../screens/channel_card.cpp"/>
        <source>Dry run</source>
        <translation>Chod naprázdno</translation>
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
        <location filename="../screens/overview.cpp"/>
        <source>Ends all programs: press again</source>
        <translation>Ukončí vše: znovu</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Ends the program: press again</source>
        <translation>Ukončí program: znovu</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Feed hold: start goes on</source>
        <translation>Stop posuvu: start pokračuje</translation>
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
        <location filename="../screens/channel_card.cpp"/>
        <source>Follow. error</source>
        <translation>Odchylka</translation>
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
        <location filename="../screens/overview.cpp"/>
        <source>Hold %1</source>
        <translation>Stop posuvu %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Hold all</source>
        <translation>Stop všech</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Interrupted</source>
        <translation>Přerušen</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Jog</source>
        <translation>Ruční</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Last</source>
        <translation>Minulý</translation>
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
        <location filename="../screens/channel_card.cpp"/>
        <source>Mean</source>
        <translation>Průměr</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>No controller answers</source>
        <translation>Řízení neodpovídá</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Offset</source>
        <translation>Korekce</translation>
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
        <location filename="../screens/overview.hpp"/>
        <source>Overview</source>
        <translation>Přehled</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Parts</source>
        <translation>Kusy</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Process dead</source>
        <translation>Proces skončil</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Programmed stop M0: start goes on</source>
        <translation>Programový stop M0: start pokračuje</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Rapid</source>
        <translation>Rychlop.</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Reference</source>
        <translation>Reference</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Remaining</source>
        <translation>Zbývá</translation>
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
        <location filename="../screens/overview.cpp"/>
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
        <location filename="../machine/channel_words.cpp"/>
        <source>Runs</source>
        <translation>Běží</translation>
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
        <location filename="../screens/overview.cpp"/>
        <source>Start %1</source>
        <translation>Start %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Start all</source>
        <translation>Start všech</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Starts all channels: press again</source>
        <translation>Spustí vše: znovu</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Stopped</source>
        <translation>Zastaven</translation>
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
        <location filename="../machine/requests.cpp"/>
        <source>There is no connection to the controller.</source>
        <translation>Není spojení s řízením.</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>To go</source>
        <translation>Zbývá</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Touches and keys do nothing. The machine goes on.</source>
        <translation>Dotyky a klávesy nefungují. Stroj běží dál.</translation>
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
        <location filename="../screens/channel_card.cpp"/>
        <source>Workpiece</source>
        <translation>Obrobek</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>a marker</source>
        <translation>značce</translation>
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
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>not all axes are referenced</source>
        <translation>osy nemají referenci</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>not referenced</source>
        <translation>bez reference</translation>
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
