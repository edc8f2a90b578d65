// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"
#include "app/recovery/leftover.h"

#include <QString>

#include <functional>

class QWidget;

class QPrinter;

namespace ui {

class MessageStrip;

/// All questions about files, as dialogs over a window, or in its strip. Tests override its
/// functions.
class Questions {
public:
    /// What is asked in the strip is never asked without one.
    explicit Questions(QWidget& window, MessageStrip* strip = nullptr)
        : window_(window), strip_(strip)
    {
    }
    virtual ~Questions() = default;

    enum class Answer : std::uint8_t { Save, DontSave, Cancel };

    /// A file to read; empty: cancelled.
    virtual QString fileToOpen(const QString& folder);
    /// A path to write a drawing to, a table, a chart or a report; empty: cancelled. `kind` names
    /// it in the dialog; `ending` is the file extension, added if there is none.
    virtual QString fileToWrite(const QString& title, const QString& proposal, const QString& kind,
                                const QString& ending);
    /// The same for several files whose names have a common prefix. No file has exactly the chosen
    /// name, so this does not ask about overwriting.
    virtual QString filesToWrite(const QString& title, const QString& proposal, const QString& kind,
                                 const QString& ending);
    /// A folder to write files of given names to; empty: cancelled.
    virtual QString folderToWrite(const QString& title, const QString& folder);
    /// Lesson files; empty: cancelled.
    virtual QStringList lessonsToOpen(const QString& folder);
    /// A folder of lesson files; empty: cancelled.
    virtual QString lessonFolderToOpen(const QString& folder);
    /// A shared library; empty: cancelled.
    virtual QString libraryToOpen(const QString& folder);
    /// The library is about to be run for the first time, with all of the person's rights; true:
    /// run it.
    virtual bool trustLibrary(const QString& path);
    /// Whether a printer is set up.
    virtual bool hasPrinter();
    /// Lets the person choose a printer, and its paper; false: cancelled.
    virtual bool choosePrinter(QPrinter& printer);
    /// Some of the `all` files to be written exist; true: overwrite them.
    virtual bool overwriteFiles(const QStringList& existing, int all);
    /// Asks in the strip; `answered` is called later, unless the window is destroyed before.
    virtual void saveChanges(const QString& name, std::function<void(Answer)> answered);
    void endSaveChanges(Answer answer); ///< answers the question if it is open
    /// Saving would make the losses of an import permanent; true: save as a new file.
    virtual bool saveAsNewFile(const std::vector<app::Loss>& losses);
    virtual void showLosses(const QString& name, const std::vector<app::Loss>& losses);
    /// Another program changed the file after it was opened. Reload gives up the unsaved changes.
    enum class ChangedFile : std::uint8_t { Overwrite, Reload, Cancel };
    virtual ChangedFile aboutChangedFile(const QString& path);

    /// An earlier run ended before a drawing was saved, and `more` others. Asks in the strip, as
    /// saveChanges().
    enum class Leftover : std::uint8_t { Recover, Discard, Later };
    virtual void aboutLeftover(const app::Leftover& leftover, std::size_t more,
                               std::function<void(Leftover)> answered);

private:
    QWidget& window_;
    MessageStrip* strip_;
    int saveChanges_ = 0; ///< the last such question in the strip
};

} // namespace ui
