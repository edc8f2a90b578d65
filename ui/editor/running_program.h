// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include <memory>

class QLocalServer;

namespace ui {

/// Where the running program listens: a socket in the user's runtime folder, one for each display.
/// Empty, and nobody listens, if there is no such folder, or if others have access to it.
QString socketOfProgram();

/// Asks the program that listens at `socket` to open files (absolute paths; none: to come to the
/// front). False: nobody listens, or nobody answered within two seconds.
bool handOver(const QString& socket, const QStringList& files);

/// The running program's end: takes files from those that are started later.
class Listener : public QObject {
    Q_OBJECT

public:
    /// Listens, unless somebody else does. What a program that crashed left is removed.
    explicit Listener(const QString& socket, QObject* parent = nullptr);
    ~Listener() override;

signals:
    void wanted(const QStringList& files); ///< absolute paths; may be none

private:
    void answer();

    std::unique_ptr<QLocalServer> server_;
};

} // namespace ui
