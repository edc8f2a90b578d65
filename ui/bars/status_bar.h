// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/frame_times.h"
#include "ui/canvas/canvas.h"

#include <QElapsedTimer>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>

namespace ui {

class ElidedLabel;
class StatusCell;
class WarningButton;
class ZoomButton;

/// The tool's hint at the left. At the right, a warning as long as work is not protected, and cells
/// as wide as their widest text, so that nothing ever jumps: position, visible and total lines,
/// algorithm, times (shown at most ten times a second), zoom; in the dark theme the switch for dark
/// paper.
class StatusBar : public QStatusBar {
    Q_OBJECT

public:
    StatusBar(app::Session& session, Canvas& canvas, QWidget* parent = nullptr);

    QString times() const; ///< as shown
    QString visibility() const;
    QString position() const;

    /// Empty: the tool's hint. Adds that digits choose the algorithm, if they do and if it fits.
    void showHint(const QString& hint);
    void note(const app::FrameTimes& times); ///< of a frame that is shown
    /// Why unsaved work would be lost in a crash; empty: it would not. Shown until then.
    void warn(const QString& sentence);
    /// What is shown in place of the drawing, such as "6 sheets, A4"; empty: the drawing is.
    void setSummary(const QString& summary);
    /// Shows the pointer's position in the microscope, formatted like the microscope's numbers.
    void showPoint(std::optional<app::Point> point);

signals:
    void warningWanted(const QString& sentence); ///< the warning was pressed: say it again
    /// The time of clipping, empty if there are too few lines, and how many are seen to differ.
    void timed(const QString& clip, std::size_t differing);

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void forgetFrames();
    void showTimes();
    void explainTimes();
    void showPosition(std::optional<app::Point> position);
    void showStep();
    void showParts();
    void showAlgorithm(const app::Variant& variant);
    void explainAlgorithm(); ///< in its tooltip
    void followWindows();
    bool leavesAlone() const;
    void showZoom();
    void keepRoom();
    void keepRoomForLines();
    void addPaperSwitch();
    void followPaper();
    void addZoomMenu();

    app::Session& session_;
    Canvas& canvas_;
    ElidedLabel* hint_;
    WarningButton* warning_;
    StatusCell *position_, *visible_, *algorithm_, *times_, *renderer_;
    QToolButton* darkPaper_;
    ZoomButton* zoom_;
    app::FrameStatistics clip_;
    app::FrameTimes last_;
    QString summary_;
    QString said_; ///< by showHint()
    QTimer pause_;
};

} // namespace ui
