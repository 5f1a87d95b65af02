using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Quality;

/// <summary>
/// Image quality assessment: whether a picture whose place is known can be searched, by what was measured of it, by
/// earlier pictures of the flight and by its pose. Fixed memory, no allocation; for one thread.
/// </summary>
/// <remarks>
/// In brackets: the nearest to the limit in 380 generated stills and frames, dark and bright, and in simulated flights
/// (<c>PictureSetTests</c>).
/// </remarks>
internal sealed class PictureJudge
{
    // 95 % of the luma is below: a lens cap is at the sensor's black level and its noise, below 20 (91).
    internal const int MaxBlackLevel = 32;

    // 95 % of the luma is above (113).
    internal const int MinWhiteLevel = 235;

    // A third of the picture holds no colour any more (0.005).
    internal const double MaxClippedShare = 0.33;

    // Square levels: ground varies by several levels within eight pixels; the darker corners that every lens has come
    // to 0.5, and what chance makes of noise of 2.5 levels to 0.4 (17).
    internal const double MinCoarseDetail = 2;

    // Part of the tiles that show nothing but noise (0.06).
    internal const double MaxFlatShare = 0.3;

    // Fine by coarse detail, for any lens: a blur of 4 pixels (sigma) and more is below (0.086)...
    internal const double MinSharpness = 0.06;

    // ...and for this lens over this ground, of what it had in the flight; one flight varies by 0.68 downwards. A blur
    // of 3 pixels is below in the simulation.
    private const double MinSharpnessRatio = 0.5;

    // Directed by fine detail: 0 is the same in all directions; a blur along a line by 17 pixels gives 1.4 to 2.9
    // (1.23 in a flight). Furrows have it too, but then there is no less detail than before.
    private const double MinDirectedRatio = 1.5;
    private const double MinDetailRatio = 0.5;

    // What the flight had is known after some seconds; it follows slowly, so that a lens that fogs is noticed.
    private const int PicturesToLearn = 8;
    private const double Forgetting = 1.0 / 32;

    // A frozen picture differs by the noise of two pictures at most, which is part of the difference of neighbours. A
    // new one differs by more than the coarse detail, but where a wrong attitude in a turn says that the place has
    // moved and it has not, by an eighth of that only (seen in a nominal flight).
    private const double FrozenPartOfDetail = 0.05;

    private readonly PictureMeter _meter = new();
    private readonly FrozenPictures _frozen = new();
    private int _learnt;
    private double _sharpness;
    private double _fineDetail;

    /// <summary>What was measured of the last picture.</summary>
    public PictureStatistics Statistics { get; private set; }

    /// <summary>Judges a picture.</summary>
    /// <param name="pixels">Red, green and blue, row by row.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="view">How it was taken.</param>
    public PictureQuality Judge(byte[] pixels, int width, int height, in PictureView view)
    {
        if (view.GroundSamplingMetres > view.NeededSamplingMetres)
            return PictureQuality.TooCoarse;
        Statistics = _meter.Measure(pixels, width, height);
        PictureQuality quality = JudgeLight(Statistics);
        if (quality == PictureQuality.Usable && IsFrozen(view))
            return PictureQuality.Frozen;
        if (quality == PictureQuality.Usable)
            quality = JudgeDetail(view);
        if (quality == PictureQuality.Usable)
            Learn();
        return quality;
    }

    /// <summary>What was measured of the last picture, for people.</summary>
    /// <param name="exposure">Of that picture.</param>
    public PictureFacts Describe(TimeSpan exposure) => new()
    {
        Exposure = exposure,
        DarkLevel = Statistics.DarkLevel,
        BrightLevel = Statistics.BrightLevel,
        ClippedShare = Statistics.ClippedShare,
        Sharpness = Statistics.CoarseDetail > 0 ? SharpnessOf(Statistics) : double.NaN,
    };

    private static PictureQuality JudgeLight(in PictureStatistics picture)
        => picture.BrightLevel < MaxBlackLevel ? PictureQuality.Black
            : picture.DarkLevel > MinWhiteLevel ? PictureQuality.White
            : picture.ClippedShare > MaxClippedShare ? PictureQuality.Saturated
            : picture.CoarseDetail < MinCoarseDetail ? PictureQuality.Uniform
            : PictureQuality.Usable;

    private PictureQuality JudgeDetail(in PictureView view)
    {
        PictureStatistics picture = Statistics;
        if (picture.FlatShare > MaxFlatShare)
            return PictureQuality.Covered;
        bool isLearnt = _learnt >= PicturesToLearn;

        // Under noise, or over ground that is nothing but fine grain, detail cannot be judged.
        bool isJudged = picture.CoarseDetail > picture.NeighbourDifference;
        bool isDirected = picture.DirectedDetail > MinDirectedRatio * picture.FineDetail;
        if (isLearnt && isDirected && picture.FineDetail < MinDetailRatio * _fineDetail)
            return PictureQuality.MotionBlurred;
        if (isJudged && !isDirected && SharpnessOf(picture) < RequiredSharpness(isLearnt))
            return PictureQuality.Defocused;
        return view.IsSmeared ? PictureQuality.MotionBlurred : PictureQuality.Usable;
    }

    private double RequiredSharpness(bool isLearnt)
        => isLearnt ? Math.Max(MinSharpness, MinSharpnessRatio * _sharpness) : MinSharpness;

    private static double SharpnessOf(in PictureStatistics picture) => picture.FineDetail / picture.CoarseDetail;

    private bool IsFrozen(in PictureView view)
    {
        PictureStatistics picture = Statistics;
        bool isSame = _meter.DifferenceFromReference()
            < picture.NeighbourDifference + (FrozenPartOfDetail * picture.CoarseDetail);
        if (_frozen.Take(isSame, view))
            _meter.KeepAsReference();
        return _frozen.IsFrozen;
    }

    private void Learn()
    {
        double weight = Math.Max(1.0 / ++_learnt, Forgetting);
        _sharpness += weight * (SharpnessOf(Statistics) - _sharpness);
        _fineDetail += weight * (Statistics.FineDetail - _fineDetail);
    }
}
