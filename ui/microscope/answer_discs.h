// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/stage_answers.h"
#include "app/practice/practice.h"

#include <QWidget>

class QMouseEvent;

namespace ui {

class MicroscopeView;

/// The answers of a lesson's question on the figure, or the edges of a move: numbered discs beside
/// its parts. A click at a
/// part or its disc answers; the part under the pointer is lit, whether right or wrong. It lies
/// over the view, which gets all other events of the pointer.
class AnswerDiscs : public QWidget {
    Q_OBJECT

public:
    AnswerDiscs(app::Course& course, app::Practice& practice, MicroscopeView& view);

    const std::vector<app::StageAnswer>& answers() const { return answers_; }
    std::optional<int> hovered() const { return hovered_; }

signals:
    void answered(); ///< by a click

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow();
    bool asks() const;
    void choose(int choice);
    void hover(std::optional<int> choice);
    std::optional<int> choiceAt(const QMouseEvent& event) const;
    void paint(QPainter& painter, const app::StageAnswer& answer) const;

    app::Course& course_;
    app::Practice& practice_;
    MicroscopeView& view_;
    std::vector<app::StageAnswer> answers_;
    std::optional<int> hovered_, pressed_;
};

} // namespace ui
