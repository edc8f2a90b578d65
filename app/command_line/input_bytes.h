// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>

namespace app {

/// The bytes of a command's input, a file or - for standard input, as they come. All functions
/// throw Failure.
class InputBytes {
public:
    explicit InputBytes(const QString& path);
    ~InputBytes();

    /// Waits until there are bytes, and reads those that can be had without waiting again, up to
    /// `size`. Returns 0 at the end, or after `stop`.
    std::size_t read(char* bytes, std::size_t size);

    /// Makes `read` return 0 from now on, also if it waits on another thread.
    void stop();

    /// The size of a file; empty for a pipe or device.
    std::optional<std::size_t> size() const;

    /// The failure with this reason, which names the input.
    [[noreturn]] void fail(const QString& why) const;

private:
    bool isReady(bool waits) const;

    QString path_;
    QFile file_;
    int stopped_ = -1; ///< an eventfd, which `poll` can wait for
};

} // namespace app
