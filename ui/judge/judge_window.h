// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "app/judge/judge.h"
#include "app/session/session.h"
#include "ui/dialogs/questions.h"
#include "ui/widgets/message_strip.h"

#include <QCheckBox>
#include <QDateTime>
#include <QDialog>
#include <QFileSystemWatcher>
#include <QStackedWidget>
#include <QTimer>

namespace ui {

class ProgressRow;
class VerdictView;

/// Judges the user's own algorithm: the library at the top, the verdict below, progress at the
/// bottom. Not modal: the editor stays usable. A rebuilt library is judged again.
class JudgeWindow : public QDialog {
    Q_OBJECT

public:
    explicit JudgeWindow(app::Session& session, QWidget* parent = nullptr);
    ~JudgeWindow() override;

    /// Replaces the dialogs and the program of the child process; used by tests.
    void setQuestions(std::unique_ptr<Questions> questions) { questions_ = std::move(questions); }
    void setProgram(const QString& program) { program_ = program; }

    const app::plug_in::Verdict* verdict() const;
    bool judging() const { return judging_.active(); }

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void layOut();
    QWidget* top();
    QWidget* invitation();
    void choose();
    void saveExample();
    void take(const QString& path);
    void run();
    void cancel();
    void finish(app::plug_in::Verdict verdict);
    void showProgress(const app::Progress& progress);
    void followFile();
    void lookAt(const app::plug_in::Finding& finding);
    void showState();

    app::Session& session_;
    std::unique_ptr<Questions> questions_;
    QString program_, path_;
    QDateTime written_; ///< modification time of the last judged library
    QPushButton *choose_, *again_, *example_, *copy_;
    QCheckBox *follow_, *strict_;
    QLabel* file_;
    ProgressRow* progress_;
    MessageStrip* strip_;
    QStackedWidget* stack_;
    VerdictView* view_;
    QFileSystemWatcher watcher_;
    QTimer settled_; ///< waits until the compiler has finished writing the file
    app::Background<std::optional<app::plug_in::Verdict>> judging_;
};

} // namespace ui
