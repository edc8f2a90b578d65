// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/session/difference_row.h"

#include <QTest>

#include <limits>

#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"

namespace session_difference_row_test {

class DifferenceRowTest : public QObject {
    Q_OBJECT

private slots:
    void ulpsInWords_data()
    {
        QTest::addColumn<double>("ulps");
        QTest::addColumn<QString>("text");
        QTest::newRow("a point") << 0.0 << "0";
        QTest::newRow("whole") << 3.0 << "3";
        QTest::newRow("half") << 3.5 << "3.5";
        QTest::newRow("some") << 1234.4 << "1,234";
        QTest::newRow("many") << 8.44e12 << "8.4 × 10¹²";
        QTest::newRow("all") << std::numeric_limits<double>::infinity() << "∞";
    }
    void ulpsInWords()
    {
        QFETCH(double, ulps);
        QTEST(app::ulpsText(ulps), "text");
    }

    /// Both read the same, but it is said how far they are apart, and the tip has all digits.
    void endsThatDifferInTheLastPlaceAreSeenToDiffer()
    {
        app::Session session;
        app::Sheet sheet;
        sheet.window = {{1, 0}, {2, 2}};
        for (const double y : {0.1, 0.7, 0.3, 0.9, 0.6}) {
            app::Shape line;
            line.paths = {{{-1, y}, {{{6, y + 1.6}}}}};
            sheet.shapes.push_back(std::move(line));
        }
        ::load(session.document, std::move(sheet));
        session.differences.ask(
            app::Comparison{*app::findVariant("cb:published"), app::exactVariant(), 0});
        session.differences.finish();
        const auto& list = session.differences.found().list;
        QVERIFY(!list.empty());
        const auto columns = app::differenceColumns();
        for (const app::Difference& difference : list) {
            QCOMPARE(columns[1].text(session, difference), "different ends");
            QVERIFY(columns[2].text(session, difference).contains(" ulp"));
            QCOMPARE(columns[3].text(session, difference), columns[4].text(session, difference));
            const QStringList full = app::piecesInFull(session, difference).split('\n');
            QVERIFY(full[0].section(": ", 1) != full[1].section(": ", 1));
        }
        // Nobody looks any more, and the line is gone: no words, and no crash.
        const app::Difference gone{99, app::Difference::Kind::OnlyA, 1};
        QCOMPARE(columns[0].text(session, gone), "");
        QCOMPARE(app::piecesInFull(session, gone), "");
        const app::Difference first = list.front();
        session.differences.ask(std::nullopt);
        for (const std::size_t column : {0, 1, 2, 3, 4, 5})
            QCOMPARE(columns[column].text(session, first), "");
    }

    void endsThatAreSeenToDifferAreApartInTheUnit()
    {
        app::Session session;
        app::Sheet sheet;
        sheet.window = {{0, 0}, {100, 100}};
        app::Shape line; // leaves by the lower edge at (50, 100)
        line.paths = {{{40, 80}, {{{60, 120}}}}};
        sheet.shapes.push_back(std::move(line));
        ::load(session.document, std::move(sheet));
        session.differences.ask(app::Comparison{*app::findVariant("md-step-2")});
        session.differences.finish();
        const auto& list = session.differences.found().list;
        QCOMPARE(list.size(), std::size_t(1));
        QCOMPARE(list[0].kind, app::Difference::Kind::EndsApart);
        // x1 + (x2 - x1) / (y2 - y1) (ymax - x1) = 40 + 20 / 40 * 60 = 70, not 50
        const double size = session.now().page().millimetresPerUnit();
        QCOMPARE(app::differenceColumns()[2].text(session, list[0]),
                 app::lengthText(20, session.display().unit, size));
    }

    void everyColumnSortsBothWays()
    {
        app::Session session;
        app::Sheet sheet;
        sheet.window = {{0, 0}, {100, 100}};
        for (int i = 0; i < 40; ++i) {
            app::Shape line;
            line.paths = {{{100. - 2 * i, 50. - i}, {{{100.5 - 2 * i, 60. + 7 * (i % 5)}}}}};
            sheet.shapes.push_back(std::move(line));
        }
        ::load(session.document, std::move(sheet));
        session.differences.ask(app::Comparison{*app::findVariant("kwc:published")});
        session.differences.finish();
        const auto& list = session.differences.found().list;
        QVERIFY(list.size() > 10);
        for (const app::DifferenceColumn& column : app::differenceColumns())
            for (const auto order : {Qt::AscendingOrder, Qt::DescendingOrder}) {
                const auto rows = app::sortedBy(session, column, order);
                QCOMPARE(rows.size(), list.size());
                for (std::size_t i = 1; i < rows.size(); ++i) {
                    const auto before = column.key(session, list[rows[i - 1]]);
                    const auto after = column.key(session, list[rows[i]]);
                    QVERIFY(order == Qt::AscendingOrder ? before <= after : before >= after);
                    QVERIFY(before != after || rows[i - 1] < rows[i]);
                }
            }
    }
};

} // namespace session_difference_row_test

TEST_CLASS(session_difference_row_test::DifferenceRowTest, Core)
#include "tests/app/session/difference_row_test.moc"
