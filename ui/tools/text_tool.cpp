// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/change_paths.h"
#include "app/document/path.h"
#include "app/lettering/lettering.h"
#include "app/lettering/outline_fonts.h"
#include "app/lettering/stroke_fonts.h"
#include "app/session/selection_style.h"
#include "app/session/units.h"
#include "app/view/outline.h"
#include "ui/look/text.h"
#include "ui/tools/picking_marks.h"
#include "ui/tools/shape_drawing.h"

#include <glm/common.hpp>

namespace ui {
namespace {

constexpr std::string_view keptText = "text"; // the size in millimetres
constexpr double baseline = 24;               // pixels of the mark

/// Writes a text of strokes or outlines, and edits one. The letters are typed in a field on the
/// canvas.
class TextTool final : public Tool,
                       public TakenUp,
                       public TypesNumbers,
                       public TypesText,
                       public HasUnfinished {
public:
    void takeUp(Workbench& bench) override
    {
        const auto object = std::exchange(bench.nextObject, std::nullopt);
        if (object)
            edit(*object, bench);
        goesBack_ = object.has_value();
    }
    void press(const Pointer& pointer, Workbench& bench) override
    {
        end(bench);
        goesBack_ = false;
        const auto object = pickedAt(pointer.raw, bench).object;
        if (object && isText(bench.session, *object))
            edit(*object, bench);
        else
            begin(pointer.position, bench);
    }
    void cancel(Workbench&) override
    {
        text_.reset();
        object_.reset();
        letters_ = {};
        changes_ = 0;
    }
    void end(Workbench& bench) override;
    bool busy() const override { return text_.has_value(); }

    std::optional<app::Gauge> gauge(const Workbench& bench) const override
    {
        return busy() ? std::nullopt : std::optional(gaugeOfStart(bench));
    }
    void accept(const app::GestureEnd& end, Workbench& bench) override { begin(end.point, bench); }

    std::optional<TypedText> typedText() const override;
    void typeText(const app::TextRecipe& text, Workbench& bench) override;
    void finishText(Workbench& bench) override
    {
        end(bench);
        if (std::exchange(goesBack_, false))
            bench.nextTool = "select";
    }
    std::optional<app::ObjectInHand> unfinished(const Workbench& bench) const override;
    std::size_t unfinishedPoints() const override { return changes_; }

    QCursor cursor(const Workbench&) const override
    {
        return busy() ? Qt::IBeamCursor : Qt::CrossCursor;
    }
    QString hint(const Workbench&) const override
    {
        return busy() ? Text::tr(
                   "Type the text. Shift+Enter: new line, Enter: end, Tab: font and size.")
                      : QString();
    }
    void paint(QPainter& painter, const Workbench& bench) const override;

private:
    void begin(const app::Point& at, const Workbench& bench);
    void edit(std::size_t object, Workbench& bench);
    void layOut()
    {
        letters_ = app::lettered(*text_);
        ++changes_;
    }
    QString remark() const;
    void paintLetters(QPainter& painter, const Workbench& bench, const app::Style& style) const;
    /// The object that is edited, if it is still the same.
    const app::TextRecipe* edited(const Workbench& bench) const;

    std::optional<app::TextRecipe> text_;
    app::Lettering letters_;
    std::optional<std::size_t> object_; ///< that is edited; empty: a new text
    app::TextRecipe before_;            ///< the text of that object
    std::size_t changes_ = 0;           ///< of text, font and size
    app::FontFace wantedFace_{};        ///< the text has of it what its font has
    bool goesBack_ = false;             ///< to the tool Select when the text is finished
};

void TextTool::begin(const app::Point& at, const Workbench& bench)
{
    const double size = keptBy(keptText, bench, {app::usualTextSize})[0]
                        / bench.session.now().page().millimetresPerUnit();
    const QString font = fontOfNext(bench);
    text_ = app::TextRecipe{{}, font, size, at};
    wantedFace_ = bench.keptFace;
    text_->face = app::faceOf(font, wantedFace_);
    object_.reset();
    layOut();
}

void TextTool::edit(std::size_t object, Workbench& bench)
{
    if (object >= bench.session.now().objects().size() || !isText(bench.session, object))
        return;
    bench.session.select({object});
    bench.session.inspect(std::nullopt);
    before_ = std::get<app::TextRecipe>(
        app::Recipe(bench.session.now().objects()[object].particulars().recipe));
    text_ = before_;
    wantedFace_ = before_.face;
    object_ = object;
    layOut();
    // They stay as they are until the text changes, even if the font is another one by now.
    letters_.paths = bench.session.now().objects()[object].path().subpaths();
}

const app::TextRecipe* TextTool::edited(const Workbench& bench) const
{
    const app::Objects& objects = bench.session.now().objects();
    if (!object_ || *object_ >= objects.size())
        return nullptr;
    const auto* text = std::get_if<app::TextRecipe>(&objects[*object_].particulars().recipe);
    return text && *text == before_ ? text : nullptr;
}

std::optional<app::ObjectInHand> TextTool::unfinished(const Workbench& bench) const
{
    const app::ContainerId into = app::containerForNew(bench.session);
    const bool same = edited(bench);
    if (!busy() || letters_.paths.empty() || (same && *text_ == before_))
        return std::nullopt;
    if (!same)
        return app::ObjectInHand({objectOf(bench.session, letters_.paths, *text_), into});
    app::Object object = bench.session.now().objects()[*object_].copy();
    object.path = app::Path(letters_.paths);
    object.particulars.recipe = *text_;
    return app::ObjectInHand({std::move(object), into}, object_);
}

void TextTool::end(Workbench& bench)
{
    if (!busy())
        return;
    const app::TextRecipe text = *text_;
    const auto object = object_;
    const bool same = edited(bench), changed = text != before_;
    const QString said = !object || changed ? remark() : QString();
    const app::Lettering letters = std::move(letters_);
    cancel(bench);
    app::Session& session = bench.session;
    if (same && changed) {
        const std::array paths{app::ChangedPath{*object, app::Path(letters.paths), text}};
        session.history.push(new app::ChangePaths(session.document, paths, Text::tr("Edit text")));
    } else if (!same && !letters.paths.empty()) {
        draw(bench, letters.paths, Text::tr("Write text"), text);
        bench.lastPoint = text.at;
    }
    if (!said.isEmpty())
        emit session.refused(said);
}

/// Which font and which letters are missing; may be empty.
QString TextTool::remark() const
{
    QStringList all;
    const bool instead =
        object_ && !app::hasFont(before_.font)
        && (text_->font == before_.font || text_->font == app::fontInsteadOf(before_.font));
    if (instead)
        all << app::missingFontText(before_.font);
    if (const QString missing = app::missingText(letters_); !missing.isEmpty())
        all << missing;
    return all.join(u' ');
}

std::optional<TypedText> TextTool::typedText() const
{
    if (!busy())
        return std::nullopt;
    const app::Point top = text_->at - app::downOf(*text_) * text_->size;
    clipping::Window bounds{glm::min(text_->at, top), glm::max(text_->at, top)};
    for (const app::Subpath& path : letters_.paths) {
        bounds = {glm::min(bounds.min, path.start), glm::max(bounds.max, path.start)};
        for (const app::PathSegment& s : path.segments)
            bounds = {glm::min(bounds.min, s.to), glm::max(bounds.max, s.to)};
    }
    return TypedText{*text_, remark(), bounds};
}

void TextTool::typeText(const app::TextRecipe& text, Workbench& bench)
{
    if (!busy() || text == *text_)
        return;
    if (app::hasFont(text.font))
        text_->font = text.font;
    else if (!app::hasFont(text_->font))
        text_->font = app::fontInsteadOf(text_->font);
    // A font that lacks the face does not forget it.
    wantedFace_ = text.face == text_->face ? wantedFace_ : text.face;
    text_->face = app::faceOf(text_->font, wantedFace_);
    text_->text = text.text.left(app::longestText);
    if (text.size > 0)
        text_->size = text.size;
    layOut();
    bench.keptFont = text_->font;
    bench.keptFace = wantedFace_;
    bench.kept[keptText] = {text_->size * bench.session.now().page().millimetresPerUnit()};
}

QPainterPath onScreen(const Workbench& bench, std::vector<app::Subpath> paths, app::FillRule rule)
{
    for (app::Subpath& path : paths)
        app::forEachPoint(path, [&](app::Point& p) { p = bench.view.toScreen(p); });
    return app::painterPath(paths, rule);
}

void TextTool::paintLetters(QPainter& painter, const Workbench& bench,
                            const app::Style& style) const
{
    if (style.fill)
        painter.fillPath(onScreen(bench, letters_.paths, style.fillRule),
                         shownColour(*style.fill, bench));
    if (style.stroke || !style.fill)
        preview(painter, bench, letters_.paths, style);
}

void TextTool::paint(QPainter& painter, const Workbench& bench) const
{
    if (!busy())
        return;
    app::Style style = app::newStyle(bench.session);
    if (edited(bench)) { // covers the text as it was
        const app::ObjectView old = bench.session.now().objects()[*object_];
        style = old.style();
        const QPainterPath lines = onScreen(bench, old.path().subpaths(), style.fillRule);
        painter.strokePath(lines, QPen(bench.look.paper, style.width * bench.view.zoom + 4,
                                       Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        if (style.fill)
            painter.fillPath(lines, bench.look.paper);
    }
    paintLetters(painter, bench, style);
    const app::Point along = app::alongOf(*text_), up = -app::downOf(*text_);
    const QPointF at = bench.onScreen(text_->at);
    painter.setPen(QPen(bench.look.selection, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawLine(at, at + QPointF(along.x, along.y) * baseline);
    painter.drawLine(at, bench.onScreen(text_->at + up * text_->size));
}

} // namespace

std::unique_ptr<Tool> makeTextTool() { return std::make_unique<TextTool>(); }

} // namespace ui
