// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/input_bytes.h"

#include "app/command_line/refusal.h"
#include "app/formats/read_open_file.h"

#include <cerrno>
#include <poll.h>
#include <unistd.h>

namespace app {
namespace {

bool isReady(int file)
{
    pollfd asked{file, POLLIN, 0};
    return ::poll(&asked, 1, 0) > 0;
}

} // namespace

InputBytes::InputBytes(const QString& path) : path_(path), file_(path)
{
    const bool isStream = path == QStringLiteral("-");
    if (const auto fault = isStream ? std::nullopt : faultToOpen(path))
        fail(*fault);
    const bool open =
        isStream ? file_.open(STDIN_FILENO, QIODevice::ReadOnly) : file_.open(QIODevice::ReadOnly);
    if (!open)
        fail(file_.errorString() + u'.');
}

std::size_t InputBytes::read(char* bytes, std::size_t size)
{
    std::size_t done = 0;
    while (done < size && (done == 0 || isReady(file_.handle()))) {
        const ssize_t count = ::read(file_.handle(), bytes + done, size - done);
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            fail(Commands::tr("it cannot be read to its end. %1.").arg(qt_error_string(errno)));
        if (count == 0)
            break;
        done += std::size_t(count);
    }
    return done;
}

std::optional<std::size_t> InputBytes::size() const
{
    return file_.isSequential() ? std::nullopt : std::optional(std::size_t(file_.size()));
}

void InputBytes::fail(const QString& why) const
{
    throw Failure{path_ == QStringLiteral("-")
                      ? Commands::tr("Cannot read standard input: %1").arg(why)
                      : Commands::tr("Cannot open %1: %2").arg(path_, why)};
}

} // namespace app
