#include "hmi/machine/tools/computer_settings.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>

#include <QDateTime>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTimeZone>
#include <QTimer>
#include <bit>
#include <cmath>

#include "hmi/text/calculate.hpp"
#include "hmi/text/display_languages.hpp"
#include "ipc/diagnosis/details.hpp"

namespace polyturn::hmi {
namespace {

using What = ComputerSetting::What;
constexpr int kCommandTimeout_ms = 15'000;

QString fileText(const char* name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

// The interface that the default route goes out through, and its gateway.
std::pair<QString, QString> route() {
    for (const QString& line : fileText("/proc/net/route").split('\n').mid(1)) {
        const QStringList words = line.split('\t');
        if (words.size() < 3 || words[1] != "00000000") continue;
        const in_addr address{words[2].toUInt(nullptr, 16)};
        char text[INET_ADDRSTRLEN] = {};
        ::inet_ntop(AF_INET, &address, text, sizeof text);
        return {words[0], text};
    }
    return {};
}

}  // namespace

const std::vector<ComputerSetting>& computerSettings() {
    static const std::vector<ComputerSetting> kAll{
        {What::Date, "N5100", WORD("Date and time"), "2026-01-31 06:00:00"},
        {What::Zone, "", WORD("Time zone"), "Europe/Prague"},
        {What::Synchronised, "", WORD("Time from the network"), ""},
        {What::Address, "N5101", WORD("Network address"), "192.168.1.10"},
        {What::Mask, "N5102", WORD("Subnet mask"), "255.255.255.0"},
        {What::Gateway, "N5103", WORD("Gateway"), "192.168.1.1"},
        {What::Dns1, "N5104", WORD("First name server"), "192.168.1.1"},
        {What::Dns2, "N5105", WORD("Second name server"), "192.168.1.2"},
        {What::Wins1, "N5106", WORD("First WINS server"), ""},
        {What::Wins2, "N5107", WORD("Second WINS server"), ""},
        {What::Dhcp, "N5108", WORD("Addresses by DHCP"), "0, 1"},
        {What::Layout, "", WORD("Keyboard layout"), "us, cz, hu, ru"},
        {What::Delay, "N5110", WORD("Time before a key repeats"), "250 - 1000"},
        {What::Rate, "N5111", WORD("Repeats in a second"), "2 - 30"},
    };
    return kAll;
}

bool ipv4(const QString& text) {
    in_addr address{};
    return ::inet_pton(AF_INET, text.toUtf8().constData(), &address) == 1;
}

int prefixOf(const QString& mask) {
    in_addr address{};
    if (::inet_pton(AF_INET, mask.toUtf8().constData(), &address) != 1) return -1;
    const std::uint32_t bits = ntohl(address.s_addr);
    const int ones = std::countl_one(bits);
    return ones == std::popcount(bits) ? ones : -1;
}

QString maskOf(int prefix) {
    const std::uint32_t bits = prefix <= 0 ? 0 : 0xffffffffu << (32 - std::min(prefix, 32));
    return QString("%1.%2.%3.%4")
        .arg(bits >> 24)
        .arg(bits >> 16 & 255)
        .arg(bits >> 8 & 255)
        .arg(bits & 255);
}

QString layoutIn(const QString& keyboard) {
    static const QRegularExpression kLine("^\\s*XKBLAYOUT=[\"']?([a-z][a-z0-9,_-]*)[\"']?\\s*$",
                                          QRegularExpression::MultilineOption);
    return kLine.match(keyboard).captured(1);
}

ComputerSettings::~ComputerSettings() {
    changed = {};
    for (QProcess* one : findChildren<QProcess*>()) {
        one->disconnect();
        one->kill();
        one->waitForFinished(200);
    }
}

void ComputerSettings::run(const QString& program, const QStringList& arguments, Taken taken) {
    auto* process = new QProcess(this);
    auto told = std::make_shared<bool>(false);
    ++running_;
    const auto over = [this, process, told, taken = std::move(taken)](int status,
                                                                      const QString& why) {
        if (std::exchange(*told, true)) return;
        --running_;
        QString error = QString::fromLocal8Bit(process->readAllStandardError()).trimmed();
        // timedatectl and localectl never translate this sentence, and it is the one refusal that
        // every computer without systemd gives.
        if (error.contains("not been booted with systemd"))
            error = word("This computer runs without systemd");
        else
            error = QString::fromStdString(detail_in(error.toStdString(), spoken()));
        taken(status, QString::fromLocal8Bit(process->readAllStandardOutput()).trimmed(),
              error.isEmpty() ? why : error);
        process->deleteLater();
        if (changed) changed();
    };
    connect(process, &QProcess::finished, this, [over](int status, QProcess::ExitStatus how) {
        over(how == QProcess::NormalExit ? status : 1, word("The program was broken off"));
    });
    connect(process, &QProcess::errorOccurred, this, [over, program](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            over(127, word("This computer has no %1").arg(program));
    });
    QTimer::singleShot(kCommandTimeout_ms, process, [process] { process->kill(); });
    QProcessEnvironment plain = QProcessEnvironment::systemEnvironment();
    plain.insert("LC_ALL", "C.UTF-8");  // details.cpp knows what they say in English
    process->setProcessEnvironment(plain);
    process->start(program, arguments);  // a program that asks for a password gets none and refuses
    process->closeWriteChannel();
}

void ComputerSettings::read() {
    values_.clear();
    why_.clear();
    values_[What::Zone] = QString::fromUtf8(QTimeZone::systemTimeZoneId());
    const auto [device, gateway] = route();
    device_ = device;
    values_[What::Gateway] = gateway;
    ifaddrs* all = nullptr;
    if (::getifaddrs(&all) == 0) {
        for (const ifaddrs* one = all; one; one = one->ifa_next) {
            if (!one->ifa_addr || one->ifa_addr->sa_family != AF_INET ||
                one->ifa_flags & IFF_LOOPBACK || (!device_.isEmpty() && device_ != one->ifa_name))
                continue;
            char text[INET_ADDRSTRLEN] = {};
            ::inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(one->ifa_addr)->sin_addr,
                        text, sizeof text);
            values_[What::Address] = text;
            if (device_.isEmpty()) device_ = one->ifa_name;
            if (one->ifa_netmask) {
                ::inet_ntop(AF_INET,
                            &reinterpret_cast<const sockaddr_in*>(one->ifa_netmask)->sin_addr, text,
                            sizeof text);
                values_[What::Mask] = text;
            }
            break;
        }
        ::freeifaddrs(all);
    }
    const QRegularExpression server("^nameserver\\s+(\\S+)", QRegularExpression::MultilineOption);
    int number = 0;
    for (auto found = server.globalMatch(fileText("/etc/resolv.conf"));
         found.hasNext() && number < 2; ++number)
        values_[number ? What::Dns2 : What::Dns1] = found.next().captured(1);
    for (const What one : {What::Wins1, What::Wins2})
        why_[one] = word("This system knows no WINS: names come from the name servers");

    const auto refused = [this](std::initializer_list<What> which, const QString& why) {
        for (const What one : which) why_[one] = why;
    };
    run("timedatectl", {"show", "-p", "Timezone", "-p", "NTP"},
        [this, refused](int status, const QString& out, const QString& error) {
            if (status != 0) return refused({What::Date, What::Zone, What::Synchronised}, error);
            for (const QString& line : out.split('\n')) {
                if (line.startsWith("Timezone=")) values_[What::Zone] = line.mid(9);
                if (line.startsWith("NTP="))
                    values_[What::Synchronised] = line.mid(4) == "yes" ? word("yes") : word("no");
            }
        });
    run("nmcli", {"-t", "-f", "NAME,DEVICE", "connection", "show", "--active"},
        [this, refused](int status, const QString& out, const QString& error) {
            const auto network = {What::Address, What::Mask, What::Gateway,
                                  What::Dns1,    What::Dns2, What::Dhcp};
            if (status != 0) return refused(network, error);
            for (const QString& line : out.split('\n'))
                if (const int at = static_cast<int>(line.lastIndexOf(':'));
                    at > 0 && line.mid(at + 1) == device_)
                    connection_ = line.left(at).replace("\\:", ":");
            if (connection_.isEmpty())
                return refused(network, word("No network connection is managed here"));
            run("nmcli", {"-g", "ipv4.method", "connection", "show", connection_},
                [this, refused, network](int code, const QString& method, const QString& why) {
                    if (code != 0) return refused(network, why);
                    values_[What::Dhcp] = method == "auto" ? "1" : "0";
                    if (method == "auto")
                        refused({What::Address, What::Mask, What::Gateway},
                                word("It comes by DHCP (N5108)"));
                });
        });
    run("localectl", {"status"},
        [this, refused](int status, const QString& out, const QString& error) {
            if (status != 0) return refused({What::Layout}, error);
            for (const char* name : {"X11 Layout:", "VC Keymap:"})
                if (const auto found =
                        QRegularExpression(QRegularExpression::escape(name) + "\\s*(\\S+)")
                            .match(out);
                    found.hasMatch()) {
                    values_[What::Layout] = found.captured(1);
                    break;
                }
        });
    if (qEnvironmentVariableIsEmpty("DISPLAY"))
        return refused({What::Delay, What::Rate},
                       word("Without a display server the keyboard itself decides"));
    run("xset", {"q"}, [this, refused](int status, const QString& out, const QString& error) {
        if (status != 0) return refused({What::Delay, What::Rate}, error);
        const auto found =
            QRegularExpression("auto repeat delay:\\s*(\\d+)\\s+repeat rate:\\s*(\\d+)").match(out);
        values_[What::Delay] = found.captured(1);
        values_[What::Rate] = found.captured(2);
    });
}

QString ComputerSettings::value(What what) const {
    if (what == What::Date) return QDateTime::currentDateTime().toString("yyyy-MM-dd HH:mm:ss");
    const auto at = values_.find(what);
    return at == values_.end() ? QString() : at->second;
}

QString ComputerSettings::whyNot(What what) const {
    const auto at = why_.find(what);
    return at == why_.end() ? QString() : at->second;
}

QStringList ComputerSettings::addresses() const {
    QStringList out{"connection",
                    "modify",
                    connection_,
                    "ipv4.method",
                    "manual",
                    "ipv4.addresses",
                    QString("%1/%2").arg(value(What::Address)).arg(prefixOf(value(What::Mask))),
                    "ipv4.gateway",
                    value(What::Gateway)};
    return out;
}

void ComputerSettings::write(What what, const QString& text, Done done) {
    const QString words = text.trimmed();
    const auto wrong = [&](const QString& why) { done(false, why); };
    if (const QString why = whyNot(what); !why.isEmpty()) return wrong(why);
    const auto ended = [this, done](int status, const QString&, const QString& error) {
        done(status == 0, status == 0 ? QString() : error);
        if (status == 0) read();
    };
    switch (what) {
        case What::Date: {
            const QDateTime when = QDateTime::fromString(words, "yyyy-MM-dd HH:mm:ss");
            if (!when.isValid()) return wrong(word("Written as %1").arg("2026-01-31 06:00:00"));
            return run("timedatectl", {"set-time", words}, ended);
        }
        case What::Zone:
            if (!QTimeZone::isTimeZoneIdAvailable(words.toUtf8()))
                return wrong(word("There is no time zone %1").arg(words));
            return run("timedatectl", {"set-timezone", words}, ended);
        case What::Synchronised: {
            const bool on = words == "1" || words.compare("yes", Qt::CaseInsensitive) == 0 ||
                            words.compare(word("yes"), Qt::CaseInsensitive) == 0;
            return run("timedatectl", {"set-ntp", on ? "true" : "false"}, ended);
        }
        case What::Address:
        case What::Mask:
        case What::Gateway:
        case What::Dns1:
        case What::Dns2:
        case What::Dhcp: {
            if (connection_.isEmpty()) return wrong(word("No network connection is managed here"));
            if (what == What::Dhcp   ? words != "0" && words != "1"
                : what == What::Mask ? prefixOf(words) < 0
                                     : !(ipv4(words) || (what == What::Dns2 && words.isEmpty())))
                return wrong(word("%1 is not such a value").arg(words));
            QStringList arguments{"connection", "modify", connection_};
            const QString before = value(what);
            values_[what] = words;
            if (what == What::Dhcp && words == "1")
                arguments << "ipv4.method"
                          << "auto"
                          << "ipv4.addresses"
                          << ""
                          << "ipv4.gateway"
                          << "";
            else if (what == What::Dns1 || what == What::Dns2)
                arguments << "ipv4.dns" << (value(What::Dns1) + " " + value(What::Dns2)).trimmed();
            else
                arguments = addresses();
            return run(
                "nmcli", arguments,
                [this, what, before, ended](int status, const QString& out, const QString& error) {
                    if (status != 0) {
                        values_[what] = before;
                        return ended(status, out, error);
                    }
                    run("nmcli", {"connection", "up", connection_}, ended);
                });
        }
        case What::Layout:
            if (!QRegularExpression("^[a-z][a-z0-9,_-]*$").match(words).hasMatch())
                return wrong(word("%1 is not such a value").arg(words));
            return run("localectl", {"set-x11-keymap", words}, ended);
        case What::Delay:
        case What::Rate: {
            const bool delay = what == What::Delay;
            // 500/2 and +50 as in every number field
            const auto entry = calculate(words.toStdString());
            const double wanted = entry ? std::round(entry->over(value(what).toDouble())) : 0;
            if (wanted < (delay ? 250 : 2) || wanted > (delay ? 1000 : 30))
                return wrong(delay ? word("250 to 1000 ms") : word("2 to 30 a second"));
            const QString whole = QString::number(wanted, 'f', 0);
            return run("xset",
                       {"r", "rate", delay ? whole : value(What::Delay),
                        delay ? value(What::Rate) : whole},
                       ended);
        }
        case What::Wins1:
        case What::Wins2:
            break;
    }
}

}  // namespace polyturn::hmi
