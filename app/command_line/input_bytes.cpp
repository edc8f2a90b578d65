// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/input_bytes.h"

#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/formats/read_open_file.h"

#include <cerrno>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace app {

InputBytes::InputBytes(const QString& path) : path_(path), file_(path)
{
    const bool isStream = path == QStringLiteral("-");
    if (const auto fault = isStream ? std::nullopt : faultToOpen(path))
        fail(*fault);
    const bool open =
        isStream ? file_.open(STDIN_FILENO, QIODevice::ReadOnly) : file_.open(QIODevice::ReadOnly);
    if (!open)
        fail(file_.errorString() + u'.');
    stopped_ = ::eventfd(0, EFD_CLOEXEC);
}

InputBytes::~InputBytes() { ::close(stopped_); }

std::size_t InputBytes::read(char* bytes, std::size_t size)
{
    std::size_t done = 0;
    while (done < size && isReady(done == 0)) {
        const ssize_t count = ::read(file_.handle(), bytes + done, size - done);
        if (count < 0 && (errno == EINTR || errno == EAGAIN)) // another process may have read them
            continue;
        if (count < 0)
            fail(Text::tr("it cannot be read to its end. %1.").arg(qt_error_string(errno)));
        if (count == 0)
            break;
        done += std::size_t(count);
    }
    return done;
}

void InputBytes::stop() { ::eventfd_write(stopped_, 1); }

// False after `stop`, and if there are no bytes and it does not wait.
bool InputBytes::isReady(bool waits) const
{
    pollfd asked[] = {{file_.handle(), POLLIN, 0}, {stopped_, POLLIN, 0}};
    int count = 0;
    do
        count = ::poll(asked, std::size(asked), waits ? -1 : 0);
    while (count < 0 && errno == EINTR);
    return count != 0 && asked[1].revents == 0;
}

std::optional<std::size_t> InputBytes::size() const
{
    return file_.isSequential() ? std::nullopt : std::optional(std::size_t(file_.size()));
}

void InputBytes::fail(const QString& why) const
{
    if (path_ == QStringLiteral("-"))
        throw Failure{Text::tr("Cannot read standard input: %1").arg(why)};
    throw Failure{(file_.isOpen() ? Text::tr("Cannot read %1: %2") : Text::tr("Cannot open %1: %2"))
                      .arg(path_, why)};
}

} // namespace app
