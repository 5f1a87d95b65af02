using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Tests.Shared;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Writes docs/search-planning.md, where RABIT_UPDATE_DOCS=1 asks for it.</summary>
internal static class SearchPlanningDocument
{
    private const string Introduction =
        """
        # Search planning: figures

        The planned way over the 40 areas of tests/data/autonomy/search-areas.json, from the start of the first leg to the end of the last; what a picture shows is as wide as the sweep. The bound is area
        over sweep, of a sliver also its length but for a sweep: no way is shorter. Why area 11, a comb, and area 27, a wedge, need more is explained in
        [decision 26](decisions/0026-search-planning.md). 4000 samples of each area are within half a sweep of the way; no part of the way is outside the area or nearer to a hole than 10 m.

        `RABIT_UPDATE_DOCS=1 dotnet test -s tests/long.runsettings -c Release tests/Rabit.Uav.Tests --filter FullyQualifiedName~Plan_AllAreas` plans them and writes this page.

        """;

    public static void Update(IReadOnlyList<PlannedArea> areas)
    {
        if (Environment.GetEnvironmentVariable("RABIT_UPDATE_DOCS") != "1")
            return;
        var text = new StringBuilder(Introduction.Replace("\r\n", "\n"));
        text.Append("\n| kind | areas | way over bound, mean | largest |\n|---|---|---|---|\n");
        foreach (IGrouping<string, PlannedArea> kind in areas.GroupBy(a => a.Kind))
        {
            text.Append(FormattableString.Invariant(
                $"| {kind.Key} | {kind.Count()} | {kind.Average(a => a.Ratio):0.000} | {kind.Max(a => a.Ratio):0.000} |\n"));
        }

        text.Append("\n| area | kind | area / sweep2 | way m | over bound | corners |\n|---|---|---|---|---|---|\n");
        foreach (PlannedArea a in areas)
        {
            text.Append(FormattableString.Invariant(
                $"| {a.Id} | {a.Kind} | {a.Outer.Area / a.Sweep / a.Sweep:0} | {a.Way!.Length:0} | {a.Ratio:0.000} | {a.Way.Corners.Count} |\n"));
        }

        File.WriteAllText(Path.Combine(Repository.Root, "docs", "search-planning.md"), text.ToString());
    }
}
