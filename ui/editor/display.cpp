// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/display.h"

#include "app/command_line/command.h"
#include "ui/editor/editor_application.h"
#include "ui/look/text.h"
#include "ui/widgets/spoken_role.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <utility>
#include <vector>

#if defined(Q_OS_UNIX)
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace ui {
namespace {

QString instead()
{
    return Text::tr("Start the editor from a desktop. Commands such as clearcut clip IN -o OUT "
                    "need no display; clearcut --help lists them.");
}

/// The display or platform that was requested.
QString whereAsked()
{
    if (const QString platform = qEnvironmentVariable("QT_QPA_PLATFORM"); !platform.isEmpty())
        return Text::tr("the platform “%1” (QT_QPA_PLATFORM)").arg(platform);
    for (const char* variable : {"WAYLAND_DISPLAY", "DISPLAY"})
        if (const QString display = qEnvironmentVariable(variable); !display.isEmpty())
            return Text::tr("the display “%1” (%2)").arg(display, QLatin1StringView(variable));
    return Text::tr("this system");
}

QtMessageHandler handlerBefore = nullptr; // the previous message handler; set before Qt starts

struct HeldMessage {
    QtMsgType type;
    QByteArray category;
    QString text;
};
std::mutex heldMutex; // a platform's plug-in has threads of its own
std::vector<HeldMessage> held;

[[noreturn]] void giveUp()
{
    const QString sentence =
        Text::tr("The editor cannot show a window on %1. %2").arg(whereAsked(), instead());
    std::fprintf(stderr, "clearcut: %s\n", qPrintable(sentence));
    std::_Exit(int(app::Exit::Failed)); // returning from a fatal message aborts
}

// Qt prints many messages about platforms while it tries them, also in the default category; only
// the last one is fatal. So the others are held until it is known that there is a window, and
// those about platforms are dropped. Messages for developers are printed at once.
void whileStarting(QtMsgType type, const QMessageLogContext& context, const QString& text)
{
    if (type == QtFatalMsg)
        giveUp();
    if (type == QtDebugMsg)
        return handlerBefore(type, context, text);
    const bool ofPlatform = QByteArrayView(context.category).startsWith("qt.qpa")
                            || QGuiApplication::platformName().isEmpty();
    const std::scoped_lock one(heldMutex);
    if (!ofPlatform)
        held.push_back({type, context.category, text});
}

} // namespace

QString whyNoDisplay()
{
#if defined(Q_OS_LINUX)
    for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        if (!qEnvironmentVariableIsEmpty(variable))
            return {};
    return Text::tr("There is no display for the editor. %1").arg(instead());
#else
    return {};
#endif
}

std::unique_ptr<EditorApplication> startApplication(int& argc, char** argv)
{
    handlerBefore = qInstallMessageHandler(whileStarting);
    auto application = std::make_unique<EditorApplication>(argc, argv);
    speakRowsInFocus();
    if (QGuiApplication::screens().isEmpty()) // a frame buffer that cannot be opened
        giveUp();
    qInstallMessageHandler(handlerBefore);
    const std::scoped_lock one(heldMutex);
    for (const HeldMessage& message : std::exchange(held, {}))
        handlerBefore(message.type, {nullptr, 0, nullptr, message.category}, message.text);
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
