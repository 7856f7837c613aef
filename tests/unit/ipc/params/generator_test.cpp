// The build refuses a table with a wrong row, and says where.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/places.hpp"

namespace {

constexpr const char* kHeader =
    "number,name,group,scope,type,unit,min,max,default,effect,protection,acts,bits,meaning\n";
constexpr const char* kGood =
    "N0304,Rapid,Feed,A,double,mm/min,0,,10000,tick,maker,yes,,Rapid traverse.\n";

struct Outcome {
    int status;
    std::string output;
};

// `translated`: the rows of every other language; without them none is made.
Outcome generate(const std::string& table, const char* translated = nullptr) {
    const auto folder = std::filesystem::temp_directory_path() /
                        ("polyturn_generator_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "table.csv") << table;
    const std::string command =
        "python3 " + std::string(kSourceFolder) + "/tools/generate_parameters.py " +
        (folder / "table.csv").string() + " " + (folder / "handles.hpp").string() + " " +
        (folder / "rows.cpp").string() +
        (translated ? " " + (folder / "display_languages.hpp").string() : "") + " 2>&1";
    for (const char* code : {"ru", "cs", "hu"})
        if (translated)
            std::ofstream(folder / (std::string("table.") + code + ".csv"))
                << "number,name,bits,meaning,acts\n"
                << translated;
    Outcome run{-1, ""};
    if (std::FILE* pipe = ::popen(command.c_str(), "r")) {
        char buffer[512];
        while (std::fgets(buffer, sizeof buffer, pipe) != nullptr) run.output += buffer;
        run.status = ::pclose(pipe);
    }
    std::filesystem::remove_all(folder);
    return run;
}

TEST(ParameterGenerator, TakesAGoodTable) {
    const Outcome run = generate(std::string(kHeader) + kGood);
    EXPECT_EQ(run.status, 0) << run.output;
}

struct Fault {
    const char* row;
    const char* message;
};
constexpr Fault kFaults[] = {
    {"N0304,Rapid,Feed,A,double,mm,0,,1,tick,maker,yes,,Twice.\n",
     ":3: number N0304 is already on line 2"},
    {"X1,Rapid,Feed,A,double,mm,0,,1,tick,maker,yes,,Text.\n", "is no parameter number"},
    {"N0305,Rapid,Feed,Q,double,mm,0,,1,tick,maker,yes,,Text.\n", "unknown scope 'Q'"},
    {"N0305,Rapid,Feed,A,float,mm,0,,1,tick,maker,yes,,Text.\n", "unknown type 'float'"},
    {"N0305,Rapid,Feed,A,double,mm,0,,1,later,maker,yes,,Text.\n", "unknown effect 'later'"},
    {"N0305,Rapid,Feed,A,double,mm,0,,1,tick,owner,yes,,Text.\n", "unknown protection 'owner'"},
    {"N0305,Rapid,Feed,A,double,mm,5,1,3,tick,maker,yes,,Text.\n", "min 5 is above max 1"},
    {"N0305,Rapid,Feed,A,double,mm,0,10,11,tick,maker,yes,,Text.\n", "default 11 is outside"},
    {"N0305,Rapid,Feed,A,double,mm,0,inf,1,tick,maker,yes,,Text.\n", "is not finite"},
    {"N0305,Rapid,Feed,A,int,mm,0,10,1.5,tick,maker,yes,,Text.\n", "is no whole number"},
    {"N0305,Rapid,Feed,A,double,mm,0,10,,tick,maker,yes,,Text.\n", "0 defaults, wanted 1"},
    {"N0305,Rapid,Feed,A,double[3],mm,0,10,1 2,tick,maker,yes,,Text.\n",
     "2 defaults, wanted 1 or 3"},
    {"N0305,Rapid,Feed,A,double,mm,0,10,1,tick,maker,yes,,\n", "meaning is empty"},
    {"N0305,Rapid,Feed,A,double,mm,0,10,1,tick,maker,,,Text.\n", "acts is empty"},
    {"N0305,Flags,Feed,A,bit,,0,3,0,tick,maker,yes,#2 ABC: 1 on,Text.\n",
     "bit #2 is not within max 3"},
    {"N0305,Flags,Feed,A,bit,,0,255,0,tick,maker,yes,#2 ABC: 1 on; #1 ABD: 1 on,Text.\n",
     "out of order"},
    {"N0305,Flags,Feed,A,bit,,0,255,0,tick,maker,yes,ABC,Text.\n", "is no bit"},
    {"N0305,Name,Feed,L,text,,,,d,tick,maker,yes,a / b,Text.\n", "default 'd' is not allowed"},
    {"N0305,Name,Feed,L,text,,,64,,tick,maker,yes,,Text.\n", "0 to 63 characters"},
    {"N0305,Rapid,Feed\n", "14 columns wanted"},
};

TEST(ParameterGenerator, RefusesAWrongRowWithItsLine) {
    for (const Fault& fault : kFaults) {
        SCOPED_TRACE(fault.row);
        const Outcome run = generate(std::string(kHeader) + kGood + fault.row);
        EXPECT_NE(run.status, 0);
        EXPECT_NE(run.output.find(fault.message), std::string::npos) << run.output;
        EXPECT_NE(run.output.find("table.csv:3:"), std::string::npos) << run.output;
    }
}

// Who changes an English row need not speak the others: what no longer fits is told, and shown in
// English.
struct Translation {
    const char* row;
    const char* told;  // nullptr: it fits
};
constexpr Translation kTranslations[] = {
    {"N0106,Druh,#0 DIA: 1 průměry; #1 ROT: 1 rotační,Druh osy.,\n", nullptr},
    {"N0106,Druh,#0 DIA: 1 průměry,Druh osy.,\n", "must name the bits #0 DIA, #1 ROT"},
    {"N0106,Druh,#0 DIA: 1 průměry; #1 OSA: 1 rotační,Druh osy.,\n",
     "must name the bits #0 DIA, #1 ROT"},
    {"N0106,Druh,#1 ROT: 1 rotační; #0 DIA: 1 průměry,Druh osy.,\n",
     "must name the bits #0 DIA, #1 ROT"},
    {"N0106,,#0 DIA: 1 průměry; #1 ROT: 1 rotační,Druh osy.,\n",
     "needs a name, a meaning, and acts where the row has no effect"},
    {"N0106,Druh,#0 DIA: 1 průměry; #1 ROT: 1 rotační,Druh osy.,nikdy\n",
     "needs a name, a meaning, and acts where the row has no effect"},
    {"", "1 rows are shown in English: N0106"},
};

TEST(ParameterGenerator, TellsWhichTranslationsDoNotFit) {
    const std::string table =
        std::string(kHeader) +
        "N0106,Kind,Axis,A,bit,,0,255,0,tick,maker,yes,#0 DIA: 1 diameters; #1 ROT: 1 rotary,Kind "
        "of axis.\n";
    for (const Translation& one : kTranslations) {
        SCOPED_TRACE(one.row);
        const Outcome run = generate(table, one.row);
        EXPECT_EQ(run.status, 0) << run.output;
        if (one.told) {
            EXPECT_NE(run.output.find(one.told), std::string::npos) << run.output;
        } else {
            EXPECT_EQ(run.output, "");
        }
    }
}

}  // namespace
