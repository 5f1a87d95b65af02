using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>Finds what is wrong with the dialect of the links and with the subscriptions to its messages.</summary>
internal static class SubscriptionCheck
{
    private const string HowToCombine = "MavlinkDialect.Combine puts dialects together";

    public static IEnumerable<string> FindFaults(
        MavlinkDialect? dialect, IReadOnlyList<MavlinkSubscription?>? subscriptions)
    {
        if (dialect is null)
            return [$"{nameof(CommunicationsOptions.Dialect)} is null"];
        if (subscriptions is null || subscriptions.Contains(null))
            return [$"{nameof(CommunicationsOptions.Subscriptions)}, or one of them, is null; the list may be empty"];
        return FindFaults(dialect).Concat(FindFaultsOfQueues(subscriptions!))
            .Concat(subscriptions.SelectMany(s => FindFaults(s!, dialect)));
    }

    // What the managers decode by its id must mean the same on the links.
    private static IEnumerable<string> FindFaults(MavlinkDialect dialect)
    {
        if (ReferenceEquals(dialect, MavlinkDialect.All))
            yield break;
        List<MavlinkMessageInfo> missing = MavlinkDialect.Common.Messages
            .Where(m => !dialect.TryGetMessage(m.Id, out _)).OrderBy(m => m.Id).ToList();
        if (missing.Count > 0)
        {
            yield return $"dialect '{dialect.Name}' lacks {missing[0].Name}"
                + (missing.Count > 1 ? $" and {missing.Count - 1} more messages" : string.Empty)
                + $" of common.xml, which the managers use; {HowToCombine}";
        }

        MavlinkDialect.All.TryGetMessage(Wind.MavlinkId, out MavlinkMessageInfo wind);
        foreach (MavlinkMessageInfo ours in MavlinkDialect.Common.Messages.Append(wind))
        {
            if (dialect.TryGetMessage(ours.Id, out MavlinkMessageInfo other) && other.CrcExtra != ours.CrcExtra)
            {
                yield return $"dialect '{dialect.Name}' has {other.Name} (checksum byte {other.CrcExtra}) as message "
                    + $"{ours.Id}, which the managers use as {ours.Name} (checksum byte {ours.CrcExtra})";
            }
        }
    }

    private static IEnumerable<string> FindFaultsOfQueues(IReadOnlyList<MavlinkSubscription> subscriptions)
    {
        foreach (IGrouping<string, MavlinkSubscription> same
            in subscriptions.GroupBy(s => s.Queue, StringComparer.Ordinal))
        {
            if (same.Count() > 1)
                yield return $"{same.Count()} subscriptions have queue '{same.Key}'; each needs a queue of its own";
            if (string.Equals(same.Key, MessageNames.AutopilotFrames, StringComparison.Ordinal))
                yield return $"a subscription has queue '{same.Key}', which is that of Autopilot Interface";
        }
    }

    private static IEnumerable<string> FindFaults(MavlinkSubscription subscription, MavlinkDialect dialect)
    {
        string name = $"the subscription of queue '{subscription.Queue}'";
        if (subscription.ComponentId == 0)
            yield return $"{name} is for component 0, which means every component; it must be 1 to 255, or null for "
                + "our own";
        if (subscription.MessageIds is null)
        {
            yield return $"{name} has null as {nameof(MavlinkSubscription.MessageIds)}; none means all";
            yield break;
        }

        foreach (IGrouping<int, int> id in subscription.MessageIds.GroupBy(i => i))
        {
            if (!dialect.TryGetMessage(id.Key, out _))
                yield return $"{name} has message {id.Key}, which dialect '{dialect.Name}' does not have, so that "
                    + $"nothing could check it; {HowToCombine}";
            if (id.Count() > 1)
                yield return $"{name} has message {id.Key} more than once";
        }
    }
}
