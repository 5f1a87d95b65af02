using System.Collections.Generic;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What makes pictures of real flights worse than those of the plain simulated camera. All of it is off by default,
/// follows from seed, poses and number of the picture, and is the same on every runtime.
/// </summary>
/// <example>
/// <code>
/// var camera = new SimulatedCameraOptions
/// {
///     Exposure = TimeSpan.FromMilliseconds(6),
///     Effects = SimulatedPictureEffects.CreateModerate(),
/// };
/// </code>
/// </example>
public sealed class SimulatedPictureEffects
{
    /// <summary>
    /// Whether the whole picture is smeared by what the camera moves and turns during
    /// <see cref="SimulatedCameraOptions.Exposure"/>; otherwise only things on the ground are.
    /// </summary>
    public bool HasMotionBlur { get; set; }

    /// <summary>How much darker than the middle the corners are, beside the 16 % of every picture, 0 to 0.9.</summary>
    public double Vignetting { get; set; }

    /// <summary>
    /// Which part of the light clouds take from half of the ground, in patches some 60 m wide with soft edges, 0 to
    /// 0.9.
    /// </summary>
    public double Shade { get; set; }

    /// <summary>Red as a multiple of what a camera with the right white balance gives, 0.5 to 2.</summary>
    /// <value>The default is 1.</value>
    public double RedGain { get; set; } = 1;

    /// <summary>The same of blue.</summary>
    /// <value>The default is 1.</value>
    public double BlueGain { get; set; } = 1;

    /// <summary>
    /// All levels as a multiple of what the right exposure gives, 0.2 to 4; what is above 255 is clipped.
    /// </summary>
    /// <value>The default is 1.</value>
    public double ExposureGain { get; set; } = 1;

    /// <summary>
    /// Quality of the JPEG that the camera makes of its pictures, 1 to 100 as libjpeg counts, with colours at half the
    /// resolution; null for none.
    /// </summary>
    /// <value>The default is null.</value>
    public int? JpegQuality { get; set; }

    internal bool HasLight
        => Vignetting > 0 || !RedGain.Equals(1) || !BlueGain.Equals(1) || !ExposureGain.Equals(1);

    /// <summary>An ordinary camera on a day with clouds; made for an exposure of 6 ms.</summary>
    public static SimulatedPictureEffects CreateModerate() => new()
    {
        HasMotionBlur = true,
        Vignetting = 0.2,
        Shade = 0.4,
        RedGain = 1.08,
        BlueGain = 0.9,
        ExposureGain = 1.1,
        JpegQuality = 75,
    };

    /// <summary>A cheap camera in bad light; made for an exposure of 12 ms.</summary>
    public static SimulatedPictureEffects CreateHarsh() => new()
    {
        HasMotionBlur = true,
        Vignetting = 0.4,
        Shade = 0.6,
        RedGain = 1.2,
        BlueGain = 0.75,
        ExposureGain = 1.35,
        JpegQuality = 40,
    };

    internal SimulatedPictureEffects Copy() => (SimulatedPictureEffects)MemberwiseClone();

    internal IEnumerable<string> FindFaults()
    {
        foreach ((string name, double value, double min, double max) in new (string, double, double, double)[]
        {
            (nameof(Vignetting), Vignetting, 0, 0.9), (nameof(Shade), Shade, 0, 0.9),
            (nameof(RedGain), RedGain, 0.5, 2), (nameof(BlueGain), BlueGain, 0.5, 2),
            (nameof(ExposureGain), ExposureGain, 0.2, 4),
        })
        {
            if (!(value >= min && value <= max))
            {
                yield return System.FormattableString.Invariant(
                    $"{nameof(SimulatedCameraOptions.Effects)}.{name} is {value}; it must be {min} to {max}");
            }
        }

        if (JpegQuality is < 1 or > 100)
            yield return $"{nameof(SimulatedCameraOptions.Effects)}.{nameof(JpegQuality)} is {JpegQuality}; it must be "
                + "1 to 100";
    }
}
