// SPDX-License-Identifier: GPL-3.0-or-later
#include <QImage>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"
#include "tests/ui/tasks/player.h"

namespace tasks_export_test {

using namespace tasks;

// Tasks of README.md about exports.
class ExportTest : public QObject {
    Q_OBJECT

    static Steps rectangle(const char* corner)
    {
        return {key("R"), type(corner), enter(), type("20"), tab(), type("10"), enter()};
    }
    static Steps another(const char* corner) { return {type(corner), enter(), enter()}; }

    /// A picture of 21 × 11 mm at 300 dpi: nothing inside, the stroke around it.
    static QString faultOfPicture(const Player& player)
    {
        const Table drawn = player.drawn();
        if (drawn.size() != 2 || drawn[1].points.front() != app::Point(80, 90))
            return "the other rectangle is not where it belongs";
        const QImage image(player.exported());
        if (image.size() != QSize(248, 130))
            return QString("%1: %2 × %3")
                .arg(player.exported())
                .arg(image.width())
                .arg(image.height());
        if (image.pixelColor(124, 65).alpha() != 0)
            return "it is not transparent";
        return image.pixelColor(124, 4) == QColor(Qt::black) ? QString() : "there is no stroke";
    }
    /// The size of a PDF page in millimetres.
    static QString pageOf(const QString& pdf)
    {
        const auto run = runProgram("pdfinfo", {pdf});
        static const QRegularExpression size(
            QStringLiteral("Page size: +([0-9.]+) x ([0-9.]+) pts"));
        const auto found = size.match(QString::fromUtf8(run.out));
        const auto side = [&](int part) { return found.captured(part).toDouble() / 72 * 25.4; };
        return QString("%1 × %2").arg(side(1), 0, 'f', 2).arg(side(2), 0, 'f', 2);
    }
    static QString faultOfPage(const Player& player)
    {
        if (player.drawn().size() != 2)
            return "not both are drawn";
        const QString page = pageOf(player.exported());
        return page == "21.00 × 11.00" ? QString() : page;
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void logoPicture()
    {
        Steps steps = rectangle("40,50");
        add(steps, another("#80,90"));
        add(steps,
            {key("V"), click({50, 50}), key("Ctrl+E"), key("Right"), key("Right"),
             press("The selected objects, whole"), press("Nothing behind the drawing"), enter()});
        checkPlayer(steps, faultOfPicture);
    }
    void logoDocument()
    {
        Steps steps = rectangle("40,50");
        add(steps, another("#80,90"));
        add(steps, {key("V"), click({50, 50}), key("Ctrl+E"), key("Right"),
                    press("The selected objects, whole"), enter()});
        checkPlayer(steps, faultOfPage);
    }
    void layerDocument()
    {
        Steps steps = rectangle("40,50");
        add(steps, {press("Add layer"), enter()});
        add(steps, another("80,90"));
        add(steps,
            {key("Ctrl+E"), key("Right"), press("The visible objects of a layer, whole"), enter()});
        checkPlayer(steps, faultOfPage);
    }
    void exportedAgain()
    {
        const auto box = [](const app::Point& at) {
            return Drawn{
                {at, at + app::Point(20, 0), at + app::Point(20, 10), at + app::Point(0, 10)},
                true};
        };
        Steps steps = rectangle("40,50");
        add(steps, {key("Ctrl+E"), enter()});
        add(steps, another("#80,90"));
        add(steps, {key("Ctrl+Shift+E")});
        const Table once{box({40, 50}), box({80, 90})};
        Table twice = once;
        twice.insert(twice.end(), once.begin(), once.end());
        check(steps, twice);
    }
};

} // namespace tasks_export_test

TEST_CLASS(tasks_export_test::ExportTest, Widgets)
#include "tests/ui/tasks/export_test.moc"
