using System;
using System.Globalization;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>What is remembered of one link between two looks.</summary>
internal sealed class LinkWatch(int number, MessageSubscriber<LinkStatus> status)
{
    private readonly string _number = number.ToString(CultureInfo.InvariantCulture);
    private readonly RecentRise _dropped = new();

    public LinkFacts Look(TimeSpan now, TimeSpan watchedSince, HealthOptions options)
    {
        status.Fetch();
        ref readonly LinkStatus value = ref status.Value;
        bool drops = _dropped.Take(value.FramesDroppedIn + value.FramesDroppedOut, now, options.RememberedFor);
        return new LinkFacts(value.Url ?? _number, value, drops, now - watchedSince);
    }
}
