// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/session.h"
#include "ui/docks/history_panel.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/app/document/one_window.h"
#include "tests/test_class.h"

namespace docks_history_panel_test {

using namespace ui;

class HistoryPanelTest : public QObject {
    Q_OBJECT

    static void push(app::Session& session, double width)
    {
        session.history.push(windowStep(session.document, {{0, 0}, {width, 5}}));
    }
    static QStringList texts(const HistoryPanel& panel)
    {
        QStringList texts;
        for (int row = 0; row < panel.model()->rowCount(); ++row)
            texts << panel.model()->index(row, 0).data().toString();
        return texts;
    }

private slots:
    void itListsEveryStepAndMarksTheSavedState()
    {
        app::Session session;
        HistoryPanel panel(session.history);
        QCOMPARE(texts(panel), QStringList("Start"));
        push(session, 1);
        session.history.setClean();
        push(session, 2);
        session.history.undo();
        QCOMPARE(texts(panel),
                 QStringList({"Start", session.history.text(0), session.history.text(1)}));
        const auto is = [&](int row, int role) {
            return panel.model()->index(row, 0).data(role).toBool();
        };
        QVERIFY(is(1, HistoryModel::SavedRole) && !is(2, HistoryModel::SavedRole));
        QVERIFY(is(2, HistoryModel::UndoneRole) && !is(1, HistoryModel::UndoneRole));
        QCOMPARE(panel.currentIndex().row(), 1);
        push(session, 3); // replaces the undone step
        QCOMPARE(panel.model()->rowCount(), 3);
        QVERIFY(!is(2, HistoryModel::UndoneRole));
    }
    void lettersAskForNothing()
    {
        app::Session session;
        HistoryPanel panel(session.history);
        push(session, 1);
        push(session, 2);
        panel.show();
        const QSignalSpy wanted(&panel, &HistoryPanel::stepWanted);
        QTest::keyClicks(&panel, "SDM");
        QCOMPARE(wanted.size(), 0);
    }
    void aClickAndAnArrowKeyAskForAStep()
    {
        app::Session session;
        HistoryPanel panel(session.history);
        for (const double width : {1., 2., 3.})
            push(session, width);
        panel.resize(200, 300);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        connect(&panel, &HistoryPanel::stepWanted, &session.history, &app::History::setIndex);
        const QSignalSpy wanted(&panel, &HistoryPanel::stepWanted);
        QTest::mouseClick(panel.viewport(), Qt::LeftButton, {},
                          panel.visualRect(panel.model()->index(1, 0)).center());
        QCOMPARE(session.history.index(), 1);
        QTest::keyClick(&panel, Qt::Key_Up);
        QCOMPARE(session.history.index(), 0);
        QTest::keyClick(&panel, Qt::Key_End);
        QCOMPARE(session.history.index(), 3);
        QCOMPARE(wanted.size(), 3); // undo and redo themselves ask for nothing
        session.history.undo();
        QCOMPARE(wanted.size(), 3);
        QCOMPARE(panel.currentIndex().row(), 2);
    }
};

} // namespace docks_history_panel_test

TEST_CLASS(docks_history_panel_test::HistoryPanelTest, Widgets)
#include "tests/ui/docks/history_panel_test.moc"
#include "tests/app/document/one_window.h"
