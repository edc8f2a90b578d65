// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_steps.h"

#include <QElapsedTimer>

#include <cmath>
#include <numbers>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace canvas_large_window_test {

using namespace ui;

namespace {

// A shape of many edges; lines and filled squares under it.
QByteArray drawing(int edges)
{
    QByteArray path = "M";
    for (int i = 0; i < edges; ++i) {
        const double angle = 2 * std::numbers::pi * i / edges;
        const double radius = 40 + 5 * std::sin(97 * angle) + (i % 3) * 0.01;
        path += QByteArray::number(50 + radius * std::cos(angle), 'f', 5) + ','
                + QByteArray::number(50 + radius * std::sin(angle), 'f', 5) + ' ';
    }
    QByteArray art;
    for (int i = 0; i < 1000; ++i)
        art += QByteArrayLiteral("<path d='M%1,%2h4v4h-4z' fill='#c00' stroke='#000'/>"
                                 "<path d='M%2,%1l30,20' fill='none' stroke='#000'/>")
                   .replace("%1", QByteArray::number(i * 37 % 101))
                   .replace("%2", QByteArray::number(i * 73 % 103));
    return "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' "
           "viewBox='0 0 100 100'>"
           + art + "<path id='coast' fill='none' stroke='#000' d='" + path + "Z'/></svg>";
}

} // namespace

class LargeWindowTest : public QObject {
    Q_OBJECT

private slots:
    // The program answers at once, also while the window is moved and when it cuts. The bound is
    // for a busy machine; a hang takes minutes.
    void aWindowOfAHundredThousandEdgesDoesNotHang()
    {
        TestWindow t;
        t.open(t.file("coast.svg", drawing(100'000)));
        t.show();
        app::Session& session = t.window->session();
        session.select(app::ObjectRanges{session.now().objects().size() - 1});
        QElapsedTimer timer;
        timer.start();
        t.run("windows-of-selection");
        QCOMPARE(session.windows().list.size(), 1u);
        t.window->grab();
        QVERIFY2(timer.elapsed() < 20'000, qPrintable(QString::number(timer.elapsed())));
        timer.restart();
        app::moveWindow(session, app::Point(1, 1));
        t.window->grab();
        QVERIFY2(timer.elapsed() < 30'000, qPrintable(QString::number(timer.elapsed())));
        timer.restart();
        t.run("crop");
        t.window->grab();
        QVERIFY2(timer.elapsed() < 30'000, qPrintable(QString::number(timer.elapsed())));
    }
};

} // namespace canvas_large_window_test

TEST_CLASS(canvas_large_window_test::LargeWindowTest, Widgets)
#include "tests/ui/canvas/large_window_test.moc"
