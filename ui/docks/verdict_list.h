// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/race/race_verdict.h"

#include <QScrollArea>

namespace ui {

class IconSign;
class LookLabel;

/// The statements about a race, each a paragraph with a sign. Nothing is elided.
class VerdictList : public QWidget {
    Q_OBJECT

public:
    explicit VerdictList(QWidget* parent = nullptr);

    void show(std::vector<app::RaceStatement> statements);
    using QWidget::show;
    QString text() const; ///< of all paragraphs, each on a line
    int lineHeight() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Paragraph {
        QWidget* row;
        IconSign* sign;
        LookLabel* text;
    };
    Paragraph added();
    void paint();

    std::vector<app::RaceStatement> statements_;
    std::vector<Paragraph> paragraphs_; ///< those without a statement are hidden
};

/// Scrolls a verdict where there is no room for it: with the keys, too.
class VerdictArea : public QScrollArea {
    Q_OBJECT

public:
    explicit VerdictArea(VerdictList* verdict);

protected:
    bool event(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
};

} // namespace ui
