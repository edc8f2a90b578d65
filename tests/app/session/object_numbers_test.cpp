// SPDX-License-Identifier: GPL-3.0-or-later
// What objects without a name are called stays, whatever happens to others.
#include "app/commands/add_and_remove.h"
#include "app/document/document_builder.h"
#include "app/session/copy_selection.h"
#include "app/session/rearrange_selection.h"
#include "app/session/units.h"

#include <QTest>

#include <array>
#include <map>
#include <utility>

#include "tests/test_class.h"

namespace session_object_numbers_test {

using namespace app;

namespace {

Object line(double x)
{
    return {.path = Path(clipping::Segment{{x, 0}, {x + 1, 1}}),
            .style = {.stroke = Colour{}, .width = 1}};
}

/// Lines 0, 1 and 2 in the layer "low", line 3 and a triangle in "high".
struct Drawing : Session {
    Drawing()
    {
        DocumentBuilder builder;
        builder.open({.name = "low"});
        for (int i = 0; i < 3; ++i)
            builder.add(line(i));
        builder.close();
        builder.open({.name = "high"});
        builder.add(line(3));
        const Subpath triangle{{0, 0}, {{{4, 0}}, {{0, 4}}}, true};
        builder.add({.path = Path(std::array{triangle}), .style = {.stroke = Colour{}}});
        builder.close();
        load({builder.take({}), {}});
    }
    QStringList names() const
    {
        QStringList all;
        for (std::size_t i = 0; i < now().objects().size(); ++i)
            all << app::objectName(*this, i);
        return all;
    }
    void add(double x)
    {
        history.push(new AddObjects(
            document, adding(now(), std::array{PendingObject{line(x), pen.layer}}), {}));
    }
    void remove(std::size_t object)
    {
        history.push(new RemoveObjects(document, ObjectRanges({object})));
    }
};

} // namespace

class ObjectNumbersTest : public QObject {
    Q_OBJECT

private slots:
    void theyStayInAnotherOrder()
    {
        Drawing drawing;
        QCOMPARE(drawing.names(), QStringList({"Line 1", "Line 2", "Line 3", "Line 4", "Path 5"}));
        drawing.select({4});
        stackSelection(drawing, Stacking::ToBack);
        QCOMPARE(drawing.names(), QStringList({"Line 1", "Line 2", "Line 3", "Path 5", "Line 4"}));
        drawing.select({0, 3});
        moveSelectionTo(drawing, drawing.now().containers().childrenOf(0)[1]);
        QCOMPARE(drawing.names(), QStringList({"Line 2", "Line 3", "Line 4", "Line 1", "Path 5"}));
        drawing.history.setIndex(0);
        QCOMPARE(drawing.names(), QStringList({"Line 1", "Line 2", "Line 3", "Line 4", "Path 5"}));
        drawing.history.setIndex(2);
        QCOMPARE(drawing.names(), QStringList({"Line 2", "Line 3", "Line 4", "Line 1", "Path 5"}));
    }
    void noNumberIsUsedTwice()
    {
        Drawing drawing;
        drawing.remove(1);
        QCOMPARE(drawing.names(), QStringList({"Line 1", "Line 3", "Line 4", "Path 5"}));
        drawing.add(9);
        QCOMPARE(drawing.names().back(), QStringLiteral("Line 6"));
        drawing.history.setIndex(0);
        QCOMPARE(drawing.names(), QStringList({"Line 1", "Line 2", "Line 3", "Line 4", "Path 5"}));
    }
    void aCopyIsAnotherObject()
    {
        Drawing drawing;
        drawing.select({0});
        duplicateInPlace(drawing);
        QStringList names = drawing.names();
        QCOMPARE(names.size(), 6);
        QCOMPARE(names.removeDuplicates(), 0);
        QVERIFY(names.contains("Line 1") && names.contains("Line 6"));
    }
    void anotherDrawingBeginsAgain()
    {
        Drawing drawing;
        drawing.remove(0);
        drawing.load({drawing.now(), {}});
        QCOMPARE(drawing.names(), QStringList({"Line 1", "Line 2", "Line 3", "Path 4"}));
    }
    // Two equal lines, and many steps: what exists has one number each, and undo restores all.
    void stepsAreUndoneOneByOne()
    {
        Drawing drawing;
        std::vector<QStringList> seen{drawing.names()};
        for (int i = 0; i < 20; ++i) {
            if (i % 5 == 0)
                drawing.add(0);
            else if (i % 5 == 1)
                drawing.remove(std::size_t(i) % drawing.now().objects().size());
            else {
                constexpr std::array ways{Stacking::ToFront, Stacking::Raise, Stacking::Lower,
                                          Stacking::ToBack};
                drawing.select({0, 2});
                stackSelection(drawing, ways[std::size_t(i) % ways.size()]);
            }
            QCOMPARE(QStringList(drawing.names()).removeDuplicates(), 0);
            if (int(seen.size()) == drawing.history.count()) // it did change something
                seen.push_back(drawing.names());
        }
        QCOMPARE(int(seen.size()), drawing.history.count() + 1);
        QVERIFY(seen.size() > 15);
        for (int index = drawing.history.count(); index >= 0; --index) {
            drawing.history.setIndex(index);
            QCOMPARE(drawing.names(), seen[std::size_t(index)]);
        }
        for (int index = 0; index <= drawing.history.count(); ++index) {
            drawing.history.setIndex(index);
            QCOMPARE(drawing.names(), seen[std::size_t(index)]);
        }
    }
    // As many objects come to a place as leave it, but others.
    void objectsThatChangePlacesKeepTheirNumbers()
    {
        DocumentBuilder builder;
        builder.open({.name = "low"});
        for (int i = 0; i < 4; ++i)
            builder.add({.path = Path(clipping::Segment{{0, double(i)}, {4, double(4 - i)}}),
                         .style = {.stroke = Colour{}, .width = 1}});
        builder.close();
        Drawing drawing;
        drawing.load({builder.take({}), {}});
        const auto ends = [&] {
            std::map<QString, double> all;
            for (std::size_t i = 0; i < 4; ++i)
                all[app::objectName(drawing, i)] = drawing.now().objects()[i].singleLine()->a.y;
            return all;
        };
        const auto before = ends();
        drawing.select({0, 2});
        stackSelection(drawing, Stacking::Raise);
        QCOMPARE(drawing.names(), QStringList({"Line 2", "Line 1", "Line 4", "Line 3"}));
        QVERIFY(ends() == before);
        drawing.select({0, 3});
        stackSelection(drawing, Stacking::Lower);
        QVERIFY(ends() == before);
        drawing.history.setIndex(0);
        QCOMPARE(drawing.names(), QStringList({"Line 1", "Line 2", "Line 3", "Line 4"}));
    }
    // Such a change looks like an undo of the last one.
    void aNewObjectInThePlaceOfARemovedOneIsNew()
    {
        Drawing drawing;
        drawing.select({3});
        stackSelection(drawing, Stacking::ToFront);
        QCOMPARE(drawing.names(), QStringList({"Line 1", "Line 2", "Line 3", "Path 5", "Line 4"}));
        drawing.pen.layer = drawing.now().containers().layerOf(4);
        drawing.remove(4);
        drawing.add(9);
        QCOMPARE(drawing.names(), QStringList({"Line 1", "Line 2", "Line 3", "Path 5", "Line 6"}));
        drawing.history.setIndex(0);
        QCOMPARE(drawing.names(), QStringList({"Line 1", "Line 2", "Line 3", "Line 4", "Path 5"}));
    }
    void theFirstPieceOfWhatIsCutKeepsTheNumber()
    {
        Drawing drawing;
        Edit edit{.splices = {{1, 1, 2}}, .objects = drawing.now().objects().slice(0, 0)};
        edit.objects.append(line(1));
        edit.objects.append(line(1));
        edit.containers = drawing.now().containers().spliced(edit.splices);
        const Edit back = drawing.document.apply(edit);
        QCOMPARE(drawing.names(),
                 QStringList({"Line 1", "Line 2", "Line 6", "Line 3", "Line 4", "Path 5"}));
        drawing.document.apply(back);
        QCOMPARE(drawing.names(), QStringList({"Line 1", "Line 2", "Line 3", "Line 4", "Path 5"}));
    }
    // Undone by the document itself, when memory runs out in a listener.
    void whatFailsChangesNoNumber()
    {
        Drawing drawing;
        drawing.remove(1);
        const QStringList before = drawing.names();
        bool fails = true;
        QObject listener;
        connect(&drawing.document, &EditedDocument::changed, &listener, [&] {
            if (std::exchange(fails, false))
                throw std::bad_alloc();
        });
        QVERIFY_EXCEPTION_THROWN(drawing.remove(0), std::bad_alloc);
        QCOMPARE(drawing.names(), before);
        drawing.history.undo();
        QCOMPARE(drawing.names(), QStringList({"Line 1", "Line 2", "Line 3", "Line 4", "Path 5"}));
    }
    void theSelectionIsNamed()
    {
        Drawing drawing;
        drawing.select({4});
        QCOMPARE(selectionText(drawing), QStringLiteral("Path 5"));
        drawing.select({0, 4});
        QCOMPARE(selectionText(drawing), QStringLiteral("2 objects"));
        const QString named = QStringLiteral("Path “roof”");
        Drawing other;
        DocumentBuilder builder;
        builder.open({});
        const Subpath triangle{{0, 0}, {{{4, 0}}, {{0, 4}}}, true};
        builder.add({.path = Path(std::array{triangle}),
                     .style = {.stroke = Colour{}},
                     .particulars = {.id = "roof"}});
        builder.close();
        other.load({builder.take({}), {}});
        other.select({0});
        QCOMPARE(selectionText(other), named);
        QCOMPARE(app::objectName(other, 0), QStringLiteral("roof")); // beside the picture of a path
        groupSelection(drawing);
        QCOMPARE(selectionText(drawing), QStringLiteral("group of 2 objects"));
    }
};

} // namespace session_object_numbers_test

TEST_CLASS(session_object_numbers_test::ObjectNumbersTest, Core)
#include "tests/app/session/object_numbers_test.moc"
