// SPDX-License-Identifier: GPL-3.0-or-later
#include <QImage>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"
#include "tests/ui/tasks/player.h"

namespace tasks_printing_test {

using namespace tasks;

// Tasks of README.md about printing, into a PDF file.
class PrintingTest : public QObject {
    Q_OBJECT

    /// "2 of 297 × 420": the pages of the file and their size in millimetres.
    static QString printed(const Player& player)
    {
        const auto run = runProgram("pdfinfo", {player.printed()});
        const QString said = QString::fromUtf8(run.out);
        static const QRegularExpression pages(QStringLiteral("Pages: +(\\d+)")),
            size(QStringLiteral("Page size: +([0-9.]+) x ([0-9.]+) pts"));
        const auto found = size.match(said);
        const auto side = [&](int part) {
            return QString::number(qRound(found.captured(part).toDouble() / 72 * 25.4));
        };
        return QString("%1 of %2 × %3").arg(pages.match(said).captured(1), side(1), side(2));
    }
    /// How wide what is drawn on the first page is, in whole millimetres: of the dark pixels at one
    /// pixel a millimetre.
    static int widthOnPaper(const Player& player)
    {
        const QString stem = player.printed() + ".first";
        runProgram("pdftoppm", {"-r", "25.4", "-png", "-singlefile", player.printed(), stem});
        const QImage page(stem + ".png");
        int least = page.width(), most = -1;
        const int marks = page.height() / 10; // where sheets to be joined have theirs
        for (int y = marks; y < page.height() - marks; ++y)
            for (int x = 0; x < page.width(); ++x)
                if (qGray(page.pixel(x, y)) < 200)
                    least = std::min(least, x), most = std::max(most, x);
        return most - least;
    }
    static void checkPrinted(const Steps& steps, const QString& expected)
    {
        const Table room{{{{2000, 2000}, {10400, 2000}, {10400, 7200}, {2000, 7200}}, true}};
        checkPlayer(steps, [&](const Player& player) {
            const QString wrong = difference(player.drawn(), room);
            const QString found = printed(player);
            if (!wrong.isEmpty() || found != expected)
                return !wrong.isEmpty() ? wrong : found;
            const int width = widthOnPaper(player);
            return std::abs(width - 8400 / 50) <= 1 ? QString() : QString("%1 mm").arg(width);
        });
    }
    /// A room of 8.4 × 5.2 m at 1 : 50.
    static Steps plan()
    {
        return {key("Ctrl+Alt+P"), press("A3, 297 × 420 mm"),
                press("Metres"),   clickField("Scale 1 :"),
                key("Ctrl+A"),     type("50"),
                enter(),           key("R"),
                type("2,2"),       enter(),
                type("8.4"),       tab(),
                type("5.2"),       enter()};
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void planPrinted()
    {
        Steps steps = plan();
        add(steps, {key("Ctrl+P"), press("To PDF file…")});
        checkPrinted(steps, "1 of 420 × 297");
    }
    void sheetsPrinted()
    {
        Steps steps = plan();
        add(steps, {key("Ctrl+P"), clickList("Size of the paper"), type("A4"), enter(),
                    press("To PDF file…")});
        checkPrinted(steps, "4 of 297 × 210");
    }
};

} // namespace tasks_printing_test

TEST_CLASS(tasks_printing_test::PrintingTest, Widgets)
#include "tests/ui/tasks/printing_test.moc"
