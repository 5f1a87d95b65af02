using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;

namespace Rabit.Uav.ImageProcessing;

/// <summary>What Image Processing knows of its camera, and what it takes for a target. Read once, when the manager is made.</summary>
public sealed class ImageProcessingOptions
{
    private const double Degree = Math.PI / 180;

    /// <summary>The camera's pinhole and lens. Needed where there is a camera.</summary>
    public CameraModel? Camera { get; set; }

    /// <summary>How the camera sits on the vehicle.</summary>
    /// <value>The default is no misalignment and no distance from the point whose position the autopilot tells.</value>
    public CameraMount Mount { get; set; } = new();

    /// <summary>How wrong the things are from which positions are reckoned.</summary>
    public ErrorBudget Errors { get; set; } = new();

    /// <summary>Side of the smallest target, metres; a target is a square.</summary>
    /// <value>The default is 0.6 m, for panels of 1 m.</value>
    public double MinimumSideMetres { get; set; } = 0.6;

    /// <summary>Side of the largest target, metres.</summary>
    /// <value>The default is 1.5 m, for panels of 1 m.</value>
    public double MaximumSideMetres { get; set; } = 1.5;

    /// <summary>How much longer than wide a target may be.</summary>
    /// <value>The default is 1.7: a square that is seen aslant or small.</value>
    public double MaximumAspect { get; set; } = 1.7;

    /// <summary>Side of the smallest target in the picture, pixels: fewer tell nothing of its form.</summary>
    /// <value>The default is 4.</value>
    public double MinimumSidePixels { get; set; } = 4;

    /// <summary>How many targets of one picture are reported, the surest first; the others are counted.</summary>
    /// <value>The default is 16.</value>
    public int MaximumReportsPerPicture { get; set; } = 16;

    /// <summary>How far below the horizon a line of sight must point, radians.</summary>
    /// <value>The default is 5 degrees: nearer to the horizon every error grows without limit.</value>
    public double MinimumDepressionRadians { get; set; } = 5 * Degree;

    /// <summary>How long a picture waits for a pose of its time.</summary>
    /// <value>The default is 300 ms.</value>
    public TimeSpan PoseTimeout { get; set; } = TimeSpan.FromMilliseconds(300);

    /// <summary>How far beyond the newest samples a pose is drawn on, once a picture has waited long enough; its covariance grows with that.</summary>
    /// <value>The default is 100 ms; zero refuses such pictures.</value>
    public TimeSpan LongestExtrapolation { get; set; } = TimeSpan.FromMilliseconds(100);

    /// <summary>Heights of the ground, above mean sea level.</summary>
    /// <value>Null, the default, for ground that is flat and level at the height that the order tells.</value>
    public TerrainGrid? Terrain { get; set; }

    /// <summary>How far apart two positions, or two attitudes, may be for a pose between them.</summary>
    /// <value>The default is 1 s: at 5 Hz four may be lost on the way.</value>
    public TimeSpan LongestPoseGap { get; set; } = TimeSpan.FromSeconds(1);

    /// <summary>How many pictures may wait for a pose; a further one makes the oldest leave. Each of them keeps a buffer of the camera's pool.</summary>
    /// <value>The default is 2.</value>
    public int FramesWaiting { get; set; } = 2;

    /// <summary>Side of the part of a picture that is kept of each report, pixels.</summary>
    /// <value>The default is 48.</value>
    public int CutOutSide { get; set; } = 48;

    /// <summary>How many of those are kept, the newest.</summary>
    /// <value>The default is 200: 1.4 MB.</value>
    public int CutOutsKept { get; set; } = 200;

    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal ImageProcessingOptions ValidatedCopy(bool hasCamera, string parameter)
    {
        if (Mount is null || Errors is null)
            throw new ArgumentException("Image Processing: the mount and the errors may be left as they are, but not null.", parameter);
        List<string> faults = FindFaults(hasCamera).Concat(FindFaultsInParts()).ToList();
        if (faults.Count > 0)
            throw new ArgumentException("Image Processing: " + string.Join("; ", faults) + ".", parameter);
        var copy = (ImageProcessingOptions)MemberwiseClone();
        copy.Errors = Errors.Copy();
        return copy;
    }

    private IEnumerable<string> FindFaults(bool hasCamera)
    {
        if (hasCamera && Camera is null)
            yield return $"there is a camera, but {nameof(Camera)} does not say what it is like";
        if (!(MinimumSideMetres > 0 && MinimumSideMetres < MaximumSideMetres && !double.IsInfinity(MaximumSideMetres)))
            yield return FormattableString.Invariant($"{nameof(MinimumSideMetres)} is {MinimumSideMetres} and {nameof(MaximumSideMetres)} {MaximumSideMetres}; they must be above 0 and in this order");
        if (!(MaximumAspect > 1))
            yield return FormattableString.Invariant($"{nameof(MaximumAspect)} is {MaximumAspect}; it must be above 1");
        if (!(MinimumSidePixels >= 4))
            yield return FormattableString.Invariant($"{nameof(MinimumSidePixels)} is {MinimumSidePixels}; it must be at least 4");
        if (MaximumReportsPerPicture < 1)
            yield return $"{nameof(MaximumReportsPerPicture)} is {MaximumReportsPerPicture}; it must be at least 1";
        if (!(MinimumDepressionRadians > 0 && MinimumDepressionRadians < Math.PI / 2))
            yield return FormattableString.Invariant($"{nameof(MinimumDepressionRadians)} is {MinimumDepressionRadians}; it must be between 0 and pi/2");
        if (PoseTimeout < TimeSpan.Zero)
            yield return $"{nameof(PoseTimeout)} is {PoseTimeout}; it must not be negative";
        if (LongestExtrapolation < TimeSpan.Zero || LongestExtrapolation > TimeSpan.FromSeconds(1))
            yield return $"{nameof(LongestExtrapolation)} is {LongestExtrapolation}; it must be from zero to a second";
        if (LongestPoseGap <= TimeSpan.Zero)
            yield return $"{nameof(LongestPoseGap)} is {LongestPoseGap}; it must be above zero";
        if (FramesWaiting < 1)
            yield return $"{nameof(FramesWaiting)} is {FramesWaiting}; it must be at least 1";
        if (CutOutSide < 1 || CutOutsKept < 0)
            yield return $"{nameof(CutOutSide)} is {CutOutSide} and {nameof(CutOutsKept)} {CutOutsKept}; they must be at least 1 and 0";
    }

    private IEnumerable<string> FindFaultsInParts()
        => (Camera?.FindFaults() ?? []).Concat(Mount.FindFaults()).Concat(Errors.FindFaults());
}
