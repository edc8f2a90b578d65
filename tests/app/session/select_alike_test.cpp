// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/select_alike.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include "tests/test_class.h"

namespace session_select_alike_test {

using namespace app;

class SelectAlikeTest : public QObject {
    Q_OBJECT

    /// Red and blue lines of two widths on two layers; the last two are in a group.
    struct Drawing : Session {
        Drawing()
        {
            DocumentBuilder builder;
            const Colour red{200, 0, 0}, blue{0, 0, 200};
            const auto add = [&](const Colour& colour, double width, const QString& id = {}) {
                Object line{Path(clipping::Segment{{0, 0}, {1, 1}}),
                            {.stroke = colour, .width = width}};
                line.particulars.id = id;
                builder.add(line);
            };
            builder.open({.name = "Walls"});
            add(red, 1, "north");
            add(blue, 1);
            builder.close();
            upper = builder.open({.name = "Doors"});
            add(red, 2);
            builder.open({.kind = Container::Kind::Group, .name = "Front door"});
            add(red, 1, "leaf");
            add(blue, 2);
            builder.close();
            builder.close();
            load({builder.take({}), {}});
        }
        ContainerId upper = 0;
    };
    static void select(Session& session, std::string_view key)
    {
        const auto row = std::ranges::find(likenesses(), key, &Likeness::key);
        selectAlike(session, *row);
    }

private slots:
    void whatIsAlike()
    {
        Drawing drawing;
        drawing.select({0});
        select(drawing, "same-colour");
        QCOMPARE(drawing.selection(), (ObjectRanges{0, 2, 3}));
        drawing.select({4});
        select(drawing, "same-stroke-width");
        QCOMPARE(drawing.selection(), (ObjectRanges{2, 4}));
        drawing.select({0});
        select(drawing, "same-style");
        QCOMPARE(drawing.selection(), (ObjectRanges{0, 3}));
        select(drawing, "same-layer");
        QCOMPARE(drawing.selection(), (ObjectRanges{0, 1, 2, 3, 4}));
        drawing.select({4});
        select(drawing, "same-layer");
        QCOMPARE(drawing.selection(), (ObjectRanges{2, 3, 4}));
        invertSelection(drawing);
        QCOMPARE(drawing.selection(), (ObjectRanges{0, 1}));
        selectLayer(drawing, drawing.upper);
        QCOMPARE(drawing.selection(), (ObjectRanges{2, 3, 4}));
    }
    void namesAreFound()
    {
        Drawing drawing;
        QCOMPARE(find(drawing, "north"), "1 object is selected.");
        QCOMPARE(drawing.selection(), (ObjectRanges{0}));
        QCOMPARE(find(drawing, "front"), "2 objects are selected.");
        QCOMPARE(drawing.selection(), (ObjectRanges{3, 4}));
        QCOMPARE(find(drawing, "door"), "3 objects are selected.");
        QCOMPARE(find(drawing, "window"), QString("No object, group or layer is named “window”."));
        QCOMPARE(drawing.selection(), (ObjectRanges{2, 3, 4}));
        QCOMPARE(find(drawing, "  "), "Type an id or a name.");
    }
    void lockedObjectsAreLeftAlone()
    {
        Drawing drawing;
        Container layer = drawing.now().containers()[drawing.upper];
        layer.locked = true;
        Edit edit;
        edit.containers = drawing.now().containers().with(layer);
        drawing.document.apply(edit);
        drawing.select({0});
        select(drawing, "same-colour");
        QCOMPARE(drawing.selection(), (ObjectRanges{0}));
        QCOMPARE(
            find(drawing, "leaf"),
            QString("The objects named “leaf” are locked or hidden. Unlock and show them first."));
        QSignalSpy refused(&drawing, &Session::refused);
        selectLayer(drawing, drawing.upper);
        QCOMPARE(refused.count(), 1);
    }
    // Measured, not judged.
    void manyObjects()
    {
        DocumentBuilder builder;
        builder.open({});
        for (int i = 0; i < 100'000; ++i)
            builder.add({Path(clipping::Segment{{double(i), 0}, {double(i), 1}}),
                         {.stroke = Colour{std::uint8_t(i % 2), 0, 0}}});
        builder.close();
        Session session;
        session.load({builder.take({}), {}});
        session.select({0});
        QElapsedTimer timer;
        timer.start();
        select(session, "same-colour");
        qInfo("same colour of 100,000 objects: %lld ms", timer.elapsed());
        QCOMPARE(session.selection().size(), std::size_t(50'000));
    }
    /// Each with each, they would take many minutes.
    void manyColours()
    {
        constexpr int count = 600'000;
        DocumentBuilder builder;
        builder.open({});
        for (int i = 0; i < count; ++i)
            builder.add(
                {Path(clipping::Segment{{double(i), 0}, {double(i), 1}}),
                 {.stroke = Colour{std::uint8_t(i >> 16), std::uint8_t(i >> 8), std::uint8_t(i)},
                  .width = i + 1.0}});
        builder.close();
        Session session;
        session.load({builder.take({}), {}});
        for (const char* likeness : {"same-colour", "same-stroke-width", "same-style"}) {
            session.select(ObjectRanges(ObjectRange{0, count / 2}));
            QElapsedTimer timer;
            timer.start();
            select(session, likeness);
            qInfo("%s of half of %d distinct styles: %lld ms", likeness, count, timer.elapsed());
            QCOMPARE(session.selection().size(), std::size_t(count / 2));
        }
    }
};

} // namespace session_select_alike_test

TEST_CLASS(session_select_alike_test::SelectAlikeTest, Core)
#include "tests/app/session/select_alike_test.moc"
