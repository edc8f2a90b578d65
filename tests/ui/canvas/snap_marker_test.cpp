// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look.h"

#include <QFrame>

#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"

namespace canvas_snap_marker_test {

// The marker where the pointer snaps, as it is painted.
class SnapMarkerTest : public QObject {
    Q_OBJECT

    static bool has(const QImage& picture, const QColor& colour, const QRect& where)
    {
        for (int y = where.top(); y <= where.bottom(); ++y)
            for (int x = where.left(); x <= where.right(); ++x)
                if (picture.valid(x, y) && picture.pixelColor(x, y) == colour)
                    return true;
        return false;
    }
    static QRect around(const QPoint& at, int reach)
    {
        return {at.x() - reach, at.y() - reach, 2 * reach + 1, 2 * reach + 1};
    }

private slots:
    void theMarkerIsAtTheEndAndNamesItsKind()
    {
        Stage stage(ui::Backend::Raster);
        stage.canvas->setTool("line");
        const ui::Look& look = ui::lookOf(stage.canvas->palette());
        stage.move({60, 60});
        QVERIFY(!has(stage.picture(), look.guideGround, stage.surface().rect()));
        QCOMPARE(stage.surface().cursor().shape(), Qt::CrossCursor);
        stage.move({12, 52});
        const QPoint end = stage.at({10, 50});
        const QImage picture = stage.picture();
        QVERIFY(has(picture, look.guideGround, around(end, 60)));
        QVERIFY(!has(picture, look.guideGround,
                     stage.surface().rect().adjusted(end.x() + 1, end.y() - 1, 0, 0)));
        QCOMPARE(stage.surface().cursor().shape(), Qt::BlankCursor);
        stage.move({12, 52}, Qt::NoButton, Qt::ControlModifier);
        QVERIFY(!has(stage.picture(), look.guideGround, stage.surface().rect()));
    }
    // The names have different widths: the ground shows which one is painted.
    void everyKindHasItsWord()
    {
        Stage stage(ui::Backend::Raster);
        stage.canvas->setTool("line");
        const ui::Look& look = ui::lookOf(stage.canvas->palette());
        const auto width = [&](app::Point pointer) {
            stage.move(pointer);
            const QImage picture = stage.picture();
            int least = picture.width(), most = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x)
                    if (picture.pixelColor(x, y) == look.guideGround) {
                        least = std::min(least, x);
                        most = std::max(most, x);
                    }
            return most - least;
        };
        const int end = width({12, 52}), middle = width({99, 51}), corner = width({51, 21});
        QVERIFY2(0 < end && end < middle && middle < corner,
                 qPrintable(QStringLiteral("%1 %2 %3").arg(end).arg(middle).arg(corner)));
    }
    void theReadoutDoesNotCoverTheMarker()
    {
        Stage stage(ui::Backend::Raster);
        stage.canvas->setTool("line");
        const ui::Look& look = ui::lookOf(stage.canvas->palette());
        stage.click({80, 90}, Qt::ControlModifier);
        stage.move({12, 52});
        const QRect readout = [&] {
            for (auto* frame : stage.canvas->findChildren<QFrame*>())
                if (frame->accessibleName() == "Numbers of the gesture" && frame->isVisible())
                    return QRect(stage.surface().mapFromGlobal(frame->mapToGlobal(QPoint())),
                                 frame->size());
            return QRect();
        }();
        QVERIFY(!readout.isEmpty());
        const QImage picture = stage.picture();
        QVERIFY(has(picture, look.guideGround, stage.surface().rect()));
        QVERIFY(!has(picture, look.guideGround, readout));
        QVERIFY(!readout.intersects(around(stage.at({10, 50}), 6)));
    }
};

} // namespace canvas_snap_marker_test

TEST_CLASS(canvas_snap_marker_test::SnapMarkerTest, Widgets)
#include "tests/ui/canvas/snap_marker_test.moc"
