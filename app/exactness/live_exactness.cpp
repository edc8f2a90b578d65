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

class LiveExactness::Growing final : public Finding {
public:
    Growing(const Variant& variant, const Window& window) : results{window}, variant_(variant) {}
    void look(const SceneLines& lines, std::size_t count) override
    {
        results = extended(std::move(results), variant_, lines, count);
    }

    ExactnessResults results;

private:
    Variant variant_;
};

std::unique_ptr<LiveFinding::Finding> LiveExactness::start(const Window& window)
{
    return std::make_unique<Growing>(asked_->variant, window);
}

void LiveExactness::keep(Finding& whole)
{
    found_ = std::move(static_cast<Growing&>(whole).results);
    measure();
}

void LiveExactness::forget()
{
    found_ = {};
    counts_ = {};
    pieces_.clear();
}

void LiveExactness::measure()
{
    counts_ = counted(found_, asked_->errorUnit);
    std::vector<std::vector<Clipped>> pieces(errorClasses().size());
    for (const LineExactness& line : found_.list)
        pieces[errorClassOf(line, asked_->errorUnit)].push_back({line.piece, line.source, 0});
    pieces_.clear();
    for (auto& ofClass : pieces)
        pieces_.push_back(std::make_shared<const std::vector<Clipped>>(std::move(ofClass)));
}

std::span<const SharedPieces> LiveExactness::piecesAt(const Window& window) const
{
    if (!asked_ || !upToDate() || found_.window != window)
        return {};
    return pieces_;
}

} // namespace app

#include "moc_live_exactness.cpp"
