// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_containers.h"
#include "ui/tools/tool.h"

#include <QLabel>
#include <QLineEdit>
#include <QStatusBar>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace tools_digits_test {

// Outside gestures and fields digits choose the algorithm whenever a clip window is chosen or the
// workspace is not Draw; a digit never does so during a gesture, whatever the tool.
class DigitsTest : public QObject {
    Q_OBJECT

    struct Person : Hand {
        Person() : Hand({shape({wave()}), shape({{{30, 90}, {{{90, 90}}}, false}})})
        {
            work(Qt::Key_2);
        }
        /// Key 1 is for the workspace Draw, 2 for Cut.
        void work(int key) { Hand::key(key, Qt::ControlModifier | Qt::AltModifier); }
        bool typing() const
        {
            const auto* field = qobject_cast<const QLineEdit*>(QApplication::focusWidget());
            return field && canvas.isAncestorOf(field);
        }
        double lengthOfLast() const
        {
            const auto lines = session.scene.lines();
            const clipping::Segment last = lines[lines.size() - 1];
            return glm::distance(last.a, last.b);
        }
        QString hint() const
        {
            return t.window->statusBar()->findChild<QLabel*>("hint")->toolTip();
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
    void afterAWindowIsDraggedDigitsChoose_data() { bothWorkspaces(); }
    void afterAWindowIsDraggedDigitsChoose()
    {
        QFETCH(int, workspace);
        Person person;
        person.work(workspace);
        for (const bool selected : {false, true}) {
            person.click(selected ? app::Point(80, 50) : app::Point(100, 5));
            QCOMPARE(person.session.selection().empty(), !selected);
            const auto before = *person.session.clipWindow();
            person.drag({167, 85}, {160, 75});
            QVERIFY(*person.session.clipWindow() != before);
            QVERIFY(person.digitsChoose());
            QVERIFY(!person.typing());
        }
    }
    void afterAWindowIsDrawnDigitsChoose_data() { bothWorkspaces(); }
    void afterAWindowIsDrawnDigitsChoose()
    {
        QFETCH(int, workspace);
        Person person;
        person.work(workspace);
        person.canvas.setTool("window");
        person.drag({100, 5}, {150, 30});
        QCOMPARE(person.session.windows().list.size(), std::size_t(2));
        QVERIFY(person.digitsChoose());
        QVERIFY2(person.hint().endsWith("Digits: algorithm."), qPrintable(person.hint()));
    }
    void inDrawDigitsAreTheNumbersOfWhatWasJustDrawn()
    {
        Person person;
        person.work(Qt::Key_1);
        person.canvas.setTool("line");
        person.drag({100, 10}, {120, 10});
        const app::Variant before = person.session.variant();
        person.key(Qt::Key_3);
        QVERIFY(person.typing());
        QVERIFY(!person.hint().contains("Digits"));
        person.key(Qt::Key_5);
        person.key(Qt::Key_Return);
        QCOMPARE(person.lengthOfLast(), 35.0);
        QCOMPARE(person.session.variant(), before);
    }
    void inDrawDigitsAreTheNumbersOfAMovedObject()
    {
        Person person;
        person.work(Qt::Key_1);
        person.click({60, 90});
        person.drag({60, 90}, {70, 80});
        QVERIFY(!person.digitsChoose());
        QVERIFY(person.typing());
    }
    void outsideDrawEnterOpensTheNumbers()
    {
        Person person;
        person.canvas.setTool("line");
        person.drag({100, 10}, {120, 10});
        QVERIFY(person.digitsChoose());
        QVERIFY(!person.typing());
        const double length = person.lengthOfLast();
        person.key(Qt::Key_Return);
        QVERIFY(person.typing());
        QVERIFY(!person.digitsChoose()); // they are in the field
        person.key(Qt::Key_Escape);
        QCOMPARE(person.lengthOfLast(), length);
        person.drag({100, 30}, {120, 30});
        person.key(Qt::Key_Return);
        person.key(Qt::Key_3);
        person.key(Qt::Key_0);
        person.key(Qt::Key_Return);
        QCOMPARE(person.lengthOfLast(), 30.0);
    }
    void inDrawWithoutAWindowDigitsDoNothing()
    {
        Person person;
        person.work(Qt::Key_1);
        app::Edit edit;
        edit.windows = app::ClipWindows{};
        person.session.document.apply(edit);
        QVERIFY(!person.digitsChoose());
        QVERIFY(person.t.window->statusBar()->currentMessage().contains("clip window is chosen"));
    }
    void theHintSaysWhetherDigitsChoose()
    {
        Person person;
        const auto says = [&] { return person.hint().endsWith("Digits: algorithm."); };
        QVERIFY(says());
        person.work(Qt::Key_1);
        QVERIFY(says()); // the window is chosen, as nothing else is
        person.click({80, 50});
        QVERIFY(!says());
        person.work(Qt::Key_2);
        QVERIFY(says());
        person.work(Qt::Key_1);
        person.canvas.setTool("line");
        QVERIFY(!says());
        person.canvas.setTool("select");
        person.key(Qt::Key_Escape);
        QVERIFY(says());
    }
    // Nothing can be drawn there, so no number can begin a line.
    void onALockedLayerNoFieldOpens()
    {
        Person person;
        person.work(Qt::Key_1);
        person.canvas.setTool("line");
        person.drag({100, 10}, {120, 10});
        const app::Containers& tree = person.session.now().containers();
        app::Container layer = tree[tree.childrenOf(0).front()];
        layer.locked = true;
        person.session.history.push(
            new app::SetContainers(person.session.document, tree.with(layer), "lock"));
        person.key(Qt::Key_3);
        QVERIFY(!person.typing());
    }
    void undoneStepLeavesDigitsToTheAlgorithm()
    {
        Person person;
        person.click({60, 90});
        person.drag({60, 90}, {70, 80});
        person.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(person.digitsChoose());
    }

private:
    static void bothWorkspaces()
    {
        QTest::addColumn<int>("workspace");
        QTest::newRow("Draw") << int(Qt::Key_1);
        QTest::newRow("Cut") << int(Qt::Key_2);
    }
};

} // namespace tools_digits_test

TEST_CLASS(tools_digits_test::DigitsTest, Widgets)
#include "tests/ui/tools/digits_test.moc"
