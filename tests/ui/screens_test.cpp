// SPDX-License-Identifier: GPL-3.0-or-later
// What people see looks as in the pictures of tests/ui/screens, and says what is in the texts
// beside them. Each wanted change comes with its new pictures and texts: CLEARCUT_PICTURES is a
// folder to which those that differ are written.
#include <QImageWriter>

#include <set>

#include "tests/content_of.h"
#include "tests/test_class.h"
#include "tests/ui/screens/canvas_screens.h"
#include "tests/ui/screens/maker_screens.h"
#include "tests/ui/screens/window_screens.h"

namespace screens_test {

using namespace ui;

namespace {

const std::vector<Screen>& allScreens()
{
    static const auto all = [] {
        std::vector<Screen> made;
        addMakers(made);
        addCanvases(made);
        addWindows(made);
        return made;
    }();
    return all;
}

QString folder() { return QStringLiteral(SOURCE_DIR "/tests/ui/screens/"); }

constexpr int step = 17; // of 255: the pictures have so few colours to be small files

/// With at most 256 colours, if possible.
QImage withFewColours(QImage picture)
{
    const auto rounded = [](int value) { return (value + step / 2) / step * step; };
    std::set<QRgb> colours;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb exact = picture.pixel(x, y);
            const QRgb colour =
                qRgb(rounded(qRed(exact)), rounded(qGreen(exact)), rounded(qBlue(exact)));
            picture.setPixel(x, y, colour);
            colours.insert(colour);
        }
    if (colours.size() > 256)
        return picture;
    return picture.convertToFormat(QImage::Format_Indexed8, {colours.begin(), colours.end()},
                                   Qt::ThresholdDither);
}

void write(const QImage& picture, const QString& file)
{
    QImageWriter writer(file, "png");
    writer.setQuality(0); // as small as possible
    writer.write(withFewColours(picture));
}

void write(const QString& words, const QString& path)
{
    QFile file(path);
    if (file.open(QIODevice::WriteOnly))
        file.write(words.toUtf8());
}

/// Empty: none but that of rounding, and of processors.
QString difference(const QImage& shown, const QImage& wanted)
{
    return wanted.isNull() ? QStringLiteral("there is no picture of it")
                           : differenceBetween(shown, wanted, step / 2 + 2);
}

} // namespace

class ScreensTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        Timers::watch();
        dropRemarksOfThePlatform();
        QApplication::setCursorFlashTime(0); // it is always seen
    }
    void cleanup() { applyTheme(*qApp, Theme::Light); }

    void everyScreenLooksAsInItsPicture_data()
    {
        QTest::addColumn<std::size_t>("number");
        for (std::size_t i = 0; i < allScreens().size(); ++i)
            QTest::newRow(qPrintable(allScreens()[i].name)) << i;
    }
    void everyScreenLooksAsInItsPicture()
    {
        QFETCH(std::size_t, number);
        const Screen& screen = allScreens()[number];
        const Seen seen = screen.look();
        const QString file = folder() + screen.name;
        const QString fault = difference(seen.picture, QImage(file + ".png"));
        const QStringList said = seen.words.split(u'\n'),
                          wanted = QString::fromUtf8(contentOf(file + ".txt")).split(u'\n');
        const QString kept = qEnvironmentVariable("CLEARCUT_PICTURES");
        if (!fault.isEmpty() && !kept.isEmpty())
            write(seen.picture, kept + '/' + screen.name + ".png");
        if (said != wanted && !kept.isEmpty())
            write(seen.words, kept + '/' + screen.name + ".txt");
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
        QCOMPARE(said, wanted);
    }

    void everyPictureIsOfAScreen()
    {
        QStringList names, files = QDir(folder()).entryList({"*.png", "*.txt"});
        for (const Screen& screen : allScreens())
            names << screen.name + ".png" << screen.name + ".txt";
        names.sort();
        files.sort();
        QCOMPARE(files, names);
    }
};

} // namespace screens_test

TEST_CLASS(screens_test::ScreensTest, Widgets)
#include "tests/ui/screens_test.moc"
