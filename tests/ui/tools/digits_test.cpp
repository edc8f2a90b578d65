// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool.h"

#include "tests/ui/tools/hand.h"

// A digit never chooses the algorithm during a gesture, whatever the tool.
class DigitsTest : public QObject {
    Q_OBJECT

    struct Person : Hand {
        Person() : Hand({shape({wave()}), shape({{{30, 90}, {{{90, 90}}}, false}})})
        {
            key(Qt::Key_2, Qt::ControlModifier | Qt::AltModifier); // the workspace Cut
        }
        bool digitsChoose()
        {
            const app::Variant before = session.variant();
            bool changed = false;
            for (int digit = Qt::Key_1; digit <= Qt::Key_9; ++digit) {
                key(digit);
                changed = changed || session.variant() != before;
            }
            return changed;
        }
        /// Types digits in the middle of a drag.
        bool dragKeepsAlgorithm(app::Point from, app::Point to)
        {
            press(from);
            move((from + to) * 0.5, Qt::LeftButton);
            move(to, Qt::LeftButton);
            const bool kept = !digitsChoose();
            key(Qt::Key_Escape); // the field
            key(Qt::Key_Escape); // the gesture
            release(to);
            return kept;
        }
    };

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void digitsChooseWithoutAGesture()
    {
        Person person;
        QVERIFY(person.digitsChoose());
        person.press({100, 10});
        person.move({120, 30}, Qt::LeftButton);
        person.release({120, 30});
        QVERIFY(person.digitsChoose()); // the gesture is over
    }
    void noToolLetsADigitThrough()
    {
        Person person;
        for (const ui::ToolInfo& tool : ui::tools()) {
            person.canvas.setTool(tool.key);
            QVERIFY2(person.dragKeepsAlgorithm({100, 10}, {150, 30}), tool.key.data());
        }
    }
    void noKindOfDragLetsADigitThrough_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<bool>("selects");
        QTest::addColumn<QPointF>("from");
        const auto row = [](const char* name, const char* tool, bool selects, QPointF from) {
            QTest::newRow(name) << QString(tool) << selects << from;
        };
        row("window moved", "select", false, {167, 85});
        row("window resized", "select", false, {160, 85});
        row("window drawn", "window", false, {100, 10});
        row("window of its tool moved", "window", false, {170, 90});
        row("window of its tool resized", "window", false, {190, 95});
        row("objects moved", "select", true, {80, 50});
        row("objects resized", "select", true, {140, 70});
        row("nodes boxed", "nodes", true, {100, 10});
        row("node dragged", "nodes", true, {80, 50});
        row("curve bent", "nodes", true, {50, 27.5});
        row("zoom rectangle", "zoom", false, {100, 10});
        row("view moved", "hand", false, {100, 10});
    }
    void noKindOfDragLetsADigitThrough()
    {
        QFETCH(QString, tool);
        QFETCH(bool, selects);
        QFETCH(QPointF, from);
        Person person;
        if (selects)
            person.click({80, 50});
        person.canvas.setTool(tool.toStdString());
        const app::Point at(from.x(), from.y());
        QVERIFY(person.dragKeepsAlgorithm(at, at + app::Point(9, -4)));
    }
    void pivotAndRotationLetNoDigitThrough()
    {
        Person person;
        person.click({80, 50});
        const auto box = *person.session.selectionBounds();
        const app::Point middle = (box.min + box.max) * 0.5;
        QVERIFY(person.dragKeepsAlgorithm(middle, middle + app::Point(9, -4)));
        const app::Point above(middle.x, box.min.y - 28 / person.canvas.view().zoom);
        QVERIFY(person.dragKeepsAlgorithm(above, above + app::Point(9, -4)));
    }
    void panningLetsNoDigitThrough()
    {
        Person person;
        QTest::mousePress(&person.surface(), Qt::MiddleButton, {}, person.at({100, 10}));
        QVERIFY(!person.digitsChoose());
        QTest::mouseRelease(&person.surface(), Qt::MiddleButton, {}, person.at({100, 10}));
        QVERIFY(person.digitsChoose());
    }
    void undoneStepLeavesDigitsToTheAlgorithm()
    {
        Person person;
        person.click({60, 90});
        person.drag({60, 90}, {70, 80});
        person.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(person.digitsChoose());
    }
};

QTEST_MAIN(DigitsTest)
#include "digits_test.moc"
