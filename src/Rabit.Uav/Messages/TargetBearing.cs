using System;
using System.Globalization;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>
/// Where a target points on the ground, clockwise from true north, up to its symmetry, and how well that is known. A
/// plain value; not that of the direction in which the target is seen.
/// </summary>
public readonly record struct TargetBearing
{
    /// <summary>Makes one.</summary>
    /// <param name="angle">
    /// Of its longer side, of any side of a square, of the upper edge of a marker; any number of turns.
    /// </param>
    /// <param name="sigma">One standard deviation, new in each picture; above 0.</param>
    /// <param name="symmetry">By which turns it looks the same.</param>
    public TargetBearing(Angle angle, Angle sigma, BearingSymmetry symmetry)
    {
        (Symmetry, Sigma) = (symmetry, sigma);
        double turns = Math.Floor(angle.Radians / Period.Radians);
        Angle = turns == 0 ? angle : Angle.FromRadians(angle.Radians - (turns * Period.Radians));
    }

    /// <summary>Clockwise from true north; at least 0 and below <see cref="Period"/>.</summary>
    public Angle Angle { get; }

    /// <summary>One standard deviation of what is new in each picture.</summary>
    public Angle Sigma { get; }

    /// <summary>
    /// One standard deviation of what is the same in all pictures of a flight, as that of the compass; 0 where that is
    /// not known, as to a detector.
    /// </summary>
    public Angle SystematicSigma { get; init; }

    /// <summary>By which turns it looks the same.</summary>
    public BearingSymmetry Symmetry { get; }

    /// <summary>One standard deviation in all.</summary>
    public Angle TotalSigma
        => Angle.FromRadians(Math.Sqrt(
            (Sigma.Radians * Sigma.Radians) + (SystematicSigma.Radians * SystematicSigma.Radians)));

    /// <summary>The turn by which it looks the same: 360, 180 or 90 degrees.</summary>
    public Angle Period => Symmetry switch
    {
        BearingSymmetry.HalfTurn => Angle.FromDegrees(180),
        BearingSymmetry.QuarterTurn => Angle.FromDegrees(90),
        _ => Angle.FromDegrees(360),
    };

    /// <summary>By how much it differs from a direction at least, whichever of its ends is the front.</summary>
    /// <param name="direction">Clockwise from north.</param>
    /// <returns>0 to half of <see cref="Period"/>.</returns>
    public Angle DistanceTo(Angle direction)
    {
        double period = Period.Radians;
        double difference = direction.Radians - Angle.Radians;
        return Angle.FromRadians(Math.Abs(difference - (period * Math.Round(difference / period))));
    }

    /// <summary>In degrees, with its standard deviation and the other directions that it may be.</summary>
    public override string ToString()
    {
        string text = string.Format(
            CultureInfo.InvariantCulture, "{0:0}° ±{1:0.0}°", Angle.Degrees, TotalSigma.Degrees);
        return Symmetry switch
        {
            BearingSymmetry.HalfTurn => text + " or 180° more",
            BearingSymmetry.QuarterTurn => text + " or 90°, 180°, 270° more",
            _ => text,
        };
    }
}
