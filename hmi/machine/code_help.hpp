// Where the manual tells of a word of a program: the help key in the editor.
#pragma once
#include <QString>

namespace polyturn::hmi {

struct CodePlace {
    QString page, find;      // empty page: the word is no code
};
CodePlace placeOfCode(const QString& word, const QString& language);
// The word that a column (from 0) of a line stands in or behind.
QString wordAt(const QString& line, int column);

}  // namespace polyturn::hmi
