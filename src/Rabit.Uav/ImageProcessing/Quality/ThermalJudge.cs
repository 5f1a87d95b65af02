using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Quality;

/// <summary>
/// Image quality assessment of a thermal camera: whether it shows ground at all, whether it is a new picture, and how
/// it was taken. What its counts are in degrees is not known, and how sharp it must be neither. Fixed memory, no
/// allocation; for one thread.
/// </summary>
internal sealed class ThermalJudge
{
    // Of the noise: chance makes 0.07 of pure noise in a picture of 160 x 120 pixels (one standard deviation). Ground
    // that varies by a third of the noise of a pixel within eight pixels has more.
    internal const double MinDetailByNoise = 0.15;

    // A digital picture that is repeated differs by what a lossy compression makes of it; a new one by all of its
    // noise, and by its ground.
    private const double FrozenPartOfNoise = 0.5;
    private const double FrozenPartOfDetail = 0.05;

    private const double LevelsPerCount = 255.0 / ushort.MaxValue;

    private readonly ThermalMeter _meter = new();
    private readonly FrozenPictures _frozen = new();

    /// <summary>Judges a picture.</summary>
    /// <param name="counts">Row by row.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="view">How it was taken.</param>
    public PictureQuality Judge(ReadOnlySpan<ushort> counts, int width, int height, in PictureView view)
    {
        if (view.GroundSamplingMetres > view.NeededSamplingMetres)
            return PictureQuality.TooCoarse;
        _meter.Measure(counts, width, height);

        // One value, or nothing but noise: a closed shutter, a cap, a sensor that gives nothing.
        if (_meter.CoarseDetail <= MinDetailByNoise * _meter.NeighbourDifference)
            return PictureQuality.Uniform;
        bool isSame = _meter.DifferenceFromReference() < (FrozenPartOfNoise * _meter.NeighbourDifference)
            + (FrozenPartOfDetail * _meter.CoarseDetail);
        if (_frozen.Take(isSame, view))
            _meter.KeepAsReference();
        return _frozen.IsFrozen ? PictureQuality.Frozen
            : view.IsSmeared ? PictureQuality.MotionBlurred
            : PictureQuality.Usable;
    }

    /// <summary>What was measured of the last picture, for people.</summary>
    /// <param name="exposure">Of that picture.</param>
    public PictureFacts Describe(TimeSpan exposure) => new()
    {
        Exposure = exposure,
        DarkLevel = (int)(_meter.Coldest * LevelsPerCount),
        BrightLevel = (int)(_meter.Warmest * LevelsPerCount),
        Sharpness = double.NaN,
    };
}
