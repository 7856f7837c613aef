// What has been typed into the editor and not saved, where the editor that holds it goes: with the
// language of the screens, with a crash. It is kept beside what else is kept over a restart.
#pragma once
#include <QByteArray>
#include <QString>

#include "hmi/machine/programs/file_text.hpp"

namespace polyturn::hmi {

struct Draft {
    QString file, canonical, language, text;  // file empty: there is none
    FilePart part;
    bool dos = false;
    int position = 0;            // of the cursor
    QByteArray written() const;  // as it is kept
    static Draft read(const QByteArray& bytes);
};

}  // namespace polyturn::hmi
