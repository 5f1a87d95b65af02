using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// The printed marker on the place to land on: for precision landing, which stays the autopilot's. See
/// <see cref="ImageProcessingOptions.LandingMarker"/>.
/// </summary>
/// <example>
/// An AprilTag of 40 cm:
/// <code>
/// var imaging = new ImageProcessingOptions
/// {
///     LandingMarker = new LandingMarkerOptions { Family = MarkerFamily.AprilTag36h11, Id = 7, SideMetres = 0.4 },
/// };
/// </code>
/// </example>
public sealed class LandingMarkerOptions
{
    // A larger print is a mistake in the unit.
    private const double MaxSideMetres = 20;

    /// <summary>Its family.</summary>
    /// <value>
    /// The default is <see cref="MarkerFamily.AprilTag36h11"/>: in clutter it is less often read where there is none.
    /// </value>
    public MarkerFamily Family { get; set; } = MarkerFamily.AprilTag36h11;

    /// <summary>Its id.</summary>
    /// <value>The default is 0.</value>
    public int Id { get; set; }

    /// <summary>
    /// Side of its black square as it is printed, metres: the distance that is reported is wrong by as many per cent as
    /// this is.
    /// </summary>
    /// <value>There is none: it must be measured.</value>
    public double SideMetres { get; set; }

    internal LandingMarkerOptions Copy() => (LandingMarkerOptions)MemberwiseClone();

    internal IEnumerable<string> FindFaults()
    {
        if (Family is not (MarkerFamily.ArUco4x4 or MarkerFamily.AprilTag36h11))
            yield return $"the landing marker is of the unknown family {(int)Family}";
        else if (Id < 0 || Id >= TargetMarker.CountOf(Family))
            yield return $"the landing marker has the id {Id}; {Family} has 0 to {TargetMarker.CountOf(Family) - 1}";
        if (!(SideMetres > 0 && SideMetres <= MaxSideMetres))
        {
            yield return FormattableString.Invariant(
                $"the side of the landing marker is {SideMetres} m; it must be above 0, at most {MaxSideMetres}");
        }
    }
}
