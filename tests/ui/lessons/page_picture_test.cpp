// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/lesson.h"
#include "app/session/samples.h"
#include "ui/lessons/page_picture.h"

#include <QTest>

#include "tests/test_class.h"

namespace lessons_page_picture_test {

class PagePictureTest : public QObject {
    Q_OBJECT

    static QSet<QRgb> coloursOf(const QImage& image)
    {
        QSet<QRgb> colours;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                colours << image.pixel(x, y);
        return colours;
    }

private slots:
    void everyPageNamesASampleOrNone()
    {
        int pictures = 0;
        for (const app::Lesson& lesson : app::lessons())
            for (const app::LessonPage& page : lesson.pages) {
                if (page.picture.isEmpty())
                    continue;
                ++pictures;
                const auto all = app::samples();
                QVERIFY2(std::ranges::count(all, page.picture, &app::Sample::key) == 1,
                         qPrintable(page.picture));
            }
        QVERIFY(pictures > 0);
    }
    void showsTheSampleInItsWidth()
    {
        QWidget window;
        ui::PagePicture picture(&window);
        window.resize(400, 300);
        window.show();
        QVERIFY(!picture.isVisible());
        picture.show("no such sample");
        QVERIFY(!picture.isVisible());
        picture.show("landscape");
        QVERIFY(picture.isVisible() && picture.accessibleName().contains("landscape"));
        for (const int width : {384, 200}) {
            picture.resize(width, picture.heightForWidth(width));
            QCOMPARE(picture.height(), width * 216 / 384);
            QTRY_VERIFY(coloursOf(picture.grab().toImage()).size() > 20);
        }
    }
};

} // namespace lessons_page_picture_test

TEST_CLASS(lessons_page_picture_test::PagePictureTest, Widgets)
#include "tests/ui/lessons/page_picture_test.moc"
