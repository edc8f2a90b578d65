// SPDX-License-Identifier: GPL-3.0-or-later
// Random keys, clicks, unfinished gestures and commands on all widgets.
// The environment variables CLEARCUT_EVENTS and CLEARCUT_SEED set their number and the seed.
#include <QApplication>
#include <QListView>
#include <QMenu>
#include <QTimer>
#include <QWheelEvent>

#include <cmath>
#include <random>

#include "tests/app/document/sheet_edits.h"
#include "tests/ui/test_window.h"

using namespace ui;

namespace {

quint64 fromEnvironment(const char* name, quint64 usual)
{
    return qEnvironmentVariableIsSet(name) ? qEnvironmentVariable(name).toULongLong() : usual;
}

class Somebody {
public:
    explicit Somebody(quint64 seed) : random_(seed)
    {
        test_.open(test_.twoLines());
        test_.show();
        test_.answers->answer = Questions::Answer::DontSave;
        for (QAction* action : test_.window->findChildren<QAction*>())
            if (!action->menu() && !action->isSeparator() && !leavesTheWindow(*action))
                actions_ << action;
        // Questions get no answer.
        QObject::connect(&closer_, &QTimer::timeout, [] {
            if (QWidget* waiting = QApplication::activePopupWidget()
                                       ? QApplication::activePopupWidget()
                                       : QApplication::activeModalWidget())
                waiting->close();
        });
        closer_.start(20);
        QObject::connect(&session(), &app::Session::loaded,
                         [this] { start_ = sheetOf(session().document); });
        start_ = sheetOf(session().document);
    }

    /// Sends one random event, waits for the file that it reads or writes, and describes it.
    QString act()
    {
        const QString what = send();
        test_.window->files().wait();
        return what;
    }

    /// The fault found now, or empty.
    QString fault()
    {
        const app::Sheet& sheet = sheetOf(session().document);
        const auto& selection = session().selection();
        if (!session().now().containers().contains(session().pen.layer))
            return "the pen is on no layer";
        if (!std::ranges::is_sorted(sheet.shapes, {}, &app::Shape::layer)
            || (!sheet.shapes.empty() && sheet.shapes.back().layer >= sheet.layers.size()))
            return "a shape is on no layer";
        if (!selection.empty() && selection.last() >= sheet.shapes.size())
            return "what is selected is not there";
        const auto segments = segmentsOf(session().scene.lines());
        if (session().inspected() && *session().inspected() >= segments.size())
            return "what is inspected is not there";
        if (!(sheet.window.min.x <= sheet.window.max.x && sheet.window.min.y <= sheet.window.max.y))
            return "the window is inside out";
        const app::Panes& panes = test_.window->canvas().panes();
        const app::Display& display = session().display();
        if (panes.chosen() != usable(display.variant))
            return "what is chosen is not the active pane's";
        const bool otherPage = session().microscope.isOpen() || test_.window->sheets().isOpen();
        if (test_.drawingArea()->isVisibleTo(test_.window.get()) == otherPage
            || test_.drawingArea() != test_.window->canvas().paneSurface(panes.active()))
            return "the active pane is not in sight";
        return segmentsOf(app::Scene(session().document).lines()) == segments
                   ? QString()
                   : "the scene is not the drawing";
    }

    /// Whether undoing everything restores the opened drawing, and redoing the edited one.
    bool historyHolds()
    {
        QTest::keyClick(test_.drawingArea(), Qt::Key_Escape); // ends a gesture
        const app::Sheet now = sheetOf(session().document);
        app::History& history = session().history;
        const int index = history.index();
        history.setIndex(0);
        const bool back = sheetOf(session().document) == start_;
        history.setIndex(index);
        return back && sheetOf(session().document) == now;
    }

private:
    QString send()
    {
        switch (below(13)) {
        case 0:
        case 1:
            return command();
        case 2:
            return key();
        case 3:
            return list();
        case 4:
            return undo();
        case 5:
            return wheel();
        case 6:
            return resize();
        case 7:
            return drag();
        case 8:
            return pane();
        default:
            return mouse();
        }
    }
    app::Session& session() { return test_.window->session(); }
    int below(int most) { return int(random_() % unsigned(most)); }
    template <class List>
    auto& oneOf(List& list)
    {
        return list[below(int(std::size(list)))];
    }
    QPoint place()
    {
        const QSize size = test_.drawingArea()->size();
        return {below(size.width() + 40) - 20, below(size.height() + 40) - 20};
    }
    Qt::KeyboardModifiers modifiers()
    {
        static constexpr Qt::KeyboardModifier all[]{Qt::NoModifier,      Qt::NoModifier,
                                                    Qt::NoModifier,      Qt::ShiftModifier,
                                                    Qt::ControlModifier, Qt::AltModifier};
        return oneOf(all);
    }
    static bool leavesTheWindow(const QAction& action)
    {
        return QStringList{"quit", "close", "about-qt", "full-screen"}.contains(
            action.objectName());
    }

    QString command()
    {
        test_.answers->open = test_.path("two.svg");
        test_.answers->save = test_.path(below(2) ? "random.svg" : "random.csv");
        QAction* action = oneOf(actions_);
        const QString text = action->text(); // of undo and redo it changes
        action->trigger();
        return "command " + text;
    }
    QString key()
    {
        static constexpr Qt::Key all[]{
            Qt::Key_V,         Qt::Key_L,      Qt::Key_P,     Qt::Key_B,     Qt::Key_R,
            Qt::Key_E,         Qt::Key_W,      Qt::Key_Z,     Qt::Key_H,     Qt::Key_Delete,
            Qt::Key_Backspace, Qt::Key_Escape, Qt::Key_Left,  Qt::Key_Right, Qt::Key_Up,
            Qt::Key_Down,      Qt::Key_Return, Qt::Key_Space, Qt::Key_1,     Qt::Key_6,
            Qt::Key_8,         Qt::Key_F7,     Qt::Key_F8,    Qt::Key_Tab};
        const Qt::Key key = oneOf(all);
        const auto held = modifiers();
        QTest::keyClick(test_.drawingArea(), key, held);
        return QString("key %1 with %2").arg(QKeySequence(key).toString()).arg(int(held));
    }
    QString list()
    {
        const auto lists = test_.window->findChildren<QListView*>();
        QListView* one = oneOf(lists);
        const QPoint at(below(std::max(1, one->viewport()->width())),
                        below(std::max(1, one->viewport()->height())));
        QTest::mouseClick(one->viewport(), Qt::LeftButton, {}, at);
        return "click in the list of " + one->accessibleName();
    }
    QString undo()
    {
        app::History& history = session().history;
        const int index = below(history.count() + 1);
        if (below(4) == 0)
            history.setIndex(index);
        else
            below(2) ? history.undo() : history.redo();
        return "undo or redo";
    }
    QString wheel()
    {
        QWidget* area = test_.drawingArea();
        const QPointF at = place();
        QWheelEvent event(at, area->mapToGlobal(at), {}, {0, 120 * (below(3) - 1)}, Qt::NoButton,
                          modifiers(), Qt::NoScrollPhase, false);
        QApplication::sendEvent(area, &event);
        return "wheel";
    }
    QString resize()
    {
        test_.window->resize(1024 + below(500), 640 + below(300));
        return "resize";
    }
    QString drag()
    {
        const auto held = modifiers();
        QTest::mousePress(test_.drawingArea(), Qt::LeftButton, held, place());
        for (int i = below(4); i >= 0; --i)
            move(Qt::LeftButton, held);
        QTest::mouseRelease(test_.drawingArea(), Qt::LeftButton, held, place());
        return "drag";
    }
    /// Changes the number of panes or the active pane, or closes one, also during gestures.
    QString pane()
    {
        Canvas& canvas = test_.window->canvas();
        app::Panes panes = canvas.panes();
        const std::size_t one = std::size_t(below(int(panes.size())));
        switch (below(6)) {
        case 0:
            panes.close(one);
            break;
        case 1:
            panes.show(std::size_t(1 + below(4)));
            break;
        case 2:
            panes.showAll();
            break;
        default:
            panes.activate(one);
        }
        canvas.setPanes(panes);
        return QStringLiteral("%1 panes").arg(panes.size());
    }
    void move(Qt::MouseButtons buttons, Qt::KeyboardModifiers held)
    {
        const QPointF at = place();
        QMouseEvent event(QEvent::MouseMove, at, test_.drawingArea()->mapToGlobal(at), Qt::NoButton,
                          buttons, held);
        QApplication::sendEvent(test_.drawingArea(), &event);
    }
    QString mouse()
    {
        static constexpr Qt::MouseButton buttons[]{Qt::LeftButton, Qt::LeftButton, Qt::LeftButton,
                                                   Qt::MiddleButton, Qt::RightButton};
        QWidget* area = test_.drawingArea();
        const Qt::MouseButton button = oneOf(buttons);
        const auto held = modifiers();
        switch (below(5)) {
        case 0:
            QTest::mousePress(area, button, held, place());
            return "press";
        case 1:
            QTest::mouseRelease(area, button, held, place());
            return "release";
        case 2:
            QTest::mouseDClick(area, button, held, place());
            return "double click";
        case 3:
            QTest::mouseClick(area, button, held, place());
            return "click";
        default:
            move(below(2) ? button : Qt::NoButton, held);
            return "move";
        }
    }

    std::mt19937_64 random_;
    TestWindow test_;
    QList<QAction*> actions_;
    QTimer closer_;
    app::Sheet start_;
};

} // namespace

class RandomTest : public QObject {
    Q_OBJECT

private slots:
    void randomEventsBreakNothing()
    {
        const auto events = fromEnvironment("CLEARCUT_EVENTS", 600);
        Somebody somebody(fromEnvironment("CLEARCUT_SEED", 1));
        QString done;
        for (quint64 i = 0; i < events; ++i) {
            done = QStringLiteral("%1: %2").arg(i).arg(somebody.act());
            if (events > 600) // helps to find a crash
                qInfo("%s", qPrintable(done));
            if (i % 3 == 0)
                QCoreApplication::processEvents();
            const QString fault = somebody.fault();
            QVERIFY2(fault.isEmpty(), qPrintable(done + ": " + fault));
            if (i % 50 == 49)
                QVERIFY2(somebody.historyHolds(), qPrintable(done));
        }
    }
};

QTEST_MAIN(RandomTest)
#include "random_test.moc"
