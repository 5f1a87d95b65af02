using System;
using System.Globalization;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>What is remembered of one link between two looks.</summary>
internal sealed class LinkWatch(int number, MessageSubscriber<LinkStatus> status)
{
    private readonly string _number = number.ToString(CultureInfo.InvariantCulture);
    private readonly WindowedIncrease _dropped = new();
    private long _droppedUnheard;

    public LinkFacts Look(TimeSpan now, TimeSpan watchedSince, HealthOptions options)
    {
        status.Fetch();
        ref readonly LinkStatus value = ref status.Value;

        // While nobody was heard on a link there is nobody to lose what we say.
        if (value.State == LinkState.Waiting)
            _droppedUnheard = value.FramesDroppedOut;
        long dropped = value.FramesDroppedIn + value.FramesDroppedOut - _droppedUnheard;
        bool drops = _dropped.Take(dropped, now, options.RememberedFor);
        return new LinkFacts(value.Url ?? _number, value, dropped, drops, now - watchedSince);
    }
}
