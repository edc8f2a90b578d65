// SPDX-License-Identifier: GPL-3.0-or-later
// A process that draws is killed at random moments: no finished step is lost. That process is this
// program (--draw FOLDER SEED). CLEARCUT_KILLS=1000 sets the number of kills.
#include "app/recovery/replay.h"

#include <QCoreApplication>
#include <QProcess>
#include <QTest>
#include <QThread>

#include <csignal>
#include <cstdio>

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

[[noreturn]] void draw(const QString& folder, unsigned seed)
{
    Script script(seed);
    Journal journal(script.document, script.history, folder, limits);
    for (int step = 0;; ++step) {
        std::printf("%d\n", step);
        std::fflush(stdout);
        script.act();
        journal.setInHand(script.inHand);
        QCoreApplication::processEvents();
        QThread::usleep(50);
    }
}

} // namespace

class KillTest : public QObject {
    Q_OBJECT

    /// The number of steps that the process said were done before it was killed; -1: none.
    static int killed(const QString& folder, unsigned seed, int milliseconds)
    {
        QProcess process;
        process.start(QCoreApplication::applicationFilePath(),
                      {"--draw", folder, QString::number(seed)});
        process.waitForReadyRead(patience);
        QThread::msleep(unsigned(milliseconds));
        ::kill(pid_t(process.processId()), SIGKILL);
        process.waitForFinished(patience);
        const auto lines = process.readAllStandardOutput().split('\n');
        return lines.size() < 2 ? -1 : lines[lines.size() - 2].toInt();
    }

private slots:
    void noFinishedStepIsLost()
    {
        const int kills = std::max(5, qEnvironmentVariableIntValue("CLEARCUT_KILLS"));
        RandomSheets random(unsigned(QDateTime::currentMSecsSinceEpoch()));
        int inHand = 0, steps = 0;
        for (int i = 0; i < kills; ++i) {
            const QTemporaryDir home;
            const auto seed = unsigned(random.below(1'000'000));
            const int done = killed(home.filePath("unsaved"), seed, int(random.below(150)));
            const QByteArray what = QStringLiteral("seed %1, step %2").arg(seed).arg(done).toUtf8();
            QVERIFY2(done >= 0, what);
            Script script(seed);
            for (int step = 0; step < done; ++step)
                script.act();
            std::vector<RecordedState> states;
            states.push_back(expected(script));
            inHand += script.inHand.has_value();
            script.act();
            states.push_back(expected(script)); // done, but perhaps not yet said
            const auto left = claimLeftovers(home.filePath("unsaved"));
            if (left.empty()) { // nothing was done yet
                QVERIFY2(states[0].index == 0 || states[1].index == 0, what);
                continue;
            }
            const auto found = recover(left[0]);
            QVERIFY2(found, what);
            const RecordedState state = stateOf(*found.value);
            QVERIFY2(state == states[0] || state == states[1], what);
            steps += done;
        }
        qInfo("%d kills, %d steps, %d in mid-polyline", kills, steps, inHand);
    }
};

int main(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    if (argc == 4 && QByteArrayView(argv[1]) == "--draw")
        draw(argv[2], unsigned(QByteArray(argv[3]).toUInt()));
    KillTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "tests/app/recovery/kill_test.moc"
