// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_view.h"

#include "app/base/numbers.h"
#include "ui/look/checker.h"
#include "ui/look/focus_ring.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/spoken_role.h"
#include "ui/widgets/swatch.h"

#include <QMouseEvent>
#include <QPainter>
#include <QScreen>

#include <cmath>
#include <utility>

namespace ui {

using namespace std::chrono_literals;

namespace {

constexpr auto mostWaiting = 5ms;
constexpr double step = 1.2; // a key zooms by
constexpr double millimetresPerInch = 25.4;
constexpr double leastDpi = 40, mostDpi = 1000;      // of a screen that tells its size
constexpr int away = 18, foot = 5, roomForWords = 6; // pixels of a size beside the paper
constexpr double scaleBar = 50;                      // millimetres

/// A line with feet and its length in the middle, from left to right.
void paintSize(QPainter& painter, double length, const QString& text, const Look& look)
{
    const QFontMetricsF metrics(painter.font());
    const double words = metrics.horizontalAdvance(text) + 2 * roomForWords;
    if (words > length)
        return;
    painter.setPen(look.muted);
    painter.drawLine(QLineF(0, 0, (length - words) / 2, 0));
    painter.drawLine(QLineF((length + words) / 2, 0, length, 0));
    for (const double x : {0.0, length})
        painter.drawLine(QLineF(x, -foot, x, foot));
    painter.setPen(look.text);
    painter.drawText(QRectF(0, -metrics.height(), length, 2 * metrics.height()), Qt::AlignCenter,
                     text);
}

} // namespace

ExportView::ExportView(app::Session& session, std::shared_ptr<app::LiveExport> live,
                       QWidget* parent)
    : QWidget(parent), session_(session), live_(std::move(live))
{
    setSpokenRole(*this, QAccessible::Canvas);
    setAccessibleName(Text::tr("What is written"));
    setObjectName(QStringLiteral("export-view"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::OpenHandCursor);
    connect(live_.get(), &app::LiveExport::changed, this, &ExportView::follow);
    connect(&navigation_, &Navigation::moved, this, [this] {
        update();
        emit sizeChanged();
    });
    connect(&picture_, &app::LivePicture::advanced, this, qOverload<>(&QWidget::update));
    follow();
}

/// The view stays while the paper does.
void ExportView::follow()
{
    if (live_->making())
        return; // the last one is shown until then
    if (std::exchange(made_, live_->made()) == live_->made())
        return update();
    ++revision_;
    fitOther();
    update();
}

void ExportView::setPapers(std::vector<clipping::Window> papers)
{
    papers_ = std::move(papers);
    fitOther();
    update();
}

/// Fits another paper into the view.
void ExportView::fitOther()
{
    if (!made_ || fitted_ == paper())
        return;
    fitted_ = paper();
    showAt(sizeShown() == Size::True ? Size::True : Size::Whole);
}

clipping::Window ExportView::paper() const
{
    if (papers_.empty())
        return made_->drawing.document.page().rectangle();
    return {papers_.front().min, papers_.back().max};
}

double ExportView::trueZoom() const
{
    const double measured = screen()->physicalDotsPerInch();
    const bool isUsable = measured >= leastDpi && measured <= mostDpi;
    const double dpi = isUsable ? measured : screen()->logicalDotsPerInch();
    const double unit = session_.now().page().millimetresPerUnit();
    return dpi / millimetresPerInch * unit;
}

void ExportView::showAt(Size size)
{
    if (!made_)
        return;
    const clipping::Window paper = this->paper();
    if (size == Size::Whole) {
        const app::Point room = (paper.max - paper.min) * 0.08; // for the sizes beside it
        navigation_.show({paper.min - room, paper.max + room});
    } else {
        app::View view = navigation_.view();
        view.zoom = trueZoom();
        view.centre = (paper.min + paper.max) * 0.5;
        navigation_.go(view);
    }
    emit sizeChanged();
}

std::optional<ExportView::Size> ExportView::sizeShown() const
{
    if (navigation_.isFitted())
        return Size::Whole;
    const bool isTrue = std::abs(navigation_.view().zoom / trueZoom() - 1) < 1e-9;
    return isTrue ? std::optional(Size::True) : std::nullopt;
}

QRectF ExportView::onScreen(const clipping::Window& rectangle) const
{
    const app::Point from = navigation_.view().toScreen(rectangle.min);
    const app::Point to = navigation_.view().toScreen(rectangle.max);
    return {QPointF(from.x, from.y), QPointF(to.x, to.y)};
}

app::FrameWish ExportView::wish() const
{
    const double ratio = devicePixelRatioF();
    app::FrameWish wish{.key = {.lines = made_->lines.revision(),
                                .look = revision_,
                                .view = navigation_.view(),
                                .variant = session_.variant(),
                                .pixels = (QSizeF(size()) * ratio).toSize(),
                                .pixelRatio = ratio},
                        .document = made_->drawing.document,
                        .lines = made_->lines};
    wish.underlays = seenUnderlays(wish.document);
    wish.options.removed = app::RemovedPart::Hidden;
    wish.options.leastWidth = ratio < 1.5 ? 0.75 : 0.5;
    return wish;
}

void ExportView::want(std::chrono::microseconds patience)
{
    if (made_)
        picture_.want(wish(), patience);
}

// Not by repaint(), which paints later if this window was composed less than a frame ago.
void ExportView::settle()
{
    live_->wait();
    want({});
    picture_.settle();
    repaint();
}

void ExportView::paintPaper(QPainter& painter, const QRectF& paper) const
{
    const app::ExportChoice& choice = live_->choice();
    const app::Format& format = app::formatOf(choice);
    const Look& look = lookOnPaper(false);
    painter.fillRect(paper, look.paper);
    const auto background = live_->background();
    if (!format.takes.background || !background)
        return;
    if (background->alpha > 0)
        return painter.fillRect(paper, screenColour(*background));
    if (!format.takes.dpi)
        return; // printed on white paper
    painter.fillRect(paper, checkerOf(look));
}

/// The edge of each sheet, and its number if there are several.
void ExportView::paintPapers(QPainter& painter) const
{
    const Look& look = lookOnPaper(false);
    const std::vector<clipping::Window> papers = papers_.empty() ? std::vector{paper()} : papers_;
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < papers.size(); ++i) {
        const QRectF sheet = onScreen(papers[i]);
        painter.setPen(papers.size() > 1 ? look.selection : look.border);
        painter.drawRect(sheet.adjusted(-0.5, -0.5, 0.5, 0.5));
        if (papers.size() > 1)
            painter.drawText(sheet.adjusted(roomForWords, roomForWords, 0, 0),
                             Qt::AlignLeft | Qt::AlignTop, QString::number(i + 1));
    }
}

void ExportView::paintSizes(QPainter& painter, const QRectF& paper) const
{
    const Look& look = lookOnPaper(false);
    const app::Point size = (this->paper().max - this->paper().min)
                            * made_->drawing.document.page().millimetresPerUnit();
    painter.save();
    painter.translate(paper.left(), paper.top() - away);
    paintSize(painter, paper.width(), app::lengthText(size.x, app::Unit::Mm, 1), look);
    painter.restore();
    painter.save();
    painter.translate(paper.right() + away, paper.bottom());
    painter.rotate(-90);
    paintSize(painter, paper.height(), app::lengthText(size.y, app::Unit::Mm, 1), look);
    painter.restore();
}

/// At true size, so that a person can lay a ruler on the screen.
void ExportView::paintScale(QPainter& painter, const QRectF& paper) const
{
    if (sizeShown() != Size::True)
        return;
    const Look& look = lookOnPaper(false);
    const double dpi = trueZoom() / session_.now().page().millimetresPerUnit() * millimetresPerInch;
    const double length = scaleBar * dpi / millimetresPerInch;
    const QPointF from(std::max(paper.left(), double(away)),
                       std::min(paper.bottom() + 2 * away, height() - 2.0 * away));
    painter.setPen(look.muted);
    painter.drawLine(QLineF(from, from + QPointF(length, 0)));
    for (int tick = 0; tick <= 5; ++tick) {
        const QPointF at = from + QPointF(length * tick / 5, 0);
        const double half = tick % 5 == 0 ? foot : 2;
        painter.drawLine(QLineF(at - QPointF(0, half), at + QPointF(0, half)));
    }
    painter.drawText(from + QPointF(0, foot + painter.fontMetrics().height()),
                     Text::tr("50 mm on this screen (%1 dpi)").arg(app::numberText(dpi, 0)));
}

void ExportView::paintEvent(QPaintEvent*)
{
    const Look& look = lookOnPaper(false);
    QPainter painter(this);
    painter.fillRect(rect(), look.canvas);
    painter.setFont(captionFont(font()));
    if (!made_) {
        painter.setPen(look.muted);
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         live_->error());
    } else {
        want(mostWaiting);
        const QRectF paper = onScreen(this->paper());
        paintPaper(painter, paper);
        painter.save();
        painter.setClipRect(paper);
        picture_.paint(painter);
        painter.restore();
        painter.setRenderHint(QPainter::Antialiasing);
        paintPapers(painter);
        paintSizes(painter, paper);
        paintScale(painter, paper);
    }
    painter.end();
    if (hasFocus())
        paintFocusRing(*this);
}

void ExportView::resizeEvent(QResizeEvent*) { navigation_.resize({width(), height()}); }

void ExportView::wheelEvent(QWheelEvent* event)
{
    navigation_.wheel(*event);
    event->accept();
}

bool ExportView::event(QEvent* event)
{
    if (event->type() == QEvent::NativeGesture
        && navigation_.gesture(*static_cast<QNativeGestureEvent*>(event)))
        return true;
    return QWidget::event(event);
}

void ExportView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton)
        return event->ignore();
    dragged_ = event->position();
    setCursor(Qt::ClosedHandCursor);
}

void ExportView::mouseMoveEvent(QMouseEvent* event)
{
    if (!dragged_)
        return;
    navigation_.pan(event->position() - *dragged_);
    dragged_ = event->position();
}

void ExportView::mouseReleaseEvent(QMouseEvent*)
{
    dragged_.reset();
    setCursor(Qt::OpenHandCursor);
}

void ExportView::mouseDoubleClickEvent(QMouseEvent*) { showAt(Size::Whole); }

void ExportView::keyPressEvent(QKeyEvent* event)
{
    const QPointF middle = QPointF(width(), height()) / 2;
    if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal)
        navigation_.zoomAt(middle, step);
    else if (event->key() == Qt::Key_Minus)
        navigation_.zoomAt(middle, 1 / step);
    else if (event->key() == Qt::Key_Home)
        showAt(Size::Whole);
    else
        QWidget::keyPressEvent(event);
}

} // namespace ui

#include "moc_export_view.cpp"
