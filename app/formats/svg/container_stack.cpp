// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/container_stack.h"

#include "app/base/text.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"

#include <utility>

namespace app::svg {

void ContainerStack::open(Container container)
{
    Open open = open_.back();
    if (open.inGroup)
        container.kind = Container::Kind::Group;
    open.dissolved = dissolves(container);
    if (open.inGroup || open.dissolved)
        lostImages_ += std::exchange(container.underlay, {}) ? 1 : 0;
    if (open.dissolved) {
        open.hidden = open.hidden || !container.visible;
    } else if (container.kind == Container::Kind::Layer) {
        if (atFirstLevel())
            closeDrawing();
        ++layers_;
    } else {
        open.inGroup = true;
        ++groups_;
    }
    open_.push_back(open);
    if (open.dissolved)
        return;
    if (container.kind == Container::Kind::Group && builder_.depth() == 0)
        openDrawing();
    builder_.open(std::move(container));
}

// The last layer is reserved for objects beyond the limit that are in no other layer.
bool ContainerStack::dissolves(const Container& container)
{
    if (container.kind == Container::Kind::Layer && layers_ + 1 >= Containers::mostLayers) {
        if (layers_ < Containers::mostLayers && atFirstLevel())
            closeDrawing();
        return mergesLayers_ = true;
    }
    const bool outside = builder_.depth() == 0; // a layer is opened around a group
    const bool tooMany = container.kind == Container::Kind::Group && groups_ == mostGroups;
    if (!tooMany && (outside || builder_.canOpen()))
        return false;
    ++dissolved_;
    return true;
}

void ContainerStack::close()
{
    if (!open_.back().dissolved)
        builder_.close();
    open_.pop_back();
}

void ContainerStack::add(Object object)
{
    if (builder_.depth() == 0)
        openDrawing();
    object.hidden = object.hidden || open_.back().hidden;
    builder_.add(object);
}

void ContainerStack::openDrawing()
{
    QString name = Text::tr("Drawing");
    if (++layers_ == Containers::mostLayers) {
        name = Text::tr("All further layers");
        mergesLayers_ = true;
    } else if (++drawings_ > 1) {
        name = QStringLiteral("%1 (%2)").arg(name).arg(drawings_);
    }
    builder_.open({.name = name});
    drawingIsOpen_ = true;
}

void ContainerStack::closeDrawing()
{
    if (drawingIsOpen_)
        builder_.close();
    drawingIsOpen_ = false;
}

Document ContainerStack::take(const Page& page, About about, Report& report)
{
    closeDrawing();
    report.add(losses::layers, mergesLayers_ ? 1 : 0);
    report.add(losses::containers, dissolved_);
    report.add(losses::image, lostImages_);
    return builder_.take(page, std::move(about));
}

} // namespace app::svg
