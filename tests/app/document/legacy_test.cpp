// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets come back from documents as they were; of richer documents comes what a sheet can hold.
#include "app/document/document_builder.h"

#include <QDir>
#include <QTest>

#include "tests/app/document/random_sheets.h"
#include "tests/app/document/sheet.h"
#include "tests/app/formats/svg/text.h"
#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace document_legacy_test {

using namespace app;

namespace {

Container layer(const QString& name, bool visible = true, bool locked = false)
{
    return {.name = name, .svgId = name.toLower(), .visible = visible, .locked = locked};
}

Container group(bool visible)
{
    return {.kind = Container::Kind::Group, .name = "Group", .visible = visible, .locked = true};
}

// An object that is known by its id.
Object object(const QString& id)
{
    return {Path(clipping::Segment{{1, 2}, {3, 4}}), {.width = 2}, {.id = id, .title = "lost"}};
}

// "Layer: object object; Layer", with "-" before what is hidden and "!" behind a locked layer.
QString told(const Sheet& sheet)
{
    QStringList layers;
    std::size_t at = 0;
    for (std::size_t i = 0; i < sheet.layers.size(); ++i) {
        const Layer& layer = sheet.layers[i];
        QString text = (layer.visible ? "" : "-") + layer.name + (layer.locked ? "!" : "") + ":";
        for (; at < sheet.shapes.size() && sheet.shapes[at].layer == i; ++at)
            text +=
                QStringLiteral(" ") + (sheet.shapes[at].hidden ? "-" : "") + sheet.shapes[at].id;
        layers << text;
    }
    return layers.join("; ");
}

} // namespace

class LegacyTest : public QObject {
    Q_OBJECT

private slots:
    void files_data()
    {
        QTest::addColumn<QString>("path");
        for (const char* place : {"/tests/app/formats/data", "/resources/samples"}) {
            const QDir folder(SOURCE_DIR + QString(place));
            for (const QString& name : notEmpty(folder.entryList({"*.svg"})))
                QTest::newRow(qPrintable(name)) << folder.filePath(name);
        }
    }
    void files()
    {
        QFETCH(QString, path);
        const auto read = readText(contentOf(path));
        QVERIFY2(read, qPrintable(read.error));
        const Sheet sheet = sheetOf(read.value->document);
        QCOMPARE(sheet.shapes.size(), read.value->document.objects().size());
        QVERIFY(sheetOf(documentOf(sheet)) == sheet);
    }

    void randomSheets()
    {
        RandomSheets sheets(2);
        for (int i = 0; i < 3000; ++i) {
            Sheet sheet = sheets.sheet();
            if (i % 8 == 0)
                sheet.window = {sheet.window.max, sheet.window.min}; // inverted
            if (i % 8 == 1)
                sheet.about = {"root", "<!-- c -->", "<title/>", "<desc/>", "<metadata/>"};
            if (i % 8 == 2 && !sheet.shapes.empty())
                sheet.shapes.back().paths.clear();
            const Document document = documentOf(sheet);
            QVERIFY(sheetOf(document) == sheet);
            for (std::size_t n = 0; n < sheet.shapes.size(); ++n) {
                QCOMPARE(document.shown(n), sheet.shown(sheet.shapes[n]));
                QCOMPARE(document.editable(n), sheet.shown(sheet.shapes[n])
                                                   && !sheet.layers[sheet.shapes[n].layer].locked);
            }
        }
    }

    void aSheetHasOneNamelessWindow()
    {
        Sheet sheet;
        sheet.window = {{1, 2}, {3, 4}};
        const ClipWindows expected{{{.shape = RectangleShape{{{1, 2}, {3, 4}}}}}};
        QVERIFY(documentOf(sheet).windows() == expected);
    }

    void theWindowOfADocument()
    {
        const auto windowOf = [](ClipWindows windows) {
            return sheetOf(DocumentBuilder().take({}, {}, std::move(windows))).window;
        };
        const ClipWindow hidden{.shape = RectangleShape{{{1, 1}, {2, 2}}}, .visible = false};
        const ClipWindow turned{.shape = RectangleShape{{{3, 3}, {4, 4}}, 0.5}};
        const ClipWindow cutOut{.shape = RectangleShape{{{5, 5}, {6, 6}}},
                                .operation = WindowOperation::CutOut};
        QVERIFY(windowOf({}) == Page{}.rectangle());
        QVERIFY(windowOf({{hidden, turned}}) == Page{}.rectangle());
        QVERIFY((windowOf({{hidden, turned, cutOut}}) == clipping::Window{{5, 5}, {6, 6}}));
    }

    void layersInLayersFollowEachOther()
    {
        DocumentBuilder builder;
        builder.open(layer("Map"));
        builder.add(object("a"));
        builder.open(layer("Roads", false));
        builder.add(object("b"));
        builder.open(layer("Empty"));
        builder.close();
        builder.open(layer("Paths", true, true));
        builder.add(object("c"));
        builder.close();
        builder.add(object("d"));
        builder.close();
        builder.add(object("e"));
        builder.add(object("f"));
        builder.open(layer("Last"));
        builder.close();
        builder.close();
        const Sheet sheet = sheetOf(builder.take({}));
        QCOMPARE(told(sheet), QString("Map: a; -Roads: b; -Empty:; -Paths!: c; -Roads (2): d; "
                                      "Map (2): e f; Last:"));
        QCOMPARE(sheet.layers[0].id, QString("map"));
        QCOMPARE(sheet.layers[5].id, QString());
    }

    void groupsDissolve()
    {
        DocumentBuilder builder;
        builder.open(layer("Layer"));
        builder.add(object("a"));
        builder.open(group(true));
        builder.add(object("b"));
        builder.open(group(false));
        builder.add(object("c"));
        builder.open(group(true));
        builder.add(object("d"));
        builder.close();
        builder.close();
        builder.add(object("e"));
        builder.close();
        builder.add(object("f"));
        builder.close();
        QCOMPARE(told(sheetOf(builder.take({}))), QString("Layer: a b -c -d e f"));
    }

    void nothing()
    {
        const Sheet sheet = sheetOf(Document());
        QCOMPARE(told(sheet), QString("Drawing:"));
        QVERIFY(sheet == Sheet{});
        QVERIFY(sheet.about == About{});
    }
};

} // namespace document_legacy_test

TEST_CLASS(document_legacy_test::LegacyTest, None)
#include "tests/app/document/legacy_test.moc"
