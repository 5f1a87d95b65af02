using System;
using Rabit.Geodesy;
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

    /// <summary>That of a picture over level ground, by a known pose: for a detector without a manager.</summary>
    /// <param name="camera">The camera that took it.</param>
    /// <param name="nedFromCamera">
    /// How it was turned: from its axes (x right, y down, z along the optical axis) to north-east-down.
    /// </param>
    /// <param name="heightMetres">How high it was above the ground.</param>
    /// <exception cref="ArgumentOutOfRangeException">The height is not above 0.</exception>
    public static PictureGroundScale OfLevelGround(CameraModel camera, Rotation nedFromCamera, double heightMetres)
    {
        if (camera is null)
            throw new ArgumentNullException(nameof(camera));
        if (!(heightMetres > 0 && heightMetres < double.PositiveInfinity))
            throw new ArgumentOutOfRangeException(
                nameof(heightMetres), heightMetres, "The height of the camera above the ground must be above 0.");
        return new PictureGroundScale(new LevelGroundScale(camera, nedFromCamera, heightMetres));
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
