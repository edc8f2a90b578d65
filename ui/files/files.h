// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut.h"
#include "app/recovery/leftover.h"
#include "app/session/recent_files.h"
#include "app/session/samples.h"
#include "app/session/session.h"
#include "ui/dialogs/questions.h"
#include "ui/widgets/message_strip.h"

#include <QDateTime>

namespace ui {

/// The File menu's functions on one session. Asks about unsaved changes before it replaces them.
/// Reading, cutting and large writes do not block the window.
class Files : public QObject {
    Q_OBJECT

public:
    Files(app::Session& session, QWidget& window, std::unique_ptr<Questions> questions);

    void setQuestions(std::unique_ptr<Questions> questions);

    void startNew(); ///< an empty A3 sheet
    void open();
    void open(const QString& path);
    void openSample(const app::Sample& sample);
    /// Opens a document made by the program; false: the person kept the current one.
    bool openMade(app::Document document, const QString& title);
    bool save(); ///< true: saved
    bool saveAs();
    void exportCut();
    void crop(); ///< undoable
    bool mayClose();
    /// Opens a drawing that an earlier run left, marked as unsaved; false: cancelled, or its file
    /// was unreadable and has been set aside.
    bool recover(app::Leftover& leftover);

    Questions& questions() { return *questions_; }
    app::Origin origin() const; ///< restored with the document after a signal ended the program
    QString name() const;       ///< for the title: the file's, the sample's, or "Untitled"
    QString sample() const { return sample_; } ///< the key of the sample that is open; empty: none
    std::vector<app::RecentFile> recent() const;
    void forgetRecent();

signals:
    void documentWanted(); ///< finish the gesture: the document is about to be saved or replaced
    void told(const ui::Message& message);
    void recentChanged();
    void nameChanged();

private:
    void show(app::Imported imported, const QString& path, const QString& title);
    bool write(const QString& path);
    void noteRecent();
    QString folder() const;
    app::CutOptions cutOptions() const;

    app::Session& session_;
    QWidget& window_;
    std::unique_ptr<Questions> questions_;
    QString title_, sample_;
    QDateTime seen_; ///< the file's modification time when we last read or wrote it
};

} // namespace ui
