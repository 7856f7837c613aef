#include "hmi/machine/live/requests.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <QDateTime>
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSocketNotifier>
#include <cerrno>

#include "hmi/text/display_languages.hpp"
#include "hmi/text/retold.hpp"
#include "ipc/memory/controller_door.hpp"

namespace polyturn::hmi {
namespace {

// the store may take five seconds to say that its disk does not answer
constexpr qint64 kTimeoutMs = 6'000;

}  // namespace

Requests::Requests(std::string instance) : instance_(std::move(instance)) {
    timeout_.setInterval(250);
    QObject::connect(&timeout_, &QTimer::timeout, [this] {
        if (!waiting_.empty() && QDateTime::currentMSecsSinceEpoch() > waiting_.front().until_ms)
            close(word("The controller gave no answer."));
        if (waiting_.empty()) timeout_.stop();
    });
}

Requests::~Requests() {
    readable_.reset();
    writable_.reset();
    if (fd_ >= 0) ::close(fd_);
}

bool Requests::open() {
    if (fd_ >= 0) return true;
    // and looked who listens: passwords go through it
    const auto connected = connect_to_controller(instance_, false);
    if (!connected) return false;
    const int fd = *connected;
    fd_ = fd;
    readable_ = std::make_unique<QSocketNotifier>(fd, QSocketNotifier::Read);
    writable_ = std::make_unique<QSocketNotifier>(fd, QSocketNotifier::Write);
    writable_->setEnabled(false);
    QObject::connect(readable_.get(), &QSocketNotifier::activated, [this] { read(); });
    QObject::connect(writable_.get(), &QSocketNotifier::activated, [this] { flush(); });
    return true;
}

void Requests::close(const QString& why) {
    // A notifier may be the one that calls.
    if (readable_) {
        readable_->setEnabled(false);
        readable_.release()->deleteLater();
    }
    if (writable_) {
        writable_->setEnabled(false);
        writable_.release()->deleteLater();
    }
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
    in_.clear();
    out_.clear();
    std::deque<Waiting> left;
    left.swap(waiting_);
    for (Waiting& one : left) {
        const Answer answer{false, why, word("Look whether the controller runs; try again."), {}};
        if (one.done) one.done(answer);
        if (onRefused && !one.quiet) onRefused(answer);
    }
}

void Requests::press(const QString& words, Done done) {
    ask({{"do", "press"}, {"words", words}, {"folder", QDir::currentPath()}}, std::move(done));
}
void Requests::set(const QString& words, Done done) {
    ask({{"do", "set"}, {"words", words}}, std::move(done));
}
void Requests::parameter(const QString& line, Done done) {
    ask({{"do", "parameters"}, {"lines", QJsonArray{line}}}, std::move(done));
}

void Requests::store(const QJsonObject& operation, Done done, bool quiet) {
    ask({{"do", "store"}, {"op", operation}}, std::move(done), quiet);
}

void Requests::ask(const QJsonObject& request, Done done, bool quiet) {
    const bool kept = request.value("do").toString() == "alarms";
    waiting_.push_back(
        {std::move(done), QDateTime::currentMSecsSinceEpoch() + kTimeoutMs, quiet || kept, kept});
    if (!open()) return close(word("There is no connection to the controller."));
    QJsonObject with = request;
    if (!token_.isEmpty()) with.insert("token", token_);
    out_ += QJsonDocument(with).toJson(QJsonDocument::Compact) + '\n';
    timeout_.start();
    flush();
}

void Requests::forgetScreens() {
    for (Waiting& one : waiting_)
        if (!one.kept) one.done = {};
}

void Requests::flush() {
    while (!out_.isEmpty()) {
        const auto wrote =
            ::send(fd_, out_.constData(), static_cast<std::size_t>(out_.size()), MSG_NOSIGNAL);
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote < 0 && errno == EAGAIN) return writable_->setEnabled(true);
        if (wrote <= 0) return close(word("There is no connection to the controller."));
        out_.remove(0, static_cast<int>(wrote));
    }
    writable_->setEnabled(false);
}

void Requests::read() {
    char block[65536];
    for (;;) {
        const auto got = ::read(fd_, block, sizeof block);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0 && errno == EAGAIN) break;
        if (got <= 0) return close(word("There is no connection to the controller."));
        in_.append(block, static_cast<int>(got));
    }
    for (int end = static_cast<int>(in_.indexOf('\n')); end >= 0 && fd_ >= 0;
         end = static_cast<int>(in_.indexOf('\n'))) {
        const QByteArray line = in_.left(end);
        in_.remove(0, end + 1);
        answer(line);
    }
}

void Requests::answer(const QByteArray& line) {
    if (waiting_.empty()) return;
    Waiting first = std::move(waiting_.front());
    waiting_.pop_front();
    Answer out;
    out.object = QJsonDocument::fromJson(line).object();
    out.ok = out.object.value("ok").toBool();
    if (!out.ok) {
        const auto words = [](const QJsonObject& from) {
            RetoldWords told =
                retold(from.value("number").toString(), from.value("text").toString());
            if (!told.found) told.remedy = from.value("remedy").toString();
            return told;
        };
        const RetoldWords refusal = words(out.object);
        out.text = refusal.text;
        out.remedy = refusal.remedy;
        for (const auto& one : out.object.value("faults").toArray())
            if (const QString text = words(one.toObject()).text; text != refusal.text)
                out.text += "\n" + text;
        if (out.text.isEmpty()) out.text = word("The controller refused.");
    }
    if (first.done) first.done(out);
    if (!out.ok && onRefused && !first.quiet) onRefused(out);
}

}  // namespace polyturn::hmi
