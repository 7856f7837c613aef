// A page of the handbook in slices that are laid out one in each turn of the event loop: a list of
// all codes of a language at once would stop the screens for a tenth of a second. A long table is
// cut into tables of some rows; that their columns stand one below the other is seen to by shares
// of the width, which are measured for the whole table.
#pragma once
#include <QString>
#include <vector>

namespace polyturn::hmi {

struct HelpSlice {
    QString markdown;
    std::vector<double> shares;  // of a table: of the width, in percent; empty: no table
    // a table: begins in the slice before, so that its head is left out
    bool goesOn = false;
    QString picture = {};  // the only thing in it: a picture, by its file; empty: none
    bool last = true;      // a table: nothing of it follows
};

inline constexpr int kMostSliceLines = 24, kMostSliceRows = 6;

std::vector<HelpSlice> sliceHelp(const QString& markdown);
// The first slice where the words stand as they are shown; as a code: whole, and in these letters.
// -1: nowhere.
int sliceWith(const std::vector<HelpSlice>& slices, const QString& find, bool code);
// Cuts that slice in two where the paragraph with the words begins; the number of the one that
// begins with it.
int splitAt(std::vector<HelpSlice>& slices, int slice, const QString& find);

}  // namespace polyturn::hmi
