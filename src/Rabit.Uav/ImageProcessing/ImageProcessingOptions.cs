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
    /// <summary>The camera's pinhole and lens. Needed where there is a camera.</summary>
    public CameraModel? Camera { get; set; }

    /// <summary>How the camera sits on the vehicle.</summary>
    /// <value>The default is no misalignment and no distance from the point whose position the autopilot tells.</value>
    public CameraMount Mount { get; set; } = new();

    /// <summary>How wrong the things are from which positions are reckoned.</summary>
    public ErrorBudget Errors { get; set; } = new();

    /// <summary>Side of the smallest target, metres; a target is a square.</summary>
    /// <value>The default is 0.6 m, for panels of 1 m.</value>
    public double MinSideMetres { get; set; } = 0.6;

    /// <summary>Side of the largest target, metres.</summary>
    /// <value>The default is 1.5 m, for panels of 1 m.</value>
    public double MaxSideMetres { get; set; } = 1.5;

    /// <summary>How much longer than wide a target may be.</summary>
    /// <value>The default is 1.7: a square that is seen aslant or small.</value>
    public double MaxAspect { get; set; } = 1.7;

    /// <summary>Side of the smallest target in the picture, pixels: fewer tell nothing of its form.</summary>
    /// <value>The default is 4.</value>
    public double MinSidePixels { get; set; } = 4;

    /// <summary>How many targets of one picture are reported, the surest first; the others are counted.</summary>
    /// <value>The default is 16.</value>
    public int MaxReportsPerPicture { get; set; } = 16;

    /// <summary>How far below the horizon a line of sight must point.</summary>
    /// <value>The default is 5 degrees: nearer to the horizon every error grows without limit.</value>
    public Angle MinDepression { get; set; } = Angle.FromDegrees(5);

    /// <summary>How long a picture waits for a pose of its time.</summary>
    /// <value>The default is 300 ms.</value>
    public TimeSpan PoseTimeout { get; set; } = TimeSpan.FromMilliseconds(300);

    /// <summary>How far beyond the newest samples a pose is drawn on, once a picture has waited long enough; its covariance grows with that.</summary>
    /// <value>The default is 100 ms; zero refuses such pictures.</value>
    public TimeSpan MaxExtrapolation { get; set; } = TimeSpan.FromMilliseconds(100);

    /// <summary>The terrain.</summary>
    /// <value>Null, the default, for ground that is flat and level at the height that the order tells.</value>
    public TerrainGrid? Terrain { get; set; }

    /// <summary>How far apart two positions, or two attitudes, may be for a pose between them.</summary>
    /// <value>The default is 1 s: at 5 Hz four may be lost on the way.</value>
    public TimeSpan MaxPoseGap { get; set; } = TimeSpan.FromSeconds(1);

    /// <summary>How many pictures may wait for a pose; a further one makes the oldest leave. Each of them keeps a buffer of the camera's pool.</summary>
    /// <value>The default is 2.</value>
    public int FramesWaiting { get; set; } = 2;

    /// <summary>Side of the part of a picture that is kept of each report, pixels.</summary>
    /// <value>The default is 48.</value>
    public int ImageChipSide { get; set; } = 48;

    /// <summary>How many of those are kept, the newest.</summary>
    /// <value>The default is 200: 1.4 MB.</value>
    public int MaxImageChips { get; set; } = 200;

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
        if (!(MinSideMetres > 0 && MinSideMetres < MaxSideMetres && !double.IsInfinity(MaxSideMetres)))
            yield return FormattableString.Invariant($"{nameof(MinSideMetres)} is {MinSideMetres} and {nameof(MaxSideMetres)} {MaxSideMetres}; they must be above 0 and in this order");
        if (!(MaxAspect > 1))
            yield return FormattableString.Invariant($"{nameof(MaxAspect)} is {MaxAspect}; it must be above 1");
        if (!(MinSidePixels >= 4))
            yield return FormattableString.Invariant($"{nameof(MinSidePixels)} is {MinSidePixels}; it must be at least 4");
        if (MaxReportsPerPicture < 1)
            yield return $"{nameof(MaxReportsPerPicture)} is {MaxReportsPerPicture}; it must be at least 1";
        if (!(MinDepression.Degrees > 0 && MinDepression.Degrees < 90))
            yield return FormattableString.Invariant($"{nameof(MinDepression)} is {MinDepression}; it must be between 0 and 90°");
        if (PoseTimeout < TimeSpan.Zero)
            yield return $"{nameof(PoseTimeout)} is {PoseTimeout}; it must not be negative";
        if (MaxExtrapolation < TimeSpan.Zero || MaxExtrapolation > TimeSpan.FromSeconds(1))
            yield return $"{nameof(MaxExtrapolation)} is {MaxExtrapolation}; it must be from zero to a second";
        if (MaxPoseGap <= TimeSpan.Zero)
            yield return $"{nameof(MaxPoseGap)} is {MaxPoseGap}; it must be above zero";
        if (FramesWaiting < 1)
            yield return $"{nameof(FramesWaiting)} is {FramesWaiting}; it must be at least 1";
        if (ImageChipSide < 1 || MaxImageChips < 0)
            yield return $"{nameof(ImageChipSide)} is {ImageChipSide} and {nameof(MaxImageChips)} {MaxImageChips}; they must be at least 1 and 0";
    }

    private IEnumerable<string> FindFaultsInParts()
        => (Camera?.FindFaults() ?? []).Concat(Mount.FindFaults()).Concat(Errors.FindFaults());
}
