// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/recovery.h"

#include "app/base/unfinished.h"
#include "app/recovery/signal_watch.h"
#include "ui/files/files.h"
#include "ui/look/text.h"
#include "ui/window/main_window.h"

#include <QPointer>

#include <cstdio>
#include <cstring>
#include <exception>
#include <mutex>

namespace ui {

/// A signal ends the process for all of them.
struct Recovery::Watch {
    static std::shared_ptr<Watch> get()
    {
        static std::weak_ptr<Watch> shared;
        auto watch = shared.lock();
        if (!watch)
            shared = watch = std::make_shared<Watch>();
        return watch;
    }

    void keep(int signal)
    {
        const std::lock_guard guard(lock);
        for (const Recovery* one : all)
            one->keep(signal);
        app::removeUnfinished(); // the partial file of a Save that the signal interrupted
    }

    std::mutex lock;
    std::vector<const Recovery*> all;
    app::SignalWatch signalWatch{[this](int signal) { keep(signal); }};
};

Recovery::Recovery(MainWindow& window, QString folder, const app::Journal::Limits& limits)
    : window_(window), folder_(std::move(folder)), file_(app::newLeftoverFile(folder_)),
      work_(window.session().document),
      journal_(window.session().document, window.session().history, folder_, limits)
{
    const app::Session& session = window.session();
    connect(&session, &app::Session::fileChanged, this, &Recovery::forgetRecovered);
    connect(&session, &app::Session::fileChanged, this, &Recovery::tell);
    connect(&session.history, &app::History::cleanChanged, this, &Recovery::tell);
    connect(&window.files(), &Files::nameChanged, this, &Recovery::tell);
    connect(&window.canvas(), &Canvas::stepsChanged, this, &Recovery::tell);
    connect(&journal_, &app::Journal::completeChanged, this, &Recovery::warn);
    tell();
    watch_ = Watch::get();
    const std::lock_guard guard(watch_->lock);
    watch_->all.push_back(this);
}

Recovery::~Recovery()
{
    {
        const std::lock_guard guard(watch_->lock);
        std::erase(watch_->all, this);
    }
    watch_.reset();
    journal_.discard();
    discardRecovered();
}

void Recovery::tell()
{
    const Files& files = window_.files();
    const auto inHand = window_.canvas().pendingObject();
    journal_.setOrigin({files.origin(), files.sample()});
    journal_.setInHand(inHand);
    work_.tell(
        {file_, files.origin(), files.sample(), !window_.session().history.isClean(), inHand});
    warn();
}

void Recovery::warn()
{
    const QString why = journal_.whyIncomplete();
    window_.warn(!why.isEmpty() && work_.unsaved() ? why : QString());
}

/// Discards the leftover when its drawing is saved or replaced by another.
void Recovery::forgetRecovered()
{
    if (window_.session().history.isClean())
        discardRecovered();
}

void Recovery::discardRecovered()
{
    if (recovered_ && damaged_)
        app::setAside(*recovered_);
    else if (recovered_)
        app::discard(*recovered_);
    recovered_.reset();
}

// Runs on the watch's thread while the other threads continue.
void Recovery::keep(int signal) const
{
    const auto say = [signal](const QString& sentence) {
        std::fprintf(stderr, "clearcut: %s. %s\n", strsignal(signal), qPrintable(sentence));
    };
    try {
        const auto written =
            journal_.complete() ? app::UnsavedWork::Written{work_.unsaved()} : work_.write();
        if (written.error)
            say(Text::tr("The unsaved drawing is lost: %1").arg(*written.error));
        else if (written.unsaved)
            say(Text::tr("The unsaved drawing is kept; the next start offers to recover it."));
    } catch (const std::exception&) { // std::bad_alloc
        say(Text::tr("The unsaved drawing is lost: there was not enough memory to write it."));
    }
}

void Recovery::offer()
{
    window_.files().whenIdle([self = QPointer(this)] {
        if (self)
            self->ask(app::claimLeftovers(self->folder_));
    });
}

void Recovery::ask(std::vector<app::Leftover> found)
{
    if (found.empty())
        return;
    app::Leftover first = found.front();
    found.erase(found.begin());
    using Verb = Questions::Leftover;
    const auto follow = [self = QPointer(this), first, found](Verb verb) mutable {
        if (!self || verb == Verb::Later)
            return;
        if (verb == Verb::Discard) {
            app::discard(first);
            return self->ask(std::move(found));
        }
        Recovery& there = self->place_ ? self->place_(first.origin.path) : *self;
        there.recover(first, [there = QPointer(&there), found](bool recovered) {
            if (there && (!recovered || there->place_)) // there is a window for the next one
                there->ask(found);
        });
    };
    window_.files().questions().aboutLeftover(first, found.size(), follow);
}

/// Replaces the drawing in the window, unless the person keeps it or the leftover is unreadable.
void Recovery::recover(const app::Leftover& chosen, const std::function<void(bool)>& ended)
{
    using End = Files::Recovered;
    const auto end = [=, self = QPointer(this)](End recovered) {
        if (!self)
            return;
        if (recovered == End::NotAtAll)
            return ended(false);
        self->recovered_ = chosen;
        self->damaged_ = recovered == End::Partly;
        if (self->journal_.ready()) // it has its own copy
            self->discardRecovered();
        self->tell();
        ended(true);
    };
    window_.files().mayClose([=, self = QPointer(this)](bool mayReplace) {
        if (self && mayReplace)
            self->window_.files().recover(chosen, end);
        else
            end(End::NotAtAll);
    });
}

} // namespace ui

#include "moc_recovery.cpp"
