// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/ruler.h"

#include <QMenu>

#include "tests/ui/test_window.h"

namespace ui {

// The unit where the rulers meet.
class RulerCornerTest : public QObject {
    Q_OBJECT

private slots:
    void clickChoosesTheUnit()
    {
        TestWindow t;
        t.show();
        QCOMPARE(t.window->session().display().unit, app::Unit::Mm);
        auto* corner = t.window->findChild<RulerCorner*>();
        QTest::mouseClick(corner, Qt::LeftButton);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu);
        QTest::keyClick(menu, Qt::Key_Down);
        QTest::keyClick(menu, Qt::Key_Down);
        QTest::keyClick(menu, Qt::Key_Return);
        QCOMPARE(t.window->session().display().unit, app::Unit::Cm);
    }
    void focusDoesNotChangeIt()
    {
        TestWindow t;
        t.show();
        auto* corner = t.window->findChild<RulerCorner*>();
        const QImage with = corner->grab().toImage();
        t.drawingArea()->clearFocus();
        QVERIFY(!t.drawingArea()->hasFocus());
        QCOMPARE(corner->grab().toImage(), with);
    }
};

} // namespace ui

QTEST_MAIN(ui::RulerCornerTest)
#include "ruler_corner_test.moc"
