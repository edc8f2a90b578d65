// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/session.h"

#include <QSignalSpy>
#include <QTest>

#include <random>

#include "tests/app/comparison/random_lines.h"
#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/app/scene/scene_lines_of.h"
#include "tests/test_class.h"

namespace exactness_live_exactness_test {

using namespace clipping;
using app::LiveExactness;

namespace {

LiveExactness::Question published(app::ErrorUnit errorUnit = app::ErrorUnit::Largest)
{
    return {*app::findVariant("kwc:published"), errorUnit};
}

/// What was found is what the lines say if all of them are judged in one go.
bool isUpToDateAt(const app::Session& session, const Window& window)
{
    const auto all = app::extended({window}, session.exactness.asked()->variant,
                                   std::span<const Segment>(allOf(session.scene.lines())));
    const app::ExactnessResults& found = session.exactness.found();
    return found.window == window && found.lines == all.lines
           && std::ranges::equal(found.list, all.list, {}, &app::LineExactness::source,
                                 &app::LineExactness::source)
           && std::ranges::equal(found.list, all.list, {}, &app::LineExactness::fault,
                                 &app::LineExactness::fault);
}

std::size_t painted(const app::Session& session, const Window& window)
{
    std::size_t pieces = 0;
    for (const auto& ofClass : session.exactness.piecesAt(window))
        pieces += ofClass->size();
    return pieces;
}

} // namespace

class LiveExactnessTest : public QObject {
    Q_OBJECT

private slots:
    void nothingIsComputedWithoutAWatcher()
    {
        app::Session session;
        ::load(session.document, sheetOf(500));
        QSignalSpy changed(&session.exactness, &LiveExactness::changed);
        QTest::qWait(30);
        QVERIFY(changed.isEmpty());
        QVERIFY(session.exactness.piecesAt(paper).empty());
        QVERIFY(session.exactness.upToDate());
    }

    void followsTheDrawingAndTheWindow()
    {
        app::Session session;
        ::load(session.document, sheetOf(2'000));
        session.exactness.ask(published());
        QVERIFY(session.exactness.piecesAt(paper).empty()); // hidden until it is known
        QTRY_VERIFY(session.exactness.upToDate());
        QVERIFY(isUpToDateAt(session, paper));
        QVERIFY(session.exactness.counts().classes.back() > 50);
        QCOMPARE(painted(session, paper), session.exactness.found().list.size());
        QVERIFY(session.exactness.piecesAt({{0, 0}, {9, 9}}).empty());
        for (const Clipped& piece : *session.exactness.piecesAt(paper).back())
            QVERIFY(piece.source < 2'000);

        const Window moved{{120, 90}, {320, 240}};
        session.setPreview({.windows = withWindow(session.now().windows(), moved)});
        session.exactness.finish();
        QVERIFY(isUpToDateAt(session, moved));
        QCOMPARE(painted(session, moved), session.exactness.found().list.size());
        session.setPreview({});
        session.exactness.finish();
        ::splice(session.document, 0, 700, {});
        QVERIFY(session.exactness.piecesAt(paper).empty()); // its lines are others
        QTRY_VERIFY(session.exactness.upToDate());
        QVERIFY(isUpToDateAt(session, paper));
        session.document.load({});
        QVERIFY(session.exactness.found().list.empty());
        QCOMPARE(session.exactness.counts().classes, app::ErrorCounts().classes);
    }

    void theSlicesOfManyLinesAreOneList()
    {
        app::Session session;
        ::load(session.document, sheetOf(LiveExactness::mostAtOnce + 2'345));
        QSignalSpy begun(&session.exactness,
                         &LiveExactness::begun); // only where the lines are many
        session.exactness.ask(published());
        QCOMPARE(session.exactness.progress(), 0.0);
        QTRY_VERIFY_WITH_TIMEOUT(session.exactness.upToDate(), 20'000);
        QCOMPARE(begun.size(), 1);
        QVERIFY(isUpToDateAt(session, paper));
        session.setPreview(
            {.windows = withWindow(session.now().windows(), Window{{0, 0}, {50, 50}})});
        QVERIFY(!session.exactness.upToDate());
        session.exactness.finish();
        QVERIFY(isUpToDateAt(session, {{0, 0}, {50, 50}}));
    }

    /// The lines are not judged again.
    void bothErrorUnitsMeasureTheSameResults()
    {
        app::Session session;
        ::load(session.document, sheetOf(1'000));
        session.exactness.ask(LiveExactness::Question{*app::findVariant("md")});
        session.exactness.finish();
        const auto before = session.exactness.counts().classes;
        QSignalSpy changed(&session.exactness, &LiveExactness::changed);
        session.exactness.ask(
            LiveExactness::Question{*app::findVariant("md"), app::ErrorUnit::Own});
        QVERIFY(session.exactness.upToDate());
        QCOMPARE(changed.size(), 1);
        QVERIFY(session.exactness.counts().classes != before);
        QCOMPARE(painted(session, paper), session.exactness.found().list.size());
        session.exactness.ask(published(app::ErrorUnit::Own));
        QVERIFY(!session.exactness.upToDate());
        QVERIFY(session.exactness.found().list.empty());
        session.exactness.ask(std::nullopt);
        QVERIFY(session.exactness.upToDate());
        QVERIFY(session.exactness.piecesAt(paper).empty());
    }
};

} // namespace exactness_live_exactness_test

TEST_CLASS(exactness_live_exactness_test::LiveExactnessTest, Core)
#include "tests/app/exactness/live_exactness_test.moc"
