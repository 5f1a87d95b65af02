using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Naming;

/// <summary>
/// Names of the members of an enum: what all have in common is left out.
/// <list type="number">
/// <item>Where every entry begins with the words of the enum's name, these are dropped and nothing else:
/// <c>MAV_TYPE_GCS</c> is <c>MavType.Gcs</c>, and no entry that another file adds can change that.</item>
/// <item>Otherwise each entry drops the words in front that all entries share or those that it shares with the enum's
/// name, whichever are more: <c>MAV_COMP_ID_GPS</c> of MAV_COMPONENT is <c>Gps</c>, <c>EKF_ATTITUDE</c> of
/// EKF_STATUS_FLAGS is <c>Attitude</c>.</item>
/// <item>At least one word stays, and a rest that begins with a digit keeps the word before it:
/// <c>GPS_FIX_TYPE_3D_FIX</c> is <c>Type3dFix</c>.</item>
/// <item>Entries that would come out the same keep all their words.</item>
/// </list>
/// </summary>
internal static class EntryNames
{
    /// <summary>The C# name of each entry, by its name in the definition.</summary>
    public static IReadOnlyDictionary<string, string> Of(EnumDefinition definition)
    {
        string[] own = PascalCase.Words(definition.Name);
        List<string[]> all = definition.Entries.Select(entry => PascalCase.Words(entry.Name)).ToList();
        int common = Common(own, all);
        var names = definition.Entries.ToDictionary(
            entry => entry.Name, entry => Shorten(PascalCase.Words(entry.Name), own, common), StringComparer.Ordinal);

        IEnumerable<string> clashes = names.GroupBy(pair => pair.Value, StringComparer.Ordinal)
            .Where(group => group.Count() > 1).SelectMany(group => group.Select(pair => pair.Key)).ToList();
        foreach (string clash in clashes)
            names[clash] = PascalCase.Of(clash);
        return names;
    }

    private static int Common(string[] own, List<string[]> all)
    {
        if (all.Count == 0 || all.All(words => Shared(words, own) == own.Length && words.Length > own.Length))
            return own.Length;
        return all.Count == 1 ? 0 : all.Min(words => Shared(words, all[0]));
    }

    private static string Shorten(string[] words, string[] own, int common)
    {
        int drop = Math.Min(Math.Max(common, Shared(words, own)), words.Length - 1);
        while (drop > 0 && char.IsDigit(words[drop][0]))
            drop--;
        return PascalCase.Join(words.Skip(Math.Max(drop, 0)).ToArray());
    }

    private static int Shared(string[] left, string[] right)
    {
        int count = 0;
        while (count < left.Length && count < right.Length
            && string.Equals(left[count], right[count], StringComparison.OrdinalIgnoreCase))
            count++;
        return count;
    }
}
