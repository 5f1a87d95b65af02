using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Messages;
using Rabit.Core.Queues;

namespace Rabit.Core.Wiring;

/// <summary>Finds everything that does not fit together, before any thread starts.</summary>
internal static class WiringCheck
{
    // All places of a queue are there from the start. More than this is a mistake, or a wish for an unbounded queue.
    private const int MaxCapacity = 1 << 24;

    public static List<string> FindFaults(
        WiringGraph wiring, RabitTime time, IReadOnlyCollection<Type> trusted, IReadOnlyList<AbsentManager> absent)
    {
        var faults = new List<string>();
        if (wiring.Managers.Count == 0)
            faults.Add("The reactor has no manager.");
        faults.AddRange(wiring.Managers
            .GroupBy(m => m.Name, StringComparer.Ordinal)
            .Where(g => g.Count() > 1)
            .Select(g => $"{g.Count()} managers are named '{g.Key}'."));

        // What is wrong with a type is looked up once: each manager has a message of the same type, its status.
        var faultsOfTypes = new Dictionary<Type, string?>();
        foreach (IReadOnlyList<EndpointDeclaration> endpoints in wiring.Messages.Values)
            CheckMessage(wiring, endpoints, FaultOfType, absent, faults);
        foreach (IReadOnlyList<EndpointDeclaration> endpoints in wiring.Queues.Values)
            CheckQueue(wiring, endpoints, absent, faults);

        if (time is VirtualTime modelled)
        {
            faults.AddRange(modelled.ModelledManagers
                .Where(name => !wiring.Managers.Any(m => string.Equals(m.Name, name, StringComparison.Ordinal)))
                .Select(name => $"Virtual time models the units of work of manager '{name}', "
                    + "which is not in the reactor."
                    + NameSuggestion.For(name, wiring.Managers.Select(m => m.Name), [], string.Empty)));
        }

        if (!time.AllowsBlocking)
        {
            faults.AddRange(wiring.Managers
                .SelectMany(m => m.Readers.Concat(m.Writers))
                .Where(d => d.Blocks)
                .Select(d => $"'{d.Name}' uses a device that blocks: virtual time needs a scripted or simulated one."));
        }

        return faults;

        string? FaultOfType(EndpointDeclaration endpoint)
        {
            if (!faultsOfTypes.TryGetValue(endpoint.ValueType, out string? fault))
            {
                fault = MessageTypeCheck.FindFault(endpoint.ValueType, endpoint.CopiesItself, trusted);
                faultsOfTypes.Add(endpoint.ValueType, fault);
            }

            return fault;
        }
    }

    /// <summary>Queues whose values sender and receiver could share and change; a line each.</summary>
    public static List<string> FindSharedValues(WiringGraph wiring, IReadOnlyCollection<Type> trusted)
    {
        var found = new List<string>();
        foreach (IReadOnlyList<EndpointDeclaration> endpoints in wiring.Queues.Values)
        {
            if (MessageTypeCheck.FindFaultInQueue(endpoints[0].ValueType, trusted) is { } why)
                found.Add($"queue '{endpoints[0].Name}': {why} Its sender must not touch what it has pushed: see "
                    + $"{nameof(HandedOverAttribute)}.");
        }

        return found;
    }

    private static void CheckMessage(
        WiringGraph wiring, IReadOnlyList<EndpointDeclaration> endpoints,
        Func<EndpointDeclaration, string?> faultOfType, IReadOnlyList<AbsentManager> absent, List<string> faults)
    {
        string name = endpoints[0].Name;
        if (!HaveOneType(endpoints, $"Message '{name}'", faults))
            return;

        List<EndpointDeclaration> publishers = endpoints.Where(e => e.Role == EndpointRole.Publish).ToList();
        List<EndpointDeclaration> needing = endpoints.Where(e => !e.IsOptional).ToList();
        if (publishers.Count == 0 && needing.Count > 0)
            faults.Add($"{Verb(needing, "subscribes", "subscribe")} to message '{name}', but it has no publisher"
                + AbsenceText.OfPublisher(absent, name)
                + NameSuggestion.For(name, Published(wiring), wiring.Queues.Keys, "queue"));

        if (publishers.Find(p => !p.IsBuiltIn) is { } own && RabitManager.IsStatusMessageName(name))
            faults.Add($"'{own.Owner.Name}' publishes '{name}', but names like this one are those of the status of a "
                + "manager.");
        else if (publishers.Count > 1 && !publishers.All(p => p.IsShared || p.IsBuiltIn))
            faults.Add($"Message '{name}' has {publishers.Count} publishers ({Owners(publishers)}); "
                + "all of them must allow others.");
        if (publishers.Count(p => p.StatesInitial) > 1 && !publishers.All(p => p.IsShared))
            faults.Add($"Message '{name}': more than one endpoint states the first value.");

        if (faultOfType(endpoints[0]) is { } why)
            faults.Add($"Message '{name}': {why}");
        else if (!endpoints[0].ValueType.IsValueType && !endpoints.Any(e => e.StatesInitial) && publishers.Count > 0)
            faults.Add($"Message '{name}': {TypeNames.Of(endpoints[0].ValueType)} is a class, so its publisher "
                + $"({Owners(publishers)}) must state a first value.");
        else
            faults.AddRange(
                endpoints.Select(e => e.FindFaultOfInitial()).OfType<string>().Select(f => $"Message '{name}': {f}"));
    }

    private static IEnumerable<string> Published(WiringGraph wiring)
        => wiring.Messages.Values.Where(m => m.Any(e => e.Role == EndpointRole.Publish)).Select(m => m[0].Name);

    private static IEnumerable<string> Received(WiringGraph wiring)
        => wiring.Queues.Values.Where(q => q.Any(e => e.Role == EndpointRole.Receive)).Select(q => q[0].Name);

    private static void CheckQueue(
        WiringGraph wiring, IReadOnlyList<EndpointDeclaration> endpoints, IReadOnlyList<AbsentManager> absent,
        List<string> faults)
    {
        string name = endpoints[0].Name;
        if (!HaveOneType(endpoints, $"Queue '{name}'", faults))
            return;

        List<EndpointDeclaration> receivers = endpoints.Where(e => e.Role == EndpointRole.Receive).ToList();
        List<EndpointDeclaration> senders = endpoints.Where(e => e.Role == EndpointRole.Send).ToList();
        if (receivers.Count == 0)
            faults.Add($"Queue '{name}' has no receiver, but {Verb(senders, "sends", "send")} to it"
                + AbsenceText.OfReceiver(absent, name)
                + NameSuggestion.For(name, Received(wiring), wiring.Messages.Keys, "message"));
        if (senders.Count == 0 && AbsenceText.OfSender(absent, name) is { } why)
            faults.Add($"Queue '{name}' has no sender, but {Verb(receivers, "receives", "receive")} it{why}");
        if (receivers.Count > 1)
            faults.Add($"Queue '{name}' has {receivers.Count} receivers ({Owners(receivers)}); it can have one.");

        foreach (EndpointDeclaration receiver in receivers)
        {
            var queue = (IQueueDeclaration)receiver;
            string what = $"Queue '{name}' of '{receiver.Owner.Name}'";
            if (queue.Capacity < 1)
                faults.Add($"{what} has capacity {queue.Capacity}; it needs at least 1.");
            if (queue.Capacity > MaxCapacity)
                faults.Add($"{what} has capacity {queue.Capacity}; it can have {MaxCapacity}.");
            if (queue.FullMode is < QueueFullMode.Reject or > QueueFullMode.Wait)
                faults.Add($"{what} has an unknown rule for a full queue: {(int)queue.FullMode}.");
            if (queue.MaxWait <= TimeSpan.Zero)
                faults.Add($"{what} lets a push wait for {queue.MaxWait}; it needs a time above zero.");
            if (queue.MaxWait is not null && queue.FullMode != QueueFullMode.Wait)
                faults.Add($"{what} says how long a push may wait, but by its rule ({queue.FullMode}) none does.");
            if (queue.FullMode != QueueFullMode.Wait)
                continue;
            faults.AddRange(senders
                .Where(s => s.Owner.IsManager)
                .Select(s => $"Queue '{name}' makes its senders wait when it is full; "
                    + $"a manager never waits, and '{s.Owner.Name}' is one."));
        }
    }

    private static bool HaveOneType(IReadOnlyList<EndpointDeclaration> endpoints, string what, List<string> faults)
    {
        List<IGrouping<Type, EndpointDeclaration>> types = endpoints.GroupBy(e => e.ValueType).ToList();
        if (types.Count == 1)
            return true;
        IReadOnlyList<string> names = TypeNames.Of(types.ConvertAll(t => t.Key));
        faults.Add(
            $"{what} has {types.Count} types: "
                + string.Join("; ", types.Select((t, i) => $"{names[i]} for {Owners(t)}")) + ".");
        return false;
    }

    private static string Verb(IReadOnlyList<EndpointDeclaration> endpoints, string one, string several)
    {
        string owners = Owners(endpoints);
        return owners == Owners(endpoints.Take(1)) ? $"{owners} {one}" : $"{owners} {several}";
    }

    private static string Owners(IEnumerable<EndpointDeclaration> endpoints)
        => string.Join(", ", endpoints.Select(e => $"'{e.Owner.Name}'").Distinct(StringComparer.Ordinal));
}
