// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/live_export.h"
#include "app/view/live_picture.h"
#include "ui/canvas/navigation.h"

#include <QWidget>

namespace ui {

/// The paper with what is written on it, and nothing else. A drag moves it, the wheel zooms, a
/// double click shows all of it.
class ExportView : public QWidget {
    Q_OBJECT

public:
    ExportView(app::Session& session, std::shared_ptr<app::LiveExport> live,
               QWidget* parent = nullptr);

    enum class Size : std::uint8_t {
        True, ///< a millimetre on paper is one on the screen
        Whole ///< all of the paper
    };
    void showAt(Size size);
    std::optional<Size> sizeShown() const; ///< empty: any other one
    /// Shows these sheets of paper, in the drawing's coordinates, in place of the one that is
    /// written.
    void setPapers(std::vector<clipping::Window> papers);
    void settle(); ///< until the picture is up to date
    const app::View& view() const { return navigation_.view(); }

signals:
    void sizeChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void follow();
    void fitOther();
    void want(std::chrono::microseconds patience);
    app::FrameWish wish() const;
    clipping::Window paper() const; ///< all of it
    QRectF onScreen(const clipping::Window& rectangle) const;
    void paintPapers(QPainter& painter) const;
    double trueZoom() const;
    void paintPaper(QPainter& painter, const QRectF& paper) const;
    void paintSizes(QPainter& painter, const QRectF& paper) const;
    void paintScale(QPainter& painter, const QRectF& paper) const;

    app::Session& session_;
    std::shared_ptr<app::LiveExport> live_;
    std::shared_ptr<const app::LiveExport::Made> made_; ///< that is shown; null: nothing is
    std::vector<clipping::Window> papers_;
    Navigation navigation_;
    std::optional<clipping::Window> fitted_; ///< the last paper that was fitted
    app::LivePicture picture_;
    std::uint64_t revision_ = 1;
    std::optional<QPointF> dragged_; ///< where the pointer was last
};

} // namespace ui
