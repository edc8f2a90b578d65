// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/hard_cases/case_use.h"
#include "app/lessons/reading.h"
#include "app/teaching/line_text.h"
#include "app/teaching/manual.h"
#include "ui/docks/algorithm_list.h"
#include "ui/explanation/explanation_window.h"
#include "ui/explanation/page_view.h"
#include "ui/hard_cases/case_list.h"
#include "ui/hard_cases/case_view.h"
#include "ui/hard_cases/hard_cases_window.h"

#include <QAbstractTextDocumentLayout>
#include <QMenu>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextFrame>

#include <array>
#include <cmath>

#include "tests/not_empty.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace explanation_explanation_test {

using namespace ui;

namespace {

const clipping::Algorithm& row(const char* abbreviation)
{
    return *clipping::findAlgorithm(abbreviation);
}

/// The headings of every page, in this order; then one or more references.
const QStringList sections{
    "History and citation", "Pseudo-code", "Step by step",  "Strengths",
    "As published",         "Corrected",   "What it costs", "Three dimensions and polygons",
    "Where rounding bites"};

/// Infinities and NaNs have no link.
bool isFinite(const app::HardCase& hard)
{
    const auto& [a, b] = hard.line;
    const auto& [min, max] = hard.window;
    return std::ranges::all_of(std::array{a, b, min, max}, [](const glm::dvec2& p) {
        return std::isfinite(p.x) && std::isfinite(p.y);
    });
}

QStringList headingsOf(const QTextDocument& page)
{
    QStringList headings;
    for (QTextBlock block = page.begin(); block.isValid(); block = block.next())
        if (block.blockFormat().headingLevel() == 2)
            headings << block.text();
    return headings;
}

/// Every link of a page, in the order of the document.
QStringList linksOf(const QTextDocument& page)
{
    QStringList links;
    for (QTextBlock block = page.begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part)
            if (part.fragment().charFormat().isAnchor())
                links << part.fragment().charFormat().anchorHref();
    links.removeDuplicates();
    return links;
}

/// The position of a link's first letter in the view.
QPoint placeOf(PageView& view, const QString& link)
{
    for (QTextBlock block = view.document()->begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part)
            if (part.fragment().charFormat().anchorHref() == link) {
                QTextCursor cursor(view.document());
                cursor.setPosition(part.fragment().position() + 1);
                view.setTextCursor(cursor);
                view.ensureCursorVisible();
                return view.cursorRect(cursor).center();
            }
    return {};
}

struct Reader {
    Reader()
    {
        test.show();
        QTest::keyClick(test.drawingArea(), Qt::Key_F1, Qt::ShiftModifier);
        window = test.window->findChild<ExplanationWindow*>();
        page = &window->page();
        active();
    }
    void active() const
    {
        QVERIFY(QTest::qWaitForWindowExposed(window));
        window->activateWindow();
        QTRY_COMPARE(QApplication::activeWindow(), static_cast<QWidget*>(window));
    }
    void click(const QString& link) const
    {
        QTest::mouseClick(page->viewport(), Qt::LeftButton, {}, placeOf(*page, link));
    }
    QString title() const { return page->document()->begin().text(); }

    TestWindow test;
    ExplanationWindow* window = nullptr;
    PageView* page = nullptr;
};

} // namespace

class ExplanationTest : public QObject {
    Q_OBJECT

private slots:
    void shiftF1ShowsTheCurrentAlgorithm()
    {
        Reader reader;
        QVERIFY(reader.window->isVisible());
        QCOMPARE(reader.page->algorithm(),
                 reader.test.window->session().display().variant.algorithm);
        app::Display display = reader.test.window->session().display();
        display.variant.algorithm = &row("Skala");
        reader.test.window->session().setDisplay(display);
        reader.test.action("about-algorithm")->trigger();
        QCOMPARE(reader.page->algorithm(), &row("Skala"));
        QCOMPARE(reader.title(), QStringLiteral("Skala"));
        QCOMPARE(reader.test.window->findChildren<ExplanationWindow*>().size(), 1);
    }

    void shiftF1ShowsTheMicroscopesAlgorithm()
    {
        Reader reader;
        auto& session = reader.test.window->session();
        session.microscope.open(*app::tracedLineOf(
            QUrl(QStringLiteral("clearcut:trace?a=NLN&line=-1,0,3,1&w=0,0,2,2"))));
        reader.test.action("about-algorithm")->trigger();
        QCOMPARE(reader.page->algorithm(), &row("NLN"));
    }

    void everyPageIsComplete_data() { everyAlgorithm(); }
    void everyPageIsComplete()
    {
        QFETCH(const clipping::Algorithm*, algorithm);
        PageView page;
        page.resize(900, 700);
        page.show(*algorithm);
        QCOMPARE(page.document()->begin().text(), app::latin(algorithm->name));
        QVERIFY(page.document()->characterCount() > 800);
        QVERIFY(!page.toPlainText().contains(QStringLiteral("SPDX")));
        for (const QString& line : app::shownCode(algorithm->correctedCode))
            QVERIFY2(page.toPlainText().contains(line.trimmed()), qPrintable(line));
        QVERIFY(!page.grab().isNull());
        QCOMPARE(headingsOf(*page.document()).mid(0, sections.size()), sections);
        int figures = 0;
        for (QTextBlock block = page.document()->begin(); block.isValid(); block = block.next())
            for (auto part = block.begin(); !part.atEnd(); ++part) {
                const QTextCharFormat format = part.fragment().charFormat();
                if (!format.isImageFormat())
                    continue;
                const QUrl address(format.toImageFormat().name());
                const auto picture =
                    page.document()->resource(QTextDocument::ImageResource, address);
                QVERIFY2(picture.value<QImage>().width() > 200, qPrintable(address.toString()));
                ++figures;
            }
        QVERIFY(figures >= 1);
    }

    // All links of all pages lead somewhere: to a page, a line, a case, a filter, or the web.
    void everyLinkResolves_data() { everyAlgorithm(); }
    void everyLinkResolves()
    {
        QFETCH(const clipping::Algorithm*, algorithm);
        PageView page;
        page.resize(900, 700);
        page.show(*algorithm);
        for (const QString& text : notEmpty(linksOf(*page.document()))) {
            const QUrl link(text);
            const QString after = link.path().section(u'/', 1);
            const bool good =
                link.scheme() == QStringLiteral("https")
                || (link.scheme().isEmpty() && app::algorithmOfPage(link.path()))
                || app::tracedLineOf(link) || app::findHardCase(after)
                || (link.path().startsWith(QStringLiteral("fails/")) && app::findVariant(after));
            QVERIFY2(good, qPrintable(text));
        }
    }

    void linksLeadToOtherPagesAndBack()
    {
        Reader reader;
        reader.window->show(row("MD"));
        reader.click(QStringLiteral("kodituwakku-wijeweera-chamikara.md"));
        QCOMPARE(reader.page->algorithm(), &row("KWC"));
        QTest::keyClick(reader.window, Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(reader.page->algorithm(), &row("MD"));
        QVERIFY(reader.window->windowTitle().contains(app::latin(row("MD").name)));
        QTest::keyClick(reader.window, Qt::Key_Right, Qt::AltModifier);
        QCOMPARE(reader.page->algorithm(), &row("KWC"));
        auto* list = reader.window->findChild<QListView*>();
        QVERIFY(list->currentIndex().data().toString().startsWith(app::latin(row("KWC").name)));
        const QModelIndex above = list->currentIndex().siblingAtRow(list->currentIndex().row() - 1);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(above).center());
        QVERIFY(above.data().toString().startsWith(app::latin(reader.page->algorithm()->name)));
        QVERIFY(reader.page->algorithm() != &row("KWC"));
    }

    void linksToTheHardCases()
    {
        Reader reader;
        reader.window->show(row("CS"));
        reader.click(QStringLiteral("clearcut:case/plotink-40"));
        auto* casesWindow = reader.test.window->findChild<HardCasesWindow*>();
        QVERIFY(casesWindow);
        QCOMPARE(casesWindow->view().hardCase(), app::findHardCase(QStringLiteral("plotink-40")));
        reader.window->show(row("KWC"));
        reader.click(QStringLiteral("clearcut:fails/kodituwakku-wijeweera-chamikara:published"));
        QVERIFY(casesWindow->list().model()->rowCount() < int(app::hardCases().size()));
        QVERIFY(casesWindow->list().model()->rowCount() > 10);
    }

    void linksOpenTheMicroscope_data()
    {
        QTest::addColumn<QString>("link");
        QTest::addColumn<bool>("good");
        const auto link = [](const char* text, bool good) {
            QTest::newRow(text) << QString(text) << good;
        };
        link("clearcut:trace?a=cohen-sutherland:published&line=1,1,-1,-1&w=0.1,0.1,3,3", true);
        link("clearcut:trace?a=MD&line=-1e-300,0,1,1&w=0,0,1,1", true);
        link("clearcut:trace?a=nobody&line=1,1,-1,-1&w=0,0,3,3", false);
        link("clearcut:trace?a=MD&line=1,1,-1&w=0,0,3,3", false);
        link("clearcut:trace?a=MD&line=1,1,-1,x&w=0,0,3,3", false);
        link("clearcut:trace", false);
        link("https://example.org/trace?a=MD&line=1,1,-1,-1&w=0,0,3,3", false);
    }
    void linksOpenTheMicroscope()
    {
        QFETCH(QString, link);
        QFETCH(bool, good);
        const auto tracedLine = app::tracedLineOf(QUrl(link));
        QCOMPARE(tracedLine.has_value(), good);
        if (tracedLine)
            QCOMPARE(tracedLine->y, app::YAxis::Up);
    }

    // Numbers survive the text of a link bit for bit.
    void linksKeepEveryBitOfALine()
    {
        int links = 0;
        for (const app::HardCase& hard : app::hardCases()) {
            const auto there = app::tracedLineOf(hard, {&row("CS"), clipping::Form::Published});
            const auto link = app::traceLink(there);
            QVERIFY2(link.has_value() == isFinite(hard), qPrintable(hard.key));
            if (!link)
                continue;
            ++links;
            const auto back = app::tracedLineOf(QUrl(*link));
            QVERIFY2(back, qPrintable(*link));
            QVERIFY(back->line == there.line && back->window == there.window);
            QCOMPARE(app::keyOf(back->variant), QStringLiteral("cohen-sutherland:published"));
        }
        QVERIFY(links > 30);
    }

    void aHardCaseOpensInTheMicroscope()
    {
        Reader reader;
        reader.window->show(row("CS"));
        const app::HardCase& hard = *app::findHardCase(QStringLiteral("plotink-40"));
        reader.click(
            *app::traceLink(app::tracedLineOf(hard, {&row("CS"), clipping::Form::Published})));
        const auto& microscope = reader.test.window->session().microscope;
        QVERIFY(microscope.isOpen());
        QCOMPARE(microscope.tracedLine().line, hard.line);
        QVERIFY(microscope.narration().outcome == clipping::Outcome::DidNotEnd);
    }

    void textIsFoundOnThePage()
    {
        Reader reader;
        reader.window->show(row("MD"));
        QTest::keyClick(reader.window, Qt::Key_F, Qt::ControlModifier);
        auto* field = reader.window->findChild<QLineEdit*>("find-on-page");
        QVERIFY(field->isVisible());
        QTest::keyClicks(field, QStringLiteral("window"));
        const QTextCursor first = reader.page->textCursor();
        QCOMPARE(first.selectedText().toLower(), QStringLiteral("window"));
        QVERIFY(reader.page->extraSelections().size() > 2);
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(reader.page->textCursor().position() > first.position());
        for (qsizetype i = 1; i < reader.page->extraSelections().size(); ++i)
            QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(reader.page->textCursor().position(), first.position()); // round again
        QTest::keyClicks(field, QStringLiteral("xyz"));
        QCOMPARE(reader.page->extraSelections().size(), 0);
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(!field->isVisible() && reader.window->isVisible());
    }

    void textBecomesLargerAndSmaller()
    {
        Reader reader;
        const double before = reader.page->document()->defaultFont().pointSizeF();
        QTest::keyClick(reader.window, Qt::Key_Plus, Qt::ControlModifier);
        QVERIFY(reader.page->document()->defaultFont().pointSizeF() > before);
        QTest::keyClick(reader.window, Qt::Key_0, Qt::ControlModifier);
        QCOMPARE(reader.page->document()->defaultFont().pointSizeF(), before);
        QTest::keyClick(reader.window, Qt::Key_Minus, Qt::ControlModifier);
        QVERIFY(reader.page->document()->defaultFont().pointSizeF() < before);
    }

    // Lines are neither too long to read nor wider than the window.
    void linesHaveAReadableLength()
    {
        PageView page;
        page.resize(1800, 700);
        page.QWidget::show();
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        page.show(row("MD"));
        const auto format = page.document()->rootFrame()->frameFormat();
        const double line = 1800 - format.leftMargin() - format.rightMargin();
        QVERIFY(line < 100 * page.fontMetrics().averageCharWidth());
        QVERIFY(line > 60 * page.fontMetrics().averageCharWidth());
        page.resize(500, 700);
        QTRY_VERIFY(page.document()->rootFrame()->frameFormat().leftMargin() < 40);
    }

    void codeStaysInItsBox_data() { everyAlgorithm(); }
    void codeStaysInItsBox()
    {
        QFETCH(const clipping::Algorithm*, algorithm);
        for (const int width : {500, 900}) {
            PageView view;
            view.resize(width, 700);
            view.QWidget::show();
            QVERIFY(QTest::qWaitForWindowExposed(&view));
            view.show(*algorithm);
            const QTextDocument& page = *view.document();
            page.documentLayout()->documentSize(); // lays out all of it
            const auto frame = page.rootFrame()->frameFormat();
            const double column =
                view.viewport()->width() - frame.leftMargin() - frame.rightMargin();
            int blocks = 0;
            for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
                const QTextBlockFormat format = block.blockFormat();
                if (!format.hasProperty(QTextFormat::BlockCodeFence)
                    && !format.hasProperty(QTextFormat::BlockCodeLanguage))
                    continue;
                ++blocks;
                for (int i = 0; i < block.layout()->lineCount(); ++i) {
                    const QTextLine line = block.layout()->lineAt(i);
                    QVERIFY2(line.x() + line.naturalTextWidth() <= column - format.rightMargin(),
                             qPrintable(block.text()));
                }
            }
            QVERIFY(blocks > 0);
        }
    }
    void pagesFollowTheTheme()
    {
        Reader reader;
        reader.window->show(row("MD"));
        const auto codeGround = [&] {
            for (QTextBlock block = reader.page->document()->begin(); block.isValid();
                 block = block.next())
                if (block.text().contains(QStringLiteral("reject"))
                    && block.blockFormat().background().style() != Qt::NoBrush)
                    return block.blockFormat().background().color();
            return QColor();
        };
        QCOMPARE(codeGround(), lookOf(reader.page->palette()).panel);
        const QColor light = codeGround();
        reader.test.window->setTheme(Theme::Dark);
        QTRY_COMPARE(codeGround(), lookOf(reader.page->palette()).panel);
        QVERIFY(codeGround() != light);
        reader.test.window->setTheme(Theme::Light);
    }

    // Later, on another thread: until then there is an empty picture of the same size.
    void samplesAreDrawn()
    {
        PageView page;
        page.resize(700, 700);
        page.QWidget::show();
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        page.showManual(QStringLiteral("first-cut"));
        const auto picture = [&page] {
            for (QTextBlock block = page.document()->begin(); block.isValid(); block = block.next())
                for (auto part = block.begin(); !part.atEnd(); ++part)
                    if (const auto format = part.fragment().charFormat(); format.isImageFormat())
                        return page.document()
                            ->resource(QTextDocument::ImageResource,
                                       QUrl(format.toImageFormat().name()))
                            .value<QImage>();
            return QImage();
        };
        const QSize size = picture().size();
        QVERIFY(size.width() > 500);
        const auto dark = [&] { // pixels, of a disc among others
            const QImage now = picture();
            int count = 0;
            for (int y = 0; y < now.height(); ++y)
                for (int x = 0; x < now.width(); ++x)
                    count += qGray(now.pixel(x, y)) < 60;
            return count;
        };
        QTRY_VERIFY(dark() > 200);
        QCOMPARE(picture().size(), size);
    }

    void aPageIsSavedAsPdf()
    {
        Reader reader;
        auto prepared = std::make_unique<PreparedAnswers>(*reader.window);
        PreparedAnswers& answers = *prepared;
        reader.window->setQuestions(std::move(prepared));
        answers.save = reader.test.path("page.pdf");
        reader.window->show(row("LB"));
        QTest::keyClick(reader.window, Qt::Key_P, Qt::ControlModifier);
        QCOMPARE(answers.proposed, QStringLiteral("liang-barsky.pdf"));
        QFile file(answers.save);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.read(5) == "%PDF-" && file.size() > 5000);
        QVERIFY(reader.page->saveAsPdf(reader.test.path("no/such/folder.pdf")).has_value());
    }

    void rowsOfAlgorithmsOfferTheirPage()
    {
        Reader reader;
        reader.window->hide();
        reader.test.window->raisePanel("algorithm");
        auto* list = reader.test.window->findChild<AlgorithmList*>();
        const QRect third = list->visualRect(list->model()->index(2, 0));
        QTest::mouseMove(list->viewport(), third.center());
        QTest::mouseMove(list->viewport(), third.center() + QPoint(1, 0));
        auto* about = list->viewport()->findChild<QToolButton*>();
        QTRY_VERIFY(about->isVisible());
        QTest::mouseClick(about, Qt::LeftButton);
        QVERIFY(reader.window->isVisible());
        QCOMPARE(reader.page->algorithm(), &clipping::algorithms()[2]);
        const QPoint fifth = list->visualRect(list->model()->index(4, 0)).center();
        QContextMenuEvent asked(QContextMenuEvent::Mouse, fifth,
                                list->viewport()->mapToGlobal(fifth));
        QCoreApplication::sendEvent(list->viewport(), &asked);
        auto* menu = reader.test.window->findChild<QMenu*>("algorithm-menu");
        QVERIFY(menu);
        menu->findChild<QAction*>("about-algorithm")->trigger();
        QCOMPARE(reader.page->algorithm(), &clipping::algorithms()[4]);
    }

private:
    static void everyAlgorithm()
    {
        QTest::addColumn<const clipping::Algorithm*>("algorithm");
        for (const auto& algorithm : clipping::algorithms())
            QTest::newRow(algorithm.key.data()) << &algorithm;
    }
};

} // namespace explanation_explanation_test

TEST_CLASS(explanation_explanation_test::ExplanationTest, Widgets)
#include "tests/ui/explanation/explanation_test.moc"
