namespace Rabit.Uav.Messages;

/// <summary>How many pictures were of which quality. A plain value.</summary>
public struct PictureCounts
{
    /// <summary>Pictures that could be searched, and were.</summary>
    public long Usable { get; set; }

    /// <summary>See <see cref="PictureQuality.RepeatedNumber"/>.</summary>
    public long RepeatedNumber { get; set; }

    /// <summary>See <see cref="PictureQuality.NoPose"/>.</summary>
    public long NoPose { get; set; }

    /// <summary>See <see cref="PictureQuality.NotGround"/>.</summary>
    public long NotGround { get; set; }

    /// <summary>See <see cref="PictureQuality.NotSearched"/>.</summary>
    public long NotSearched { get; set; }

    /// <summary>See <see cref="PictureQuality.TooCoarse"/>.</summary>
    public long TooCoarse { get; set; }

    /// <summary>See <see cref="PictureQuality.Black"/>.</summary>
    public long Black { get; set; }

    /// <summary>See <see cref="PictureQuality.White"/>.</summary>
    public long White { get; set; }

    /// <summary>See <see cref="PictureQuality.Saturated"/>.</summary>
    public long Saturated { get; set; }

    /// <summary>See <see cref="PictureQuality.Uniform"/>.</summary>
    public long Uniform { get; set; }

    /// <summary>See <see cref="PictureQuality.Frozen"/>.</summary>
    public long Frozen { get; set; }

    /// <summary>See <see cref="PictureQuality.Covered"/>.</summary>
    public long Covered { get; set; }

    /// <summary>See <see cref="PictureQuality.Defocused"/>.</summary>
    public long Defocused { get; set; }

    /// <summary>See <see cref="PictureQuality.MotionBlurred"/>.</summary>
    public long MotionBlurred { get; set; }

    /// <summary>All of them.</summary>
    public readonly long Total
        => Usable + RepeatedNumber + NoPose + NotGround + NotSearched + TooCoarse + Black + White + Saturated + Uniform
            + Frozen + Covered + Defocused + MotionBlurred;

    /// <summary>How many are of a quality.</summary>
    /// <param name="quality">Which; 0 for none of its values.</param>
    public readonly long Of(PictureQuality quality) => quality switch
    {
        PictureQuality.Usable => Usable,
        PictureQuality.RepeatedNumber => RepeatedNumber,
        PictureQuality.NoPose => NoPose,
        PictureQuality.NotGround => NotGround,
        PictureQuality.NotSearched => NotSearched,
        PictureQuality.TooCoarse => TooCoarse,
        PictureQuality.Black => Black,
        PictureQuality.White => White,
        PictureQuality.Saturated => Saturated,
        PictureQuality.Uniform => Uniform,
        PictureQuality.Frozen => Frozen,
        PictureQuality.Covered => Covered,
        PictureQuality.Defocused => Defocused,
        PictureQuality.MotionBlurred => MotionBlurred,
        _ => 0,
    };

    internal void Count(PictureQuality quality)
    {
        switch (quality)
        {
            case PictureQuality.Usable: Usable++; break;
            case PictureQuality.RepeatedNumber: RepeatedNumber++; break;
            case PictureQuality.NoPose: NoPose++; break;
            case PictureQuality.NotGround: NotGround++; break;
            case PictureQuality.NotSearched: NotSearched++; break;
            case PictureQuality.TooCoarse: TooCoarse++; break;
            case PictureQuality.Black: Black++; break;
            case PictureQuality.White: White++; break;
            case PictureQuality.Saturated: Saturated++; break;
            case PictureQuality.Uniform: Uniform++; break;
            case PictureQuality.Frozen: Frozen++; break;
            case PictureQuality.Covered: Covered++; break;
            case PictureQuality.Defocused: Defocused++; break;
            case PictureQuality.MotionBlurred: MotionBlurred++; break;
        }
    }
}
