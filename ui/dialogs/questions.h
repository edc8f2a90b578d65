// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"
#include "app/recovery/leftover.h"

#include <QString>

class QWidget;

namespace ui {

/// Everything that has to be asked about files, as dialogs over a window. Tests answer in its
/// place.
class Questions {
public:
    explicit Questions(QWidget& window) : window_(window) {}
    virtual ~Questions() = default;

    enum class Answer : std::uint8_t { Save, DontSave, Cancel };
    enum class Formats : std::uint8_t { Native, All };

    /// Files to read; empty: cancelled.
    virtual QString fileToOpen(const QString& folder);
    /// Where to write, one of all formats that can be or of the native one; empty: cancelled. An
    /// ending is added where there is none.
    virtual QString fileToSave(const QString& title, const QString& proposal, Formats which);
    /// Where to write something that is no drawing: a table, a chart, a report. `kind` is what it
    /// is called, `ending` what its name ends with, which is added where there is none.
    virtual QString fileToWrite(const QString& title, const QString& proposal, const QString& kind,
                                const QString& ending);
    /// The same for several files whose names begin alike: no one file of that name is written, so
    /// none is asked about.
    virtual QString filesToWrite(const QString& title, const QString& proposal, const QString& kind,
                                 const QString& ending);
    /// A folder to write files of given names to; empty: cancelled.
    virtual QString folderToWrite(const QString& title, const QString& folder);
    /// A shared library; empty: cancelled.
    virtual QString libraryToOpen(const QString& folder);
    /// It is about to be run for the first time, with all rights of the person; true: do it.
    virtual bool trustLibrary(const QString& path);
    /// Some of the files that are about to be written exist; true: overwrite them.
    virtual bool overwriteFiles(const QStringList& existing, int all);
    virtual Answer saveChanges(const QString& name);
    /// What an import lost is about to be lost for good; true: save as a new file.
    virtual bool saveAsNewFile(const std::vector<app::Loss>& losses);
    virtual void showLosses(const QString& name, const std::vector<app::Loss>& losses);
    /// Another program changed the file after it was opened; true: overwrite it.
    virtual bool overwriteChanged(const QString& path);

    /// Earlier runs were ended before these were saved: what to do with one of them.
    struct LeftoverAnswer {
        enum class Verb : std::uint8_t { Recover, Discard, Later };
        Verb verb = Verb::Later;
        std::size_t which = 0; ///< not for Later
    };
    virtual LeftoverAnswer aboutLeftovers(const std::vector<app::Leftover>& leftovers);

private:
    QWidget& window_;
};

} // namespace ui
