// The computer's own settings (N5100 to N5111): date, zone, network, keyboard. The operating system
// keeps them; here they are read, and changed by its own programs (timedatectl, nmcli, localectl,
// xset) as processes of their own, so that its rules say who may. What they refuse is told in their
// words; what this computer has no program for is said so.
#pragma once
#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <map>
#include <vector>

class QProcess;

namespace polyturn::hmi {

struct ComputerSetting {
    enum class What : std::uint8_t {
        Date,
        Zone,
        Synchronised,
        Address,
        Mask,
        Gateway,
        Dns1,
        Dns2,
        Wins1,
        Wins2,
        Dhcp,
        Layout,
        Delay,
        Rate
    } what;
    const char* number;   // N51xx; empty: not in that list
    const char* title;    // to be translated
    const char* example;  // how it is written
};
const std::vector<ComputerSetting>& computerSettings();

class ComputerSettings : public QObject {
public:
    using Done = std::function<void(bool ok, const QString& text)>;
    ~ComputerSettings() override;
    // starts; `changed` is called as answers come
    void read();
    QString value(ComputerSetting::What what) const;
    // it cannot be changed here; empty: it can be tried
    QString whyNot(ComputerSetting::What what) const;
    // Wrong text is refused at once. Answers when the system's program has ended.
    void write(ComputerSetting::What what, const QString& text, Done done);
    bool busy() const { return running_ > 0; }
    std::function<void()> changed;

private:
    using Taken = std::function<void(int status, const QString& out, const QString& error)>;
    void run(const QString& program, const QStringList& arguments, Taken taken);
    // arguments of nmcli from what there is
    QStringList addresses() const;
    std::map<ComputerSetting::What, QString> values_, why_;
    QString connection_, device_;
    int running_ = 0;
};

bool ipv4(const QString& text);
int prefixOf(const QString& mask);  // -1: no mask
QString maskOf(int prefix);
// The layouts that /etc/default/keyboard names (XKBLAYOUT="us,cz"; localectl writes them there);
// empty: none, or nothing that is a layout.
QString layoutIn(const QString& keyboard);

}  // namespace polyturn::hmi
