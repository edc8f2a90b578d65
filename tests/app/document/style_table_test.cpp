// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/style_table.h"

#include <QTest>

#include <cmath>
#include <thread>
#include <vector>

#include "tests/test_class.h"

namespace document_style_table_test {

using namespace app;

namespace {

Style numbered(int i)
{
    Style style;
    style.stroke = Colour{std::uint8_t(i), std::uint8_t(i >> 8), std::uint8_t(i >> 16)};
    style.width = i;
    style.dashes = {double(i), 1};
    return style;
}

} // namespace

class StyleTableTest : public QObject {
    Q_OBJECT

private slots:
    void eachStyleIsThereOnce()
    {
        StyleTable table;
        QCOMPARE(table.size(), std::size_t(0));
        for (int round = 0; round < 2; ++round)
            for (int i = 0; i < 2000; ++i)
                QCOMPARE(table.indexOf(numbered(i)), StyleIndex(i));
        QCOMPARE(table.size(), std::size_t(2000));
        for (int i = 0; i < 2000; ++i)
            QCOMPARE(table[StyleIndex(i)], numbered(i));
    }
    void aCopyHasTheSameNumbers()
    {
        StyleTable table;
        for (int i = 0; i < 700; ++i)
            table.indexOf(numbered(i));
        StyleTable copy = table;
        QCOMPARE(copy.size(), std::size_t(700));
        for (int i = 0; i < 700; ++i)
            QCOMPARE(copy.indexOf(numbered(i)), StyleIndex(i));
        QCOMPARE(copy.indexOf(numbered(700)), StyleIndex(700));
        QCOMPARE(table.size(), std::size_t(700));
    }
    void everyMemberCounts()
    {
        StyleTable table;
        std::vector<Style> styles(15);
        styles[1].stroke = Colour{};
        styles[2].fill = Colour{};
        styles[3].fill = Colour{0, 0, 0, 0};
        styles[4].width = 2;
        styles[5].miterLimit = 2;
        styles[6].dashOffset = 1;
        styles[7].dashes = {1, 2};
        styles[8].dashes = {2, 1};
        styles[9].cap = Cap::Round;
        styles[10].join = Join::Round;
        styles[11].fillRule = FillRule::EvenOdd;
        styles[12].dashOffset = -0.0; // another bit in a file
        styles[13].dashes = {1, 2, -0.0};
        styles[14].width = NAN;
        for (int round = 0; round < 2; ++round)
            for (std::size_t i = 0; i < styles.size(); ++i)
                QCOMPARE(table.indexOf(styles[i]), StyleIndex(i));
    }
    void stylesStayWhereTheyAre()
    {
        StyleTable table;
        std::vector<const Style*> places;
        for (int i = 0; i < 20'000; ++i)
            places.push_back(&table[table.indexOf(numbered(i))]);
        for (int i = 0; i < 20'000; ++i) {
            QCOMPARE(&table[StyleIndex(i)], places[std::size_t(i)]);
            QCOMPARE(*places[std::size_t(i)], numbered(i));
        }
    }
    void fourThreadsReadWhileOneAdds()
    {
        constexpr int all = 5000;
        StyleTable table;
        std::vector<std::jthread> readers;
        for (int reader = 0; reader < 4; ++reader)
            readers.emplace_back([&table] {
                for (std::size_t size = 0; size < all;) {
                    size = table.size();
                    for (std::size_t i = size < 20 ? 0 : size - 20; i < size; ++i)
                        if (!(table[StyleIndex(i)] == numbered(int(i))))
                            qFatal("a style is not there yet");
                }
            });
        for (int i = 0; i < all; ++i)
            table.indexOf(numbered(i));
    }
    void severalThreadsMayAdd()
    {
        StyleTable table;
        std::vector<std::jthread> threads;
        for (int thread = 0; thread < 3; ++thread)
            threads.emplace_back([&table] {
                for (int i = 0; i < 2000; ++i)
                    if (!(table[table.indexOf(numbered(i))] == numbered(i)))
                        qFatal("another style has this number");
            });
        threads.clear();
        QCOMPARE(table.size(), std::size_t(2000));
    }
};

} // namespace document_style_table_test

TEST_CLASS(document_style_table_test::StyleTableTest, None)
#include "tests/app/document/style_table_test.moc"
