// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/session.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include <random>
#include <vector>

#include "tests/app/comparison/random_lines.h"
#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/app/scene/scene_lines_of.h"
#include "tests/test_class.h"

namespace comparison_live_differences_test {

using namespace clipping;
using app::Comparison;
using app::LiveDifferences;

namespace {

Comparison kwcAgainstExact()
{
    return {{findAlgorithm("kwc"), Form::Published}, app::exactVariant()};
}

std::vector<app::Difference> atOnce(const app::Session& session, const Comparison& comparison,
                                    const Window& window)
{
    return app::differences(allOf(session.scene.lines()), window, comparison.a, comparison.b,
                            comparison.allowed());
}

app::Differences inSlices(const app::SceneLines& lines, const Comparison& comparison,
                          std::size_t count)
{
    app::Differences all{paper};
    while (all.lines < lines.size())
        all = extended(std::move(all), comparison, lines, count);
    return all;
}

// In the order in which their marks are painted.
bool haveTheSamePieces(const app::Differences& one, const app::Differences& other)
{
    return std::ranges::equal(one.pieces, other.pieces, [](const Clipped& a, const Clipped& b) {
        return a.segment == b.segment && a.source == b.source && a.cut == b.cut;
    });
}

} // namespace

class LiveDifferencesTest : public QObject {
    Q_OBJECT

private slots:
    void nothingIsComputedWithoutAWatcher()
    {
        app::Session session;
        ::load(session.document, sheetOf(1000));
        QSignalSpy changed(&session.differences, &LiveDifferences::changed);
        QTest::qWait(50);
        QVERIFY(changed.isEmpty());
        QVERIFY(session.differences.found().list.empty());
        QVERIFY(session.differences.piecesAt(paper).empty());
        QVERIFY(session.differences.upToDate());
    }

    void followsTheDrawing()
    {
        app::Session session;
        ::load(session.document, sheetOf(5000));
        const auto found = [&]() -> const auto& { return session.differences.found(); };
        std::vector<Window> results; // a late one is told twice: first that the last one is old
        connect(&session.differences, &LiveDifferences::changed, &session, [&] {
            if (session.differences.upToDate())
                results.push_back(found().window);
        });
        session.differences.ask(kwcAgainstExact());
        QTRY_VERIFY(session.differences.upToDate());
        QVERIFY(found().list.size() > 100);
        QCOMPARE(found().list, atOnce(session, kwcAgainstExact(), paper));
        QCOMPARE(found().lines, std::size_t(5000));

        // Several changes in one event are looked at once.
        const Window other{{50, 50}, {200, 350}};
        session.history.push(windowStep(session.document, {{0, 0}, {10, 10}}));
        session.history.push(windowStep(session.document, other));
        QVERIFY(!session.differences.upToDate());
        QTRY_VERIFY(session.differences.upToDate());
        QCOMPARE(results, (std::vector<Window>{paper, other}));
        QCOMPARE(found().list, atOnce(session, kwcAgainstExact(), other));
        QSignalSpy changed(&session.differences, &LiveDifferences::changed);
        ::load(session.document, sheetOf(100));
        QCOMPARE(changed.size(), 1); // these lines are gone
        QVERIFY(found().list.empty());
        QTRY_COMPARE(found().lines, std::size_t(100));

        session.differences.ask(std::nullopt);
        QVERIFY(found().list.empty());
    }

    void theSlicesOfManyLinesAreOneList()
    {
        app::Session session;
        ::load(session.document, sheetOf(LiveDifferences::mostAtOnce + 12'345));
        QSignalSpy begun(&session.differences, &LiveDifferences::begun);
        session.differences.ask(kwcAgainstExact());
        QVERIFY(session.differences.piecesAt(paper).empty()); // hidden until it is known
        QTRY_VERIFY(session.differences.upToDate());
        QCOMPARE(begun.size(), 1);
        const auto found = [&]() -> const auto& { return session.differences.found(); };
        QCOMPARE(found().list, atOnce(session, kwcAgainstExact(), paper));
        // Of lines whose ends are apart both pieces are coloured.
        QCOMPARE(found().pieces.size(), found().list.size() + app::counted(found().list).endsApart);
        QCOMPARE(session.differences.piecesAt(paper).size(), found().pieces.size());
        for (const Clipped& piece : found().pieces)
            QVERIFY(std::ranges::binary_search(found().list, piece.source, {},
                                               &app::Difference::source));
        QVERIFY(session.differences.piecesAt({{0, 0}, {9, 9}}).empty());

        // A change in the middle begins anew; finish() does not wait.
        ::setWindow(session.document, {{0, 0}, {50, 50}});
        QVERIFY(!session.differences.upToDate());
        session.differences.finish();
        QCOMPARE(found().list, atOnce(session, kwcAgainstExact(), {{0, 0}, {50, 50}}));
    }

    // Marks that follow each other are joined: in another order they would look different.
    void blocksAndSlicesDoNotChangeTheOrderOfPieces()
    {
        app::Session session;
        ::load(session.document, sheetOf(5000));
        const auto lines = allOf(session.scene.lines());
        Comparison comparison = kwcAgainstExact();
        comparison.ulps = 0; // some lines are lost, others end elsewhere: those have two pieces
        const app::Differences all = extended({paper}, comparison, lines);
        const app::DifferenceCounts counts = app::counted(all.list);
        QVERIFY(counts.onlyB > 100 && counts.endsApart > 100);
        for (const std::size_t inBlock : {5000, 1200, 7})
            for (const std::size_t inSlice : {5000, 700, 1})
                QVERIFY(haveTheSamePieces(
                    inSlices(sceneLinesOf(lines, inBlock), comparison, inSlice), all));
    }

    void theColoursFollowAGesture()
    {
        app::Session session;
        ::load(session.document, sheetOf(5000));
        session.differences.ask(kwcAgainstExact());
        session.differences.finish();
        const Window moved{{120, 90}, {320, 240}};
        const auto before = session.differences.found().list;
        const auto expected = atOnce(session, kwcAgainstExact(), moved);
        QVERIFY(expected != before);
        QVERIFY(session.differences.piecesAt(moved).empty()); // to ask computes nothing
        session.setPreview({.windows = withWindow(session.now().windows(), moved)});
        QVERIFY(session.differences.piecesAt(moved).empty());
        session.differences.finish();
        const auto pieces = session.differences.piecesAt(moved);
        QCOMPARE(session.differences.found().list, expected);
        QCOMPARE(pieces.size(), expected.size() + app::counted(expected).endsApart);
        for (const app::Difference& difference : expected)
            if (difference.kind == app::Difference::Kind::OnlyB)
                QVERIFY(std::ranges::any_of(pieces, [&](const Clipped& piece) {
                    return piece.source == difference.source
                           && piece.segment
                                  == app::clipped(app::exactVariant(),
                                                  session.scene.lines()[difference.source], moved);
                }));
        session.setPreview({});
        session.differences.finish();
        QCOMPARE(session.differences.found().window, paper);
        QCOMPARE(session.differences.found().list, before);
    }

    /// When the gesture rests, and once: the command that it becomes finds nothing new.
    void manyLinesAreComparedWhenAGestureRests()
    {
        app::Session session;
        ::load(session.document, sheetOf(LiveDifferences::mostAtOnce + 1));
        session.differences.ask(kwcAgainstExact());
        session.differences.finish();
        QSignalSpy begun(&session.differences, &LiveDifferences::begun);
        QSignalSpy changed(&session.differences, &LiveDifferences::changed);
        Window moved = paper;
        for (int i = 1; i <= 5; ++i) {
            moved = {paper.min + double(i), paper.max + double(i)};
            session.setPreview({.windows = withWindow(session.now().windows(), moved)});
            QCoreApplication::processEvents();
            QVERIFY(!session.differences.upToDate());
            QCOMPARE(changed.size(), 1); // panels hear at once that their figures are old
        }
        QTRY_VERIFY(session.differences.upToDate());
        QCOMPARE(begun.size(), 1);
        QCOMPARE(session.differences.found().list, atOnce(session, kwcAgainstExact(), moved));
        session.history.push(windowStep(session.document, moved));
        session.setPreview({});
        QVERIFY(session.differences.upToDate());
        // One that is dropped costs nothing.
        session.setPreview({.windows = withWindow(session.now().windows(), paper)});
        QVERIFY(!session.differences.upToDate());
        session.setPreview({});
        QVERIFY(session.differences.upToDate());
        QVERIFY(!session.differences.piecesAt(moved).empty());
        session.setPreview({.windows = withWindow(session.now().windows(), paper)});
        ::splice(session.document, 0, 1, {});
        session.setPreview({}); // the lines are others meanwhile
        QVERIFY(!session.differences.upToDate());
    }

    void sameQuestionIsNotComputedAgain()
    {
        app::Session session;
        ::load(session.document, sheetOf(500));
        session.differences.ask(kwcAgainstExact());
        session.differences.finish();
        QSignalSpy changed(&session.differences, &LiveDifferences::changed);
        session.differences.ask(kwcAgainstExact());
        QTest::qWait(20);
        QVERIFY(changed.isEmpty());
        Comparison stricter{{findAlgorithm("md"), Form::Corrected}, app::exactVariant(), 0};
        session.differences.ask(stricter);
        QTRY_VERIFY(session.differences.upToDate());
        QVERIFY(!session.differences.found().list.empty()); // MD rounds
        stricter.ulps.reset();
        session.differences.ask(stricter);
        session.differences.finish();
        QVERIFY(session.differences.found().list.empty()); // and keeps its contract
        QVERIFY(stricter.allowed() >= 24);
    }

    void placeShowsTheDifferingPart()
    {
        const Segment line{{0, 0}, {0.5, 300}};
        const Window window{{0, 100}, {400, 200}};
        const auto place = app::placeOf(kwcAgainstExact(), line, window);
        QCOMPARE(place.min.y, 100.); // all of the piece, and not all of the line
        QCOMPARE(place.max.y, 200.);
        const auto contact = app::placeOf(kwcAgainstExact(), {{-10, 110}, {10, 90}}, window);
        QCOMPARE(contact, (Window{{0, 100}, {0, 100}}));
    }

    // How long is printed, not tested: other programs' work decides it, too.
    void aHundredThousandLinesAreComparedAtOnce()
    {
        app::Session session;
        ::load(session.document, sheetOf(LiveDifferences::mostAtOnce));
        for (const app::Variant& variant : app::variants()) {
            session.differences.ask(Comparison{variant});
            session.differences.finish();
            double best = 1e9;
            for (int i = 0; i < 3; ++i) {
                ::setWindow(session.document, {{100. + i, 100}, {300, 250}});
                QElapsedTimer clock;
                clock.start();
                session.differences.finish();
                best = std::min(best, double(clock.nsecsElapsed()) * 1e-6);
            }
            qInfo("%s against exact: %.1f ms", qPrintable(app::nameOf(variant)), best);
            QVERIFY(session.differences.upToDate());
        }
    }
};

} // namespace comparison_live_differences_test

TEST_CLASS(comparison_live_differences_test::LiveDifferencesTest, Core)
#include "tests/app/comparison/live_differences_test.moc"
