// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool.h"

#include <QSignalSpy>

#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"

namespace tools_refusals_test {

// What cannot be drawn is refused with one sentence, and nothing is lost or added.
class RefusalsTest : public QObject {
    Q_OBJECT

    struct Hand : Stage {
        explicit Hand(const char* tool) : Stage(ui::Backend::Raster, {})
        {
            canvas->setTool(tool);
            canvas->setSnapping(app::SnapTo::Nothing);
        }
        std::size_t count() const { return session.now().objects().size(); }
        /// One sentence was said, and nothing was drawn.
        bool refusedOnce()
        {
            const bool once = refused.size() == 1 && refused[0][0].toString().endsWith(u'.')
                              && count() == 0 && session.history.count() == 0;
            refused.clear();
            return once;
        }
        QSignalSpy refused{&session, &app::Session::refused};
    };

private slots:
    void shapesWithoutWidthOrHeight()
    {
        for (const char* tool : {"rectangle", "ellipse"}) {
            Hand hand(tool);
            hand.drag({20, 30}, {70, 30});
            QVERIFY2(hand.refusedOnce(), tool);
            hand.move({70, 60});
            hand.click({70, 60}); // the gesture goes on
            QCOMPARE(hand.count(), std::size_t(1));
        }
    }
    void secondClickOnTheFirst()
    {
        for (const char* tool : {"line", "rectangle", "ellipse", "polygon", "star"}) {
            Hand hand(tool);
            hand.click({20, 30});
            QVERIFY(hand.refused.empty());
            hand.click({20, 30});
            QVERIFY2(hand.refusedOnce(), tool);
            hand.click({60, 70});
            QCOMPARE(hand.count(), std::size_t(1));
        }
    }
    void repeatedPoint()
    {
        Hand hand("polyline");
        hand.click({20, 30});
        hand.click({20, 30});
        QVERIFY(hand.refusedOnce());
        hand.key(Qt::Key_Return); // one corner
        QVERIFY(hand.refusedOnce());
        hand.click({20, 30});
        hand.key(Qt::Key_Escape); // given up, which needs no sentence
        QVERIFY(hand.refused.empty());
        QCOMPARE(hand.count(), std::size_t(0));
    }
    void doubleClickDrawsNoPolyline()
    {
        for (const char* tool : {"polyline", "pen"}) {
            Hand hand(tool);
            hand.click({20, 30});
            QTest::mouseDClick(&hand.surface(), Qt::LeftButton, {}, hand.at({20, 30}));
            QVERIFY2(hand.refusedOnce(), tool);
        }
    }
    void arcOfThreePointsOnALine()
    {
        Hand hand("arc");
        hand.click({20, 30});
        hand.click({20, 30});
        QVERIFY(hand.refusedOnce());
        hand.click({60, 30});
        QVERIFY(hand.refused.empty());
        hand.click({40, 30});
        QVERIFY(hand.refusedOnce());
        hand.move({40, 45});
        hand.click({40, 45});
        QCOMPARE(hand.count(), std::size_t(1));
    }
    void arcAroundItsCentreWithoutAnAngle()
    {
        Hand hand("arc");
        hand.key(Qt::Key_C);
        hand.click({20, 30});
        hand.click({60, 30});
        hand.click({60, 30});
        QVERIFY(hand.refusedOnce());
        hand.move({20, 60});
        hand.click({20, 60});
        QCOMPARE(hand.count(), std::size_t(1));
    }
    void clickOfThePencil()
    {
        Hand hand("pencil");
        hand.click({20, 30});
        QVERIFY(hand.refusedOnce());
        hand.drag({20, 30}, {60, 50});
        QCOMPARE(hand.count(), std::size_t(1));
        QVERIFY(hand.refused.empty());
    }
    void hiddenOrLockedLayer()
    {
        for (const bool hidden : {true, false})
            for (const ui::ToolInfo& tool : ui::tools()) {
                if (!tool.draws())
                    continue;
                Hand hand(tool.key.data());
                ::setLayers(hand.session.document,
                            {{.name = "Walls", .visible = !hidden, .locked = !hidden}});
                hand.drag({20, 30}, {70, 60});
                QVERIFY2(hand.refusedOnce(), tool.key.data());
                QCOMPARE(hand.surface().cursor().shape(), Qt::ForbiddenCursor);
                QVERIFY(hand.canvas->toolHint().contains("Walls"));
            }
    }
};

} // namespace tools_refusals_test

TEST_CLASS(tools_refusals_test::RefusalsTest, Widgets)
#include "tests/ui/tools/refusals_test.moc"
