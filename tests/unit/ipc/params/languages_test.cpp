// The languages of programs have their names in one table; PT_LANGUAGE takes the same ones.
#include "ipc/diagnosis/languages.hpp"

#include <gtest/gtest.h>

#include "ipc/params/registry.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn::params {
namespace {

TEST(Languages, AreThoseThatTheParameterTakes) {
    const auto& choices = rows()[pt_language.row].choices;
    ASSERT_EQ(choices.size(), std::size(kProgramLanguages));
    for (const std::string_view name : choices) {
        const Dialect one = dialect_of(name);
        EXPECT_NE(one, Dialect::Polyturn) << name;
        EXPECT_EQ(language_name(one), name);
    }
    EXPECT_EQ(dialect_of("heidenhain"), Dialect::Polyturn);
    EXPECT_EQ(dialect_of(""), Dialect::Polyturn);
    EXPECT_EQ(language_name(Dialect::Polyturn), "");
}

}  // namespace
}  // namespace polyturn::params
