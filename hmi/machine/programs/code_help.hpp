// Where the manual explains a word of a program: the help key in the editor.
#pragma once
#include <QString>

#include "ipc/diagnosis/languages.hpp"

namespace polyturn::hmi {

struct CodePlace {
    QString page, find;  // empty page: the word is no code
    bool code = true;    // `find` is the word itself; else a heading
};
CodePlace placeOfCode(const QString& word, const QString& language);
QString referenceOf(Dialect language);  // the page that has all words of a language
// The word that a column (from 0) of a line is in or behind.
QString wordAt(const QString& line, int column);

}  // namespace polyturn::hmi
