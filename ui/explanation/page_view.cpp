// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/explanation/page_view.h"

#include "app/base/replace_file.h"
#include "app/base/text.h"
#include "app/lessons/reading.h"
#include "app/teaching/manual.h"
#include "app/teaching/page_figure.h"
#include "ui/explanation/drawn_pictures.h"
#include "ui/explanation/page_style.h"
#include "ui/look/focus_ring.h"
#include "ui/look/text.h"
#include "ui/widgets/algorithm_marker.h"

#include <QDir>
#include <QFile>
#include <QKeyEvent>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextFrame>

#include <algorithm>

namespace ui {

namespace {

constexpr int charactersInLine = 92, leastMargin = 24, smallestZoom = -3, largestZoom = 12;
constexpr double step = 0.1;     // fraction of the text size
constexpr int figureWidth = 620; // logical pixels on paper
constexpr double printRatio = 3; // figure pixels per logical pixel
constexpr double printSize = 10; // points
const QString pictures = QStringLiteral(":/manual/pictures/");

QImage widthOf(const QImage& picture, int width, double ratio)
{
    QImage image = picture.scaledToWidth(std::min(picture.width(), int(width * ratio)),
                                         Qt::SmoothTransformation);
    image.setDevicePixelRatio(ratio);
    return image;
}

/// A picture of the whole window, of which there may be one in the dark theme, NAME-dark.png: to
/// draw it would take a window of its own, for far longer than a frame.
QImage stored(const QString& file, app::Ground ground)
{
    const QString dark = file.chopped(4) + QStringLiteral("-dark.png");
    return QImage(ground == app::Ground::Dark && QFile::exists(dark) ? dark : file);
}

// For printing.
void addFigure(QTextDocument& paper, const clipping::Algorithm& algorithm)
{
    const QUrl figure(QStringLiteral("figure:") + app::latin(algorithm.key));
    paper.addResource(
        QTextDocument::ImageResource, figure,
        app::pageFigure(figure.toString(), app::Ground::Light, figureWidth, printRatio));
}

void addPictures(QTextDocument& paper, const QString& markdown)
{
    static const QRegularExpression drawn(QStringLiteral("\\]\\((sample:[^)]+)\\)"));
    for (auto all = drawn.globalMatch(markdown); all.hasNext();) {
        const QString address = all.next().captured(1);
        paper.addResource(QTextDocument::ImageResource, QUrl(address),
                          DrawnPictures::now(address, figureWidth, printRatio));
    }
    for (const QString& name : QDir(pictures).entryList())
        if (markdown.contains(name))
            paper.addResource(QTextDocument::ImageResource,
                              QUrl(QStringLiteral("pictures/") + name),
                              widthOf(QImage(pictures + name), figureWidth, printRatio));
}

} // namespace

PageView::PageView(QWidget* parent) : QTextBrowser(parent), drawn_(new DrawnPictures(this))
{
    setFrameShape(QFrame::NoFrame);
    setOpenLinks(false);
    // So that a page does not change its own width.
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &PageView::setAnew);
    connect(drawn_, &DrawnPictures::drawn, this, &PageView::setAnew);
    setAccessibleName(Text::tr("Page"));
    connect(this, &QTextBrowser::anchorClicked, this, &PageView::follow);
    connect(this, &QTextBrowser::historyChanged, this,
            &PageView::pageChanged); // source() has changed now
}

void PageView::open(const QString& link) { setSource(QUrl(link), QTextDocument::MarkdownResource); }

void PageView::show(const clipping::Algorithm& algorithm) { open(app::pageLink(algorithm)); }

void PageView::showManual(const QString& topic) { open(topic + QStringLiteral(".md")); }

const clipping::Algorithm* PageView::algorithm() const
{
    return app::algorithmOfPage(source().path());
}

QString PageView::topic() const { return app::topicOfPage(source().path()); }

QString PageView::title() const
{
    const auto manual = app::manualPage(topic());
    return manual ? manual->title : algorithm() ? app::latin(algorithm()->name) : QString();
}

void PageView::follow(const QUrl& link)
{
    const QString path = link.scheme().isEmpty() ? link.path() : QString();
    if (const auto* algorithm = app::algorithmOfPage(path))
        show(*algorithm);
    else if (const QString topic = app::topicOfPage(path); !topic.isEmpty())
        showManual(topic);
    else
        emit linkChosen(link);
}

void PageView::doSetSource(const QUrl& url, QTextDocument::ResourceType type)
{
    QTextBrowser::doSetSource(url, type);
    style();
}

QVariant PageView::loadResource(int type, const QUrl& url)
{
    if (url.scheme() == QStringLiteral("figure"))
        return app::pageFigure(url.toString(), groundOf(palette()), columnWidth(),
                               devicePixelRatioF());
    if (url.scheme() == QStringLiteral("sample"))
        return drawn_->picture(url.toString(), columnWidth(), devicePixelRatioF(),
                               lookOf(palette()));
    if (const auto* algorithm = app::algorithmOfPage(url.path()))
        return app::readingOf(*algorithm).toUtf8();
    if (const auto page = app::manualPage(app::topicOfPage(url.path())))
        return page->markdown.toUtf8();
    if (url.path().startsWith(QStringLiteral("pictures/")))
        return widthOf(stored(QStringLiteral(":/manual/") + url.path(), groundOf(palette())),
                       columnWidth(), devicePixelRatioF());
    return type == QTextDocument::ImageResource ? QVariant()
                                                : QTextBrowser::loadResource(type, url);
}

void PageView::style()
{
    styleMarkdown(*document(), lookOf(palette()));
    fitLines();
}

int PageView::columnWidth() const
{
    const int comfortable = fontMetrics().averageCharWidth() * charactersInLine;
    return std::max(200, std::min(comfortable, viewport()->width() - 2 * leastMargin));
}

void PageView::fitLines()
{
    QTextFrameFormat format = document()->rootFrame()->frameFormat();
    const int side = std::max(leastMargin, (viewport()->width() - columnWidth()) / 2);
    format.setLeftMargin(side);
    format.setRightMargin(side);
    format.setTopMargin(leastMargin);
    format.setBottomMargin(2 * leastMargin);
    document()->rootFrame()->setFrameFormat(format);
}

void PageView::setZoom(int steps)
{
    zoom_ = std::clamp(steps, smallestZoom, largestZoom);
    QFont larger;
    larger.setPointSizeF(larger.pointSizeF() * (1 + step * zoom_));
    setFont(larger);
    if (!source().isEmpty())
        reload();
}

int PageView::find(const QString& text, QTextDocument::FindFlags direction)
{
    const Look& look = lookOf(palette());
    QList<QTextEdit::ExtraSelection> marks;
    for (QTextCursor found = document()->find(text); !found.isNull() && !text.isEmpty();
         found = document()->find(text, found)) {
        QTextEdit::ExtraSelection mark;
        mark.cursor = found;
        mark.format.setBackground(look.tint);
        marks << mark;
    }
    setExtraSelections(marks);
    if (!marks.isEmpty() && !QTextBrowser::find(text, direction)) {
        moveCursor(direction.testFlag(QTextDocument::FindBackward) ? QTextCursor::End
                                                                   : QTextCursor::Start);
        QTextBrowser::find(text, direction);
    }
    return int(marks.size());
}

void PageView::forgetFound()
{
    setExtraSelections({});
    QTextCursor cursor = textCursor();
    cursor.clearSelection();
    setTextCursor(cursor);
}

std::optional<QString> PageView::saveAsPdf(const QString& file) const
{
    QTextDocument paper;
    QFont body;
    body.setPointSizeF(printSize);
    paper.setDefaultFont(body);
    const auto manual = app::manualPage(topic());
    manual ? addPictures(paper, manual->markdown) : addFigure(paper, *algorithm());
    paper.setMarkdown(manual ? manual->markdown : app::readingOf(*algorithm()));
    styleMarkdown(paper, lookOf(QPalette(Qt::white)));
    return app::replaceFile(file, [&paper, this](QIODevice& out) -> std::optional<QString> {
        QPdfWriter writer(&out);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins({22, 20, 22, 20}, QPageLayout::Millimeter);
        writer.setTitle(title());
        paper.print(&writer);
        return std::nullopt;
    });
}

/// Reloads the page later, because a page may be loading now. Figures depend on the line width and
/// the palette.
void PageView::setAnew()
{
    if (source().isEmpty())
        return;
    const int before = verticalScrollBar()->value();
    reload();
    verticalScrollBar()->setValue(before);
}

void PageView::resizeEvent(QResizeEvent* event)
{
    QTextBrowser::resizeEvent(event);
    if (event->oldSize().width() != event->size().width())
        soon_.start();
}

void PageView::changeEvent(QEvent* event)
{
    QTextBrowser::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::LocaleChange)
        soon_.start();
}

void PageView::paintEvent(QPaintEvent* event)
{
    QTextBrowser::paintEvent(event);
    if (hasFocus())
        paintFocusRing(*viewport());
}

void PageView::focusInEvent(QFocusEvent* event)
{
    QTextBrowser::focusInEvent(event);
    viewport()->update();
}

void PageView::focusOutEvent(QFocusEvent* event)
{
    QTextBrowser::focusOutEvent(event);
    viewport()->update();
}

void PageView::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::ZoomIn) || event->matches(QKeySequence::ZoomOut))
        return event->ignore(); // leave the window's shortcuts to the window
    QTextBrowser::keyPressEvent(event);
}

void PageView::wheelEvent(QWheelEvent* event)
{
    if (!event->modifiers().testFlag(Qt::ControlModifier))
        return QTextBrowser::wheelEvent(event);
    if (event->angleDelta().y() != 0)
        setZoom(zoom_ + (event->angleDelta().y() > 0 ? 1 : -1));
    event->accept();
}

} // namespace ui

#include "moc_page_view.cpp"
