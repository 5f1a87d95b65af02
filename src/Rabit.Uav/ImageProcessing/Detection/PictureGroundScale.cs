using System;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// How large a pixel is on the ground at any place of one picture, by the pose of the camera at its exposure. A small
/// value; valid only during the call of the detector that it was given to, on its thread.
/// </summary>
public readonly struct PictureGroundScale
{
    private readonly IGroundScaleSource? _source;
    private readonly double _metresPerPixel;

    internal PictureGroundScale(IGroundScaleSource source) => (_source, _metresPerPixel) = (source, 0);

    private PictureGroundScale(double metresPerPixel) => (_source, _metresPerPixel) = (null, metresPerPixel);

    /// <summary>The same everywhere, top of the picture to the north: for tests of a detector.</summary>
    /// <param name="metresPerPixel">Side of a pixel on the ground, above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">It is not above 0.</exception>
    public static PictureGroundScale Uniform(double metresPerPixel)
    {
        if (!(metresPerPixel > 0 && metresPerPixel < double.PositiveInfinity))
            throw new ArgumentOutOfRangeException(
                nameof(metresPerPixel), metresPerPixel, "The side of a pixel on the ground must be above 0.");
        return new PictureGroundScale(metresPerPixel);
    }

    /// <summary>The scale at a place. Allocates nothing; takes about four times as long as locating a pixel.</summary>
    /// <param name="column">Pixels; the centre of the top left pixel is 0.</param>
    /// <param name="row">Pixels; the centre of the top left pixel is 0.</param>
    /// <param name="scale">Metres per pixel there.</param>
    /// <returns>False where the picture does not show the ground, or too near to the horizon.</returns>
    public bool TryAt(double column, double row, out GroundScale scale)
    {
        if (_source is not null)
            return _source.TryScale(column, row, out scale);
        scale = new GroundScale { EastByColumn = _metresPerPixel, NorthByRow = -_metresPerPixel };
        return _metresPerPixel > 0;
    }
}
