// SPDX-License-Identifier: GPL-3.0-or-later
// A drag sets the session's preview: everything follows it, and nothing waits for a frame.
#include "ui/docks/compare_panel.h"
#include "ui/docks/cost_map_panel.h"
#include "ui/docks/line_panel.h"
#include "ui/docks/window_panel.h"
#include "ui/widgets/length_field.h"

#include <QSignalSpy>

#include <array>

#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/app/scene/block_scene.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace preview_test {

using namespace ui;

namespace {

constexpr clipping::Window start{{25, 25}, {75, 75}};
constexpr int lines = 2500; // enough to be timed

/// Counts the frames of a widget.
struct Frames : QObject {
    explicit Frames(QWidget& widget) { widget.installEventFilter(this); }
    bool eventFilter(QObject*, QEvent* event) override
    {
        count += event->type() == QEvent::Paint;
        return false;
    }
    int count = 0;
};

/// The main window with a drawing in millimetres, of 100 by 100 user units, all visible.
struct Desk : TestWindow {
    Desk()
    {
        QByteArray path = "M0 0";
        for (int i = 1; i <= lines; ++i)
            path += "L" + QByteArray::number(i % 101) + " " + QByteArray::number(i % 97);
        open(file("lines.svg",
                  "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' "
                  "viewBox='0 0 100 100'><path stroke='#000' fill='none' d='"
                      + path + "'/></svg>"));
        ::setWindow(session().document, start);
        show();
        window->canvas().setTool("window");
        window->canvas().fitPage();
        const auto found = window->findChild<WindowPanel*>()->findChildren<LengthField*>();
        const QStringList names{"X", "Y", "Width", "Height"};
        for (LengthField* field : found)
            if (const auto i = names.indexOf(field->accessibleName()); i >= 0)
                fields[std::size_t(i)] = field;
    }
    app::Session& session() const { return window->session(); }
    const app::LiveRace& race() const { return window->findChild<ComparePanel*>()->race(); }
    const app::LiveCostMap& costMap() const { return window->costMapPanel().live(); }
    QPoint at(const app::Point& p) const
    {
        const app::Point s = window->canvas().view().toScreen(p);
        return {qRound(s.x), qRound(s.y)};
    }
    /// Presses at a point and moves on, in steps; Control: nothing snaps.
    void drag(const app::Point& from, std::initializer_list<app::Point> to) const
    {
        QTest::mousePress(drawingArea(), Qt::LeftButton, Qt::ControlModifier, at(from));
        for (const app::Point& point : to)
            moveTo(point);
    }
    void moveTo(const app::Point& point) const
    {
        const QPointF place = at(point);
        QMouseEvent event(QEvent::MouseMove, place, drawingArea()->mapToGlobal(place), Qt::NoButton,
                          Qt::LeftButton, Qt::ControlModifier);
        QCoreApplication::sendEvent(drawingArea(), &event);
    }
    void release(const app::Point& point) const
    {
        QTest::mouseRelease(drawingArea(), Qt::LeftButton, Qt::ControlModifier, at(point));
    }
    /// The shown texts of X, Y, W and H.
    std::array<double, 4> numbers() const
    {
        const auto seen = [&](int i) { return std::round(fields[i]->value() * 100) / 100; };
        return {seen(0), seen(1), seen(2), seen(3)};
    }
    /// The numbers of a clip window, rounded like the fields.
    std::array<double, 4> numbersOf(const clipping::Window& w) const
    {
        const auto rounded = [&](double v) { return std::round(v * 100) / 100; };
        return {rounded(w.min.x), rounded(w.min.y), rounded(w.max.x - w.min.x),
                rounded(w.max.y - w.min.y)};
    }
    /// The number of lines that `exact` keeps in the current clip window.
    std::size_t visible() const
    {
        return visibleIn(session().scene.lines(), session().region(), app::exactVariant());
    }

    std::array<LengthField*, 4> fields{};
};

} // namespace

class PreviewTest : public QObject {
    Q_OBJECT

private slots:
    void theNumbersFollowTheDrag_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<app::Point>("from");
        QTest::addColumn<app::Point>("to");
        QTest::addColumn<std::vector<bool>>("others"); // of X, Y, W, H, while it is dragged
        QTest::addRow("moved") << "window" << app::Point(50, 50) << app::Point(60, 43)
                               << std::vector{true, true, false, false};
        QTest::addRow("sized") << "window" << app::Point(75, 75) << app::Point(83, 62)
                               << std::vector{false, false, true, true};
        QTest::addRow("sized by Select") << "select" << app::Point(25, 50) << app::Point(12, 50)
                                         << std::vector{true, false, true, false};
        QTest::addRow("drawn") << "window" << app::Point(5, 10) << app::Point(20, 22)
                               << std::vector{true, true, true, true};
    }
    void theNumbersFollowTheDrag()
    {
        QFETCH(QString, tool);
        QFETCH(app::Point, from);
        QFETCH(app::Point, to);
        QFETCH(std::vector<bool>, others);
        Desk t;
        t.window->canvas().setTool(tool.toStdString());
        QCOMPARE(t.numbers(), t.numbersOf(start));
        t.window->setUpdatesEnabled(false);
        Frames frames(*t.drawingArea());
        t.drag(from, {0.5 * (from + to)});
        const auto half = t.numbers();
        t.moveTo(to);
        const auto now = t.numbers();
        for (std::size_t i = 0; i < 4; ++i) {
            QCOMPARE(now[i] != t.numbersOf(start)[i], others[i]);
            QCOMPARE(now[i] != half[i], others[i] && !(tool == "window" && i < 2 && from.x < 10));
        }
        QCOMPARE(now, t.numbersOf(t.session().window()));
        QCOMPARE(sheetOf(t.session().document).window, start);
        t.release(to);
        QCOMPARE(t.numbers(), now);
        QVERIFY(!t.session().preview().windows);
        QCOMPARE(t.numbersOf(*t.session().clipWindow()), now); // the chosen one
        QCOMPARE(t.session().history.count(), 1);
        t.session().history.undo();
        QCOMPARE(t.numbers(), t.numbersOf(start));
        QCOMPARE(frames.count, 0);
    }

    void theRaceAndTheCostMapFollow_data()
    {
        QTest::addColumn<QString>("panel");
        QTest::addRow("race") << "compare-live";
        QTest::addRow("cost map") << "cost-map";
    }
    void theRaceAndTheCostMapFollow()
    {
        QFETCH(QString, panel);
        Desk t;
        t.action(qPrintable(panel))->trigger();
        const bool race = panel == "compare-live";
        const auto shows = [&](const clipping::Window& window) {
            return race ? t.race().upToDate() && t.race().rows().front().visible == t.visible()
                        : t.costMap().upToDate() && t.costMap().map()
                              && t.costMap().map()->plan.window == window;
        };
        QTRY_VERIFY(shows(start));
        const std::size_t visible = t.visible();
        t.window->setUpdatesEnabled(false);
        Frames frames(*t.drawingArea());

        t.drag({50, 50}, {{40, 45}, {15, 20}});
        const clipping::Window dragged = t.session().window();
        QVERIFY(dragged != start);
        QVERIFY(t.visible() != visible);
        QVERIFY(!shows(dragged)); // soon, not at once
        QTRY_VERIFY(shows(dragged));
        QCOMPARE(sheetOf(t.session().document).window, start);

        QTest::keyClick(t.drawingArea(), Qt::Key_Escape);
        QCOMPARE(t.session().window(), start);
        QCOMPARE(t.visible(), visible);
        QCOMPARE(t.numbers(), t.numbersOf(start));
        QTRY_VERIFY(shows(start));
        t.release({15, 20});
        QCOMPARE(t.session().history.count(), 0);

        t.drag({50, 50}, {{60, 55}, {70, 60}});
        t.release({70, 60});
        QCOMPARE(t.session().history.count(), 1);
        QTRY_VERIFY(shows(sheetOf(t.session().document).window));
        QVERIFY(sheetOf(t.session().document).window != start);
        t.session().history.undo();
        QTRY_VERIFY(shows(start));
        QCOMPARE(frames.count, 0);
    }

    void theInspectorFollows()
    {
        Desk t;
        t.session().inspect(60); // from (60, 60) to (61, 61)
        const auto* panel = t.window->findChild<LinePanel*>();
        QTRY_VERIFY(!panel->steps().isEmpty());
        const QString before = panel->steps();
        t.window->setUpdatesEnabled(false);
        t.drag({50, 50}, {{40, 45}, {27, 26}});
        QTRY_VERIFY(panel->steps() != before);
        QTest::keyClick(t.drawingArea(), Qt::Key_Escape);
        QTRY_COMPARE(panel->steps(), before);
    }

    /// The clip window does not jump back between the gesture and its command.
    void theClipWindowNeverJumpsBack()
    {
        Desk t;
        std::vector<clipping::Window> seen;
        connect(&t.session(), &app::Session::previewChanged, this,
                [&] { seen.push_back(t.session().window()); });
        t.drag({50, 50}, {{55, 50}, {60, 50}});
        t.release({60, 50});
        QVERIFY(seen.size() >= 3);
        QVERIFY(std::ranges::find(seen, start) == seen.end());
        QCOMPARE(seen.back(), sheetOf(t.session().document).window);
    }

    void everyEndOfAGestureEndsThePreview_data()
    {
        QTest::addColumn<QString>("how");
        for (const char* how : {"undo", "tool", "open"})
            QTest::addRow("%s", how) << how;
    }
    void everyEndOfAGestureEndsThePreview()
    {
        QFETCH(QString, how);
        Desk t;
        QSignalSpy changed(&t.session(), &app::Session::previewChanged);
        t.drag({50, 50}, {{40, 45}, {15, 20}});
        QVERIFY(t.session().preview().windows);
        QCOMPARE(t.session().preview().drag, app::Preview::Drag::Moving);
        changed.clear();
        if (how == "undo")
            t.window->canvas().undo();
        else if (how == "tool")
            t.window->canvas().setTool("line");
        else
            t.open(t.twoLines());
        QCOMPARE(t.session().preview(), app::Preview{});
        QVERIFY(!changed.isEmpty());
        QCOMPARE(t.numbers(), t.numbersOf(sheetOf(t.session().document).window));
        QCOMPARE(t.session().history.count(), 0);
    }

    void thePreviewHoldsTheDrawnLine()
    {
        Desk t;
        t.window->canvas().setTool("line");
        t.drag({10, 10}, {{30, 20}, {40, 20}});
        const auto& line = t.session().preview().line;
        QVERIFY(line);
        QVERIFY(glm::distance(line->b, app::Point(40, 20)) < 0.2);
        QVERIFY(!t.session().preview().windows);
        t.release({40, 20});
        QCOMPARE(t.session().preview(), app::Preview{});
        QCOMPARE(t.session().history.count(), 1);
    }

    void onlyAChangedPreviewIsSignalled()
    {
        app::Session session;
        QSignalSpy changed(&session, &app::Session::previewChanged);
        session.setPreview({});
        QCOMPARE(changed.size(), 0);
        session.setPreview({.windows = withWindow(session.now().windows(), start),
                            .drag = app::Preview::Drag::Moving});
        session.setPreview({.windows = withWindow(session.now().windows(), start),
                            .drag = app::Preview::Drag::Moving});
        QCOMPARE(changed.size(), 1);
        session.setPreview({.windows = withWindow(session.now().windows(), start),
                            .drag = app::Preview::Drag::Sizing});
        QCOMPARE(changed.size(), 2);
        session.document.load({});
        QCOMPARE(changed.size(), 3);
        QCOMPARE(session.preview(), app::Preview{});
    }
};

} // namespace preview_test

TEST_CLASS(preview_test::PreviewTest, Widgets)
#include "tests/ui/preview_test.moc"
