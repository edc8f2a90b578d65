// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/unfinished.h"
#include "app/recovery/replay.h"
#include "ui/editor/editor.h"
#include "ui/files/files.h"
#include "ui/widgets/message_strip.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <QTimer>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <functional>
#include <map>
#include <random>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "tests/app/document/sheet_edits.h"
#include "tests/content_of.h"

// The editor, in a process of its own, receives real events, is ended by a signal, and is started
// again. That process is this test program (--editor SCENARIO [FILE]): it runs the editor as
// main() does, and a timer in it acts as the user.

namespace {

using ui::MainWindow;

/// Signals the test that started this process.
void say(const QString& line)
{
    std::printf("%s\n", qPrintable(line));
    std::fflush(stdout);
}

MainWindow* mainWindow()
{
    for (QWidget* widget : QApplication::allWidgets())
        if (auto* window = qobject_cast<MainWindow*>(widget); window && window->isVisible())
            return window;
    return nullptr;
}

QWidget* area(MainWindow& window) { return window.canvas().focusProxy(); }

void drawLine(MainWindow& window)
{
    window.canvas().setTool("line");
    QTest::mousePress(area(window), Qt::LeftButton, {}, {100, 100});
    QTest::mouseMove(area(window), {150, 150});
    QTest::mouseRelease(area(window), Qt::LeftButton, {}, {200, 220});
}

void clickCorners(MainWindow& window)
{
    window.canvas().setTool("polyline");
    for (const QPoint corner : {QPoint(100, 100), QPoint(200, 120), QPoint(150, 300)})
        QTest::mouseClick(area(window), Qt::LeftButton, {}, corner);
}

/// The strip that asks about a drawing; null: none does.
ui::MessageStrip* offer()
{
    if (const MainWindow* window = mainWindow())
        for (auto* strip : window->findChildren<ui::MessageStrip*>())
            if (strip->asks())
                return strip;
    return nullptr;
}

/// The number of drawings that are offered, and the first one's name.
void sayOffer()
{
    const QString asked = offer() ? offer()->findChild<QLabel*>()->text() : QString();
    const int count = asked.isEmpty() ? 0 : asked.contains("One more") ? 2 : 1;
    const QString name = asked.section("before ", 1).section(" was saved", 0, 0);
    say(QString("offers %1: %2").arg(count).arg(name));
}

void press(const QString& verb)
{
    const auto* strip = offer();
    if (!strip)
        return;
    for (QPushButton* button : strip->findChildren<QPushButton*>())
        if (button->text() == verb)
            return button->click();
}

void sayDrawing(const MainWindow& window)
{
    say(QString("%1 shapes, %2, %3")
            .arg(window.session().now().objects().size())
            .arg(window.windowTitle().section("[", 0, 0),
                 window.isWindowModified() ? "not saved" : "saved"));
}

void ready() { say("ready"); }

std::atomic<bool> diskHangs = false; ///< at the next file that is not a journal's

bool isJournal(int file)
{
    return QFile::symLinkTarget(QStringLiteral("/proc/self/fd/%1").arg(file)).contains("/unsaved/");
}

qsizetype filesLeft()
{
    return QDir(app::leftoverFolder()).entryList({"*.journal"}, QDir::Dirs).size();
}

void when(const std::function<bool()>& so, const std::function<void()>& then)
{
    QTimer::singleShot(10, [so, then] { so() ? then() : when(so, then); });
}

/// Answers the offer, if there is one.
void recover(MainWindow& window, const std::function<void()>& then)
{
    if (!offer())
        return then();
    press("Recover");
    // Until then, input is held back.
    when([&window] { return window.isWindowModified() && !window.files().busy(); }, then);
}

/// The window may become active a moment later.
QWidget* focused()
{
    (void)QTest::qWaitFor([] { return QApplication::focusWidget() != nullptr; });
    return QApplication::focusWidget();
}

using Scenario = std::function<void(MainWindow&)>;
const std::map<QString, Scenario>& scenarios()
{
    static const std::map<QString, Scenario> all{
        {"look", [](MainWindow&) { ready(); }},
        {"draw", [](MainWindow& w) { drawLine(w), ready(); }},
        {"draw on", // says the number of lines after each
         [](MainWindow& w) {
             auto* timer = new QTimer(&w);
             QObject::connect(timer, &QTimer::timeout, &w, [&w] {
                 drawLine(w);
                 say(QString::number(w.session().now().objects().size()));
             });
             timer->start(0);
         }},
        {"polyline", [](MainWindow& w) { clickCorners(w), ready(); }},
        {"text",
         [](MainWindow& w) {
             w.canvas().setTool("text");
             QTest::mouseClick(area(w), Qt::LeftButton, {}, {100, 100});
             QTest::keyClicks(focused(), "Wall");
             QTimer::singleShot(500, ready);
         }},
        {"edited text",
         [](MainWindow& w) {
             w.canvas().setTool("text");
             QTest::mouseClick(area(w), Qt::LeftButton, {}, {100, 100});
             QTest::keyClicks(focused(), "W");
             QTest::keyClick(focused(), Qt::Key_Return);
             w.canvas().setTool("select");
             const auto start = w.session().now().objects()[1].path().subpaths()[0].start;
             const app::Point on = w.canvas().view().toScreen(start);
             QTest::mouseDClick(area(w), Qt::LeftButton, {}, {qRound(on.x), qRound(on.y)});
             QTest::keyClicks(focused(), "Wall");
             QTimer::singleShot(500, ready);
         }},
        {"one corner",
         [](MainWindow& w) {
             w.canvas().setTool("polyline");
             QTest::mouseClick(area(w), Qt::LeftButton, {}, {100, 100});
             ready();
         }},
        {"busy", // as if painting never ended
         [](MainWindow& w) {
             drawLine(w);
             ready();
             for (;;)
                 pause();
         }},
        {"saving", // where the file system has no unnamed files
         [](MainWindow& w) {
             drawLine(w);
             const QString path = w.session().path();
             const app::Unfinished guard(path);
             QFile half(path + ".AbCdEf");
             if (half.open(QIODevice::WriteOnly))
                 ready();
             for (;;)
                 pause();
         }},
        {"slow save",
         [](MainWindow& w) {
             drawLine(w);
             diskHangs = true;
             w.findChild<QAction*>("save")->trigger();
         }},
        {"dialog",
         [](MainWindow& w) {
             drawLine(w);
             QTimer::singleShot(0, ready);
             QMessageBox(QMessageBox::NoIcon, "x", "y", QMessageBox::Ok, &w).exec();
         }},
        {"recover",
         [](MainWindow& w) {
             sayOffer();
             recover(w, [&w] { sayDrawing(w), ready(); });
         }},
        {"recover and undo",
         [](MainWindow& w) {
             recover(w, [&w] {
                 say("undo " + w.session().history.undoText());
                 w.findChild<QAction*>("undo")->trigger();
                 sayDrawing(w);
                 w.findChild<QAction*>("redo")->trigger();
                 sayDrawing(w), ready();
             });
         }},
        {"recover and draw", [](MainWindow& w) { recover(w, [&w] { drawLine(w), ready(); }); }},
        {"recover and save",
         [](MainWindow& w) {
             recover(w, [&w] {
                 w.findChild<QAction*>("save")->trigger();
                 w.files().wait();
                 sayDrawing(w), ready();
             });
         }},
        {"discard",
         [](MainWindow&) {
             sayOffer();
             const auto count = filesLeft();
             press("Discard");
             when([count] { return filesLeft() < count; }, ready);
         }},
        {"not now", [](MainWindow&) { sayOffer(), press("Later"), ready(); }},
    };
    return all;
}

QString scenario;

} // namespace

/// Goes before the C library's function.
extern "C" int fsync(int file)
{
    if (!diskHangs || isJournal(file) || !diskHangs.exchange(false))
        return int(::syscall(SYS_fsync, file));
    ready();
    for (;;)
        pause();
}

namespace {

// When this runs, the events of the start have been handled, or wait for an answer to the offer.
void play()
{
    MainWindow* window = mainWindow();
    if (!window)
        return QTimer::singleShot(10, play);
    window->activateWindow();
    scenarios().at(scenario)(*window);
}

/// The editor's exit code.
int runEditor(int argc, char** argv)
{
    QStringList arguments;
    for (int i = 3; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    scenario = argv[2];
    qAddPreRoutine([] { QTimer::singleShot(10, play); });
    return ui::runEditor(argc, argv, arguments);
}

constexpr int patience = 60'000; // milliseconds, against a hang

} // namespace

class RecoveryTest : public QObject {
    Q_OBJECT

private slots:
    void aSignalSavesTheWorkAndEndsTheProgram_data()
    {
        QTest::addColumn<QString>("scenario");
        QTest::addColumn<int>("signal");
        QTest::addColumn<int>("shapes");
        for (const int signal : {SIGTERM, SIGHUP, SIGINT})
            QTest::addRow("a line, %s", strsignal(signal)) << "draw" << signal << 2;
        for (const char* const killed :
             {"draw", "polyline", "text", "edited text", "busy", "dialog"})
            QTest::addRow("%s, killed", killed) << killed << SIGKILL << 2;
        for (const int signal : {SIGSEGV, SIGABRT})
            for (const char* const crashed : {"draw", "polyline"})
                QTest::addRow("%s, %s", crashed, strsignal(signal)) << crashed << signal << 2;
        for (const char* const inHand : {"polyline", "text", "edited text"})
            QTest::addRow("%s in hand", inHand) << inHand << SIGTERM << 2;
        QTest::addRow("while it is busy") << "busy" << SIGTERM << 2;
        QTest::addRow("while it saves") << "saving" << SIGTERM << 2;
        QTest::addRow("while the disk is slow") << "slow save" << SIGTERM << 2;
        QTest::addRow("in a dialog") << "dialog" << SIGTERM << 2;
    }
    void aSignalSavesTheWorkAndEndsTheProgram()
    {
        QFETCH(QString, scenario);
        QFETCH(int, signal);
        QFETCH(int, shapes);
        const Home home;
        const QByteArray saved = contentOf(home.drawing());
        Editor editor(home, scenario, {home.drawing()}, withoutCore);
        QVERIFY(editor.waitsUntilReady());
        QElapsedTimer clock;
        clock.start();
        QCOMPARE(editor.endedBy(signal), signal);
        qInfo("ended after %lld ms", clock.elapsed());
        QCOMPARE(contentOf(home.drawing()), saved);
        QCOMPARE(QDir(home.path.path()).entryList({"plan.svg*"}, QDir::Files),
                 QStringList{"plan.svg"}); // no partial file
        const auto left = app::claimLeftovers(home.leftovers());
        QCOMPARE(left.size(), std::size_t(1));
        QCOMPARE(left[0].origin.name, "plan.svg");
        QCOMPARE(left[0].origin.path, home.drawing());
        const app::Document recovered = app::recover(left[0]).value->document;
        const auto sheet = app::sheetOf(recovered);
        QCOMPARE(int(sheet.shapes.size()), shapes);
        if (scenario == "polyline")
            QCOMPARE(sheet.shapes.back().paths[0].segments.size(), std::size_t(2));
        if (scenario.endsWith("text")) {
            const app::Recipe recipe = recovered.objects()[1].particulars().recipe;
            const auto* text = std::get_if<app::TextRecipe>(&recipe);
            QVERIFY(text && text->text == "Wall");
        }
    }
    void noFinishedStepIsLostWhileEventsDraw()
    {
        std::random_device random;
        for (int kills = 0; kills < 2; ++kills) {
            const Home home;
            Editor editor(home, "draw on", {home.drawing()});
            while (editor.said.count('\n') < 3 && editor.process.waitForReadyRead(patience))
                editor.said += editor.process.readAllStandardOutput();
            QThread::msleep(random() % 200);
            QCOMPARE(editor.endedBy(SIGKILL), SIGKILL);
            editor.said += editor.process.readAllStandardOutput();
            const QStringList lines = editor.said.split('\n');
            QVERIFY2(lines.size() > 3, qPrintable(editor.said));
            const int said = lines[lines.size() - 2].toInt();
            const auto left = app::claimLeftovers(home.leftovers());
            QCOMPARE(left.size(), std::size_t(1));
            const int found = int(app::recover(left[0]).value->document.objects().size());
            QVERIFY2(found == said || found == said + 1, // done, but not yet said
                     qPrintable(QString("%1 lines instead of %2").arg(found).arg(said)));
            qInfo("%d lines", said);
        }
    }
    void aVanishingDisplayLosesNothing()
    {
        const QString server = QStandardPaths::findExecutable("Xvfb");
        if (server.isEmpty())
            QSKIP("Xvfb is not installed.");
        Home home;
        QProcess display;
        display.start(server, {"-displayfd", "1", "-screen", "0", "1280x800x24"});
        QByteArray number;
        while (!number.endsWith('\n') && display.waitForReadyRead(patience))
            number += display.readAllStandardOutput();
        QVERIFY2(number.endsWith('\n'), display.readAllStandardError());
        home.display = ":" + QString::fromLatin1(number.trimmed());
        Editor editor(home, "draw", {home.drawing()});
        QVERIFY2(editor.waitsUntilReady(), editor.process.readAllStandardError());
        display.kill();
        QVERIFY(display.waitForFinished(patience));
        QVERIFY(editor.process.waitForFinished(patience));
        home.display.clear();
        Editor next(home, "recover", {});
        QVERIFY(next.waitsUntilReady());
        QVERIFY2(next.said.contains("offers 1: plan.svg"), qPrintable(next.said));
        QVERIFY2(next.said.contains("2 shapes, plan.svg, not saved"), qPrintable(next.said));
    }
    void aDamagedJournalIsRecoveredAndItsFilesAreKept()
    {
        const Home home;
        const QByteArray saved = contentOf(home.drawing());
        QVERIFY(leave(home, "polyline", SIGKILL));
        const QDir left(home.leftovers());
        const QString journal = left.filePath(left.entryList({"*.journal"}, QDir::Dirs).front());
        QFile log(QDir(journal).filePath("log-1"));
        QVERIFY(log.open(QIODevice::ReadWrite));
        const QByteArray bytes = log.readAll();
        QVERIFY(log.seek(bytes.size() - 1) && log.putChar(char(bytes.back() ^ 1)));
        log.close();
        {
            Editor editor(home, "recover", {});
            QVERIFY(editor.waitsUntilReady());
            QVERIFY2(editor.said.contains("offers 1: plan.svg"), qPrintable(editor.said));
            QVERIFY2(editor.said.contains("2 shapes, plan.svg, not saved"),
                     qPrintable(editor.said));
            QCOMPARE(left.entryList({"*.unreadable"}, QDir::Dirs).size(), 1);
            QCOMPARE(editor.endedBy(SIGKILL), SIGKILL);
        }
        QCOMPARE(contentOf(home.drawing()), saved);
        const auto again = app::claimLeftovers(home.leftovers());
        QCOMPARE(again.size(), std::size_t(1));
        QVERIFY(again[0].origin.path.isEmpty()); // Save asks where
    }
    void withoutUnsavedWorkNothingIsLeftBehind()
    {
        for (const char* const scenario : {"look", "one corner"}) {
            const Home home;
            Editor editor(home, scenario, {home.drawing()});
            QVERIFY(editor.waitsUntilReady());
            QCOMPARE(editor.endedBy(SIGTERM), SIGTERM);
            QVERIFY2(app::claimLeftovers(home.leftovers()).empty(), scenario);
        }
    }
    void anIgnoredSignalStaysIgnored() // nohup
    {
        const Home home;
        Editor editor(home, "draw", {home.drawing()}, [] { std::signal(SIGHUP, SIG_IGN); });
        QVERIFY(editor.waitsUntilReady());
        kill(pid_t(editor.process.processId()), SIGHUP);
        QCOMPARE(editor.endedBy(SIGTERM), SIGTERM);
    }
    void theNextStartOffersTheWorkOnce()
    {
        const Home home;
        QVERIFY(leave(home, "draw"));
        {
            Editor editor(home, "recover", {});
            QVERIFY(editor.waitsUntilReady());
            QVERIFY2(editor.said.contains("offers 1: plan.svg"), qPrintable(editor.said));
            QVERIFY2(editor.said.contains("2 shapes, plan.svg, not saved"),
                     qPrintable(editor.said));
            Editor other(home, "recover", {}); // while the first one has claimed it
            QVERIFY(other.waitsUntilReady());
            QVERIFY2(other.said.contains("offers 0"), qPrintable(other.said));
            QCOMPARE(other.endedBy(SIGTERM), SIGTERM);
            QCOMPARE(editor.endedBy(SIGKILL), SIGKILL); // still not saved: it stays
        }
        {
            Editor editor(home, "recover and draw", {});
            QVERIFY(editor.waitsUntilReady());
            QCOMPARE(editor.endedBy(SIGTERM), SIGTERM); // one file, the newer work
            const auto left = app::claimLeftovers(home.leftovers());
            QCOMPARE(left.size(), std::size_t(1));
            QCOMPARE(app::sheetOf(app::recover(left[0]).value->document).shapes.size(),
                     std::size_t(3));
        }
        {
            Editor editor(home, "recover and save", {});
            QVERIFY(editor.waitsUntilReady());
            QVERIFY2(editor.said.contains("3 shapes, plan.svg, saved"), qPrintable(editor.said));
            QCOMPARE(editor.endedBy(SIGTERM), SIGTERM);
            QCOMPARE(app::sheetOf(app::readFile(home.drawing()).value->document).shapes.size(),
                     std::size_t(3));
        }
        Editor editor(home, "recover", {});
        QVERIFY(editor.waitsUntilReady());
        QVERIFY2(editor.said.contains("offers 0"), qPrintable(editor.said));
        QCOMPARE(editor.endedBy(SIGTERM), SIGTERM);
    }
    void undoLeadsBackToTheSavedFile()
    {
        const Home home;
        const QByteArray saved = contentOf(home.drawing());
        QVERIFY(leave(home, "draw", SIGKILL));
        Editor editor(home, "recover and undo", {});
        QVERIFY2(editor.waitsUntilReady(), qPrintable(editor.said));
        static const QRegularExpression undone("undo Draw line, \\d+\\.\\d+\u00a0mm\n1 shapes, "
                                               "plan.svg, saved\n2 shapes, plan.svg, not saved");
        QVERIFY2(editor.said.contains(undone), qPrintable(editor.said));
        QCOMPARE(contentOf(home.drawing()), saved);
    }
    void anUntitledDrawingIsRecoveredToo()
    {
        const Home home;
        {
            Editor editor(home, "draw", {});
            QVERIFY(editor.waitsUntilReady());
            QCOMPARE(editor.endedBy(SIGKILL), SIGKILL);
        }
        const auto left = app::claimLeftovers(home.leftovers());
        QCOMPARE(left.size(), std::size_t(1));
        QVERIFY(left[0].origin.path.isEmpty());
        QVERIFY(!left[0].origin.name.isEmpty());
        const auto found = app::recover(left[0]);
        QVERIFY(found);
        QCOMPARE(found.value->history.index, 1);
    }
    void severalDrawingsAreOfferedWithoutGarbage()
    {
        const Home home;
        QVERIFY(leave(home, "draw"));
        QVERIFY(leave(home, "polyline"));
        QFile garbage(home.leftovers() + "/garbage.svg");
        QVERIFY(garbage.open(QIODevice::WriteOnly));
        garbage.write("\0<?clearcut-unsaved \xff", 21);
        garbage.close();
        const QStringList expected{"offers 2: plan.svg", "offers 2: plan.svg", "offers 1: plan.svg",
                                   "offers 0"};
        const QStringList scenarios{"not now", "discard", "recover and save", "look"};
        for (qsizetype i = 0; i < scenarios.size(); ++i) {
            Editor editor(home, scenarios[i] == "look" ? "recover" : scenarios[i], {});
            QVERIFY(editor.waitsUntilReady());
            if (scenarios[i] != "recover and save")
                QVERIFY2(editor.said.contains(expected[i]),
                         qPrintable(scenarios[i] + ": " + editor.said));
            QCOMPARE(editor.endedBy(SIGTERM), SIGTERM);
        }
        QVERIFY(garbage.exists());
    }
    void aDiscardedDrawingIsNotOfferedAgain()
    {
        const Home home;
        QVERIFY(leave(home, "draw"));
        {
            Editor editor(home, "discard", {});
            QVERIFY(editor.waitsUntilReady());
            QCOMPARE(editor.endedBy(SIGTERM), SIGTERM);
        }
        QVERIFY(app::claimLeftovers(home.leftovers()).empty());
    }
    void anUnwritableFolderIsReportedAndTheProgramEnds()
    {
        const Home home;
        Editor editor(home, "draw", {home.drawing()}, {}, "/dev/null");
        QVERIFY(editor.waitsUntilReady());
        QCOMPARE(editor.endedBy(SIGTERM), SIGTERM);
        const QString errors = editor.process.readAllStandardError();
        QVERIFY2(errors.contains("The unsaved drawing is lost: Cannot write /dev/null/"),
                 qPrintable(errors));
    }
    void signalsEndTheProgram()
    {
        const Home home;
        QVERIFY(leave(home, "draw"));
        QProcess program;
        program.setProcessEnvironment(home.environment(home.path.path()));
        program.setProcessChannelMode(QProcess::MergedChannels);
        program.start(CLEARCUT_BINARY, {"--verbose", home.drawing()});
        QByteArray said;
        while (!said.contains("first frame") && program.waitForReadyRead(patience))
            said += program.readAll();
        QVERIFY2(said.contains("first frame"), said.constData());
        kill(pid_t(program.processId()), SIGINT);
        QVERIFY(program.waitForFinished(patience));
        QCOMPARE(program.exitStatus(), QProcess::CrashExit);
        QCOMPARE(program.exitCode(), SIGINT);
        QCOMPARE(app::claimLeftovers(home.leftovers()).size(), std::size_t(1));
    }

private:
    /// A user's folders, with a drawing of one line.
    struct Home {
        Home()
        {
            QFile file(drawing());
            [[maybe_unused]] const bool open = file.open(QIODevice::WriteOnly);
            file.write("<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' "
                       "viewBox='0 0 100 100'><path d='M0 50H100' stroke='#000' "
                       "fill='none'/></svg>");
        }
        QString drawing() const { return path.filePath("plan.svg"); }
        QString leftovers() const { return path.filePath("clearcut/unsaved"); }
        QProcessEnvironment environment(const QString& state) const
        {
            auto environment = QProcessEnvironment::systemEnvironment();
            environment.insert("HOME", path.path());
            environment.insert("XDG_CONFIG_HOME", path.filePath("config"));
            environment.insert("XDG_STATE_HOME", state);
            environment.insert("QT_QPA_PLATFORM", display.isEmpty() ? "offscreen" : "xcb");
            if (!display.isEmpty())
                environment.insert("DISPLAY", display);
            return environment;
        }
        QTemporaryDir path;
        QString display{}; ///< of X; empty: none
    };

    struct Editor {
        Editor(const Home& home, const QString& scenario, const QStringList& arguments,
               const std::function<void()>& before = {}, const QString& state = {})
        {
            auto environment = home.environment(state.isEmpty() ? home.path.path() : state);
            // A crash is to end it as without a sanitizer.
            for (const char* const sanitizer : {"ASAN_OPTIONS", "TSAN_OPTIONS"})
                environment.insert(sanitizer, environment.value(sanitizer) + ":handle_segv=0");
            process.setProcessEnvironment(environment);
            process.setChildProcessModifier(before);
            process.start(QCoreApplication::applicationFilePath(),
                          QStringList{"--editor", scenario} + arguments);
        }
        ~Editor()
        {
            process.kill();
            process.waitForFinished(patience);
        }
        bool waitsUntilReady()
        {
            while (!said.endsWith("ready\n") && process.waitForReadyRead(patience))
                said += process.readAllStandardOutput();
            return said.endsWith("ready\n");
        }
        /// The signal that ended it; 0: none.
        int endedBy(int signal)
        {
            kill(pid_t(process.processId()), signal);
            return process.waitForFinished(patience) && process.exitStatus() == QProcess::CrashExit
                       ? process.exitCode()
                       : 0;
        }
        QProcess process;
        QString said;
    };

    /// Crashes are wanted here.
    static void withoutCore()
    {
        const rlimit none{0, 0};
        ::setrlimit(RLIMIT_CORE, &none);
    }
    static bool leave(const Home& home, const QString& scenario, int signal = SIGTERM)
    {
        Editor editor(home, scenario, {home.drawing()});
        return editor.waitsUntilReady() && editor.endedBy(signal) == signal;
    }
};

int main(int argc, char** argv)
{
    if (argc > 2 && QByteArrayView(argv[1]) == "--editor")
        return runEditor(argc, argv);
    QCoreApplication application(argc, argv);
    RecoveryTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "tests/ui/editor/recovery_test.moc"
