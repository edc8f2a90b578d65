// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/window_needs.h"
#include "app/view/frame_times.h"
#include "ui/canvas/controller.h"

#include <QTimer>
#include <QToolButton>

namespace ui {

/// The heading of a pane: marker, abbreviation, name and form of its algorithm, and the median of
/// its last clip times, shown at most ten times a second. A menu chooses another algorithm. A blue
/// line marks the active pane.
class PaneHeading : public QWidget {
    Q_OBJECT

public:
    explicit PaneHeading(QWidget* parent);
    ~PaneHeading() override;

    void show(const Pane& pane);
    /// What the clip windows demand: an algorithm that cannot clip there is dimmed, and the heading
    /// says what is used instead.
    void setNeeds(app::WindowNeeds needs);
    /// What it says where the algorithm leaves the windows `left` alone, with their names: where it
    /// clips, empty if nowhere. Without such windows it says what is used instead.
    void setLimits(const QString& where, const QString& left);
    QString remark() const { return nameText(); } ///< as shown after the abbreviation
    void note(const app::FrameTimes& times);
    QString time() const { return time_; } ///< as shown
    void openMenu();

signals:
    void pressed();
    void chosen(const app::Variant& choice);
    void useWanted(); ///< let its algorithm cut
    void closeWanted();
    void aloneWanted(); ///< close all other panes

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool event(QEvent* event) override;

private:
    /// The places of the parts, from left to right; a part without room has an invalid rectangle.
    struct Places {
        QRect marker, abbreviation, name, form, choose, time, close;
    };
    Places places() const;
    QString formText() const;
    void place();
    void showTime();
    void fill(QMenu& menu);
    void addChoice(QMenu& menu, const app::Variant& choice);

    QString nameText() const;
    void followNeeds();
    bool clips() const; ///< anywhere
    app::Variant used() const;

    std::optional<Pane> pane_;
    app::WindowNeeds needs_ = app::WindowNeeds::Rectangle;
    QString where_, left_;
    QToolButton *choose_, *close_;
    app::FrameStatistics clip_;
    app::FrameTimes last_;
    QString time_;
    QTimer pause_;
};

} // namespace ui
