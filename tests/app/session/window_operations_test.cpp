// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_operations.h"

#include <QSet>
#include <QTest>

#include "tests/test_class.h"

namespace session_window_operations_test {

class WindowOperationsTest : public QObject {
    Q_OBJECT

private slots:
    void theyAreFoundByTheirOperation()
    {
        for (std::size_t i = 0; i < app::windowOperations().size(); ++i) {
            QCOMPARE(std::size_t(app::windowOperations()[i].operation), i);
            QCOMPARE(&app::infoOf(app::WindowOperation(i)), &app::windowOperations()[i]);
        }
    }
    void theyAreToldApart()
    {
        QSet<QString> texts;
        QList<std::vector<double>> dashes;
        for (const app::WindowOperationInfo& each : app::windowOperations()) {
            for (const QString& text : {each.letter + " letter", each.sign + " sign", each.name,
                                        each.verb, each.entry, each.tip, each.step}) {
                QVERIFY2(!texts.contains(text), qPrintable(text));
                texts << text;
            }
            QCOMPARE(each.step.count("%1"), 1);
            QVERIFY(!dashes.contains(each.dashes));
            dashes << each.dashes;
        }
    }
};

} // namespace session_window_operations_test

TEST_CLASS(session_window_operations_test::WindowOperationsTest, Core)
#include "tests/app/session/window_operations_test.moc"
