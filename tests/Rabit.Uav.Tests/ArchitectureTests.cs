using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.AutopilotInterface;
using Xunit;

namespace Rabit.Uav.Tests;

/// <summary>
/// The walls of the house: which package may use which, and which namespace of Rabit.Uav may see which. By what the compiled code
/// refers to, since a "using" says little: a neighbour can be named without one, and one is often left over.
/// </summary>
public class ArchitectureTests
{
    private const string House = "Rabit.Uav";

    private static readonly string[] Shared = ["Messages", "Geometry", "Links"];

    private static readonly string[] Rooms =
        ["Communications", "AutopilotInterface", "ImageProcessing", "SensorFusion", "MissionControl", "HealthMonitoring"];

    [Fact]
    public void Packages_References_GoOneWay()
    {
        Assert.Empty(RabitReferences(typeof(RabitManager).Assembly));
        Assert.Empty(RabitReferences(typeof(MavlinkFrame).Assembly));
        Assert.Equal(["Rabit.Core", "Rabit.Mavlink"], RabitReferences(typeof(AutopilotManager).Assembly));
    }

    [Fact]
    public void Rooms_EachType_SeesOnlyItsRoomAndWhatIsShared()
    {
        List<string> violations = FindViolations(typeof(AutopilotManager).Assembly.GetTypes(), House).ToList();
        Assert.True(violations.Count == 0, string.Join(Environment.NewLine, violations));
    }

    [Fact]
    public void Rooms_Walls_AreSeenInFieldsSignaturesAndCode()
    {
        const string Planted = "Rabit.Uav.Tests.Planted";
        IEnumerable<Type> types = typeof(ArchitectureTests).Assembly.GetTypes()
            .Where(t => t.Namespace?.StartsWith(Planted, StringComparison.Ordinal) == true);
        IEnumerable<string> culprits = FindViolations(types, Planted)
            .Select(v => v.Substring(0, v.IndexOf(' '))).Distinct(StringComparer.Ordinal).OrderBy(n => n, StringComparer.Ordinal);

        Assert.Equal(
            ["ByAttribute", "ByBase", "ByCall", "ByField", "ByGenericArgument", "ByLambda", "ByLocal", "ByMail", "BySignature"], culprits);
    }

    private static string[] RabitReferences(Assembly assembly)
        => assembly.GetReferencedAssemblies().Select(a => a.Name!)
            .Where(n => n.StartsWith("Rabit", StringComparison.Ordinal)).OrderBy(n => n, StringComparer.Ordinal).ToArray();

    /// <summary>Lines that begin with the name of the outermost type to blame.</summary>
    private static IEnumerable<string> FindViolations(IEnumerable<Type> types, string house)
    {
        foreach (Type type in types)
        {
            string from = PartOf(type, house);
            foreach (Type used in TypeReferences.Of(type))
            {
                string to = PartOf(used, house);
                if (to.Length > 0 && !MaySee(from, to))
                    yield return $"{Outermost(type).Name} ({from}) uses {used.Name} ({to})";
            }
        }
    }

    // The root, where everything is put together, may see everything, and is seen by nobody.
    private static bool MaySee(string from, string to) => from switch
    {
        _ when from == to || from == "root" || from.Length == 0 => true,
        "Geometry" or "Links" => false,
        "Messages" => to == "Geometry",
        _ => Rooms.Contains(from, StringComparer.Ordinal) && Shared.Contains(to, StringComparer.Ordinal),
    };

    // "" for what is not in the house at all.
    private static string PartOf(Type type, string house)
    {
        string name = type.Namespace ?? string.Empty;
        if (name == house)
            return "root";
        return name.StartsWith(house + ".", StringComparison.Ordinal) ? name.Substring(house.Length + 1).Split('.')[0] : string.Empty;
    }

    private static Type Outermost(Type type)
    {
        while (type.DeclaringType is { } outer)
            type = outer;
        return type;
    }
}
