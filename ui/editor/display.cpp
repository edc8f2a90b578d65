// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/display.h"

#include "app/command_line/command.h"
#include "ui/editor/editor_application.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#if defined(Q_OS_UNIX)
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace ui {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("Display", text); }

QString instead()
{
    return tr("Start the editor from a desktop, or use a command that needs no display, such as "
              "clearcut clip IN -o OUT (clearcut --help lists all commands).");
}

/// The display or platform that was requested.
QString whereAsked()
{
    if (const QString platform = qEnvironmentVariable("QT_QPA_PLATFORM"); !platform.isEmpty())
        return tr("the platform “%1” (QT_QPA_PLATFORM)").arg(platform);
    for (const char* variable : {"WAYLAND_DISPLAY", "DISPLAY"})
        if (const QString display = qEnvironmentVariable(variable); !display.isEmpty())
            return tr("the display “%1” (%2)").arg(display, QLatin1StringView(variable));
    return tr("this system");
}

QtMessageHandler handlerBefore = nullptr; // the previous message handler; set before Qt starts

// Qt prints many messages about platforms while it tries them; only the last one is fatal.
void whileStarting(QtMsgType type, const QMessageLogContext& context, const QString& text)
{
    if (type == QtFatalMsg) {
        const QString sentence =
            tr("The editor cannot show a window on %1. %2").arg(whereAsked(), instead());
        std::fprintf(stderr, "clearcut: %s\n", qPrintable(sentence));
        std::_Exit(int(app::Exit::Failed)); // returning from a fatal message aborts
    }
    if (!QByteArrayView(context.category).startsWith("qt.qpa"))
        handlerBefore(type, context, text);
}

} // namespace

QString whyNoDisplay()
{
#if defined(Q_OS_LINUX)
    for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        if (!qEnvironmentVariableIsEmpty(variable))
            return {};
    return tr("There is no display for the editor. %1").arg(instead());
#else
    return {};
#endif
}

std::unique_ptr<EditorApplication> startApplication(int& argc, char** argv)
{
    handlerBefore = qInstallMessageHandler(whileStarting);
    auto application = std::make_unique<EditorApplication>(argc, argv);
    qInstallMessageHandler(handlerBefore);
    return application;
}

// A desktop gives its programs no input, and writes their messages to a file or a socket.
bool isErrorRead()
{
#if defined(Q_OS_UNIX)
    constexpr std::array streams{STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO};
    return std::ranges::any_of(streams, [](int stream) {
        struct stat found {};
        return ::isatty(stream) != 0 || (::fstat(stream, &found) == 0 && S_ISFIFO(found.st_mode));
    });
#else
    return true;
#endif
}

} // namespace ui
