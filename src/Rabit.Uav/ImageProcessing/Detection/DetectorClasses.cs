using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>The check of the target classes that a detector of one kind is made with.</summary>
internal static class DetectorClasses
{
    /// <param name="classes">The classes.</param>
    /// <param name="kind">What the detector goes by: "marker" for a marker detector.</param>
    /// <param name="has">Whether a class has one.</param>
    /// <param name="parameterName">The name of the caller's parameter.</param>
    /// <exception cref="ArgumentException">A class is wrong, or has none; all of them are named.</exception>
    public static void Demand(
        ImmutableArray<TargetClass> classes, string kind, Func<TargetClass, bool> has, string parameterName)
    {
        string[] faults = TargetClass.FindFaults(classes).ToArray();
        if (faults.Length == 0)
        {
            faults = classes.Where(c => !has(c))
                .Select(c => $"target class {c.Name} has no {kind}, which the {kind} detector needs").ToArray();
        }

        if (faults.Length > 0)
            throw new ArgumentException(
                $"{char.ToUpperInvariant(kind[0])}{kind.Substring(1)} detector: {string.Join("; ", faults)}.",
                parameterName);
    }
}
