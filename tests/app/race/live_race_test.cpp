// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/race/live_race.h"
#include "app/session/session.h"

#include <QSignalSpy>
#include <QTest>

#include <array>

#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet.h"
#include "tests/app/scene/block_scene.h"
#include "tests/app/session/concave_window.h"
#include "tests/test_class.h"

namespace race_live_race_test {

using namespace clipping;

namespace {

// Variants that write down on what they were called.
struct Call {
    int who;
    std::size_t lines;
    Window window;
};
std::vector<Call> calls;

template <int who>
std::size_t clipAll(std::span<const Segment> in, const Window& window, std::span<Clipped> out)
{
    calls.push_back({who, in.size(), window});
    return findAlgorithm("cs")->corrected.clipAll(in, window, out);
}

template <int who>
Algorithm counting()
{
    Algorithm row = *findAlgorithm("cs");
    row.corrected.clipAll = clipAll<who>;
    return row;
}

/// A drawing of one zigzag.
app::Sheet sheetOf(int lines)
{
    app::Sheet sheet;
    sheet.window = {{10, 10}, {90, 90}};
    if (lines == 0)
        return sheet;
    app::Shape zigzag;
    zigzag.style.stroke = app::Colour{};
    zigzag.paths.push_back({{0, 0}, {}, false});
    for (int i = 1; i <= lines; ++i)
        zigzag.paths.back().segments.push_back({{double(i % 101), double(i % 97)}});
    sheet.shapes.push_back(zigzag);
    return sheet;
}

struct Track {
    std::array<Algorithm, 2> rows{counting<0>(), counting<1>()};
    app::Session session;
    app::LiveRace race{session.document, session.scene};

    explicit Track(int lines)
    {
        QObject::connect(&session, &app::Session::previewChanged, &race,
                         [this] { race.setWindow(session.comparedAt()); });
        session.load({app::documentOf(sheetOf(lines)), {}});
        race.setVariants({{&rows[0], Form::Corrected}, {&rows[1], Form::Corrected}});
        calls.clear();
    }
    /// As a gesture does.
    void show(const Window& window)
    {
        session.setPreview({.windows = withWindow(session.now().windows(), window),
                            .drag = app::Preview::Drag::Moving});
    }
    std::size_t roundsOn(const Window& window) const
    {
        return std::size_t(std::ranges::count_if(
                   calls, [&](const Call& call) { return call.window == window; }))
               / rows.size();
    }
};

Window moved(double by) { return {{10 + by, 10}, {90 + by, 90}}; }

} // namespace

class LiveRaceTest : public QObject {
    Q_OBJECT

private slots:
    void racesRunOnlyWhileTheyAreWatched()
    {
        Track t(2000);
        t.show(moved(1));
        QTest::qWait(250);
        QVERIFY(calls.empty());
        QVERIFY(t.race.rows().empty());
        t.race.start();
        QTRY_VERIFY(t.race.rows().size() == 2);
        t.race.stop();
        const std::size_t before = calls.size();
        t.show(moved(2));
        QTest::qWait(250);
        QCOMPARE(calls.size(), before);
        QVERIFY(t.race.rows().empty());
    }
    /// A canvas asks for a frame by an event that is posted when the window moves.
    void theFrameComesFirst()
    {
        struct Canvas : QObject {
            std::size_t callsBefore = 99;
            bool event(QEvent* event) override
            {
                if (event->type() == QEvent::UpdateRequest)
                    callsBefore = calls.size();
                return QObject::event(event);
            }
        } canvas;
        Track t(2000);
        connect(&t.session, &app::Session::previewChanged, &canvas, [&] {
            QCoreApplication::postEvent(&canvas, new QEvent(QEvent::UpdateRequest),
                                        Qt::LowEventPriority);
        });
        t.race.start();
        t.show(moved(1));
        QVERIFY(calls.empty());
        QTRY_VERIFY(t.race.upToDate());
        QCOMPARE(canvas.callsBefore, std::size_t(0));
        calls.clear();
        canvas.callsBefore = 99;
        t.show(moved(2)); // between two rounds
        QVERIFY(calls.empty());
        QTRY_VERIFY(t.roundsOn(moved(2)) >= 1);
        QCOMPARE(canvas.callsBefore, std::size_t(0));
    }
    /// Also in the middle of a gesture, which has not reached the drawing yet.
    void itIsTheWindowThatIsShown()
    {
        Track t(2000);
        t.show(moved(3));
        t.race.start();
        QTRY_VERIFY(!t.race.rows().empty());
        QVERIFY(
            std::ranges::all_of(calls, [](const Call& call) { return call.window == moved(3); }));
        QCOMPARE(t.race.lines(), std::size_t(2000));
    }
    void eachNewFrameIsRacedOn()
    {
        Track t(2000);
        t.race.start();
        for (int i = 1; i <= 10; ++i) {
            t.show(moved(i));
            QTRY_VERIFY(t.roundsOn(moved(i)) >= 1);
        }
    }
    void framesThatComeTooFastShareARound()
    {
        Track t(2000);
        t.race.start();
        for (int i = 1; i <= 10; ++i)
            t.show(moved(i));
        QTRY_VERIFY(t.roundsOn(moved(10)) >= 1);
        for (int i = 1; i < 10; ++i)
            QCOMPARE(t.roundsOn(moved(i)), std::size_t(0));
    }
    void itSettlesAndThenRests()
    {
        Track t(2000);
        QSignalSpy shown(&t.race, &app::LiveRace::advanced);
        bool settledIsShown = false;
        connect(&t.race, &app::LiveRace::advanced, this,
                [&] { settledIsShown = t.race.settled(); });
        t.race.start();
        QTRY_VERIFY_WITH_TIMEOUT(settledIsShown, 60'000);
        QVERIFY(t.race.settled());
        QCOMPARE(t.race.rows().front().milliseconds.size(), app::Race::length);
        const std::size_t before = calls.size();
        QVERIFY(!shown.empty() && std::size_t(shown.size()) <= app::Race::length);
        t.show(moved(0)); // nothing new
        QTest::qWait(300);
        QCOMPARE(calls.size(), before);
        t.show(moved(1));
        QTRY_VERIFY(calls.size() > before);
        QVERIFY(!t.race.settled());
    }
    void tooFewLinesSettleAtOnce_data()
    {
        QTest::addColumn<int>("lines");
        QTest::addRow("some") << 10;
        QTest::addRow("none") << 0;
    }
    void tooFewLinesSettleAtOnce()
    {
        QFETCH(int, lines);
        Track t(lines);
        t.race.start();
        QTRY_VERIFY_WITH_TIMEOUT(t.race.settled(), 1000);
        QCOMPARE(t.race.rows().front().visible,
                 visibleIn(t.session.scene.lines(), t.session.region(), app::exactVariant()));
    }
    /// The lines of a round go away in the middle of it.
    void otherLinesBeginAnew()
    {
        Track t(100'000);
        t.race.start();
        QTRY_VERIFY(!calls.empty());
        t.session.load({app::documentOf(sheetOf(3000)), {}});
        calls.clear();
        QTRY_VERIFY(t.race.upToDate()); // what was found before is shown until then
        QVERIFY(std::ranges::all_of(calls, [](const Call& call) { return call.lines == 3000; }));
        QVERIFY(t.race.rows().front().milliseconds.size() <= calls.size() / 2); // none of before
    }
    void undoneWindowsAreRacedOn()
    {
        Track t(2000);
        t.race.start();
        t.show(moved(5));
        t.session.history.push(windowStep(t.session.document, moved(5)));
        t.session.setPreview({});
        QTRY_VERIFY(t.race.upToDate());
        QVERIFY(t.roundsOn(moved(5)) >= 1);
        calls.clear();
        t.session.history.undo();
        QVERIFY(!t.race.upToDate());
        QTRY_VERIFY(t.race.upToDate());
        QVERIFY(t.roundsOn(moved(0)) >= 1);
    }
    /// At a window that not every algorithm can clip nothing is measured, least of all at the page.
    void withoutARectangleThereAreNoRows()
    {
        Track t(2000);
        t.race.start();
        QTRY_VERIFY(!t.race.rows().empty());
        setWindows(t.session, {concaveWindow("Star", {{10, 10}, {90, 90}})});
        QVERIFY(t.race.rows().empty());
        calls.clear();
        QTest::qWait(300);
        QVERIFY(calls.empty());
        t.session.load({app::documentOf(sheetOf(3000)), {}});
        QTRY_VERIFY(!t.race.rows().empty());
        QVERIFY(t.roundsOn(moved(0)) >= 1);
    }
    /// Of a gesture that is dropped nothing is left.
    void droppedGesturesAreForgotten()
    {
        Track t(2000);
        t.show(moved(5));
        t.session.setPreview({});
        t.race.start();
        QTRY_VERIFY(!t.race.rows().empty());
        QVERIFY(t.roundsOn(moved(0)) >= 1);
        QCOMPARE(t.roundsOn(moved(5)), std::size_t(0));
    }
};

} // namespace race_live_race_test

TEST_CLASS(race_live_race_test::LiveRaceTest, Core)
#include "tests/app/race/live_race_test.moc"
