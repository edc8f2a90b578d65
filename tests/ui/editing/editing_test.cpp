// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/session.h"
#include "ui/editing/editing.h"

#include <QBuffer>
#include <QClipboard>
#include <QGuiApplication>
#include <QSignalSpy>
#include <QTest>

#include "tests/test_class.h"

namespace editing_editing_test {

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
    app::ImagePlacing placing{session};
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
        app::duplicateInPlace(stage.session);
        QCOMPARE(stage.edits, 1);
        QCOMPARE(stage.session.history.count(), 1);
        QCOMPARE(stage.session.history.text(0), "Duplicate");

        const app::Document after = stage.now();
        QCOMPARE(after.objects().size(), std::size_t(2 * groups));
        QCOMPARE(after.containers().size(), before.containers().size() + groups);
        for (std::size_t i = 0; i < groups; ++i) {
            const app::ContainerId copy = after.containers().containerOf(groups + i);
            QCOMPARE(after.containers().rangeOf(copy),
                     (app::ObjectRange{groups + i, groups + i + 1}));
            QVERIFY(after.objects()[groups + i].path() == before.objects()[i].path());
            QVERIFY(stage.session.selection().contains(groups + i));
        }
        QCOMPARE(stage.session.selection().size(), std::size_t(groups));

        stage.session.history.undo();
        QCOMPARE(stage.edits, 2);
        QVERIFY(stage.now() == before);
        QCOMPARE(stage.session.selection().size(), std::size_t(groups));
        QCOMPARE(svgOf(stage.now()), svgOf(before));
        stage.session.history.redo();
        QCOMPARE(stage.edits, 3);
        QVERIFY(stage.now() == after);
        QCOMPARE(svgOf(stage.now()), svgOf(after));
    }
    void aCopyInAnEnteredGroupStaysInIt()
    {
        app::DocumentBuilder builder;
        const auto layer = builder.open({.name = "layer"});
        builder.add(line(0));
        const auto group = builder.open({.kind = app::Container::Kind::Group});
        builder.add(line(1));
        builder.close();
        builder.close();
        Stage stage(builder.take({}));
        stage.session.entered.enter(group);
        selectAll(stage.session);
        QCOMPARE(stage.session.selection(), (app::ObjectRanges{1}));
        app::duplicateInPlace(stage.session);
        copySelection(stage.session);
        QCOMPARE(paste(stage.session, QGuiApplication::clipboard()->mimeData(),
                       app::PastePlace::InPlace, {}, stage.placing),
                 QString());
        const app::Containers& tree = stage.now().containers();
        QCOMPARE(tree.rangeOf(group), (app::ObjectRange{1, 4}));
        QCOMPARE(tree.size(), std::size_t(2)); // the copy is in no group of its own
        stage.session.entered.enter(0);
        stage.session.select({0});
        app::duplicateInPlace(stage.session);
        QCOMPARE(stage.now().containers().containerOf(stage.session.selection().first()), layer);
        QGuiApplication::clipboard()->clear();
    }
    void nothingIsPastedIntoALockedLayer()
    {
        Stage stage(manyGroups());
        selectAll(stage.session);
        copySelection(stage.session);
        app::Container layer = stage.now().containers()[stage.session.pen.layer];
        layer.locked = true;
        app::Edit edit;
        edit.containers = stage.now().containers().with(layer);
        stage.session.document.apply(edit);
        QSignalSpy refused(&stage.session, &app::Session::refused);
        QCOMPARE(paste(stage.session, QGuiApplication::clipboard()->mimeData(),
                       app::PastePlace::Offset, {}, stage.placing),
                 QString());
        QCOMPARE(refused.count(), 1);
        QCOMPARE(stage.session.history.count(), 0);
        QGuiApplication::clipboard()->clear();
    }
    void whatIsLostOfAnotherProgramsDrawingIsTold()
    {
        const QString image = "<image href='photo.png'/>";
        const QString lost =
            "1 image that is neither in the file nor in its folder or below cannot be kept.";
        const auto pasteOf = [](Stage& stage, const QString& elements) {
            QMimeData data;
            data.setText("<svg xmlns='http://www.w3.org/2000/svg'>" + elements + "</svg>");
            return paste(stage.session, &data, app::PastePlace::InPlace, {}, stage.placing);
        };
        Stage stage(manyGroups());
        QCOMPARE(pasteOf(stage, image + "<path d='M0 0H9' stroke='red'/>"), lost);
        QCOMPARE(stage.session.history.count(), 1);
        QCOMPARE(pasteOf(stage, image), lost + " Nothing was pasted.");
        QCOMPARE(pasteOf(stage, "<path d='M0 0H9' stroke='red'/>"), QString());
        QCOMPARE(stage.session.history.count(), 2);
        app::Container layer = stage.now().containers()[stage.session.pen.layer];
        layer.locked = true;
        stage.session.document.apply({.containers = stage.now().containers().with(layer)});
        QCOMPARE(pasteOf(stage, image + "<path d='M0 0H9' stroke='red'/>"), QString()); // refused
    }
    void aPasteIsOneEdit()
    {
        Stage stage(manyGroups());
        const app::Document before = stage.now();
        selectAll(stage.session);
        copySelection(stage.session);
        QCOMPARE(paste(stage.session, QGuiApplication::clipboard()->mimeData(),
                       app::PastePlace::Offset, {}, stage.placing),
                 QString());
        QCOMPARE(stage.edits, 1);
        QCOMPARE(stage.session.history.text(0), "Paste");
        QCOMPARE(stage.session.selection().first(), std::size_t(groups));
        QCOMPARE(stage.session.selection().size(), std::size_t(groups));
        const app::Containers& tree = stage.now().containers();
        QCOMPARE(tree.parentOf(tree.containerOf(groups)), stage.session.pen.layer);
        stage.session.history.undo();
        QVERIFY(stage.now() == before);
        QGuiApplication::clipboard()->clear();
    }
};

} // namespace editing_editing_test

TEST_CLASS(editing_editing_test::EditingTest, Widgets)
#include "tests/ui/editing/editing_test.moc"
