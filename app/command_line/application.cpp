// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/application.h"

#include "app/command_line/command.h"

#include <QGuiApplication>
#include <QLoggingCategory>

#include <algorithm>

namespace app {
namespace {

Paints paintsOf(const QStringList& arguments)
{
    const auto all = commands();
    const auto named = std::ranges::find_if(all, [&](const Command& command) {
        return arguments.first() == QLatin1StringView(command.key);
    });
    return named == all.end() ? Paints::Nothing : named->paints;
}

/// Qt tries them from left to right; a display that cannot be reached counts as none.
QByteArray platforms()
{
    const QByteArray asked = qgetenv("QT_QPA_PLATFORM");
    if (!asked.isEmpty())
        return asked + ";offscreen";
    if (!qEnvironmentVariableIsEmpty("DISPLAY"))
        return "xcb;offscreen";
    if (!qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY"))
        return "wayland;offscreen";
    return "offscreen";
}

} // namespace

std::unique_ptr<QCoreApplication> applicationFor(const QStringList& arguments, int& argc,
                                                 char** argv)
{
    const Paints paints = paintsOf(arguments);
    if (paints == Paints::Nothing)
        return std::make_unique<QCoreApplication>(argc, argv);
    // A command reports errors itself; Qt's own warnings concern displays that it does not need.
    QLoggingCategory::setFilterRules(
        QStringLiteral("qt.qpa.*=false\ndefault.warning=false\ndefault.critical=false"));
    qputenv("QT_QPA_PLATFORM", paints == Paints::Letters ? "offscreen" : platforms());
    return std::make_unique<QGuiApplication>(argc, argv);
}

} // namespace app
