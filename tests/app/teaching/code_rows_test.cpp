// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/code_rows.h"

#include <QTest>

#include <random>

#include "tests/test_class.h"

namespace teaching_code_rows_test {

using app::codeRows;

class CodeRowsTest : public QObject {
    Q_OBJECT

    static QStringList told(const std::vector<app::CodeRow>& rows)
    {
        QStringList lines;
        for (const app::CodeRow& row : rows)
            lines << QStringLiteral("%1-%2%3 %4")
                         .arg(row.first)
                         .arg(row.last)
                         .arg(QLatin1String(row.folds ? "*" : ""), row.text);
        return lines;
    }
    static inline const QStringList code{"a",       "if b",  "  c",    "  d",   "else",
                                         "  if e",  "    f", "  else", "    g", "    h",
                                         "proc(x)", "  i",   "  if j", "    k", "last"};

private slots:
    void branchesThatWereNotTakenAreOneRow()
    {
        QCOMPARE(told(codeRows(code, {1, 2, 6, 7, 15})),
                 (QStringList{"1-1 a", "2-2 if b", "3-4*   not the case", "5-5 else", "6-6   if e",
                              "7-7     f", "8-10*   else …", "11-14* proc(x) …", "15-15 last"}));
        // One line alone stays, and so does what surrounds a line that was run.
        QCOMPARE(
            told(codeRows(code, {1, 2, 3, 14})),
            (QStringList{"1-1 a", "2-2 if b", "3-3   c", "4-4   d", "5-10* else …", "11-11 proc(x)",
                         "12-12   i", "13-13   if j", "14-14     k", "15-15 last"}));
    }
    void anUnfoldedBranchIsWhole()
    {
        const auto rows = codeRows(code, {1, 2, 3, 15}, {5});
        QCOMPARE(rows.size(), std::size_t(12));
        QVERIFY(rows[4].folds && !rows[4].isFolded());
        QVERIFY(!rows[7].folds); // within it nothing is folded
        QVERIFY(rows[10].isFolded());
    }
    void withoutARunNothingIsFolded()
    {
        QCOMPARE(codeRows(code, {}).size(), std::size_t(code.size()));
        QVERIFY(codeRows({}, {1, 2}).empty());
        QCOMPARE(codeRows(code, {99}).back().last, int(code.size()));
    }
    /// Of all algorithms, for random lines: each line is in one row, those of the steps in rows of
    /// their own, and so is what they stand in.
    void everyRowIsALineOrABranchWithoutSteps()
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> number(-200, 200);
        int folded = 0;
        for (const app::Variant& variant : app::variants())
            for (int i = 0; i < 20; ++i) {
                const app::TracedLine traced{
                    variant,
                    {{number(random), number(random)}, {number(random), number(random)}},
                    {{-100, -75}, {100, 75}},
                    app::YAxis::Up,
                    {}};
                const app::Narration narration = app::narrationOf(traced);
                const auto run = app::linesRun(narration);
                int next = 1;
                for (const app::CodeRow& each : codeRows(narration.code, run)) {
                    QCOMPARE(each.first, next);
                    next = each.last + 1;
                    folded += each.isFolded();
                    const bool steps = run.lower_bound(each.first) != run.upper_bound(each.last);
                    QVERIFY(!each.isFolded() || !steps);
                    if (!each.isFolded())
                        QCOMPARE(each.text, narration.code[each.first - 1]);
                }
                QCOMPARE(next, int(narration.code.size()) + 1);
            }
        QVERIFY(folded > 100);
    }
};

} // namespace teaching_code_rows_test

TEST_CLASS(teaching_code_rows_test::CodeRowsTest, Core)
#include "tests/app/teaching/code_rows_test.moc"
