// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace app {

/// The log of a journal, open for appending. One thread appends; any other may sync.
class LogFile {
public:
    /// A new file, which only the user can read, with these bytes. Null, with the reason in
    /// `error`, if there is no room or no permission.
    static std::shared_ptr<LogFile> create(const QString& path, std::string_view bytes,
                                           QString& error);
    ~LogFile();
    LogFile(const LogFile&) = delete;
    LogFile& operator=(const LogFile&) = delete;

    /// Appends all bytes with one call of the system (with more for a thousand parts), or none.
    /// Returns nothing, or the reason.
    std::optional<QString> append(std::span<const std::string_view> parts);
    std::optional<QString> append(std::string_view bytes) { return append({&bytes, 1}); }
    /// Returns when all appended bytes are on the disk, and the names of the file and its folder;
    /// or the reason why they may not be.
    std::optional<QString> sync();
    const QString& path() const { return path_; }

private:
    LogFile(int file, QString path) : file_(file), path_(std::move(path)) {}
    std::optional<QString> syncNames() const;

    const int file_;
    const QString path_;
    bool named_ = false; ///< the names are on the disk
    std::size_t size_ = 0;
};

/// Writes a file, which only the user can read, completely or not at all, and puts it on the disk.
/// Returns nothing, or the reason.
std::optional<QString> writeWhole(const QString& path, std::string_view bytes);

/// The contents of a file; empty if it cannot be read.
std::string contentsOf(const QString& path, qint64 most = std::numeric_limits<qint64>::max());

/// How far records were followed.
struct Reach {
    std::uint64_t end; ///< the number of the next record
    bool whole;        ///< all bytes of the logs were records, all of which were followed
};
/// Calls follow(record) for each record from number `next` on, in the log of this generation and
/// the following ones, until one is missing or damaged, or follow() returns false.
Reach forEachRecord(const QString& folder, int generation, std::uint64_t next,
                    const std::function<bool(std::string_view)>& follow);

} // namespace app
