// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/ruler.h"

#include <QMenu>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace ui::canvas_ruler_corner_test {

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

} // namespace ui::canvas_ruler_corner_test

TEST_CLASS(ui::canvas_ruler_corner_test::RulerCornerTest, Widgets)
#include "tests/ui/canvas/ruler_corner_test.moc"
