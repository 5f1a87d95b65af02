using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav.Communications;

namespace Rabit.Uav;

/// <summary>Finds what is wrong with the links of a system, and with their signing.</summary>
internal static class UavLinkCheck
{
    public static IReadOnlyList<T> Usable<T>(IReadOnlyList<T>? links)
        where T : class
        => (links ?? []).Where(l => l is not null).ToArray();

    /// <summary>What is missing or null; the other checks get those that <see cref="Usable"/> gives.</summary>
    public static IEnumerable<string> FindNulls(UavOptions given)
    {
        bool isNone = (given.Links?.Count ?? 0) + (given.OpenLinks?.Count ?? 0) == 0;
        if (isNone && given.Has(UavManagers.Communications))
            yield return "A UAV needs at least one link";
        else if (given.Links is null)
            yield return $"{nameof(given.Links)} is null; it may be empty";
        else if (given.OpenLinks is null)
            yield return $"{nameof(given.OpenLinks)} is null; it may be empty";
        if (given.Links?.Contains(null!) == true || given.OpenLinks?.Contains(null!) == true)
            yield return "A link is null";
    }

    public static IEnumerable<string> FindFaults(UavOptions options)
        => FindFaultsOfLists(options).Concat(FindFaultsOfPace(options)).Concat(FindFaultsOfSigning(options));

    private static IEnumerable<string> FindFaultsOfLists(UavOptions options)
    {
        int links = options.Links.Count + options.OpenLinks.Count;
        if (links > MavlinkRouter.MaxLinks)
            yield return $"there are {links} links; at most {MavlinkRouter.MaxLinks} are possible";
        foreach (IGrouping<string, LinkUrl> same
            in options.Links.GroupBy(l => l.Address, StringComparer.Ordinal).Where(g => g.Count() > 1))
            yield return $"link {same.Key} is given {same.Count()} times";

        // Two readers would take each other's bytes. Links of one name may be several.
        foreach (IByteLink twice in options.OpenLinks.Where((l, i) => options.OpenLinks.Take(i).Contains(l)).Distinct())
            yield return $"{nameof(options.OpenLinks)} has link {twice.Url} more than once, the same object";
    }

    private static IEnumerable<string> FindFaultsOfPace(UavOptions options)
    {
        LinkUrl? fast = options.Links.FirstOrDefault(l => !l.Speed.Equals(1));
        LinkUrl? other = fast is null
            ? null
            : options.Links.FirstOrDefault(l => l.Kind != LinkKind.RecordedFile || !l.Speed.Equals(fast.Speed));
        if (other is not null)
            yield return $"{fast} plays at another pace than {other}; a log at another speed than 1 goes with logs of "
                + "the same speed only";
        if (fast is not null && (options.OpenLinks.Count > 0 || options.Time is not null))
            yield return $"{fast} plays at a pace of its own, which does not go with other links or another time";
    }

    private static IEnumerable<string> FindFaultsOfSigning(UavOptions options)
    {
        if (ManagerOptions.SigningOf(options) is not { } signing)
            return [];
        if (options.IsReplay)
            return ["there is nothing to sign in a replay"];
        return signing.FindFaults(
            options.OpenLinks.Count + options.Links.Count(l => l.Kind != LinkKind.RecordedFile));
    }
}
