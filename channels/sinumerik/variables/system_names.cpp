// The names of the system variables.
#include "channels/sinumerik/variables/system_names.hpp"

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/tools/tool_variables.hpp"
#include "channels/sinumerik/variables/variables.hpp"
#include "ipc/diagnosis/display_language.hpp"

namespace polyturn::channels::sinumerik {

// The name behind $ and its indices; the cursor is at $.
bool system_name(Execution& x, std::string& name, std::vector<Value>& indices) {
    const char* const from = x.line.cursor.at();
    x.line.cursor.advance(1);
    const std::string_view word = x.line.cursor.name_ahead();
    if (word.empty() || x.line.cursor.at() != from + 1) return syntax(x, from, "$");
    name = "$" + upper(word);
    x.line.cursor.advance(word.size());
    indices.clear();
    return x.line.cursor.peek() != '[' || index_list(x, indices);
}
bool is_system_variable(std::string_view name) {
    static constexpr std::string_view kNames[] = {"$PI",
                                                  "$P_GG",
                                                  "$P_F",
                                                  "$P_S",
                                                  "$P_SDIR",
                                                  "$P_TOOLNO",
                                                  "$P_TOOL",
                                                  "$P_TOOLR",
                                                  "$P_TOOLL",
                                                  "$P_TOOLND",
                                                  "$P_EP",
                                                  "$P_TOFF",
                                                  "$P_TOFFL",
                                                  "$P_TOFFR",
                                                  "$P_FZ",
                                                  "$P_F_TYPE",
                                                  "$P_MSNUM",
                                                  "$P_CHANNO",
                                                  "$P_PROG",
                                                  "$P_LINENO",
                                                  "$P_STACK",
                                                  "$P_REPINF",
                                                  "$P_ISTEST",
                                                  "$P_SEARCH",
                                                  "$P_AXN1",
                                                  "$P_AXN2",
                                                  "$P_AXN3",
                                                  "$P_AD",
                                                  "$P_DRYRUN",
                                                  "$P_SVC",
                                                  "$P_S_TYPE",
                                                  "$P_GWPS",
                                                  "$PA_FGROUP",
                                                  "$PA_FGREF",
                                                  "$P_FGROUP_MASK",
                                                  "$AC_FGROUP_MASK",
                                                  "$AA_FGROUP",
                                                  "$AA_FGREF",
                                                  "$AC_TOFF",
                                                  "$AC_TOFFL",
                                                  "$AC_TOFFR",
                                                  "$AC_FZ",
                                                  "$AC_F_TYPE",
                                                  "$AC_SVC",
                                                  "$AC_S_TYPE",
                                                  "$P_APR",
                                                  "$P_AEP",
                                                  "$P_APDV",
                                                  "$P_PFRAME",
                                                  "$P_ACTFRAME",
                                                  "$P_IFRAME",
                                                  "$P_ACTBFRAME",
                                                  "$P_BFRAME",
                                                  "$P_CHBFRAME",
                                                  "$P_GFRAME",
                                                  "$P_GFR",
                                                  "$AC_LIFTFAST",
                                                  "$AA_ACC",
                                                  "$AA_IM",
                                                  "$AA_IW",
                                                  "$AA_MM",
                                                  "$AA_MW",
                                                  "$AC_MEA",
                                                  "$AC_DELT",
                                                  "$AA_DELT",
                                                  "$AA_IB",
                                                  "$AA_FXS",
                                                  "$AA_S",
                                                  "$AC_MARKER",
                                                  "$AC_PARAM",
                                                  "$AC_TIME",
                                                  "$A_YEAR",
                                                  "$A_MONTH",
                                                  "$A_DAY",
                                                  "$A_HOUR",
                                                  "$A_MINUTE",
                                                  "$A_SECOND",
                                                  "$A_IN",
                                                  "$A_OUT",
                                                  "$AN_LANGUAGE_ON_HMI",
                                                  "$AA_OFF",
                                                  "$AA_OFF_VAL",
                                                  "$AA_LEAD_SP",
                                                  "$AA_LEAD_SV",
                                                  "$AA_ESR_TRIGGER",
                                                  "$P_TOOLFRAME",
                                                  "$P_ACTID",
                                                  "$P_UIFR",
                                                  "$P_UIFRNUM",
                                                  "$P_NUM_SPINDLES"};
    for (const std::string_view known : kNames)
        if (known == name) return true;
    return name.starts_with("$TC_DP") || name.starts_with("$TC_MOP") || name == "$TC_TP9" ||
           name == "$TC_TP2" || name == "$TC_TP_MAX_VELO" || grinding_parameter(name);
}
}  // namespace polyturn::channels::sinumerik
