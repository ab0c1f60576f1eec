#include "studies/readers/csv_reader.hpp"

#include "core/support/error.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>

namespace ff::studies {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Texts = std::vector<std::string>;

std::vector<Texts> read(std::string_view text) {
    CsvReader reader(text, "x.csv");
    std::vector<Texts> records;
    std::vector<CsvField> record;
    while (reader.next(record)) {
        Texts& texts = records.emplace_back();
        for (const CsvField& field : record) texts.push_back(field.text);
    }
    return records;
}

std::string refusal_of_csv(std::string_view text) {
    return test::message_of<UserError>([&] { read(text); });
}

TEST(CsvReader, ReadsRecordsWithAnyLineEnd) {
    const Texts first{"a", "b"};
    const Texts second{"1", "2"};
    EXPECT_THAT(read("a,b\n1,2\n"), ElementsAre(first, second));
    EXPECT_THAT(read("a,b\r\n1,2\r\n"), ElementsAre(first, second));
    EXPECT_THAT(read("a,b\n1,2"), ElementsAre(first, second));
    EXPECT_THAT(read("a,b\n\n\r\n1,2\n\n"), ElementsAre(first, second));
}

TEST(CsvReader, KeepsEmptyCells) {
    EXPECT_THAT(read("a,,\n,"), ElementsAre(Texts{"a", "", ""}, Texts{"", ""}));
}

TEST(CsvReader, ReadsQuotedCommasQuotesAndLineEndsAsText) {
    EXPECT_THAT(read("\"a,b\",\"say \"\"so\"\"\",\"two\nlines\"\n"),
                ElementsAre(Texts{"a,b", "say \"so\"", "two\nlines"}));
    EXPECT_THAT(read("\"\",x\n"), ElementsAre(Texts{"", "x"}));
}

TEST(CsvReader, SkipsAByteOrderMark) {
    EXPECT_THAT(read("\xef\xbb\xbf"
                     "a,b\n"),
                ElementsAre(Texts{"a", "b"}));
}

TEST(CsvReader, KnowsWhereAFieldBegins) {
    CsvReader reader("a,b\n\"x\ny\",zz,w\n", "x.csv");
    std::vector<CsvField> record;
    reader.next(record);
    reader.next(record);
    EXPECT_EQ(record[0].line, 2u);
    EXPECT_EQ(record[1].line, 3u);
    EXPECT_EQ(record[1].column, 4u);
}

TEST(CsvReader, RefusesQuotesThatDoNotMatch) {
    EXPECT_THAT(refusal_of_csv("a\n1,\"2\n3,4\n"), HasSubstr("x.csv:2:3: a quote is opened and never closed"));
    EXPECT_THAT(refusal_of_csv("a\n\"1\"2\n"), HasSubstr("x.csv:2:1: text follows a closing quote"));
    EXPECT_THAT(refusal_of_csv("\xff\xfe"
                               "a"),
                HasSubstr("UTF-16"));
}

TEST(CsvReader, ReadsNoRecordFromAnEmptyText) {
    EXPECT_THAT(read(""), testing::IsEmpty());
    EXPECT_THAT(read("\r\n\n"), testing::IsEmpty());
}

}  // namespace
}  // namespace ff::studies
