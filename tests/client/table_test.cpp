#include "client/output/table.hpp"

#include "client/output/results_table.hpp"

#include <gtest/gtest.h>
#include <sstream>

namespace lamprey::client::output {
namespace {

class TableTest : public testing::Test {
 protected:
  std::ostringstream out;
  std::ostringstream err;
  Console console{.out = out, .err = err, .columns = 40};
};

TEST_F(TableTest, NumbersAlignRightUnderAThinRule) {
  Table table({{"sweep"}, {"jobs", Align::right}});
  table.add({"a", "12,345"});
  table.add({"longer", "7"});
  table.print(console);
  EXPECT_EQ(out.str(),
            "sweep     jobs\n"
            "--------------\n"
            "a       12,345\n"
            "longer       7\n");
}

TEST_F(TableTest, NoLineEndsInWhiteSpace) {
  Table table({{"name"}, {"text"}});
  table.add({"a", ""});
  table.print(console);
  EXPECT_EQ(out.str(), "name  text\n----------\na\n");
}

TEST_F(TableTest, NotesAreIndentedAndWrapped) {
  Table table({{"name"}});
  table.add({"a"});
  table.note("a note that is longer than the forty columns of it");
  table.print(console);
  EXPECT_NE(out.str().find("\n    a note that is longer than the forty\n    columns of it\n"), std::string::npos);
}

TEST_F(TableTest, StylesAppearOnlyOnATerminalWithColour) {
  EXPECT_EQ(console.bold("x"), "x");
  Console terminal{.out = out, .err = err, .out_is_terminal = true, .colour = true};
  EXPECT_EQ(terminal.bold("x"), "\x1b[1mx\x1b[0m");
  EXPECT_EQ(terminal.red("x"), "x") << "err is no terminal";
  terminal.colour = false;
  EXPECT_EQ(terminal.bold("x"), "x");
}

TEST(ResultsTable, LiteralsReadAsPlainText) {
  EXPECT_EQ(plain("null"), "");
  EXPECT_EQ(plain(R"("a \"b\"")"), "a \"b\"");
  EXPECT_EQ(plain("0.8433333333333334"), "0.8433333333333334");
  EXPECT_EQ(readable("0.8433333333333334"), "0.843333");
  EXPECT_EQ(readable("18446744073709551615"), "18446744073709551615") << "whole numbers keep all digits";
}

TEST(ResultsTable, CommaSeparatedValuesAreQuotedWhereNeeded) {
  EXPECT_EQ(csv_line({"a", "b,c", "d\"e", "", "f\ng"}), "a,\"b,c\",\"d\"\"e\",,\"f\ng\"\n");
}

TEST_F(TableTest, ColumnsGiveWayInTheirOrderUntilTheRestFits) {
  const std::vector<std::string> columns = {"job", "a_rather_wide_column", "another_wide_column", "total"};
  const std::vector<std::vector<std::string>> rows = {{"1", "2", "3", "4.5"}};
  const auto left_out = print_results(console, {columns, rows}, {0, 1, 2, 3}, {"another_wide_column", "job"});
  EXPECT_EQ(left_out, std::vector<std::string>{"another_wide_column"});
  EXPECT_TRUE(out.str().starts_with("job  a_rather_wide_column  total\n")) << out.str();
}

}  // namespace
}  // namespace lamprey::client::output
