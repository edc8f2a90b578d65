// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of an open drawing for which the heap runs out at any of their allocations.
#include "app/document/hidden_objects.h"
#include "app/session/copy_selection.h"

#include <QTest>

#include <atomic>
#include <limits>

#include "tests/app/commands/random_commands.h"
#include "tests/app/recovery/recorded_drawing.h"
#include "tests/replaced_heap.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace {

constexpr std::size_t enough = std::numeric_limits<std::size_t>::max();

/// What the heap still gives to this thread, and for how many allocations it gives nothing then.
struct Heap {
    std::size_t left = enough, refuses = 0;
};
thread_local Heap heap;
/// How many large allocations other threads get until one is refused. Qt does not bear that small
/// ones fail: QFile crashes.
std::atomic<std::size_t> leftForOthers = enough;
constexpr std::size_t large = 1000; // bytes
thread_local bool isTestThread = false;

} // namespace

bool heapRefuses(std::size_t size)
{
    if (!isTestThread)
        return size >= large && leftForOthers != enough && leftForOthers-- == 0;
    if (heap.left == enough || heap.left-- > 0)
        return false;
    heap.left = --heap.refuses > 0 ? 0 : enough;
    return true;
}

using namespace app;

namespace {

/// A drawing with some steps, of which the last one is undone.
struct Drawing {
    explicit Drawing(unsigned seed, const QString& above)
        : journal(session.document, session.history, above, {.retry = {}})
    {
        RandomDocuments random(seed);
        session.load({random.document(15), {}});
        states.push_back(session.now());
        for (int i = 0; i < 3; ++i) {
            session.history.push(RandomCommands(session.document, seed + unsigned(i)).next());
            states.push_back(session.now());
        }
        session.history.undo();
        session.select(common(
            ObjectRanges(ObjectRange{2, std::min<std::size_t>(9, session.now().objects().size())}),
            editableObjects(session.now())));
    }
    /// Whether what is shown of the document is that of the document.
    bool isConsistent() const
    {
        const Document& now = session.now();
        const SceneLines lines =
            linesOf(now.objects(), now.containers().hiddenRanges(), usualTolerance(now.page()));
        return std::ranges::equal(allOf(session.scene.lines()), allOf(lines))
               && (session.selection().empty()
                   || session.selection().ranges().back().end <= now.objects().size());
    }
    static std::vector<clipping::Segment> allOf(const SceneLines& lines)
    {
        std::vector<clipping::Segment> all;
        for (const auto& run : lines.runs())
            all.insert(all.end(), run.segments.begin(), run.segments.end());
        return all;
    }

    Session session;
    Journal journal;
    std::vector<Document> states; ///< at each index of the history
};

using Act = std::function<void(Session&)>;
std::vector<std::pair<const char*, Act>> acts()
{
    const Document other = RandomDocuments(77).document(12);
    return {
        {"a command", [](Session& s) { s.history.push(RandomCommands(s.document, 31).next()); }},
        {"undo", [](Session& s) { s.history.undo(); }},
        {"redo", [](Session& s) { s.history.redo(); }},
        {"a jump", [](Session& s) { s.history.setIndex(0); }},
        {"duplicate", [](Session& s) { duplicateInPlace(s); }},
        {"paste", [other](Session& s) { paste(s, other, PastePlace::Offset); }},
        {"nodes", [](Session& s) { s.nodes.run(nodeStep("reverse-path")); }}};
}

} // namespace

class TooLittleMemoryTest : public QObject {
    Q_OBJECT

    QTemporaryDir home_;
    QString above() const { return home_.filePath("unsaved"); }

private slots:
    void initTestCase() { isTestThread = true; }

    void anEditIsDoneOrNot_data()
    {
        QTest::addColumn<std::size_t>("refuses");
        QTest::newRow("one allocation fails") << std::size_t(1);
        QTest::newRow("all later ones fail") << enough;
    }
    void anEditIsDoneOrNot()
    {
        QFETCH(std::size_t, refuses);
        std::size_t failures = 0;
        for (const auto& [name, act] : acts())
            for (unsigned seed = 1; seed <= 2; ++seed) {
                Drawing expected(seed, above());
                const int before = expected.session.history.index();
                act(expected.session);
                const int after = expected.session.history.index();
                Drawing drawing(seed, above());
                Session& session = drawing.session;
                drawing.states.resize(std::size_t(std::max(after, before) + 1));
                drawing.states[std::size_t(after)] = expected.session.now();
                for (std::size_t left = 0; session.history.index() == before; ++left) {
                    const std::uint64_t revision = session.document.revision();
                    const ObjectRanges selection = session.selection();
                    heap = {left, refuses};
                    try {
                        act(session);
                    } catch (const std::bad_alloc&) {
                        ++failures;
                    }
                    heap = {};
                    const auto index = std::size_t(session.history.index());
                    const QString what =
                        QStringLiteral("%1, seed %2, after %3").arg(name).arg(seed).arg(left);
                    VERIFY_OR_SAY(session.now() == drawing.states[index], qPrintable(what));
                    if (int(index) == before) {
                        VERIFY_OR_SAY(session.document.revision() == revision, qPrintable(what));
                        VERIFY_OR_SAY(refuses > 1 || session.selection() == selection,
                                      qPrintable(what));
                    }
                    VERIFY_OR_SAY(refuses > 1 || left % 4 > 0 || drawing.isConsistent(),
                                  qPrintable(what));
                    if (after == before && session.document.revision() == revision && left > 1000)
                        break; // a refused act
                }
                session.history.setIndex(after); // a jump may have ended on the way
                session.history.push(RandomCommands(session.document, 55).next());
                QVERIFY(drawing.isConsistent());
                drawing.journal.wait();
                session.history.undo();
                drawing.journal.wait();
                QVERIFY2(drawing.journal.complete(), qPrintable(drawing.journal.whyIncomplete()));
                const auto found = replayed(drawing.journal.folder());
                QVERIFY(found && found->document == session.now());
                drawing.journal.discard();
                expected.journal.discard();
            }
        QVERIFY(failures > 300);
    }
    // It makes the files. Whatever it cannot allocate, the next step finds it at work again.
    void theJournalsThreadGoesOn()
    {
        const auto other = [](Drawing& drawing) {
            return new AddObjects(drawing.session.document,
                                  RandomDocuments(8).document(300).objects(),
                                  drawing.session.pen.layer, "Add");
        };
        bool refused = true;
        for (std::size_t left = 0; refused; ++left) {
            leftForOthers = left;
            Drawing drawing(4, above());
            drawing.session.history.push(other(drawing));
            drawing.journal.wait();
            refused = leftForOthers == enough;
            leftForOthers = enough;
            for (int i = 0; i < 2; ++i) {
                drawing.session.history.push(other(drawing));
                drawing.journal.wait();
            }
            VERIFY_OR_SAY(drawing.journal.complete(), qPrintable(QString::number(left)));
            const auto found = replayed(drawing.journal.folder());
            VERIFY_OR_SAY(found && found->document == drawing.session.now(),
                          qPrintable(QString::number(left)));
            drawing.journal.discard();
            QVERIFY(!refused || left < 100);
        }
    }
};

TEST_CLASS(TooLittleMemoryTest, Core)
#include "tests/app/recovery/too_little_memory_test.moc"
