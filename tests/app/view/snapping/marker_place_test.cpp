// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/marker_place.h"

#include <QTest>

#include "tests/test_class.h"

namespace view_snapping_marker_place_test {

class MarkerPlaceTest : public QObject {
    Q_OBJECT

private slots:
    void isAboveLeftIfThereIsRoom()
    {
        const QRectF place = app::markerPlace({200, 200}, {60, 20}, {400, 400}, {});
        QVERIFY(place.right() < 195 && place.bottom() < 195);
    }
    void isInsideAndClearOfTheBoxEverywhere()
    {
        const QSizeF canvas(400, 300), box(250, 28), label(90, 20);
        for (int x = 0; x <= 400; x += 5)
            for (int y = 0; y <= 300; y += 5) {
                QRectF covered(QPointF(x + 16, y + 15), box); // as the readout box is placed
                if (covered.right() > canvas.width())
                    covered.moveLeft(std::max(0.0, x - 16 - box.width()));
                if (covered.bottom() > canvas.height())
                    covered.moveTop(y - 15 - box.height());
                const QRectF place = app::markerPlace(QPointF(x, y), label, canvas, covered);
                QVERIFY(QRectF({0, 0}, canvas).contains(place));
                QVERIFY(!place.intersects(covered));
            }
    }
};

} // namespace view_snapping_marker_place_test

TEST_CLASS(view_snapping_marker_place_test::MarkerPlaceTest, None)
#include "tests/app/view/snapping/marker_place_test.moc"
