// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/visible_colour.h"

#include <QColor>
#include <QTest>

#include "tests/test_class.h"

namespace view_visible_colour_test {

class VisibleColourTest : public QObject {
    Q_OBJECT

private slots:
    void contrastIsThatOfWcag()
    {
        QCOMPARE(app::contrast({0, 0, 0}, {255, 255, 255}), 21.0);
        QCOMPARE(app::contrast({255, 255, 255}, {255, 255, 255}), 1.0);
        // #767676 on white is WCAG's own example of 4.54.
        QVERIFY(std::abs(app::contrast({0x76, 0x76, 0x76}, {255, 255, 255}) - 4.54) < 0.005);
    }
    void whatCanBeSeenStays()
    {
        const app::Colour orange{255, 143, 82}, night{0x1E, 0x20, 0x23};
        QCOMPARE(app::visibleColour(orange, night), orange);
    }
    void everyColourCanBeSeenAndKeepsItsHueAndAlpha()
    {
        for (const app::Colour page : {app::Colour{0x1E, 0x20, 0x23}, app::Colour{255, 255, 255}})
            for (int r = 0; r < 256; r += 17)
                for (int g = 0; g < 256; g += 17)
                    for (int b = 0; b < 256; b += 17) {
                        const app::Colour colour{std::uint8_t(r), std::uint8_t(g), std::uint8_t(b),
                                                 77};
                        const app::Colour shown = app::visibleColour(colour, page);
                        QVERIFY2(app::contrast(shown, page) >= 3,
                                 qPrintable(QColor(r, g, b).name()));
                        QCOMPARE(shown.alpha, std::uint8_t(77));
                        const QColor before(r, g, b), after(shown.red, shown.green, shown.blue);
                        if (before.hslSaturation() < 40 || after.hslSaturation() < 40)
                            continue;
                        const int turn = std::abs(before.hslHue() - after.hslHue());
                        QVERIFY2(std::min(turn, 360 - turn) <= 12,
                                 qPrintable(before.name() + after.name()));
                    }
    }
    void ghostsForProjectorsCanBeSeen()
    {
        const app::Colour white{255, 255, 255}, black{0, 0, 0, 200}, pale{200, 220, 255};
        const app::Colour ghost = app::ghostColour(black, white, 0.32);
        QVERIFY(app::contrast(ghost, white) >= 3 && app::contrast(ghost, white) < 3.3);
        QCOMPARE(ghost.alpha, std::uint8_t(200));
        QCOMPARE(app::ghostColour(black, white, 0.8),
                 (app::Colour{51, 51, 51, 200}));            // enough as it is
        QCOMPARE(app::ghostColour(pale, white, 0.32), pale); // it cannot be
    }
};

} // namespace view_visible_colour_test

TEST_CLASS(view_visible_colour_test::VisibleColourTest, None)
#include "tests/app/view/visible_colour_test.moc"
