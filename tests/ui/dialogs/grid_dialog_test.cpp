// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/grid_dialog.h"
#include "ui/widgets/length_field.h"

#include <QLabel>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace dialogs_grid_dialog_test {

using namespace ui;

// A grid with an angle and spacings of one's own.
class GridDialogTest : public QObject {
    Q_OBJECT

    struct Dialog : Hand {
        Dialog() : Hand({shape({corner()})})
        {
            t.run("grid-own");
            dialog = t.window->findChild<GridDialog*>();
        }
        LengthField* field(const QString& name) const
        {
            for (LengthField* field : dialog->findChildren<LengthField*>())
                if (field->accessibleName() == name)
                    return field;
            return nullptr;
        }
        void type(const QString& name, const QString& text) const
        {
            field(name)->setFocus();
            field(name)->selectAll();
            QTest::keyClicks(field(name), text);
            QTest::keyClick(field(name), Qt::Key_Return);
        }
        const app::Grid& grid() const { return t.window->session().display().grid; }

        GridDialog* dialog = nullptr;
    };

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void whatIsTypedIsShownSnappedToAndSaved()
    {
        Dialog t;
        QVERIFY(t.dialog && t.grid().shown);
        t.type("Spacing along the lines", "20");
        t.type("Spacing across the lines", "1cm");
        t.type("Angle", "30°");
        QCOMPARE(t.grid().text(), QString("shown 20 own lines down=10 angle=30"));
        QCOMPARE(t.grid(),
                 (app::Grid{true, 20, app::Grid::Pattern::Own, app::Grid::Marks::Lines, 10, 30}));
        QCOMPARE(app::Grid::fromText(QSettings().value("grid").toString()), t.grid());
        QVERIFY(t.t.action("grid-own")->isChecked());
        QVERIFY(t.dialog->isVisible()); // Enter ends the field only
        t.dialog->close();
        t.t.window->activateWindow();
        t.canvas.setFocus();
        t.canvas.setSnapping(app::SnapTo::All);
        Hand::key(Qt::Key_L);
        const app::Point along(20 * std::sqrt(0.75), -10), across(5, 10 * std::sqrt(0.75));
        const app::Point from = along + across * 8.0, to = along * 3.0 + across * 8.0;
        t.drag(from + 0.3, to - 0.3);
        Hand::key(Qt::Key_Escape);
        const app::Subpath drawn = t.paths(1).front();
        QVERIFY(glm::distance(drawn.start, from) < 1e-9);
        QVERIFY(glm::distance(drawn.segments[0].to, to) < 1e-9);
    }
    void whatIsImpossibleIsSaid()
    {
        Dialog t;
        const app::Grid before = t.grid();
        t.type("Spacing across the lines", "0");
        t.type("Angle", "1000");
        bool said = false;
        for (const auto* label : t.dialog->findChildren<QLabel*>())
            said = said || label->text().endsWith(u"360°.");
        QVERIFY(said);
        QCOMPARE(t.grid(), before);
        QCOMPARE(t.field("Angle")->value(), before.angle);
    }
};

} // namespace dialogs_grid_dialog_test

TEST_CLASS(dialogs_grid_dialog_test::GridDialogTest, Widgets)
#include "tests/ui/dialogs/grid_dialog_test.moc"
