using System;
using Rabit.Geodesy;

namespace Rabit.Uav.ImageProcessing.Quality;

/// <summary>What is known of how a picture was taken, by its pose. A plain value.</summary>
internal struct PictureView
{
    /// <summary>Where the middle of the picture is on the ground.</summary>
    public GeodeticPosition Centre { get; set; }

    /// <summary>Side of a pixel on the ground in the middle of the picture, metres.</summary>
    public double GroundSamplingMetres { get; set; }

    /// <summary>How far the ground moved past during the exposure, metres.</summary>
    public double SmearMetres { get; set; }

    /// <summary>
    /// The largest ground sampling at which the smallest class can be detected, metres; infinite where that is not
    /// known.
    /// </summary>
    public double NeededSamplingMetres { get; set; }

    /// <summary>
    /// Whether it is smeared by more than the smallest class allows: by more than the largest pixel that is fine
    /// enough, unless the pixels are so much smaller that a smeared one covers no more ground than that one. The detail
    /// of the picture need not show it.
    /// </summary>
    public readonly bool IsSmeared
    {
        get
        {
            double covered = GroundSamplingMetres * (GroundSamplingMetres + SmearMetres);
            return SmearMetres > NeededSamplingMetres && covered > NeededSamplingMetres * NeededSamplingMetres;
        }
    }

    /// <summary>How far on the middle of the picture is from that of another one, metres over ground.</summary>
    public readonly double MetresFrom(GeodeticPosition centre)
        => NedPosition.Origin.HorizontalDistanceTo(LocalNedFrame.IgnoringGeoid(centre).ToNed(Centre));
}
