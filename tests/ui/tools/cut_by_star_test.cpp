// SPDX-License-Identifier: GPL-3.0-or-later
// A person draws a star over the street map, makes it a clip window, cuts a rotated rectangle out
// of it, crops, undoes it, and exports the rest on sheets of A4: by events alone. The command line
// makes the same sheets.
#include "app/document/window_shape.h"
#include "app/session/samples.h"
#include "app/view/frame_handles.h"

#include <QAbstractButton>
#include <QDir>
#include <QImage>
#include <QLabel>
#include <QListView>
#include <QRadioButton>

#include <glm/trigonometric.hpp>

#include "tests/app/command_line/program.h"
#include "tests/app/scene/block_scene.h"
#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace tools_cut_by_star_test {

namespace {

void clickOn(QWidget* widget) { QTest::mouseClick(widget, Qt::LeftButton, {}, {8, 8}); }

/// The map is on the canvas, without a clip window.
void openMap(Hand& h)
{
    const auto samples = app::samples();
    const auto map = std::ranges::find(samples, QString("street-map"), &app::Sample::key);
    QVERIFY(map != samples.end());
    h.t.window->files().openSample(*map);
    h.t.window->files().wait();
    h.canvas.fitPage();
    h.canvas.setFocus();
    h.t.run("remove-window"); // the sample has one
}

QList<QAbstractButton*> choices(Hand& h, const char* segments)
{
    return h.t.window->findChild<QWidget*>(segments)->findChildren<QAbstractButton*>();
}

/// From corner to corner, also inside another window.
void drawHole(Hand& h, app::Point from, app::Point to)
{
    QTest::mousePress(&h.surface(), Qt::LeftButton, Qt::AltModifier, h.at(from));
    h.move(to, Qt::LeftButton);
    h.release(to);
    QTest::keyClick(&h.surface(), '-');
}

/// A rectangle that cuts out is drawn, and turned by its handle.
void cutOutRotated(Hand& h, app::Point from, app::Point to)
{
    clickOn(choices(h, "window-shapes").front());
    drawHole(h, from, to);
    const app::Point middle((from.x + to.x) / 2, std::min(from.y, to.y));
    const double above = app::rotationHandleAbove / h.canvas.view().zoom;
    h.drag(middle - app::Point(0, above), middle + app::Point(15, -above));
}

QString numbersText(std::initializer_list<double> numbers)
{
    QStringList texts;
    for (const double number : numbers)
        texts << QString::number(number, 'g', 17);
    return texts.join(u',');
}

/// The windows of the drawing for the command line: the star's corners, and the rectangle.
QStringList windowOptions(const app::ClipWindows& windows)
{
    QStringList corners;
    const auto star = std::get<app::PathShape>(windows.list[0].shape).path.subpaths().front();
    corners << numbersText({star.start.x, star.start.y});
    for (const app::PathSegment& side : star.segments)
        corners << numbersText({side.to.x, side.to.y});
    const auto& hole = std::get<app::RectangleShape>(windows.list[1].shape);
    const auto& [min, max] = hole.box;
    return {"-w", "polygon:" + corners.join(u' '), "--cut-out",
            numbersText({min.x, min.y, max.x, max.y}) + '@'
                + QString::number(-glm::degrees(hole.angle), 'g', 17)};
}

/// How rsvg-convert paints a file, at 96 dpi.
QImage seen(const QString& file)
{
    const QString png = file + ".png";
    return runProgram("rsvg-convert", {"-b", "white", "-o", png, file}).code == 0 ? QImage(png)
                                                                                  : QImage();
}

/// The share of pixels that differ visibly.
double difference(const QImage& a, const QImage& b)
{
    int different = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            different += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 40;
    return a.size() == b.size() ? double(different) / a.width() / a.height() : 1;
}

bool hasInk(const QImage& picture)
{
    QImage white(picture.size(), picture.format());
    white.fill(Qt::white);
    return difference(picture, white) > 0.001;
}

} // namespace

class CutByStarTest : public QObject {
    Q_OBJECT

private slots:
    void fromStarToCroppedMapAndBack()
    {
        Hand h({});
        openMap(h);
        const app::Document before = h.session.now();
        const auto visible = [&] {
            return visibleIn(h.session.scene.lines(), h.session.region(), h.session.variant());
        };
        const std::size_t all = visible();
        QCOMPARE(all, h.session.scene.lines().size());

        h.key(Qt::Key_S);
        h.drag({210, 150}, {210, 30});
        h.key(Qt::Key_G); // selects what was just drawn
        h.key(Qt::Key_Escape);
        QCOMPARE(h.session.selection().size(), 1u);
        h.key(Qt::Key_W);
        QTest::mouseClick(h.t.window->findChild<QAbstractButton*>("window-from-selection"),
                          Qt::LeftButton);
        QCOMPARE(h.session.now().windows().list.size(), 1u);
        const std::size_t inStar = visible();
        QVERIFY2(inStar > 1000 && inStar < all, qPrintable(QString::number(inStar)));

        drawHole(h, {190, 130}, {230, 160});
        const double above = app::rotationHandleAbove / h.canvas.view().zoom;
        h.drag({210, 130 - above}, {225, 130 - above});
        const auto& list = h.session.now().windows().list;
        QCOMPARE(list.size(), 2u);
        const auto hole = std::get<app::RectangleShape>(list[1].shape);
        QVERIFY(hole.angle > 0.1 && list[1].operation == app::WindowOperation::CutOut);
        const std::size_t left = visible();
        QVERIFY2(left > 0 && left < inStar, qPrintable(QString("%1 of %2").arg(left).arg(inStar)));
        QCOMPARE(h.t.window->findChild<QListView*>("clip-windows")->model()->rowCount(), 2);

        const std::size_t objects = h.session.now().objects().size();
        h.t.run("crop");
        QVERIFY(h.session.now().objects().size() < objects);
        QVERIFY(h.session.now().windows().list.size() == 2u);
        for (int step = h.session.history.index(); step > 1; --step)
            h.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(h.session.now() == before);
    }

    void aCircleCroppedAtItselfStaysWhole()
    {
        Hand h({});
        h.session.document.apply({.windows = app::ClipWindows()});
        h.key(Qt::Key_E);
        h.drag({100, 100}, {160, 160});
        h.key(Qt::Key_G);
        h.key(Qt::Key_Escape);
        const app::Document before = h.session.now();
        QCOMPARE(before.objects().size(), std::size_t(1));
        h.key(Qt::Key_W);
        QTest::mouseClick(h.t.window->findChild<QAbstractButton*>("window-from-selection"),
                          Qt::LeftButton);
        QCOMPARE(h.session.now().windows().list.size(), std::size_t(1));
        h.t.run("crop");
        QVERIFY(h.session.now().objects()[0].path() == before.objects()[0].path());
        h.t.run("cut-out");
        QCOMPARE(h.session.now().objects().size(), std::size_t(0));
    }

    void fromStarToSheetsOfPaper()
    {
        Hand h({});
        openMap(h);
        h.t.window->resize(1280, 800);
        QTest::keyClick(h.t.window.get(), Qt::Key_2, Qt::ControlModifier | Qt::AltModifier); // Cut
        h.canvas.fitPage();
        const auto visible = [&] {
            return visibleIn(h.session.scene.lines(), h.session.region(), h.session.variant());
        };
        h.canvas.setFocus();
        h.key(Qt::Key_W);
        clickOn(choices(h, "window-shapes")[3]); // Star
        h.drag({60, 20}, {360, 280});
        const std::size_t inStar = visible();
        QVERIFY(inStar > 5000 && inStar < h.session.scene.lines().size());
        cutOutRotated(h, {180, 110}, {240, 170});
        QVERIFY(visible() < inStar);
        const app::Document before = h.session.now();
        QCOMPARE(before.windows().list.size(), 2u);
        QVERIFY(std::get<app::RectangleShape>(before.windows().list[1].shape).angle > 0.1);

        h.key(Qt::Key_X, Qt::ControlModifier | Qt::ShiftModifier); // Crop to windows
        h.t.window->files().wait();
        QVERIFY(h.session.now().objects().size() < before.objects().size());
        h.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(h.session.now() == before);

        h.key(Qt::Key_T, Qt::ControlModifier);
        app::LiveSheets& sheets = h.t.window->sheets();
        QVERIFY(sheets.isOpen());
        sheets.wait();
        QCOMPARE(sheets.settings().paper, "A4");
        auto* exporting = h.t.window->findChild<QAbstractButton*>("export-sheets");
        h.t.answers->directory = h.t.folder.path();
        clickOn(exporting);
        h.t.window->files().wait();
        const QDir folder(h.t.folder.path());
        const QStringList names = folder.entryList({"*-?-?.svg"}, QDir::Files, QDir::Name);
        QCOMPARE(sheets.tiling().value->tiles.size(), 6u);
        QCOMPARE(names.size(), 4); // the star does not reach the other two

        QDir().mkpath(h.t.path("command"));
        const auto run =
            clearcut(QStringList{"clip", SOURCE_DIR "/resources/samples/street-map.svg", "--tiles",
                                 "a4", "--overlap", "10mm", "--marks", "-o",
                                 h.t.path("command/sheet-{row}-{column}.svg")}
                     + windowOptions(before.windows()));
        QVERIFY2(run.code == 0, run.err.constData());
        QCOMPARE(QDir(h.t.path("command")).entryList({"*.svg"}).size(), names.size());
        int inked = 0;
        for (const QString& name : names) {
            const QImage mine = seen(folder.filePath(name));
            QCOMPARE(mine.size(), QSize(794, 1123)); // A4 at 96 dpi
            inked += hasInk(mine);
            const QString place = name.section('-', -2); // "1-2.svg"
            const QImage theirs = seen(folder.filePath("command/sheet-" + place));
            const double share = difference(mine, theirs);
            QVERIFY2(share < 2e-3, qPrintable(QString("%1: %2").arg(name).arg(share)));
        }
        QVERIFY(inked >= 4);

        clickOn(h.t.window->findChild<QRadioButton*>("one-pdf"));
        h.t.answers->save = h.t.path("all.pdf");
        clickOn(exporting);
        h.t.window->files().wait();
        const auto info = runProgram("pdfinfo", {h.t.path("all.pdf")});
        QVERIFY2(info.out.contains(QString("Pages:           %1\n").arg(names.size()).toUtf8())
                     && info.out.contains("(A4)"),
                 info.out.constData());
    }
};

} // namespace tools_cut_by_star_test

TEST_CLASS(tools_cut_by_star_test::CutByStarTest, Widgets)
#include "tests/ui/tools/cut_by_star_test.moc"
