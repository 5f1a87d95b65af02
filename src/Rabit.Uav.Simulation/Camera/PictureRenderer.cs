using System.Collections.Generic;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Makes pictures of the simulated world. The same seed, poses and number give the same bytes. One thread;
/// allocates nothing for a picture.
/// </summary>
internal sealed class PictureRenderer
{
    private const ulong PurposeOfGround = 0x67726F756E64;

    private readonly GroundPainter _ground;
    private readonly SheetPainter _sheets;
    private readonly SensorFinish _finish;
    private readonly LensFaults _faults;
    private readonly PictureEffects _effects;

    /// <exception cref="System.ArgumentException">No ray of light falls on some pixel.</exception>
    public PictureRenderer(SimulatedCameraOptions options, IEnumerable<SimulatedTarget> sheets, ulong seed)
    {
        var lens = new LensRays(options.Camera);
        _ground = new GroundPainter(lens, new GroundTexture(SeededSequence.Derive(seed, PurposeOfGround)));
        _sheets = new SheetPainter(lens, sheets);
        _faults = new LensFaults(lens.Width, lens.Height);
        _effects = new PictureEffects(options.Effects, lens, seed);
        _finish = new SensorFinish(lens.Width, lens.Height, options.NoiseSigma, seed);
    }

    /// <summary>Makes one picture.</summary>
    /// <param name="middle">How the camera stands at the middle of the exposure.</param>
    /// <param name="early">How it stands after a quarter of it.</param>
    /// <param name="late">How it stands after three quarters of it.</param>
    /// <param name="number">Number of the picture; another number has other noise.</param>
    /// <param name="pixels">Takes red, green and blue, row by row.</param>
    /// <param name="faults">What is wrong with it; null: nothing.</param>
    public void Render(
        in CameraPose middle, in CameraPose early, in CameraPose late, long number, byte[] pixels,
        IReadOnlyList<ScriptedFault>? faults = null)
    {
        _ground.Paint(middle, pixels);
        if (_effects.HasMotionBlur)
            _sheets.Paint(middle, middle, pixels);
        else
            _sheets.Paint(early, late, pixels);
        _effects.ApplyToScene(middle, early, late, pixels);
        if (faults is { Count: > 0 })
            _faults.Apply(faults, pixels);
        _effects.ApplyToLight(pixels);
        _finish.Apply(pixels, number);
        if (faults is { Count: > 0 })
            LensFaults.Overexpose(faults, pixels);
        _effects.ApplyToPicture(pixels);
    }
}
