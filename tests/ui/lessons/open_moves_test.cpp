// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/variants.h"
#include "ui/microscope/microscope_page.h"
#include "ui/microscope/microscope_view.h"

#include <QAction>
#include <QMenu>
#include <QTimer>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace lessons_open_moves_test {

using namespace ui;

namespace {

/// A window with an attempt.
struct AttemptWindow : TestWindow {
    AttemptWindow()
    {
        answers->answer = Questions::Answer::DontSave;
        show();
        begin();
    }
    void begin()
    {
        window->showLessons();
        practice().begin(*app::findVariant(QStringLiteral("cs:published")));
        QCoreApplication::processEvents();
    }
    app::Practice& practice() const { return window->session().practice; }
    app::Microscope& microscope() const { return window->session().microscope; }
};

} // namespace

/// Nothing but an answer uncovers a step.
class OpenMovesTest : public QObject {
    Q_OBJECT

private slots:
    void noCommandUncoversAMove()
    {
        static const QStringList leave{"quit",       "close",     "about-qt",  "print",
                                       "experiment", "judge-own", "hard-cases"};
        AttemptWindow bench;
        QTimer closer;
        connect(&closer, &QTimer::timeout, this, [] {
            if (QWidget* waiting = QApplication::activePopupWidget()
                                       ? QApplication::activePopupWidget()
                                       : QApplication::activeModalWidget())
                waiting->close();
        });
        closer.start(5);
        int tried = 0;
        for (QAction* action : bench.window->findChildren<QAction*>()) {
            if (action->menu() || action->isSeparator() || !action->isEnabled()
                || action->objectName().isEmpty() || leave.contains(action->objectName()))
                continue;
            if (!bench.practice().asks())
                bench.begin();
            const app::TracedLine line = bench.practice().tracedLine();
            action->trigger();
            bench.window->files().wait();
            QCoreApplication::processEvents();
            QVERIFY2(!bench.microscope().isOpen() || bench.microscope().isCovered()
                         || bench.microscope().tracedLine().line != line.line,
                     qPrintable(action->objectName()));
            ++tried;
        }
        QVERIFY(tried > 60);
    }
    void escLeavesTheAttempt()
    {
        AttemptWindow bench;
        bench.window->microscopePage()->view().setFocus();
        QTest::keyClick(&bench.window->microscopePage()->view(), Qt::Key_Escape);
        QCoreApplication::processEvents();
        QVERIFY(!bench.practice().isOn() && !bench.microscope().isOpen());
    }
};

} // namespace lessons_open_moves_test

TEST_CLASS(lessons_open_moves_test::OpenMovesTest, Widgets)
#include "tests/ui/lessons/open_moves_test.moc"
