using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>Which task of a validation is of which track: by class, marker and place.</summary>
internal static class TrackValidation
{
    // Two vehicles locate one target as differently as that, but seldom; two targets of one class are farther apart.
    private const double SamePlaceMetres = 10;

    /// <summary>The task of a track: of several one that has a result, then the nearest one; null for none.</summary>
    public static ValidationTask? Of(TargetTrack track, IEnumerable<ValidationTask> tasks) => tasks
        .Where(t => IsOf(track, t))
        .OrderByDescending(HasResult).ThenByDescending(t => t.State == ValidationState.Closed)
        .ThenBy(t => Metres(track.Position, t.Position))
        .Select(t => (ValidationTask?)t).FirstOrDefault();

    /// <summary>Whether a track may be of a task.</summary>
    public static bool IsOf(TargetTrack track, ValidationTask task) => task.Class == track.Class
        && task.MarkerId == track.MarkerId && AreOnePlace(track.Position, task.Position);

    /// <summary>Whether two vehicles may mean one target by them.</summary>
    public static bool AreOnePlace(GeodeticPosition a, GeodeticPosition b) => Metres(a, b) < SamePlaceMetres;

    /// <summary>Whether it was confirmed or rejected.</summary>
    public static bool HasResult(ValidationTask task)
        => task.State == ValidationState.Closed && task.Result != ValidationResult.Unknown;

    /// <summary>Between two places, over ground.</summary>
    public static double Metres(GeodeticPosition a, GeodeticPosition b)
        => NedPosition.Origin.HorizontalDistanceTo(LocalNedFrame.IgnoringGeoid(a).ToNed(b));
}
