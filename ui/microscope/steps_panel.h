// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/microscope.h"
#include "ui/microscope/playback.h"

#include <QComboBox>
#include <QLabel>
#include <QToolButton>

namespace ui {

class Legend;
class Timeline;

/// Says in one sentence what happens at the step; below are the step and play buttons and the
/// timeline. If the panel is low, it drops the legend first.
class StepsPanel : public QWidget {
    Q_OBJECT

public:
    explicit StepsPanel(app::Microscope& microscope, QWidget* parent = nullptr);

    Playback& playback() { return playback_; }
    QString sentence() const { return sentence_->text(); }
    QString count() const { return count_->text(); } ///< "11 of 13"

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QToolButton* addButton(const char* icon, const QString& name, const QString& key);
    void addSpeeds();
    void layOut();
    void showStep();
    void showPlaying();
    int heightWithoutLegend() const;

    app::Microscope& microscope_;
    Playback playback_;
    QLabel *sentence_, *count_, *keys_;
    QList<QToolButton*> buttons_; ///< first, previous, play, next, last
    QComboBox* speed_;
    Timeline* timeline_;
    Legend* legend_;
    QWidget* foot_;
};

} // namespace ui
