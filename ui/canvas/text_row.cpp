// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/text_row.h"

#include "app/lettering/outline_fonts.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/font_list.h"
#include "ui/widgets/length_field.h"

#include <QHBoxLayout>

#include <algorithm>

namespace ui {
namespace {

constexpr int fontWidth = 132, textSizeWidth = 66; // pixels

} // namespace

TextRow::TextRow(app::Session& session)
    : session_(session), font_(new FontList),
      size_(new LengthField(Text::tr("Height of capital letters"), LengthField::Range::NotNegative,
                            LengthField::Suffix::None))
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(space::labelToField);
    font_->setFrame(false);
    font_->setFixedSize(fontWidth, space::fieldHeight);
    row->addWidget(font_);
    addFaces();
    size_->setObjectName(QStringLiteral("object-capsule-text-size"));
    size_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    size_->setFrame(false);
    size_->setFixedWidth(textSizeWidth);
    size_->setAlignment(Qt::AlignRight);
    size_->setToolTip(size_->accessibleName());
    row->addWidget(size_);
    connect(font_, &QComboBox::activated, this, [this] {
        if (!font_->font().isEmpty())
            say(app::setTextFont(session_, font_->font()));
    });
    connect(font_, &FontList::done, this, &TextRow::done);
    connect(size_, &LengthField::edited, this, [this](double size, app::Merging merging) {
        say(app::setTextSize(session_, size, merging));
    });
}

void TextRow::addFaces()
{
    faces_ = {{iconButton("bold", Text::tr("Bold")), &app::FontFace::bold},
              {iconButton("italic", Text::tr("Italic")), &app::FontFace::italic}};
    for (const auto& [button, part] : faces_) {
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus); // a click leaves the keyboard with the canvas
        layout()->addWidget(button);
        connect(button, &QToolButton::clicked, this,
                [this, part = part](bool on) { say(app::setTextFace(session_, part, on)); });
    }
}

void TextRow::setCompact(bool compact) { compact_ = compact; }

void TextRow::say(const std::optional<QString>& remark)
{
    if (remark)
        emit session_.refused(*remark);
    follow();
}

bool TextRow::follow()
{
    const std::vector<app::TextRecipe> texts = app::selectedTexts(session_);
    setVisible(!texts.empty());
    if (texts.empty())
        return false;
    const auto font = app::commonOf(texts, &app::TextRecipe::font);
    font_->show(font.value_or(QString()));
    if (!font)
        font_->setPlaceholderText(Text::tr("mixed"));
    showFaces(texts);
    if (size_->isBeingTyped())
        return true;
    const app::Page& page = session_.now().page();
    const app::Unit unit = page.paperUnit(session_.display().unit);
    const double millimetres = page.millimetresPerUnit();
    if (app::commonOf(texts, &app::TextRecipe::size))
        size_->show(texts.front().size, unit, millimetres);
    else
        size_->showMixed(texts.front().size, unit, millimetres);
    return true;
}

/// Where fonts differ, what one of them has can be chosen.
void TextRow::showFaces(std::span<const app::TextRecipe> texts)
{
    for (const auto& [button, part] : faces_) {
        app::FontFace alone;
        alone.*part = true;
        const bool has = std::ranges::any_of(texts, [&, part = part](const app::TextRecipe& text) {
            return app::faceOf(text.font, alone).*part;
        });
        button->setVisible(has && !compact_);
        button->setChecked(std::ranges::all_of(
            texts, [part = part](const app::TextRecipe& text) { return text.face.*part; }));
    }
}

} // namespace ui

#include "moc_text_row.cpp"
