using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Managers;
using Rabit.Core.Messaging;

namespace Rabit.Core.Workspaces;

/// <summary>Finds everything that does not fit together, before any thread starts.</summary>
internal static class WiringCheck
{
    // All places of a queue are there from the start. More than this is a slip, or a wish for a queue without an end.
    private const int LargestQueue = 1 << 24;

    public static IReadOnlyList<string> FindFaults(Wiring wiring, RabitTime time)
    {
        var faults = new List<string>();
        if (wiring.Managers.Count == 0)
            faults.Add("The reactor has no manager.");
        faults.AddRange(wiring.Managers
            .GroupBy(m => m.Name, StringComparer.Ordinal)
            .Where(g => g.Count() > 1)
            .Select(g => $"{g.Count()} managers are named '{g.Key}'."));

        foreach (IReadOnlyList<EndDeclaration> ends in wiring.Messages.Values)
            CheckMessage(ends, faults);
        foreach (IReadOnlyList<EndDeclaration> ends in wiring.Queues.Values)
            CheckQueue(ends, faults);

        if (time is VirtualTime modelled)
        {
            faults.AddRange(modelled.ModelledManagers
                .Where(name => !wiring.Managers.Any(m => string.Equals(m.Name, name, StringComparison.Ordinal)))
                .Select(name => $"Virtual time models the units of work of manager '{name}', which is not in the reactor."));
        }

        if (!time.AllowsBlocking)
        {
            faults.AddRange(wiring.Managers
                .SelectMany(m => m.Readers.Concat(m.Writers))
                .Where(d => d.Blocks)
                .Select(d => $"'{d.Name}' uses a device that blocks: virtual time needs a scripted or simulated one."));
        }

        return faults;
    }

    private static void CheckMessage(IReadOnlyList<EndDeclaration> ends, List<string> faults)
    {
        string name = ends[0].Name;
        if (!HaveOneType(ends, $"Message '{name}'", faults))
            return;

        List<EndDeclaration> publishers = ends.Where(e => e.Role == EndRole.Publish).ToList();
        if (publishers.Count == 0)
        {
            faults.AddRange(ends
                .Where(e => !e.IsOptional)
                .Select(e => $"'{e.Owner.Name}' subscribes to message '{name}', but nobody publishes it."));
        }

        if (publishers.Count > 1 && !publishers.All(p => p.IsShared))
            faults.Add($"Message '{name}' has {publishers.Count} publishers ({Owners(publishers)}); all of them must allow others.");
        if (publishers.Count(p => p.StatesInitial) > 1 && !publishers.All(p => p.IsShared))
            faults.Add($"Message '{name}': more than one end states the first value.");

        if (MessageTypeCheck.FindFault(ends[0].ValueType) is { } why)
            faults.Add($"Message '{name}': {why}");
        else if (!ends[0].ValueType.IsValueType && !ends.Any(e => e.StatesInitial) && publishers.Count > 0)
            faults.Add($"Message '{name}': {TypeNames.Of(ends[0].ValueType)} is a class, so its publisher ({Owners(publishers)}) must state a first value.");
    }

    private static void CheckQueue(IReadOnlyList<EndDeclaration> ends, List<string> faults)
    {
        string name = ends[0].Name;
        if (!HaveOneType(ends, $"Queue '{name}'", faults))
            return;

        List<EndDeclaration> receivers = ends.Where(e => e.Role == EndRole.Receive).ToList();
        List<EndDeclaration> senders = ends.Where(e => e.Role == EndRole.Send).ToList();
        if (receivers.Count == 0)
            faults.Add($"Queue '{name}' has no receiver, but {Owners(senders)} sends to it.");
        if (receivers.Count > 1)
            faults.Add($"Queue '{name}' has {receivers.Count} receivers ({Owners(receivers)}); it can have one.");

        foreach (EndDeclaration receiver in receivers)
        {
            var queue = (IQueueDeclaration)receiver;
            if (queue.Capacity < 1)
                faults.Add($"Queue '{name}' of '{receiver.Owner.Name}' has capacity {queue.Capacity}; it needs at least 1.");
            if (queue.Capacity > LargestQueue)
                faults.Add($"Queue '{name}' of '{receiver.Owner.Name}' has capacity {queue.Capacity}; it can have {LargestQueue}.");
            if (queue.FullMode is < QueueFullMode.Reject or > QueueFullMode.Wait)
                faults.Add($"Queue '{name}' of '{receiver.Owner.Name}' has an unknown rule for a full queue: {(int)queue.FullMode}.");
            if (queue.FullMode != QueueFullMode.Wait)
                continue;
            faults.AddRange(senders
                .Where(s => s.Owner.IsManager || s.Owner.WakeUp is null)
                .Select(s => $"Queue '{name}' makes its senders wait when it is full; only readers may wait, and '{s.Owner.Name}' is none."));
        }
    }

    private static bool HaveOneType(IReadOnlyList<EndDeclaration> ends, string what, List<string> faults)
    {
        List<IGrouping<Type, EndDeclaration>> types = ends.GroupBy(e => e.ValueType).ToList();
        if (types.Count == 1)
            return true;
        faults.Add($"{what} has {types.Count} types: " + string.Join("; ", types.Select(t => $"{TypeNames.Of(t.Key)} for {Owners(t)}")) + ".");
        return false;
    }

    private static string Owners(IEnumerable<EndDeclaration> ends)
        => string.Join(", ", ends.Select(e => $"'{e.Owner.Name}'").Distinct(StringComparer.Ordinal));
}
