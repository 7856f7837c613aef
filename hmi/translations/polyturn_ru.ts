<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru_RU" sourcelanguage="en">
<context>
    <name>hmi</name>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>A start needs:</source>
        <translation>Для пуска нужно:</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Absent</source>
        <translation>Нет</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Automatic</source>
        <translation>Автомат</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Block skip</source>
        <translation>Пропуск кадров</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Cycle</source>
        <translation>Цикл</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Dark</source>
        <translation>Тёмная</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Dry run</source>
        <translation>Пробный прогон</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>End with this part</source>
        <translation>Конец с этой деталью</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Ended</source>
        <translation>Завершён</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Ends all programs: press again</source>
        <translation>Прервёт все: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Ends the program: press again</source>
        <translation>Прервёт программу: ещё раз</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Feed hold: start goes on</source>
        <translation>Стоп подачи: пуск продолжит</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>First part</source>
        <translation>Первая деталь</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>First part: start goes on with this tool</source>
        <translation>Первая деталь: пуск продолжит этим инструментом</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Follow. error</source>
        <translation>Рассогл.</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Handwheel</source>
        <translation>Маховичок</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Held</source>
        <translation>Удержан</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Hold %1</source>
        <translation>Стоп подачи %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Hold all</source>
        <translation>Стоп подачи всех</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Interrupted</source>
        <translation>Прерван</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Jog</source>
        <translation>Ручной</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Last</source>
        <translation>Прошлый</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Light</source>
        <translation>Светлая</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Lock</source>
        <translation>Замок</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Locked for cleaning</source>
        <translation>Заблокировано для протирки</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>Look whether the controller runs; try again.</source>
        <translation>Проверьте, работает ли УЧПУ; повторите.</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>MDI</source>
        <translation>РВД</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Machine</source>
        <translation>Станок</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Machine lock</source>
        <translation>Блокировка осей</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Mean</source>
        <translation>Средний</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>No controller answers</source>
        <translation>Нет связи с УЧПУ</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Offset</source>
        <translation>Корректор</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Optional stop</source>
        <translation>Останов M1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Optional stop %1</source>
        <translation>Останов M1 %1</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Optional stop M1: start goes on</source>
        <translation>Останов M1: пуск продолжит</translation>
    </message>
    <message>
        <location filename="../screens/overview.hpp"/>
        <source>Overview</source>
        <translation>Обзор</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Parts</source>
        <translation>Детали</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Process dead</source>
        <translation>Процесс погиб</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Programmed stop M0: start goes on</source>
        <translation>Останов M0: пуск продолжит</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Rapid</source>
        <translation>Быстро</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Reference</source>
        <translation>Выход в 0</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Remaining</source>
        <translation>Осталось</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Reset</source>
        <translation>Сброс</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Reset %1</source>
        <translation>Сброс %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Reset all</source>
        <translation>Сброс всех</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Restart: start makes the approach</source>
        <translation>Возобновление: пуск выполнит подвод</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Retrace has come to its end</source>
        <translation>Возврат по траектории дошёл до конца</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Runs</source>
        <translation>Работает</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Single block</source>
        <translation>Покадрово</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Single block %1</source>
        <translation>Покадрово %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Single block all</source>
        <translation>Покадрово все</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Single block: start does the next one</source>
        <translation>Покадрово: пуск выполнит следующий кадр</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Start %1</source>
        <translation>Пуск %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Start all</source>
        <translation>Пуск всех</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Starts all channels: press again</source>
        <translation>Пуск всех каналов: ещё раз</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Stopped</source>
        <translation>Остановлен</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>The controller gave no answer.</source>
        <translation>УЧПУ не ответило.</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>The controller refused.</source>
        <translation>УЧПУ отказало.</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>There is no connection to the controller.</source>
        <translation>Нет соединения с УЧПУ.</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>To go</source>
        <translation>Остаток</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Touches and keys do nothing. The machine goes on.</source>
        <translation>Касания и клавиши не действуют. Станок работает.</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Waiting for the controller</source>
        <translation>Ожидание УЧПУ</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits</source>
        <translation>Ждёт</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits at %1 for %2, since %3</source>
        <translation>Ждёт на %1 канал %2, уже %3</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits at %1, all are there</source>
        <translation>Ждёт на %1, все на месте</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Workpiece</source>
        <translation>Деталь</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>a marker</source>
        <translation>метке</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>an alarm has stopped everything</source>
        <translation>авария всё остановила</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>an alarm of the channel stands</source>
        <translation>авария канала не снята</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>an axis is being moved by hand</source>
        <translation>ось перемещают вручную</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>attach it (AP_DETCHR)</source>
        <translation>присоедините её (AP_DETCHR)</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>axes are on their way to their reference points</source>
        <translation>оси идут в нулевые точки</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>axes were moved in the hold</source>
        <translation>оси отведены при удержании</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>bring a tool into place</source>
        <translation>поставьте инструмент</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>bring it to its end</source>
        <translation>доведите её до конца</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>choose auto or mdi</source>
        <translation>выберите автомат или РВД</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>close it, look at its pressure</source>
        <translation>закройте его, проверьте давление</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>close it, or switch to setup mode</source>
        <translation>закройте её или включите режим наладки</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>detached</source>
        <translation>отсоединена</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>everything was stopped by an alarm</source>
        <translation>всё остановлено аварией</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>fill up its oil</source>
        <translation>долейте масло</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>line</source>
        <translation>строка</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>load a new one</source>
        <translation>загрузите новый</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no program</source>
        <translation>нет программы</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no ref.</source>
        <translation>нет нуля</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>no tool is in place, the turret is not locked</source>
        <translation>нет инструмента, револьвер не зажат</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no tool known</source>
        <translation>нет инструмента</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>not all axes are referenced</source>
        <translation>не все оси в нуле</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>not referenced</source>
        <translation>нет выхода в ноль</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>press machine on</source>
        <translation>включите станок</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>press reference all</source>
        <translation>нажмите «все в ноль»</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>press reset</source>
        <translation>нажмите «сброс»</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>press return</source>
        <translation>нажмите «возврат»</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>reference it</source>
        <translation>выведите её в ноль</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>release it and switch the machine on</source>
        <translation>отпустите его и включите станок</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>remove its cause and reset</source>
        <translation>устраните причину и сбросьте</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>remove its cause, then press reset</source>
        <translation>устраните причину, затем сброс</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>switch it on</source>
        <translation>включите его</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the bar is used up</source>
        <translation>пруток закончился</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the channel's process is not there</source>
        <translation>нет процесса канала</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the chuck does not hold</source>
        <translation>патрон не держит</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the door is open</source>
        <translation>дверь открыта</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the emergency stop is active</source>
        <translation>аварийный останов активен</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the lubrication is missing</source>
        <translation>нет смазки</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the machine is not switched on</source>
        <translation>станок не включён</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>the machine is off</source>
        <translation>станок выключен</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>the machine is ready</source>
        <translation>станок готов</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the mode is for moving by hand</source>
        <translation>режим ручных перемещений</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the reset is not over</source>
        <translation>сброс не закончен</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the store is dead: nothing would be kept</source>
        <translation>хранилище не работает: ничего не сохранится</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the tailstock is neither back nor does it hold</source>
        <translation>задняя бабка ни отведена, ни прижата</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>tip</source>
        <translation>вершина</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>turn the button back, then press machine on</source>
        <translation>отпустите кнопку, затем включите станок</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>wait</source>
        <translation>подождите</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it is started again, then reset</source>
        <translation>подождите его запуска, затем сброс</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it rests</source>
        <translation>подождите её остановки</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it runs again</source>
        <translation>подождите его запуска</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until the axes rest</source>
        <translation>подождите остановки осей</translation>
    </message>
</context>
</TS>
