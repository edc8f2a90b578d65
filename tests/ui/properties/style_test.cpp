// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/recent_colours.h"
#include "ui/bars/option_bar.h"
#include "ui/properties/style_popup.h"
#include "ui/widgets/colour_popup.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/swatches.h"
#include "ui/widgets/tool_list.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QStatusBar>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

using app::Colour;
using app::Style;

namespace ui::properties_style_test {

// Style by mouse and keys: colours, stroke, fill, eyedropper, copy and paste.
class StyleTest : public QObject {
    Q_OBJECT

    static constexpr Colour red{255, 0, 0}, blue{0, 0, 200}, green{0, 128, 0};

    static app::Shape line(double y, const Style& style)
    {
        app::Shape line = shape({{{20, y}, {{{120, y}}}, false}});
        line.style = style;
        return line;
    }
    struct Person : Hand {
        Person()
            : Hand({line(20, {.stroke = red, .width = 2}), line(40, {.stroke = blue, .width = 1}),
                    line(60, {.stroke = blue, .width = 1})})
        {
            key(Qt::Key_2, Qt::ControlModifier | Qt::AltModifier); // in Draw the panel is docked
        }
        Style style(std::size_t object) { return session.now().objects()[object].style(); }
        StylePanel& panel() { return popup().panel(); }
        StylePopup& popup() { return *t.window->findChild<StylePopup*>(); }
        /// Opens the panel as the key does.
        void open()
        {
            QTest::keyClick(&surface(), Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
            settle();
            QVERIFY(popup().isVisible());
        }
        static void settle() { QTest::qWait(20); } // the panel follows after the events
        template <class Widget>
        Widget* named(const QString& name)
        {
            for (auto* widget : panel().findChildren<Widget*>())
                if (widget->accessibleName() == name)
                    return widget;
            return nullptr;
        }
        template <class Field>
        void typeInto(const QString& name, const QString& text)
        {
            Field* field = named<Field>(name);
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, text);
            QTest::keyClick(field, Qt::Key_Return);
            settle();
        }
        void choose(const QString& segment)
        {
            QTest::mouseClick(named<QToolButton>(segment), Qt::LeftButton);
            settle();
        }
        ColourPopup& openColours()
        {
            auto* button = panel().findChild<ColourChoice*>();
            QTest::mouseClick(button, Qt::LeftButton);
            return *button->findChild<ColourPopup*>();
        }
        /// To the part of a popup that has the keyboard.
        static void keyIn(QWidget& popup, int key)
        {
            QTest::keyClick(popup.focusWidget(), Qt::Key(key));
        }
        static void typeIn(QWidget& popup, const char* text)
        {
            for (const char* c = text; *c; ++c)
                QTest::keyClick(popup.focusWidget(), *c);
        }
    };

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() { QSettings().remove("recentColours"); }

    void theFillRuleIsForFilledObjects()
    {
        Person p;
        p.session.select({0});
        p.open();
        auto* rule = p.named<Segments>("Fill rule");
        QVERIFY(rule && !rule->isVisible());
        app::setColour(p.session, &Style::fill, green);
        p.settle();
        QVERIFY(rule->isVisible());
        QCOMPARE(rule->chosen(), int(app::FillRule::NonZero));
        p.choose("Fill rule: Even-odd");
        QCOMPARE(p.style(0).fillRule, app::FillRule::EvenOdd);
        QCOMPARE(p.session.history.undoText(), "Fill rule");
        QCOMPARE(rule->chosen(), int(app::FillRule::EvenOdd));
        p.canvas.undo();
        QCOMPARE(p.style(0).fillRule, app::FillRule::NonZero);
    }
    void digitsChangeTheStrokeOfTheSelectionInOneStep()
    {
        Person p;
        p.session.select({0, 1});
        p.open();
        ColourPopup& colours = p.openColours();
        QVERIFY(colours.isVisible());
        p.typeIn(colours,
                 "#8A5A2B"); // begins in the swatches, goes on in the field
        p.keyIn(colours, Qt::Key_Return);
        QVERIFY(!colours.isVisible());
        const Colour brown{0x8A, 0x5A, 0x2B};
        QVERIFY(p.style(0).stroke == brown && p.style(1).stroke == brown);
        QCOMPARE(p.style(2).stroke, std::optional(blue));
        QCOMPARE(p.session.history.count(), 1);
        p.canvas.undo();
        QCOMPARE(p.style(0).stroke, std::optional(red));
        QCOMPARE(app::recentColours(QSettings()), std::vector{brown});
    }
    void coloursOfTheDrawingAreOfferedMostUsedFirst()
    {
        Person p;
        p.session.select({0});
        p.open();
        ColourPopup& colours = p.openColours();
        auto* first = qobject_cast<Swatches*>(colours.focusWidget());
        QVERIFY(first);
        QCOMPARE(first->colours(), (std::vector{blue, red}));
        p.keyIn(colours, Qt::Key_Left); // from red, which is in use
        p.keyIn(colours, Qt::Key_Space);
        QCOMPARE(p.style(0).stroke, std::optional(blue));
        auto* panel = p.panel().findChild<Swatches*>();
        p.session.select({1});
        Person::settle();
        QCOMPARE(panel->colours(), std::vector{blue});
    }
    void aSwatchIsPickedByAClick()
    {
        Person p;
        p.session.select({1, 2});
        p.open();
        auto* swatches = p.panel().findChild<Swatches*>();
        QTest::mouseClick(swatches, Qt::LeftButton, {}, swatches->squareOf(1).center());
        QVERIFY(p.style(1).stroke == red && p.style(2).stroke == red);
        QCOMPARE(p.session.history.count(), 1);
        QTest::keyClick(swatches, Qt::Key_Z, Qt::ControlModifier); // goes on in the window
        QCOMPARE(p.style(1).stroke, std::optional(blue));
    }
    void swatchesNameTheColourThatTheKeyboardIsAt()
    {
        Person p;
        p.session.select({0});
        p.open();
        ColourPopup& colours = p.openColours();
        auto* swatches = qobject_cast<Swatches*>(colours.focusWidget());
        QVERIFY(swatches->accessibleName().endsWith(app::hexText(red)));
        p.keyIn(colours, Qt::Key_Left);
        QVERIFY(swatches->accessibleName().endsWith(app::hexText(blue)));
        for (auto* field : colours.findChildren<QLineEdit*>())
            field->setFocus();
        QVERIFY(!swatches->hasFocus());
        const QString name = swatches->accessibleName();
        QVERIFY2(!name.contains(u'#'), qPrintable(name));
        swatches->setFocus();
        QCOMPARE(swatches->accessibleName(), name + ": " + app::hexText(blue));
    }
    void badDigitsAreRefusedInTheWindowOfColours()
    {
        Person p;
        p.session.select({0});
        p.open();
        ColourPopup& colours = p.openColours();
        const QSize size = colours.size();
        p.typeIn(colours, "#12");
        p.keyIn(colours, Qt::Key_Return);
        QVERIFY(colours.isVisible());
        QCOMPARE(colours.size(), size);
        QCOMPARE(p.session.history.count(), 0);
        p.keyIn(colours, Qt::Key_Escape);
        QVERIFY(!colours.isVisible() && p.popup().isVisible());
        p.keyIn(p.popup(), Qt::Key_Escape);
        QVERIFY(!p.popup().isVisible());
    }
    void noneTakesTheFillAwayAndNeverEverything()
    {
        Person p;
        p.session.select({0});
        p.open();
        p.choose("Colour of: Fill");
        p.typeIn(p.openColours(), "teal");
        p.keyIn(*p.panel().findChild<ColourPopup*>(), Qt::Key_Return);
        QCOMPARE(p.style(0).fill, std::optional(Colour{0, 128, 128}));
        const auto none = [&] {
            QTest::mouseClick(p.openColours().findChild<QToolButton*>("no-colour"), Qt::LeftButton);
        };
        none();
        QVERIFY(!p.style(0).fill);
        p.choose("Colour of: Stroke");
        none();
        QCOMPARE(p.style(0).stroke, std::optional(red));
        QVERIFY(p.t.window->message().endsWith(u'.'));
    }
    void strokeIsTypedWithUnitsAndChosenByIcons()
    {
        Person p;
        p.session.select({0, 1, 2});
        p.open();
        p.typeInto<LengthField>("Stroke width", "1mm/2");
        p.typeInto<QLineEdit>("Dash pattern", "3mm 1 0.5 1");
        p.typeInto<LengthField>("Miter limit", "10");
        p.choose("Caps: Round");
        p.choose("Joins: Bevel");
        QCOMPARE(p.session.history.count(), 5);
        for (std::size_t i = 0; i < 3; ++i) {
            const Style now = p.style(i);
            QCOMPARE(now.width, 0.5);
            QCOMPARE(now.dashes, (std::vector<double>{3, 1, 0.5, 1}));
            QCOMPARE(now.miterLimit, 10.0);
            QCOMPARE(now.cap, app::Cap::Round);
            QCOMPARE(now.join, app::Join::Bevel);
        }
        for (int i = 0; i < 5; ++i)
            p.canvas.undo();
        QCOMPARE(p.style(0), (Style{.stroke = red, .width = 2}));
    }
    void mixedValuesAreShownAsMixedAndTypedForAll()
    {
        Person p;
        p.session.select({0, 1});
        Person::settle();
        QTest::keyClick(&p.surface(), Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
        auto* width = p.named<LengthField>("Stroke width");
        QVERIFY(width->text().isEmpty() && width->hasFocus());
        QTest::keyClick(width, Qt::Key_Return);
        QTest::keyClick(width, Qt::Key_Tab); // nothing was typed
        QVERIFY(width->text().isEmpty() && p.session.history.count() == 0);
        QCOMPARE(p.panel().findChild<ColourChoice*>()->text(), QString("mixed"));
        p.typeInto<LengthField>("Stroke width",
                                "2"); // the first one's, too, is a change
        QVERIFY(p.style(0).width == 2 && p.style(1).width == 2);
        QVERIFY(!width->text().isEmpty());
        p.session.select({1, 2});
        Person::settle();
        QVERIFY(width->text().isEmpty());
        p.session.select({});
        Person::settle();
        QVERIFY(!width->text().isEmpty());
    }
    void usualDashesGrowWithTheWidth()
    {
        Person p;
        p.session.select({0});
        p.open();
        QTest::keyClick(p.named<ToolList>("Dashes"), Qt::Key_Down);
        QCOMPARE(p.style(0).dashes, (std::vector<double>{12, 6}));
        p.typeInto<LengthField>("Stroke width", "1");
        QCOMPARE(p.style(0).dashes, (std::vector<double>{6, 3}));
        QCOMPARE(p.named<ToolList>("Dashes")->currentIndex(), 1);
        p.typeInto<QLineEdit>("Dash pattern", "3mm 1 0.5 1");
        QCOMPARE(p.named<ToolList>("Dashes")->currentIndex(), -1);
        QCOMPARE(p.named<ToolList>("Dashes")->placeholderText(), QString("own"));
        p.session.select({0, 1});
        Person::settle();
        QCOMPARE(p.named<ToolList>("Dashes")->placeholderText(), QString("mixed"));
    }
    void badPatternsAndLimitsAreRefused()
    {
        Person p;
        p.session.select({0});
        p.open();
        p.typeInto<QLineEdit>("Dash pattern", "3 -1");
        QVERIFY(p.t.window->message().endsWith(u'.'));
        QVERIFY(p.named<QLineEdit>("Dash pattern")->text().isEmpty()); // as it was
        p.typeInto<LengthField>("Miter limit", "0.5");
        p.typeInto<LengthField>("Stroke width", "-1");
        QCOMPARE(p.session.history.count(), 0);
        QCOMPARE(p.named<LengthField>("Miter limit")->value(), 4.0);
    }
    void withoutASelectionTheStyleIsForWhatIsDrawnNext()
    {
        Person p;
        p.open();
        p.typeInto<LengthField>("Stroke width", "3");
        p.choose("Caps: Square");
        p.keyIn(p.popup(), Qt::Key_Escape);
        QCOMPARE(p.session.history.count(), 0);
        p.canvas.setTool("line");
        p.drag({150, 20}, {150, 70});
        QCOMPARE(p.style(3).width, 3.0);
        QCOMPARE(p.style(3).cap, app::Cap::Square);
    }
    void layerGivesTheStyleToWhatIsDrawnNext()
    {
        Person p;
        p.session.select({0});
        p.open();
        auto* box = p.named<QCheckBox>("For new objects of the layer");
        QVERIFY(!box->isChecked());
        QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
        Person::settle();
        QVERIFY(box->isChecked());
        QCOMPARE(p.session.history.count(), 1);
        p.keyIn(p.popup(), Qt::Key_Escape);
        p.canvas.setTool("line");
        p.drag({150, 20}, {150, 70});
        QVERIFY(p.style(3) == p.style(0));
        p.canvas.undo();
        p.canvas.undo();
        p.session.select({});
        p.open();
        QVERIFY(!box->isChecked());
    }
    void eyedropperTakesTheColourOfALine()
    {
        Person p;
        p.session.select({0});
        QTest::keyClick(&p.surface(), Qt::Key_I);
        p.move({150, 90}, {});
        p.click({150, 90}); // nothing is there
        p.move({60, 40}, {});
        p.click({60, 40});
        QCOMPARE(p.style(0).stroke, std::optional(blue));
        QCOMPARE(p.session.selection(), app::ObjectRanges({0})); // the click selected nothing
        p.click({60, 60});
        QCOMPARE(p.session.selection(), app::ObjectRanges({2}));
        QCOMPARE(p.session.history.count(), 1);
    }
    void eyedropperGivesUpWithEsc()
    {
        Person p;
        p.session.select({0});
        QTest::keyClick(&p.surface(), Qt::Key_I, Qt::ShiftModifier);
        QTest::keyClick(&p.surface(), Qt::Key_Escape);
        QCOMPARE(p.session.selection(), app::ObjectRanges({0})); // the selection stays
        p.click({60, 40});
        QCOMPARE(p.session.selection(), app::ObjectRanges({1}));
        QCOMPARE(p.session.history.count(), 0);
        QTest::keyClick(&p.surface(), Qt::Key_I, Qt::ShiftModifier);
        p.click({60, 20});
        QCOMPARE(p.style(1).fill, std::optional(red));
    }
    // Events come while panes are made, when there are more panes than widgets for them.
    void eyedropperGoesOnWhileThePanesChange()
    {
        Person p;
        p.session.select({0});
        QTest::keyClick(&p.surface(), Qt::Key_I);
        p.move({60, 40}, {});
        for (const char* panes : {"panes-4", "panes-all", "panes-1"})
            p.t.run(panes);
        p.move({60, 40}, {});
        p.click({60, 40});
        QCOMPARE(p.style(0).stroke, std::optional(blue));
    }
    void styleIsCopiedAndPasted()
    {
        Person p;
        p.session.select({0});
        QTest::keyClick(&p.surface(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(p.t.window->statusBar()->currentMessage().contains("copied"));
        p.session.select({1, 2});
        QTest::keyClick(&p.surface(), Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(p.style(1) == p.style(0) && p.style(2) == p.style(0));
        QCOMPARE(p.session.history.count(), 1);
        QCOMPARE(p.session.history.undoText(), QString("Paste style"));
    }
    void barShowsTheSameAsThePanel()
    {
        Person p;
        p.session.select({0, 1});
        auto* width = p.t.window->optionBar().findChild<LengthField*>();
        QVERIFY(width->text().isEmpty());
        p.open();
        p.typeInto<LengthField>("Stroke width", "4");
        QCOMPARE(width->value(), 4.0);
        auto* button = p.t.window->optionBar().findChild<QToolButton*>("style");
        QVERIFY2(button->toolTip().contains("Ctrl+Shift+F"), qPrintable(button->toolTip()));
    }
    void panelOpensInItsSize()
    {
        Person p;
        QTest::keyClick(&p.surface(), Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
        const QSize size = p.popup().size();
        Person::settle();
        QCOMPARE(p.popup().size(), size);
    }
    void panelKeepsItsSize()
    {
        Person p;
        p.open();
        const QSize size = p.popup().size();
        for (const app::ObjectRanges& selection :
             {app::ObjectRanges{0}, app::ObjectRanges{0, 1}, app::ObjectRanges{}}) {
            p.session.select(selection);
            Person::settle();
            QCOMPARE(p.popup().size(), size);
        }
    }
};

} // namespace ui::properties_style_test

TEST_CLASS(ui::properties_style_test::StyleTest, Widgets)
#include "tests/ui/properties/style_test.moc"
