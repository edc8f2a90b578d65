// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/units.h"
#include "ui/docks/dock.h"
#include "ui/properties/properties_panel.h"
#include "ui/properties/selection_panel.h"
#include "ui/properties/style_panel.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/segments.h"

#include <QSignalSpy>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace properties_panel_test {

using namespace ui;

// The section Properties, with mouse and keys.
class PropertiesPanelTest : public QObject {
    Q_OBJECT

    struct Panel : Hand {
        explicit Panel() : Hand({shape({wave()})})
        {
            t.window->raisePanel("properties");
            waitForFinalSize(panel());
        }
        static void settle() { QTest::qWait(20); } // the panel follows after the events
        PropertiesPanel& panel() const { return *t.window->findChild<PropertiesPanel*>(); }
        template <typename Part>
        Part& part() const
        {
            return *panel().findChild<Part*>();
        }
        template <typename Field>
        bool shows(const QString& name) const
        {
            for (Field* field : panel().findChildren<Field*>())
                if (field->accessibleName() == name)
                    return field->isVisible();
            qFatal("no field of this name");
        }
        void restyle(const app::ChangeStyle& change) const
        {
            app::restyle(session, change, QStringLiteral("style"));
            settle();
        }
    };

private slots:
    void itShowsWhatTheSelectionHasAtOneHeight()
    {
        Panel p;
        const QPoint chooser = p.part<StylePanel>().pos();
        const int height = p.panel().height();
        QVERIFY(!p.part<SelectionPanel>().isVisible() && p.part<StylePanel>().isVisible());
        QCOMPARE(p.panel().title(), QString("nothing selected, pen for new objects"));
        for (const app::ObjectRanges& selected : {app::ObjectRanges{0}, app::ObjectRanges()}) {
            p.session.select(selected);
            QTRY_COMPARE(p.part<SelectionPanel>().isVisible(), !selected.empty());
            QTRY_COMPARE(p.part<StylePanel>().pos(), chooser); // nothing jumps
            QCOMPARE(p.panel().height(), height);
            QCOMPARE(p.panel().sizeHint().height(), height);
        }
    }
    void thereIsAFillRuleOnlyWithAFillAndALimitOnlyWithMiters()
    {
        Panel p;
        p.session.select({0});
        p.restyle([](app::Style& style) {
            style.fill = app::Colour{1, 2, 3};
            style.join = app::Join::Miter;
        });
        QVERIFY(p.shows<Segments>("Fill rule") && p.shows<LengthField>("Miter limit"));
        p.restyle([](app::Style& style) { style.fill.reset(); });
        QVERIFY(!p.shows<Segments>("Fill rule") && p.shows<LengthField>("Miter limit"));
        p.restyle([](app::Style& style) { style.join = app::Join::Round; });
        QVERIFY(!p.shows<LengthField>("Miter limit"));
    }
    void theHeadingNamesWhatIsSelectedAlsoWhileFolded()
    {
        Panel p;
        auto& dock = *p.t.window->findChild<Dock*>("properties");
        dock.setFolded(true);
        const QSignalSpy titled(&p.panel(), &PropertiesPanel::titled);
        p.session.select({0});
        Panel::settle();
        QCOMPARE(titled.last()[0].toString(), app::selectionText(p.session));
        p.t.run("group");
        Panel::settle();
        QCOMPARE(titled.last()[0].toString(), QString("group of 1 object"));
    }
    void theHeadingNamesTheNode()
    {
        Panel p;
        p.doubleClick(wave().start);
        p.click({80, 50});
        Panel::settle();
        QCOMPARE(p.panel().title(), QString("node 2 of 3"));
    }
};

} // namespace properties_panel_test

TEST_CLASS(properties_panel_test::PropertiesPanelTest, Widgets)
#include "tests/ui/properties/properties_panel_test.moc"
