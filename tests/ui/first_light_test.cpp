// SPDX-License-Identifier: GPL-3.0-or-later
// The whole workflow once, by mouse and keyboard: open a drawing of the kind another program
// writes, draw a clip window, nudge it, switch algorithms, undo, export; then compare the
// export with the picture that librsvg makes of the original, clipped at the same window.
#include "ui/files/files.h"
#include "ui/menus/actions.h"
#include "ui/window/main_window.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QLineEdit>
#include <QProcess>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

#include "tests/app/document/sheet_edits.h"

namespace {

const QString foreign = QStringLiteral(SOURCE_DIR "/tests/ui/data/foreign.svg");

/// No other question is expected.
struct Answers : ui::Questions {
    using Questions::Questions;
    void saveChanges(const QString&, std::function<void(Answer)> answered) override
    {
        answered(Answer::DontSave);
    }
};

QImage rendered(const QString& svg, const QString& png)
{
    QProcess rsvg;
    rsvg.start("rsvg-convert", {"-w", "1000", "-b", "white", "-o", png, svg});
    return rsvg.waitForFinished() && rsvg.exitCode() == 0
               ? QImage(png).convertToFormat(QImage::Format_RGB32)
               : QImage();
}

/// The original inside an SVG clip path, as a viewer shows it.
void writeMasked(const QString& path, const clipping::Window& window)
{
    QFile in(foreign);
    QVERIFY(in.open(QIODevice::ReadOnly));
    QString text = QString::fromUtf8(in.readAll());
    const auto number = [](double x) { return QString::number(x, 'g', 17); };
    const qsizetype head = text.indexOf('>', text.indexOf("<svg")) + 1;
    text.insert(text.lastIndexOf("</svg>"), "</g>");
    text.insert(head,
                QString("<clipPath id='w'><rect x='%1' y='%2' width='%3' height='%4'/></clipPath>"
                        "<g clip-path='url(#w)'>")
                    .arg(number(window.min.x), number(window.min.y),
                         number(window.max.x - window.min.x), number(window.max.y - window.min.y)));
    QFile out(path);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(text.toUtf8());
}

struct Difference {
    double mean;   // of 255
    double strong; // share of the pixels that differ by more than a third
};

Difference between(const QImage& a, const QImage& b)
{
    double sum = 0, strong = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const int d = std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
            sum += d;
            strong += d > 85;
        }
    const double pixels = double(a.width()) * a.height();
    return {sum / pixels, strong / pixels};
}

} // namespace

class FirstLightTest : public QObject {
    Q_OBJECT

private slots:
    // NOLINTNEXTLINE(readability-function-size): one way through the program, from file to file
    void aForeignDrawingIsCutAndExported()
    {
        QTemporaryDir folder;
        const QString cutFile = folder.filePath("out.svg");
        QSettings().remove("export"); // of this file, by an earlier run
        ui::MainWindow window(ui::Backend::Raster);
        ui::addMenus(window);
        window.setQuestions(std::make_unique<Answers>(window));
        window.resize(1280, 800);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));

        window.files().open(foreign);
        window.files().wait();
        QCOMPARE(window.files().name(), QString("foreign.svg"));
        const auto& session = window.session();
        QVERIFY(session.losses().empty()
                || !std::ranges::any_of(session.losses(), [](const auto& l) { return !l.remark; }));
        QVERIFY(session.scene.lines().size() > 100);
        const clipping::Window page = sheetOf(session.document).page.rectangle();
        QVERIFY(sheetOf(session.document).window == page);

        // Draw the window: the tool by its key, then a drag.
        QWidget* const canvas = window.canvas().focusProxy();
        QVERIFY(canvas);
        canvas->setFocus();
        QTest::keyClick(canvas, Qt::Key_W);
        QCOMPARE(window.canvas().tool(), std::string_view("window"));
        window.canvas().fitPage();
        window.canvas().settle();
        const auto at = [&](double x, double y) {
            const auto p = window.canvas().view().toScreen({x, y});
            return QPoint(int(std::lround(p.x)), int(std::lround(p.y)));
        };
        // From a free place: at the page's edge the handles of the old window would be taken.
        QTest::mousePress(canvas, Qt::LeftButton, Qt::ControlModifier, at(170, 130));
        QTest::mouseMove(canvas, at(300, 300));
        QTest::mouseMove(canvas, at(610, 470));
        QTest::mouseRelease(canvas, Qt::LeftButton, Qt::ControlModifier, at(610, 470));
        const clipping::Window drawn = sheetOf(session.document).window;
        QVERIFY2(std::abs(drawn.min.x - 170) < 3 && std::abs(drawn.min.y - 130) < 3
                     && std::abs(drawn.max.x - 610) < 3 && std::abs(drawn.max.y - 470) < 3,
                 qPrintable(QString("%1 %2 %3 %4")
                                .arg(drawn.min.x)
                                .arg(drawn.min.y)
                                .arg(drawn.max.x)
                                .arg(drawn.max.y)));
        QCOMPARE(session.history.count(), 1);

        // Nudge it, twice in one undo step or two; undo brings back what was drawn.
        QTest::keyClick(canvas, Qt::Key_Right, Qt::AltModifier);
        QTest::keyClick(canvas, Qt::Key_Down, Qt::AltModifier | Qt::ShiftModifier);
        const clipping::Window nudged = sheetOf(session.document).window;
        QVERIFY(nudged.min.x > drawn.min.x && nudged.min.y > drawn.min.y);

        // Every algorithm, chosen by its digit, keeps the same.
        for (std::size_t i = 0; i < clipping::algorithms().size() && i < 9; ++i) {
            QTest::keyClick(canvas, Qt::Key(Qt::Key_1 + int(i)));
            QCOMPARE(session.display().variant.algorithm, &clipping::algorithms()[i]);
        }
        QTest::keyClick(canvas, Qt::Key_0); // the last
        QCOMPARE(session.display().variant.algorithm, &clipping::algorithms().back());

        while (session.history.index() > 1)
            QTest::keyClick(canvas, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(sheetOf(session.document).window == drawn);

        QTest::keyClick(canvas, Qt::Key_E, Qt::ControlModifier);
        auto* file = window.findChild<QLineEdit*>("export-file");
        QCOMPARE(QFileInfo(file->text()).fileName(), QString("foreign-cut.svg"));
        auto* paper = window.findChild<QWidget*>("export-paper");
        QTest::mouseClick(paper->findChildren<QAbstractButton*>().at(1), Qt::LeftButton);
        file->setText(cutFile);
        QTest::keyClick(file, Qt::Key_Return);
        QTRY_VERIFY(!window.files().busy());
        QVERIFY(QFile::exists(cutFile));
        QVERIFY2(!window.sheet(), "the sheet closes once the file is written");
        QVERIFY2(!window.message().isEmpty(), "the export says what it did");

        const QString masked = folder.filePath("masked.svg");
        writeMasked(masked, drawn);
        const QImage expected = rendered(masked, folder.filePath("masked.png"));
        const QImage actual = rendered(cutFile, folder.filePath("out.png"));
        QVERIFY(!expected.isNull());
        QCOMPARE(actual.size(), expected.size());
        const Difference difference = between(actual, expected);
        QVERIFY2(
            difference.mean < 0.3 && difference.strong < 0.001,
            qPrintable(QString("mean %1, strong %2").arg(difference.mean).arg(difference.strong)));

        // The comparison can fail: the whole drawing is not the cut one.
        const Difference whole = between(rendered(foreign, folder.filePath("whole.png")), expected);
        QVERIFY(whole.strong > 0.01);
    }
};

int main(int argc, char** argv)
{
    QStandardPaths::setTestModeEnabled(true);
    QApplication application(argc, argv);
    FirstLightTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "tests/ui/first_light_test.moc"
