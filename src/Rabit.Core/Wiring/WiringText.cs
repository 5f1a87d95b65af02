using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Rabit.Core.Locks;
using Rabit.Core.Queues;

namespace Rabit.Core.Wiring;

/// <summary>Writes a wiring as text, for people.</summary>
internal static class WiringText
{
    public static string Describe(WiringGraph wiring)
    {
        var text = new StringBuilder();
        Line(text, "managers, in the order of their start");
        foreach (RabitManager manager in wiring.Managers)
            Line(text, $"  {manager.Name}");

        foreach (IReadOnlyList<EndpointDeclaration> endpoints in wiring.Messages.Values.Where(e => !IsUnreadStatus(e)))
        {
            Line(text, $"message {endpoints[0].Name} : {TypeNames.Of(endpoints[0].ValueType)}");
            Line(text, "  posted by ", endpoints.Where(e => e.Role == EndpointRole.Publish));
            Line(text, "  fetched by ", endpoints.Where(e => e.Role == EndpointRole.Subscribe));
        }

        foreach (IReadOnlyList<EndpointDeclaration> endpoints in wiring.Queues.Values)
        {
            var receiver = (IQueueDeclaration)endpoints.First(e => e.Role == EndpointRole.Receive);
            string capacity = receiver.Capacity.ToString(CultureInfo.InvariantCulture);
            Line(text, $"queue {endpoints[0].Name} : {TypeNames.Of(endpoints[0].ValueType)}, {capacity} at most, when "
                + $"full {receiver.FullMode}");
            Line(text, "  pushed by ", endpoints.Where(e => e.Role == EndpointRole.Send));
            Line(text, "  popped by ", endpoints.Where(e => e.Role == EndpointRole.Receive));
        }

        foreach (string note in Notes(wiring))
            Line(text, "note: " + note);
        return text.ToString();
    }

    public static IEnumerable<string> Notes(WiringGraph wiring)
    {
        foreach (IReadOnlyList<EndpointDeclaration> endpoints in wiring.Messages.Values.Where(e => !IsUnreadStatus(e)))
        {
            if (endpoints.All(e => e.Role == EndpointRole.Publish))
                yield return $"no subscriber for message '{endpoints[0].Name}' of '{endpoints[0].Owner.Name}'";
            if (endpoints.All(e => e.Role == EndpointRole.Subscribe))
                yield return $"no publisher for message '{endpoints[0].Name}'; it is optional for all its subscribers";
        }

        foreach (IReadOnlyList<EndpointDeclaration> endpoints
            in wiring.Queues.Values.Where(q => q.All(e => e.Role == EndpointRole.Receive)))
            yield return $"no sender for queue '{endpoints[0].Name}' of '{endpoints[0].Owner.Name}'";

        foreach (IReadOnlyList<EndpointDeclaration> endpoints in wiring.Queues.Values)
        {
            foreach (string note in NotesOfLock(endpoints))
                yield return note;
        }

        foreach (string note in wiring.Notes)
            yield return note;
    }

    // The managers of a real-time priority that may find a queue locked by another.
    private static IEnumerable<string> NotesOfLock(IReadOnlyList<EndpointDeclaration> endpoints)
    {
        EndpointOwner[] owners = [.. endpoints.Select(e => e.Owner).Distinct()];
        var queue = (IQueueDeclaration)endpoints.First(e => e.Role == EndpointRole.Receive);
        if (owners.Length == 1 || !queue.NeedsLock(endpoints))
            return [];
        string forHowLong = PriorityInheritanceMutex.IsThere
            ? "for as long as others take to copy what is ahead; who holds the lock has that priority meanwhile"
            : "for as long as threads of priorities in between run: this system has no lock that passes a priority on";
        return owners.Where(o => o.HasPriority).Select(
            o => $"manager '{o.Name}' of a real-time priority may wait for the lock of queue '{endpoints[0].Name}', "
                + forHowLong);
    }

    private static bool IsUnreadStatus(IReadOnlyList<EndpointDeclaration> endpoints) => endpoints.All(e => e.IsBuiltIn);

    private static void Line(StringBuilder text, string words) => text.Append(words).Append('\n');

    private static void Line(StringBuilder text, string words, IEnumerable<EndpointDeclaration> endpoints)
    {
        string names = string.Join(", ", endpoints.Select(e => e.Owner.Name + (e.Wakes ? " (wakes)" : string.Empty)));
        Line(text, words + (names.Length == 0 ? "none" : names));
    }
}
