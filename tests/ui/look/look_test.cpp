// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/visible_colour.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/tools/tool.h"
#include "ui/widgets/algorithm_marker.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QToolTip>
#include <QVBoxLayout>

#include <set>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace look_look_test {

using namespace ui;

namespace {

double contrast(const QColor& a, const QColor& b)
{
    const auto plain = [](const QColor& c) {
        return app::Colour{std::uint8_t(c.red()), std::uint8_t(c.green()), std::uint8_t(c.blue())};
    };
    return app::contrast(plain(a), plain(b));
}

std::set<QRgb> opaqueColours(const QImage& image)
{
    std::set<QRgb> colours;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixelColor(x, y).alpha() == 255)
                colours.insert(image.pixelColor(x, y).rgb());
    return colours;
}

} // namespace

class LookTest : public QObject {
    Q_OBJECT

private slots:
    void textHasEnoughContrast_data()
    {
        QTest::addColumn<int>("theme");
        QTest::newRow("light") << int(Theme::Light);
        QTest::newRow("dark") << int(Theme::Dark);
    }
    void textHasEnoughContrast()
    {
        QFETCH(int, theme);
        applyTheme(*qApp, Theme(theme));
        const Look& look = lookOf(QApplication::palette());
        QCOMPARE(look.dark, Theme(theme) == Theme::Dark);
        for (const QColor& ground : {look.window, look.panel, look.base, look.tint, look.hover}) {
            QVERIFY(contrast(look.text, ground) >= 4.5);
            QVERIFY2(contrast(look.muted, ground) >= 4.5, qPrintable(ground.name()));
        }
        QVERIFY(contrast(look.onSelection, look.selection) >= 4.5);
        QVERIFY(contrast(look.onAccent, look.accent) >= 4.5);
        QVERIFY(contrast(look.warning, look.warningGround) >= 4.5);
        QVERIFY(contrast(look.good, look.panel) >= 4.5);
        QVERIFY(contrast(look.differs, look.panel) >= 4.5);
        for (const auto& algorithm : clipping::algorithms())
            QVERIFY2(contrast(app::algorithmColour(algorithm, groundOf(QApplication::palette())),
                              look.panel)
                         >= 3,
                     algorithm.abbreviation.data());
    }
    void bordersAndMarksHaveEnoughContrast_data() { textHasEnoughContrast_data(); }
    void bordersAndMarksHaveEnoughContrast()
    {
        QFETCH(int, theme);
        const Look& look = lookOf(Theme(theme));
        for (const QColor& ground :
             {look.window, look.panel, look.base, look.tint, look.hover, look.canvas})
            QVERIFY2(contrast(look.control, ground) >= 3, qPrintable(ground.name()));
        for (const QColor& mark :
             {look.accent, look.selection, look.differs, look.guide, look.good})
            for (const QColor& ground : {look.paper, look.canvas})
                QVERIFY2(contrast(mark, ground) >= 3, qPrintable(mark.name() + ground.name()));
        QVERIFY(contrast(look.accent, look.paper) >= 4.5); // the names of windows
        QVERIFY(contrast(look.guide, look.guideGround) >= 4.5);
        QVERIFY(contrast(look.panel, look.muted) >= 4.5); // a sheet that is left out
        for (const QColor& ground : {look.window, look.panel, look.base})
            QVERIFY(contrast(errorColour(look), ground) >= 4.5);
    }
    /// As painted: the border of each, beside it and within.
    void whatCanBeClickedHasABorderThatIsSeen_data() { textHasEnoughContrast_data(); }
    void whatCanBeClickedHasABorderThatIsSeen()
    {
        QFETCH(int, theme);
        applyTheme(*qApp, Theme(theme));
        QWidget ground;
        QVBoxLayout rows(&ground);
        const QList<QWidget*> all{new QLineEdit("text"),    new QSpinBox,
                                  new QDoubleSpinBox,       new QComboBox,
                                  new QPushButton("Push"),  new QCheckBox("Check"),
                                  new QRadioButton("Radio")};
        for (QWidget* each : all) {
            each->setFocusPolicy(Qt::NoFocus);
            rows.addWidget(each, 0, Qt::AlignLeft);
        }
        ground.show();
        const QImage picture = ground.grab().toImage().scaled(ground.size());
        for (const QWidget* each : all) {
            const int y = each->geometry().center().y();
            const QColor beside = picture.pixelColor(each->x() - 4, y);
            double most = 0;
            for (int x = each->x(); x < each->x() + 6; ++x)
                most = std::max(most, contrast(picture.pixelColor(x, y), beside));
            QVERIFY2(most >= 3,
                     qPrintable(QString("%1: %2").arg(each->metaObject()->className()).arg(most)));
        }
    }
    void everyToolAndCommandHasItsIcon()
    {
        TestWindow t;
        for (const ToolInfo& tool : tools())
            QVERIFY2(!opaqueColours(icon(tool.key).pixmap(40, 40).toImage()).empty(),
                     tool.key.data());
        int icons = 0;
        for (const QAction* action : t.window->findChildren<QAction*>())
            if (!action->icon().isNull()) {
                QVERIFY2(!opaqueColours(action->icon().pixmap(40, 40).toImage()).empty(),
                         qPrintable(action->text()));
                ++icons;
            }
        QVERIFY(icons > 10);
    }
    /// Names of files and layers are shown as they are, in labels and in tooltips.
    void aNameIsNoMarkup()
    {
        const QString name = QStringLiteral("<b>bold</b>");
        QWidget ground;
        QVBoxLayout rows(&ground);
        QLabel plain(name), rich(name);
        rich.setTextFormat(Qt::RichText);
        for (QLabel* label : {&plain, &rich})
            rows.addWidget(label);
        ground.show();
        QCOMPARE(plain.textFormat(), Qt::PlainText);
        QVERIFY(plain.sizeHint().width() > rich.sizeHint().width());
        QToolTip::showText(ground.mapToGlobal(QPoint()), name, &ground);
        for (const QWidget* top : QApplication::topLevelWidgets())
            if (const auto* tip = qobject_cast<const QLabel*>(top); tip && tip->text() == name) {
                QCOMPARE(tip->textFormat(), Qt::PlainText);
                QToolTip::hideText();
                return;
            }
        QFAIL("no tooltip");
    }
    void iconsFollowTheTheme()
    {
        for (const Theme theme : {Theme::Light, Theme::Dark}) {
            applyTheme(*qApp, theme);
            const Look& look = lookOf(QApplication::palette());
            const auto ink = opaqueColours(icon("select").pixmap(80, 80).toImage());
            QVERIFY(ink.contains(look.text.rgb()));
            const auto window = opaqueColours(icon("window").pixmap(80, 80).toImage());
            QVERIFY(window.contains(look.accent.rgb()));
        }
    }
    void progressOfUnknownLengthIsNotAFullBar()
    {
        applyTheme(*qApp, Theme::Light);
        QProgressBar bar;
        bar.setTextVisible(false);
        bar.resize(400, 8);
        const auto filled = [&bar] {
            const QImage picture = bar.grab().toImage().scaled(bar.size());
            const QRgb fill = lookOf(bar.palette()).selection.rgb();
            int columns = 0;
            for (int x = 0; x < picture.width(); ++x)
                columns += picture.pixel(x, 4) == fill;
            return columns;
        };
        bar.setRange(0, 0);
        QVERIFY2(std::abs(filled() - 100) < 8, qPrintable(QString::number(filled())));
        bar.setRange(0, 1000);
        bar.setValue(750);
        QVERIFY2(std::abs(filled() - 300) < 8, qPrintable(QString::number(filled())));
        bar.setValue(0);
        QCOMPARE(filled(), 0);
    }
};

} // namespace look_look_test

TEST_CLASS(look_look_test::LookTest, Widgets)
#include "tests/ui/look/look_test.moc"
