// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/step_variables.h"
#include "ui/bars/status_bar.h"
#include "ui/docks/difference_panel.h"
#include "ui/docks/line_panel.h"
#include "ui/microscope/code_view.h"
#include "ui/microscope/line_field.h"
#include "ui/microscope/microscope_bar.h"
#include "ui/microscope/microscope_page.h"
#include "ui/microscope/microscope_view.h"
#include "ui/microscope/overview.h"
#include "ui/microscope/timeline.h"
#include "ui/microscope/variable_table.h"

#include <QAccessible>
#include <QApplication>
#include <QDockWidget>
#include <QTextBlock>
#include <QToolButton>

#include <utility>

#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace microscope_microscope_test {

using namespace ui;

namespace {

/// A window with two lines and the microscope opened by its key.
class Stage {
public:
    Stage()
    {
        t.open(t.twoLines());
        app::Session& session = t.window->session();
        session.history.push(windowStep(session.document, {{25, 25}, {75, 75}}));
        t.show();
        QTest::keyClick(t.drawingArea(), Qt::Key_F2);
    }
    app::Microscope& microscope() { return t.window->session().microscope; }
    MicroscopePage& page() { return *t.window->microscopePage(); }
    MicroscopeView& view() { return page().view(); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }
    /// Drags from one point of the drawing to another.
    void drag(const app::Point& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {})
    {
        const QPoint start = view().frame().at(from).toPoint();
        QTest::mousePress(&view(), Qt::LeftButton, modifiers, start);
        moveTo((start + to) / 2, modifiers);
        moveTo(to, modifiers);
        QTest::mouseRelease(&view(), Qt::LeftButton, modifiers, to);
    }
    QPoint screen(const app::Point& p) { return view().frame().at(p).toPoint(); }

    TestWindow t;
    void moveTo(const QPoint& place, Qt::KeyboardModifiers modifiers)
    {
        QMouseEvent event(QEvent::MouseMove, place, view().mapToGlobal(place), Qt::NoButton,
                          Qt::LeftButton, modifiers);
        QApplication::sendEvent(&view(), &event);
    }
};

QByteArray docksOf(const MainWindow& window)
{
    QByteArray text;
    auto docks = window.findChildren<QDockWidget*>();
    std::ranges::sort(docks, {}, &QObject::objectName); // raising one makes it the last child
    for (const QDockWidget* dock : docks)
        text += dock->objectName().toUtf8() + (dock->isVisible() ? " seen " : " ")
                + (dock->isHidden() ? "hidden " : "shown ")
                + (dock->isFloating() ? "floating " : "docked ") + QByteArray::number(dock->x() < 0)
                + ' ' + QByteArray::number(dock->width()) + ' ' + QByteArray::number(dock->height())
                + '\n';
    return text;
}

/// Qt stores an arbitrary place for panels behind another.
QByteArray docksInFront(const MainWindow& window)
{
    QByteArrayList lines = docksOf(window).split('\n');
    lines.removeIf([](const QByteArray& line) { return !line.contains(" seen shown docked 0"); });
    return lines.join('\n');
}

/// Drawn with a tool.
app::UndoCommand* addLine(app::Session& session, const clipping::Segment& line)
{
    app::Shape shape;
    shape.paths.push_back({line.a, {{line.b}}, false});
    shape.style.stroke = app::Colour{};
    return addShapes(session.document, {shape}, QStringLiteral("Draw line"));
}

bool noPanelCoversAnother(const MainWindow& window)
{
    QList<QRect> places;
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
        if (dock->isVisible() && dock->x() >= 0)
            places << dock->geometry();
    for (const QRect& one : places)
        for (const QRect& other : places)
            if (one != other && one.intersects(other))
                return false;
    return true;
}

} // namespace

class MicroscopeTest : public QObject {
    Q_OBJECT

private slots:
    void f2OpensAndCloses()
    {
        Stage s;
        QVERIFY(s.microscope().isOpen());
        QVERIFY(s.page().isVisible());
        QVERIFY(!s.t.window->canvas().isVisible());
        for (const QDockWidget* dock : s.t.window->findChildren<QDockWidget*>())
            QVERIFY2(!dock->isVisible(), qPrintable(dock->objectName()));
        s.key(Qt::Key_F2);
        QVERIFY(!s.microscope().isOpen());
        QVERIFY(s.t.window->canvas().isVisible());
    }
    void nothingIsCreatedBeforeItIsOpened()
    {
        TestWindow t;
        QVERIFY(!t.window->microscopePage());
    }
    void aClickShowsABranchThatWasNotTaken()
    {
        Stage s;
        CodeView& code = s.page().code();
        const auto folded = [&code] {
            return std::ranges::count_if(code.rows(), &app::CodeRow::isFolded);
        };
        const auto before = folded();
        QVERIFY(before > 0);
        QCOMPARE(code.document()->blockCount(), int(code.rows().size()));
        const auto first = std::ranges::find_if(code.rows(), &app::CodeRow::isFolded);
        const int row = int(first - code.rows().begin()), line = first->first;
        QTextCursor cursor(code.document()->findBlockByNumber(row));
        const QPoint place = code.cursorRect(cursor).center();
        QTest::mouseClick(code.viewport(), Qt::LeftButton, {}, place);
        QCOMPARE(folded(), before - 1);
        QCOMPARE(code.rows()[std::size_t(row)].first, line);
        QTest::mouseClick(code.viewport(), Qt::LeftButton, {}, place);
        QCOMPARE(folded(), before);
        code.setFocus();
        s.key(Qt::Key_Return);
        QCOMPARE(folded(), 0);
        QCOMPARE(code.toPlainText(), s.microscope().narration().code.join(u'\n'));
        s.key(Qt::Key_Return);
        QCOMPARE(folded(), before);
    }
    void keysReachTheSameStepsInBothDirections()
    {
        Stage s;
        const auto last = s.microscope().narration().steps.size() - 1;
        QVERIFY(last > 1);
        QStringList forth, back;
        const auto now = [&] {
            return s.page().steps().sentence() + QString::number(s.page().code().currentLine())
                   + s.page().steps().count();
        };
        forth << now();
        while (!s.microscope().atEnd())
            s.key(Qt::Key_Right), forth << now();
        s.key(Qt::Key_Right); // no further
        QCOMPARE(s.microscope().step(), last);
        back << now();
        while (s.microscope().step() > 0)
            s.key(Qt::Key_Left), back.prepend(now());
        QCOMPARE(forth, back);
        QCOMPARE(QSet<QString>(forth.begin(), forth.end()).size(), forth.size());
        s.key(Qt::Key_End);
        QCOMPARE(s.microscope().step(), last);
        s.key(Qt::Key_Home);
        QCOMPARE(s.microscope().step(), std::size_t(0));
    }
    void keysStepWithAnyFocus()
    {
        Stage s;
        int widgets = 0;
        for (QWidget* widget : s.page().findChildren<QWidget*>()) {
            if (!widget->isVisible() || !widget->isEnabled()
                || !(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy()
                || qobject_cast<LineField*>(widget))
                continue;
            ++widgets;
            s.microscope().goTo(0);
            widget->setFocus(Qt::OtherFocusReason);
            s.key(Qt::Key_Right);
            QVERIFY2(s.microscope().step() == 1, widget->metaObject()->className());
            s.key(Qt::Key_Home);
            QVERIFY2(s.microscope().step() == 0, widget->metaObject()->className());
        }
        QVERIFY(widgets > 1);
    }
    void typingDoesNotStep()
    {
        Stage s;
        s.page().bar().lineField().setFocus();
        s.key(Qt::Key_Right);
        s.key(Qt::Key_End);
        s.key(Qt::Key_Space);
        QCOMPARE(s.microscope().step(), std::size_t(0));
        QVERIFY(!s.page().steps().playback().playing());
    }
    void itPlaysToTheEndAndStops()
    {
        Stage s;
        s.page().steps().playback().setSpeed(300);
        s.key(Qt::Key_Space);
        QVERIFY(s.page().steps().playback().playing());
        QTRY_VERIFY(!s.page().steps().playback().playing());
        QVERIFY(s.microscope().atEnd());
        s.key(Qt::Key_Space); // once more, from the first
        QVERIFY(s.page().steps().playback().playing());
        s.key(Qt::Key_F2);
        QVERIFY(!s.page().steps().playback().playing());
    }
    void aDraggedEndChangesOnlyTheTrace()
    {
        Stage s;
        const app::Document before = s.t.window->session().now();
        const int history = s.t.window->session().history.count();
        const auto line = s.microscope().tracedLine().line;
        const auto visible = s.microscope().narration().visible;
        s.drag(line.b, s.screen({50, 50}) + QPoint(3, -31));
        QVERIFY(s.microscope().tracedLine().line != line);
        QCOMPARE(s.microscope().tracedLine().line.a, line.a);
        QVERIFY(s.microscope().narration().visible != visible);
        QVERIFY(s.t.window->session().now() == before);
        QCOMPARE(s.t.window->session().history.count(), history);
        auto* back = s.page().findChild<QToolButton*>("back-to-line");
        QVERIFY(back->isVisible());
        QTest::mouseClick(back, Qt::LeftButton);
        QCOMPARE(s.microscope().tracedLine().line, line);
        QVERIFY(!back->isVisible());
    }
    void anEndSnapsToTheWindow()
    {
        Stage s;
        const QPoint corner = s.screen({75, 75}) + QPoint(3, -3);
        s.drag(s.microscope().tracedLine().line.b, corner);
        QCOMPARE(s.microscope().tracedLine().line.b, app::Point(75, 75));
        s.drag({75, 75}, s.screen({60, 60}));
        s.drag(s.microscope().tracedLine().line.b, corner, Qt::ControlModifier);
        QVERIFY(s.microscope().tracedLine().line.b != app::Point(75, 75));
    }
    void escapeUndoesADrag()
    {
        Stage s;
        const auto line = s.microscope().tracedLine().line;
        QTest::mousePress(&s.view(), Qt::LeftButton, {}, s.screen(line.b));
        QMouseEvent move(QEvent::MouseMove, s.screen({50, 40}), QPointF(), Qt::NoButton,
                         Qt::LeftButton, {});
        QApplication::sendEvent(&s.view(), &move);
        QVERIFY(s.microscope().tracedLine().line != line);
        s.key(Qt::Key_Escape);
        QCOMPARE(s.microscope().tracedLine().line, line);
        QVERIFY(s.microscope().isOpen());
    }
    void arrowKeysMoveTheSelectedEnd()
    {
        Stage s;
        const auto line = s.microscope().tracedLine().line;
        s.view().setFocus();
        s.key(Qt::Key_Tab);
        QCOMPARE(s.view().chosenEnd(), LineEnd::One);
        s.key(Qt::Key_Up);
        QCOMPARE(s.microscope().tracedLine().line.b, line.b);
        QVERIFY(s.microscope().tracedLine().line.a.y < line.a.y); // up, where y points down
        s.key(Qt::Key_Tab);
        QCOMPARE(s.view().chosenEnd(), LineEnd::Two);
        s.key(Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(s.microscope().tracedLine().line.b.x > line.b.x);
        QCOMPARE(s.microscope().step(), std::size_t(0));
        s.key(Qt::Key_Escape);
        QVERIFY(s.microscope().isOpen());
        s.key(Qt::Key_Right);
        QCOMPARE(s.microscope().step(), std::size_t(1));
        s.key(Qt::Key_Escape);
        QVERIFY(!s.microscope().isOpen());
    }
    void aTypedLineIsTraced()
    {
        Stage s;
        LineField& field = s.page().bar().lineField();
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, "0, 10 -> 100.5, 90");
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(s.microscope().tracedLine().line, (clipping::Segment{{0, 10}, {100.5, 90}}));
        field.selectAll();
        QTest::keyClicks(&field, "0, 10 -> what");
        QTest::keyClick(&field, Qt::Key_Return);
        QVERIFY2(s.t.window->message().contains("is not a line"),
                 qPrintable(s.t.window->message()));
        QCOMPARE(s.microscope().tracedLine().line.b, app::Point(100.5, 90));
        QTest::keyClick(&field, Qt::Key_Escape);
        QVERIFY(s.microscope().isOpen());
        QCOMPARE(field.text(), QString::fromUtf8("0, 10 → 100.5, 90"));
        field.selectAll();
        QTest::keyClicks(&field, "nan, 10 -> 5, 90");
        QTest::keyClick(&field, Qt::Key_Return);
        QVERIFY(s.microscope().narration().steps.empty());
        QCOMPARE(s.page().steps().sentence(), s.microscope().narration().refusal);
        QVERIFY(!s.page().steps().sentence().isEmpty());
        s.page().grab(); // and can be painted
    }
    void theWheelZoomsAroundThePointer()
    {
        Stage s;
        const QPointF place(200, 150);
        const app::Point before = s.view().frame().pointAt(place);
        const double width = s.view().frame().seen.max.x - s.view().frame().seen.min.x;
        QWheelEvent wheel(place, s.view().mapToGlobal(place), {}, {0, 120}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&s.view(), &wheel);
        const auto& seen = s.view().frame().seen;
        QVERIFY(std::abs(width / (seen.max.x - seen.min.x) - 1.25) < 1e-9);
        const app::Point after = s.view().frame().pointAt(place);
        QVERIFY(std::hypot(before.x - after.x, before.y - after.y) < 1e-9);
        s.key(Qt::Key_Right);
        QCOMPARE(s.view().frame().seen, seen); // steady
        s.view().fit();
        QVERIFY(std::abs((s.view().frame().seen.max.x - s.view().frame().seen.min.x) / width - 1)
                < 1e-9);
    }
    void variablesOfTheStepOrAll()
    {
        Stage s;
        s.microscope().goTo(6);
        const QAbstractItemModel* rows = s.page().variables().model();
        auto* link = s.page().findChild<QToolButton*>(QStringLiteral("all-variables-link"));
        const auto countNow = [&s] {
            return app::allVariables(s.microscope().tracedLine(), s.microscope().narration(),
                                     s.microscope().step())
                .size();
        };
        const auto all = countNow();
        QCOMPARE(link->text(), QStringLiteral("All %1").arg(all));
        QVERIFY(all > 6 && rows->rowCount() > 0 && rows->rowCount() <= 6);
        link->click();
        QCOMPARE(std::size_t(rows->rowCount()), all);
        QCOMPARE(link->text(), "Only this step");
        s.microscope().goTo(7); // stays
        QCOMPARE(std::size_t(rows->rowCount()), countNow());
        link->click();
        QVERIFY(rows->rowCount() <= 6);
    }
    void aNewLineAndOpeningFitTheView()
    {
        Stage s;
        const auto zoom = [&] {
            s.view().zoomBy(3);
            QVERIFY(!s.view().fitted());
        };
        zoom();
        s.key(Qt::Key_Right); // a step does not
        QVERIFY(!s.view().fitted());
        s.key(Qt::Key_F8); // the other line
        QVERIFY(s.view().fitted());
        zoom();
        s.microscope().close();
        s.microscope().open(s.microscope().tracedLine());
        QVERIFY(s.view().fitted());
        zoom();
        app::TracedLine traced = s.microscope().tracedLine();
        traced.variant.algorithm = clipping::findAlgorithm("lb");
        s.microscope().setTracedLine(traced); // the same line
        QVERIFY(!s.view().fitted());
        std::swap(traced.line.a, traced.line.b);
        s.microscope().setTracedLine(traced);
        QVERIFY(!s.view().fitted());
        QTest::mouseDClick(&s.view(), Qt::LeftButton, {}, {5, s.view().height() - 5});
        QVERIFY(s.view().fitted());
    }
    void aDragBesideTheLineTakesThePlaneWithIt()
    {
        Stage s;
        const auto line = s.microscope().tracedLine().line;
        const app::Point held = s.view().frame().pointAt({60, 40});
        s.drag(held, {90, 57});
        const QPointF now = s.view().frame().at(held);
        QVERIFY(std::hypot(now.x() - 90, now.y() - 57) < 1.5);
        const QPointF corner = s.view().frame().at(s.view().frame().seen.min);
        s.drag(held, {100, 60});
        QCOMPARE(s.view().frame().at(s.view().frame().seen.min), corner); // no zoom
        QCOMPARE(s.microscope().tracedLine().line, line);
    }
    /// A page that was small for a moment looks as one that never was.
    void theOverviewGoesBackToItsFirstCorner()
    {
        Stage s;
        const auto* overview = s.page().findChild<Overview*>();
        const QPoint place = overview->pos();
        const app::TracedLine traced = s.microscope().tracedLine();
        app::TracedLine far = traced;
        far.line.a = {-50, -50};
        s.microscope().setTracedLine(far);
        QVERIFY(overview->pos() != place);
        s.microscope().setTracedLine(traced);
        QCOMPARE(overview->pos(), place);

        const QPoint end = s.screen(traced.line.a);
        QTest::mousePress(&s.view(), Qt::LeftButton, {}, end);
        s.moveTo(place + QPoint(10, 10), Qt::ControlModifier);
        const QPoint beside = overview->pos();
        QVERIFY(beside != place);
        s.moveTo(end, Qt::ControlModifier);
        QCOMPARE(overview->pos(), beside); // still in a gesture
        QTest::mouseRelease(&s.view(), Qt::LeftButton, {}, end);
        QCOMPARE(overview->pos(), place);
    }
    void theCursorTellsWhatADragDoes()
    {
        Stage s;
        const QPoint end = s.screen(s.microscope().tracedLine().line.a);
        s.moveTo(end, {});
        QCOMPARE(s.view().cursor().shape(), Qt::SizeAllCursor);
        s.moveTo({60, 40}, {});
        QCOMPARE(s.view().cursor().shape(), Qt::ArrowCursor);
        QTest::mousePress(&s.view(), Qt::LeftButton, {}, {60, 40});
        QCOMPARE(s.view().cursor().shape(), Qt::ClosedHandCursor);
        QTest::mouseRelease(&s.view(), Qt::LeftButton, {}, {60, 40});
        QCOMPARE(s.view().cursor().shape(), Qt::ArrowCursor);
    }
    void aClickOnTheTimelineChoosesTheStep()
    {
        Stage s;
        auto* timeline = s.page().findChild<Timeline*>();
        for (const std::size_t step :
             {s.microscope().narration().steps.size() - 1, std::size_t(1)}) {
            QTest::mouseClick(timeline, Qt::LeftButton, {}, timeline->placeOf(step).toPoint());
            QCOMPARE(s.microscope().step(), step);
        }
    }
    void everyAlgorithmAndFormStepsToItsEnd()
    {
        Stage s;
        for (const clipping::Algorithm& algorithm : clipping::algorithms())
            for (const auto form : {clipping::Form::Corrected, clipping::Form::Published}) {
                if (!clipping::functionsOf(algorithm, form))
                    continue;
                s.t.window->drawnLine().choose({&algorithm, form});
                QCOMPARE(s.microscope().tracedLine().variant.algorithm, &algorithm);
                s.key(Qt::Key_Home);
                while (!s.microscope().atEnd()) {
                    QVERIFY(!s.page().steps().sentence().isEmpty());
                    s.key(Qt::Key_Right);
                }
                s.page().grab();
                QCOMPARE(
                    s.t.window->status().visibility(),
                    QStringLiteral("step %1 of %1").arg(s.microscope().narration().steps.size()));
            }
    }
    void thePanelsAreRestored()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        t.window->session().inspect(0);
        t.window->findChild<LinePanel*>()->showNow(); // on a busy machine the timer may be late
        QByteArray before; // when the Line panel has its room: twice the same
        QTRY_VERIFY(std::exchange(before, docksOf(*t.window)) == before);
        QTest::keyClick(t.drawingArea(), Qt::Key_F2);
        QVERIFY(docksOf(*t.window) != before);
        t.window->resize(1200, 790); // nothing is rearranged while it is open
        t.window->resize(1280, 800);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QTRY_COMPARE(docksOf(*t.window), before);
        QVERIFY(t.window->canvas().isAncestorOf(QApplication::focusWidget())
                || QApplication::focusWidget() == &t.window->canvas());
    }
    /// Without a selected line the microscope chooses one; that choice ends when it closes.
    void thePanelsAreRestoredWithoutASelectedLine()
    {
        TestWindow t;
        t.show();
        t.window->session().history.push(addLine(t.window->session(), {{20, 20}, {180, 160}}));
        QTest::qWait(300); // until the verdict of the Algorithm panel is there
        const QByteArray before = docksInFront(*t.window);
        QTest::keyClick(t.drawingArea(), Qt::Key_F2);
        QVERIFY(t.window->session().inspected());
        QTest::qWait(60); // the Line panel is filled meanwhile
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(!t.window->session().inspected());
        QTRY_COMPARE(docksInFront(*t.window), before);
        QTest::keyClick(t.drawingArea(), Qt::Key_F2);
        QTest::qWait(60);
        t.window->drawnLine().look(0); // now the user chose it, so it stays
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(t.window->session().inspected());
        QTRY_VERIFY(noPanelCoversAnother(*t.window));
    }
    void aUserLayoutIsKeptAndSaved()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        auto* layers = t.window->findChild<QDockWidget*>("layers");
        auto* line = t.window->findChild<QDockWidget*>("line");
        t.window->addDockWidget(Qt::LeftDockWidgetArea, layers);
        line->hide();
        QCoreApplication::processEvents();
        const QByteArray before = docksOf(*t.window);
        QTest::keyClick(t.drawingArea(), Qt::Key_F2);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F2);
        QTRY_COMPARE(docksOf(*t.window), before);
        QCOMPARE(t.window->dockWidgetArea(layers), Qt::LeftDockWidgetArea);
        QTest::keyClick(t.drawingArea(), Qt::Key_F2);
        t.window->session().history.setClean();
        t.window->close(); // with the microscope open
        const auto again = windowWithMenus();
        again->resize(1280, 800);
        again->show();
        QCOMPARE(again->dockWidgetArea(again->findChild<QDockWidget*>("layers")),
                 Qt::LeftDockWidgetArea);
        QVERIFY(!again->findChild<QDockWidget*>("layers")->isHidden());
        QVERIFY(again->findChild<QDockWidget*>("line")->isHidden());
    }
    void theLinePanelAndF2OpenTheMicroscopeButADoubleClickShowsNodes()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        t.window->session().inspect(1);
        auto* panel = t.window->findChild<LinePanel*>();
        auto* button = panel->findChild<QPushButton*>();
        QTRY_VERIFY(!button->isHidden());
        button->click();
        QVERIFY(t.window->session().microscope.isOpen());
        QCOMPARE(t.window->drawnLine().line(), std::size_t(1));
        t.window->session().microscope.close();
        t.window->canvas().setTool("select");
        t.window->canvas().fitPage();
        const app::Point at = t.window->canvas().view().toScreen({30, 50});
        QTest::mouseDClick(t.drawingArea(), Qt::LeftButton, {}, QPoint(int(at.x), int(at.y)));
        QVERIFY(!t.window->session().microscope.isOpen());
        QCOMPARE(t.window->canvas().tool(), std::string_view("nodes"));
        t.window->canvas().setTool("select");
        QTest::mouseClick(t.drawingArea(), Qt::LeftButton, {}, QPoint(int(at.x), int(at.y)));
        QTest::keyClick(t.drawingArea(), Qt::Key_F2);
        QVERIFY(t.window->session().microscope.isOpen());
        QCOMPARE(t.window->drawnLine().line(), std::size_t(0));
    }
    void f8ShowsTheNextLine()
    {
        Stage s;
        const auto first = s.t.window->drawnLine().line();
        s.key(Qt::Key_F8);
        QVERIFY(s.microscope().isOpen());
        QVERIFY(s.t.window->drawnLine().line() != first);
        s.key(Qt::Key_F8, Qt::ShiftModifier);
        QCOMPARE(s.t.window->drawnLine().line(), first);
    }
    void itsListNamesTheAlgorithm()
    {
        Stage s;
        s.key(Qt::Key_F8);
        const auto name = s.microscope().tracedLine().variant.algorithm->name;
        const auto lists = s.t.window->findChildren<QComboBox*>();
        QVERIFY(std::ranges::any_of(lists, [&](const QComboBox* list) {
            return list->isVisible() && list->accessibleName() == "Algorithm"
                   && list->currentText().endsWith(QString::fromUtf8(name));
        }));
    }
    void itsButtonsShowTheNextLine()
    {
        Stage s;
        const auto click = [&](const QString& tip) {
            for (auto* button : s.t.window->findChildren<QToolButton*>())
                if (button->isVisible() && button->toolTip().startsWith(tip))
                    return QTest::mouseClick(button, Qt::LeftButton);
            QFAIL(qPrintable(tip));
        };
        s.key(Qt::Key_F8);
        const auto first = s.t.window->drawnLine().line();
        click("Next line of the drawing");
        const auto next = s.t.window->drawnLine().line();
        QVERIFY(next != first);
        click("Previous line of the drawing");
        QCOMPARE(s.t.window->drawnLine().line(), first);
    }
    void everyControlHasAName()
    {
        Stage s;
        int controls = 0;
        for (QWidget* widget : s.page().findChildren<QWidget*>()) {
            if (!(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy()
                || !widget->isVisible())
                continue;
            ++controls;
            QAccessibleInterface* said = QAccessible::queryAccessibleInterface(widget);
            QVERIFY2(said && !said->text(QAccessible::Name).isEmpty(),
                     widget->metaObject()->className());
        }
        QVERIFY(controls > 1);
    }
    void nothingIsCutOffInASmallWindow()
    {
        Stage s;
        for (const double factor : {1.0, 1.5}) {
            QFont font = qApp->font();
            font.setPointSizeF(font.pointSizeF() * factor);
            s.t.window->setFont(font);
            s.t.window->resize(1024, 640);
            QCoreApplication::processEvents();
            QVERIFY2(factor > 1 || s.t.window->width() == 1024,
                     qPrintable(QString::number(s.t.window->width())));
            for (const QWidget* widget : s.page().findChildren<QWidget*>())
                if (widget->isVisible() && qobject_cast<const QAbstractButton*>(widget)) {
                    const QRect place(widget->mapTo(&s.page(), QPoint()), widget->size());
                    QVERIFY2(s.page().rect().contains(place), qPrintable(widget->accessibleName()));
                    QVERIFY2(!widget->visibleRegion().isEmpty(),
                             qPrintable(widget->accessibleName()));
                }
        }
    }
};

} // namespace microscope_microscope_test

TEST_CLASS(microscope_microscope_test::MicroscopeTest, Widgets)
#include "tests/ui/microscope/microscope_test.moc"
