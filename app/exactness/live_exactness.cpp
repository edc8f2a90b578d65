// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exactness/live_exactness.h"

namespace app {

using clipping::Clipped;
using clipping::Window;

constexpr std::size_t sliceLines = 250; // a millisecond or two

LiveExactness::LiveExactness(const EditedDocument& document, const Scene& scene, QObject* parent)
    : LiveFinding(document, scene, {mostAtOnce, sliceLines}, parent)
{
}

void LiveExactness::ask(const std::optional<Question>& question)
{
    if (question == asked_)
        return;
    const bool same = question && asked_ && question->variant == asked_->variant;
    asked_ = question;
    if (!same || !upToDate())
        return askAnew(asked_.has_value());
    measure();
    emit changed();
}

void LiveExactness::start(const Window& window) { growing_ = {window}; }

void LiveExactness::look(const SceneLines& lines, std::size_t count)
{
    growing_ = extended(std::move(growing_), asked_->variant, lines, count);
}

void LiveExactness::keep()
{
    found_ = std::exchange(growing_, {});
    measure();
}

void LiveExactness::forget()
{
    found_ = growing_ = {};
    counts_ = {};
    pieces_.clear();
}

void LiveExactness::measure()
{
    counts_ = counted(found_, asked_->yardstick);
    pieces_.assign(errorClasses().size(), {});
    for (const LineExactness& line : found_.list)
        pieces_[errorClassOf(line, asked_->yardstick)].push_back({line.piece, line.source, 0});
}

std::span<const std::vector<Clipped>> LiveExactness::piecesAt(const Window& window) const
{
    if (!asked_ || !upToDate() || found_.window != window)
        return {};
    return pieces_;
}

} // namespace app
