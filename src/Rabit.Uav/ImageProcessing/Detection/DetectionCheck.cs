using System.Collections.Immutable;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// What a detection must be to be used: detectors are the user's, and a wrong number would go as far as a filter.
/// </summary>
internal static class DetectionCheck
{
    public const string OutsidePicture = "the centre of a detection is outside the picture or not a number";
    public const string WrongClass = "a detection is of a class that is not declared, or that the mission does not ask for";
    public const string WrongScore = "the score of a detection is not 0 to 1";
    public const string WrongExtent = "the extent of a detection is not above 0, larger than the picture or not a number";
    public const string WrongSide = "the side of a detection on the ground is negative or not a number";
    public const string WrongBearing = "the bearing of a detection is not a number, or has no standard deviation above 0";
    public const string WrongCovariance = "the covariance of a detection is not positive definite, or not finite";

    // Larger than anything that is searched for from the air; Sensor Fusion refuses more.
    private const double MaxSideMetres = 50;

    /// <summary>
    /// What is wrong with a detection; null if nothing is. Comparisons with NaN are false, so each is true for what is
    /// valid.
    /// </summary>
    public static string? FindFault(in TargetDetection detection, in DetectorInput input)
    {
        if (!(detection.CentreX >= -0.5 && detection.CentreX <= input.Width - 0.5
            && detection.CentreY >= -0.5 && detection.CentreY <= input.Height - 0.5))
            return OutsidePicture;
        if (!IsWanted(detection, input.Classes))
            return WrongClass;
        if (detection.Score is not (>= 0 and <= 1))
            return WrongScore;
        if (!(detection.WidthPixels > 0 && detection.WidthPixels <= input.Width
            && detection.HeightPixels > 0 && detection.HeightPixels <= input.Height))
            return WrongExtent;
        if (detection.SideMetres is not (>= 0 and <= MaxSideMetres))
            return WrongSide;
        if (detection.Bearing is { } bearing && !IsBearing(bearing))
            return WrongBearing;
        return detection.Covariance.IsPositiveDefinite ? null : WrongCovariance;
    }

    private static bool IsBearing(in TargetBearing bearing)
        => bearing.Angle.IsFinite && bearing.Sigma.IsFinite && bearing.Sigma.Radians > 0
            && bearing.Symmetry is >= BearingSymmetry.None and <= BearingSymmetry.QuarterTurn;

    private static bool IsWanted(in TargetDetection detection, ImmutableArray<TargetClass> classes)
    {
        foreach (TargetClass one in classes)
        {
            if (one.Name == detection.Class)
                return true;
        }

        return false;
    }
}
