// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/terminal.h"

#include "app/command_line/command.h"
#include "app/command_line/refusal.h"

#include <csignal>
#include <cstdio>
#include <cstring>
#include <unistd.h>

namespace app {

void print(const QString& text)
{
    const QByteArray bytes = text.toUtf8();
    const auto size = std::size_t(bytes.size());
    if (std::fwrite(bytes.data(), 1, size, stdout) != size || std::fflush(stdout) != 0)
        throw Failure{Commands::tr("Cannot write standard output: %1.")
                          .arg(QString::fromLocal8Bit(std::strerror(errno)))};
}

void say(const QString& line) { std::fputs((line + u'\n').toUtf8().constData(), stderr); }

void answerSignals()
{
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGINT, [](int) { ::_exit(int(Exit::Interrupted)); });
}

} // namespace app
