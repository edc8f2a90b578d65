// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

namespace app {

/// Watches the file of the open drawing, and says when another program changed or removed it. Also
/// notices files that are replaced by renaming another one. Where the system cannot watch a file,
/// nothing is said.
class FileWatch : public QObject {
    Q_OBJECT

public:
    /// A change is reported when the file has been left alone for this time: a program that
    /// replaces a file may remove it first, and one that writes it may take a while.
    static constexpr std::chrono::milliseconds rest{200};

    explicit FileWatch(QObject* parent = nullptr);

    /// From now on, a change of this file after `known` is reported, each once.
    void follow(const QString& path, const QDateTime& known);
    void pause(); ///< until follow(): the program itself writes

signals:
    void changed();
    void removed(); ///< it was deleted, renamed or moved

private:
    void watch();
    void look();

    QFileSystemWatcher watcher_;
    QTimer rest_;
    QString path_;
    QDateTime known_; ///< the file's last change that needs no report; invalid: it does not exist
};

} // namespace app
