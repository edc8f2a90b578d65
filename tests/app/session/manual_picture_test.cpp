// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/manual_picture.h"
#include "app/session/samples.h"
#include "app/teaching/manual.h"

#include <QRegularExpression>
#include <QTest>

#include "tests/test_class.h"

namespace session_manual_picture_test {

namespace {

const app::ThumbnailColours colours{Qt::white, Qt::red, 0.3};
const app::DiscLook discs{Qt::blue, Qt::yellow, Qt::green, QFont()};

QStringList addresses(const app::ManualPage& page)
{
    static const QRegularExpression picture(QStringLiteral("\\((sample:[^)]*)\\)"));
    QStringList all;
    for (auto found = picture.globalMatch(page.markdown); found.hasNext();)
        all << found.next().captured(1);
    return all;
}

} // namespace

class ManualPictureTest : public QObject {
    Q_OBJECT

private slots:
    void anAddressNamesASampleAndDiscs()
    {
        const auto picture = app::manualPicture("sample:landscape?1=25,50&2=100,0");
        QVERIFY(picture && picture->file.endsWith("landscape.svg"));
        QCOMPARE(picture->discs.size(), 2U);
        QCOMPARE(picture->discs[0].number, 1);
        QCOMPARE(picture->discs[0].at, QPointF(0.25, 0.5));
        QVERIFY(app::manualPicture("sample:rosette")->discs.empty());
        for (const char* wrong :
             {"", "landscape", "sample:", "sample:none", "figure:cs", "sample:rosette?a=1,2",
              "sample:rosette?1=1", "sample:rosette?1=x,2", "sample:rosette?1=101,2",
              "sample:rosette?0=1,2", "sample:rosette?99=1,2", "sample:rosette?1=nan,2"})
            QVERIFY2(!app::manualPicture(wrong), wrong);
    }

    void discsAreWhereTheySay()
    {
        const auto with = app::manualPicture("sample:nine-regions?7=25,50");
        const QSize points = app::manualPictureSize(200);
        for (const double ratio : {1.0, 2.0}) {
            const QImage picture = app::painted(*with, points, ratio, colours, discs);
            QCOMPARE(picture.size(), points * ratio);
            const auto at = [&](double x, double y) {
                return picture.pixelColor(int(x * picture.width()), int(y * picture.height()));
            };
            QCOMPARE(at(0.25, 0.5 + 9.0 / points.height()), QColor(Qt::blue)); // below the figure
            QVERIFY(at(0.5, 0.5) != QColor(Qt::blue));
            QCOMPARE(at(0, 0.5), QColor(Qt::green));
        }
    }

    // Every step that a disc names is a step of the text.
    void thePagesHaveTheStepsOfTheirDiscs()
    {
        int pictures = 0;
        for (const QString& topic : app::manualTopics()) {
            const auto page = app::manualPage(topic);
            for (const QString& address : addresses(*page)) {
                const auto picture = app::manualPicture(address);
                QVERIFY2(picture, qPrintable(topic + ": " + address));
                for (const auto& disc : picture->discs)
                    QVERIFY2(page->markdown.contains(QString("\n%1. ").arg(disc.number)),
                             qPrintable(QString("%1: step %2").arg(topic).arg(disc.number)));
                ++pictures;
            }
        }
        QVERIFY(pictures >= 2);
    }
};

} // namespace session_manual_picture_test

TEST_CLASS(session_manual_picture_test::ManualPictureTest, Gui)
#include "tests/app/session/manual_picture_test.moc"
