using System;
using System.Linq;
using Rabit.Uav.Reporting;
using Xunit;

namespace Rabit.Uav.Simulation.Tests;

/// <summary>The simulation uses Reporting for its scores; Reporting and Rabit.Uav know no simulation.</summary>
public sealed class ArchitectureTests
{
    [Fact]
    public void Packages_References_GoOneWay()
    {
        Assert.Contains("Rabit.Uav.Reporting", References(typeof(SimulatedWorld)));
        Assert.DoesNotContain("Rabit.Uav.Simulation", References(typeof(MissionScore)));
        Assert.DoesNotContain("Rabit.Uav.Simulation", References(typeof(UavSystem)));
        Assert.DoesNotContain("Rabit.Uav.Reporting", References(typeof(UavSystem)));
    }

    private static string[] References(Type type)
        => type.Assembly.GetReferencedAssemblies().Select(a => a.Name!).ToArray();
}
