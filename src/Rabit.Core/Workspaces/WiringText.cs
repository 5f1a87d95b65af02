using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Rabit.Core.Messaging;

namespace Rabit.Core.Workspaces;

/// <summary>Writes a wiring as text, for people.</summary>
internal static class WiringText
{
    public static string Describe(Wiring wiring)
    {
        var text = new StringBuilder();
        Line(text, "managers, in the order of their start");
        foreach (RabitManager manager in wiring.Managers)
            Line(text, $"  {manager.Name}");

        foreach (IReadOnlyList<EndDeclaration> ends in wiring.Messages.Values.Where(e => !IsUnreadStatus(e)))
        {
            Line(text, $"message {ends[0].Name} : {TypeNames.Of(ends[0].ValueType)}");
            Line(text, "  posted by ", ends.Where(e => e.Role == EndRole.Publish));
            Line(text, "  fetched by ", ends.Where(e => e.Role == EndRole.Subscribe));
        }

        foreach (IReadOnlyList<EndDeclaration> ends in wiring.Queues.Values)
        {
            var receiver = (IQueueDeclaration)ends.First(e => e.Role == EndRole.Receive);
            string capacity = receiver.Capacity.ToString(CultureInfo.InvariantCulture);
            Line(text, $"queue {ends[0].Name} : {TypeNames.Of(ends[0].ValueType)}, {capacity} at most, when full {receiver.FullMode}");
            Line(text, "  pushed by ", ends.Where(e => e.Role == EndRole.Send));
            Line(text, "  popped by ", ends.Where(e => e.Role == EndRole.Receive));
        }

        foreach (string note in Notes(wiring))
            Line(text, "note: " + note);
        return text.ToString();
    }

    public static IEnumerable<string> Notes(Wiring wiring)
    {
        foreach (IReadOnlyList<EndDeclaration> ends in wiring.Messages.Values.Where(e => !IsUnreadStatus(e)))
        {
            if (ends.All(e => e.Role == EndRole.Publish))
                yield return $"nobody fetches message '{ends[0].Name}' of '{ends[0].Owner.Name}'";
            if (ends.All(e => e.Role == EndRole.Subscribe))
                yield return $"nobody publishes message '{ends[0].Name}'; it is optional for all who fetch it";
        }

        foreach (IReadOnlyList<EndDeclaration> ends in wiring.Queues.Values.Where(q => q.All(e => e.Role == EndRole.Receive)))
            yield return $"nobody pushes into queue '{ends[0].Name}' of '{ends[0].Owner.Name}'";
    }

    private static bool IsUnreadStatus(IReadOnlyList<EndDeclaration> ends) => ends.All(e => e.IsBuiltIn);

    private static void Line(StringBuilder text, string words) => text.Append(words).Append('\n');

    private static void Line(StringBuilder text, string words, IEnumerable<EndDeclaration> ends)
    {
        string names = string.Join(", ", ends.Select(e => e.Owner.Name + (e.Wakes ? " (wakes)" : string.Empty)));
        Line(text, words + (names.Length == 0 ? "nobody" : names));
    }
}
