// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/move_objects.h"
#include "app/document/document_builder.h"
#include "app/session/copy_selection.h"

#include <QTest>

#include "tests/test_class.h"

namespace session_selection_memory_test {

using namespace app;

// Which objects are selected after undo and redo.
class SelectionMemoryTest : public QObject {
    Q_OBJECT

    struct Drawing : Session {
        Drawing()
        {
            DocumentBuilder builder;
            builder.open({});
            for (int i = 0; i < 3; ++i)
                builder.add({Path(clipping::Segment{{double(i), 0}, {double(i), 1}}),
                             {.stroke = Colour{}}});
            builder.close();
            load({builder.take({}), {}});
            select({0});
        }
    };

private slots:
    void undoAndRedoOfCopies()
    {
        Drawing drawing;
        duplicateInPlace(drawing);
        duplicateInPlace(drawing);
        QCOMPARE(drawing.selection(), (ObjectRanges{4}));
        drawing.select({1}); // by hand, afterwards
        drawing.history.undo();
        QCOMPARE(drawing.selection(), (ObjectRanges{3}));
        drawing.history.undo();
        QCOMPARE(drawing.selection(), (ObjectRanges{0}));
        drawing.history.redo();
        QCOMPARE(drawing.selection(), (ObjectRanges{3}));
        drawing.history.setIndex(0);
        QCOMPARE(drawing.selection(), (ObjectRanges{0}));
        drawing.history.setIndex(2);
        QCOMPARE(drawing.selection(), (ObjectRanges{1}));
    }
    void aJumpIsLikeSingleSteps()
    {
        Drawing drawing;
        const auto move = [&] {
            drawing.history.push(new MoveObjects(drawing.document, {0}, {1, 0}));
        };
        move();
        duplicateInPlace(drawing); // {3}
        duplicateInPlace(drawing); // {4}
        move();
        drawing.history.setIndex(0);
        QCOMPARE(drawing.selection(), (ObjectRanges{0}));
        drawing.history.setIndex(2);
        QCOMPARE(drawing.selection(), (ObjectRanges{3}));
        drawing.history.setIndex(4);
        QCOMPARE(drawing.selection(), (ObjectRanges{4}));
    }
    void stepsThatKeepAllObjectsLeaveTheSelectionAlone()
    {
        Drawing drawing;
        drawing.history.push(new MoveObjects(drawing.document, {0}, {1, 0}));
        drawing.select({2});
        drawing.history.undo();
        QCOMPARE(drawing.selection(), (ObjectRanges{2}));
        drawing.history.redo();
        QCOMPARE(drawing.selection(), (ObjectRanges{2}));
    }
    void anotherDrawingAndForgottenSteps()
    {
        Drawing drawing;
        duplicateInPlace(drawing);
        drawing.load({drawing.now(), {}});
        QVERIFY(drawing.selection().empty());
        drawing.select({1});
        for (int i = 0; i < 3; ++i)
            duplicateInPlace(drawing);
        const ObjectRanges last = drawing.selection();
        drawing.history.setLimit(1); // only the newest step stays
        QCOMPARE(drawing.history.count(), 1);
        drawing.history.undo();
        QCOMPARE(drawing.selection(), (ObjectRanges{5}));
        drawing.history.redo();
        QCOMPARE(drawing.selection(), last);
    }
};

} // namespace session_selection_memory_test

TEST_CLASS(session_selection_memory_test::SelectionMemoryTest, Core)
#include "tests/app/session/selection_memory_test.moc"
