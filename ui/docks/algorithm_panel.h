// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/agreement.h"
#include "app/session/session.h"

#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QTimer>

namespace ui {

/// Which algorithm clips, in which form, and whether all of them agree on what is seen here. The
/// comparison is made when nothing has changed for a moment; on big drawings when it is asked for.
class AlgorithmPanel : public QWidget {
    Q_OBJECT

public:
    explicit AlgorithmPanel(app::Session& session, QWidget* parent = nullptr);

    void compare(); ///< now
    QString verdict() const { return verdict_->text(); }
    const std::vector<app::Dissent>& dissents() const { return dissents_; }

signals:
    void aboutWanted(const clipping::Algorithm& algorithm); ///< its page is to be shown

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void followWindow();
    void outdate();
    void follow();
    void paintVerdict();

    app::Session& session_;
    QRadioButton *corrected_, *published_;
    QLabel *tick_, *verdict_;
    QPushButton* ask_;
    QTimer idle_;
    clipping::Window window_{};
    std::vector<app::Dissent> dissents_;
};

} // namespace ui
