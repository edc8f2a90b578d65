// SPDX-License-Identifier: GPL-3.0-or-later
// A process that draws is killed at random moments: no finished step is lost, of one drawing or of
// several. That process is this program (--draw FOLDER SEED DRAWINGS). CLEARCUT_KILLS=1000 sets the
// number of kills.
#include "app/recovery/replay.h"

#include <QCoreApplication>
#include <QProcess>
#include <QTest>
#include <QThread>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <map>
#include <memory>

#include "tests/app/commands/random_commands.h"
#include "tests/app/recovery/recorded_drawing.h"

using namespace app;

namespace {

constexpr int patience = 60'000;                     // milliseconds, against a hang
constexpr Journal::Limits limits{10'000'000, 0.002}; // a new base after some steps

/// The same steps for the same seed. Each is a single record.
class Script : public QObject {
public:
    explicit Script(unsigned seed)
        : document(RandomDocuments(seed).document(30)), commands_(document, seed), random_(seed)
    {
        connect(&history, &History::pushed, this, [this] { inHand.reset(); });
    }
    void act()
    {
        switch (random_.below(10)) {
        case 0:
            history.undo();
            break;
        case 1:
            history.redo();
            break;
        case 2:
        case 3:
        case 4:
            addCorner();
            break;
        default:
            history.push(commands_.next());
        }
    }
    EditedDocument document;
    History history;
    std::optional<PendingObject> inHand; ///< a polyline

private:
    void addCorner()
    {
        std::vector<Subpath> path{{random_.point(), {{random_.point()}}, false}};
        if (inHand) {
            path = inHand->object.path.subpaths();
            path[0].segments.push_back({random_.point()});
        }
        inHand = PendingObject{{Path(path), {.stroke = Colour{}}},
                               document.now().containers().childrenOf(0)[0]};
    }
    RandomCommands commands_;
    RandomSheets random_;
};

/// The state after a recovery.
RecordedState expected(const Script& script)
{
    RecordedState state = stateOf(script.document.now(), script.history);
    if (script.inHand) {
        Document document = script.document.now();
        const PendingObject& pending = *script.inHand;
        const Containers& containers = document.containers();
        const ContainerId into =
            containers.contains(pending.into) ? pending.into : containers.childrenOf(0).back();
        Objects objects = document.objects().slice(0, 0);
        objects.append(pending.object);
        document.apply(adding(document, objects, into));
        state.svg = svgOf(document);
        state.texts = state.texts.first(state.index);
        state.texts << "Recover unfinished object";
        if (state.clean && *state.clean > state.index)
            state.clean.reset();
        ++state.index;
    }
    return state;
}

/// One of the open drawings, as each tab has it.
struct Drawing {
    Drawing(const QString& folder, unsigned seed, int number)
        : script(seed + unsigned(number)), journal(script.document, script.history, folder, limits)
    {
        journal.setOrigin({{QString::number(number), {}, {}}, {}});
    }
    Script script;
    Journal journal;
};

/// Step i is one of drawing i % drawings.
[[noreturn]] void draw(const QString& folder, unsigned seed, int drawings)
{
    std::vector<std::unique_ptr<Drawing>> all;
    for (int number = 0; number < drawings; ++number)
        all.push_back(std::make_unique<Drawing>(folder, seed, number));
    for (int step = 0;; ++step) {
        std::printf("%d\n", step);
        std::fflush(stdout);
        Drawing& drawing = *all[std::size_t(step % drawings)];
        drawing.script.act();
        drawing.journal.setInHand(drawing.script.inHand);
        QCoreApplication::processEvents();
        QThread::usleep(50);
    }
}

/// The states that a recovery may find: after the steps that were said to be done, and after one
/// more, if it was done but not yet said.
std::vector<RecordedState> possible(Script& script, int done, bool perhapsOneMore)
{
    for (int step = 0; step < done; ++step)
        script.act();
    std::vector<RecordedState> states{expected(script)};
    if (perhapsOneMore) {
        script.act();
        states.push_back(expected(script));
    }
    return states;
}

} // namespace

class KillTest : public QObject {
    Q_OBJECT

    /// The number of steps that the process said were done before it was killed; -1: none.
    static int killed(const QString& folder, unsigned seed, int drawings, int milliseconds)
    {
        QProcess process;
        process.start(QCoreApplication::applicationFilePath(),
                      {"--draw", folder, QString::number(seed), QString::number(drawings)});
        process.waitForReadyRead(patience);
        QThread::msleep(unsigned(milliseconds));
        ::kill(pid_t(process.processId()), SIGKILL);
        process.waitForFinished(patience);
        const auto lines = process.readAllStandardOutput().split('\n');
        return lines.size() < 2 ? -1 : lines[lines.size() - 2].toInt();
    }

private slots:
    void noFinishedStepIsLost_data()
    {
        QTest::addColumn<int>("drawings");
        QTest::addRow("one drawing") << 1;
        QTest::addRow("three drawings") << 3;
    }
    void noFinishedStepIsLost()
    {
        QFETCH(int, drawings);
        const int kills = std::max(5, qEnvironmentVariableIntValue("CLEARCUT_KILLS"));
        RandomSheets random(unsigned(QDateTime::currentMSecsSinceEpoch()));
        int inHand = 0, steps = 0;
        for (int i = 0; i < kills; ++i) {
            const QTemporaryDir home;
            const QString folder = home.filePath("unsaved");
            const auto seed = unsigned(random.below(1'000'000));
            const int done = killed(folder, seed, drawings, int(random.below(150)));
            QVERIFY2(done >= 0, qPrintable(QString("seed %1").arg(seed)));
            steps += done;
            std::map<QString, Leftover> left;
            for (const Leftover& one : claimLeftovers(folder))
                left[one.origin.name] = one;
            for (int number = 0; number < drawings; ++number) {
                const QByteArray what = QStringLiteral("seed %1, step %2, drawing %3")
                                            .arg(seed)
                                            .arg(done)
                                            .arg(number)
                                            .toUtf8();
                Script script(seed + unsigned(number));
                const auto states = possible(script, (done + drawings - 1 - number) / drawings,
                                             done % drawings == number);
                inHand += script.inHand.has_value();
                const auto found = left.find(QString::number(number));
                if (found == left.end()) { // nothing was done yet
                    QVERIFY2(std::ranges::count(states, 0, &RecordedState::index) > 0, what);
                    continue;
                }
                const auto recovered = recover(found->second);
                QVERIFY2(recovered, what);
                QVERIFY2(std::ranges::count(states, stateOf(*recovered.value)) > 0, what);
            }
        }
        qInfo("%d kills, %d steps, %d in mid-polyline", kills, steps, inHand);
    }
};

int main(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    if (argc == 5 && QByteArrayView(argv[1]) == "--draw")
        draw(argv[2], unsigned(QByteArray(argv[3]).toUInt()), QByteArray(argv[4]).toInt());
    KillTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "tests/app/recovery/kill_test.moc"
