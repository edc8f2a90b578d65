// SPDX-License-Identifier: GPL-3.0-or-later
// The editor as a desktop starts it, and where memory runs out. This program runs the editor as
// main() does (--editor message|algorithm ARGUMENT ...) and writes to the file $REPORT what the
// window says, or which algorithm it has.
#include "app/comparison/variants.h"
#include "ui/editor/display.h"
#include "ui/editor/editor.h"
#include "ui/editor/editor_application.h"
#include "ui/window/main_window.h"

#include <QDir>
#include <QFile>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <array>
#include <fcntl.h>
#include <functional>
#include <new>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/content_of.h"
#include "tests/ui/test_window.h"

namespace {

ui::MainWindow* mainWindow()
{
    for (QWidget* widget : QApplication::allWidgets())
        if (auto* window = qobject_cast<ui::MainWindow*>(widget); window && window->isVisible())
            return window;
    return nullptr;
}

QString reported(ui::MainWindow& window, bool algorithm)
{
    return algorithm ? keyOf(window.session().variant()) : window.message();
}

/// Writes the message of the window, as soon as there is one, or its algorithm, and ends the
/// editor.
void report(bool algorithm)
{
    auto* window = mainWindow();
    if (!window || reported(*window, algorithm).isEmpty())
        return QTimer::singleShot(10, [algorithm] { report(algorithm); });
    QFile file(qEnvironmentVariable("REPORT"));
    if (file.open(QIODevice::WriteOnly))
        file.write(reported(*window, algorithm).toUtf8());
    file.close();
    QCoreApplication::quit();
}

int runEditor(int argc, char** argv)
{
    QStringList arguments;
    for (int i = 3; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    if (QByteArray(argv[2]) == "algorithm")
        qAddPreRoutine([] { QTimer::singleShot(10, [] { report(true); }); });
    else
        qAddPreRoutine([] { QTimer::singleShot(10, [] { report(false); }); });
    return ui::runEditor(argc, argv, arguments);
}

/// The exit code of a process that does this, after its streams have been opened by their names.
int inProcess(const std::array<const char*, 3>& streams, const std::function<int()>& act)
{
    const pid_t child = fork();
    if (child == 0) {
        for (int i = 0; i < 3; ++i) {
            const int file = ::open(streams[std::size_t(i)], O_RDWR | O_CREAT, 0600);
            ::dup2(file, i);
            if (file > STDERR_FILENO)
                ::close(file);
        }
        _exit(act());
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

const std::array<const char*, 3> nobody{"/dev/null", "/dev/null", "/dev/null"};

/// Does what it is told when an event reaches it.
struct Receiver : QObject {
    explicit Receiver(std::function<void()> act) : act(std::move(act)) {}
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::User)
            act();
        return QObject::event(event);
    }
    std::function<void()> act;
};

} // namespace

class StartTest : public QObject {
    Q_OBJECT

    QTemporaryDir home_;

    /// What the window says, or its algorithm, of an editor that nobody listens to.
    QString saidOf(const QByteArray& argument, const char* what = "message") const
    {
        const QByteArray report = QFile::encodeName(home_.filePath("report"));
        const QByteArray program = QFile::encodeName(QCoreApplication::applicationFilePath());
        QFile::remove(report);
        const int code = inProcess(nobody, [&] {
            ::setenv("REPORT", report.constData(), 1);
            ::setenv("QT_QPA_PLATFORM", "offscreen", 1);
            for (const char* folder : {"HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"})
                ::setenv(folder, qPrintable(home_.path()), 1);
            ::execl(program.constData(), program.constData(), "--editor", what,
                    argument.constData(), nullptr);
            return 99;
        });
        return code == 0 ? QString::fromUtf8(contentOf(report)) : QString::number(code);
    }

private slots:
    void aFileThatIsNotThereIsSaidInTheWindow()
    {
        QCOMPARE(saidOf("/no/where.svg"), "Cannot open /no/where.svg: there is no such file.");
        QCOMPARE(saidOf("file:///no/where.svg"),
                 "Cannot open /no/where.svg: there is no such file.");
    }
    void aNameThatIsNotUtf8IsSaidInTheWindow()
    {
        const QByteArray name = QFile::encodeName(home_.path()) + "/\xff.svg";
        const int file = ::open(name.constData(), O_CREAT | O_WRONLY, 0600);
        QVERIFY(file >= 0);
        ::close(file);
        const QString said = saidOf(name);
        QVERIFY2(said.startsWith("Cannot open ") && said.contains("UTF-8"), qPrintable(said));
    }
    void theAlgorithmIsTheOneAskedFor()
    {
        QCOMPARE(saidOf("--algorithm=MD", "algorithm"), "matthes-drakopoulos");
        QCOMPARE(saidOf("--size=900x700", "algorithm"), "exact");
    }
    /// The drawing that is opened at the start takes away the messages before it.
    void ignoredKeysAreSaidAfterTheFirstDrawing()
    {
        const ui::TestWindow t; // its settings are those of the editor
        const QByteArray file = QFile::encodeName(t.twoLines());
        QDir(home_.path()).mkpath("Clearcut");
        QFile settings(home_.filePath("Clearcut/Clearcut.ini"));
        QVERIFY(settings.open(QIODevice::WriteOnly));
        settings.write(R"({"shortcuts": ["save\tnonsense"]})");
        settings.close();
        const auto forget = qScopeGuard([&settings] { settings.remove(); });
        for (const QByteArray& argument : {file, QByteArray("--size=900x700")})
            QVERIFY(saidOf(argument).contains("keyboard shortcuts"));
    }
    void whoeverListensIsToldAndNoWindowOpens()
    {
        const QByteArray log = QFile::encodeName(home_.filePath("log"));
        const auto isRead = [] { return int(ui::isErrorRead()); };
        QCOMPARE(inProcess(nobody, isRead), 0);
        QCOMPARE(inProcess({"/dev/null", log.constData(), log.constData()}, isRead), 0);
        const auto withPipe = [] {
            int ends[2];
            return ::pipe(ends) == 0 && ::dup2(ends[1], STDERR_FILENO) >= 0 && ui::isErrorRead();
        };
        QCOMPARE(inProcess(nobody, [&] { return int(withPipe()); }), 1);
        QCOMPARE(inProcess(nobody,
                           [] {
                               const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
                               ::dup2(terminal, STDIN_FILENO);
                               return int(terminal >= 0 && ui::isErrorRead());
                           }),
                 1);
    }
    void anEventWithoutMemoryDoesNotEndTheProgram()
    {
        ui::TestWindow t;
        ui::MainWindow& window = *t.window;
        auto* application = qobject_cast<ui::EditorApplication*>(qApp);
        QVERIFY(application);
        application->setWindow(&window);
        app::EditedDocument& document = window.session().document;
        Receiver fails([] { throw std::bad_alloc(); });
        Receiver changesAndFails([&] {
            document.apply({.page = app::Page{{1, 1}}});
            throw std::bad_alloc();
        });
        QEvent event(QEvent::User);
        QCoreApplication::sendEvent(&fails, &event);
        QVERIFY2(window.message().contains("was not changed"), qPrintable(window.message()));
        QCoreApplication::sendEvent(&changesAndFails, &event);
        QVERIFY2(window.message().startsWith("The step was done"), qPrintable(window.message()));
        QCoreApplication::postEvent(&fails, new QEvent(QEvent::User));
        QCoreApplication::processEvents();
        QVERIFY(window.message().contains("was not changed"));
        application->setWindow(nullptr);
        QCoreApplication::sendEvent(&fails, &event);
        QVERIFY_EXCEPTION_THROWN(
            {
                Receiver other([] { throw std::logic_error("a bug"); });
                QCoreApplication::sendEvent(&other, &event);
            },
            std::logic_error);
    }
};

int main(int argc, char** argv)
{
    if (argc > 2 && QByteArray(argv[1]) == "--editor")
        return runEditor(argc, argv);
    ui::EditorApplication application(argc, argv);
    StartTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "tests/ui/editor/start_test.moc"
