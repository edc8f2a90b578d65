// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/clip_text.h"

#include "app/document/object_view.h"
#include "app/document/window_shape.h"
#include "app/formats/svg/attribute_text.h"

namespace app::svg {

void ClipText::append(std::string& text, const Document& document, const OutlineText& outlines)
{
    std::string elements;
    const Objects& objects = document.objects();
    objects.forEach(0, objects.size(), [&](std::size_t, const ObjectView& object) {
        define(elements, object.particulars().clips, outlines);
    });
    if (!elements.empty())
        text.append("<defs>\n").append(elements).append("</defs>\n");
}

// A clip path that is inside others refers to them.
void ClipText::define(std::string& text, KeptClips clips, const OutlineText& outlines)
{
    if (clips.empty() || ids_.contains(clips))
        return;
    KeptClips around = clips;
    around.pop_back();
    define(text, around, outlines);
    std::string content;
    appendReference(content, around);
    content += ">\n";
    for (const ClipWindow& window : clips.back()->list) {
        const PathShape shape = pathOf(window.shape);
        content += "<path";
        if (shape.rule == FillRule::EvenOdd)
            appendAttribute(content, "clip-rule", "evenodd");
        content += " d=\"";
        for (const Subpath& path : shape.path.subpaths())
            outlines.appendPathData(content, path);
        content += "\"/>\n";
    }
    const auto [same, isNew] = written_.try_emplace(
        std::move(content), "clearcut-clip-" + std::to_string(written_.size() + 1));
    ids_.emplace(std::move(clips), same->second);
    if (!isNew)
        return;
    text += "<clipPath";
    appendAttribute(text, "id", same->second);
    text.append(same->first).append("</clipPath>\n");
}

void ClipText::appendReference(std::string& text, const KeptClips& clips) const
{
    if (const auto id = ids_.find(clips); !clips.empty() && id != ids_.end())
        appendAttribute(text, "clip-path", "url(#" + id->second + ")");
}

} // namespace app::svg
