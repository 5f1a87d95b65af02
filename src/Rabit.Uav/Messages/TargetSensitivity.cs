using System.Collections.Immutable;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>
/// How the place of a report would be another one for errors that are the same in every picture, north and east in
/// metres; down is 0. Reports of one target that differ in it show the error. Immutable.
/// </summary>
internal sealed class TargetSensitivity
{
    /// <summary>The largest error of the time that is tried, either way, seconds.</summary>
    public const double MaxOffsetSeconds = 1.6;

    /// <summary>From one to the next, seconds: in that time the attitude changes little.</summary>
    public const double StepSeconds = 0.05;

    /// <summary>How many errors of the time are tried.</summary>
    public const int Offsets = (2 * 32) + 1;

    /// <summary>
    /// How far the place moves if the time of the picture is later than the exposure truly was by
    /// <see cref="OffsetOf"/>; not a number where there is no pose of that time.
    /// </summary>
    public ImmutableArray<NedVector> ByOffset { get; init; } = [];

    /// <summary>For each radian of roll.</summary>
    public NedVector ByRoll { get; init; }

    /// <summary>For each radian of pitch.</summary>
    public NedVector ByPitch { get; init; }

    /// <summary>For each radian of heading.</summary>
    public NedVector ByHeading { get; init; }

    /// <summary>For each metre that the ground is higher.</summary>
    public NedVector ByGroundHeight { get; init; }

    /// <summary>The errors of the time in turn, seconds.</summary>
    public static double OffsetOf(int index) => (index * StepSeconds) - MaxOffsetSeconds;
}
