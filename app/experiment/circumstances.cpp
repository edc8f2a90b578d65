// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/circumstances.h"

#include "app/base/text.h"

#include <QFile>
#include <QSysInfo>
#include <QThread>

namespace app {
namespace {

/// The first "KEY : VALUE" of a file of the Linux kernel.
QString fromKernel(const QString& path, const QByteArray& key)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const auto lines = file.readAll().split('\n');
    for (const QByteArray& line : lines)
        if (line.startsWith(key))
            return QString::fromUtf8(line.mid(line.indexOf(':') + 1)).simplified();
    return {};
}

QString processor()
{
    QString name = fromKernel(QStringLiteral("/proc/cpuinfo"), "model name");
    if (name.isEmpty())
        name = QSysInfo::currentCpuArchitecture();
    return Text::tr("%1, %n core(s)", nullptr, QThread::idealThreadCount()).arg(name);
}

QString compiler()
{
#ifdef __clang__
    return QStringLiteral("Clang " __clang_version__);
#elif defined(__GNUC__)
    return QStringLiteral("GCC " __VERSION__);
#else
    return Text::tr("unknown");
#endif
}

} // namespace

std::vector<std::pair<QString, QString>> circumstances()
{
    return {
        {"processor", processor()},
        {"memory", fromKernel(QStringLiteral("/proc/meminfo"), "MemTotal").replace(" kB", " KiB")},
        {"system", QSysInfo::prettyProductName() + QStringLiteral(", ") + QSysInfo::kernelType()
                       + u' ' + QSysInfo::kernelVersion()},
        {"compiler", compiler()},
        {"flags", QStringLiteral(CLEARCUT_FLAGS)},
        {"clearcut", QStringLiteral(CLEARCUT_VERSION)},
        {"qt", QLatin1StringView(qVersion())},
    };
}

} // namespace app
