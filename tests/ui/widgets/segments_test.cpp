// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/segments.h"

#include <QAbstractButton>
#include <QLineEdit>
#include <QVBoxLayout>

#include "tests/test_class.h"

namespace widgets_segments_test {

// A choice of a few, side by side.
class SegmentsTest : public QObject {
    Q_OBJECT

private slots:
    // Two rings would look like two choices.
    void aClickTakesTheFocusOfItsNeighbourAndOfNothingElse()
    {
        QWidget window;
        auto* column = new QVBoxLayout(&window);
        auto* segments = new ui::Segments("Side", {"Left", "Middle", "Right"});
        auto* field = new QLineEdit;
        column->addWidget(segments);
        column->addWidget(field);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        const auto buttons = segments->findChildren<QAbstractButton*>();
        field->setFocus();
        QTest::mouseClick(buttons[1], Qt::LeftButton);
        QCOMPARE(segments->chosen(), 1);
        QVERIFY(field->hasFocus());
        buttons[0]->setFocus();
        QTest::mouseClick(buttons[2], Qt::LeftButton);
        QCOMPARE(segments->chosen(), 2);
        QVERIFY(buttons[2]->hasFocus());
    }
};

} // namespace widgets_segments_test

TEST_CLASS(widgets_segments_test::SegmentsTest, Widgets)
#include "tests/ui/widgets/segments_test.moc"
