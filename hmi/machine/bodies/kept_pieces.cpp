#include "hmi/machine/bodies/kept_pieces.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

namespace polyturn::hmi {
namespace {

constexpr qint64 kMostPiece = 64 << 20;  // a file that is larger is not ours

bool writePiece(const QString& file, const QByteArray& piece) {
    if (piece.isEmpty()) return QFile::remove(file) || !QFile::exists(file);
    QDir().mkpath(QFileInfo(file).path());
    QSaveFile out(file);
    return out.open(QIODevice::WriteOnly) && out.write(qCompress(piece, 1)) > 0 && out.commit();
}

}  // namespace

QString KeptPieces::fileOf(const QString& name, Span span) const {
    const QString& base = span == Span::Lasting ? lasting_ : passing_;
    return base.isEmpty() ? QString() : base + "." + name;
}

void KeptPieces::put(const QString& name, QByteArray piece, Span span) {
    Piece& own = pieces_[name];
    own.reading.forget();
    own.known = std::move(piece);
    own.span = span;
    own.written = false;
    tend();
}

void KeptPieces::tend() {
    for (auto& [name, own] : pieces_) {
        if (own.written || (own.writing.busy() && !own.writing.take())) continue;
        own.written = true;
        if (const QString file = fileOf(name, own.span); !file.isEmpty())
            own.writing.start(
                [file, bytes = *own.known](const std::atomic<bool>& stop) {
                    return !stop && writePiece(file, bytes);
                },
                0);
    }
}

// The program ends: no worker is waited for.
KeptPieces::~KeptPieces() {
    for (auto& [name, own] : pieces_) {
        const QString file = fileOf(name, own.span);
        if (file.isEmpty() || (own.written && (!own.writing.busy() || own.writing.take())))
            continue;
        own.writing.forget();
        writePiece(file, *own.known);
    }
}

std::optional<QByteArray> KeptPieces::get(const QString& name, Span span) {
    Piece& own = pieces_[name];
    if (own.known) return own.known;
    const QString file = fileOf(name, span);
    if (file.isEmpty()) return own.known = QByteArray();
    if (!own.reading.busy())
        own.reading.start([file](const std::atomic<bool>&) {
            QFile in(file);
            return in.size() <= kMostPiece && in.open(QIODevice::ReadOnly)
                       ? qUncompress(in.readAll())
                       : QByteArray();
        });
    if (auto read = own.reading.take()) own.known = std::move(*read);
    return own.known;
}

}  // namespace polyturn::hmi
