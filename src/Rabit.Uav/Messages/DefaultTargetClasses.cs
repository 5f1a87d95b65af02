using System.Collections.Immutable;

namespace Rabit.Uav.Messages;

/// <summary>
/// The classes that Image Processing searches for where the user declares none: square panels of five colours.
/// </summary>
public static class DefaultTargetClasses
{
    /// <summary>"red", nominally sRGB 205,28,32.</summary>
    public static TargetClassName Red { get; } = new("red");

    /// <summary>"orange", nominally sRGB 242,112,18.</summary>
    public static TargetClassName Orange { get; } = new("orange");

    /// <summary>"blue", nominally sRGB 28,72,205.</summary>
    public static TargetClassName Blue { get; } = new("blue");

    /// <summary>"yellow", nominally sRGB 243,214,28.</summary>
    public static TargetClassName Yellow { get; } = new("yellow");

    /// <summary>"magenta", nominally sRGB 212,36,150.</summary>
    public static TargetClassName Magenta { get; } = new("magenta");

    /// <summary>All five.</summary>
    public static ImmutableArray<TargetClassName> All { get; } = [Red, Orange, Blue, Yellow, Magenta];
}
