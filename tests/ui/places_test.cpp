// SPDX-License-Identifier: GPL-3.0-or-later
// A widget whose parts have a layout leaves none of them out: it would lie in the corner, above the
// others.
#include <QLayout>

#include "tests/test_class.h"
#include "tests/ui/fresh/made.h"
#include "tests/ui/fresh/shown_by.h"

namespace places_test {

using namespace ui;

namespace {

bool isIn(const QLayout& layout, const QWidget* part)
{
    for (int i = 0; i < layout.count(); ++i) {
        QLayoutItem* const item = layout.itemAt(i);
        if (item->widget() == part || (item->layout() && isIn(*item->layout(), part)))
            return true;
    }
    return false;
}

} // namespace

class PlacesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        Timers::watch();
        dropRemarksOfThePlatform();
    }
    void every_data() { addEveryMaker(); }
    void every()
    {
        QFETCH(int, number);
        const Made made(number);
        QWidget& window = *made.window;
        QStringList lost;
        for (const QWidget* part : window.findChildren<QWidget*>()) {
            const QWidget* around = part->parentWidget();
            if (part->isVisible() && !part->isWindow() && around->layout()
                && !isIn(*around->layout(), part)
                && !part->inherits("QToolBarExtension")) // Qt's own
                lost << classOf(*part) + " “" + part->accessibleName() + "” in " + classOf(*around);
        }
        QVERIFY2(lost.isEmpty(), qPrintable(lost.join("; ")));
    }
};

} // namespace places_test

TEST_CLASS(places_test::PlacesTest, Widgets)
#include "tests/ui/places_test.moc"
