// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/signal_text.h"

#include "app/base/text.h"

#include <csignal>
#include <cstring>
#include <map>

namespace app::plug_in {
namespace {

const std::map<int, QString>& reasons()
{
    static const std::map<int, QString> all{
        {SIGSEGV,
         Text::tr("it accessed memory that it does not own, or called itself without end")},
        {SIGBUS, Text::tr("it accessed memory that does not exist")},
        {SIGFPE, Text::tr("it divided an integer by zero")},
        {SIGABRT, Text::tr("it aborted: by abort, a failed assertion or an exception")},
        {SIGILL, Text::tr("it executed an instruction that this processor does not have")},
        {SIGXCPU, Text::tr("it used up its time")},
        {SIGXFSZ, Text::tr("it wrote a file of more than 1 MiB")},
        {SIGTRAP, Text::tr("it stopped at a breakpoint or a sanitizer's trap")},
        {SIGPIPE, Text::tr("it wrote to a closed pipe")},
        {SIGSYS, Text::tr("it made a system call that does not exist")},
        {SIGALRM, Text::tr("a timer that it set ran out")},
        {SIGKILL, Text::tr("it was killed, perhaps because memory ran out")},
    };
    return all;
}

} // namespace

QString signalName(int signal)
{
    if (const char* name = ::sigabbrev_np(signal))
        return QStringLiteral("SIG") + QLatin1StringView(name);
    // The C library reserves some real-time signals below its SIGRTMIN.
    const int offset = signal - SIGRTMIN;
    return QStringLiteral("SIGRTMIN%1%2")
        .arg(offset < 0 ? QStringLiteral("-") : QStringLiteral("+"))
        .arg(std::abs(offset));
}

QString signalText(int signal)
{
    const auto found = reasons().find(signal);
    return found != reasons().end() ? Text::tr("%1 (%2)").arg(found->second, signalName(signal))
                                    : Text::tr("it was ended by %1").arg(signalName(signal));
}

} // namespace app::plug_in
