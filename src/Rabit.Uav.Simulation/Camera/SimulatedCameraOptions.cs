using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The true properties of the simulated camera. The aircraft's model of it is separate: give that other numbers, and
/// the difference is an error that the flight has to live with. Read once, when the camera is made.
/// </summary>
/// <example>
/// <code>
/// var camera = new SimulatedCameraOptions
/// {
///     FramesPerSecond = 4,
///     MisalignmentPitch = Angle.FromDegrees(1.5),   // the aircraft's model of the camera does not have it
/// };
/// var world = new SimulatedWorld(new SimulationOptions { Camera = camera });
/// </code>
/// </example>
public sealed class SimulatedCameraOptions
{
    private const int MaxPixelsPerSide = 4096;

    /// <summary>Pinhole and lens.</summary>
    /// <value>The default is 640 x 480, f 530 px, a slight barrel distortion.</value>
    public CameraModel Camera { get; set; } = new()
    {
        Width = 640,
        Height = 480,
        FocalX = 530,
        FocalY = 530,
        CentreX = 321.2,
        CentreY = 237.4,
        K1 = -0.06,
        K2 = 0.015,
        P1 = 0.0003,
        P2 = -0.0002,
    };

    /// <summary>
    /// Where the camera sits before the reference point of the true position, metres forward in body axes.
    /// </summary>
    /// <value>The default is 0.1.</value>
    public double LeverArmForwardMetres { get; set; } = 0.1;

    /// <summary>The same, metres to the right.</summary>
    /// <value>The default is 0.</value>
    public double LeverArmRightMetres { get; set; }

    /// <summary>The same, metres down.</summary>
    /// <value>The default is 0.05.</value>
    public double LeverArmDownMetres { get; set; } = 0.05;

    /// <summary>
    /// How far the foot of the camera's gimbal is rotated about the body's forward axis, right side down positive.
    /// </summary>
    /// <value>The default is 0.</value>
    public Angle MisalignmentRoll { get; set; }

    /// <summary>How far the foot of the camera's gimbal is rotated nose up.</summary>
    /// <value>The default is 0.</value>
    public Angle MisalignmentPitch { get; set; }

    /// <summary>How far the foot of the camera's gimbal is rotated to the right.</summary>
    /// <value>The default is 0.</value>
    public Angle MisalignmentYaw { get; set; }

    /// <summary>
    /// Where the camera looks until it is pointed elsewhere, against what holds it: a camera without a gimbal, which
    /// nothing points, always. -90 to 30 degrees, up positive.
    /// </summary>
    /// <value>The default is straight down, -90 degrees.</value>
    public Angle Pitch { get; set; } = Angle.FromDegrees(-90);

    /// <summary>The same, right positive.</summary>
    /// <value>The default is 0.</value>
    public Angle Yaw { get; set; }

    /// <summary>What holds the camera.</summary>
    /// <value>The default is <see cref="SimulatedGimbal.AgainstBody"/>.</value>
    public SimulatedGimbal Gimbal { get; set; }

    /// <summary>Pictures per second.</summary>
    /// <value>The default is 2.</value>
    public double FramesPerSecond { get; set; } = 2;

    /// <summary>How long a picture is exposed, all rows at once.</summary>
    /// <value>The default is 2 ms.</value>
    public TimeSpan Exposure { get; set; } = TimeSpan.FromMilliseconds(2);

    /// <summary>From the start of the exposure until the picture is delivered; longer than the exposure.</summary>
    /// <value>The default is 120 ms.</value>
    public TimeSpan Delay { get; set; } = TimeSpan.FromMilliseconds(120);

    /// <summary>Standard deviation of the noise of each channel of each pixel, levels of 255.</summary>
    /// <value>The default is 2.5.</value>
    public double NoiseSigma { get; set; } = 2.5;

    /// <summary>What makes the pictures worse.</summary>
    /// <value>The default is nothing.</value>
    public SimulatedPictureEffects Effects { get; set; } = new();

    /// <summary>How many pictures may be on their way at once; while all buffers are out, pictures are lost.</summary>
    /// <value>The default is 6.</value>
    public int Buffers { get; set; } = 6;

    /// <summary>Times without pictures.</summary>
    public IReadOnlyList<CameraFreeze> Freezes { get; set; } = Array.Empty<CameraFreeze>();

    internal GimbalFrame GimbalFrame => Gimbal switch
    {
        SimulatedGimbal.FollowsHeading => GimbalFrame.Heading,
        SimulatedGimbal.HoldsNorth => GimbalFrame.North,
        _ => GimbalFrame.Body,
    };

    /// <summary>
    /// The same camera with a quarter of the pixels, 320 x 240: for long runs in which the pictures are not the
    /// point.
    /// </summary>
    public static SimulatedCameraOptions CreateLowResolution()
    {
        var options = new SimulatedCameraOptions();
        CameraModel full = options.Camera;
        options.Camera = new CameraModel
        {
            Width = full.Width / 2,
            Height = full.Height / 2,
            FocalX = full.FocalX / 2,
            FocalY = full.FocalY / 2,
            // the corner of the picture stays where it is, not the centre of its first pixel
            CentreX = ((full.CentreX + 0.5) / 2) - 0.5,
            CentreY = ((full.CentreY + 0.5) / 2) - 0.5,
            K1 = full.K1,
            K2 = full.K2,
            P1 = full.P1,
            P2 = full.P2,
            K3 = full.K3,
        };
        return options;
    }

    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal SimulatedCameraOptions ValidatedCopy(string parameter)
    {
        if (Camera is null || Freezes is null || Effects is null)
        {
            throw new ArgumentException(
                $"Simulated camera: {nameof(Camera)}, {nameof(Freezes)} and {nameof(Effects)} may not be null.",
                parameter);
        }

        var faults = new List<string>();
        CheckPixels(faults, "Width", Camera.Width);
        CheckPixels(faults, "Height", Camera.Height);
        if (!(Camera.FocalX > 0) || !(Camera.FocalY > 0) || double.IsInfinity(Camera.FocalX + Camera.FocalY))
            faults.Add($"the focal lengths are {Camera.FocalX} and {Camera.FocalY} px; they must be above zero");
        if (Camera.Readout != TimeSpan.Zero)
            faults.Add($"{nameof(Camera.Readout)} is {Camera.Readout}; it exposes all rows at once, so that it must "
                + "be zero");
        if (Camera.Lens != LensModel.BrownConrady || Camera.K4 != 0 || Camera.K5 != 0 || Camera.K6 != 0)
            faults.Add($"its lens is {Camera.Lens} with K4 {Camera.K4}, K5 {Camera.K5}, K6 {Camera.K6}; it must be "
                + $"{LensModel.BrownConrady} without K4 to K6");
        if (Gimbal is < SimulatedGimbal.AgainstBody or > SimulatedGimbal.HoldsNorth)
            faults.Add($"{nameof(Gimbal)} is {Gimbal}; there is none of that number");
        if (!(Pitch.Degrees is >= -90.001 and <= 30.001) || !(Math.Abs(Yaw.Degrees) <= 360))
            faults.Add($"{nameof(Pitch)} and {nameof(Yaw)} are {Pitch.Degrees} and {Yaw.Degrees} degrees; they must be "
                + "-90 to 30 and -360 to 360");
        if (!(FramesPerSecond > 0) || FramesPerSecond > 1000)
            faults.Add($"{nameof(FramesPerSecond)} is {FramesPerSecond}; it must be above 0 and at most 1000");
        if (Exposure < TimeSpan.Zero || Exposure > TimeSpan.FromHours(1))
            faults.Add($"{nameof(Exposure)} is {Exposure}; it must be 0 to 1 hour");
        if (Delay <= Exposure)
            faults.Add($"{nameof(Delay)} is {Delay}; it must be longer than {nameof(Exposure)}, which is {Exposure}");
        if (!(NoiseSigma >= 0) || NoiseSigma > 20)
            faults.Add($"{nameof(NoiseSigma)} is {NoiseSigma}; it must be 0 to 20");
        if (Buffers < 1)
            faults.Add($"{nameof(Buffers)} is {Buffers}; it must be at least 1");
        faults.AddRange(Effects.FindFaults());
        if (faults.Count > 0)
            throw new ArgumentException("Simulated camera: " + string.Join("; ", faults) + ".", parameter);
        var copy = (SimulatedCameraOptions)MemberwiseClone();
        copy.Freezes = Freezes.ToArray();
        copy.Effects = Effects.Copy();
        return copy;
    }

    /// <summary>The same with the faults of the camera that a script has.</summary>
    internal SimulatedCameraOptions With(IEnumerable<ScriptedFault> faults)
    {
        var copy = (SimulatedCameraOptions)MemberwiseClone();
        copy.Freezes = Freezes.Concat(
            faults.Where(f => f.Kind == ScriptedFaultKind.CameraFreeze).Select(f => new CameraFreeze(f.At, f.Duration)))
            .ToArray();
        return copy;
    }

    private static void CheckPixels(List<string> faults, string name, int pixels)
    {
        if (pixels is < 8 or > MaxPixelsPerSide)
            faults.Add($"{name} is {pixels}; it must be 8 to {MaxPixelsPerSide} pixels");
    }
}
