// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/text_box.h"

#include "app/lettering/lettering.h"
#include "app/lettering/outline_fonts.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/font_list.h"
#include "ui/widgets/length_field.h"

#include <QKeyEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QVBoxLayout>

namespace ui {
namespace {

constexpr int boxWidth = 320, sizeWidth = 92, boxMargin = 8, mostLines = 6;
constexpr int belowLetters = 12;
constexpr double level = 0.01; // the sine of the angle up to which a text does not go down

} // namespace

TextBox::TextBox(Controller& controller, QWidget* parent)
    : QFrame(parent), controller_(controller), font_(new FontList),
      size_(new LengthField(Text::tr("Height of capital letters"), LengthField::Range::NotNegative,
                            LengthField::Suffix::Unit)),
      text_(new QPlainTextEdit), remark_(new QLabel)
{
    setObjectName(QStringLiteral("textBox"));
    setFixedWidth(boxWidth);
    font_->setFixedHeight(space::fieldHeight);
    size_->setToolTip(size_->accessibleName());
    size_->setFixedWidth(sizeWidth);
    text_->setAccessibleName(Text::tr("Text"));
    text_->setFrameStyle(QFrame::NoFrame);
    text_->setTabChangesFocus(true);
    text_->document()->setDocumentMargin(2);
    text_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    text_->setContextMenuPolicy(Qt::NoContextMenu);
    remark_->setWordWrap(true);
    auto* options = new QHBoxLayout;
    options->setSpacing(boxMargin);
    options->addWidget(font_, 1);
    const auto ctrl = [](Qt::Key key) { return Qt::CTRL | key; };
    faces_ = {{iconButton("bold", Text::tr("Bold")), &app::FontFace::bold, ctrl(Qt::Key_B)},
              {iconButton("italic", Text::tr("Italic")), &app::FontFace::italic, ctrl(Qt::Key_I)}};
    for (const auto& [button, part, key] : faces_) {
        button->setCheckable(true);
        button->setToolTip(
            QStringLiteral("%1 (%2)").arg(button->toolTip(), QKeySequence(key).toString()));
        options->addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, part = part](bool on) {
            change([&](app::TextRecipe& text) { text.face.*part = on; });
            text_->setFocus();
        });
    }
    options->addWidget(size_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(boxMargin, boxMargin, boxMargin, boxMargin);
    column->setSpacing(6);
    column->addWidget(text_);
    column->addWidget(remark_);
    column->addLayout(options);
    hide();
    text_->installEventFilter(this);
    connect(text_, &QPlainTextEdit::textChanged, this, [this] {
        change([this](app::TextRecipe& text) { text.text = text_->toPlainText(); });
    });
    connect(font_, &QComboBox::currentIndexChanged, this,
            [this] { change([this](app::TextRecipe& text) { text.font = font_->font(); }); });
    connect(size_, &LengthField::edited, this,
            [this](double size) { change([size](app::TextRecipe& text) { text.size = size; }); });
    const auto goOn = [this] { text_->setFocus(); };
    connect(font_, &FontList::done, this, goOn);
    connect(size_, &LengthField::entered, this, goOn);
    connect(size_, &LengthField::refused, &controller.session(), &app::Session::refused);
    connect(&controller, &Controller::changed, this, &TextBox::follow);
    connect(&controller.navigation(), &Navigation::moved, this, &TextBox::follow);
}

void TextBox::setSurface(QWidget* surface)
{
    if (surface_)
        surface_->removeEventFilter(this);
    surface_ = surface;
    surface_->installEventFilter(this);
    follow();
}

void TextBox::follow()
{
    if (following_ || !surface_)
        return;
    const QScopedValueRollback guard(following_, true);
    const auto text = controller_.tool().as<TypesText>().typedText();
    if (text)
        return show(*text);
    if (isHidden())
        return;
    const bool had = isAncestorOf(window()->focusWidget());
    hide();
    if (had)
        surface_->setFocus();
}

void TextBox::show(const TypedText& text)
{
    const bool opens = isHidden();
    if (text_->toPlainText() != text.recipe.text) {
        text_->setPlainText(text.recipe.text);
        text_->moveCursor(QTextCursor::End);
    }
    font_->show(text.recipe.font);
    for (const auto& [button, part, key] : faces_) {
        app::FontFace alone;
        alone.*part = true;
        button->setVisible(app::faceOf(text.recipe.font, alone).*part);
        button->setChecked(text.recipe.face.*part);
    }
    const app::Session& session = controller_.session();
    const app::Page& page = session.now().page();
    if (!size_->hasFocus())
        size_->show(text.recipe.size, page.paperUnit(session.display().unit),
                    page.millimetresPerUnit());
    remark_->setText(text.remark);
    remark_->setVisible(!text.remark.isEmpty());
    const int lines = std::clamp(text_->blockCount(), 1, mostLines);
    text_->setFixedHeight(lines * text_->fontMetrics().lineSpacing()
                          + int(2 * text_->document()->documentMargin()) + 2);
    place(text);
    QFrame::show();
    raise();
    if (!opens)
        return;
    text_->selectAll();
    text_->setFocus();
}

/// Below the letters, or above them where they go down, so that they do not push it while they are
/// typed; inside the surface.
void TextBox::place(const TypedText& text)
{
    layout()->activate();
    resize(boxWidth, sizeHint().height());
    const app::View& view = controller_.view();
    const app::Point along = app::alongOf(text.recipe);
    const app::Point min = view.toScreen(text.bounds.min), max = view.toScreen(text.bounds.max);
    const double below = max.y + belowLetters, above = min.y - belowLetters - height();
    const bool fitsBelow = below + height() <= surface_->height();
    const bool prefersAbove = along.y > level && above >= 0;
    const double y = prefersAbove || !fitsBelow ? above : below;
    const double left = along.x < -level ? max.x - width() : min.x;
    const int x = int(std::clamp(left, 0.0, double(std::max(0, surface_->width() - width()))));
    const int inside = int(std::clamp(y, 0.0, double(std::max(0, surface_->height() - height()))));
    move(surface_->mapTo(parentWidget(), QPoint(x, inside)));
}

void TextBox::change(const std::function<void(app::TextRecipe&)>& edit)
{
    const auto typed = controller_.tool().as<TypesText>().typedText();
    if (following_ || !typed)
        return;
    app::TextRecipe text = typed->recipe;
    edit(text);
    controller_.held().use(
        [&](Tool& tool, Workbench& bench) { tool.as<TypesText>().typeText(text, bench); });
}

bool TextBox::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == surface_) {
        if (event->type() == QEvent::FocusIn && !isHidden())
            text_->setFocus();
        return QFrame::eventFilter(watched, event);
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        if ((!key.text().isEmpty() && !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier)))
            || faceOf(key))
            event->accept();
    }
    if (event->type() == QEvent::KeyPress && key(static_cast<const QKeyEvent&>(*event)))
        return true;
    return QFrame::eventFilter(watched, event);
}

/// The face that the key is for, also where the font does not have it: the key is the text's.
const TextBox::Face* TextBox::faceOf(const QKeyEvent& event) const
{
    const auto face = std::ranges::find(faces_, event.keyCombination(), &Face::key);
    return face != faces_.end() ? &*face : nullptr;
}

bool TextBox::key(const QKeyEvent& event)
{
    if (const Face* const face = faceOf(event)) {
        if (face->button->isVisible())
            face->button->click();
        return true;
    }
    const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    const bool ends =
        event.key() == Qt::Key_Escape || (enter && !(event.modifiers() & Qt::ShiftModifier));
    if (ends)
        controller_.held().use(
            [](Tool& tool, Workbench& bench) { tool.as<TypesText>().finishText(bench); });
    else if (enter)
        text_->insertPlainText(QStringLiteral("\n"));
    return ends || enter;
}

void TextBox::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const Look& look = controller_.look();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(look.border, 1));
    painter.setBrush(look.base);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    const QRect field = text_->geometry();
    painter.fillRect(QRect(field.left(), field.bottom() + 1, field.width(), 2), look.selection);
}

} // namespace ui

#include "moc_text_box.cpp"
