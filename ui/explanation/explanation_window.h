// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/hard_case.h"
#include "app/session/session.h"
#include "app/teaching/help_search.h"
#include "app/teaching/manual.h"
#include "clipping/algorithm.h"
#include "ui/dialogs/questions.h"
#include "ui/widgets/message_strip.h"

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QTextDocument>
#include <QToolButton>

namespace ui {

class ElidedLabel;
class HelpContents;
class PageView;

/// The help: its contents and their search at the left, a page at the right. Not modal: the editor
/// stays usable. It stands over the editor's panels at first.
class ExplanationWindow : public QDialog {
    Q_OBJECT

public:
    /// Opens examples in the microscope of `session`. Stands beside the editor's `window` at first.
    ExplanationWindow(app::Session& session, QWidget& window);
    ~ExplanationWindow() override;

    /// Replaces the dialogs; used by tests.
    void setQuestions(std::unique_ptr<Questions> questions);
    void show(const clipping::Algorithm& algorithm);
    void showManual(const QString& topic);
    /// The page of what is in hand. It follows what is taken in hand later, until another page is
    /// chosen.
    void showInHand(const QString& topic);
    void takeInHand(const QString& topic);               ///< if the page follows it
    void setCommands(const app::HelpCommands& commands); ///< by which pages are found
    PageView& page() { return *page_; }
    void tell(const QString& warning); ///< below the page; empty: nothing

signals:
    void showWanted(const app::ManualPage& page); ///< its steps, in a drawing of their own
    void editorWanted();                          ///< in front, with its microscope
    void hardCaseWanted(const app::HardCase& hard);
    void failingWanted(const QString& variant); ///< the cases that this variant gets wrong

protected:
    void hideEvent(QHideEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* bar();
    QWidget* finder();
    QWidget* foot();
    QToolButton* button(std::string_view icon, const QString& text, const QKeySequence& keys);
    void follow(const QUrl& link);
    void find(QTextDocument::FindFlags direction);
    void stopFinding();
    void savePdf();
    void showPlace();

    app::Session& session_;
    std::unique_ptr<Questions> questions_;
    HelpContents* contents_;
    PageView* page_;
    QWidget* finder_ = nullptr;
    QLineEdit* wanted_;
    ElidedLabel* found_;
    MessageStrip* strip_;
    QToolButton *back_ = nullptr, *forward_ = nullptr;
    QToolButton* look_ = nullptr; ///< on pages of algorithms
    QWidget* foot_ = nullptr;     ///< on pages whose steps can be shown
    ElidedLabel* where_;
    QString inHand_; ///< the page that follows what is in hand; empty: none does
};

} // namespace ui
