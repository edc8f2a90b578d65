// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QSettings>
#include <QString>

#include <optional>
#include <vector>

namespace app {

/// A drawing that was opened or saved.
struct RecentFile {
    QString path; ///< absolute
    std::size_t lines = 0;
    QDateTime when;
    bool missing() const;
    friend bool operator==(const RecentFile&, const RecentFile&) = default;
};

constexpr std::size_t mostRecentFiles = 10;

/// The newest first, each path once.
std::vector<RecentFile> recentFiles(const QSettings& settings);
void remember(QSettings& settings, const RecentFile& file);
void forgetRecentFiles(QSettings& settings);

/// "today", "yesterday", "18 Nov", "18 Nov 2025".
QString dayText(const QDate& day, const QDate& today);

} // namespace app
