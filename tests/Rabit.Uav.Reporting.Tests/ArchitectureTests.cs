using System;
using System.Linq;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>
/// Reporting uses Rabit.Uav and what that uses, nothing else; no manager and no simulation refers to it from below.
/// </summary>
public sealed class ArchitectureTests
{
    [Fact]
    public void Package_References_AreRabitUavAndWhatItUses()
        => Assert.Equal(
            ["Rabit.Core", "Rabit.Geodesy", "Rabit.Mavlink", "Rabit.Uav", "Rabit.Vision"],
            typeof(FlightRecorderManager).Assembly.GetReferencedAssemblies().Select(a => a.Name!)
                .Where(n => n.StartsWith("Rabit", StringComparison.Ordinal)).OrderBy(n => n, StringComparer.Ordinal));

    [Fact]
    public void Package_Types_DoNotUseTheConsoleOrFiles()
    {
        Type[] forbidden =
            [typeof(Console), typeof(System.IO.File), typeof(System.IO.FileStream), typeof(System.IO.Directory)];

        Assert.Empty(typeof(FlightRecorderManager).Assembly.GetTypes()
            .SelectMany(
                t => Rabit.Uav.Tests.TypeReferences.Of(t).Intersect(forbidden)
                    .Select(used => $"{t.Name} uses {used.Name}")));
    }
}
