// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/window_values.h"

#include <QTest>

#include "tests/test_class.h"

namespace session_window_values_test {

using namespace app;
using enum WindowValue;

namespace {

struct Drawing : Session {
    explicit Drawing(const WindowShape& shape)
    {
        DocumentBuilder builder;
        builder.open({.name = QStringLiteral("Lines")});
        builder.close();
        load({builder.take(Page{.min = {5, 5}, .size = {100, 50}}, {}, {{{.shape = shape}}}), {}});
    }
    double number(WindowValue which) const { return windowValue(*this, which); }
    void set(WindowValue which, double number, bool keepsRatio = false)
    {
        setWindowValue(*this, which, number, keepsRatio, Merging::Never);
    }
    const RectangleShape& rectangle() const
    {
        return std::get<RectangleShape>(windows().list[0].shape);
    }
};

} // namespace

class WindowValuesTest : public QObject {
    Q_OBJECT

private slots:
    void placesCountFromThePage()
    {
        Drawing drawing(RectangleShape{{{15, 25}, {45, 35}}});
        QCOMPARE(drawing.number(X), 10.0);
        QCOMPARE(drawing.number(Y), 20.0);
        drawing.set(X, 12);
        QCOMPARE(drawing.rectangle().box, (clipping::Window{{17, 25}, {47, 35}}));
        QCOMPARE(drawing.history.undoText(), QStringLiteral("Move clip window"));
        drawing.set(X, 12);
        QCOMPARE(drawing.history.count(), 1); // nothing changes
    }
    void theOtherSideFollowsIfTheRatioIsKept()
    {
        Drawing drawing(RectangleShape{{{15, 25}, {45, 35}}});
        drawing.set(Width, 60);
        QCOMPARE(drawing.rectangle().box, (clipping::Window{{15, 25}, {75, 35}}));
        drawing.set(Height, 5, true);
        QCOMPARE(drawing.rectangle().box, (clipping::Window{{15, 25}, {45, 30}}));
        QCOMPARE(drawing.history.undoText(), QStringLiteral("Resize clip window"));
        drawing.set(Width, 0); // without a ratio to keep
        drawing.set(Width, 8, true);
        QCOMPARE(drawing.rectangle().box, (clipping::Window{{15, 25}, {23, 30}}));
    }
    void sidesAreThoseOfTheTurnedWindow()
    {
        Drawing drawing(RectangleShape{{{15, 25}, {45, 35}}, 0.3});
        drawing.set(Angle, 60);
        QVERIFY(std::abs(drawing.number(Angle) - 60) < 1e-9);
        QVERIFY(std::abs(drawing.number(Width) - 30) < 1e-9);
        drawing.set(Width, 10);
        QVERIFY(std::abs(drawing.number(Width) - 10) < 1e-9);
        QVERIFY(std::abs(drawing.number(Height) - 10) < 1e-9);
        drawing.history.undo();
        drawing.history.undo();
        QCOMPARE(drawing.rectangle(), (RectangleShape{{{15, 25}, {45, 35}}, 0.3}));
    }
    void aWindowWithoutPointsStaysAsItIs()
    {
        Drawing drawing(PathShape{});
        drawing.set(Width, 10);
        QCOMPARE(drawing.history.count(), 0);
    }
};

} // namespace session_window_values_test

TEST_CLASS(session_window_values_test::WindowValuesTest, None)
#include "tests/app/session/window_values_test.moc"
