using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav.AutopilotInterface;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests;

/// <summary>
/// The dependency rules: which package may use which, and which module (namespace) of Rabit.Uav may use which. By what
/// the compiled code refers to, since a "using" directive says little: a type can be named without one, and one is
/// often left over.
/// </summary>
public class ArchitectureTests
{
    private const string Root = "Rabit.Uav";

    // What every manager may use.
    private static readonly string[] Shared = ["Messages", "CameraGeometry", "Json", "Preflight"];

    private static readonly string[] Managers =
    [
        "Communications", "AutopilotInterface", "ImageProcessing", "SensorFusion", "MissionControl",
        "HealthMonitoring"
    ];

    [Fact]
    public void Packages_References_GoOneWay()
    {
        Assert.Empty(RabitReferences(typeof(RabitManager).Assembly));
        Assert.Empty(RabitReferences(typeof(MavlinkFrame).Assembly));
        Assert.Empty(RabitReferences(typeof(GeodeticPosition).Assembly));
        Assert.Empty(RabitReferences(typeof(RgbPicture).Assembly));
        Assert.Empty(RabitReferences(typeof(IByteLink).Assembly).Except(["Rabit.Core"]));
        Assert.Equal(
            ["Rabit.Core", "Rabit.Geodesy", "Rabit.Links", "Rabit.Mavlink", "Rabit.Vision"],
            RabitReferences(typeof(AutopilotManager).Assembly));
    }

    [Fact]
    public void Modules_EachType_UsesOnlyItsModuleAndWhatIsShared()
    {
        List<string> violations = FindViolations(typeof(AutopilotManager).Assembly.GetTypes(), Root).ToList();
        Assert.True(violations.Count == 0, string.Join(Environment.NewLine, violations));
    }

    [Fact]
    public void Modules_Violations_AreFoundInFieldsSignaturesAndCode()
    {
        const string Planted = "Rabit.Uav.Tests.Planted";
        IEnumerable<Type> types = typeof(ArchitectureTests).Assembly.GetTypes()
            .Where(t => t.Namespace?.StartsWith(Planted, StringComparison.Ordinal) == true);
        IEnumerable<string> violators = FindViolations(types, Planted)
            .Select(v => v.Substring(0, v.IndexOf(' ')))
            .Distinct(StringComparer.Ordinal)
            .OrderBy(n => n, StringComparer.Ordinal);

        Assert.Equal(
            ["ByAttribute", "ByBase", "ByCall", "ByField", "ByGenericArgument", "ByLambda", "ByLocal", "ByMessage",
                "BySignature"],
            violators);
    }

    private static string[] RabitReferences(Assembly assembly)
        => assembly.GetReferencedAssemblies().Select(a => a.Name!)
            .Where(n => n.StartsWith("Rabit", StringComparison.Ordinal))
            .OrderBy(n => n, StringComparer.Ordinal)
            .ToArray();

    /// <summary>Lines that begin with the name of the outermost type at fault.</summary>
    private static IEnumerable<string> FindViolations(IEnumerable<Type> types, string root)
    {
        foreach (Type type in types)
        {
            string from = PartOf(type, root);
            foreach (Type used in TypeReferences.Of(type))
            {
                string to = PartOf(used, root);
                if (to.Length > 0 && !MayUse(from, to))
                    yield return $"{Outermost(type).Name} ({from}) uses {used.Name} ({to})";
            }
        }
    }

    // The root, where everything is composed, may use everything, and no module uses it.
    private static bool MayUse(string from, string to) => from switch
    {
        _ when from == to || from == "root" || from.Length == 0 => true,
        "Json" => false,

        // A manager beside the six, above the two that it connects, as a user's own would be.
        "GroundControl" => Shared.Contains(to, StringComparer.Ordinal) || to is "Communications" or "MissionControl",
        "Messages" or "CameraGeometry" or "Preflight" => Array.IndexOf(Shared, to) >= 0,
        _ => Managers.Contains(from, StringComparer.Ordinal) && Shared.Contains(to, StringComparer.Ordinal),
    };

    // "" for what is not in the package.
    private static string PartOf(Type type, string root)
    {
        string name = type.Namespace ?? string.Empty;
        if (name == root)
            return "root";
        return name.StartsWith(root + ".", StringComparison.Ordinal)
            ? name.Substring(root.Length + 1).Split('.')[0]
            : string.Empty;
    }

    private static Type Outermost(Type type)
    {
        while (type.DeclaringType is { } outer)
            type = outer;
        return type;
    }
}
