// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/session.h"

#include <QSignalSpy>
#include <QTest>

#include <random>

#include "tests/app/comparison/random_lines.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/app/scene/scene_lines_of.h"

using namespace clipping;
using app::LiveTruth;

namespace {

LiveTruth::Question published(app::Yardstick yardstick = app::Yardstick::Largest)
{
    return {*app::findVariant("kwc:published"), yardstick};
}

/// What was found is what the lines say if all of them are judged in one go.
bool isTrueAt(const app::Session& session, const Window& window)
{
    const auto all = app::extended({window}, session.truth.asked()->variant,
                                   std::span<const Segment>(allOf(session.scene.lines())));
    const app::Truths& found = session.truth.found();
    return found.window == window && found.lines == all.lines
           && std::ranges::equal(found.list, all.list, {}, &app::LineTruth::source,
                                 &app::LineTruth::source)
           && std::ranges::equal(found.list, all.list, {}, &app::LineTruth::fault,
                                 &app::LineTruth::fault);
}

std::size_t painted(const app::Session& session, const Window& window)
{
    std::size_t pieces = 0;
    for (const auto& ofClass : session.truth.piecesAt(window))
        pieces += ofClass.size();
    return pieces;
}

} // namespace

class LiveTruthTest : public QObject {
    Q_OBJECT

private slots:
    void nobodyLooks()
    {
        app::Session session;
        ::load(session.document, sheetOf(500));
        QSignalSpy changed(&session.truth, &LiveTruth::changed);
        QTest::qWait(30);
        QVERIFY(changed.isEmpty());
        QVERIFY(session.truth.piecesAt(paper).empty());
        QVERIFY(session.truth.upToDate());
    }

    void followsTheDrawingAndTheWindow()
    {
        app::Session session;
        ::load(session.document, sheetOf(2'000));
        session.truth.ask(published());
        QVERIFY(session.truth.piecesAt(paper).empty()); // hidden until it is known
        QTRY_VERIFY(session.truth.upToDate());
        QVERIFY(isTrueAt(session, paper));
        QVERIFY(session.truth.counts().classes.back() > 50);
        QCOMPARE(painted(session, paper), session.truth.found().list.size());
        QVERIFY(session.truth.piecesAt({{0, 0}, {9, 9}}).empty());
        for (const Clipped& piece : session.truth.piecesAt(paper).back())
            QVERIFY(piece.source < 2'000);

        const Window moved{{120, 90}, {320, 240}};
        session.setPreview({.window = moved});
        QCoreApplication::sendPostedEvents(); // before anybody paints
        QVERIFY(isTrueAt(session, moved));
        QCOMPARE(painted(session, moved), session.truth.found().list.size());
        session.setPreview({});
        QCoreApplication::sendPostedEvents();
        ::splice(session.document, 0, 700, {});
        QVERIFY(session.truth.piecesAt(paper).empty()); // its lines are others
        QTRY_VERIFY(session.truth.upToDate());
        QVERIFY(isTrueAt(session, paper));
        session.document.load({});
        QVERIFY(session.truth.found().list.empty());
        QCOMPARE(session.truth.counts().classes, app::TruthCounts().classes);
    }

    void theSlicesOfManyLinesAreOneList()
    {
        app::Session session;
        ::load(session.document, sheetOf(LiveTruth::mostAtOnce + 2'345));
        QSignalSpy begun(&session.truth, &LiveTruth::begun); // only where the lines are many
        session.truth.ask(published());
        QCOMPARE(session.truth.progress(), 0.0);
        QTRY_VERIFY_WITH_TIMEOUT(session.truth.upToDate(), 20'000);
        QCOMPARE(begun.size(), 1);
        QVERIFY(isTrueAt(session, paper));
        session.setPreview({.window = Window{{0, 0}, {50, 50}}});
        QVERIFY(!session.truth.upToDate());
        session.truth.finish();
        QVERIFY(isTrueAt(session, {{0, 0}, {50, 50}}));
    }

    /// The lines are not judged again.
    void anotherYardstickMeasuresTheSame()
    {
        app::Session session;
        ::load(session.document, sheetOf(1'000));
        session.truth.ask(LiveTruth::Question{*app::findVariant("md")});
        session.truth.finish();
        const auto before = session.truth.counts().classes;
        QSignalSpy changed(&session.truth, &LiveTruth::changed);
        session.truth.ask(LiveTruth::Question{*app::findVariant("md"), app::Yardstick::Own});
        QVERIFY(session.truth.upToDate());
        QCOMPARE(changed.size(), 1);
        QVERIFY(session.truth.counts().classes != before);
        QCOMPARE(painted(session, paper), session.truth.found().list.size());
        session.truth.ask(published(app::Yardstick::Own));
        QVERIFY(!session.truth.upToDate());
        QVERIFY(session.truth.found().list.empty());
        session.truth.ask(std::nullopt);
        QVERIFY(session.truth.upToDate());
        QVERIFY(session.truth.piecesAt(paper).empty());
    }
};

QTEST_GUILESS_MAIN(LiveTruthTest)
#include "live_truth_test.moc"
