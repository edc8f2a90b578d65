// SPDX-License-Identifier: GPL-3.0-or-later
// Random keys, clicks, unfinished gestures and commands on all widgets of all windows, with several
// files and whatever is on the clipboard.
// The environment variables CLEARCUT_EVENTS and CLEARCUT_SEED set their number and the first seed.
#include "ui/widgets/sheet.h"

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QDesktopServices>
#include <QFileDialog>
#include <QListView>
#include <QMenu>
#include <QMimeData>
#include <QPointer>
#include <QTimer>
#include <QWheelEvent>

#include <cmath>
#include <random>

#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace random_test {

using namespace ui;

namespace {

quint64 fromEnvironment(const char* name, quint64 usual)
{
    return qEnvironmentVariableIsSet(name) ? qEnvironmentVariable(name).toULongLong() : usual;
}

constexpr const char* drawings[]{
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'/>",
    "<svg xmlns='http://www.w3.org/2000/svg' width='200mm' height='100mm' viewBox='0 0 200 100'>"
    "<g id='a'><g><rect width='40' height='30' fill='#abc'/><circle r='9' cx='60' cy='20'/></g>"
    "<path d='M0 0C50 90 90 0 99 99' stroke='red' fill='none' stroke-dasharray='3 1'/></g></svg>",
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 50 50' xmlns:clearcut='urn:clearcut:1'>"
    "<metadata><clearcut:window xmin='5' ymin='5' xmax='20' ymax='20'/></metadata>"
    "<path d='M0 0L50 50M9 0L0 9' stroke='#000'/></svg>",
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1e-3 1e-3'><path d='M0 0h1e-3' "
    "stroke='#00f' stroke-width='1e-4'/></svg>",
    "<svg this is none",
    "x1,y1,x2,y2\n0,0,100,50\n10,90,90,10\n",
};

/// Opens no browser.
class NoBrowser : public QObject {
    Q_OBJECT

public:
    NoBrowser()
    {
        for (const char* scheme : {"http", "https", "file"})
            QDesktopServices::setUrlHandler(scheme, this, "open");
    }
    Q_INVOKABLE void open(const QUrl&) {}
};

class Somebody {
public:
    explicit Somebody(quint64 seed) : random_(seed)
    {
        test_.open(test_.twoLines());
        test_.show();
        test_.answers->answer = Questions::Answer::DontSave;
        for (QAction* action : test_.window->findChildren<QAction*>())
            if (leavesTheWindow(*action))
                action->disconnect(); // also in menus
            else if (!action->menu() && !action->isSeparator())
                actions_ << action;
        for (std::size_t i = 0; i < std::size(drawings); ++i)
            files_ << test_.file(QString(i + 1 < std::size(drawings) ? "%1.svg" : "%1.csv").arg(i),
                                 drawings[i]);
        const auto samples = app::samples();
        files_ << samples[0].file << samples[1].file;
        // What waits for an answer in an event loop of its own gets one event, then none.
        QObject::connect(&closer_, &QTimer::timeout, [this] {
            QWidget* waiting = inFront();
            if (qobject_cast<QFileDialog*>(waiting)) // also one that a click opens a moment later
                return void(waiting->close());
            if (!waiting)
                return;
            // A menu that a button opens on its own, a while after a press, has its event loop
            // between two events.
            constexpr int aSecond = 50;
            if (!acting_)
                return void(++ticksBetween_ > aSecond && waiting->close());
            if (std::exchange(answered_, true))
                return void(waiting->close());
            // Not from here: what opens another dialog would wait for this timer, which Qt does not
            // let out again before this function has ended.
            QTimer::singleShot(0, waiting, [this, waiting] {
                if (acting_)
                    somewhere(*waiting);
            });
        });
        closer_.start(20);
        QObject::connect(&session(), &app::Session::loaded,
                         [this] { start_ = sheetOf(session().document); });
        start_ = sheetOf(session().document);
    }

    /// Sends one random event, waits for the file that it reads or writes, and describes it.
    QString act()
    {
        acting_ = true;
        answered_ = false;
        ticksBetween_ = 0;
        QWidget* front = inFront();
        const QString what = !front ? send() : below(4) ? somewhere(*front) : closed(*front);
        acting_ = false;
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
        const ui::Sheet* sheetBeside = test_.window->sheet();
        const bool otherPage = session().microscope.isOpen() || test_.window->sheets().isOpen()
                               || (sheetBeside && sheetBeside->preview());
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
    app::Session& session() { return test_.window->session(); }
    int below(int most) { return int(random_() % unsigned(most)); }
    template <class List>
    auto& oneOf(List& list)
    {
        return list[below(int(std::size(list)))];
    }
    QString send()
    {
        switch (below(20)) {
        case 0:
        case 1:
        case 13:
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
        case 9:
        case 14:
        case 15:
            return somewhere(*oneWindow());
        case 16:
            return type();
        case 17:
            return foreignClipboard();
        case 18:
            return open();
        default:
            return mouse();
        }
    }

    /// The menu, popup or dialog that alone takes input now, or null.
    static QWidget* inFront()
    {
        QWidget* popup = QApplication::activePopupWidget();
        return popup ? popup : QApplication::activeModalWidget();
    }
    QWidget* oneWindow()
    {
        QWidgetList shown;
        for (QWidget* window : QApplication::topLevelWidgets())
            if (window->isVisible() && window->windowType() != Qt::ToolTip)
                shown << window;
        return oneOf(shown);
    }
    static QString closed(QWidget& window)
    {
        window.close();
        return "close " + window.objectName();
    }
    /// Events to one of the widgets of a window.
    QString somewhere(QWidget& window)
    {
        if (qobject_cast<QFileDialog*>(&window)) // it can delete files
            return closed(window);
        QWidgetList parts{&window};
        for (QWidget* part : window.findChildren<QWidget*>())
            if (part->isVisible() && part->isEnabled() && part->window() == &window
                && !measuresForMinutes(*part))
                parts << part;
        const QPointer<QWidget> part = oneOf(parts);
        const QPoint at(below(std::max(1, part->width())), below(std::max(1, part->height())));
        const QString name =
            QString("%1 “%2” in %3")
                .arg(part->metaObject()->className(), part->accessibleName(), window.objectName());
        switch (below(6)) {
        case 0: {
            QContextMenuEvent menu(QContextMenuEvent::Mouse, at, part->mapToGlobal(at));
            QApplication::sendEvent(part, &menu);
            return "menu of " + name;
        }
        case 1:
            turn(*part, at);
            return "wheel on " + name;
        case 2:
            QTest::mouseDClick(part, Qt::LeftButton, modifiers(), at);
            return "double click on " + name;
        case 3:
            part->setFocus(Qt::TabFocusReason);
            return type() + " in " + name;
        default:
            QTest::mouseClick(part, Qt::LeftButton, modifiers(), at);
            return "click on " + name;
        }
    }
    static bool measuresForMinutes(const QWidget& widget)
    {
        const auto* button = qobject_cast<const QAbstractButton*>(&widget);
        return button && QString(button->text()).remove(u'&') == u"Run";
    }
    /// Keys to whatever has the keyboard.
    QString type()
    {
        static const QStringList texts{"12", "-3,5", "1in+4mm", "x", "#ff8000", "é", "0", "1e9"};
        static constexpr Qt::Key keys[]{
            Qt::Key_Tab,    Qt::Key_Backtab, Qt::Key_Return, Qt::Key_Escape, Qt::Key_Space,
            Qt::Key_Up,     Qt::Key_Down,    Qt::Key_Home,   Qt::Key_End,    Qt::Key_PageDown,
            Qt::Key_Delete, Qt::Key_F2,      Qt::Key_A,      Qt::Key_C,      Qt::Key_X,
            Qt::Key_V,      Qt::Key_Z,       Qt::Key_Y,      Qt::Key_F10};
        const QPointer<QWidget> focus = QApplication::focusWidget();
        if (!focus)
            return "nothing typed";
        if (below(2)) {
            const QString text = oneOf(texts);
            for (const QChar typed : text) // QTest::keyClicks() knows no letter beyond ASCII
                if (focus)
                    QTest::sendKeyEvent(QTest::Click, focus, Qt::Key(typed.toUpper().unicode()),
                                        typed, Qt::NoModifier);
            return "type " + text;
        }
        const Qt::Key key = oneOf(keys);
        const bool control = key >= Qt::Key_A && key <= Qt::Key_Z;
        QTest::keyClick(focus, key, control ? Qt::ControlModifier : modifiers());
        return "key " + QKeySequence(key).toString();
    }
    QString foreignClipboard()
    {
        auto* data = new QMimeData;
        const QByteArray content = oneOf(drawings);
        if (below(2))
            data->setText(content);
        if (below(2))
            data->setData("image/svg+xml", content);
        QGuiApplication::clipboard()->setMimeData(data);
        return "another program's clipboard";
    }
    QString open()
    {
        const QString file = oneOf(files_);
        test_.window->files().open(file);
        return "open " + file;
    }
    static void turn(QWidget& widget, const QPoint& at)
    {
        QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QSpontaneKeyEvent::setSpontaneous(&event); // made events do not go on to the parent
        qApp->notify(&widget, &event);
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
        test_.answers->open = oneOf(files_);
        test_.answers->save = test_.path(below(2) ? "random.svg" : "random.csv");
        actions_.removeIf([](const auto& action) { return !action; }); // menus are filled anew
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
    NoBrowser noBrowser_;
    QList<QPointer<QAction>> actions_;
    QStringList files_;
    QTimer closer_;
    int ticksBetween_ = 0;
    bool acting_ = false, answered_ = false;
    app::Sheet start_;
};

} // namespace

class RandomTest : public QObject {
    Q_OBJECT

private slots:
    // `deep`: 50,000 in all.
    void randomEventsBreakNothing_data()
    {
        QTest::addColumn<quint64>("seed");
        const bool deep = qEnvironmentVariableIntValue("CLEARCUT_DEEP") == 1;
        const quint64 first = fromEnvironment("CLEARCUT_SEED", 1);
        for (quint64 seed = first; seed < first + (deep ? 5 : 1); ++seed)
            QTest::addRow("seed %llu", static_cast<unsigned long long>(seed)) << seed;
    }
    void randomEventsBreakNothing()
    {
        QFETCH(quint64, seed);
        const bool deep = qEnvironmentVariableIntValue("CLEARCUT_DEEP") == 1;
        const auto events = fromEnvironment("CLEARCUT_EVENTS", deep ? 10'000 : 600);
        Somebody somebody(seed);
        QString done;
        for (quint64 i = 0; i < events; ++i) {
            done = QStringLiteral("%1: %2").arg(i).arg(somebody.act());
            if (qEnvironmentVariableIsSet("CLEARCUT_EVENTS")) // helps to find a crash
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

} // namespace random_test

TEST_CLASS(random_test::RandomTest, Widgets)
#include "tests/ui/random_test.moc"
