using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Core.Wiring;

/// <summary>Ends the sentence on what is missing: with the absent manager that would have had that part.</summary>
internal static class AbsenceText
{
    public static string OfPublisher(IReadOnlyList<AbsentManager> absent, string message)
        => Of(absent, "publish it", a => Has(a.Publishes, message)
            || string.Equals(RabitManager.StatusMessageName(a.Name), message, StringComparison.Ordinal)) ?? ".";

    public static string OfReceiver(IReadOnlyList<AbsentManager> absent, string queue)
        => Of(absent, "receive it", a => Has(a.Receives, queue)) ?? ".";

    /// <returns>Null where no absent manager would send to it: then it may be meant to have no sender yet.</returns>
    public static string? OfSender(IReadOnlyList<AbsentManager> absent, string queue)
        => Of(absent, "send to it", a => Has(a.Sends, queue));

    private static bool Has(IEnumerable<string> names, string name) => names.Contains(name, StringComparer.Ordinal);

    private static string? Of(IReadOnlyList<AbsentManager> absent, string part, Func<AbsentManager, bool> has)
    {
        List<string> found = absent.Where(has).Select(a => $"'{a.Name}', which {a.Reason}").ToList();
        return found.Count == 0 ? null : $": {string.Join(", or ", found)}, would {part}.";
    }
}
