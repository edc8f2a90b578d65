// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/navigation.h"
#include "ui/tiles/sheet_art.h"

#include <QWidget>

namespace ui {

/// The sheets of a drawing: in place, as windows over it, or apart, as they are exported. The wheel
/// zooms, a drag moves the view, a double click fits all sheets into it. A click leaves a sheet out
/// or takes it again; a drag of the edge between two sheets moves the cuts.
class TilesView : public QWidget {
    Q_OBJECT

public:
    enum class Use : std::uint8_t { Full, Overview }; ///< an overview takes no clicks
    TilesView(app::Session& session, app::LiveSheets& sheets, app::SheetArrangement arrangement,
              Use use = Use::Full, QWidget* parent = nullptr);

    app::SheetArrangement arrangement() const { return arrangement_; }
    void arrange(app::SheetArrangement arrangement);
    void tintOverlaps(bool tinted);
    bool tintsOverlaps() const { return tinted_; }
    void fit();
    void zoomBy(double factor);

    /// Where the middle of a sheet is shown, in logical pixels.
    QPointF middleOf(std::size_t sheet) const;
    const SheetArt& art() const { return art_; }
    void settle(); ///< until the picture is up to date

signals:
    void frameShown(const app::FrameTimes& times);
    void hinted(const QString& hint); ///< why a click did nothing

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
    void outdate();
    std::vector<SheetWish> wishes() const;
    void want(); ///< the pictures of the sheets in view, if there are sheets
    SheetWish wishFor(std::size_t sheet, const clipping::Window& shown) const;
    app::Point layoutAt(const QPointF& screen) const;
    std::optional<int> edgeAt(const QPointF& screen) const;
    void showCursor(const QPointF& at);
    void toggle(std::size_t sheet);
    void shift(const QPointF& to);

    app::Session& session_;
    app::LiveSheets& sheets_;
    app::SheetArrangement arrangement_;
    Use use_;
    bool tinted_ = true;
    Navigation navigation_;
    SheetArt art_;
    std::optional<app::SheetLayout> layout_; ///< empty: there are no sheets
    std::uint64_t revision_ = 1;

    /// What the pressed button does once the pointer has moved.
    struct Drag {
        QPointF from, last;
        std::optional<int> edge; ///< the axis along which cuts move; empty: the view moves
        app::Point shift;        ///< at its beginning
        bool moved = false;
    };
    std::optional<Drag> drag_;
};

} // namespace ui
