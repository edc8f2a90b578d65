// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/clip_area.h"
#include "app/formats/svg/container_stack.h"
#include "app/formats/svg/part_count.h"

#include <variant>

namespace app::svg {

/// Content on its way into the document. What is inside of clip paths is collected until they end,
/// and then cut: all of it at once. Layers and groups stay where they are.
///
/// Of an object that is cut, the area remains, filled as before, and above it the lines of its
/// stroke. The first of them keeps the particulars, apart from the recipe.
class ClippedContent {
public:
    /// `bytes`: of all attributes of the file.
    ClippedContent(const Page& page, double tolerance, std::size_t bytes, Report& report)
        : page_(page), parts_(tolerance, bytes), report_(report)
    {
    }

    /// Whether objects keep the areas around them (Particulars::clips) instead of being cut.
    void keepClips(bool keep) { keepsClips_ = keep; }
    bool keepsClips() const { return keepsClips_; }

    void open(Container container);
    void close();
    void add(Object object, const ClipAreas& around);

    /// Counts work on clip paths. Throws Refused beyond the limit.
    void addWork(std::size_t work);
    std::size_t& work() { return work_; }

    /// Cuts what is not cut yet; then the document is as ContainerStack gives it.
    Document take(About about);

private:
    struct Closing {};
    using Event = std::variant<Container, Closing, std::size_t>; ///< the last: adds this object
    struct Scope {
        std::shared_ptr<const ClipArea> area;
        std::vector<Event> events{};
        Objects objects{};
    };

    void moveTo(const ClipAreas& areas);
    void put(Object object);
    void leave();
    std::vector<CutObject> cut(const Scope& scope);
    bool isWideStroke(const ObjectView& object) const;
    void tellSidesOfStrokes(const Scope& scope, std::span<const CutObject> left);
    void putWhatIsLeft(const ObjectView& object, CutObject left);

    const Page& page_;
    PartCount parts_;
    Report& report_;
    ContainerStack containers_;
    std::vector<Scope> scopes_; ///< outermost first
    std::size_t work_ = 0;
    std::size_t looked_ = 0; ///< points of visible wide strokes
    bool keepsClips_ = false;
};

} // namespace app::svg
