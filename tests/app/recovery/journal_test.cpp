// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/move_objects.h"
#include "app/document/document_builder.h"
#include "app/recovery/journal.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include <ctime>

#include "tests/app/commands/random_commands.h"
#include "tests/app/recovery/recorded_drawing.h"
#include "tests/test_class.h"

namespace recovery_journal_test {

using namespace app;

namespace {

Document lines(int count)
{
    DocumentBuilder builder;
    builder.open({.name = "Lines"});
    const StyleEntry style = builder.style({.stroke = Colour{}});
    for (int i = 0; i < count; ++i)
        builder.addLine({{0.1 * i, 0.3}, {0.7, 0.01 * i}}, style);
    builder.close();
    return builder.take({});
}

ObjectRanges every(const Document& document)
{
    return ObjectRanges(ObjectRange{0, document.objects().size()});
}

/// Pushes, undoes, redoes, jumps and saves.
class RandomScript {
public:
    RandomScript(EditedDocument& document, History& history, unsigned seed)
        : document_(document), history_(history), commands_(document, seed), random_(seed + 1)
    {
    }
    void act()
    {
        const auto act = random_.below(20);
        if (act == 0)
            history_.undo();
        else if (act == 1)
            history_.redo();
        else if (act == 2)
            history_.setIndex(std::max(0, history_.index() - int(random_.below(4))));
        else if (act == 3)
            history_.setClean();
        else if (act == 4 && !document_.now().objects().empty())
            nudge();
        else
            history_.push(commands_.next());
    }
    std::string_view neverDrawn() const { return commands_.neverDrawn(); }
    int nudges() const { return nudges_; }

private:
    void nudge() // such steps join
    {
        for (int i = 0; i < 3; ++i, ++nudges_)
            history_.push(
                new MoveObjects(document_, every(document_.now()), {0.1, -0.7}, Merging::WithLast));
    }
    EditedDocument& document_;
    History& history_;
    RandomCommands commands_;
    RandomSheets random_;
    int nudges_ = 0;
};

} // namespace

class JournalTest : public QObject {
    Q_OBJECT

    QTemporaryDir home_;
    QString above() const { return home_.filePath("unsaved"); }

private slots:
    void aReplayGivesTheSameBytesAndTheHistory_data()
    {
        QTest::addColumn<double>("replay");
        QTest::addColumn<int>("history");
        QTest::newRow("one base") << 1e9 << 1'000'000'000;
        QTest::newRow("a new base after some steps") << 0.0005 << 1'000'000'000;
        QTest::newRow("bases without old steps") << 0.0005 << 100'000;
    }
    void aReplayGivesTheSameBytesAndTheHistory()
    {
        QFETCH(double, replay);
        QFETCH(int, history);
        RecordedDrawing drawing(RandomDocuments(1).document(300), above(),
                                {std::size_t(history), replay});
        RandomScript script(drawing.document, drawing.history, 2);
        int shorter = 0;
        for (int i = 1; i <= 1500; ++i) {
            script.act();
            if (i % 10 == 0)
                QCoreApplication::processEvents();
            if (i % 100 > 0)
                continue;
            drawing.journal.wait();
            const auto found = replayed(drawing.journal.folder());
            QVERIFY(found);
            const auto expected = stateOf(drawing.document.now(), drawing.history);
            const auto state = stateOf(*found);
            const auto forgotten = expected.texts.size() - state.texts.size();
            shorter += forgotten > 0;
            QCOMPARE(state.texts, expected.texts.mid(forgotten));
            QCOMPARE(state.index, expected.index - int(forgotten));
            if (forgotten == 0)
                QCOMPARE(state.clean, expected.clean);
            QVERIFY2(state.svg == expected.svg, qPrintable(QString::number(i)));
        }
        QVERIFY2(script.neverDrawn().empty(), script.neverDrawn().data());
        QVERIFY(script.nudges() > 100);
        QCOMPARE(shorter > 0, history < 1'000'000);
        QCOMPARE(QFile::exists(baseFile(drawing.journal.folder(), 1)), replay > 1);
    }
    void aStepMayJoinOneThatTheBaseLeftOut()
    {
        RecordedDrawing drawing(lines(100), above(), {1, 0.0003}); // bases without steps
        for (int i = 0; i < 20; ++i) {
            drawing.history.push(new MoveObjects(drawing.document, every(drawing.document.now()),
                                                 {1, 0}, Merging::WithLast));
            QCoreApplication::processEvents(); // some write a new base
            drawing.journal.wait();
            const auto found = replayed(drawing.journal.folder());
            QVERIFY(found);
            QCOMPARE(stateOf(*found).svg, svgOf(drawing.document.now()));
        }
        QCOMPARE(drawing.history.count(), 1);
    }
    // The steps before a base are restored from it, the others from records.
    void recoveredStepsAreUndoneAndRedone()
    {
        RecordedDrawing drawing(RandomDocuments(3).document(100), above());
        RandomScript script(drawing.document, drawing.history, 4);
        for (int i = 0; i < 400; ++i)
            script.act();
        auto found = replayed(drawing.journal.folder());
        QVERIFY(found);
        EditedDocument document(found->document);
        History history;
        restore(history, document, std::move(found->history));
        QCOMPARE(history.count(), drawing.history.count());
        for (int index = history.index(); index >= 0; --index) {
            history.setIndex(index);
            drawing.history.setIndex(index);
            QVERIFY2(svgOf(document.now()) == svgOf(drawing.document.now()),
                     qPrintable(QString::number(index)));
        }
        history.setIndex(history.count());
        drawing.history.setIndex(drawing.history.count());
        QCOMPARE(svgOf(document.now()), svgOf(drawing.document.now()));
    }
    void aBaseKeepsTheHistory()
    {
        RecordedDrawing drawing(RandomDocuments(5).document(200), above());
        RandomScript script(drawing.document, drawing.history, 6);
        for (int round = 0; round < 5; ++round) {
            for (int i = 0; i < 60; ++i)
                script.act();
            Recovered found = *replayed(drawing.journal.folder());
            JournalBase base{7, 3, found.origin, found.document, found.history};
            const auto read = readBase(baseBytes(base));
            QVERIFY(read);
            QCOMPARE(read->firstStep, StepNumber(3));
            QCOMPARE(read->firstRecord, std::uint64_t(7));
            QVERIFY(read->document == found.document);
            QVERIFY(stateOf({read->document, read->history, {}}) == stateOf(found));
            drawing.history.undo();
            const auto before = svgOf(drawing.document.now());
            EditedDocument document(read->document);
            History history;
            restore(history, document, read->history);
            history.undo();
            QVERIFY(svgOf(document.now()) == before);
        }
    }
    void newBasesBoundTheReplay()
    {
        RecordedDrawing drawing(lines(20'000), above());
        drawing.journal.wait();
        const ObjectRanges all = every(drawing.document.now());
        const QDir folder(drawing.journal.folder());
        for (int i = 0; i < 300; ++i)
            drawing.history.push(new MoveObjects(drawing.document, all, {0.1, 0.2 * i}));
        drawing.journal.wait();
        for (int i = 0; i < 10; ++i)
            drawing.history.undo();
        drawing.journal.wait();
        QVERIFY(!QFile::exists(copyFile(folder.path(), 1)));
        QVERIFY(folder.entryList(QDir::Files).size() <= 6); // a lock, two bases and their logs
        const std::clock_t start = std::clock();
        const auto found = replayed(folder.path());
        qInfo("recovered in %.0f ms of processor time",
              1e3 * double(std::clock() - start) / CLOCKS_PER_SEC);
        QVERIFY(svgOf(found->document) == svgOf(drawing.document.now()));
        QVERIFY(found->history.steps.size() > 60);
        QCOMPARE(int(found->history.steps.size()) - found->history.index, 10);
    }
    void theObjectInHandIsTheLastStep()
    {
        RecordedDrawing drawing(lines(3), above());
        const ContainerId layer = drawing.document.now().containers().childrenOf(0)[0];
        const Path two(std::vector<Subpath>{{{0, 0}, {{{5, 5}}, {{9, 1}}}, false}});
        const Path three(std::vector<Subpath>{{{0, 0}, {{{5, 5}}, {{9, 1}}, {{7, 7}}}, false}});
        drawing.journal.setInHand(PendingObject{{two, {}}, layer});
        drawing.journal.setInHand(PendingObject{{three, {}}, layer});
        const auto found = replayed(drawing.journal.folder());
        QCOMPARE(found->document.objects().size(), std::size_t(4));
        QVERIFY(found->document.objects()[3].path() == three);
        QCOMPARE(found->history.index, 1);
        QVERIFY(found->history.clean == 0);
        QVERIFY(known(drawing.journal.folder())->state.unsaved());
        drawing.journal.setInHand({});
        QCOMPARE(replayed(drawing.journal.folder())->document.objects().size(), std::size_t(3));
        QVERIFY(!known(drawing.journal.folder())->state.unsaved());
    }
    void anEditedObjectIsReplaced()
    {
        RecordedDrawing drawing(lines(3), above());
        Object edited = drawing.document.now().objects()[1].copy();
        edited.path = Path({{0, 0}, {7, 7}});
        drawing.journal.setInHand(ObjectInHand({edited, 0}, 1));
        const auto found = replayed(drawing.journal.folder());
        QCOMPARE(found->document.objects().size(), std::size_t(3));
        QVERIFY(found->document.objects()[1].copy() == edited);
        QVERIFY(found->document.objects()[2].path() == drawing.document.now().objects()[2].path());
        QCOMPARE(found->history.index, 1);
        drawing.journal.setInHand(ObjectInHand({edited, 0}, 99)); // it is gone: a new one
        QCOMPARE(replayed(drawing.journal.folder())->document.objects().size(), std::size_t(4));
    }
    void aStepEndsTheObjectInHand()
    {
        RecordedDrawing drawing(lines(3), above());
        const ContainerId layer = drawing.document.now().containers().childrenOf(0)[0];
        drawing.journal.setInHand(PendingObject{{Path({{0, 0}, {1, 1}}), {}}, layer});
        drawing.history.push(new RemoveObjects(drawing.document, {0}));
        QCOMPARE(replayed(drawing.journal.folder())->document.objects().size(), std::size_t(2));
    }
    void anotherDocumentHasAJournalOfItsOwn()
    {
        RecordedDrawing drawing(lines(3), above());
        drawing.history.push(new RemoveObjects(drawing.document, {0}));
        const QString first = drawing.journal.folder();
        drawing.history.clear();
        drawing.document.load(lines(7));
        drawing.journal.setOrigin({{"plan", "/tmp/plan.svg", {}}, {}});
        drawing.journal.wait();
        QVERIFY(drawing.journal.folder() != first);
        QVERIFY(!QFile::exists(first));
        const auto found = known(drawing.journal.folder());
        QVERIFY(found && !found->state.unsaved());
        QCOMPARE(found->state.origin.origin.name, "plan");
        drawing.history.push(new RemoveObjects(drawing.document, {0}));
        QVERIFY(known(drawing.journal.folder())->state.unsaved());
        QCOMPARE(replayed(drawing.journal.folder())->document.objects().size(), std::size_t(6));
        drawing.history.setClean();
        QVERIFY(!known(drawing.journal.folder())->state.unsaved());
        drawing.history.undo();
        QVERIFY(known(drawing.journal.folder())->state.unsaved());
        drawing.journal.discard();
        QVERIFY(!QFile::exists(drawing.journal.folder()));
    }
    void onlyTheUserCanRead()
    {
        RecordedDrawing drawing(lines(3), above());
        drawing.journal.wait();
        const auto others = QFile::ReadGroup | QFile::WriteGroup | QFile::ExeGroup
                            | QFile::ReadOther | QFile::WriteOther | QFile::ExeOther;
        const QString folder = drawing.journal.folder();
        for (const QString& path : {above(), folder, baseFile(folder, 1), logFile(folder, 1)})
            QVERIFY2(!(QFile::permissions(path) & others), qPrintable(path));
    }
    // Printed, not tested. The first and the last receiver of a signal are called before and after
    // the journal.
    void timesOfAppending()
    {
        constexpr int count = 100'000;
        EditedDocument document(lines(count));
        History history;
        QElapsedTimer clock;
        qint64 appending = 0; // nanoseconds
        connect(&history, &History::pushed, this, [&] { clock.start(); });
        Journal journal(document, history, above());
        connect(&history, &History::indexChanged, this, [&] { appending = clock.nsecsElapsed(); });
        journal.wait();
        const ObjectRanges all = every(document.now());
        const auto print = [&](const char* name, const auto& make) {
            std::vector<qint64> times;
            for (int i = 0; i < 7; ++i) {
                history.push(make());
                times.push_back(appending);
                journal.wait();
            }
            std::ranges::sort(times);
            qInfo("%s: %.3f ms, at most %.3f ms", name, double(times[3]) / 1e6,
                  double(times.back()) / 1e6);
        };
        print("move 100,000 lines", [&] { return new MoveObjects(document, all, {0.1, 0.2}); });
        print("restyle 100,000 lines", [&] {
            return new SetStyle(
                document, all, [](Style& style) { style.width += 1; }, "Style");
        });
        print("add a line", [&] {
            Objects objects = document.now().objects().slice(0, 0);
            objects.append(Object{Path({{0, 0}, {1, 1}}), {}});
            return new AddObjects(document, objects, document.now().containers().childrenOf(0)[0],
                                  "Add");
        });
        print("remove 1,000 lines", [&] {
            return new RemoveObjects(document, ObjectRanges(ObjectRange{7, 1007}));
        });
        print("copy 50,000 lines", [&] {
            return new AddObjects(document, document.now().objects().slice(0, count / 2),
                                  document.now().containers().childrenOf(0)[0], "Add");
        });
        Containers tree = document.now().containers();
        for (int i = 0; i < 2000; ++i)
            tree = *tree.inserted({.name = QString::number(i)}, tree.childrenOf(0)[0], 0, {0, 0});
        history.push(new SetContainers(document, tree, "Layers"));
        print("add a line among 2,000 layers", [&] {
            Objects objects = document.now().objects().slice(0, 0);
            objects.append(Object{Path({{0, 0}, {1, 1}}), {}});
            return new AddObjects(document, objects, document.now().containers().childrenOf(0)[0],
                                  "Add");
        });
        clock.start();
        history.undo();
        qInfo("undo: %.3f ms", double(appending) / 1e6);
    }
};

} // namespace recovery_journal_test

TEST_CLASS(recovery_journal_test::JournalTest, Core)
#include "tests/app/recovery/journal_test.moc"
