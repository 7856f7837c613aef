// Walking a TOML document with a diagnosis for whatever is not understood. Only the .cpp files here
// include this: the TOML library is heavy and stays behind setup.hpp, scenario.hpp and job.hpp.
#pragma once
#include <toml++/toml.h>

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::text {

class TomlReader {
public:
    TomlReader(std::string_view filename, std::vector<Diagnosis>& diagnoses)
        : filename_(filename), diagnoses_(&diagnoses) {}

    // Nothing when the text is no TOML; then a diagnosis says where.
    std::optional<toml::table> parse(std::string_view content);

    // Calls `take` for each key of the table in the file's order.
    using Take = std::function<void(const toml::key& key, const toml::node& node)>;
    void each(const toml::table& table, const Take& take);

    // The node as what it must be; otherwise a diagnosis that names the key, and nothing.
    const toml::table* table(const toml::key& key, const toml::node& node);
    const toml::array* array(const toml::key& key, const toml::node& node);
    std::optional<double> number(const toml::key& key, const toml::node& node);  // finite
    std::optional<long> whole(const toml::key& key, const toml::node& node, long low, long high);
    std::optional<bool> flag(const toml::key& key, const toml::node& node);  // true, false, 1, 0
    std::optional<std::string> text(const toml::key& key, const toml::node& node);
    std::optional<long> whole_key(const toml::key& key, long low, long high, std::string_view what);

    void unknown(const toml::key& key, std::string_view known);  // known: what could stand here
    void wrong(const toml::key& key, const toml::node& node, std::string_view wanted);
    void fault(Alarm alarm, const toml::source_region& where, std::string detail,
               std::uint32_t length = 1);
    Place place(const toml::source_region& where, std::uint32_t length = 1) const;

private:
    std::string_view filename_;
    std::vector<Diagnosis>* diagnoses_;
};

}  // namespace polyturn::text
