// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>

namespace app {

/// The bytes of a command's input, a file or - for standard input, as they come. All functions
/// throw Failure.
class InputBytes {
public:
    explicit InputBytes(const QString& path);

    /// Waits until there are bytes, and reads those that can be had without waiting again, up to
    /// `size`. Returns 0 at the end.
    std::size_t read(char* bytes, std::size_t size);

    /// The size of a file; empty for a pipe or device.
    std::optional<std::size_t> size() const;

    /// The failure with this reason, which names the input.
    [[noreturn]] void fail(const QString& why) const;

private:
    QString path_;
    QFile file_;
};

} // namespace app
