// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/hard_case.h"
#include "app/session/session.h"
#include "clipping/algorithm.h"
#include "ui/dialogs/questions.h"
#include "ui/widgets/message_strip.h"

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QTextDocument>
#include <QToolButton>

namespace ui {

class ElidedLabel;
class PageView;

/// The pages about the algorithms: a list of algorithms at the left, a page at the right. Not
/// modal: the editor stays usable.
class ExplanationWindow : public QDialog {
    Q_OBJECT

public:
    /// Opens examples in the microscope of `session`, and brings the editor's `window` to the
    /// front.
    ExplanationWindow(app::Session& session, QWidget& window);
    ~ExplanationWindow() override;

    /// Replaces the dialogs; used by tests.
    void setQuestions(std::unique_ptr<Questions> questions);
    void show(const clipping::Algorithm& algorithm);
    void showManual(const QString& topic);
    void showManual(); ///< the page of the manual that was read last, or its index
    PageView& page() { return *page_; }

signals:
    void hardCaseWanted(const app::HardCase& hard);
    void failingWanted(const QString& variant); ///< the cases that this variant gets wrong

protected:
    void hideEvent(QHideEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* bar();
    QWidget* finder();
    QToolButton* button(std::string_view icon, const QString& text, const QKeySequence& keys);
    void follow(const QUrl& link);
    void find(QTextDocument::FindFlags direction);
    void stopFinding();
    void savePdf();
    void showPlace();

    app::Session& session_;
    QWidget& window_;
    std::unique_ptr<Questions> questions_;
    QListView* list_;
    PageView* page_;
    QWidget* finder_ = nullptr;
    QLineEdit* wanted_;
    ElidedLabel* found_;
    MessageStrip* strip_;
    QToolButton *back_ = nullptr, *forward_ = nullptr;
    QToolButton *contents_ = nullptr, *look_ = nullptr; ///< on pages of the manual; of algorithms
    QString topic_;                                     ///< of the manual, read last
};

} // namespace ui
