// What the operator asks of the controller: one JSON object a line through the supervisor's socket,
// answered in order. Nothing waits: an answer comes by a call from the event loop, and a request
// that gets none within some seconds is answered by «no answer».
#pragma once
#include <QJsonObject>
#include <QObject>
#include <QString>
#include <QTimer>
#include <deque>
#include <functional>
#include <memory>
#include <string>

class QSocketNotifier;

namespace polyturn::hmi {

struct Answer {
    bool ok = false;
    QString text;  // why not, in the language of the HMI
    QString remedy;
    QJsonObject object;
};

class Requests {
public:
    using Done = std::function<void(const Answer&)>;
    explicit Requests(std::string instance);
    ~Requests();

    void press(const QString& words, Done done = {});  // as `polyturn press`
    void set(const QString& words, Done done = {});    // as `polyturn set`
    void parameter(const QString& line, Done done = {});
    // quiet: a refusal is not reported
    void ask(const QJsonObject& request, Done done, bool quiet = false);
    // as `polyturn tools`, `polyturn pallets` ... do it
    void store(const QJsonObject& operation, Done done = {}, bool quiet = false);
    // Called with each answer that refuses, beside its own `done`.
    std::function<void(const Answer&)> onRefused;
    // of a login; goes along with every request
    void setToken(const QString& token) { token_ = token; }
    // the asker is gone; the alarm log is not
    void forgetScreens();
    std::size_t waiting() const { return waiting_.size(); }

private:
    bool open();
    void close(const QString& why);
    void flush();
    void read();
    void answer(const QByteArray& line);

    struct Waiting {
        Done done;
        qint64 until_ms = 0;
        bool quiet = false, kept = false;
    };
    std::string instance_;
    int fd_ = -1;
    std::unique_ptr<QSocketNotifier> readable_, writable_;
    QString token_;
    QByteArray in_, out_;
    std::deque<Waiting> waiting_;
    QTimer timeout_;
};

}  // namespace polyturn::hmi
