// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace app {

/// The steps of one thread of `inTurn`. They share what they have taken.
struct TurnSteps {
    std::function<bool()> take; ///< takes the next share of the input; false at its end
    std::function<void()> work; ///< works on it, at the same time as other threads
    std::function<bool()> give; ///< gives the result away; false: no more is wanted
};

/// Runs one thread for each of `threads`, the first one on the calling thread, or fewer if the
/// system allows no more. Only one thread takes at a time, and they give in the order in which they
/// have taken. A thread that waits in `take` does not keep others from giving. Returns at the end
/// of the input, or once no more is wanted. After the first exception of a share nothing is given
/// any more, and it is thrown again; what was taken before it has been given.
class InTurn {
public:
    /// `stopTaking` is called at most once, on any thread, when nothing will be given any more. It
    /// ends the wait of a `take` for input, and the waits of later ones.
    void run(const std::vector<TurnSteps>& threads, const std::function<void()>& stopTaking = {})
    {
        stopTaking_ = stopTaking;
        {
            std::vector<std::jthread> others;
            try {
                for (std::size_t i = 1; i < threads.size(); ++i)
                    others.emplace_back([this, &steps = threads[i]] { follow(steps); });
            } catch (const std::system_error&) { // the system allows no more threads
            }
            follow(threads.front());
        }
        if (error_)
            std::rethrow_exception(error_);
    }

private:
    struct Share {
        std::size_t number;
        bool taken;
        std::exception_ptr error{};
    };

    void follow(const TurnSteps& steps)
    {
        for (Share share = take(steps); share.taken; share = take(steps)) {
            if (!share.error)
                share.error = errorOf([&] { steps.work(); });
            give(steps, share);
        }
    }

    template <class Step>
    static std::exception_ptr errorOf(const Step& step)
    {
        try {
            step();
            return nullptr;
        } catch (...) {
            return std::current_exception();
        }
    }

    Share take(const TurnSteps& steps)
    {
        const std::scoped_lock one(taking_);
        Share share{taken_, !ended_ && !stopped_};
        if (!share.taken)
            return share;
        share.error = errorOf([&] { share.taken = steps.take(); });
        ended_ = share.error || !share.taken;
        taken_ += share.taken;
        return share;
    }

    void give(const TurnSteps& steps, const Share& share)
    {
        std::unique_lock one(giving_);
        turn_.wait(one, [&] { return given_ == share.number; });
        if (!stopped_) {
            bool wanted = true;
            error_ = share.error ? share.error : errorOf([&] { wanted = steps.give(); });
            stopped_ = error_ || !wanted;
            if (stopped_ && stopTaking_)
                stopTaking_();
        }
        ++given_;
        turn_.notify_all();
    }

    std::function<void()> stopTaking_;
    std::mutex taking_, giving_;
    std::condition_variable turn_;
    std::size_t taken_ = 0; ///< shares, guarded by taking_
    bool ended_ = false;    ///< guarded by taking_
    std::size_t given_ = 0; ///< guarded by giving_
    std::atomic<bool> stopped_ = false;
    std::exception_ptr error_; ///< guarded by giving_
};

} // namespace app
