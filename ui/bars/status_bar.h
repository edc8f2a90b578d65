// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/frame_statistics.h"
#include "ui/canvas/canvas.h"

#include <QElapsedTimer>
#include <QStatusBar>
#include <QTimer>

namespace ui {

class ElidedLabel;
class StatusCell;
class ZoomButton;

/// The tool's hint at the left. At the right, cells as wide as their widest text, so that nothing
/// ever jumps: position, visible and total lines, algorithm, times (medians of 60 frames, shown at
/// most ten times a second), zoom.
class StatusBar : public QStatusBar {
    Q_OBJECT

public:
    StatusBar(app::Session& session, Canvas& canvas, QWidget* parent = nullptr);

    QString times() const; ///< as shown
    QString visibility() const;
    QString position() const;

    void showHint(const QString& hint); ///< empty: show the tool's hint
    void note(const FrameTimes& times); ///< of a frame that is shown
    /// What is shown in place of the drawing, such as "6 sheets, A4"; empty: the drawing is.
    void setSummary(const QString& summary);
    /// Shows the pointer's position in the microscope, formatted like the microscope's numbers.
    void showPoint(std::optional<app::Point> point);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void forgetFrames();
    void showTimes();
    void showPosition(std::optional<app::Point> position);
    void showStep();
    void showParts();
    void showAlgorithm(const app::Variant& variant);
    void explainAlgorithm(); ///< in its tooltip
    void followWindows();
    void showZoom();
    void keepRoom();
    void addZoomMenu();

    app::Session& session_;
    Canvas& canvas_;
    ElidedLabel* hint_;
    StatusCell *position_, *visible_, *algorithm_, *times_, *renderer_;
    ZoomButton* zoom_;
    app::FrameStatistics clip_, draw_;
    FrameTimes last_;
    QString summary_;
    QTimer pause_;
};

} // namespace ui
