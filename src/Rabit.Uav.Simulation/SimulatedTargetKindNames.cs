using System;

namespace Rabit.Uav.Simulation;

/// <summary>The names of kinds of targets, as command lines take them. Any thread.</summary>
public static class SimulatedTargetKindNames
{
    // In the order of the enumeration.
    private static readonly string[] Names =
        ["coloured", "white", "black", "two-coloured", "person", "car", "aruco", "apriltag"];

    /// <summary>All of them: "coloured, white, ...".</summary>
    public static string All { get; } = string.Join(", ", Names);

    /// <summary>Finds a kind by its name.</summary>
    /// <param name="name">One of <see cref="All"/>, in small letters.</param>
    /// <param name="kind">The kind; the first where there is none of that name.</param>
    /// <returns>Whether there is one.</returns>
    public static bool TryParse(string? name, out SimulatedTargetKind kind)
    {
        int at = Array.IndexOf(Names, name);
        kind = (SimulatedTargetKind)Math.Max(0, at);
        return at >= 0;
    }

    /// <summary>The name of a kind.</summary>
    /// <param name="kind">The kind.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such kind.</exception>
    public static string NameOf(SimulatedTargetKind kind)
        => (int)kind >= 0 && (int)kind < Names.Length
            ? Names[(int)kind]
            : throw new ArgumentOutOfRangeException(nameof(kind), kind, "There is no such kind of target.");

    /// <summary>The error for a name that is none.</summary>
    /// <param name="option">The option of the command line.</param>
    /// <param name="name">What was given.</param>
    public static string Fault(string option, string name)
        => $"{option}: '{name}' is no kind of target; there are {All}.";
}
