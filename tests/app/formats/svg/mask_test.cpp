// SPDX-License-Identifier: GPL-3.0-or-later
// Masks of opaque shapes in white and black are cuts; all others are told.
#include <QTest>

#include "tests/app/formats/svg/lengths_of.h"
#include "tests/test_class.h"

namespace formats_svg_mask_test {

namespace {

QByteArray mask(const QByteArray& content, const QByteArray& attributes = {})
{
    return "<linearGradient id='l'><stop stop-color='#fff'/><stop offset='1'/></linearGradient>"
           "<mask id='m' "
           + attributes + ">" + content + "</mask>";
}

QByteArray masked(const QByteArray& elements) { return "<g mask='url(#m)'>" + elements + "</g>"; }

constexpr double all = 900; // the length of the hatch

} // namespace

class MaskTest : public QObject {
    Q_OBJECT

private slots:
    void plainMasks_data()
    {
        QTest::addColumn<QByteArray>("mask");
        QTest::addColumn<double>("left");
        const auto row = [](const char* name, const QByteArray& mask, double left) {
            QTest::newRow(name) << mask << left;
        };
        const QByteArray box = "<rect x='20' y='15' width='60' height='70' fill='#fff'/>";
        row("white", mask(box), 420);
        row("white in a group",
            mask("<g fill='white' transform='translate(10)'><rect x='10' "
                 "y='15' width='60' height='70'/></g>"),
            420);
        row("black hides", mask(box + "<rect x='40' width='20' height='100'/>"), 280);
        row("white on black shows",
            mask(box
                 + "<rect x='40' width='20' height='100'/><rect x='45' width='10' height='100' "
                   "fill='#fff'/>"),
            370);
        row("black alone", mask("<rect width='100' height='100'/>"), 0);
        row("nothing", mask(""), 0);
        row("any colour by alpha", mask("<rect width='50' height='100'/>", "mask-type='alpha'"),
            450);
        row("stroke", mask("<path d='M50 0V100' stroke='#fff' stroke-width='20'/>"), 180);
        row("fill and stroke",
            mask("<rect x='40' y='5' width='20' height='90' fill='#fff' stroke='#fff' "
                 "stroke-width='10'/>"),
            270);
        row("used",
            "<defs><rect id='q' width='50' height='100'/></defs>"
                + mask("<use href='#q' x='20' fill='#fff'/>"),
            450);
        row("a clip path in it",
            "<clipPath id='c'><rect width='100' height='55'/></clipPath>"
                + mask("<rect width='50' height='100' fill='#fff' clip-path='url(#c)'/>"),
            250);
        row("its rectangle",
            mask("<rect width='100' height='100' fill='#fff'/>",
                 "maskUnits='userSpaceOnUse' x='0' y='0' width='50' height='100'"),
            450);
        row("its rectangle in the box",
            mask("<rect width='100' height='100' fill='#fff'/>", "x='0' y='0' width='.5' "
                                                                 "height='100%'"),
            450);
        row("content in the box",
            mask("<rect width='.5' height='1' fill='#fff'/>",
                 "maskContentUnits='objectBoundingBox'"),
            450);
    }
    void plainMasks()
    {
        QFETCH(QByteArray, mask);
        QFETCH(double, left);
        QCOMPARE(lengthOf(mask + masked(hatch())), left);
        QVERIFY(reportOf(mask + masked(hatch())).contains("1 mask was replaced by a real cut"));
    }

    void greyMasksAreOpacities_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<int>("alpha");
        const QByteArray box = "<rect width='50' height='100' ";
        QTest::newRow("grey") << box + "fill='#666'/>" << 102;
        QTest::newRow("green") << box + "fill='#0f0'/>" << 182;
        QTest::newRow("soft") << box + "fill='#fff' opacity='.4'/>" << 102;
        QTest::newRow("in a soft group") << "<g opacity='.4'>" + box + "fill='#fff'/></g>" << 102;
        QTest::newRow("two of one grey")
            << box + "fill='#666'/><circle r='20' fill='#666'/>" << 102;
        QTest::newRow("black on grey")
            << box + "fill='#666'/><rect x='50' y='50' width='9' height='9'/>" << 102;
    }
    void greyMasksAreOpacities()
    {
        QFETCH(QByteArray, content);
        QFETCH(int, alpha);
        const QByteArray line = "<path d='M0 30H100' stroke='#000' mask='url(#m)'/>"
                                "<path d='M0 90H100V95' stroke='#000' mask='url(#m)'/>";
        const auto result = readText(
            drawing(mask(content, "maskUnits='userSpaceOnUse' width='100' height='100'") + line));
        QVERIFY(result);
        QCOMPARE(int(result.value->document.objects()[0].style().stroke->alpha), alpha);
        QCOMPARE(lengthOf(mask(content) + masked(hatch())), 450.0);
    }

    void whatHasNoAreaHasNoMaskInItsBox()
    {
        const QByteArray line = "<path d='M0 30H100' stroke='#000' mask='url(#m)'/>";
        QCOMPARE(lengthOf(mask("<rect width='90' height='90' fill='#fff'/>") + line), 0.0);
    }

    void greyInLinearColoursIsTold()
    {
        const QByteArray elements =
            mask("<rect width='50' height='100' fill='#888'/>", "color-interpolation='linearRGB'")
            + masked(hatch());
        QCOMPARE(lengthOf(elements), all);
        QCOMPARE(reportOf(elements), "1 mask");
    }

    void otherMasksAreTold_data()
    {
        QTest::addColumn<QByteArray>("content");
        const auto row = [](const char* name, const QByteArray& content) {
            QTest::newRow(name) << content;
        };
        const QByteArray box = "<rect width='50' height='100' ";
        row("two greys", box + "fill='#888'/>" + box + "x='50' fill='#999'/>");
        row("several that are soft",
            "<g opacity='.5'>" + box + "fill='#fff'/>" + box + "x='20' fill='#fff'/></g>");
        row("softly black", box + "fill='#fff'/>" + box + "fill='#000' opacity='.5'/>");
        row("gradient", box + "fill='url(#l)'/>");
        row("text", "<text fill='#fff'>x</text>");
        row("image", "<image width='50' height='100'/>");
        row("filter", box + "fill='#fff' filter='url(#f)'/>");
        row("a mask in it", box + "fill='#fff' mask='url(#m)'/>");
    }
    void otherMasksAreTold()
    {
        QFETCH(QByteArray, content);
        const QByteArray elements = mask(content) + masked(hatch());
        QCOMPARE(lengthOf(elements), all);
        QCOMPARE(reportOf(elements), "1 mask");
    }
};

} // namespace formats_svg_mask_test

TEST_CLASS(formats_svg_mask_test::MaskTest, Core)
#include "tests/app/formats/svg/mask_test.moc"
