// Tool data as files: CSV with a heading, and the data programs of Fanuc and Sinumerik. A reader
// only takes the text apart, naming row and column of what it cannot read; what the values may be
// is asked by who enters them.
//
//   CSV        tool,name,type,...,magazine,pot,D1.DP3,... ; comma or semicolon, quotes doubled;
//              rows from the heading's 1
//   Fanuc      G10 P3 X.. Z.. R.. Q.. (wear), P10003 (geometry); G10 L3, P group L life (Q1 uses,
//              Q2 minutes), T tool and offset, G11
//   Sinumerik  $TC_TP1[5]=2 $TC_TP2[5]="ROUGH" $TC_DP3[5,1]=12.5 $TC_MOP11[5,1]=60 $TC_MPP6[1,3]=5
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace polyturn::toolmgmt {

struct TableEntry {
    int row = 0;            // of the file, from 1
    std::string column;     // for the fault: heading, word or variable
    std::int64_t tool = 0;  // data number; 0: an offset cell
    // column of the tool table, "magazine", "pot", "D1.DP3", "exists"; "<table * 256 + field>" of a
    // cell
    std::string field;
    std::string text;
    std::int64_t cell = 0;  // offset number
};
struct TableFault {
    int row = 0;
    std::string column, text;
};
struct ReadTable {
    std::vector<TableEntry> entries;
    std::vector<TableFault> faults;
};

ReadTable read_csv_table(std::string_view text);
ReadTable read_fanuc_table(std::string_view text);
ReadTable read_sinumerik_table(std::string_view text);

}  // namespace polyturn::toolmgmt
