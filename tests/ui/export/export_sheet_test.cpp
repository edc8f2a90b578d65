// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/add_and_remove.h"
#include "app/commands/history.h"
#include "app/export/remembered_choice.h"
#include "app/session/export_source.h"
#include "app/session/window_steps.h"
#include "ui/export/export_preview.h"
#include "ui/export/export_sheet.h"
#include "ui/widgets/segments.h"

#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>

#include "tests/content_of.h"
#include "tests/test_class.h"
#include "tests/ui/export/output_desk.h"

namespace ui::export_export_sheet_test {

namespace {

/// The editor with two layers: a red square of 20 mm with a stroke of 2 mm, and a line across the
/// page; at a clip window of 40 × 30 mm.
class Desk : public OutputDesk<ExportSheet> {
public:
    Desk()
        : OutputDesk(
            "export", "logo.svg",
            "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='80mm' "
            "viewBox='0 0 100 80' xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape'"
            " xmlns:clearcut='urn:clearcut:1'><metadata>"
            "<clearcut:window xmin='5' ymin='5' xmax='45' ymax='35'/></metadata>"
            "<g inkscape:groupmode='layer' inkscape:label='Logo'>"
            "<rect x='10' y='10' width='20' height='20' fill='#c00000' stroke='#c00000' "
            "stroke-width='2'/></g>"
            "<g inkscape:groupmode='layer' inkscape:label='Lines'>"
            "<path d='M0 50H100' stroke='#000' fill='none'/></g></svg>")
    {
    }
    void press(const char* name)
    {
        part<QAbstractButton>(name).click();
        settle();
    }
    void pick(const char* segments, const QString& choice)
    {
        for (auto* button : part(segments).findChildren<QToolButton*>())
            if (button->text() == choice) {
                button->click();
                return settle();
            }
        qFatal("no choice %s", qPrintable(choice));
    }
    QString text(const char* label)
    {
        return part<QLabel>(label).text().replace(QChar::Nbsp, u' ');
    }
    void select(std::size_t object) { window->session().select(app::ObjectRanges{object}); }
    void write(const QString& path)
    {
        part<QLineEdit>("export-file").setText(path);
        part<QPushButton>("write-export").click();
        window->files().wait();
    }
    bool isShown(const char* name) { return part(name).isVisible(); }
};

} // namespace

class ExportSheetTest : public QObject {
    Q_OBJECT

private slots:
    void copyPutsOnTheClipboardWhatWouldBeWritten()
    {
        Desk t;
        t.openSheet();
        t.part<QAbstractButton>("write-export").click();
        t.window->files().wait();
        const QByteArray written = contentOf(t.window->files().lastExport()->file);
        t.openSheet();
        t.press("copy-export");
        t.window->files().wait();
        const QMimeData* copied = QGuiApplication::clipboard()->mimeData();
        QVERIFY(written.contains("<svg"));
        QCOMPARE(copied->data("image/svg+xml"), written);
        QCOMPARE(copied->text(), QString::fromUtf8(written));
        QVERIFY(t.window->message().startsWith("Copied as SVG"));
        QVERIFY(t.window->sheet()); // what was chosen stays
        t.press("export-as-png");
        t.press("copy-export");
        t.window->files().wait();
        copied = QGuiApplication::clipboard()->mimeData();
        QVERIFY(!QImage::fromData(copied->data("image/png"), "png").isNull());
        QVERIFY(!copied->hasText());
    }
    /// The drawing is not seen: no key and no command changes it, or what is selected.
    void nothingReachesTheDrawingBehindThePreview()
    {
        Desk t;
        t.select(0);
        t.openSheet();
        auto* preview = t.window->findChild<ExportPreview*>();
        preview->setFocus();
        const auto before = t.window->session().now();
        const auto tool = t.window->canvas().tool();
        for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_T, Qt::Key_3})
            QTest::keyClick(QApplication::focusWidget(), key);
        for (const Qt::Key key : {Qt::Key_A, Qt::Key_D, Qt::Key_Z})
            QTest::keyClick(QApplication::focusWidget(), key, Qt::ControlModifier);
        QCOMPARE(t.window->session().now(), before);
        QCOMPARE(t.window->session().selection(), app::ObjectRanges{0});
        QCOMPARE(t.window->canvas().tool(), tool);
        QVERIFY(!t.action("delete")->isEnabled() && !t.action("crop")->isEnabled());
        QVERIFY(t.action("save-as")->isEnabled() && t.action("find-command")->isEnabled());
        QCOMPARE(t.action("delete")->statusTip(), "Close the preview first (Esc).");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QTRY_VERIFY(!t.window->sheet() && t.action("delete")->isEnabled());
    }
    void theNameSaysWhatIsInTheFileUntilAnotherIsTyped()
    {
        Desk t;
        t.openSheet();
        const auto name = [&t] {
            return QFileInfo(t.part<QLineEdit>("export-file").text()).fileName();
        };
        t.press("export-page");
        QVERIFY2(name().endsWith("-page.svg"), qPrintable(name()));
        t.press("export-layer");
        QVERIFY2(name().endsWith("-Lines.svg") || name().endsWith("-Logo.svg"), qPrintable(name()));
        t.press("export-as-png");
        t.press("export-page");
        QVERIFY2(name().endsWith("-page.png"), qPrintable(name()));
        t.part<QLineEdit>("export-file").setText("mine.png");
        t.press("export-layer");
        QCOMPARE(name(), QString("mine.png"));
    }
    void anotherAreaStaysInTheFolderOfTheLastExport()
    {
        Desk t;
        t.openSheet();
        QVERIFY(QDir(t.path({})).mkdir("out"));
        t.press("export-page");
        t.write(t.path("out/page.svg"));
        t.openSheet();
        t.press("export-layer");
        const QString file = t.part<QLineEdit>("export-file").text();
        QCOMPARE(QFileInfo(file).dir().dirName(), QString("out"));
        QVERIFY2(file.endsWith("-Lines.svg") || file.endsWith("-Logo.svg"), qPrintable(file));
    }
    void dxfSaysItsRealSize()
    {
        Desk t;
        app::Page page = t.window->session().now().page();
        page.scale = {50, app::Unit::Metre};
        page.size *= 50.0;
        t.window->session().document.apply({.page = page});
        t.openSheet();
        t.press("export-page");
        QVERIFY(!t.text("export-size").contains("real"));
        t.press("export-as-dxf");
        QVERIFY2(t.text("export-size").contains(" m</b> in the file, which has real lengths"),
                 qPrintable(t.text("export-size")));
    }
    void aPartOfAnotherDrawingIsNotRemembered()
    {
        for (const auto& [kept, next] : {std::pair(app::ExportPart::Layer, app::ExportPart::Cut),
                                         std::pair(app::ExportPart::Page, app::ExportPart::Page)}) {
            Desk t;
            QSettings settings;
            app::remember(settings, {{}, {}, {.format = "png", .area = {.part = kept}}});
            QCOMPARE(t.window->files().usualExport().format, std::string("png"));
            QCOMPARE(t.window->files().usualExport().area.part, next);
        }
    }
    void thePreviewStandsInPlaceOfTheDrawing()
    {
        Desk t;
        const app::Document before = t.window->session().now();
        ExportSheet& sheet = t.openSheet();
        QVERIFY(sheet.shown().isVisible() && !t.window->canvas().isVisible());
        QTest::keyClick(&sheet.shown().view(), Qt::Key_Escape);
        QVERIFY(!t.window->sheet() && t.window->canvas().isVisible());
        QTRY_COMPARE(t.window->focusWidget(), t.drawingArea());
        QVERIFY(sameAddress(before, t.window->session().now()));
        QVERIFY(t.window->session().history.isClean());
    }
    // Only what the chosen format can do.
    void optionsAreThoseOfTheFormat()
    {
        Desk t;
        t.openSheet();
        const auto shown = [&t] {
            QStringList names;
            for (const char* name : {"export-projection", "export-paper", "export-dpi",
                                     "export-background", "export-decimals", "export-pixels"})
                if (t.isShown(name))
                    names << QString(name).mid(7);
            return names.join(u' ');
        };
        QCOMPARE(shown(), "paper decimals");
        t.press("export-as-pdf");
        QCOMPARE(shown(), "paper background decimals");
        t.press("export-as-png");
        QCOMPARE(shown(), "paper dpi background pixels");
        t.press("export-as-csv");
        QCOMPARE(shown(), "decimals");
        t.press("export-as-geojson");
        QCOMPARE(shown(), "projection decimals");
    }
    // On a page of 100 by 80 units, which begins at the origin, with a line at y = 50.
    void aMapIsWrittenInDegrees()
    {
        Desk t;
        t.openSheet();
        t.press("export-as-geojson");
        t.press("export-page");
        t.pick("export-projection", "Web Mercator");
        QVERIFY(!t.text("export-losses").contains("map"));
        const QString path = t.path("map.geojson");
        t.write(path);
        const QByteArray map = contentOf(path);
        QVERIFY2(map.contains("[[0,28.71"), map); // of 30 degrees on the plane
        t.openSheet();
        QCOMPARE(t.part<Segments>("export-projection").chosen(), 1);
        app::Page page = t.window->session().now().page();
        page.min = {0, -300}; // the origin of the file is that of the units
        page.size.y = 600;
        t.window->session().document.apply({.page = page});
        app::Objects lines;
        lines.append(
            {app::Path(clipping::Segment{{0, -200}, {50, -250}}), {.stroke = app::Colour{}}});
        t.window->session().history.push(new app::AddObjects(
            t.window->session().document, lines, t.window->session().pen.layer, "Draw"));
        t.settle();
        QVERIFY2(t.text("export-losses").contains("2 positions lie outside the map"),
                 qPrintable(t.text("export-losses")));
    }
    void theResultIsThatOfTheArea()
    {
        Desk t;
        t.openSheet();
        QCOMPARE(t.text("export-size"), "<b>40.00 × 30.00 mm</b>");
        QCOMPARE(t.text("export-length"), "<b>80.00 mm</b>");
        QCOMPARE(t.text("export-paths"), "<b>1</b> of 2, on 1 layer");
        QVERIFY2(t.text("export-bytes").endsWith("bytes</b>"), qPrintable(t.text("export-bytes")));
        t.press("export-page");
        QCOMPARE(t.text("export-size"), "<b>100.00 × 80.00 mm</b>");
        QCOMPARE(t.text("export-paths"), "<b>2</b>, on 2 layers");
    }
    void aLogoBecomesATransparentPictureOfItsSelection()
    {
        Desk t;
        t.select(0);
        t.openSheet();
        t.press("export-as-png");
        t.press("export-selection");
        t.pick("export-background", "Transparent");
        t.pick("export-usual-dpi", "96");
        QCOMPARE(t.text("export-size"), "<b>22.00 × 22.00 mm</b>");
        QCOMPARE(t.text("export-pixels"), "<b>83 × 83 pixels</b>");
        const QString path = t.path("logo.png");
        t.write(path);
        QVERIFY2(!t.window->sheet(), qPrintable(t.window->message()));
        const QImage image(path);
        QCOMPARE(image.size(), QSize(83, 83));
        QVERIFY(image.hasAlphaChannel());
        QCOMPARE(image.pixelColor(41, 41), QColor(0xc0, 0, 0));
        QVERIFY(image.pixelColor(0, 41).red() > 0xa0); // the stroke, up to the edge
    }
    void whatIsNotPossibleSaysWhy()
    {
        Desk t;
        t.openSheet();
        auto& selection = t.part<QRadioButton>("export-selection");
        QVERIFY(!selection.isEnabled());
        QCOMPARE(selection.toolTip(), "Not possible: nothing is selected");
        t.select(1);
        t.settle();
        QVERIFY(selection.isEnabled());
        t.window->session().document.apply({.windows = app::ClipWindows()});
        t.settle();
        QVERIFY(!t.part<QRadioButton>("export-cut").isEnabled());
        QVERIFY(t.part<QRadioButton>("export-page").isChecked()); // instead
    }
    void anImpossibleResolutionIsRefusedInASentence()
    {
        Desk t;
        t.openSheet();
        t.press("export-as-png");
        auto& dpi = t.part<QLineEdit>("export-dpi");
        for (const char* typed : {"0", "1e9", "-3", "nan", "many"}) {
            dpi.setFocus();
            dpi.selectAll();
            QTest::keyClicks(&dpi, typed);
            QTest::keyClick(&dpi, Qt::Key_Return);
            QVERIFY(t.isShown("export-refusal"));
            QCOMPARE(t.text("export-refusal"),
                     QStringLiteral("“%1” is not possible: give 1 to 100,000 dpi.").arg(typed));
            QCOMPARE(t.sheet().live().choice().dpi, 300.0);
        }
        // A possible one can be too much for the area.
        dpi.selectAll();
        QTest::keyClicks(&dpi, "100000");
        QTest::keyClick(&dpi, Qt::Key_Tab);
        t.settle();
        QVERIFY2(t.text("export-error").contains("Choose"), qPrintable(t.text("export-error")));
        QVERIFY(!t.part<QPushButton>("write-export").isEnabled());
    }
    void theFileFollowsTheFormatAndSaysWhatItReplaces()
    {
        Desk t;
        t.openSheet();
        auto& file = t.part<QLineEdit>("export-file");
        QCOMPARE(QFileInfo(file.text()).fileName(), "logo-cut.svg");
        t.press("export-as-pdf");
        QCOMPARE(QFileInfo(file.text()).fileName(), "logo-cut.pdf");
        QVERIFY(!t.isShown("export-file-remark"));
        file.setText(t.path("logo.svg"));
        QVERIFY(!t.isShown("export-file-remark")); // logo.svg.pdf is new
        t.file("old.pdf", "old");
        file.setText(t.path("old.pdf"));
        QVERIFY2(t.text("export-file-remark").startsWith("Replaces old.pdf of "),
                 qPrintable(t.text("export-file-remark")));
        file.setText(t.path("nowhere/a.pdf"));
        QVERIFY(t.text("export-file-remark").startsWith("There is no folder"));
        t.part<QPushButton>("write-export").click();
        t.window->files().wait();
        QVERIFY2(t.window->message().contains("nowhere/a.pdf"), qPrintable(t.window->message()));
        QVERIFY(t.window->sheet()); // nothing that was chosen is lost
    }
    void choicesAreRememberedPerFormatAndExportedAgain()
    {
        Desk t;
        t.select(0);
        t.openSheet();
        t.press("export-as-png");
        t.press("export-selection");
        t.pick("export-usual-dpi", "150");
        const QString path = t.path("again.png");
        t.write(path);
        QVERIFY(QFile::remove(path));
        t.run("export-again");
        QVERIFY(!t.window->sheet());
        QCOMPARE(QImage(path).width(), int(std::round(22 / 25.4 * 150)));
        QVERIFY2(t.window->message().startsWith("Exported again.png"),
                 qPrintable(t.window->message()));
        t.openSheet();
        QCOMPARE(t.sheet().live().choice().dpi, 150.0);
        QVERIFY(t.part<QRadioButton>("export-selection").isChecked());
        QCOMPARE(t.sheet().live().choice().format, std::string("png"));
        t.window->closeSheet();
        // The selection is gone: nothing else is written over the file.
        const QByteArray before = contentOf(path);
        t.window->session().select({});
        t.run("export-again");
        QVERIFY2(t.window->message().contains("nothing is selected"),
                 qPrintable(t.window->message()));
        QCOMPARE(contentOf(path), before);
    }
    void aWindowIsFoundAgainOrTheSheetOpens()
    {
        Desk t;
        app::Session& session = t.window->session();
        const auto lay = [&session](double from) {
            app::addWindow(session, {.name = QStringLiteral("W%1").arg(from),
                                     .shape = app::RectangleShape{{{from, 0}, {from + 20, 20}}}});
        };
        lay(0);
        lay(50);
        app::ExportChoice choice{.area = {.part = app::ExportPart::Window}};
        choice.area.window = session.windows().list.size() - 1;
        const QString path = t.path("window.svg");
        t.window->files().exportTo({app::exportSourceOf(session), choice}, path);
        t.window->files().wait();
        const QByteArray before = contentOf(path);
        QVERIFY(!before.isEmpty());
        app::reorderWindow(session, choice.area.window, 0);
        QVERIFY(QFile::remove(path));
        t.run("export-again");
        QCOMPARE(contentOf(path), before); // the same window
        session.chooseWindow(0);
        app::removeWindow(session);
        t.run("export-again");
        QCOMPARE(contentOf(path), before);
        QVERIFY(t.window->sheet());
    }
    void withoutAnEarlierExportTheSheetOpens()
    {
        Desk t;
        t.run("export-again");
        QVERIFY(t.window->sheet());
        QCOMPARE(t.window->sheet()->objectName(), "export");
    }
    void aLayerBecomesAFile()
    {
        Desk t;
        t.openSheet();
        t.press("export-as-pdf");
        auto& layers = t.part<QComboBox>("export-layer");
        QCOMPARE(layers.count(), 2);
        layers.setCurrentText("Lines");
        emit layers.activated(layers.currentIndex());
        t.settle();
        QCOMPARE(t.text("export-paths"), "<b>1</b> of 2, on 1 layer");
        QCOMPARE(t.text("export-size"), "<b>100.00 × 1.00 mm</b>");
        t.pick("export-paper", "Whole page");
        QCOMPARE(t.text("export-size"), "<b>100.00 × 80.00 mm</b>");
        t.write(t.path("lines.pdf"));
        QVERIFY(contentOf(t.path("lines.pdf")).startsWith("%PDF"));
    }
    void theSameAreaIsPrinted()
    {
        Desk t;
        t.openSheet();
        t.press("export-page");
        t.part<QPushButton>("print-export").click();
        QCOMPARE(t.window->sheet()->objectName(), "print");
        QVERIFY(t.window->sheet()->findChild<QRadioButton*>("export-page")->isChecked());
    }
    // What lies outside the window is not on the preview, and what lies inside is.
    void thePreviewShowsOnlyWhatIsWritten()
    {
        Desk t;
        ExportView& view = t.openSheet().shown().view();
        view.settle();
        const QImage shown = view.grab().toImage();
        const auto at = [&](double x, double y) {
            const app::Point p = view.view().toScreen({x, y}) * shown.devicePixelRatio();
            return shown.pixelColor(int(p.x), int(p.y));
        };
        QCOMPARE(at(20, 20), QColor(0xc0, 0, 0));
        QCOMPARE(at(40, 20), QColor(Qt::white));
        const app::Point line = view.view().toScreen({20, 50});
        if (line.y < view.height())
            QVERIFY(at(20, 50) != QColor(Qt::black));
    }
};

} // namespace ui::export_export_sheet_test

TEST_CLASS(ui::export_export_sheet_test::ExportSheetTest, Widgets)
#include "tests/ui/export/export_sheet_test.moc"
