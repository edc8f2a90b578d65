// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/live_finding.h"

#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <QThreadPool>

#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"

namespace comparison_live_finding_test {

using clipping::Window;

namespace {

constexpr std::size_t few = 10, slice = 4;
constexpr Window first{{0, 0}, {9, 9}}, second{{1, 1}, {5, 5}}, third{{2, 2}, {8, 8}};

app::Sheet sheetOf(std::size_t lines)
{
    app::Sheet sheet;
    sheet.window = first;
    for (std::size_t i = 0; i < lines; ++i) {
        app::Shape line;
        line.paths = {{{double(i), 0}, {{{double(i), 5}}}}};
        sheet.shapes.push_back(std::move(line));
    }
    return sheet;
}

/// Finds how many lines there are, and writes down how it was asked.
class LineCount final : public app::LiveFinding {
public:
    LineCount(const app::EditedDocument& document, const app::Scene& scene)
        : LiveFinding(document, scene, {few, slice}, nullptr)
    {
    }
    using LiveFinding::askAnew;

    std::size_t found = 0, starts = 0;
    unsigned milliseconds = 0;      ///< that a slice takes
    std::vector<std::size_t> looks; ///< lines that the last result looked at
    Window window{};                ///< of the last start
    Qt::HANDLE thread = nullptr;    ///< that looked for the last result

private:
    struct Looks final : Finding {
        explicit Looks(unsigned slow) : milliseconds(slow) {}
        void look(const app::SceneLines& lines, std::size_t count) override
        {
            looks.push_back(count);
            thread = QThread::currentThreadId();
            QThread::msleep(milliseconds);
            QVERIFY(count <= lines.size());
        }
        unsigned milliseconds;
        std::vector<std::size_t> looks;
        Qt::HANDLE thread = nullptr;
    };
    std::unique_ptr<Finding> start(const Window& at) override
    {
        ++starts;
        window = at;
        return std::make_unique<Looks>(milliseconds);
    }
    void keep(Finding& whole) override
    {
        looks = static_cast<Looks&>(whole).looks;
        thread = static_cast<Looks&>(whole).thread;
        found = 0;
        for (const std::size_t lines : looks)
            found += lines;
    }
    void forget() override { found = 0; }
};

struct Stage {
    app::EditedDocument document;
    app::Scene scene{document};
    LineCount count{document, scene};
    QSignalSpy changed{&count, &app::LiveFinding::changed};
    QSignalSpy begun{&count, &app::LiveFinding::begun};
    QSignalSpy progressed{&count, &app::LiveFinding::progressed};

    explicit Stage(std::size_t lines) { ::load(document, sheetOf(lines)); }
    void ask()
    {
        count.askAnew(true);
        changed.clear();
    }
};

} // namespace

class LiveFindingTest : public QObject {
    Q_OBJECT

private slots:
    void nothingIsComputedWithoutAQuestion()
    {
        Stage stage(5);
        stage.count.setWindow(second);
        ::load(stage.document, sheetOf(100));
        QTest::qWait(200);
        QVERIFY(stage.changed.isEmpty());
        QCOMPARE(stage.count.starts, std::size_t(0));
        QVERIFY(stage.count.upToDate());
        stage.count.finish();
        QCOMPARE(stage.count.starts, std::size_t(0));
    }

    /// Of as many changes as come before it.
    void fewLinesAreLookedAtInTheBackgroundBeforeTheNextFrame()
    {
        Stage stage(few);
        stage.ask();
        QVERIFY(!stage.count.upToDate());
        stage.count.setWindow(second);
        stage.count.setWindow(third);
        QVERIFY(stage.changed.isEmpty());
        QCoreApplication::sendPostedEvents();
        QCOMPARE(stage.count.window, third);
        stage.count.finish();
        QCOMPARE(stage.count.looks, (std::vector<std::size_t>{4, 4, 2}));
        QCOMPARE(stage.count.starts, std::size_t(1));
        QVERIFY(!stage.changed.isEmpty());
        QVERIFY(stage.count.upToDate());
        QCOMPARE(stage.count.progress(), 1.0);
        QVERIFY(stage.begun.isEmpty() && stage.progressed.isEmpty());
        QVERIFY(stage.count.thread != QThread::currentThreadId());
    }

    /// Whatever it takes, the thread that paints goes on, and hears that the figures are old.
    void fewLinesThatTakeLongAreToldToBeOld()
    {
        Stage stage(few);
        stage.count.milliseconds = 200;
        stage.ask();
        QCoreApplication::sendPostedEvents();
        QVERIFY(!stage.count.upToDate());
        QCOMPARE(stage.changed.size(), 1);
        QTRY_VERIFY(stage.count.upToDate());
        QCOMPARE(stage.changed.size(), 2);
        QCOMPARE(stage.count.found, few);
        QVERIFY(stage.begun.isEmpty() && stage.progressed.isEmpty());
    }

    /// When a series of changes is over.
    void manyLinesAreLookedAtInTheBackgroundInSlices()
    {
        Stage stage(few + 1);
        stage.ask();
        for (int i = 0; i < 5; ++i) {
            stage.count.setWindow(clipping::Window{{double(i), 0}, {50, 50}});
            QTest::qWait(20);
        }
        QCOMPARE(stage.count.starts, std::size_t(0));
        QTRY_VERIFY(stage.count.upToDate());
        QCOMPARE(stage.count.found, few + 1);
        QCOMPARE(stage.count.looks, (std::vector<std::size_t>{4, 4, 3}));
        QCOMPARE(stage.count.starts, std::size_t(1));
        QCOMPARE(stage.begun.size(), 1);
        QCOMPARE(stage.changed.size(), 1);
        QVERIFY(stage.count.thread != QThread::currentThreadId());
    }

    /// A thread may still look at the lines of a drawing that is gone.
    void theDrawingMayGoInTheMiddle()
    {
        {
            Stage stage(1000);
            stage.count.milliseconds = 1;
            stage.ask();
            QTRY_VERIFY(!stage.progressed.isEmpty());
        }
        QTRY_COMPARE(app::backgroundThreads().activeThreadCount(), 0);
    }

    void finishDoesNotWait()
    {
        Stage stage(few + 1);
        stage.ask();
        stage.count.finish();
        QVERIFY(stage.count.upToDate());
        QCOMPARE(stage.count.found, few + 1);
        stage.count.finish();
        QCOMPARE(stage.count.starts, std::size_t(1));
    }

    void withoutLinesNothingIsFoundAtOnce()
    {
        Stage stage(0);
        stage.ask();
        stage.count.finish();
        QVERIFY(stage.count.upToDate());
        stage.count.setWindow(second);
        stage.count.finish();
        QVERIFY(stage.count.upToDate());
    }

    /// Otherwise old figures would pass for new ones until they are.
    void anEditOfManyLinesIsToldAtOnce_data()
    {
        QTest::addColumn<std::size_t>("lines");
        QTest::addColumn<int>("told");
        QTest::addRow("few") << few << 0; // what is found comes before the next frame
        QTest::addRow("many") << few + 2 << 1;
    }
    void anEditOfManyLinesIsToldAtOnce()
    {
        QFETCH(std::size_t, lines);
        QFETCH(int, told);
        Stage stage(lines);
        stage.ask();
        stage.count.finish();
        stage.changed.clear();
        ::splice(stage.document, 0, 1, {});
        QVERIFY(!stage.count.upToDate());
        QCOMPARE(stage.changed.size(), told);
        QCOMPARE(stage.count.found, lines); // which are of before
        stage.count.setWindow(second);
        ::setWindow(stage.document, second);
        QCOMPARE(stage.changed.size(), told); // once
        stage.count.finish();
        QCOMPARE(stage.count.found, lines - 1);
        QCOMPARE(stage.changed.size(), told + 1);
    }

    void anotherDrawingClearsTheResults()
    {
        Stage stage(few);
        stage.ask();
        stage.count.finish();
        stage.changed.clear();
        ::load(stage.document, sheetOf(3));
        QCOMPARE(stage.count.found, std::size_t(0));
        QCOMPARE(stage.changed.size(), 1);
        QTRY_COMPARE(stage.count.found, std::size_t(3));
    }

    void droppedGestureNeedsNoComputation_data()
    {
        QTest::addColumn<std::size_t>("lines");
        QTest::addRow("few") << few;
        QTest::addRow("many") << few + 1;
    }
    void droppedGestureNeedsNoComputation()
    {
        QFETCH(std::size_t, lines);
        Stage stage(lines);
        stage.count.setWindow(first);
        stage.ask();
        stage.count.finish();
        stage.count.setWindow(second);
        QVERIFY(!stage.count.upToDate());
        stage.count.setWindow(first);
        QVERIFY(stage.count.upToDate());
        QTest::qWait(200);
        QCOMPARE(stage.count.starts, std::size_t(1));
        // Not if the lines are others meanwhile.
        stage.count.setWindow(second);
        ::splice(stage.document, 0, 1, {});
        stage.count.setWindow(first);
        QVERIFY(!stage.count.upToDate());
        stage.count.finish();
        QCOMPARE(stage.count.found, lines - 1);
    }

    /// Of which nothing is kept.
    void changeDuringComputationRestartsIt()
    {
        Stage stage(40);
        stage.count.milliseconds = 3;
        stage.ask();
        connect(&stage.count, &app::LiveFinding::progressed, this, [&] {
            QVERIFY(stage.count.window == second || stage.count.progress() < 1);
            stage.count.setWindow(second);
        });
        QTRY_VERIFY(stage.count.upToDate());
        QCOMPARE(stage.count.found, std::size_t(40));
        QCOMPARE(stage.count.window, second);
        QCOMPARE(stage.count.starts, std::size_t(2));
    }
};

} // namespace comparison_live_finding_test

TEST_CLASS(comparison_live_finding_test::LiveFindingTest, Core)
#include "tests/app/comparison/live_finding_test.moc"
