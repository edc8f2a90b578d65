// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/progress_line.h"

#include "app/command_line/refusal.h"

#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace app {
namespace {

constexpr auto empty = "\r\x1b[K"; // to the line's start, and erase it

} // namespace

ProgressLine::~ProgressLine()
{
    if (shown_ >= 0)
        std::fputs(empty, stderr);
}

void ProgressLine::show(const Progress& progress)
{
    const int percent = int(100 * progress.share);
    if (percent == shown_ || ::isatty(STDERR_FILENO) == 0)
        return;
    shown_ = percent;
    const QString text =
        Commands::tr("%1 %, %2 s left").arg(percent).arg(qint64(std::ceil(progress.secondsLeft)));
    std::fputs((QLatin1StringView(empty) + text).toUtf8().constData(), stderr);
}

} // namespace app
