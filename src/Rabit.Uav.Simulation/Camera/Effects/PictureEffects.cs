namespace Rabit.Uav.Simulation;

/// <summary>
/// The effects of one camera, in the order in which light, lens, sensor and computer cause them. Allocates nothing for
/// a picture; one thread.
/// </summary>
internal sealed class PictureEffects(SimulatedPictureEffects options, LensRays lens, ulong seed)
{
    private const ulong PurposeOfClouds = 0x636C6F756473;

    private readonly CloudShade? _shade = options.Shade > 0
        ? new CloudShade(lens, options.Shade, SeededSequence.Derive(seed, PurposeOfClouds))
        : null;

    private readonly MotionBlur? _blur = options.HasMotionBlur ? new MotionBlur(lens) : null;
    private readonly LightGain? _light = options.HasLight ? new LightGain(options, lens.Width, lens.Height) : null;
    private readonly JpegLoss? _jpeg = options.JpegQuality is { } quality
        ? new JpegLoss(lens.Width, lens.Height, quality)
        : null;

    /// <summary>Whether what lies on the ground is smeared with it, not by itself.</summary>
    public bool HasMotionBlur => _blur is not null;

    /// <summary>On what is seen before anything that is wrong with the camera.</summary>
    public void ApplyToScene(in CameraPose middle, in CameraPose early, in CameraPose late, byte[] pixels)
    {
        _shade?.Apply(middle, pixels);
        _blur?.Apply(middle, early, late, pixels);
    }

    /// <summary>On what falls on the sensor, before its noise.</summary>
    public void ApplyToLight(byte[] pixels) => _light?.Apply(pixels);

    /// <summary>On what the sensor gives.</summary>
    public void ApplyToPicture(byte[] pixels) => _jpeg?.Apply(pixels);
}
