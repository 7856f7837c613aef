<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="hu_HU" sourcelanguage="en">
<context>
    <name>hmi</name>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>A start needs:</source>
        <translation>Az indításhoz kell:</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Absent</source>
        <translation>Nincs</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Automatic</source>
        <translation>Automata</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Block skip</source>
        <translation>Mondatkihagyás</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Cycle</source>
        <translation>Ciklus</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Dark</source>
        <translation>Sötét</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Dry run</source>
        <translation>Próbafutás</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>End with this part</source>
        <translation>Vége e darabbal</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Ended</source>
        <translation>Kész</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Ends all programs: press again</source>
        <translation>Mindet befejezi: újra</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Ends the program: press again</source>
        <translation>Befejezi a programot: újra</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Feed hold: start goes on</source>
        <translation>Előtolás-állj: a start folytatja</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>First part</source>
        <translation>Első darab</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>First part: start goes on with this tool</source>
        <translation>Első darab: a start ezzel a szerszámmal folytatja</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Follow. error</source>
        <translation>Köv. hiba</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Handwheel</source>
        <translation>Kézikerék</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Held</source>
        <translation>Tartva</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Hold %1</source>
        <translation>Állj %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Hold all</source>
        <translation>Állj mind</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Interrupted</source>
        <translation>Megszakítva</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Jog</source>
        <translation>Kézi</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Last</source>
        <translation>Előző</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Light</source>
        <translation>Világos</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Lock</source>
        <translation>Zár</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Locked for cleaning</source>
        <translation>Zárolva tisztításhoz</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>Look whether the controller runs; try again.</source>
        <translation>Ellenőrizze, fut-e a vezérlő; próbálja újra.</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>MDI</source>
        <translation>MDI</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Machine</source>
        <translation>Gép</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Machine lock</source>
        <translation>Géplezárás</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Mean</source>
        <translation>Átlag</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>No controller answers</source>
        <translation>A vezérlő nem válaszol</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Offset</source>
        <translation>Korrekció</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Optional stop</source>
        <translation>Feltételes állj</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Optional stop %1</source>
        <translation>Feltételes állj %1</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Optional stop M1: start goes on</source>
        <translation>Feltételes megállás M1: a start folytatja</translation>
    </message>
    <message>
        <location filename="../screens/overview.hpp"/>
        <source>Overview</source>
        <translation>Áttekintés</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Parts</source>
        <translation>Darab</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Process dead</source>
        <translation>A folyamat leállt</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Programmed stop M0: start goes on</source>
        <translation>Programozott megállás M0: a start folytatja</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Rapid</source>
        <translation>Gyors</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Reference</source>
        <translation>Referencia</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Remaining</source>
        <translation>Hátravan</translation>
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
        <translation>Reset mind</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Restart: start makes the approach</source>
        <translation>Újraindítás: a start elvégzi a ráállást</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Retrace has come to its end</source>
        <translation>A visszakövetés a végére ért</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Runs</source>
        <translation>Fut</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Single block</source>
        <translation>Mondatonként</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Single block %1</source>
        <translation>Mondatonként %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Single block all</source>
        <translation>Mondatonként mind</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Single block: start does the next one</source>
        <translation>Mondatonként: a start a következőt hajtja végre</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Start %1</source>
        <translation>Start %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Start all</source>
        <translation>Start mind</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Starts all channels: press again</source>
        <translation>Mindet indítja: újra</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Stopped</source>
        <translation>Megállt</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>The controller gave no answer.</source>
        <translation>A vezérlő nem adott választ.</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>The controller refused.</source>
        <translation>A vezérlő elutasította.</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>There is no connection to the controller.</source>
        <translation>Nincs kapcsolat a vezérlővel.</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>To go</source>
        <translation>Hátravan</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Touches and keys do nothing. The machine goes on.</source>
        <translation>Az érintés és a billentyűk hatástalanok. A gép megy tovább.</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Waiting for the controller</source>
        <translation>Várakozás a vezérlőre</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits</source>
        <translation>Vár</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits at %1 for %2, since %3</source>
        <translation>Itt vár: %1, erre: %2, %3 óta</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits at %1, all are there</source>
        <translation>Vár itt: %1, mindenki itt van</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Workpiece</source>
        <translation>Munkadarab</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>a marker</source>
        <translation>jelölő</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>an alarm has stopped everything</source>
        <translation>riasztás állított le mindent</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>an alarm of the channel stands</source>
        <translation>a csatorna riasztása áll</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>an axis is being moved by hand</source>
        <translation>egy tengelyt kézzel mozgatnak</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>attach it (AP_DETCHR)</source>
        <translation>csatolja vissza (AP_DETCHR)</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>axes are on their way to their reference points</source>
        <translation>a tengelyek referenciára mennek</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>axes were moved in the hold</source>
        <translation>a tengelyeket tartás közben elmozdították</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>bring a tool into place</source>
        <translation>állítson be szerszámot</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>bring it to its end</source>
        <translation>vigye a végállásba</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>choose auto or mdi</source>
        <translation>válasszon automatát vagy MDI-t</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>close it, look at its pressure</source>
        <translation>zárja, nézze meg a nyomását</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>close it, or switch to setup mode</source>
        <translation>csukja be, vagy váltson beállító módra</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>detached</source>
        <translation>leválasztva</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>everything was stopped by an alarm</source>
        <translation>riasztás állított le mindent</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>fill up its oil</source>
        <translation>töltse fel az olajat</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>line</source>
        <translation>sor</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>load a new one</source>
        <translation>töltsön be újat</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no program</source>
        <translation>nincs program</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no ref.</source>
        <translation>nincs ref.</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>no tool is in place, the turret is not locked</source>
        <translation>nincs szerszám, a revolverfej nincs rögzítve</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no tool known</source>
        <translation>nincs szerszám</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>not all axes are referenced</source>
        <translation>nincs minden referencia</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>not referenced</source>
        <translation>nincs referencia</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>press machine on</source>
        <translation>nyomja meg: gép be</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>press reference all</source>
        <translation>nyomja meg: mind referencia</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>press reset</source>
        <translation>nyomjon resetet</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>press return</source>
        <translation>nyomja meg: visszatérés</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>reference it</source>
        <translation>vegyen fel referenciát</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>release it and switch the machine on</source>
        <translation>oldja ki és kapcsolja be a gépet</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>remove its cause and reset</source>
        <translation>szüntesse meg az okát és reset</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>remove its cause, then press reset</source>
        <translation>szüntesse meg az okát, majd reset</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>switch it on</source>
        <translation>kapcsolja be</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the bar is used up</source>
        <translation>elfogyott a rúd</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the channel's process is not there</source>
        <translation>a csatorna folyamata nem fut</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the chuck does not hold</source>
        <translation>a tokmány nem fog</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the door is open</source>
        <translation>az ajtó nyitva</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the emergency stop is active</source>
        <translation>a vészleállítás aktív</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the lubrication is missing</source>
        <translation>nincs kenés</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the machine is not switched on</source>
        <translation>a gép nincs bekapcsolva</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>the machine is off</source>
        <translation>a gép ki van kapcsolva</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>the machine is ready</source>
        <translation>a gép üzemkész</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the mode is for moving by hand</source>
        <translation>a mód kézi mozgatás</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the reset is not over</source>
        <translation>a reset még tart</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the store is dead: nothing would be kept</source>
        <translation>a tároló nem fut: semmi nem maradna meg</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the tailstock is neither back nor does it hold</source>
        <translation>a szegnyereg sem hátul, sem szorítva</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>tip</source>
        <translation>csúcs</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>turn the button back, then press machine on</source>
        <translation>oldja ki a gombot, majd gép be</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>wait</source>
        <translation>várjon</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it is started again, then reset</source>
        <translation>várja meg az újraindulását, majd reset</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it rests</source>
        <translation>várja meg, míg megáll</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it runs again</source>
        <translation>várja meg, míg újra fut</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until the axes rest</source>
        <translation>várja meg, míg a tengelyek megállnak</translation>
    </message>
</context>
</TS>
