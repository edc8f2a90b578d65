// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/window_operations.h"

#include <QSet>
#include <QTest>

#include "tests/test_class.h"

namespace document_window_operations_test {

class WindowOperationsTest : public QObject {
    Q_OBJECT

private slots:
    void theyAreFoundByTheirOperation()
    {
        for (std::size_t i = 0; i < app::windowOperations().size(); ++i) {
            QCOMPARE(std::size_t(app::windowOperations()[i].operation), i);
            QCOMPARE(&app::infoOf(app::WindowOperation(i)), &app::windowOperations()[i]);
            QCOMPARE(app::windowOperation(app::windowOperations()[i].word),
                     std::optional(app::WindowOperation(i)));
        }
        for (const char* word : {"", "Add", "cut out", "subtract"})
            QVERIFY(!app::windowOperation(word));
    }
    void theyAreToldApart()
    {
        QSet<QString> texts;
        QList<std::vector<double>> dashes;
        for (const app::WindowOperationInfo& each : app::windowOperations()) {
            for (const QString& text : {each.letter + " letter", each.sign + " sign", each.name,
                                        each.verb, each.entry, each.tip, each.step, each.phrase}) {
                QVERIFY2(!texts.contains(text), qPrintable(text));
                texts << text;
            }
            QCOMPARE(each.step.count("%1"), 1);
            if (!each.dashes.empty()) // what adds or replaces is in the result
                QVERIFY(!dashes.contains(each.dashes));
            dashes << each.dashes;
        }
    }
};

} // namespace document_window_operations_test

TEST_CLASS(document_window_operations_test::WindowOperationsTest, Core)
#include "tests/app/document/window_operations_test.moc"
