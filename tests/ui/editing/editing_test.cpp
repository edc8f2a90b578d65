// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/session.h"
#include "ui/editing/editing.h"

#include <QBuffer>
#include <QClipboard>
#include <QGuiApplication>
#include <QTest>

using namespace ui;

namespace {

constexpr int groups = 2'000;

app::Object line(double x)
{
    return {app::Path(clipping::Segment{{x, 0}, {x, 1}}), {.stroke = app::Colour{}, .width = 1}};
}

/// A layer of groups with one line each.
app::Document manyGroups()
{
    app::DocumentBuilder builder;
    builder.open({.name = "layer"});
    for (int i = 0; i < groups; ++i) {
        builder.open({.kind = app::Container::Kind::Group});
        builder.add(line(i));
        builder.close();
    }
    builder.close();
    return builder.take({});
}

QByteArray svgOf(const app::Document& document)
{
    QBuffer svg;
    svg.open(QIODevice::WriteOnly);
    app::formats().front().write(document, svg, {});
    return svg.data();
}

/// A session, and how many edits of its document there have been.
struct Stage {
    explicit Stage(app::Document document)
    {
        session.load({std::move(document), {}});
        QObject::connect(&session.document, &app::EditedDocument::changed, &session,
                         [this] { ++edits; });
    }
    const app::Document& now() const { return session.now(); }

    app::Session session;
    int edits = 0;
};

} // namespace

class EditingTest : public QObject {
    Q_OBJECT

private slots:
    void duplicatesOfManyGroupsAreOneEdit()
    {
        Stage stage(manyGroups());
        const app::Document before = stage.now();
        selectAll(stage.session);
        duplicateSelection(stage.session);
        QCOMPARE(stage.edits, 1);
        QCOMPARE(stage.session.history.count(), 1);
        QCOMPARE(stage.session.history.text(0), "Duplicate");

        const app::Document after = stage.now();
        QCOMPARE(after.objects().size(), std::size_t(2 * groups));
        for (std::size_t i = 0; i < groups; ++i) {
            const app::ContainerId group = before.containers().containerOf(i);
            QCOMPARE(after.containers().rangeOf(group), (app::ObjectRange{2 * i, 2 * i + 2}));
            QVERIFY(after.objects()[2 * i].path() == before.objects()[i].path());
            QVERIFY(!stage.session.selection().contains(2 * i));
            QVERIFY(stage.session.selection().contains(2 * i + 1));
        }

        stage.session.history.undo();
        QCOMPARE(stage.edits, 2);
        QVERIFY(stage.now() == before);
        QCOMPARE(svgOf(stage.now()), svgOf(before));
        stage.session.history.redo();
        QCOMPARE(stage.edits, 3);
        QVERIFY(stage.now() == after);
        QCOMPARE(svgOf(stage.now()), svgOf(after));
    }
    void eachCopyIsOnTopOfItsOwnContainer()
    {
        app::DocumentBuilder builder;
        const auto layer = builder.open({.name = "layer"});
        builder.add(line(0));
        const auto outer = builder.open({.kind = app::Container::Kind::Group});
        builder.add(line(1));
        const auto inner = builder.open({.kind = app::Container::Kind::Group});
        builder.add(line(2));
        for (int i = 0; i < 3; ++i)
            builder.close();
        Stage stage(builder.take({}));
        selectAll(stage.session);
        duplicateSelection(stage.session);
        QCOMPARE(stage.edits, 1);
        QCOMPARE(stage.session.selection(), (app::ObjectRanges{3, 4, 5}));
        const app::Document& after = stage.now();
        const app::ContainerId owners[] = {layer, outer, inner, inner, outer, layer};
        const double starts[] = {0, 1, 2, 2, 1, 0};
        const double step = after.objects()[3].singleLine()->a.x - 2;
        QVERIFY(step > 0);
        for (std::size_t i = 0; i < 6; ++i) {
            QCOMPARE(after.containers().containerOf(i), owners[i]);
            QCOMPARE(after.objects()[i].singleLine()->a.x, starts[i] + (i < 3 ? 0 : step));
        }
    }
    void aPasteIsOneEdit()
    {
        Stage stage(manyGroups());
        const app::Document before = stage.now();
        selectAll(stage.session);
        copySelection(stage.session);
        QVERIFY(paste(stage.session));
        QCOMPARE(stage.edits, 1);
        QCOMPARE(stage.session.history.text(0), "Paste");
        QCOMPARE(stage.session.selection().first(), std::size_t(groups));
        QCOMPARE(stage.session.selection().size(), std::size_t(groups));
        QCOMPARE(stage.now().containers().containerOf(groups), stage.session.pen.layer);
        stage.session.history.undo();
        QVERIFY(stage.now() == before);
        QGuiApplication::clipboard()->clear();
    }
};

QTEST_MAIN(EditingTest)
#include "editing_test.moc"
