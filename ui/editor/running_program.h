// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include <functional>
#include <memory>

class QLocalServer;

namespace ui {

/// Where the running program listens: a socket in the user's runtime folder, one for each display.
/// Empty, and nobody listens, if there is no such folder, or if others have access to it.
QString socketOfProgram();
/// The same in this folder for this display.
QString socketIn(const QString& folder, const QByteArray& display);

/// Asks the program that listens at `socket` to open files (absolute paths; none: to come to the
/// front). Refused: it did not answer within two seconds, or is being quit.
enum class HandedOver : std::uint8_t { Taken, Refused, NobodyIsThere };
HandedOver handOver(const QString& socket, const QStringList& files);
/// Whether a program listens there, without a message to it.
bool isSomebodyAt(const QString& socket);

/// The running program's end: takes files from those that are started later.
class Listener : public QObject {
    Q_OBJECT

public:
    /// To be made if nobody is there. What a program that crashed left is removed.
    explicit Listener(const QString& socket, QObject* parent = nullptr);
    /// Whether files are taken now; always, unless this is set.
    void setAccepting(std::function<bool()> accepting) { accepting_ = std::move(accepting); }
    ~Listener() override;

signals:
    void wanted(const QStringList& files); ///< absolute paths; may be none

private:
    void answer();

    std::unique_ptr<QLocalServer> server_;
    std::function<bool()> accepting_;
};

} // namespace ui
